//! Curves as generalized drawing primitives, and back.
//!
//! The points are those of the primitive's definition, so that other readers can draw it. They leave the last
//! bits of the curve open; the data record has them.

use super::encode::packed;
use crate::generalized::ellipse;
use crate::generated::numbers::gdp;
use crate::item::{Closure, Curve, Ellipse, Role};
use gks_geometry::{Ndc, Point, Vector};
use glam::DVec2;
use std::f64::consts::TAU;

/// A generalized drawing primitive.
pub(super) struct Gdp {
    pub(super) id: i32,
    pub(super) points: Vec<DVec2>,
    /// The data record, as text.
    pub(super) data: String,
}

impl Gdp {
    /// The primitive that a curve is.
    pub(super) fn of(curve: &Curve<'_, Ndc>, role: Role) -> Gdp {
        match (curve, role) {
            (Curve::Bezier(control), Role::Line) => {
                Gdp { id: gdp::BEZIER_CHAIN, points: control.to_vec(), data: String::new() }
            }
            (Curve::Bezier(control), Role::Area) => {
                let on_curve = control.iter().copied().step_by(3);
                let points = on_curve.take((control.len() / 3).max(1)).collect();
                let reals: Vec<f64> = control.iter().flat_map(|p| [p.x, p.y]).collect();
                Gdp { id: gdp::CLOSED_SPLINE, points, data: packed(&[], &reals) }
            }
            (Curve::Ellipse(e), role) => Gdp::of_ellipse(e, role),
        }
    }

    fn of_ellipse(e: &Ellipse<Ndc>, role: Role) -> Gdp {
        // Other readers turn from the first axis to the second.
        let forth = if e.sweep < 0.0 {
            Ellipse { b: e.b * -1.0, start: -e.start, sweep: -e.sweep, ..*e }
        } else {
            *e
        };
        let (c, a, b) = (forth.centre, forth.a, forth.b);
        let axes = [c.0, (c + a).0, (c + b).0];
        let rays = [forth.at(forth.start).0, forth.at(forth.start + forth.sweep).0];
        let id = match (e.closure, role) {
            (Closure::Full, Role::Area) => gdp::ELLIPSE,
            (_, Role::Line) => gdp::ELLIPTIC_ARC,
            (Closure::Pie, Role::Area) => gdp::ELLIPTIC_PIE,
            (Closure::Open | Closure::Chord, Role::Area) => gdp::ELLIPTIC_CHORD,
        };
        let mut points = axes.to_vec();
        if id != gdp::ELLIPSE {
            points.extend(rays);
        }
        let exact = [e.centre.0.x, e.centre.0.y, e.a.0.x, e.a.0.y, e.b.0.x, e.b.0.y, e.start, e.sweep];
        Gdp { id, points, data: packed(&[closure_number(e.closure)], &exact) }
    }
}

const CLOSURES: [Closure; 4] = [Closure::Full, Closure::Open, Closure::Chord, Closure::Pie];

fn closure_number(closure: Closure) -> i32 {
    CLOSURES.iter().position(|&c| c == closure).map_or(0, |at| at as i32)
}

/// What a generalized drawing primitive draws.
pub(super) enum Drawn {
    Ellipse(Ellipse<Ndc>, Role),
    /// The points are the control points of a chain of Bezier curves.
    Bezier(Role),
    /// The points determine no curve and are joined.
    Polygon(Role),
}

/// What a primitive draws; `points` may be replaced. None where there is no such primitive here.
pub(super) fn drawn(id: i32, points: &mut Vec<DVec2>, data: &[u8]) -> Option<Drawn> {
    let role = crate::generalized::role(id)?;
    match id {
        gdp::BEZIER_CHAIN if points.len() >= 4 && points.len() % 3 == 1 => return Some(Drawn::Bezier(role)),
        gdp::BEZIER_CHAIN => return Some(Drawn::Polygon(role)),
        gdp::SPLINE | gdp::CLOSED_SPLINE => {
            let control = match unpacked(data) {
                Some((integers, reals))
                    if integers.is_empty() && reals.len() >= 8 && reals.len() % 6 == 2 =>
                {
                    reals.chunks_exact(2).map(|p| DVec2::new(p[0], p[1])).collect()
                }
                _ => crate::generalized::spline(points, id == gdp::CLOSED_SPLINE),
            };
            if control.len() < 4 {
                return Some(Drawn::Polygon(role));
            }
            *points = control;
            return Some(Drawn::Bezier(role));
        }
        _ => {}
    }
    let exact = unpacked(data).and_then(|(integers, reals)| exact(&integers, &reals));
    Some(match exact.or_else(|| ellipse(id, points)) {
        Some(ellipse) => Drawn::Ellipse(ellipse, role),
        None => Drawn::Polygon(role),
    })
}

fn exact(integers: &[i32], reals: &[f64]) -> Option<Ellipse<Ndc>> {
    let closure = *CLOSURES.get(usize::try_from(*integers.first()?).ok()?)?;
    let &[cx, cy, ax, ay, bx, by, start, sweep] = reals else { return None };
    (sweep.abs() <= TAU).then_some(Ellipse {
        centre: Point::new(cx, cy),
        a: Vector::new(ax, ay),
        b: Vector::new(bx, by),
        start,
        sweep,
        closure,
    })
}

/// The integers and finite reals of a data record without strings as PACK DATA RECORD writes it.
pub(super) fn unpacked(data: &[u8]) -> Option<(Vec<i32>, Vec<f64>)> {
    let mut words = str::from_utf8(data).ok()?.split_ascii_whitespace();
    if words.next()? != "GKSDR1" {
        return None;
    }
    let mut count = || words.next()?.parse::<usize>().ok();
    let [integers, reals, strings] = [count()?, count()?, count()?];
    let integers = (0..integers).map(|_| words.next()?.parse().ok()).collect::<Option<Vec<i32>>>()?;
    let real = |word: &str| match word.strip_suffix('s') {
        Some(single) => single.parse::<f32>().ok().map(f64::from),
        None => word.parse::<f64>().ok(),
    };
    let reals = (0..reals).map(|_| real(words.next()?).filter(|r| r.is_finite())).collect::<Option<_>>()?;
    (strings == 0).then_some((integers, reals))
}
