//! `gks spec`: which functions of the standards are there, and which error numbers are met.

use super::Failure;
use crate::generated::coverage::{COVERAGE, Coverage};
use crate::generated::error_numbers::{ERROR_NUMBERS, ErrorNumber};
use serde::Serialize;
use std::process::ExitCode;

/// What JSON shows.
#[derive(Serialize)]
struct Report {
    coverage: &'static [Coverage],
    errors: &'static [ErrorNumber],
}

/// Prints the coverage: for each level the number of functions that are in it and in none below, and how many
/// of them there are in each language; and of the error numbers how many tests provoke, and why not the others.
pub fn run(json: bool) -> Result<ExitCode, Failure> {
    if json {
        println!("{}", serde_json::to_string_pretty(&Report { coverage: COVERAGE, errors: ERROR_NUMBERS })?);
    } else {
        print!("{}\n{}", table(COVERAGE), numbers(ERROR_NUMBERS));
    }
    Ok(ExitCode::SUCCESS)
}

fn table(rows: &[Coverage]) -> String {
    let mut out = format!(
        "{:<8} {:<5} {:>9} {:>6} {:>6} {:>7}\n",
        "standard", "level", "functions", "Rust", "C", "Fortran"
    );
    for row in rows {
        let Coverage { standard, level, functions, rust, c, fortran, .. } = row;
        out += &format!("{standard:<8} {level:<5} {functions:>9} {rust:>6} {c:>6} {fortran:>7}\n");
    }
    for row in rows.iter().filter(|row| !row.na.is_empty()) {
        out += &format!("\nCounted at level {} although the language has no such function:\n", row.level);
        row.na.iter().for_each(|what| out += &format!("    {what}\n"));
    }
    out
}

fn numbers(all: &[ErrorNumber]) -> String {
    let (never, met): (Vec<&ErrorNumber>, Vec<&ErrorNumber>) = all.iter().partition(|e| e.never.is_some());
    let mut out =
        format!("Of {} error numbers {} are provoked by tests. Never reported:\n", all.len(), met.len());
    // Neighbours that have the same reason share a line.
    for group in never.chunk_by(|a, b| a.never == b.never) {
        let (first, last) = (group[0].number, group[group.len() - 1].number);
        let which = if first == last { first.to_string() } else { format!("{first} to {last}") };
        out += &format!("{which:>16}  {}\n", group[0].never.unwrap_or_default());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_function_of_level_0a_is_there() {
        let row = COVERAGE.iter().find(|row| (row.standard, row.level) == ("gks", "0a"));
        let row = row.expect("there is a level 0a");
        assert_eq!([row.rust, row.c, row.fortran], [row.functions; 3]);
    }

    #[test]
    fn every_error_number_is_provoked_or_explained() {
        for error in ERROR_NUMBERS {
            let provoked = !error.functions.is_empty() || error.provoked_by.is_some();
            assert_ne!(provoked, error.never.is_some(), "{}", error.number);
        }
        let text = numbers(ERROR_NUMBERS);
        assert!(text.contains("              43  as many workstations may be active"), "{text}");
        assert!(text.contains("    -100 to -504  only NCAR GKS itself"), "{text}");
    }

    #[test]
    fn the_table_has_a_line_for_each_level() {
        let text = table(COVERAGE);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[1 + COVERAGE.len()], "");
        assert!(lines[1].starts_with("gks      0a          124    124    124     124"), "{text}");
        assert!(text.contains("    fortran: CREATE STORE\n"), "{text}");
    }
}
