//! P. K. Ghosh and S. P. Mudur, "The Brush-Trajectory Approach to Figure Specification: Some Algebraic-Solutions", ACM
//! Transactions on Graphics 3(2), 1984: a line is what a brush covers on its way. Here the brush is round and moves upright, so
//! that all that it covers of a row lies side by side.

use super::SampleMask;
use super::sample_mask::SIDE;

/// Distances that are told apart within that of two samples.
const STEPS: f64 = 8.0;

/// A round brush: how many samples it covers to either side in a row, by the distance of that row from its middle.
#[derive(Clone, Debug)]
pub struct Brush {
    /// In samples.
    radius: f64,
    reaches: Vec<u32>,
}

impl Brush {
    /// A brush of a radius in pixels.
    pub fn new(radius: f64) -> Self {
        let radius = radius * SIDE;
        let reach = |i: u32| {
            let distance = (f64::from(i) + 0.5) / STEPS;
            ((radius * radius - distance * distance).max(0.0).sqrt() + 0.5) as u32
        };
        Brush { radius, reaches: (0..(radius * STEPS).ceil() as u32).map(reach).collect() }
    }

    /// The radius in pixels.
    pub fn radius(&self) -> f64 {
        self.radius / SIDE
    }

    #[inline]
    fn reach(&self, distance: f64) -> u32 {
        self.reaches.get((distance * STEPS) as usize).copied().unwrap_or(0)
    }
}

impl SampleMask {
    /// Adds the samples that a brush covers as its middle moves from a least to a greatest ordinate, in pixels, between two
    /// sample columns: so many of them lie left of it that begin with the first pixel of the raster.
    ///
    /// Ordinates must be numbers; those far from the window are brought nearer.
    pub fn sweep(&mut self, brush: &Brush, columns: i64, low: f64, high: f64) {
        let (low, high) = (nearer(low), nearer(high));
        let rows = self.window_rows();
        let row = |y: f64| first_row(y).max(rows.start).min(rows.end);
        let (begin, upper, lower, end) =
            (row(low - brush.radius), row(low), row(high), row(high + brush.radius));
        let widest = brush.reach(0.0);
        let (from, to) = (columns - i64::from(widest), columns + i64::from(widest));
        if !self.widen(begin..end, from..to) {
            return;
        }
        let middle = |row: i64| row as f64 + 0.5;
        for row in begin..upper {
            let reach = i64::from(brush.reach(low - middle(row)));
            self.add_rows(row..row + 1, columns - reach..columns + reach);
        }
        self.add_rows(upper..lower, from..to);
        for row in lower.max(upper)..end {
            let reach = i64::from(brush.reach(middle(row) - high));
            self.add_rows(row..row + 1, columns - reach..columns + reach);
        }
    }
}

/// An ordinate in samples, no farther away than rows are counted.
fn nearer(y: f64) -> f64 {
    const FARTHEST: f64 = (1u64 << 30) as f64;
    (y * SIDE).clamp(-FARTHEST, FARTHEST)
}

/// The first sample row whose middle lies beyond an ordinate in samples.
#[inline]
fn first_row(y: f64) -> i64 {
    // Rounded towards zero, which is downwards for what is positive.
    const BELOW: i64 = 1 << 32;
    (y + (BELOW as f64 + 0.5)) as i64 - BELOW
}

#[cfg(test)]
mod tests {
    use super::super::sample_mask::tests::words;
    use super::*;
    use crate::rect::IRect;
    use glam::IVec2;
    use std::collections::BTreeMap;

    #[test]
    fn a_brush_covers_what_lies_within_its_radius_of_its_way() {
        let mut mask = SampleMask::new();
        for radius in [0.5, 0.8, 1.5, 3.0] {
            let brush = Brush::new(radius);
            for (columns, low, high) in [(80, 9.3, 9.3), (85, 7.0, 14.56), (3, 4.2, 4.9), (157, -3.0, 40.0)] {
                let window = IRect::of_size(20, 20);
                mask.begin(window);
                mask.sweep(&brush, columns, low, high);
                let found = words(&mut mask);
                let x = columns as f64 / 8.0;
                for i in 0..20 * 20 * 64 {
                    let (column, row) = (i % 160, i / 160);
                    let (sx, sy) = ((f64::from(column) + 0.5) / 8.0, (f64::from(row) + 0.5) / 8.0);
                    let distance = (sx - x).hypot(sy - sy.clamp(low, high));
                    let word = found.get(&(column / 8, row / 8)).copied().unwrap_or(0);
                    let covered = word >> (row % 8 * 8 + column % 8) & 1 == 1;
                    // Within half the distance of two samples of the edge it may be either.
                    let clear = (distance - radius).abs() > 0.07;
                    assert!(!clear || covered == (distance < radius), "{radius} {columns} {low}: {sx} {sy}");
                }
            }
        }
    }

    #[test]
    fn a_sweep_has_the_same_samples_in_any_window() {
        let mut mask = SampleMask::new();
        let brush = Brush::new(1.3);
        let ways = [(40, 3.1, 9.7), (8, -5.0, 2.02), (100, 1e300, 1e301), (i64::from(i32::MAX), 0.0, 5.0)];
        let mut sweep = |low: IVec2, high: IVec2| {
            mask.begin(IRect::new(low, high));
            for (columns, low, high) in ways {
                mask.sweep(&brush, columns, low, high);
            }
            words(&mut mask)
        };
        let whole = sweep(IVec2::ZERO, IVec2::new(14, 12));
        assert!(whole.len() > 20);
        let mut bands = BTreeMap::new();
        for top in 0..4 {
            bands.append(&mut sweep(IVec2::new(0, top * 3), IVec2::new(14, top * 3 + 3)));
        }
        assert_eq!(whole, bands);
        assert!(sweep(IVec2::ONE, IVec2::ONE).is_empty());
    }
}
