//! Wide lines on devices that draw with a pen: strokes side by side, a little less than a pen width apart.
//!
//! A stroke follows the path at a fixed distance to its left, segment by segment. At a corner it goes from one
//! segment to the next within the disc around the corner that has this distance as its radius, so that it
//! never leaves the line it is to fill, however sharp the corner and however short the segments are.

use crate::device::{DeviceError, Pen};
use crate::look::{Cap, Join};
use crate::painter::{Canvas, Painter};
use gks_geometry::{Du, PathBuf, Paths, Rect};
use glam::DVec2;
use std::f64::consts::PI;

/// Lines up to this many pen widths are drawn with one stroke.
pub(crate) const SINGLE: f64 = 1.5;
/// The largest distance between strokes in pen widths: where positions are rounded, no gap may open.
const SPACING: f64 = 0.9;
/// Corners are continued until the sides meet if that is within this many linewidths, else bevelled.
const MITER_LIMIT: f64 = 10.0;
/// Points collected before they are drawn.
const CHUNK: usize = 1 << 16;

/// Draws lines that are wider than the tip of the pen.
pub(crate) fn draw(
    painter: &mut Painter,
    paths: Paths<'_, Du>,
    pen: &Pen<'_>,
    tip: f64,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let thin = Pen { width: tip, ..*pen };
    let tolerance = canvas.tolerance();
    let mut strokes = std::mem::take(&mut painter.strokes);
    let mut segments = Vec::new();
    let mut done = Ok(());
    for path in paths.iter() {
        let closed = segments_of(path, &mut segments);
        // A path that goes nowhere is a dot.
        let dot = path.iter().all(|p| *p == path[0]);
        let cap = if dot { Cap::Round } else { pen.cap };
        let line = Line { segments: &segments, closed, cap, join: pen.join, tolerance };
        for (i, offset) in offsets(pen.width, tip).enumerate() {
            let stroke = Stroke { offset, outermost: (pen.width - tip) * 0.5, number: i };
            line.add(&stroke, &mut strokes);
            if strokes.points.len() >= CHUNK && done.is_ok() {
                done = painter.lines(strokes.as_paths(), &thin, clip, canvas);
                strokes.clear();
            }
        }
    }
    if done.is_ok() {
        done = painter.lines(strokes.as_paths(), &thin, clip, canvas);
    }
    strokes.clear();
    painter.strokes = strokes;
    done
}

/// The distances of the strokes from the path: the outermost leave half a tip to the edges of the line.
fn offsets(width: f64, tip: f64) -> impl Iterator<Item = f64> {
    let gaps = ((width / tip - 1.0) / SPACING - 1e-9).ceil().clamp(1.0, 10_000.0);
    let outermost = (width - tip) * 0.5;
    (0..=gaps as u32).map(move |i| outermost * (2.0 * f64::from(i) / gaps - 1.0))
}

/// A straight piece of a path.
#[derive(Copy, Clone, Debug, PartialEq)]
struct Segment {
    start: DVec2,
    end: DVec2,
    /// The unit vector from start to end.
    along: DVec2,
}

/// The segments of a path without those of no length, one of no length for a dot; and whether the path
/// ends where it begins.
fn segments_of(path: &[DVec2], segments: &mut Vec<Segment>) -> bool {
    segments.clear();
    for pair in path.windows(2) {
        let (start, end) = (pair[0], pair[1]);
        if let Some(along) = (end - start).try_normalize() {
            segments.push(Segment { start, end, along });
        }
    }
    if let (true, Some(&p)) = (segments.is_empty(), path.first()) {
        segments.push(Segment { start: p, end: p, along: DVec2::X });
    }
    segments.len() > 1 && path.first() == path.last()
}

/// A line to be filled with strokes.
#[derive(Copy, Clone, Debug)]
struct Line<'a> {
    segments: &'a [Segment],
    closed: bool,
    cap: Cap,
    join: Join,
    /// The largest deviation of a round corner from a circle.
    tolerance: f64,
}

/// One of the strokes that fill a line.
#[derive(Copy, Clone, Debug)]
struct Stroke {
    /// The distance to the left of the path.
    offset: f64,
    /// The largest distance of all strokes.
    outermost: f64,
    /// Counts from 0; strokes with odd numbers run backwards, so that the pen need not travel.
    number: usize,
}

impl Line<'_> {
    /// Adds a stroke. It begins where the last one of this line ended: the way between them lies inside of
    /// the line, so that the pen can stay down.
    fn add(&self, stroke: &Stroke, out: &mut PathBuf<Du>) {
        let [Some(first), Some(last)] = [self.segments.first(), self.segments.last()] else { return };
        let &Stroke { offset, outermost, number } = stroke;
        let linked = out.points.last().copied().filter(|_| number > 0);
        out.points.extend(linked);
        let begin = out.points.len();
        let beyond = match self.cap {
            _ if self.closed => 0.0,
            Cap::Butt => 0.0,
            Cap::Projecting => outermost,
            Cap::Round => (outermost * outermost - offset * offset).max(0.0).sqrt(),
        };
        out.push(first.start - first.along * beyond + first.along.perp() * offset);
        for pair in self.segments.windows(2) {
            self.corner(pair[0], pair[1], offset, out);
        }
        if self.closed {
            self.corner(*last, *first, offset, out);
            out.push(out.points[begin]);
        } else {
            out.push(last.end + last.along * beyond + last.along.perp() * offset);
        }
        if number % 2 == 1 {
            out.points[begin..].reverse();
        }
        out.end();
    }

    /// Adds the way from one segment to the next.
    fn corner(&self, from: Segment, to: Segment, offset: f64, out: &mut PathBuf<Du>) {
        let (a, b) = (from.along.perp(), to.along.perp());
        let (sine, cosine) = (from.along.perp_dot(to.along), from.along.dot(to.along));
        let turns_away = offset * sine < 0.0 || (sine == 0.0 && cosine < 0.0);
        // (1 + cosine) / 2 is the square of the ratio of the linewidth to the miter.
        let meets = (1.0 + cosine) * 0.5 * MITER_LIMIT * MITER_LIMIT >= 1.0;
        match self.join {
            Join::Miter if turns_away && meets => out.push(from.end + (a + b) * (offset / (1.0 + cosine))),
            Join::Round if turns_away => {
                let angle = sine.abs().atan2(cosine) * -offset.signum();
                let step = 2.0 * (1.0 - (self.tolerance / offset.abs()).min(1.0)).acos();
                let pieces = (angle.abs() / step.max(PI / 180.0)).ceil().max(1.0);
                for i in 0..=pieces as u32 {
                    let turn = DVec2::from_angle(angle * f64::from(i) / pieces);
                    out.push(from.end + turn.rotate(a) * offset);
                }
            }
            _ => {
                out.push(from.end + a * offset);
                out.push(from.end + b * offset);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIP: f64 = 1.0;

    /// The strokes of a path as one list of points, the links between them left out.
    fn strokes(path: &[(f64, f64)], width: f64, cap: Cap, join: Join) -> Vec<Vec<DVec2>> {
        let path: Vec<DVec2> = path.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
        let mut segments = Vec::new();
        let closed = segments_of(&path, &mut segments);
        let line = Line { segments: &segments, closed, cap, join, tolerance: 0.01 };
        let mut out = PathBuf::new();
        for (number, offset) in offsets(width, TIP).enumerate() {
            line.add(&Stroke { offset, outermost: (width - TIP) * 0.5, number }, &mut out);
        }
        out.as_paths().iter().map(<[DVec2]>::to_vec).collect()
    }

    /// The distance of a point from a path.
    fn distance(p: DVec2, path: &[(f64, f64)]) -> f64 {
        let to_segment = |w: &[(f64, f64)]| {
            let (a, b) = (DVec2::from(w[0]), DVec2::from(w[1]));
            let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            p.distance(a.lerp(b, t))
        };
        path.windows(2).map(to_segment).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn strokes_are_no_more_than_a_tip_apart_and_reach_the_edges() {
        for (width, strokes) in [(1.6, 2), (1.9, 2), (2.0, 3), (2.8, 3), (5.0, 6), (7.7, 9)] {
            let offsets: Vec<f64> = offsets(width, TIP).collect();
            let outermost = (width - TIP) * 0.5;
            assert_eq!(offsets.len(), strokes, "{width}");
            assert!((offsets[0] + outermost).abs() < 1e-12);
            assert!((offsets[offsets.len() - 1] - outermost).abs() < 1e-12);
            assert!(
                offsets.windows(2).all(|w| w[1] - w[0] <= TIP * SPACING + 1e-9 && w[0] < w[1]),
                "{width}"
            );
        }
    }

    #[test]
    fn a_straight_line_becomes_strokes_to_and_fro() {
        let points = strokes(&[(0.0, 0.0), (10.0, 0.0)], 2.8, Cap::Butt, Join::Miter).concat();
        let expected = [(0, -1), (10, -1), (10, -1), (10, 0), (0, 0), (0, 0), (0, 1), (10, 1)];
        let expected = expected.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y) * 0.9));
        assert!(points.len() == 8 && points.iter().zip(expected).all(|(p, e)| p.distance(e) < 1e-9));
    }

    #[test]
    fn ends_are_cut_off_rounded_or_continued() {
        let reach = |cap: Cap, offset: f64| {
            let points = strokes(&[(0.0, 0.0), (10.0, 0.0)], 4.6, cap, Join::Miter).concat();
            let on = points.iter().filter(|p| (p.y - offset).abs() < 1e-9).map(|p| p.x);
            on.fold(f64::NEG_INFINITY, f64::max)
        };
        assert_eq!([0.0, 0.9, 1.8].map(|y| reach(Cap::Butt, y)), [10.0; 3]);
        assert_eq!([0.0, 0.9, 1.8].map(|y| reach(Cap::Projecting, y)), [11.8; 3]);
        let round = [0.0, 0.9, 1.8].map(|y| reach(Cap::Round, y));
        let circle = [11.8, 10.0 + 0.9 * 3f64.sqrt(), 10.0];
        assert!(round.iter().zip(circle).all(|(r, c)| (r - c).abs() < 1e-9), "{round:?}");
    }

    #[test]
    fn corners_are_mitred_bevelled_or_round() {
        let path = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)];
        let corner = DVec2::new(12.0, -2.0);
        let nearest = |join: Join| {
            let points = strokes(&path, 5.0, Cap::Butt, join).concat();
            points.iter().map(|p| p.distance(corner)).fold(f64::INFINITY, f64::min)
        };
        assert!(nearest(Join::Miter) < 1e-9);
        assert!((nearest(Join::Bevel) - 2.0).abs() < 1e-9);
        let round = nearest(Join::Round);
        assert!((round - (8f64.sqrt() - 2.0)).abs() < 0.05, "{round}");
        // A needle is not mitred.
        let needle = strokes(&[(0.0, 0.0), (10.0, 0.0), (0.0, 0.5)], 5.0, Cap::Butt, Join::Miter).concat();
        assert!(needle.iter().all(|p| p.x < 12.1));
    }

    #[test]
    fn strokes_never_leave_the_line() {
        let mut random = 1u32;
        let mut next = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(random >> 16) / 65536.0 * 8.0
        };
        for join in [Join::Round, Join::Bevel] {
            for length in [2, 3, 9, 40] {
                let mut path: Vec<(f64, f64)> = (0..length).map(|_| (next(), next())).collect();
                path.push(if length == 9 { path[0] } else { (next(), next()) });
                let all = strokes(&path, 6.0, Cap::Round, join);
                for stroke in &all {
                    for pair in stroke.windows(2) {
                        for i in 0..=8 {
                            let p = pair[0].lerp(pair[1], f64::from(i) / 8.0);
                            assert!(distance(p, &path) < 2.5 + 1e-9, "{join:?} {length} {p}");
                        }
                    }
                }
                assert!(all.windows(2).all(|w| w[0].last() == w[1].first()), "linked");
            }
        }
    }

    #[test]
    fn closed_lines_have_no_ends() {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)];
        let all = strokes(&square, 3.0, Cap::Projecting, Join::Miter);
        let outer = &all[0];
        assert!(outer.contains(&DVec2::new(-1.0, -1.0)) && outer.contains(&DVec2::new(11.0, -1.0)));
        assert_eq!(outer.first(), outer.last());
        assert!(all.concat().iter().all(|p| p.min_element() >= -1.0 && p.max_element() <= 11.0));
    }

    #[test]
    fn dots_are_filled_discs() {
        let all = strokes(&[(5.0, 5.0)], 5.0, Cap::Round, Join::Round);
        let points = all.concat();
        let centre = DVec2::splat(5.0);
        assert!(points.iter().all(|p| p.distance(centre) <= 2.0 + 1e-9));
        let widest = points.iter().map(|p| p.x).fold(0.0, f64::max);
        assert!((6.9..=7.0).contains(&widest) && all.len() == 6, "{widest}");
        assert!(strokes(&[], 5.0, Cap::Round, Join::Round).is_empty());
    }
}
