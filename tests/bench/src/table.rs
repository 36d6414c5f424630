//! The table of a comparison, as the README has it.

use crate::Failure;
use crate::comparison::{Cell, Row};
use crate::gate::{Gate, Measure, ROWS, gates};
use crate::machine;
use crate::peer::OURS;
use std::fmt::Write;
use std::fs;
use std::path::Path;

const BEGIN: &str = "<!-- speed: written by tests/bench/run -->";
const END: &str = "<!-- speed: end -->";

/// The tables, and what misses its gate.
pub(crate) fn text(rows: &[Row]) -> String {
    let mut text = format!("Measured on: {}.\n", machine::description());
    let (pixels, files): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.device == "memory");
    let columns = [OURS, "tiny-skia", "vello_cpu", "cairo", "AGG", "NCAR", "XGKS"];
    section(&mut text, "pictures in memory, ms", &columns, &pixels);
    section(&mut text, "files, ms / MB", &[OURS, "cairo", "NCAR"], &files);
    let left_out: Vec<&str> = ROWS
        .iter()
        .filter(|(workload, _, device)| !rows.iter().any(|r| (r.workload, r.device) == (*workload, *device)))
        .map(|(_, what, _)| *what)
        .collect();
    if !left_out.is_empty() {
        let _ = writeln!(text, "\nNot run this time: {}.", left_out.join("; "));
    }
    let missed: Vec<&&Row> = pixels.iter().chain(&files).filter(|row| row.misses()).collect();
    if missed.is_empty() {
        return text;
    }
    text += "\nWhat misses its gate, and the functions in which most instructions are executed:\n\n";
    for row in missed {
        let profile = row.profile.iter().map(|line| format!("`{line}`")).collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "- {}: {profile}", row.what);
    }
    text
}

fn section(text: &mut String, title: &str, columns: &[&str], rows: &[&Row]) {
    if rows.is_empty() {
        return;
    }
    let present: Vec<&str> =
        columns.iter().copied().filter(|peer| rows.iter().any(|row| row.cell(peer).is_some())).collect();
    let _ = writeln!(text, "\n| {title} | {} | likeness | gate |", present.join(" | "));
    let _ = writeln!(text, "|---|{}---|---|", "---:|".repeat(present.len()));
    for row in rows {
        let cells: Vec<String> = present.iter().map(|peer| cell(row, row.cell(peer))).collect();
        let likeness = row.likeness.map_or(String::new(), |(psnr, ink, truth)| {
            format!("{psnr:.1} dB, darkness {ink:.2} of {truth:.2}")
        });
        let gates: Vec<String> =
            gates(row.workload, row.device).iter().filter_map(|gate| verdict(row, gate)).collect();
        let _ =
            writeln!(text, "| {} | {} | {likeness} | {} |", row.what, cells.join(" | "), gates.join("; "));
    }
}

fn cell(row: &Row, cell: Option<&Cell>) -> String {
    let Some(cell) = cell else { return String::new() };
    match (cell.time(), cell.first) {
        (Some(time), Some(cost)) if row.device != "memory" && cost.bytes > 0 => {
            format!("{} / {:.2}", milliseconds(time), cost.bytes as f64 * 1e-6)
        }
        (Some(time), _) => milliseconds(time),
        _ => "-".into(),
    }
}

/// Three digits that count.
fn milliseconds(time: f64) -> String {
    match time {
        time if time < 10.0 => format!("{time:.2}"),
        time if time < 100.0 => format!("{time:.1}"),
        time => format!("{time:.0}"),
    }
}

/// What is asked, what is reached, and whether that is enough.
fn verdict(row: &Row, gate: &Gate) -> Option<String> {
    let ratio = row.ratio(gate)?;
    let fraction = |x: f64| if x < 0.7 { format!("1/{:.1}", 1.0 / x) } else { format!("{x:.2}") };
    let unit = match gate.measure {
        Measure::Time => "",
        Measure::Bytes => " bytes",
        Measure::Instructions => " instructions",
    };
    let mark = if ratio <= gate.factor { "" } else { " **missed**" };
    Some(format!("{} of {}{unit} ({}){mark}", fraction(ratio), gate.peer, fraction(gate.factor)))
}

/// Puts a text between the markers of a file.
pub(crate) fn insert(file: &Path, text: &str) -> Result<(), Failure> {
    let old = fs::read_to_string(file)?;
    let missing = || format!("{}: the markers for the table are missing", file.display());
    let (before, rest) = old.split_once(BEGIN).ok_or_else(missing)?;
    let (_, after) = rest.split_once(END).ok_or_else(missing)?;
    fs::write(file, format!("{before}{BEGIN}\n\n{}\n\n{END}{after}", text.trim()))?;
    Ok(())
}
