//! A. L. F. Meister, "Generalia de genesi figurarum planarum", 1769 (the shoelace formula): the area of rings.

use crate::path::{is_usable, subpaths};
use glam::DVec2;

/// The signed area of the rings together: positive where a ring runs anticlockwise with y upwards.
///
/// Rings that overlap are counted each, so this is the area filled only for rings that are simple and, where one is a
/// hole in another, turned the other way.
pub fn area(points: &[DVec2], ends: &[u32]) -> f64 {
    subpaths(points, ends).map(ring_area).sum()
}

/// The signed area of one ring; vertices that are not usable are left out.
pub fn ring_area(ring: &[DVec2]) -> f64 {
    let mut vertices = ring.iter().copied().filter(|&p| is_usable(p));
    let Some(origin) = vertices.next() else { return 0.0 };
    // Seen from the first vertex, so that a small ring far from zero loses no digits.
    let mut last = DVec2::ZERO;
    let mut twice = 0.0;
    for p in vertices {
        let p = p - origin;
        twice += last.perp_dot(p);
        last = p;
    }
    twice / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sign_tells_the_turn_and_holes_subtract() {
        let square = |from: f64, to: f64| {
            [DVec2::new(from, from), DVec2::new(to, from), DVec2::new(to, to), DVec2::new(from, to)]
        };
        let outer = square(0.0, 4.0);
        let mut hole = square(1.0, 2.0);
        hole.reverse();
        let rings = [outer, hole].concat();
        assert_eq!(ring_area(&outer), 16.0);
        assert_eq!(ring_area(&hole), -1.0);
        assert_eq!(area(&rings, &[4, 8]), 15.0);
    }

    #[test]
    fn far_away_and_bad_rings() {
        let far = DVec2::splat(1e12);
        assert_eq!(ring_area(&[far, far + DVec2::X, far + DVec2::ONE]), 0.5);
        assert_eq!(ring_area(&[]), 0.0);
        assert_eq!(ring_area(&[DVec2::ONE, DVec2::NAN, DVec2::X]), 0.0);
    }
}
