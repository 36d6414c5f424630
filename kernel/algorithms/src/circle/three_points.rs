//! Euclid, "Elements", book IV, proposition 5: the circle, or the arc, through three points.

use crate::path::is_usable;
use glam::DVec2;
use std::f64::consts::TAU;

/// An arc of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The centre of the circle.
    pub center: DVec2,
    /// Its radius, more than zero.
    pub radius: f64,
    /// The direction from the centre to the beginning of the arc, in radians.
    pub start: f64,
    /// The signed angle from the beginning to the end, in radians, less than a whole turn; positive is anticlockwise.
    pub sweep: f64,
}

/// The arc that begins at `a`, passes through `b` and ends at `c`; the circle is that through all three.
///
/// None if two of the points are equal or all three lie on a line, up to rounding.
pub fn three_points(a: DVec2, b: DVec2, c: DVec2) -> Option<Arc> {
    if ![a, b, c].into_iter().all(is_usable) {
        return None;
    }
    let (u, v) = (b - a, c - a);
    let size = u.abs().max(v.abs()).max_element();
    // Below, the third powers of lengths must neither overflow nor vanish.
    let (u, v) = (u / size, v / size);
    let turn = u.perp_dot(v);
    let shortest = u.length().min(v.length()).min(u.distance(v));
    let longest = u.length().max(v.length()).max(u.distance(v));
    // Three equal points make the size zero and all these not a number.
    if turn.is_nan() || turn.abs() <= 1e-12 * shortest * longest {
        return None;
    }
    let offset = (u.perp() * v.length_squared() - v.perp() * u.length_squared()) / (2.0 * turn);
    let (from, to) = (-offset, v - offset);
    let turned = (to.to_angle() - from.to_angle()).rem_euclid(TAU);
    let sweep = if turn > 0.0 { turned } else { turned - TAU };
    Some(Arc { center: a + offset * size, radius: offset.length() * size, start: from.to_angle(), sweep })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn both_ways_round_the_unit_circle() {
        let arc = three_points(DVec2::X, DVec2::Y, DVec2::NEG_X).unwrap();
        assert!(arc.center.length() < 1e-15 && (arc.radius - 1.0).abs() < 1e-15 && arc.start.abs() < 1e-15);
        assert!((arc.sweep - PI).abs() < 1e-15);
        let arc = three_points(DVec2::X, DVec2::NEG_X, DVec2::Y).unwrap();
        assert!((arc.sweep + 3.0 * FRAC_PI_2).abs() < 1e-15);
    }

    #[test]
    fn finds_the_arc_the_points_were_taken_from() {
        let mut random = Xorshift::new(13);
        for _ in 0..1000 {
            let (center, radius) = (random.point(-100.0, 100.0), random.real(0.1, 100.0));
            let start = random.real(-3.0, 3.0);
            let sweep = random.real(0.5, 6.0) * if random.int(0, 1) == 0 { -1.0 } else { 1.0 };
            let at = |t: f64| center + DVec2::from_angle(start + sweep * t) * radius;
            let arc = three_points(at(0.0), at(random.real(0.2, 0.8)), at(1.0)).unwrap();
            assert!(arc.center.distance(center) < 1e-8 && (arc.radius - radius).abs() < 1e-8);
            assert!((arc.sweep - sweep).abs() < 1e-7, "{arc:?} {sweep}");
        }
    }

    #[test]
    fn lines_and_equal_points_have_no_circle() {
        let (a, b) = (DVec2::new(0.1, 0.2), DVec2::new(0.7, 0.9));
        assert_eq!(three_points(a, a.lerp(b, 0.3), b), None);
        for (p, q, r) in [(a, a, b), (a, b, a), (a, b, b), (a, a, a), (a, DVec2::NAN, b)] {
            assert_eq!(three_points(p, q, r), None);
        }
    }

    #[test]
    fn sizes_at_the_limits() {
        for size in [1e-150, 1e150] {
            let arc = three_points(DVec2::X * size, DVec2::Y * size, DVec2::NEG_X * size).unwrap();
            assert!((arc.radius / size - 1.0).abs() < 1e-12 && arc.center.length() < 1e-12 * size);
        }
    }
}
