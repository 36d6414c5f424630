//! T. M. Nicholl, D. T. Lee and R. A. Nicholl, "An Efficient New Algorithm for 2-D Line Clipping", Computer Graphics
//! (SIGGRAPH) 21(4), 1987: segment against rectangle by comparing directions before dividing.

use super::{hold, meet_horizontal, meet_vertical};
use crate::path::is_usable;
use crate::rect::Rect;
use glam::DVec2;

/// The part of segment a-b inside the rectangle, found with no division for a side that does not cut it.
///
/// The paper's cases are brought down to those of a segment that runs to the right and upwards by mirroring, which
/// changes signs only and is therefore exact.
pub fn nicholl_lee_nicholl(rect: Rect, a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    if !is_usable(a) || !is_usable(b) {
        return None;
    }
    let mirror = DVec2::new(if b.x < a.x { -1.0 } else { 1.0 }, if b.y < a.y { -1.0 } else { 1.0 });
    let (u, v) = (rect.0 * mirror, rect.1 * mirror);
    let (u, v) = (
        DVec2::new(if mirror.x < 0.0 { v.x } else { u.x }, if mirror.y < 0.0 { v.y } else { u.y }),
        DVec2::new(if mirror.x < 0.0 { u.x } else { v.x }, if mirror.y < 0.0 { u.y } else { v.y }),
    );
    let (p, q) = rising((u, v), a * mirror, b * mirror, mirror)?;
    Some((p * mirror, q * mirror))
}

/// The same for a segment whose end is neither left of nor below its beginning.
fn rising((min, max): Rect, a: DVec2, b: DVec2, mirror: DVec2) -> Option<(DVec2, DVec2)> {
    let empty = min.x > max.x || min.y > max.y;
    if empty || a.x > max.x || a.y > max.y || b.x < min.x || b.y < min.y {
        return None;
    }
    let d = b - a;
    // Positive when the segment passes above (left of) the corner.
    let passes = |x: f64, y: f64| (x - a.x) * d.y - (y - a.y) * d.x;
    // Cut as it was before mirroring, so that rounding is the same as in the other algorithms.
    let at_x = |x: f64| meet_vertical(a * mirror, b * mirror, x * mirror.x) * mirror;
    let at_y = |y: f64| meet_horizontal(a * mirror, b * mirror, y * mirror.y) * mirror;
    let by_left = match (a.x < min.x, a.y < min.y) {
        (false, false) => None,
        (left, below) => Some(left && (!below || passes(min.x, min.y) >= 0.0)),
    };
    let start = match by_left {
        None => a,
        Some(true) if passes(min.x, max.y) > 0.0 => return None,
        Some(true) => at_x(min.x),
        Some(false) if passes(max.x, min.y) < 0.0 => return None,
        Some(false) => at_y(min.y),
    };
    let end = match (b.x > max.x, b.y > max.y) {
        (false, false) => b,
        (true, above) if !above || passes(max.x, max.y) < 0.0 => at_x(max.x),
        _ => at_y(max.y),
    };
    let held = |p: DVec2, given: DVec2| if p == given { given } else { hold((min, max), p) };
    Some((held(start, a), held(end, b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_the_corner_region_all_four_ways() {
        let rect = (DVec2::ZERO, DVec2::new(4.0, 4.0));
        let from = DVec2::new(-2.0, -2.0);
        let cut = |x, y| nicholl_lee_nicholl(rect, from, DVec2::new(x, y));
        assert_eq!(cut(0.0, 6.0), None);
        assert_eq!(cut(1.0, 7.0), Some((DVec2::new(0.0, 4.0), DVec2::new(0.0, 4.0))));
        assert_eq!(cut(2.0, 6.0), Some((DVec2::new(0.0, 2.0), DVec2::new(1.0, 4.0))));
        assert_eq!(cut(6.0, 2.0), Some((DVec2::new(2.0, 0.0), DVec2::new(4.0, 1.0))));
        assert_eq!(cut(10.0, 2.0), Some((DVec2::new(4.0, 0.0), DVec2::new(4.0, 0.0))));
        assert_eq!(cut(11.0, 2.0), None);
        assert_eq!(cut(3.0, 2.0), Some((DVec2::new(0.5, 0.0), DVec2::new(3.0, 2.0))));
    }
}
