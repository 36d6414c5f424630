//! Bezier curves, B-splines and conic arcs.

use super::Interpreter;
use super::line::Outline;
use crate::cgm::decoder::Decoder;
use crate::cgm::element::Element;
use crate::generated::elements::Kind;
use glam::{DVec2, DVec3};

/// How many chords a span of a spline or a hyperbola gets.
const CHORDS: usize = 32;

impl<D: Decoder> Interpreter<D> {
    pub(super) fn spline(&mut self, e: &Element) -> bool {
        match e.kind {
            Kind::Polybezier => self.polybezier(e),
            Kind::NonUniformBSpline | Kind::NonUniformRationalBSpline => match b_spline(e) {
                Some(points) => self.stroke(Outline::path(points)),
                None => self.senseless(e),
            },
            Kind::ParabolicArc => match parabola(e) {
                Some(points) => self.stroke(Outline::Bezier(points)),
                None => self.senseless(e),
            },
            Kind::HyperbolicArc => match hyperbola(e) {
                Some(points) => self.stroke(Outline::path(points)),
                None => self.senseless(e),
            },
            _ => return false,
        }
        true
    }

    fn polybezier(&mut self, e: &Element) {
        let points = e.points(1).unwrap_or_default();
        if e.integer(0) == Some(2) {
            let count = points.len().saturating_sub(1) / 3;
            if count > 0 {
                self.stroke(Outline::Bezier(points[..=3 * count].to_vec()));
            }
        } else {
            for curve in points.chunks_exact(4) {
                self.stroke(Outline::Bezier(curve.to_vec()));
            }
        }
    }
}

/// The cubic form of the quadratic curve whose tangents at both ends meet in the first point.
fn parabola(e: &Element) -> Option<Vec<DVec2>> {
    let (tangents, start, end) = (e.point(0)?, e.point(1)?, e.point(2)?);
    Some(vec![start, start.lerp(tangents, 2.0 / 3.0), end.lerp(tangents, 2.0 / 3.0), end])
}

/// `centre + a cosh t + b sinh t` between the directions of the start and the end vector.
fn hyperbola(e: &Element) -> Option<Vec<DVec2>> {
    let centre = e.point(0)?;
    let (a, b) = (e.point(1)? - centre, e.point(2)? - centre);
    let flat = a.perp_dot(b);
    let parameter = |direction: DVec2| {
        let along = direction.perp_dot(b) / flat;
        let across = a.perp_dot(direction) / flat;
        Some((across / along).atanh()).filter(|t| t.is_finite())
    };
    let (start, end) = (parameter(e.vector(3)?)?, parameter(e.vector(5)?)?);
    let at = |i: usize| {
        let t = start + (end - start) * i as f64 / CHORDS as f64;
        centre + a * t.cosh() + b * t.sinh()
    };
    Some((0..=CHORDS).map(at).collect())
}

/// The points of a B-spline: de Boor, "On calculating with B-splines", 1972.
fn b_spline(e: &Element) -> Option<Vec<DVec2>> {
    let order = usize::try_from(e.integer(0)?).ok().filter(|order| (2..=16).contains(order))?;
    let points = e.points(1)?;
    let reals: Option<Vec<f64>> = (2..e.values.len()).map(|place| e.real(place)).collect();
    let reals = reals?;
    let (knots, rest) = reals.split_at_checked(order + points.len())?;
    let [start, end, weights @ ..] = rest else { return None };
    let weight = |i: usize| weights.get(i).copied().unwrap_or(1.0);
    let control: Vec<DVec3> =
        points.iter().enumerate().map(|(i, p)| (*p * weight(i)).extend(weight(i))).collect();
    if control.len() < order || knots.windows(2).any(|pair| pair[0] > pair[1]) {
        return None;
    }
    let mut out = Vec::new();
    for span in order - 1..control.len() {
        let (low, high) = (knots[span].max(*start), knots[span + 1].min(*end));
        if low >= high {
            continue;
        }
        for i in 0..=CHORDS {
            let t = low + (high - low) * i as f64 / CHORDS as f64;
            let point = de_boor(&control, knots, order, span, t);
            out.push(point.truncate() / point.z);
        }
    }
    (out.len() > 1).then_some(out)
}

fn de_boor(control: &[DVec3], knots: &[f64], order: usize, span: usize, t: f64) -> DVec3 {
    let degree = order - 1;
    let mut d: Vec<DVec3> = control[span - degree..=span].to_vec();
    for r in 1..=degree {
        for j in (r..=degree).rev() {
            let i = span - degree + j;
            let range = knots[i + order - r] - knots[i];
            let share = if range > 0.0 { (t - knots[i]) / range } else { 0.0 };
            d[j] = d[j - 1].lerp(d[j], share);
        }
    }
    d[degree]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cgm::element::Value;

    #[test]
    fn a_spline_over_bezier_knots_is_the_bezier_curve() {
        let points = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)].map(DVec2::from).to_vec();
        let mut values = vec![Value::Integer(4), Value::Points(points)];
        values.extend([0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0].map(Value::Real));
        let spline = b_spline(&Element::new(Kind::NonUniformBSpline, values)).unwrap();
        assert_eq!((spline[0], spline[CHORDS]), (DVec2::ZERO, DVec2::X));
        assert!((spline[CHORDS / 2] - DVec2::new(0.5, 0.75)).length() < 1e-12);
    }
}
