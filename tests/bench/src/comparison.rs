//! Running all programs in turn, round by round, so that what else the machine does meets all of them alike.

use crate::Failure;
use crate::cost::{Cost, Part};
use crate::data;
use crate::gate::{Gate, Measure, OWN_TENTH, ROWS, gates};
use crate::peer::{OURS, PATIENCE, Peer, Run};
use crate::profile;
use gks_cli::bench::clock::median;
use gks_cli::bench::measurement::{Effort, Folder, measure};
use gks_cli::bench::workload;
use std::path::Path;

/// What is compared.
pub(crate) struct Comparison {
    /// How often each cell of the table is measured.
    pub(crate) rounds: usize,
    /// Everything once and without profiles, to see that it works.
    pub(crate) once: bool,
    /// The workloads; all if there are none.
    pub(crate) workloads: Vec<String>,
}

impl Default for Comparison {
    fn default() -> Self {
        Comparison { rounds: 5, once: false, workloads: Vec::new() }
    }
}

/// The least processor time of a sample in milliseconds; shorter work is repeated within it.
const SAMPLE: f64 = 300.0;
/// Work that takes longer than this is measured in three rounds at most, or once.
const LONG: [f64; 2] = [3_000.0, 9_000.0];

/// A workload on a device.
pub(crate) struct Row {
    /// The name of the workload.
    pub(crate) workload: &'static str,
    /// What it is.
    pub(crate) what: &'static str,
    /// Where it is drawn.
    pub(crate) device: &'static str,
    /// Peak signal to noise ratio of our picture, mean darkness of it and of the truth.
    pub(crate) likeness: Option<(f64, f64, f64)>,
    /// What each library needs.
    pub(crate) cells: Vec<Cell>,
    /// What our time goes into, if a gate is missed.
    pub(crate) profile: Vec<String>,
}

/// What a library needs for a row.
#[derive(Clone)]
pub(crate) struct Cell {
    /// The name of the library.
    pub(crate) peer: &'static str,
    /// The times of all rounds in milliseconds.
    samples: Vec<f64>,
    /// The first run.
    pub(crate) first: Run,
    /// The instructions of a process, where they are compared and can be counted.
    instructions: Option<u64>,
    repetitions: u32,
}

impl Cell {
    /// The median time in milliseconds, if the library can do it; at least so much if it was given up.
    pub(crate) fn time(&self) -> Option<f64> {
        match self.first {
            Run::Done(_) => Some(median(self.samples.clone())),
            Run::GivenUp => Some(f64::from(PATIENCE) * 1e3),
            Run::Impossible => None,
        }
    }

    /// What the first run has cost, if it came to its end.
    pub(crate) fn cost(&self) -> Option<Cost> {
        self.first.cost()
    }
}

impl Row {
    fn part(&self) -> Part {
        match (self.device, self.workload) {
            (_, "w10") => Part::Process,
            ("memory", _) => Part::Drawing,
            _ => Part::Document,
        }
    }

    /// The cell of a library.
    pub(crate) fn cell(&self, peer: &str) -> Option<&Cell> {
        self.cells.iter().find(|cell| cell.peer == peer)
    }

    /// What a gate bounds, as it is measured: how many times as much as the other library this one needs, decibels, or
    /// MiB.
    pub(crate) fn reached(&self, gate: &Gate) -> Option<f64> {
        let ours = self.cell(OURS)?;
        match *gate {
            Gate::Likeness(_) => self.likeness.map(|(psnr, ..)| psnr),
            Gate::Memory(_) => Some(ours.cost()?.peak_kib as f64 / 1024.0),
            Gate::Against { peer, measure, .. } => {
                let theirs = self.cell(peer)?;
                let ratio = match measure {
                    Measure::Time => ours.time()? / theirs.time()?,
                    Measure::Bytes => ours.cost()?.bytes as f64 / theirs.cost()?.bytes as f64,
                    Measure::Instructions => ours.instructions? as f64 / theirs.instructions? as f64,
                };
                Some(ratio).filter(|ratio| ratio.is_finite())
            }
        }
    }

    /// Whether a gate is missed.
    pub(crate) fn misses(&self, gate: &Gate) -> bool {
        self.reached(gate).is_some_and(|reached| match *gate {
            Gate::Against { factor, .. } => reached > factor,
            Gate::Likeness(least) => reached < least,
            Gate::Memory(most) => reached > most,
        })
    }

    /// The gates that are missed.
    pub(crate) fn missed(&self) -> Vec<Gate> {
        gates(self.workload, self.device).into_iter().filter(|gate| self.misses(gate)).collect()
    }
}

impl Comparison {
    /// Measures.
    pub(crate) fn run(&self) -> Result<Vec<Row>, Failure> {
        let folder = Folder::new()?;
        let folder = folder.path();
        let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("program");
        let peers = Peer::all(&sources, folder)?;
        data::write(&folder.join("data"))?;
        let mut rows: Vec<Row> = ROWS
            .into_iter()
            .filter(|(name, ..)| self.workloads.is_empty() || self.workloads.iter().any(|w| w == name))
            .map(|(workload, what, device)| Row {
                workload,
                what,
                device,
                likeness: None,
                cells: Vec::new(),
                profile: Vec::new(),
            })
            .collect();
        for round in 0..if self.once { 1 } else { self.rounds.max(1) } {
            for row in &mut rows {
                eprintln!("round {} {} {}", round + 1, row.device, row.workload);
                for peer in &peers {
                    self.sample(row, peer, round, folder)?;
                }
            }
        }
        let tenth = rows.iter().find(|row| row.workload == "w1k").and_then(|row| row.cell(OURS)).cloned();
        if let (Some(tenth), Some(clipped)) = (tenth, rows.iter_mut().find(|row| row.workload == "w8")) {
            clipped.cells.push(Cell { peer: OWN_TENTH, ..tenth });
        }
        for row in &mut rows {
            row.likeness = likeness(row, folder)?;
            if row.missed().iter().any(Gate::is_of_time) && !self.once {
                let ours = peers.iter().find(|peer| peer.name == OURS);
                let command = ours.and_then(|peer| peer.command_line(row.device, row.workload, folder));
                row.profile = command.map_or(Vec::new(), |words| profile::hottest(&words, folder));
            }
        }
        Ok(rows)
    }

    fn sample(&self, row: &mut Row, peer: &Peer, round: usize, folder: &Path) -> Result<(), Failure> {
        let part = row.part();
        if round == 0 {
            let first = peer.run(row.device, row.workload, 1, folder)?;
            let time = if let Run::Done(cost) = first { cost.of(part) } else { SAMPLE };
            let repetitions = (SAMPLE / time.max(0.1)).ceil().clamp(1.0, 1000.0) as u32;
            let counted = gates(row.workload, row.device).iter().any(Gate::is_of_instructions);
            let words = peer.command_line(row.device, row.workload, folder).filter(|_| counted);
            let instructions = words.and_then(|words| profile::instructions(&words, folder));
            row.cells.push(Cell { peer: peer.name, samples: Vec::new(), first, instructions, repetitions });
        }
        let Some(cell) = row.cells.iter_mut().find(|cell| cell.peer == peer.name) else { return Ok(()) };
        let Some(first) = cell.cost() else { return Ok(()) };
        let rounds = match first.of(part) {
            time if time > LONG[1] => 1,
            time if time > LONG[0] => 3,
            _ => usize::MAX,
        };
        if self.once || cell.repetitions == 1 && round == 0 {
            cell.samples.push(first.of(part));
        } else if round < rounds && part == Part::Drawing {
            let run = peer.run(row.device, row.workload, cell.repetitions, folder)?;
            cell.samples.extend(run.cost().map(|cost| cost.of(part)));
        } else if round < rounds {
            // A document is written by each process once.
            let runs = cell.repetitions.min(20);
            let runs = (0..runs).map(|_| peer.run(row.device, row.workload, 1, folder));
            let times = runs.collect::<Result<Vec<_>, _>>()?;
            let times: Vec<f64> = times.iter().filter_map(Run::cost).map(|cost| cost.of(part)).collect();
            cell.samples.push(times.iter().sum::<f64>() / times.len().max(1) as f64);
        }
        Ok(())
    }
}

/// How near our picture is to the true one.
fn likeness(row: &Row, folder: &Path) -> Result<Option<(f64, f64, f64)>, Failure> {
    let workload = workload::all().into_iter().find(|w| w.name == row.workload);
    let Some(workload) = workload.filter(|_| row.device == "memory") else { return Ok(None) };
    let measured = measure(&workload, workload.nominal_size(), Effort::Once, folder)?;
    let parts = (measured.psnr_db, measured.ink, measured.true_ink);
    Ok(if let (Some(psnr), Some(ink), Some(truth)) = parts { Some((psnr, ink, truth)) } else { None })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(likeness: f64, mib: u64, ours: f64) -> Row {
        let cell =
            |peer, time, first| Cell { peer, samples: vec![time], first, instructions: None, repetitions: 1 };
        let cost = Cost { peak_kib: mib << 10, ..Cost::default() };
        let cells = vec![
            cell(OURS, ours, Run::Done(cost)),
            cell("tiny-skia", 2000.0, Run::Done(Cost::default())),
            cell("GR", 0.0, Run::GivenUp),
            cell("cairo", 0.0, Run::Impossible),
        ];
        let likeness = Some((likeness, 26.0, 26.0));
        Row { workload: "w1", what: "W1", device: "memory", likeness, cells, profile: Vec::new() }
    }

    #[test]
    fn a_row_misses_what_it_does_not_reach() {
        assert_eq!(row(38.0, 16, 100.0).missed(), []);
        let missed = row(37.9, 17, 101.0).missed();
        assert_eq!(missed.iter().filter(|gate| gate.is_of_time()).count(), 1);
        assert_eq!(missed[1..], [Gate::Likeness(38.0), Gate::Memory(16.0)]);
    }

    #[test]
    fn a_run_that_is_given_up_counts_as_long_as_it_had() {
        let against_gr = |ours| {
            row(40.0, 1, ours)
                .missed()
                .into_iter()
                .any(|gate| matches!(gate, Gate::Against { peer: "GR", .. }))
        };
        assert!(!against_gr(160.0) && against_gr(170.0));
    }
}
