//! Y.-D. Liang and B. A. Barsky, "A New Concept and Method for Line Clipping", ACM Transactions on Graphics 3(1), 1984:
//! segment against rectangle by the interval of its parameter.

use super::cohen_sutherland::{ABOVE, BELOW, LEFT, RIGHT, outcode};
use super::{hold, meet_horizontal, meet_vertical};
use crate::path::is_usable;
use crate::rect::Rect;
use glam::DVec2;

/// Where a segment meets a line parallel to an axis.
type Meet = fn(DVec2, DVec2, f64) -> DVec2;

/// The part of segment a-b inside the rectangle, by the interval of the parameter along it.
pub fn liang_barsky(rect: Rect, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    if !is_usable(a) || !is_usable(b) {
        return None;
    }
    let (code_a, code_b) = (outcode(rect, a), outcode(rect, b));
    if code_a | code_b == 0 {
        return Some((a, b));
    }
    let (min, max) = rect;
    if code_a & code_b != 0 || min.x > max.x || min.y > max.y {
        return None;
    }
    let d = b - a;
    // The side through which the segment enters last and the one through which it leaves first. Whether it does is for the
    // ends to say: from far away the parameter of a side comes out as that of the end beyond it.
    let (mut enter, mut leave) = ((0.0, None), (1.0, None));
    for (run, low, high, meet) in [
        (d.x, (min.x - a.x, min.x, LEFT), (max.x - a.x, max.x, RIGHT), meet_vertical as Meet),
        (d.y, (min.y - a.y, min.y, BELOW), (max.y - a.y, max.y, ABOVE), meet_horizontal),
    ] {
        if run == 0.0 {
            continue;
        }
        let (near, far) = if run > 0.0 { (low, high) } else { (high, low) };
        if code_a & near.2 != 0 && (near.0 / run > enter.0 || enter.1.is_none()) {
            enter = (near.0 / run, Some((meet, near.1)));
        }
        if code_b & far.2 != 0 && (far.0 / run < leave.0 || leave.1.is_none()) {
            leave = (far.0 / run, Some((meet, far.1)));
        }
        if enter.0 > leave.0 {
            return None;
        }
    }
    let cut =
        |end: DVec2, side: Option<(Meet, f64)>| side.map_or(end, |(meet, at)| hold(rect, meet(a, b, at)));
    Some((cut(a, enter.1), cut(b, leave.1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Rect = (DVec2::ZERO, DVec2::ONE);

    #[test]
    fn parallels_are_judged_by_their_distance() {
        let row = |y| liang_barsky(UNIT, DVec2::new(-1.0, y), DVec2::new(2.0, y));
        assert_eq!(row(1.5), None);
        assert_eq!(row(1.0), Some((DVec2::new(0.0, 1.0), DVec2::ONE)));
        assert_eq!(row(0.25), Some((DVec2::new(0.0, 0.25), DVec2::new(1.0, 0.25))));
    }

    #[test]
    fn a_segment_that_ends_short_of_the_rectangle_is_hidden() {
        assert_eq!(liang_barsky(UNIT, DVec2::new(-2.0, 0.5), DVec2::new(-0.5, 0.5)), None);
        let dot = DVec2::splat(0.5);
        assert_eq!(liang_barsky(UNIT, dot, dot), Some((dot, dot)));
    }
}
