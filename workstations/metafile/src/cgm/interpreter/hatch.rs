//! Hatch styles that a metafile defines.

use super::line::{Outline, linetype};
use super::{Drawing, Interpreter};
use crate::cgm::coding::SizeMode;
use crate::cgm::decoder::Decoder;
use crate::cgm::element::Element;
use gks_algorithms::fill::{Hatch as Hatcher, HatchLines};
use gks_algorithms::path::Rule;
use gks_geometry::{Ndc, PathBuf};
use gks_pipeline::look::{Cap, Look};
use glam::DVec2;

/// The most lines of a cycle.
const MOST_LINES: usize = 64;

/// The most lines that an area gets: of one direction and place in the cycle, and pieces of them.
const MOST_ROWS: u32 = 4096;
const MOST_PIECES: usize = 100_000;

/// Parallel lines in one or two directions, at distances that repeat.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Hatch {
    mode: SizeMode,
    /// One direction, or two if the lines cross.
    directions: Vec<DVec2>,
    /// The length after which the distances repeat, as the specification mode has it.
    cycle: f64,
    /// Where in the cycle each line is, as a part of it, and its line type.
    lines: Vec<(f64, i32)>,
}

impl Hatch {
    /// The hatch that an element defines.
    pub(super) fn new(e: &Element, mode: SizeMode) -> Option<Hatch> {
        let directions =
            if e.integer(1)? == 1 { vec![e.vector(2)?, e.vector(4)?] } else { vec![e.vector(2)?] };
        let cycle = e.real(6).filter(|cycle| *cycle > 0.0)?;
        let count = usize::try_from(e.integer(7)?).ok().filter(|count| (1..=MOST_LINES).contains(count))?;
        let gap = |i: usize| Some(f64::from(e.integer(8 + i)?).abs());
        let gaps: Vec<f64> = (0..count).map(gap).collect::<Option<_>>()?;
        let sum: f64 = gaps.iter().sum();
        if sum == 0.0 || directions.contains(&DVec2::ZERO) {
            return None;
        }
        let mut at = 0.0;
        let line = |(i, gap): (usize, &f64)| {
            let line = (at / sum, e.integer(8 + count + i).unwrap_or(1));
            at += gap;
            line
        };
        Some(Hatch { mode, directions, cycle, lines: gaps.iter().enumerate().map(line).collect() })
    }
}

impl<D: Decoder> Interpreter<D> {
    /// Draws the lines of a hatch inside of what an outline encloses, from the fill reference point on.
    pub(super) fn hatch(&mut self, outline: Outline, hatch: &Hatch, mut look: Look) {
        let mapping = self.mapping();
        let mut rings = PathBuf::<Ndc>::new();
        rings.add_mapped(outline.flattened(self.tolerance()).as_paths(), &mapping.map);
        let reference = mapping.point(self.context.reference.unwrap_or(mapping.extent.0));
        let spacing = mapping.style(hatch.cycle, hatch.mode, self.context.metric);
        let rect = (mapping.window.min.0, mapping.window.max.0);
        look.line.colour = look.fill.colour;
        (look.line.width, look.cap) = (1.0, Cap::Butt);
        let limit = MOST_ROWS / hatch.lines.len() as u32;
        let (mut hatcher, mut room) = (Hatcher::new(), MOST_PIECES);
        for &direction in &hatch.directions {
            let angle = mapping.vector(direction).0.to_angle();
            for &(place, kind) in &hatch.lines {
                let origin = reference + DVec2::from_angle(angle).perp() * (spacing * place);
                let lines = HatchLines { angle, spacing, origin, limit };
                let mut pieces = PathBuf::<Ndc>::new();
                hatcher.segments(&rings.points, &rings.ends, Rule::EvenOdd, &lines, rect, |a, b| {
                    if room > 0 {
                        room -= 1;
                        pieces.add([a, b]);
                    }
                });
                look.line.linetype = linetype(kind);
                self.draw(Drawing::Lines(pieces), look.clone());
            }
        }
    }
}
