//! The table of a comparison, as the README has it.

use crate::Failure;
use crate::comparison::{Cell, Row};
use crate::gate::{Gate, Measure, ROWS, gates};
use crate::machine;
use crate::peer::{OURS, Run};
use std::fmt::Write;
use std::fs;
use std::path::Path;

const BEGIN: &str = "<!-- speed: written by tests/bench/run -->";
const END: &str = "<!-- speed: end -->";

/// The tables, and what misses its gate.
pub(crate) fn text(rows: &[Row]) -> String {
    let mut text = format!("Measured on: {}.\n", machine::description());
    let (pixels, files): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.device == "memory");
    let columns = [OURS, "tiny-skia", "vello_cpu", "cairo", "AGG", "Blend2D", "GR", "NCAR", "XGKS"];
    section(&mut text, "pictures in memory, ms / MiB", &columns, &pixels);
    section(&mut text, "files, ms / MB / MiB", &[OURS, "cairo", "GR", "NCAR"], &files);
    let left_out: Vec<&str> = ROWS
        .iter()
        .filter(|(workload, _, device)| !rows.iter().any(|r| (r.workload, r.device) == (*workload, *device)))
        .map(|(_, what, _)| *what)
        .collect();
    if !left_out.is_empty() {
        let _ = writeln!(text, "\nNot run this time: {}.", left_out.join("; "));
    }
    let missed: Vec<&&Row> = pixels.iter().chain(&files).filter(|row| !row.profile.is_empty()).collect();
    if missed.is_empty() {
        return text;
    }
    text += "\nWhat is too slow, and the functions in which most instructions are executed:\n\n";
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

/// Time, size of the file, memory.
fn cell(row: &Row, cell: Option<&Cell>) -> String {
    let Some((cell, time)) = cell.and_then(|cell| Some((cell, cell.time()?))) else { return "-".into() };
    let Run::Done(cost) = cell.first else { return format!("> {}", milliseconds(time)) };
    let mut numbers = vec![milliseconds(time)];
    if row.device != "memory" && cost.bytes > 0 {
        numbers.push(format!("{:.2}", cost.bytes as f64 * 1e-6));
    }
    if row.device == "memory" || cost.bytes > 0 {
        numbers.push(format!("{:.0}", cost.peak_kib as f64 / 1024.0));
    }
    numbers.join(" / ")
}

/// Three digits that count.
fn milliseconds(time: f64) -> String {
    match time {
        time if time < 10.0 => format!("{time:.2}"),
        time if time < 100.0 => format!("{time:.1}"),
        time => format!("{time:.0}"),
    }
}

/// What is reached, what is asked, and whether that is enough.
fn verdict(row: &Row, gate: &Gate) -> Option<String> {
    let reached = row.reached(gate)?;
    let fraction = |x: f64| if x < 0.7 { format!("1/{:.1}", 1.0 / x) } else { format!("{x:.2}") };
    let said = match *gate {
        Gate::Against { peer, measure, factor } => {
            let unit = match measure {
                Measure::Time => "",
                Measure::Bytes => " bytes",
                Measure::Instructions => " instructions",
            };
            format!("{} of {peer}{unit} ({})", fraction(reached), fraction(factor))
        }
        Gate::Likeness(least) => format!("{reached:.1} dB ({least:.0})"),
        Gate::Memory(most) => format!("{reached:.1} MiB ({most:.0})"),
    };
    let mark = if row.misses(gate) { " **missed**" } else { "" };
    Some(said + mark)
}

/// The gates of a row that are missed, as the table says it; a row that this library does not draw misses all of them.
pub(crate) fn missed(row: &Row, which: impl Fn(&Gate) -> bool) -> Vec<String> {
    if row.cell(OURS).and_then(Cell::cost).is_none() {
        return vec![format!("{}: not drawn", row.what)];
    }
    let gates = row.missed().into_iter().filter(|gate| which(gate));
    gates.filter_map(|gate| Some(format!("{}: {}", row.what, verdict(row, &gate)?))).collect()
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
