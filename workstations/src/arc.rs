//! Elliptic arcs as cubic Bezier curves, for formats that have no arcs of their own.
//!
//! A piece of the arc becomes the cubic that shares its ends and tangents and touches it in the middle; the
//! error is that of M. Goldapp, "Approximation of circular arcs by cubic polynomials", Computer Aided
//! Geometric Design 8 (1991) 227-238. Affine maps keep cubics, so conjugate semi-diameters are all that is
//! needed.

use gks_geometry::Space;
use gks_pipeline::item::{Closure, Ellipse};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The most pieces an arc is cut into.
const MOST_PIECES: u32 = 64;

/// The cubics along an arc, each as two inner points and the end point; the first one starts at
/// `ellipse.at(ellipse.start)`. They stay within `tolerance` of the arc. The chord or the radii that
/// complete it are not among them.
pub(crate) fn cubics<S: Space>(ellipse: &Ellipse<S>, tolerance: f64) -> impl Iterator<Item = [DVec2; 3]> {
    let Ellipse { centre, a, b, start, .. } = *ellipse;
    let sweep = match ellipse.closure {
        Closure::Full => TAU.copysign(ellipse.sweep),
        _ if ellipse.sweep.is_finite() => ellipse.sweep.clamp(-TAU, TAU),
        _ => 0.0,
    };
    let pieces = pieces(sweep, a.length().hypot(b.length()), tolerance);
    let step = sweep / f64::from(pieces);
    let tangent = 4.0 / 3.0 * (step / 4.0).tan();
    (0..pieces).map(move |i| {
        let t = start + step * f64::from(i);
        let (sin, cos) = t.sin_cos();
        let (next_sin, next_cos) = (t + step).sin_cos();
        let at = |x: f64, y: f64| centre.0 + a.0 * x + b.0 * y;
        [
            at(cos - tangent * sin, sin + tangent * cos),
            at(next_cos + tangent * next_sin, next_sin - tangent * next_cos),
            at(next_cos, next_sin),
        ]
    })
}

/// How many equal pieces keep an arc of a circle of radius `reach` within `tolerance`.
fn pieces(sweep: f64, reach: f64, tolerance: f64) -> u32 {
    let mut pieces = (sweep.abs() / FRAC_PI_2).ceil().clamp(1.0, 4.0) as u32;
    while pieces < MOST_PIECES {
        let quarter = sweep.abs() / f64::from(pieces) / 4.0;
        let error = 2.0 / 27.0 * quarter.sin().powi(6) / quarter.cos().powi(2) * reach;
        if error <= tolerance || error.is_nan() {
            break;
        }
        pieces += 1;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::{Du, Point, Vector};

    fn arc(start: f64, sweep: f64, closure: Closure) -> Ellipse<Du> {
        let (a, b) = (Vector::new(300.0, 40.0), Vector::new(-20.0, 150.0));
        Ellipse { centre: Point::new(10.0, 20.0), a, b, start, sweep, closure }
    }

    /// The distance by which points of the cubics lie off the ellipse, measured where it is a unit circle.
    fn worst(ellipse: &Ellipse<Du>, tolerance: f64) -> f64 {
        let (a, b) = (ellipse.a.0, ellipse.b.0);
        let det = a.perp_dot(b);
        let mut from = ellipse.at(ellipse.start).0;
        let mut worst: f64 = 0.0;
        for [c, d, e] in cubics(ellipse, tolerance) {
            for i in 0..=16 {
                let t = f64::from(i) / 16.0;
                let s = 1.0 - t;
                let p = from * (s * s * s) + c * (3.0 * s * s * t) + d * (3.0 * s * t * t) + e * (t * t * t);
                let p = p - ellipse.centre.0;
                let (x, y) = (p.perp_dot(b) / det, a.perp_dot(p) / det);
                worst = worst.max((x.hypot(y) - 1.0).abs());
            }
            from = e;
        }
        assert!(
            (from - ellipse.at(ellipse.start + ellipse.sweep).0).length() < 1e-9,
            "the arc ends elsewhere: {from}"
        );
        worst
    }

    #[test]
    fn cubics_follow_the_ellipse_as_closely_as_asked() {
        for sweep in [TAU, -TAU, 1.0, -3.0, 0.01] {
            for tolerance in [10.0, 0.01, 0.0001] {
                let ellipse = arc(0.7, sweep, Closure::Open);
                let off = worst(&ellipse, tolerance) * 310.0;
                assert!(off <= tolerance, "sweep {sweep}: off by {off}, allowed {tolerance}");
            }
        }
        assert_eq!(cubics(&arc(0.0, TAU, Closure::Open), 10.0).count(), 4);
        assert!(cubics(&arc(0.0, TAU, Closure::Open), 0.001).count() > 4);
    }

    #[test]
    fn full_ellipses_come_back_and_senseless_ones_end() {
        let whole = arc(0.3, 0.0, Closure::Full);
        let last = cubics(&whole, 0.01).last().unwrap()[2];
        assert!((last - whole.at(0.3).0).length() < 1e-9);
        assert_eq!(cubics(&arc(0.0, f64::NAN, Closure::Open), 0.01).count(), 1);
        let endless = Ellipse { a: Vector::new(f64::INFINITY, 0.0), ..arc(0.0, 1.0, Closure::Pie) };
        assert!(cubics(&endless, 0.01).count() <= MOST_PIECES as usize);
    }
}
