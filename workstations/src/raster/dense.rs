//! Dense lines: paths of many more vertices than there are columns, drawn with a round pen.

use super::stroke::{GRID_PLACES, settled};
use gks_algorithms::coverage::{Brush, SIDE, SampleMask};
use gks_algorithms::line::stay;
use glam::DVec2;

/// By how much a border is more to the left: half of the distance of the points on which others settle, so that none of those is on
/// one side or the other by the last bit of its arithmetic.
const ASIDE: f64 = 0.5 / (1u64 << GRID_PLACES) as f64;
/// Columns farther away than this are not drawn.
const FARTHEST: f64 = 1e9;

/// Follows a path with a round brush and adds what it covers.
///
/// The brush goes up and down along the borders of sample columns: half the distance of two samples to the left or to the right
/// of a vertex at most. A path that stays near a border for long thus costs what one upright line does, and one that goes on
/// to the next one costs no more. Only where it goes farther at a time its segments are drawn.
pub(super) struct Dense<'a> {
    mask: &'a mut SampleMask,
    brush: &'a Brush,
    stay: Option<Upright>,
}

/// What the path has done since it came near a border of sample columns.
#[derive(Copy, Clone)]
struct Upright {
    /// The number of the border, and where one begins and ends to be near it.
    column: f64,
    left: f64,
    right: f64,
    low: f64,
    high: f64,
    last: DVec2,
}

impl Upright {
    #[inline]
    fn at(p: DVec2) -> Self {
        let column = ((p.x + ASIDE) * SIDE + 0.5).floor();
        let [left, right] = [-0.5, 0.5].map(|half| (column + half) / SIDE - ASIDE);
        Upright { column, left, right, low: p.y, high: p.y, last: p }
    }

    #[inline]
    fn reach(&mut self, low: f64, high: f64) {
        (self.low, self.high) = (self.low.min(low), self.high.max(high));
    }
}

impl<'a> Dense<'a> {
    pub(super) fn new(mask: &'a mut SampleMask, brush: &'a Brush) -> Self {
        Dense { mask, brush, stay: None }
    }

    /// Goes on along a part of the path. What is not a number is left out.
    pub(super) fn follow(&mut self, path: &[DVec2]) {
        let mut rest = path;
        loop {
            if let Some(upright) = &mut self.stay {
                let stay = stay(rest, upright.left, upright.right);
                if stay.count > 0 {
                    upright.reach(stay.low, stay.high);
                    upright.last = rest[stay.count - 1];
                    rest = &rest[stay.count..];
                }
            }
            let [p, others @ ..] = rest else { return };
            if p.is_finite() {
                self.go(*p);
            }
            rest = others;
        }
    }

    /// Ends the path.
    pub(super) fn end(self) {
        if let Some(upright) = self.stay {
            sweep(self.mask, self.brush, &upright);
        }
    }

    /// Goes to a vertex that is not near the border that the path was near before.
    fn go(&mut self, p: DVec2) {
        let mut next = Upright::at(p);
        if let Some(mut before) = self.stay {
            if (next.column - before.column).abs() <= 1.0 {
                // Each of the two goes half the way.
                let middle = before.last.y + (p.y - before.last.y) * 0.5;
                before.reach(middle, middle);
                next.reach(middle, middle);
            } else {
                self.segment(before.last, p);
            }
            sweep(self.mask, self.brush, &before);
        }
        self.stay = Some(next);
    }

    fn segment(&mut self, from: DVec2, to: DVec2) {
        let (from, to) = (settled(from), settled(to));
        let side = (to - from).normalize_or_zero().perp() * self.brush.radius();
        self.mask.polygon(&[from + side, to + side, to - side, from - side]);
    }
}

fn sweep(mask: &mut SampleMask, brush: &Brush, upright: &Upright) {
    if upright.column.abs() <= FARTHEST {
        let [low, high] = settled(DVec2::new(upright.low, upright.high)).to_array();
        mask.sweep(brush, upright.column as i64, low, high);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_algorithms::rect::IRect;

    fn distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
        let along = b - a;
        let t = ((p - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        p.distance(a + along * t)
    }

    /// Paths that stay in columns, go on in small steps, leap and come back, on a picture of 24 by 20 pixels.
    fn paths() -> Vec<Vec<DVec2>> {
        let noise = |i: u32| f64::from(i * 7919 % 1009) / 1009.0;
        let noisy = |size: f64| {
            move |i: u32| {
                DVec2::new(
                    2.0 + f64::from(i) * 0.02,
                    10.0 + 5.0 * (f64::from(i) * 0.01).sin() + size * noise(i),
                )
            }
        };
        let leaps = |i: u32| DVec2::new(1.0 + 22.0 * noise(i), -3.0 + 25.0 * noise(i * 31));
        let loops =
            |i: u32| DVec2::new(12.0, 10.0) + DVec2::from_angle(f64::from(i) * 0.01) * f64::from(i) * 0.01;
        let backwards = |i: u32| DVec2::new(30.0 - f64::from(i) * 0.11, 12.0 + 3.0 * noise(i));
        vec![
            (0..1000).map(noisy(0.0)).collect(),
            (0..1000).map(noisy(4.0)).collect(),
            (0..9).map(leaps).collect(),
            (0..1000).map(loops).collect(),
            (0..300).map(backwards).collect(),
            vec![DVec2::new(7.3, 7.7)],
        ]
    }

    #[test]
    fn the_last_bits_of_coordinates_make_no_difference() {
        let samples = |noise: f64| {
            let at = |i: u32| DVec2::new(f64::from(i / 5) / 16.0, 5.0 + f64::from(i * 7 % 33) / 16.0) + noise;
            let path: Vec<DVec2> = (0..900).map(at).collect();
            let (mut mask, brush, mut words) = (SampleMask::new(), Brush::new(0.5), Vec::new());
            mask.begin(IRect::of_size(13, 10));
            let mut dense = Dense::new(&mut mask, &brush);
            dense.follow(&path);
            dense.end();
            mask.drain(|row, column, given| words.push((row, column, given.to_vec())));
            words
        };
        assert!(!samples(0.0).is_empty());
        assert!(samples(0.0) == samples(1e-12) && samples(0.0) == samples(-1e-12));
    }

    #[test]
    fn what_is_covered_lies_within_the_radius_of_the_path() {
        let mut mask = SampleMask::new();
        for (number, path) in paths().into_iter().enumerate() {
            for radius in [0.5, 2.2] {
                mask.begin(IRect::of_size(24, 20));
                let brush = Brush::new(radius);
                let mut dense = Dense::new(&mut mask, &brush);
                // In parts, with something that is no number between them.
                let (one, other) = path.split_at(path.len() / 3);
                dense.follow(one);
                dense.follow(&[DVec2::NAN]);
                dense.follow(other);
                dense.end();
                let mut words = vec![0u64; 24 * 20];
                mask.drain(|row, column, given| {
                    let start = row as usize * 24 + column as usize;
                    words[start..start + given.len()].copy_from_slice(given);
                });
                for i in 0..24 * 20 * 16 {
                    // Every other sample of every other row.
                    let (column, row) = (i % 96 * 2, i / 96 * 2);
                    let sample = (DVec2::new(column as f64, row as f64) + 0.5) / 8.0;
                    let near = path.windows(2).map(|w| distance(sample, w[0], w[1]));
                    let away = near.fold(sample.distance(path[0]), f64::min);
                    let covered = words[row / 8 * 24 + column / 8] >> (row % 8 * 8 + column % 8) & 1 == 1;
                    let is_clear = (away - radius).abs() > 0.15;
                    assert!(!is_clear || covered == (away < radius), "{number} {radius}: {sample} {away}");
                }
            }
        }
    }
}
