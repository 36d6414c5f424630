//! Which curves generalized drawing primitives are: what their points mean.

use crate::generated::numbers::{GDPS, GdpAttributes, gdp};
use crate::item::{Closure, Ellipse, Role};
use gks_algorithms::circle::three_points;
use gks_algorithms::curve::NaturalSpline;
use gks_geometry::{Point, Space, Vector};
use glam::DVec2;
use std::f64::consts::TAU;

/// Half axes are parallel if they enclose less than this part of the rectangle they could.
const PARALLEL: f64 = 1e-12;

/// Which attributes a primitive uses, if there is one with this identifier.
pub fn role(id: i32) -> Option<Role> {
    let kind = GDPS.iter().find(|kind| kind.number == id)?;
    Some(match kind.attributes {
        GdpAttributes::Polyline => Role::Line,
        GdpAttributes::FillArea => Role::Area,
    })
}

/// The control points of the Bezier curves that make the natural spline through points.
pub fn spline(points: &[DVec2], closed: bool) -> Vec<DVec2> {
    let mut control = Vec::new();
    NaturalSpline::new().pieces(points, closed, &mut control);
    control
}

/// The ellipse, or the part of one, that points determine; none if they determine none.
pub fn ellipse<S: Space>(id: i32, points: &[DVec2]) -> Option<Ellipse<S>> {
    let closure = match id {
        gdp::CIRCULAR_ARC | gdp::ELLIPTIC_ARC => Closure::Open,
        gdp::CIRCULAR_CHORD | gdp::ELLIPTIC_CHORD => Closure::Chord,
        gdp::CIRCULAR_PIE | gdp::ELLIPTIC_PIE => Closure::Pie,
        _ => Closure::Full,
    };
    let part = |centre: DVec2, a: DVec2, b: DVec2, start: f64, sweep: f64| Ellipse {
        centre: Point::from_vec(centre),
        a: Vector::from_vec(a),
        b: Vector::from_vec(b),
        start,
        sweep,
        closure,
    };
    match (id, points) {
        (gdp::CIRCLE, &[edge, centre]) => {
            let radius = edge.distance(centre);
            let (a, b) = (DVec2::new(radius, 0.0), DVec2::new(0.0, radius));
            (radius > 0.0).then(|| part(centre, a, b, 0.0, TAU))
        }
        (_, &[centre, first, second]) if id == gdp::ELLIPSE => {
            let (a, b) = half_axes(centre, first, second)?;
            Some(part(centre, a, b, 0.0, TAU))
        }
        (_, &[start, middle, end]) => {
            let arc = three_points(start, middle, end)?;
            let (a, b) = (DVec2::new(arc.radius, 0.0), DVec2::new(0.0, arc.radius));
            Some(part(arc.center, a, b, arc.start, arc.sweep))
        }
        (_, &[centre, first, second, start, end]) => {
            let (a, b) = half_axes(centre, first, second)?;
            let [start, end] = [direction(start - centre, a, b)?, direction(end - centre, a, b)?];
            // Equal rays, up to rounding, leave the whole ellipse between them.
            let sweep = (end - start).rem_euclid(TAU);
            Some(part(centre, a, b, start, if sweep < 1e-12 { TAU } else { sweep }))
        }
        _ => None,
    }
}

/// The half axes from a centre to two points, unless they are parallel.
fn half_axes(centre: DVec2, first: DVec2, second: DVec2) -> Option<(DVec2, DVec2)> {
    let (a, b) = (first - centre, second - centre);
    (a.perp_dot(b).abs() > PARALLEL * a.length() * b.length()).then_some((a, b))
}

/// The parameter of the point where the ray along `d` leaves the ellipse with half axes `a` and `b`; none
/// if `d` has no length.
fn direction(d: DVec2, a: DVec2, b: DVec2) -> Option<f64> {
    // The components of d along a and b, both times the same positive number.
    let sign = a.perp_dot(b).signum();
    let (along_a, along_b) = (d.perp_dot(b) * sign, a.perp_dot(d) * sign);
    (along_a != 0.0 || along_b != 0.0).then(|| along_b.atan2(along_a))
}
