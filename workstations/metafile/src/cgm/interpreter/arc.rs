//! Circles, ellipses and their arcs.

use super::Interpreter;
use super::line::{Outline, ellipse};
use crate::cgm::decoder::Decoder;
use crate::cgm::element::Element;
use crate::generated::elements::Kind;
use gks_algorithms::circle::three_points;
use gks_geometry::Wc;
use gks_pipeline::item::{Closure, Ellipse};
use glam::DVec2;
use std::f64::consts::TAU;

/// What an element draws.
enum Curve {
    Open(Outline),
    Closed(Ellipse<Wc>),
}

impl<D: Decoder> Interpreter<D> {
    pub(super) fn arc(&mut self, e: &Element) -> bool {
        let curve = match e.kind {
            Kind::Circle => circle(e),
            Kind::CircularArc3Point => through(e, Closure::Open),
            Kind::CircularArc3PointClose => through(e, closure(e.integer(3))),
            Kind::CircularArcCentre => around(e, Closure::Open, false),
            Kind::CircularArcCentreReversed => around(e, Closure::Open, true),
            Kind::CircularArcCentreClose => around(e, closure(e.integer(6)), false),
            Kind::Ellipse => elliptical(e, Closure::Full),
            Kind::EllipticalArc => elliptical(e, Closure::Open),
            Kind::EllipticalArcClose => elliptical(e, closure(e.integer(7))),
            _ => return false,
        };
        match curve {
            Some(Curve::Open(outline)) => self.stroke(outline),
            Some(Curve::Closed(ellipse)) => self.fill_ellipse(&ellipse),
            None => self.senseless(e),
        }
        true
    }
}

fn closure(number: Option<i32>) -> Closure {
    if number == Some(1) { Closure::Chord } else { Closure::Pie }
}

fn curve(ellipse: Ellipse<Wc>) -> Curve {
    match ellipse.closure {
        Closure::Open => Curve::Open(Outline::Ellipse(ellipse)),
        _ => Curve::Closed(ellipse),
    }
}

fn circle(e: &Element) -> Option<Curve> {
    let (centre, radius) = (e.point(0)?, e.real(1)?.abs());
    let (a, b) = (DVec2::new(radius, 0.0), DVec2::new(0.0, radius));
    Some(curve(ellipse(centre, a, b, (0.0, TAU), Closure::Full)))
}

fn through(e: &Element, closure: Closure) -> Option<Curve> {
    let (first, between, last) = (e.point(0)?, e.point(1)?, e.point(2)?);
    Some(match three_points(first, between, last) {
        Some(arc) => {
            let (a, b) = (DVec2::new(arc.radius, 0.0), DVec2::new(0.0, arc.radius));
            curve(ellipse(arc.center, a, b, (arc.start, arc.sweep), closure))
        }
        None => Curve::Open(Outline::path([first, between, last])),
    })
}

/// The angle from one direction to another, in positive sense; a whole turn if they are the same.
fn turn(from: DVec2, to: DVec2) -> f64 {
    let angle = (to.to_angle() - from.to_angle()).rem_euclid(TAU);
    if angle == 0.0 { TAU } else { angle }
}

fn around(e: &Element, closure: Closure, reversed: bool) -> Option<Curve> {
    let (centre, start, end, radius) = (e.point(0)?, e.vector(1)?, e.vector(3)?, e.real(5)?.abs());
    if start == DVec2::ZERO || end == DVec2::ZERO {
        return None;
    }
    let sweep = if reversed { -turn(end, start) } else { turn(start, end) };
    let (a, b) = (DVec2::new(radius, 0.0), DVec2::new(0.0, radius));
    Some(curve(ellipse(centre, a, b, (start.to_angle(), sweep), closure)))
}

fn elliptical(e: &Element, closure: Closure) -> Option<Curve> {
    let centre = e.point(0)?;
    let (a, b) = (e.point(1)? - centre, e.point(2)? - centre);
    if closure == Closure::Full {
        return Some(curve(ellipse(centre, a, b, (0.0, TAU), closure)));
    }
    let flat = a.perp_dot(b);
    if flat == 0.0 {
        return None;
    }
    // The direction as a sum of the half diameters.
    let parameter = |direction: DVec2| DVec2::new(direction.perp_dot(b) / flat, a.perp_dot(direction) / flat);
    let (start, end) = (parameter(e.vector(3)?), parameter(e.vector(5)?));
    if !(start.is_finite() && end.is_finite()) {
        return None;
    }
    Some(curve(ellipse(centre, a, b, (start.to_angle(), turn(start, end)), closure)))
}
