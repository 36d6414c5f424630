//! Dense lines: paths of many more vertices than there are columns, drawn with a round pen.

use super::stroke::settled;
use gks_algorithms::coverage::{Brush, SampleMask};
use gks_algorithms::line::stay;
use glam::DVec2;

/// Sample columns in a pixel.
const SIDE: f64 = 8.0;
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
        let column = (p.x * SIDE + 0.5).floor();
        let [left, right] = [-0.5, 0.5].map(|half| (column + half) / SIDE);
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
        mask.sweep(brush, upright.column as i64, upright.low, upright.high);
    }
}
