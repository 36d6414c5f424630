//! What ten million of something cost against a hundred thousand: a kernel whose work follows what is drawn takes as
//! long for each of them, and writes a document without keeping it.

use crate::Failure;
use gks_cli::bench::clock::median;
use gks_cli::bench::measurement::{self, Effort, Folder, Measurement};
use gks_cli::bench::workload::{self, Way, Workload};
use std::process::Command;

/// The numbers of primitives, or points of one, that are compared.
const SIZES: [usize; 2] = [100_000, 10_000_000];
/// How many times as much one of many may cost as one of few.
const DEARER: f64 = 1.2;
/// By how many KiB many may take more memory: a picture and a document hold none of them.
const MORE_KIB: u64 = 8 * 1024;
/// The workloads that grow in memory; all documents that come in these sizes do too.
const DRAWN: [&str; 7] = ["w1", "w1s", "w2", "w3dot", "w3plus", "w3circ", "w7"];

/// What is compared.
pub(crate) struct Growth {
    /// How often each size is measured, in turn.
    pub(crate) rounds: usize,
    /// The workloads; all if there are none.
    pub(crate) workloads: Vec<String>,
}

impl Default for Growth {
    fn default() -> Self {
        Growth { rounds: 3, workloads: Vec::new() }
    }
}

/// Measures one size of a workload in this process.
pub(crate) fn measure(name: &str, size: usize) -> Result<Measurement, Failure> {
    let workload = workload::all().into_iter().find(|w| w.name == name);
    let workload = workload.ok_or_else(|| format!("no workload {name}"))?;
    measurement::measure(&workload, size, Effort::Growth, Folder::new()?.path())
}

/// One size in a process of its own, so that nothing before it counts.
fn in_process(name: &str, size: usize) -> Result<Measurement, Failure> {
    let output =
        Command::new(std::env::current_exe()?).args(["measure", name, &size.to_string()]).output()?;
    match output.status.success() {
        true => Ok(serde_json::from_slice(&output.stdout)?),
        false => Err(format!("{name} at {size}: {}", String::from_utf8_lossy(&output.stderr).trim()).into()),
    }
}

/// Whether a workload grows.
fn grows(workload: &Workload) -> bool {
    let sized = SIZES.iter().all(|size| workload.sizes.contains(size));
    sized && (matches!(workload.way, Way::Document(_)) || DRAWN.contains(&workload.name.as_str()))
}

impl Growth {
    /// Measures, prints a table, and gives what is missed.
    pub(crate) fn run(&self) -> Result<Vec<String>, Failure> {
        let asked = |w: &Workload| self.workloads.is_empty() || self.workloads.contains(&w.name);
        let chosen: Vec<Workload> = workload::all().into_iter().filter(|w| grows(w) && asked(w)).collect();
        if let Some(name) = self.workloads.iter().find(|name| chosen.iter().all(|w| w.name != **name)) {
            return Err(format!("{name} does not come in the sizes {} and {}", SIZES[0], SIZES[1]).into());
        }
        let [few, many] = SIZES;
        println!("| workload | ns each of {few} | of {many} | ratio | MiB for {few} | for {many} |");
        println!("|---|---:|---:|---:|---:|---:|");
        let mut missed = Vec::new();
        for workload in chosen {
            let mut sizes = SIZES.map(|_| Vec::new());
            for _ in 0..self.rounds.max(1) {
                for (&size, measured) in SIZES.iter().zip(&mut sizes) {
                    measured.push(in_process(&workload.name, size)?);
                }
            }
            let [few, many] = sizes;
            let each = |all: &[Measurement]| {
                median(all.iter().map(|m| m.cpu_ms * 1e6 / m.n.max(1) as f64).collect())
            };
            let kib = |all: &[Measurement]| all.iter().map(|m| m.peak_kib).min().unwrap_or(0);
            let figures = Figures { each: [each(&few), each(&many)], kib: [kib(&few), kib(&many)] };
            println!("| {}: {} | {}", workload.name, workload.what, figures.line());
            missed.extend(figures.missed().map(|said| format!("{}: {said}", workload.name)));
        }
        Ok(missed)
    }
}

/// What is measured of a workload, for few and for many.
struct Figures {
    /// Nanoseconds for each.
    each: [f64; 2],
    /// Memory in KiB beyond that of the data, at its peak.
    kib: [u64; 2],
}

impl Figures {
    fn ratio(&self) -> f64 {
        self.each[1] / self.each[0]
    }

    fn line(&self) -> String {
        let ([few, many], [small, large]) = (self.each, self.kib.map(|kib| kib as f64 / 1024.0));
        format!("{few:.1} | {many:.1} | {:.2} | {small:.1} | {large:.1} |", self.ratio())
    }

    /// The gates that are missed.
    fn missed(&self) -> impl Iterator<Item = String> {
        let dearer = (self.ratio() > DEARER)
            .then(|| format!("each costs {:.2} times as much ({DEARER})", self.ratio()));
        let more = self.kib[1].saturating_sub(self.kib[0]);
        let larger =
            (more > MORE_KIB).then(|| format!("{:.1} MiB more ({})", more as f64 / 1024.0, MORE_KIB / 1024));
        dearer.into_iter().chain(larger)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_beyond_a_fifth_and_eight_mebibytes_is_told() {
        let missed = |each, kib| Figures { each, kib }.missed().count();
        assert_eq!(missed([10.0, 11.9], [100, 8000]), 0);
        assert_eq!(missed([10.0, 12.1], [100, 8000]), 1);
        assert_eq!(missed([10.0, 5.0], [100, 8293]), 1);
        assert_eq!(missed([10.0, 13.0], [100, 9000]), 2);
    }

    #[test]
    fn the_curves_the_lines_the_markers_and_all_documents_of_them_grow() {
        let names: Vec<String> = workload::all().into_iter().filter(grows).map(|w| w.name).collect();
        assert_eq!(names.len(), DRAWN.len() + 9, "{names:?}");
    }
}
