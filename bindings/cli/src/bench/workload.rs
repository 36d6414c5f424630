//! The workloads, and how each of them is drawn.

use super::area::Areas;
use super::cells::CellArray;
use super::curve::Curve;
use super::line::Lines;
use super::marker::Markers;
use super::scene::Scene;
use super::text::Strings;
use gks_pipeline::generated::numbers::{MARKERS, workstation_type as own};

/// A benchmark.
pub struct Workload {
    /// The name by which it is asked for.
    pub name: String,
    /// What is drawn, in a few words.
    pub what: String,
    /// Where it is drawn.
    pub way: Way,
    /// Numbers of primitives, or of points of a single one.
    pub sizes: [usize; 3],
    /// Which of the sizes is compared with others.
    pub nominal: usize,
    /// Makes the picture of a size.
    pub scene: Box<dyn Fn(usize) -> Box<dyn Scene>>,
}

/// What is measured.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Way {
    /// Drawing on the frame buffer of colours.
    TrueColour,
    /// Drawing on the frame buffer of colour indices, without antialiasing.
    Indexed,
    /// Writing a file of a workstation type, from OPEN to CLOSE WORKSTATION.
    Document(i32),
    /// Redrawing a segment on the frame buffer of colours.
    Redrawn,
    /// Reading a metafile of a workstation type and drawing it on the frame buffer of colours.
    Played(i32),
    /// A whole process that writes a file with one line.
    Start(i32),
}

impl Workload {
    /// The size that is compared with others.
    pub fn nominal_size(&self) -> usize {
        self.sizes[self.nominal]
    }
}

type Make = fn(usize) -> Box<dyn Scene>;

/// Name, description, way, sizes, which of them is the nominal one, scene.
type Row = (&'static str, &'static str, Way, [usize; 3], usize, Make);

/// All workloads.
pub fn all() -> Vec<Workload> {
    const MILLION: usize = 1_000_000;
    const TENTH: usize = MILLION / 10;
    // To ten million, where growth shows.
    let great = [TENTH, MILLION, 10 * MILLION];
    let small = [1_000, 10_000, TENTH];
    let rows: [Row; 21] = [
        ("w1", "noisy polyline", Way::TrueColour, great, 1, Curve::noisy),
        ("w1a", "noisy polyline, aliased", Way::Indexed, great, 1, Curve::aliased),
        ("w1s", "smooth polyline", Way::TrueColour, great, 1, Curve::smooth),
        ("w2", "lines of two points", Way::TrueColour, great, 0, Lines::antialiased),
        ("w2a", "lines of two points, aliased", Way::Indexed, great, 0, Lines::aliased),
        ("w3dot", "dots", Way::TrueColour, great, 1, Markers::dots),
        ("w3plus", "plus signs", Way::TrueColour, great, 0, Markers::pluses),
        ("w3circ", "circles", Way::TrueColour, great, 0, Markers::circles),
        ("w4a", "polygons", Way::TrueColour, small, 1, Areas::many),
        ("w4b", "one polygon", Way::TrueColour, [20_000, 200_000, 2 * MILLION], 1, Areas::large),
        ("w5", "strings, stroke font", Way::TrueColour, small, 1, Strings::strokes),
        ("w6a", "cell array", Way::TrueColour, [250_000, MILLION, 4 * MILLION], 1, CellArray::square),
        ("w6b", "cell array, large cells", Way::TrueColour, [2_500, 10_000, 40_000], 1, CellArray::square),
        ("w7", "dashed polyline, width 3", Way::TrueColour, great, 0, Curve::dashed),
        ("w8", "noisy polyline, clipped", Way::TrueColour, great, 1, Curve::clipped),
        ("outlines", "strings, outline font", Way::TrueColour, small, 1, Strings::outlines),
        ("pattern", "polygons with a pattern", Way::TrueColour, small, 1, Areas::patterned),
        ("hatch", "polygons with a hatch", Way::TrueColour, small, 1, Areas::hatched),
        ("segment", "segment of lines, redrawn", Way::Redrawn, great, 0, Lines::antialiased),
        ("play", "metafile of lines, played", Way::Played(own::GKSM), great, 0, Lines::antialiased),
        ("playcgm", "the same as CGM, binary", Way::Played(own::CGM), great, 0, Lines::antialiased),
    ];
    let mut all: Vec<Workload> = rows
        .into_iter()
        .map(|(name, what, way, sizes, nominal, make)| {
            let scene = Box::new(make);
            Workload { name: name.into(), what: what.into(), way, sizes, nominal, scene }
        })
        .collect();
    for marker in MARKERS {
        let kind = marker.number;
        all.push(Workload {
            name: format!("marker{kind}"),
            what: format!("markers: {}", marker.name),
            way: Way::TrueColour,
            sizes: [TENTH / 10, TENTH, MILLION],
            nominal: 1,
            scene: Box::new(move |count| Markers::of(kind, count)),
        });
    }
    for (format, kind) in [("svg", own::SVG), ("pdf", own::PDF), ("ps", own::PS)] {
        let pictures: [(&str, &str, [usize; 3], usize, Make); 4] = [
            ("w1", "noisy polyline", great, 1, Curve::noisy),
            ("w1s", "smooth polyline", great, 1, Curve::smooth),
            ("w2", "lines of two points", great, 0, Lines::antialiased),
            ("w4a", "polygons", small, 1, Areas::many),
        ];
        for (picture, what, sizes, nominal, make) in pictures {
            all.push(Workload {
                name: format!("w9{format}-{picture}"),
                what: format!("{what}, {}", format.to_uppercase()),
                way: Way::Document(kind),
                sizes,
                nominal,
                scene: Box::new(make),
            });
        }
    }
    for (format, kind) in [("png", own::PNG), ("svg", own::SVG), ("pdf", own::PDF), ("ps", own::PS)] {
        all.push(Workload {
            name: format!("w10{format}"),
            what: format!("process that draws one line, {}", format.to_uppercase()),
            way: Way::Start(kind),
            sizes: [1; 3],
            nominal: 0,
            scene: Box::new(Lines::antialiased),
        });
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn names_are_unique_and_sizes_increase() {
        let all = all();
        let names: BTreeSet<&str> = all.iter().map(|w| w.name.as_str()).collect();
        assert_eq!(names.len(), all.len());
        for workload in &all {
            let increasing = workload.sizes.windows(2).all(|pair| pair[0] < pair[1]);
            assert!(increasing || matches!(workload.way, Way::Start(_)), "{}", workload.name);
        }
        for key in "w1 w1s w2 w3dot w3plus w3circ w4a w4b w5 w6a w6b w7 w8".split(' ') {
            assert!(names.contains(key), "{key}");
        }
    }
}
