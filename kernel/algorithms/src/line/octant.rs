//! J. E. Bresenham, 1965, for the eight cases made one; Ye. Kuzmin, "Bresenham's Line Generation Algorithm with Built-in
//! Clipping", Computer Graphics Forum 14(5), 1995, for the steps that can be seen.

use crate::rect::IRect;
use glam::IVec2;

/// A segment turned so that it runs along its longer axis with rising or level minor coordinate, and cut to the steps in
/// which it can be seen.
///
/// In step i of `run` it is i along the longer axis and (i * `rise`) / `run`, rounded, along the other. Halves are rounded
/// towards the greater coordinate of the raster, whichever way the segment runs.
pub(super) struct Octant {
    origin: (i32, i32),
    sign: (i32, i32),
    steep: bool,
    pub(super) run: i64,
    pub(super) rise: i64,
    /// The first and the last step inside the rectangle.
    pub(super) first: i64,
    pub(super) last: i64,
}

impl Octant {
    /// The segment, or none if it cannot be seen.
    pub(super) fn new(from: IVec2, to: IVec2, clip: IRect) -> Option<Self> {
        let steep = from.y.abs_diff(to.y) > from.x.abs_diff(to.x);
        let along = |p: IVec2| if steep { (p.y, p.x) } else { (p.x, p.y) };
        let (origin, end) = (along(from), along(to));
        let sign = |from: i32, to: i32| if to < from { -1 } else { 1 };
        let sign = (sign(origin.0, end.0), sign(origin.1, end.1));
        let run = i64::from(origin.0.abs_diff(end.0));
        let rise = i64::from(origin.1.abs_diff(end.1));
        let mut octant = Self { origin, sign, steep, run, rise, first: 0, last: run };
        if !clip.contains(from.x, from.y) || !clip.contains(to.x, to.y) {
            if clip.is_empty() {
                return None;
            }
            octant.cut(along(clip.min), along(clip.max));
        }
        (octant.first <= octant.last).then_some(octant)
    }

    /// Leaves the steps within the rectangle; in step i the minor coordinate is (2 i rise + bias) / (2 run) rounded down.
    fn cut(&mut self, min: (i32, i32), max: (i32, i32)) {
        let within = |origin: i32, sign: i32, min: i32, max: i32| {
            let (low, high) = (i64::from(min) - i64::from(origin), i64::from(max) - 1 - i64::from(origin));
            if sign < 0 { (-high, -low) } else { (low, high) }
        };
        let (low, high) = within(self.origin.0, self.sign.0, min.0, max.0);
        (self.first, self.last) = (low.max(0), high.min(self.run));
        let (low, high) = within(self.origin.1, self.sign.1, min.1, max.1);
        if self.first > self.last || low > self.rise || high < 0 {
            self.last = -1;
            return;
        }
        if self.rise == 0 {
            return;
        }
        let (run, rise, bias) = (i128::from(self.run), i128::from(self.rise), i128::from(self.bias()));
        let reaches = |minor: i64| -(-(2 * run * i128::from(minor) - bias)).div_euclid(2 * rise);
        // Both fit after being held within the steps there are.
        self.first = reaches(low.max(0)).clamp(i128::from(self.first), run + 1) as i64;
        self.last = (reaches(high.min(self.rise) + 1) - 1).clamp(-1, i128::from(self.last)) as i64;
    }

    /// What is added to 2 i rise before dividing by 2 run, so that halves go the right way.
    pub(super) fn bias(&self) -> i64 {
        if self.sign.1 < 0 { self.run - 1 } else { self.run }
    }

    /// The minor coordinate in the first step, and the remainder of its division by 2 run.
    pub(super) fn start(&self) -> (i64, i64) {
        if self.first == 0 || self.run == 0 {
            return (0, self.bias());
        }
        let sum = 2 * i128::from(self.first) * i128::from(self.rise) + i128::from(self.bias());
        let whole = 2 * i128::from(self.run);
        ((sum / whole) as i64, (sum % whole) as i64)
    }

    /// The pixel a step and a minor coordinate stand for; both must lie within the segment.
    pub(super) fn pixel(&self, step: i64, minor: i64) -> (i32, i32) {
        let at = |origin: i32, sign: i32, by: i64| (i64::from(origin) + i64::from(sign) * by) as i32;
        let (major, minor) = (at(self.origin.0, self.sign.0, step), at(self.origin.1, self.sign.1, minor));
        if self.steep { (minor, major) } else { (major, minor) }
    }
}
