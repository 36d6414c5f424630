//! D. F. Rogers and J. A. Adams, "Mathematical Elements for Computer Graphics", 2nd ed., McGraw-Hill 1990, section 4-6:
//! an elliptical arc as chords, from its parametric form.

use crate::path::is_usable;
use glam::DVec2;
use std::f64::consts::{FRAC_PI_4, TAU};

/// The most chords an arc is given, however small the tolerance.
const MOST_CHORDS: f64 = 16_384.0;

/// Appends the points of an elliptical arc, first and last included, no chord farther from it than the tolerance.
///
/// The arc is `center + a cos t + b sin t` for t from `start` to `start + sweep`, where `a` and `b` are conjugate half
/// diameters: any affine image of a circle. A sweep of a whole turn or more gives the whole ellipse, whose last point
/// equals its first. There are at least eight chords to a turn and at most 16384 in all. Nothing is appended if any
/// argument but the tolerance is not finite.
pub fn flatten(
    center: DVec2,
    a: DVec2,
    b: DVec2,
    start: f64,
    sweep: f64,
    tolerance: f64,
    points: &mut Vec<DVec2>,
) {
    let usable = [center, a, b].into_iter().all(is_usable) && start.is_finite() && sweep.is_finite();
    if !usable {
        return;
    }
    let sweep = sweep.clamp(-TAU, TAU);
    let first = points.len();
    let chords = chords(a, b, sweep, tolerance);
    for i in 0..=chords {
        let (sin, cos) = (start + sweep * (f64::from(i) / f64::from(chords))).sin_cos();
        points.push(center + a * cos + b * sin);
    }
    if sweep.abs() == TAU {
        let closing = points.len() - 1;
        points[closing] = points[first];
    }
}

/// How many chords of equal parameter keep within the tolerance.
///
/// On the unit circle a chord of angle h bulges by 1 - cos(h/2) = 2 sin²(h/4); the affine map stretches no length by more
/// than the large half axis, which is its greatest singular value.
fn chords(a: DVec2, b: DVec2, sweep: f64, tolerance: f64) -> u32 {
    let half_axis = (f64::hypot(a.x + b.y, a.y - b.x) + f64::hypot(a.x - b.y, a.y + b.x)) / 2.0;
    let ratio = tolerance.max(0.0) / (2.0 * half_axis);
    let step = 4.0 * ratio.min(1.0).sqrt().asin();
    (sweep.abs() / step.min(FRAC_PI_4)).ceil().clamp(1.0, MOST_CHORDS) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn flat(a: DVec2, b: DVec2, start: f64, sweep: f64, tolerance: f64) -> Vec<DVec2> {
        let mut points = vec![];
        flatten(DVec2::new(10.0, 20.0), a, b, start, sweep, tolerance, &mut points);
        points
    }

    #[test]
    fn points_lie_on_the_arc_and_chords_within_the_tolerance() {
        let mut random = Xorshift::new(12);
        let center = DVec2::new(10.0, 20.0);
        for _ in 0..200 {
            let (a, b) = (random.point(-50.0, 50.0), random.point(-50.0, 50.0));
            let (start, sweep) = (random.real(-9.0, 9.0), random.real(-6.0, 6.0));
            let tolerance = random.real(0.001, 1.0);
            let points = flat(a, b, start, sweep, tolerance);
            let at = |t: f64| center + a * t.cos() + b * t.sin();
            assert!(points[0].distance(at(start)) < 1e-9);
            assert!(points[points.len() - 1].distance(at(start + sweep)) < 1e-9);
            let step = sweep / (points.len() - 1) as f64;
            for (i, chord) in points.windows(2).enumerate() {
                for j in 0..=8 {
                    let p = at(start + step * (i as f64 + f64::from(j) / 8.0));
                    let u = chord[1] - chord[0];
                    let t = ((p - chord[0]).dot(u) / u.length_squared()).clamp(0.0, 1.0);
                    assert!(p.distance(chord[0] + u * t) <= tolerance + 1e-9);
                }
            }
        }
    }

    #[test]
    fn a_whole_turn_closes_and_needs_few_chords() {
        let (a, b) = (DVec2::new(100.0, 0.0), DVec2::new(0.0, 100.0));
        let circle = flat(a, b, 0.3, 99.0, 0.1);
        assert_eq!(circle[0], circle[circle.len() - 1]);
        // The polygon of n sides bulges by r (1 - cos(pi / n)); with 71 sides that is just below 0.1.
        assert_eq!(circle.len(), 72);
        assert_eq!(flat(a, b, 0.0, -TAU, 1e9).len(), 9);
        assert_eq!(flat(a, b, 0.0, FRAC_PI_2, 1e9).len(), 3);
    }

    #[test]
    fn extreme_and_bad_arguments() {
        let (a, b) = (DVec2::X * 1e150, DVec2::Y * 1e150);
        for tolerance in [0.0, -1.0, f64::NAN, 1e-300] {
            assert_eq!(flat(a, b, 0.0, TAU, tolerance).len(), 16_385);
        }
        assert_eq!(flat(DVec2::ZERO, DVec2::ZERO, 0.0, PI, 0.1).len(), 5);
        assert_eq!(flat(DVec2::X, DVec2::Y, 0.0, 0.0, 0.1).len(), 2);
        assert!(flat(DVec2::NAN, DVec2::Y, 0.0, 1.0, 0.1).is_empty());
        assert!(flat(DVec2::X, DVec2::Y, f64::INFINITY, 1.0, 0.1).is_empty());
    }
}
