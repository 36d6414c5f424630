//! What is told of the measurements of a workload: a line of a table, or an object of JSON.

use super::measurement::Measurement;
use super::workload::Workload;
use serde::Serialize;

/// The measurements of a workload: that of the nominal size, and all sizes.
#[derive(Debug, Serialize)]
pub struct Report {
    /// The nominal size.
    #[serde(flatten)]
    pub nominal: Measurement,
    /// All sizes.
    pub sizes: Vec<Growth>,
}

/// How a workload costs more when it is larger.
#[derive(Debug, Serialize)]
pub struct Growth {
    /// The number of primitives, or of points of a single one.
    pub n: usize,
    /// Processor time in milliseconds.
    pub cpu_ms: f64,
    /// Memory in KiB beyond that of the data, at its peak.
    pub peak_kib: u64,
    /// The size of the file.
    pub bytes: u64,
}

impl From<&Measurement> for Growth {
    fn from(m: &Measurement) -> Growth {
        Growth { n: m.n, cpu_ms: m.cpu_ms, peak_kib: m.peak_kib, bytes: m.bytes }
    }
}

/// The heading of the table.
pub fn heading() -> String {
    format!(
        "{:<12} {:<30} {:>8} {:>9} {:>10} {:>6} {:>5} {:>5} {:>7} {:>7} {:>9} {:>10}  {}",
        "",
        "",
        "n",
        "ms",
        "tiny-skia",
        "ratio",
        "dB",
        "ts dB",
        "ink",
        "true",
        "KiB",
        "bytes",
        "ns each, by size"
    )
}

/// The line of the table for a workload.
pub fn line(workload: &Workload, report: &Report) -> String {
    let m = &report.nominal;
    let number = |value: Option<f64>, digits: usize| value.map_or(String::new(), |v| format!("{v:.digits$}"));
    let ratio = m.tiny_skia_cpu_ms.map(|direct| direct / m.cpu_ms);
    let growth: Vec<String> =
        report.sizes.iter().map(|s| format!("{:.1}", s.cpu_ms * 1e6 / s.n.max(1) as f64)).collect();
    let growth = growth.join(" ");
    format!(
        "{:<12} {:<30} {:>8} {:>9.3} {:>10} {:>6} {:>5} {:>5} {:>7} {:>7} {:>9} {:>10}  {growth}",
        workload.name,
        workload.what,
        m.n,
        m.cpu_ms,
        number(m.tiny_skia_cpu_ms, 3),
        number(ratio, 2),
        number(m.psnr_db, 1),
        number(m.tiny_skia_psnr_db, 1),
        number(m.ink, 2),
        number(m.true_ink, 2),
        m.peak_kib,
        m.bytes
    )
}
