//! How much faster than whom this library shall be.

/// A bound on the time, or the bytes, of this library.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Gate {
    /// The library that is compared.
    pub(crate) peer: &'static str,
    /// At most this many times what the other one needs.
    pub(crate) factor: f64,
    /// What is compared.
    pub(crate) measure: Measure,
}

/// What gates bound.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    /// Processor time.
    Time,
    /// The size of the file.
    Bytes,
    /// Instructions of the whole process: of processes so short that their times are chance.
    Instructions,
}

/// The workloads of the table: name in the programs, description, device.
pub(crate) const ROWS: [(&str, &str, &str); 29] = [
    ("w1", "polyline of 1,000,000 noisy points", "memory"),
    ("w1a", "the same, aliased", "memory"),
    ("w1k", "polyline of 100,000 noisy points", "memory"),
    ("w1s", "polyline of 1,000,000 points, smooth", "memory"),
    ("w2", "100,000 lines of two points", "memory"),
    ("w3dot", "1,000,000 dots", "memory"),
    ("w3plus", "100,000 plus signs", "memory"),
    ("w3circ", "100,000 circles", "memory"),
    ("w4a", "10,000 polygons", "memory"),
    ("w4b", "a polygon of 200,000 vertices", "memory"),
    ("w5", "10,000 strings in a stroke font", "memory"),
    ("w6a", "1000 x 1000 cells", "memory"),
    ("w6b", "100 x 100 cells", "memory"),
    ("w7", "100,000 points dashed, width 3", "memory"),
    ("w8", "W1 with nine tenths clipped away", "memory"),
    ("w1", "SVG of W1", "svg"),
    ("w1s", "SVG of W1, smooth", "svg"),
    ("w2", "SVG of W2", "svg"),
    ("w4a", "SVG of W4", "svg"),
    ("w1", "PDF of W1", "pdf"),
    ("w1s", "PDF of W1, smooth", "pdf"),
    ("w2", "PDF of W2", "pdf"),
    ("w4a", "PDF of W4", "pdf"),
    ("w1", "PostScript of W1", "ps"),
    ("w1s", "PostScript of W1, smooth", "ps"),
    ("w2", "PostScript of W2", "ps"),
    ("w4a", "PostScript of W4", "ps"),
    ("w10", "process that draws one line, PNG", "png"),
    ("w10", "process that draws one line, SVG", "svg"),
];

/// In the place of a library: this one itself, with a polyline of as many points as are to be seen.
pub(crate) const OWN_TENTH: &str = "our own 100,000 points";

/// The gates of a row.
pub(crate) fn gates(workload: &str, device: &str) -> Vec<Gate> {
    let time = |peer, factor| Gate { peer, factor, measure: Measure::Time };
    let bytes = |peer, factor| Gate { peer, factor, measure: Measure::Bytes };
    let instructions = |peer, factor| Gate { peer, factor, measure: Measure::Instructions };
    match (device, workload) {
        ("memory", "w1") => vec![time("tiny-skia", 1.0 / 20.0)],
        ("memory", "w1a") => vec![time("tiny-skia", 1.0 / 35.0)],
        ("memory", "w1s") => vec![time("tiny-skia", 1.0 / 12.0)],
        ("memory", "w2") => vec![time("tiny-skia", 1.0 / 3.5)],
        ("memory", "w3dot") => vec![time("AGG", 1.0)],
        ("memory", "w3plus") => vec![time("tiny-skia", 1.0 / 6.0)],
        ("memory", "w3circ") => vec![time("tiny-skia", 1.0 / 15.0)],
        ("memory", "w4a" | "w4b") => vec![time("tiny-skia", 1.0 / 4.0)],
        ("memory", "w5") => vec![time("tiny-skia", 1.0 / 20.0)],
        ("memory", "w6a" | "w6b") => vec![time("cairo", 1.0)],
        ("memory", "w7") => vec![time("tiny-skia", 1.0 / 18.0)],
        ("memory", "w8") => vec![time(OWN_TENTH, 1.2)],
        ("png", "w10") => vec![time("cairo", 1.0 / 3.0)],
        ("svg", "w10") => vec![instructions("cairo", 0.8)],
        ("svg", _) => vec![time("cairo", 1.0 / 15.0), bytes("cairo", 1.0 / 2.5)],
        ("pdf", _) => vec![time("cairo", 1.0 / 12.0)],
        ("ps", _) => vec![time("cairo", 1.0 / 15.0)],
        _ => Vec::new(),
    }
}
