//! Many short lines, one call each.

use super::random::Random;
use super::scene::{Data, Figures, Scene, StrokePen};
use gks::Gks;
use gks_pipeline::look::{Cap, Join};
use std::f64::consts::TAU;

/// Lines of two points, up to 20 pixels long, in all directions.
pub struct Lines {
    lines: Vec<[(f64, f64); 2]>,
    antialias: bool,
}

impl Lines {
    fn new(count: usize) -> Lines {
        let mut random = Random::new(4);
        let mut line = |_| {
            let (x, y) = (random.unit(), random.unit());
            let (half, turn) = (0.01 * random.unit(), TAU * random.unit());
            let (dx, dy) = (half * turn.cos(), half * turn.sin());
            [(x - dx, y - dy), (x + dx, y + dy)]
        };
        let mut lines = Vec::with_capacity(count);
        lines.extend((0..count).map(&mut line));
        Lines { lines, antialias: true }
    }

    /// W2.
    pub fn antialiased(count: usize) -> Box<dyn Scene> {
        Box::new(Lines::new(count))
    }

    /// W2 without antialiasing.
    pub fn aliased(count: usize) -> Box<dyn Scene> {
        Box::new(Lines { antialias: false, ..Lines::new(count) })
    }
}

impl Scene for Lines {
    fn draw(&self, gks: &mut Gks) -> gks::Result<()> {
        gks.set_line_cap(Cap::Round)?;
        gks.set_line_join(Join::Round)?;
        self.lines.iter().try_for_each(|line| gks.polyline(line))
    }

    fn data(&self) -> Data<'_> {
        Data::Lines(&self.lines)
    }

    fn figures(&self) -> Option<Figures<'_>> {
        let pen = StrokePen { antialias: self.antialias, ..StrokePen::THIN };
        Some(Box::new(move |canvas| self.lines.iter().for_each(|line| canvas.stroke(line, &pen))))
    }
}
