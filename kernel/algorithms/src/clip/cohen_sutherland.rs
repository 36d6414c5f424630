//! D. Cohen and I. Sutherland; W. M. Newman and R. F. Sproull, "Principles of Interactive Computer Graphics", 2nd ed.,
//! McGraw-Hill 1979, chapter 5: segment against rectangle by outcodes.

use super::{meet_horizontal, meet_vertical};
use crate::path::is_usable;
use crate::rect::Rect;
use glam::DVec2;

pub(super) const LEFT: u8 = 1;
pub(super) const RIGHT: u8 = 2;
pub(super) const BELOW: u8 = 4;
pub(super) const ABOVE: u8 = 8;

/// The sides of the rectangle beyond which `p` lies, one bit each.
pub(super) fn outcode((min, max): Rect, p: DVec2) -> u8 {
    let bit = |beyond: bool, side: u8| if beyond { side } else { 0 };
    bit(p.x < min.x, LEFT) | bit(p.x > max.x, RIGHT) | bit(p.y < min.y, BELOW) | bit(p.y > max.y, ABOVE)
}

/// The part of segment a-b inside the rectangle, by outcodes.
///
/// Every cut is computed from the segment as given, not from one already cut, so errors do not add up.
pub fn cohen_sutherland(rect: Rect, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    if !is_usable(a) || !is_usable(b) {
        return None;
    }
    let (mut p, mut q) = (a, b);
    let (mut code_p, mut code_q) = (outcode(rect, p), outcode(rect, q));
    // Four cuts are enough; rounding at a corner may send a point to and fro between two sides for ever.
    for _ in 0..6 {
        if code_p | code_q == 0 {
            return Some((p, q));
        }
        if code_p & code_q != 0 {
            return None;
        }
        if code_p != 0 {
            p = cut(rect, code_p, a, b);
            code_p = outcode(rect, p);
        } else {
            q = cut(rect, code_q, a, b);
            code_q = outcode(rect, q);
        }
    }
    None
}

/// Where the segment meets the first side in the code.
fn cut((min, max): Rect, code: u8, a: DVec2, b: DVec2) -> DVec2 {
    if code & LEFT != 0 {
        meet_vertical(a, b, min.x)
    } else if code & RIGHT != 0 {
        meet_vertical(a, b, max.x)
    } else if code & BELOW != 0 {
        meet_horizontal(a, b, min.y)
    } else {
        meet_horizontal(a, b, max.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outcodes_of_the_nine_regions() {
        let rect = (DVec2::ZERO, DVec2::ONE);
        let code = |x, y| outcode(rect, DVec2::new(x, y));
        assert_eq!([code(-1.0, 2.0), code(0.5, 2.0), code(2.0, 2.0)], [LEFT | ABOVE, ABOVE, RIGHT | ABOVE]);
        assert_eq!([code(-1.0, 0.5), code(0.0, 1.0), code(2.0, 0.5)], [LEFT, 0, RIGHT]);
        assert_eq!(
            [code(-1.0, -1.0), code(0.5, -1.0), code(2.0, -1.0)],
            [LEFT | BELOW, BELOW, RIGHT | BELOW]
        );
    }

    #[test]
    fn a_diagonal_through_two_corners_is_cut_at_both() {
        let rect = (DVec2::ZERO, DVec2::new(4.0, 2.0));
        let cut = cohen_sutherland(rect, DVec2::new(-2.0, -1.0), DVec2::new(6.0, 3.0));
        assert_eq!(cut, Some((DVec2::ZERO, DVec2::new(4.0, 2.0))));
    }
}
