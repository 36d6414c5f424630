//! What a program says that it has cost to draw a workload.

use serde::{Deserialize, Serialize};

/// The cost of one run. Times are processor times in milliseconds.
#[derive(Copy, Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Cost {
    /// Opening the workstation.
    pub(crate) open_ms: f64,
    /// Drawing once.
    pub(crate) draw_ms: f64,
    /// Closing the workstation, which completes its file.
    pub(crate) close_ms: f64,
    /// The whole process until then.
    pub(crate) process_ms: f64,
    /// Memory in KiB beyond that of the data, at its peak.
    pub(crate) peak_kib: u64,
    /// The size of the file.
    pub(crate) bytes: u64,
}

/// Which part of a cost is compared.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Drawing alone: pictures in memory.
    Drawing,
    /// From opening to closing: documents.
    Document,
    /// The whole process.
    Process,
}

impl Cost {
    /// The time that is compared, in milliseconds.
    pub(crate) fn of(&self, part: Part) -> f64 {
        match part {
            Part::Drawing => self.draw_ms,
            Part::Document => self.open_ms + self.draw_ms + self.close_ms,
            Part::Process => self.process_ms,
        }
    }
}
