//! Paths of the scan converter made of rings and curves.

use gks_geometry::{Du, Paths};
use gks_pipeline::item::{Closure, Curve, Ellipse};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};
use tiny_skia::{Path, PathBuilder};

/// A path under construction whose coordinates are taken relative to a point of the raster.
pub(super) struct Outline {
    builder: PathBuilder,
    shift: DVec2,
}

impl Outline {
    /// An empty path; `corner` becomes the origin.
    pub(super) fn new(corner: DVec2) -> Self {
        Outline { builder: PathBuilder::new(), shift: corner }
    }

    fn local(&self, p: DVec2) -> (f32, f32) {
        let p = p - self.shift;
        (p.x as f32, p.y as f32)
    }

    pub(super) fn move_to(&mut self, p: DVec2) {
        let (x, y) = self.local(p);
        self.builder.move_to(x, y);
    }

    pub(super) fn line_to(&mut self, p: DVec2) {
        let (x, y) = self.local(p);
        self.builder.line_to(x, y);
    }

    fn cubic_to(&mut self, b: DVec2, c: DVec2, d: DVec2) {
        let ((bx, by), (cx, cy), (dx, dy)) = (self.local(b), self.local(c), self.local(d));
        self.builder.cubic_to(bx, by, cx, cy, dx, dy);
    }

    pub(super) fn close(&mut self) {
        self.builder.close();
    }

    /// Adds a disc.
    pub(super) fn disc(&mut self, centre: DVec2, radius: f64) {
        let (x, y) = self.local(centre);
        self.builder.push_circle(x, y, radius as f32);
    }

    /// Adds rings.
    pub(super) fn rings(&mut self, rings: Paths<'_, Du>) {
        for ring in rings.iter() {
            if let [first, rest @ ..] = ring {
                self.move_to(*first);
                for &p in rest {
                    self.line_to(p);
                }
                self.close();
            }
        }
    }

    /// Adds a curve.
    pub(super) fn curve(&mut self, curve: &Curve<'_, Du>) {
        match curve {
            Curve::Ellipse(ellipse) => self.ellipse(ellipse),
            Curve::Bezier(points) => {
                if let [first, rest @ ..] = points {
                    self.move_to(*first);
                    for piece in rest.chunks_exact(3) {
                        self.cubic_to(piece[0], piece[1], piece[2]);
                    }
                }
            }
        }
    }

    /// Adds an elliptic arc as cubic curves: the end points and tangents of each piece are those of the arc,
    /// and its middle lies on the arc (M. Goldapp, "Approximation of circular arcs by cubic polynomials",
    /// Computer Aided Geometric Design 8, 1991).
    fn ellipse(&mut self, ellipse: &Ellipse<Du>) {
        let (centre, a, b) = (ellipse.centre.0, ellipse.a.0, ellipse.b.0);
        let full = ellipse.closure == Closure::Full;
        let sweep = if full { TAU.copysign(ellipse.sweep) } else { ellipse.sweep.clamp(-TAU, TAU) };
        // The distance from the arc is 0.00027 radii for a quarter and falls with the sixth power of the angle.
        let radius = (a.length_squared() + b.length_squared()).sqrt();
        let split = (radius * 0.009).powf(1.0 / 6.0).ceil().clamp(1.0, 64.0);
        let count = (sweep.abs() / FRAC_PI_2 * split - 1e-9).ceil().max(1.0);
        let step = sweep / count;
        let reach = 4.0 / 3.0 * (step / 4.0).tan();
        let at = |t: f64| {
            let (sin, cos) = t.sin_cos();
            (centre + a * cos + b * sin, (b * cos - a * sin) * reach)
        };
        let (mut p, mut tangent) = at(ellipse.start);
        self.move_to(p);
        for i in 1..=count as u32 {
            let (q, next) = at(ellipse.start + step * f64::from(i));
            self.cubic_to(p + tangent, q - next, q);
            (p, tangent) = (q, next);
        }
        match ellipse.closure {
            Closure::Open => {}
            Closure::Full | Closure::Chord => self.close(),
            Closure::Pie => {
                self.line_to(centre);
                self.close();
            }
        }
    }

    /// The path, or none if it is empty or a coordinate is not a finite number.
    pub(super) fn finish(self) -> Option<Path> {
        self.builder.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::{Point, Vector};
    use tiny_skia::PathSegment;

    fn arc(radius: f64, start: f64, sweep: f64, closure: Closure) -> Ellipse<Du> {
        Ellipse {
            centre: Point::new(0.0, 0.0),
            a: Vector::new(radius, 0.0),
            b: Vector::new(0.0, radius),
            start,
            sweep,
            closure,
        }
    }

    #[test]
    fn arcs_keep_to_the_circle() {
        for radius in [1.0, 100.0, 5000.0] {
            let mut outline = Outline::new(DVec2::ZERO);
            outline.curve(&Curve::Ellipse(arc(radius, 0.3, -5.0, Closure::Open)));
            let mut last = DVec2::ZERO;
            let v = |p: tiny_skia::Point| DVec2::new(f64::from(p.x), f64::from(p.y));
            for segment in outline.finish().unwrap().segments() {
                match segment {
                    PathSegment::MoveTo(p) => last = v(p),
                    PathSegment::CubicTo(b, c, d) => {
                        for i in 0..=20 {
                            let (t, u) = (f64::from(i) / 20.0, 1.0 - f64::from(i) / 20.0);
                            let at = last * u.powi(3)
                                + v(b) * 3.0 * u * u * t
                                + v(c) * 3.0 * u * t * t
                                + v(d) * t.powi(3);
                            assert!((at.length() - radius).abs() < 0.05, "{radius}: {}", at.length());
                        }
                        last = v(d);
                    }
                    other => panic!("{other:?}"),
                }
            }
            let end = DVec2::from_angle(0.3 - 5.0) * radius;
            assert!((last - end).length() < 1e-3 * radius);
        }
    }

    #[test]
    fn bad_numbers_make_no_path() {
        for radius in [f64::NAN, f64::INFINITY] {
            let mut outline = Outline::new(DVec2::ZERO);
            outline.curve(&Curve::Ellipse(arc(radius, 0.0, 1.0, Closure::Pie)));
            assert!(outline.finish().is_none());
        }
    }
}
