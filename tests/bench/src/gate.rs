//! How much faster than whom this library shall be.

/// A bound on what this library needs or reaches.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(crate) enum Gate {
    /// At most `factor` times what another library needs.
    Against {
        /// The library that is compared.
        peer: &'static str,
        /// What is compared.
        measure: Measure,
        /// At most this many times as much.
        factor: f64,
    },
    /// The least likeness of the picture to the true one, in decibels.
    Likeness(f64),
    /// The most memory beyond that of the data, in MiB.
    Memory(f64),
}

impl Gate {
    /// Whether times are compared, which on a busy machine are chance in a single run.
    pub(crate) fn is_of_time(&self) -> bool {
        matches!(self, Gate::Against { measure: Measure::Time, .. })
    }

    /// Whether instructions are compared.
    pub(crate) fn is_of_instructions(&self) -> bool {
        matches!(self, Gate::Against { measure: Measure::Instructions, .. })
    }
}

/// What is compared with other libraries.
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
pub(crate) const ROWS: [(&str, &str, &str); 32] = [
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
    ("w1", "small PDF of W1", "pdf-small"),
    ("w2", "small PDF of W2", "pdf-small"),
    ("w4a", "small PDF of W4", "pdf-small"),
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
    let time = |peer, factor| Gate::Against { peer, measure: Measure::Time, factor };
    let bytes = |peer, factor| Gate::Against { peer, measure: Measure::Bytes, factor };
    let instructions = |peer, factor| Gate::Against { peer, measure: Measure::Instructions, factor };
    let one_of = |factor: f64| 1.0 / factor;
    match (device, workload) {
        ("memory", "w1") => vec![
            time("tiny-skia", one_of(20.0)),
            time("Blend2D", one_of(8.0)),
            time("GR", one_of(60.0)),
            Gate::Likeness(38.0),
            Gate::Memory(16.0),
        ],
        ("memory", "w1a") => vec![time("tiny-skia", one_of(35.0))],
        ("memory", "w1s") => {
            vec![time("tiny-skia", one_of(12.0)), time("GR", one_of(30.0)), Gate::Likeness(38.0)]
        }
        ("memory", "w2") => vec![time("tiny-skia", one_of(3.5)), time("GR", one_of(5.0))],
        ("memory", "w3dot") => vec![time("AGG", 1.0), time("GR", one_of(50.0))],
        ("memory", "w3plus") => vec![time("tiny-skia", one_of(6.0)), time("GR", one_of(8.0))],
        ("memory", "w3circ") => vec![time("tiny-skia", one_of(15.0)), time("GR", one_of(20.0))],
        ("memory", "w4a" | "w4b") => vec![time("tiny-skia", one_of(4.0)), time("Blend2D", 1.1)],
        ("memory", "w5") => vec![time("tiny-skia", one_of(20.0)), time("GR", one_of(12.0))],
        ("memory", "w6a" | "w6b") => vec![time("cairo", 1.0), time("GR", one_of(15.0))],
        ("memory", "w7") => {
            vec![time("tiny-skia", one_of(18.0)), time("GR", one_of(20.0)), Gate::Likeness(34.0)]
        }
        ("memory", "w8") => vec![time(OWN_TENTH, 1.2), time("GR", one_of(40.0))],
        ("png", "w10") => vec![time("cairo", one_of(3.0))],
        ("svg", "w10") => vec![instructions("cairo", 0.8)],
        ("svg", _) => {
            vec![time("cairo", one_of(15.0)), bytes("cairo", one_of(2.5)), time("GR", one_of(10.0))]
        }
        ("pdf", _) => vec![time("cairo", one_of(12.0)), time("GR", one_of(10.0))],
        ("pdf-small", _) => vec![time("cairo", one_of(4.0)), bytes("cairo", 1.05)],
        ("ps", _) => vec![time("cairo", one_of(15.0)), time("GR", one_of(2.5))],
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_but_one_has_a_gate_and_no_name_of_a_row_occurs_twice() {
        for (workload, what, device) in ROWS {
            // W1 with a tenth of the points is what W8 is compared with.
            assert_eq!(gates(workload, device).is_empty(), workload == "w1k", "{what}");
            assert_eq!(ROWS.iter().filter(|row| row.1 == what).count(), 1, "{what}");
        }
    }
}
