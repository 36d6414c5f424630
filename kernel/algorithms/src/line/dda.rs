//! Foley, van Dam, Feiner and Hughes, "Computer Graphics: Principles and Practice", 2nd ed., 1990, section 3.2.1: the
//! digital differential analyser.

use super::octant::Octant;
use crate::rect::IRect;
use glam::IVec2;

/// Gives the pixels of a segment inside the rectangle, from the first to the last, by a sum in fixed point.
///
/// The slope is held with 80 binary places and rounded up, so that even the longest segment is never lifted into the next
/// row by the error of the sum, and agrees with [`super::bresenham`].
pub fn dda(from: IVec2, to: IVec2, clip: IRect, mut plot: impl FnMut(i32, i32)) {
    let Some(octant) = Octant::new(from, to, clip) else { return };
    let run = i128::from(octant.run.max(1));
    // A sum below a row lies below it by 1 / (2 run) at least, which is more than all the rounding up together.
    let fixed = |value: i128, over: i128| ((value << 80) + over - 1).div_euclid(over);
    let slope = fixed(i128::from(octant.rise), run);
    let mut minor = fixed(i128::from(octant.bias()), 2 * run) + slope * i128::from(octant.first);
    for step in octant.first..=octant.last {
        let (x, y) = octant.pixel(step, (minor >> 80) as i64);
        plot(x, y);
        minor += slope;
    }
}
