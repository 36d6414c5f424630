//! Curved generalized drawing primitives: circles, ellipses and their arcs as elements of their own.

use super::CgmRecorder;
use crate::cgm::element::Value;
use crate::generated::elements::Kind;
use gks_algorithms::{curve, ellipse};
use gks_geometry::{Ndc, PathBuf};
use gks_pipeline::item::{Closure, Curve, Ellipse, Role};
use gks_pipeline::look::Look;
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// How far chords may be from curves, in NDC.
const TOLERANCE: f64 = 1e-5;

impl CgmRecorder {
    pub(super) fn curve(&mut self, shape: &Curve<'_, Ndc>, role: Role, look: &Look) {
        match (shape, role) {
            _ if self.settings.plain => self.chords(shape, role, look),
            (Curve::Ellipse(e), Role::Line) if e.closure == Closure::Open && is_sound(e) => {
                self.set_line(look);
                self.ellipse(e);
            }
            (Curve::Ellipse(e), Role::Area) if e.closure != Closure::Open && is_sound(e) => {
                self.set_fill(look);
                self.ellipse(e);
            }
            (Curve::Bezier(points), Role::Line) if self.settings.version >= 3 => {
                self.set_line(look);
                let points = points.iter().map(|&p| self.coordinates(p)).collect();
                self.put(Kind::Polybezier, [Value::Integer(2), Value::Points(points)]);
            }
            (Curve::Bezier(points), Role::Area) if self.settings.version >= 3 => {
                self.set_fill(look);
                let points = points.iter().map(|&p| self.coordinates(p)).collect();
                self.put(Kind::BeginFigure, []);
                self.put(Kind::Polybezier, [Value::Integer(2), Value::Points(points)]);
                self.put(Kind::EndFigure, []);
            }
            _ => self.chords(shape, role, look),
        }
    }

    fn chords(&mut self, shape: &Curve<'_, Ndc>, role: Role, look: &Look) {
        let path = flattened(shape);
        match role {
            Role::Line => self.lines(path.as_paths(), look),
            Role::Area => self.area(path.as_paths(), look),
        }
    }

    fn ellipse(&mut self, e: &Ellipse<Ndc>) {
        let (centre, a, b) = (e.centre.0, e.a.0, e.b.0);
        let at = |t: f64| a * t.cos() + b * t.sin();
        let (start, end) = (at(e.start), at(e.start + e.sweep));
        // Elements go from the first half diameter towards the second, whole ellipses all around from the first.
        let (a, b) = if e.closure == Closure::Full { (start, at(e.start + FRAC_PI_2)) } else { (a, b) };
        let b = if e.sweep < 0.0 { -b } else { b };
        let mut circular = (a.length() - b.length()).abs() <= 1e-9 * a.length()
            && a.dot(b).abs() <= 1e-9 * a.length_squared()
            && a.perp_dot(b) > 0.0;
        if self.grid.real && e.closure == Closure::Full {
            // Circles begin on the right: where nothing is to be lost, others are ellipses.
            circular &= a.y == 0.0 && a.x > 0.0;
        }
        let mut values = vec![Value::Point(self.coordinates(centre))];
        if !circular {
            values.extend([a, b].map(|half| Value::Point(self.coordinates(centre + half))));
        }
        if e.closure != Closure::Full {
            values.extend(self.directions([start, end]));
        }
        if circular {
            values.push(Value::Real(self.rounded(DVec2::splat(a.length() * self.scale)).x));
        }
        match e.closure {
            Closure::Pie => values.push(Value::Integer(0)),
            Closure::Chord => values.push(Value::Integer(1)),
            Closure::Full | Closure::Open => {}
        }
        let kind = match (e.closure, circular) {
            (Closure::Full, true) => Kind::Circle,
            (Closure::Full, false) => Kind::Ellipse,
            (Closure::Open, true) => Kind::CircularArcCentre,
            (Closure::Open, false) => Kind::EllipticalArc,
            (_, true) => Kind::CircularArcCentreClose,
            (_, false) => Kind::EllipticalArcClose,
        };
        self.put(kind, values);
    }
}

/// Whether an ellipse is one: neither flat nor a whole turn that is no full ellipse.
fn is_sound(e: &Ellipse<Ndc>) -> bool {
    let area = e.a.0.perp_dot(e.b.0).abs();
    area > 1e-12 && (e.closure == Closure::Full || e.sweep.abs() < TAU - 1e-3)
}

/// A curve as a path, completed as it says.
fn flattened(shape: &Curve<'_, Ndc>) -> PathBuf<Ndc> {
    let mut path = PathBuf::new();
    match shape {
        Curve::Bezier(points) => curve::chain(points, TOLERANCE, &mut path.points),
        Curve::Ellipse(e) => {
            ellipse::flatten(e.centre.0, e.a.0, e.b.0, e.start, e.sweep, TOLERANCE, &mut path.points);
            let closing: &[DVec2] = match e.closure {
                Closure::Full | Closure::Open => &[],
                Closure::Chord => &[e.at(e.start).0],
                Closure::Pie => &[e.centre.0, e.at(e.start).0],
            };
            path.points.extend_from_slice(closing);
        }
    }
    path.end();
    path
}
