//! `gks spec`: which functions of the standards are there.

use super::Failure;
use crate::generated::coverage::{COVERAGE, Coverage};
use serde::Serialize;
use std::process::ExitCode;

/// What JSON shows.
#[derive(Serialize)]
struct Report {
    coverage: &'static [Coverage],
}

/// Prints the coverage: for each level the number of functions that are in it and in none below, and how many
/// of them there are in each language.
pub fn run(json: bool) -> Result<ExitCode, Failure> {
    if json {
        println!("{}", serde_json::to_string_pretty(&Report { coverage: COVERAGE })?);
    } else {
        print!("{}", table(COVERAGE));
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
    fn the_table_has_a_line_for_each_level() {
        let text = table(COVERAGE);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[1 + COVERAGE.len()], "");
        assert!(lines[1].starts_with("gks      0a          124    124    124     124"), "{text}");
        assert!(text.contains("    fortran: CREATE STORE\n"), "{text}");
    }
}
