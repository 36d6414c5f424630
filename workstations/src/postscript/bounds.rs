//! The bounding box of a page: the smallest rectangle around the ink of its marks.

use crate::arc;
use crate::pdf::sfnt;
use gks_geometry::{Du, LongLine, PathBuf, Paths, Piece, Pieces, Point, Rect};
use gks_pipeline::device::{Form, GlyphRun, Pen};
use gks_pipeline::font::Verb;
use gks_pipeline::item::{Closure, Curve};
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;
use std::convert::Infallible;
use std::fmt;

/// How much longer than the linewidth the tip of a corner may be.
const MITER_LIMIT: f64 = 10.0;

/// Parts into which a Bezier curve is cut to find its ends and corners.
const PARTS: u32 = 16;

/// A part at each end that is short enough to have the direction of the curve there.
const NEAR: f64 = 1e-4;

/// A bounding box that grows with what it is shown.
///
/// It is written as whole numbers, and in the alternate form (`{:#}`) with three decimal places, in points.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub(crate) struct Bounds(Option<Rect<Du>>);

impl Bounds {
    /// Takes in another bounding box.
    pub(crate) fn add(&mut self, other: &Bounds) {
        for corner in other.0.iter().flat_map(|rect| [rect.min, rect.max]) {
            self.point(corner.0);
        }
    }

    /// Takes in a rectangle.
    pub(crate) fn rect(&mut self, rect: &Rect<Du>) {
        self.point(rect.min.0);
        self.point(rect.max.0);
    }

    /// Takes in the ink of a form, as far as it is seen inside of a rectangle.
    pub(crate) fn ink(&mut self, form: &Form<'_>, clip: Option<&Rect<Du>>) {
        let Some(clip) = clip else { return self.form(form) };
        if self.0.is_some_and(|known| known.contains_rect(clip)) {
            return;
        }
        let mut ink = Bounds::default();
        ink.form(form);
        if let Some(seen) = ink.0.and_then(|ink| ink.intersection(clip)) {
            self.rect(&seen);
        }
    }

    fn form(&mut self, form: &Form<'_>) {
        match form {
            Form::Lines(paths, pen) => self.lines(*paths, pen),
            Form::LongLine(line, pen) => self.long_line(line, pen),
            Form::Area(rings, ..) => self.points(rings.points),
            Form::Markers(positions, style) => {
                positions.iter().for_each(|p| self.disc(*p, (style.size + style.width) * 0.5));
            }
            Form::Text(run) => self.text(run),
            Form::Cells(place, _) | Form::IndexedCells(place, ..) => {
                place.corners().iter().for_each(|corner| self.point(corner.0));
            }
            Form::StrokeText(run) => {
                let mut strokes = PathBuf::new();
                run.add_to(&mut strokes);
                self.lines(strokes.as_paths(), &run.pen);
            }
            Form::Stroke(curve, pen) => self.stroke(curve, pen),
            Form::Filled(curve, _) => self.curve(curve),
        }
    }

    #[inline]
    fn point(&mut self, p: DVec2) {
        if !p.is_finite() {
            return;
        }
        let p = Point::from_vec(p);
        self.0 = Some(match self.0 {
            None => Rect { min: p, max: p },
            Some(known) => Rect {
                min: Point::from_vec(known.min.0.min(p.0)),
                max: Point::from_vec(known.max.0.max(p.0)),
            },
        });
    }

    fn points(&mut self, points: &[DVec2]) {
        let Some(&first) = points.first() else { return };
        let (low, high) = points.iter().fold((first, first), |(low, high), p| (low.min(*p), high.max(*p)));
        if low.is_finite() && high.is_finite() {
            self.point(low);
            self.point(high);
        } else {
            points.iter().for_each(|p| self.point(*p));
        }
    }

    fn disc(&mut self, centre: DVec2, radius: f64) {
        self.point(centre - DVec2::splat(radius));
        self.point(centre + DVec2::splat(radius));
    }

    /// Takes in lines with their ends and corners.
    ///
    /// The points themselves are taken in first. What is drawn around a point reaches only so far that most
    /// points, well inside of the box by then, need not be looked at.
    fn lines(&mut self, paths: Paths<'_, Du>, pen: &Pen<'_>) {
        self.points(paths.points);
        for path in paths.iter() {
            self.path(path, pen);
        }
    }

    /// Takes in a long line: pieces overlap by two points, so that every corner is in one of them, and what is
    /// at the ends of the line comes in addition.
    fn long_line(&mut self, line: &LongLine<'_, Du>, pen: &Pen<'_>) {
        if let Some(bounds) = line.bounds() {
            self.rect(&bounds);
        }
        let half = pen.width.max(0.0) * 0.5;
        let inner = Pen { cap: Cap::Butt, ..*pen };
        let direction = |from: DVec2, to: &mut dyn Iterator<Item = &DVec2>| {
            to.map(|q| *q - from).find_map(DVec2::try_normalize)
        };
        let mut held: Vec<DVec2> = Vec::new();
        let mut start = (DVec2::ZERO, None);
        let done = line.pieces::<Infallible>(|Piece { points, starts, ends }| {
            let kept = if starts { 0 } else { held.len().min(2) };
            held.drain(..held.len() - kept);
            held.extend_from_slice(points);
            self.path(&held, &inner);
            if starts {
                start = (held[0], direction(held[0], &mut held.iter()));
            }
            if ends {
                let last = held[held.len() - 1];
                match (start, direction(last, &mut held.iter().rev())) {
                    ((first, Some(along)), Some(back)) if first == last => {
                        self.corner(last, -back, along, pen.join, half);
                    }
                    ((first, along), back) => {
                        along.iter().for_each(|along| self.end(first, -*along, pen.cap, half));
                        back.iter().for_each(|back| self.end(last, -*back, pen.cap, half));
                    }
                }
            }
            Ok(())
        });
        let Ok(()) = done;
    }

    fn path(&mut self, path: &[DVec2], pen: &Pen<'_>) {
        let half = pen.width.max(0.0) * 0.5;
        let reach = half * if pen.join == Join::Miter { MITER_LIMIT } else { std::f64::consts::SQRT_2 };
        let mut known = None;
        let mut safe = None;
        let closed = path.len() > 3 && path.first() == path.last();
        let path = if closed { &path[1..] } else { path };
        for (i, &p) in path.iter().enumerate() {
            if known != self.0 {
                known = self.0;
                safe = known.map(|known| known.grown(-reach));
            }
            let inside = safe.is_some_and(|safe| safe.contains(Point::from_vec(p)));
            if inside || (i > 0 && path[i - 1] == p) {
                continue;
            }
            let around = if closed { path } else { &[] };
            let earlier = path[..i].iter().rev().chain(around.iter().rev());
            let later = path[i + 1..].iter().chain(around);
            let before = earlier.map(|q| p - *q).find_map(DVec2::try_normalize);
            let after = later.map(|q| *q - p).find_map(DVec2::try_normalize);
            for along in before.iter().chain(&after) {
                self.point(p + along.perp() * half);
                self.point(p - along.perp() * half);
            }
            match (before, after) {
                (Some(before), Some(after)) => self.corner(p, before, after, pen.join, half),
                (Some(outwards), None) => self.end(p, outwards, pen.cap, half),
                (None, Some(inwards)) => self.end(p, -inwards, pen.cap, half),
                (None, None) => self.disc(p, half),
            }
        }
    }

    /// Takes in the end of a line.
    fn end(&mut self, at: DVec2, outwards: DVec2, cap: Cap, half: f64) {
        match cap {
            Cap::Butt => {}
            Cap::Round => self.disc(at, half),
            Cap::Projecting => {
                self.point(at + (outwards + outwards.perp()) * half);
                self.point(at + (outwards - outwards.perp()) * half);
            }
        }
    }

    /// Takes in the corner between two directions.
    fn corner(&mut self, at: DVec2, before: DVec2, along: DVec2, join: Join, half: f64) {
        match join {
            Join::Bevel => {}
            Join::Round => self.disc(at, half),
            Join::Miter => {
                // The tip lies on the bisector, at the distance of half / sin(angle / 2).
                let Some(outwards) = (before - along).try_normalize() else { return };
                let sine = outwards.dot(before.perp()).abs();
                if sine * MITER_LIMIT >= 1.0 {
                    self.point(at + outwards * (half / sine));
                }
            }
        }
    }

    /// Takes in a curve drawn with a pen: the sides where the curve turns, ends and corners as of a polygon.
    fn stroke(&mut self, curve: &Curve<'_, Du>, pen: &Pen<'_>) {
        let half = pen.width.max(0.0) * 0.5;
        let mut line = Vec::new();
        cubics(curve, |[a, b, c, d]| {
            self.turns([a, b, c, d], half);
            if line.is_empty() {
                line.push(a);
            }
            let inner = (1..PARTS).map(|i| f64::from(i) / f64::from(PARTS));
            let parts = [NEAR].into_iter().chain(inner).chain([1.0 - NEAR, 1.0]);
            line.extend(parts.map(|t| at([a, b, c, d], t)));
        });
        if let (Curve::Ellipse(ellipse), Some(&first)) = (curve, line.first()) {
            if ellipse.closure == Closure::Pie {
                line.push(ellipse.centre.0);
            }
            if ellipse.closure != Closure::Open {
                line.push(first);
            }
        }
        self.path(&line, pen);
    }

    /// Takes in the area that a curve encloses.
    fn curve(&mut self, curve: &Curve<'_, Du>) {
        cubics(curve, |cubic| self.cubic(cubic));
        if let Curve::Ellipse(ellipse) = curve
            && ellipse.closure == Closure::Pie
        {
            self.point(ellipse.centre.0);
        }
    }

    fn cubic(&mut self, cubic: [DVec2; 4]) {
        self.point(cubic[0]);
        self.point(cubic[3]);
        self.turns(cubic, 0.0);
    }

    /// Takes in the places where a cubic turns back in x or in y, with a margin.
    fn turns(&mut self, cubic: [DVec2; 4], margin: f64) {
        let [a, b, c, d] = cubic;
        for axis in [DVec2::X, DVec2::Y] {
            let [p, q, r] = [b - a, c - b, d - c].map(|edge| edge.dot(axis));
            // The derivative p (1-t)^2 + 2 q t (1-t) + r t^2 as a polynomial.
            let (square, linear) = (p - 2.0 * q + r, 2.0 * (q - p));
            let root = (linear * linear - 4.0 * square * p).sqrt();
            let flat = if square.abs() < 1e-12 { -p / linear } else { f64::NAN };
            for t in [(-linear + root) / (2.0 * square), (-linear - root) / (2.0 * square), flat] {
                if t > 0.0 && t < 1.0 {
                    self.disc(at(cubic, t), margin);
                }
            }
        }
    }

    fn text(&mut self, run: &GlyphRun<'_>) {
        let [left, bottom, right, top] = sfnt::bounds(run.face);
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top)].map(DVec2::from);
        for glyph in run.glyphs {
            let place = |p: DVec2| glyph.origin.0 + run.x.0 * p.x + run.y.0 * p.y;
            let inside = |known: Rect<Du>| corners.iter().all(|p| known.contains(Point::from_vec(place(*p))));
            if self.0.is_some_and(inside) {
                continue;
            }
            let mut last = DVec2::ZERO;
            for verb in &run.face.outline(glyph.id).verbs {
                let cubic = match *verb {
                    Verb::Move(p) | Verb::Line(p) => [p; 4],
                    Verb::Quad(a, p) => [last, last.lerp(a, 2.0 / 3.0), p.lerp(a, 2.0 / 3.0), p],
                    Verb::Cubic(a, b, p) => [last, a, b, p],
                    Verb::Close => continue,
                };
                self.cubic(cubic.map(place));
                last = cubic[3];
            }
        }
    }
}

fn at([a, b, c, d]: [DVec2; 4], t: f64) -> DVec2 {
    let s = 1.0 - t;
    a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
}

/// Calls `take` with each cubic of a curve.
fn cubics(curve: &Curve<'_, Du>, mut take: impl FnMut([DVec2; 4])) {
    match curve {
        Curve::Bezier(points) => {
            for i in (3..points.len()).step_by(3) {
                take([points[i - 3], points[i - 2], points[i - 1], points[i]]);
            }
        }
        Curve::Ellipse(ellipse) => {
            let mut start = ellipse.at(ellipse.start).0;
            for [b, c, d] in arc::cubics(ellipse, 0.005) {
                take([start, b, c, d]);
                start = d;
            }
        }
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(rect) = self.0 else { return f.write_str("0 0 0 0") };
        let (min, max) = (rect.min.0, rect.max.0);
        if f.alternate() {
            write!(f, "{:.3} {:.3} {:.3} {:.3}", min.x, min.y, max.x, max.y)
        } else {
            // What lies a rounding error beyond a whole number is on it.
            let (min, max) = ((min + 1e-6).floor(), (max - 1e-6).ceil());
            write!(f, "{:.0} {:.0} {:.0} {:.0}", min.x, min.y, max.x, max.y)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::colour::{Colour, Paint};

    fn pen(width: f64, cap: Cap, join: Join) -> Pen<'static> {
        Pen { paint: Paint { colour: Colour::BLACK, index: 1 }, width, dash: &[], cap, join }
    }

    fn of(points: &[(f64, f64)], pen: Pen<'static>, clip: Option<Rect<Du>>) -> String {
        let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
        let mut bounds = Bounds::default();
        let ends = [points.len() as u32];
        let form = Form::Lines(Paths::new(&points, &ends), pen);
        bounds.ink(&form, clip.as_ref());
        format!("{bounds:#}")
    }

    #[test]
    fn ends_and_corners_count() {
        let level = [(10.0, 10.0), (30.0, 10.0)];
        assert_eq!(of(&level, pen(4.0, Cap::Butt, Join::Miter), None), "10.000 8.000 30.000 12.000");
        assert_eq!(of(&level, pen(4.0, Cap::Round, Join::Miter), None), "8.000 8.000 32.000 12.000");
        assert_eq!(of(&level, pen(4.0, Cap::Projecting, Join::Miter), None), "8.000 8.000 32.000 12.000");
        assert_eq!(of(&level[..1], pen(4.0, Cap::Butt, Join::Miter), None), "8.000 8.000 12.000 12.000");
        let square = [(10.0, 10.0), (30.0, 10.0), (30.0, 30.0), (10.0, 30.0), (10.0, 10.0)];
        assert_eq!(of(&square, pen(4.0, Cap::Butt, Join::Miter), None), "8.000 8.000 32.000 32.000");
        assert_eq!(of(&square[..4], pen(4.0, Cap::Butt, Join::Miter), None), "10.000 8.000 32.000 32.000");
        // 60 degrees at the tip: half / sin(30) = width.
        let tip = [(10.0, 10.0), (20.0, 10.0 + 300_f64.sqrt()), (30.0, 10.0)];
        assert!(of(&tip, pen(6.0, Cap::Butt, Join::Miter), None).ends_with(" 33.321"));
        assert!(of(&tip, pen(6.0, Cap::Butt, Join::Round), None).ends_with(" 30.321"));
        assert!(of(&tip, pen(6.0, Cap::Butt, Join::Bevel), None).ends_with(" 28.821"));
        let needle = [(0.0, 0.0), (100.0, 1.0), (0.0, 2.0)];
        assert_eq!(of(&needle, pen(2.0, Cap::Butt, Join::Miter), None).split(' ').nth(2), Some("100.010"));
    }

    #[test]
    fn clipping_cuts_and_whole_numbers_surround() {
        let level = [(10.0, 10.0), (30.0, 10.0)];
        let clip = Some(Rect::new(15.5, 18.0, 9.25, 50.0));
        assert_eq!(of(&level, pen(4.0, Cap::Butt, Join::Miter), clip), "15.500 9.250 18.000 12.000");
        let hidden = Some(Rect::new(0.0, 5.0, 0.0, 5.0));
        assert_eq!(of(&level, pen(4.0, Cap::Butt, Join::Miter), hidden), "0 0 0 0");
        let mut bounds = Bounds::default();
        bounds.rect(&Rect::new(-0.5, 10.2, 3.000_000_01, 4.999));
        bounds.add(&Bounds::default());
        assert_eq!(bounds.to_string(), "-1 3 11 5");
        assert_eq!(
            of(&[(f64::NAN, 0.0), (1.0, f64::INFINITY)], pen(1.0, Cap::Butt, Join::Miter), None),
            "0 0 0 0"
        );
    }

    #[test]
    fn cubics_reach_as_far_as_they_turn() {
        let mut bounds = Bounds::default();
        let arch = [(0.0, 0.0), (0.0, 40.0), (30.0, 40.0), (30.0, 0.0)].map(|(x, y)| DVec2::new(x, y));
        bounds.ink(&Form::Filled(Curve::Bezier(&arch), pen(1.0, Cap::Butt, Join::Bevel).paint), None);
        assert_eq!(format!("{bounds:#}"), "0.000 0.000 30.000 30.000");
    }
}
