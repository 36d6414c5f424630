//! Adobe Systems, "PostScript Language Reference Manual", 1985, `setdash`: a polyline cut into dashes.

use crate::clip;
use crate::path::{end_subpath, is_usable};
use crate::rect::Rect;
use glam::DVec2;

/// Appends the dashes of a polyline that lie inside the rectangle.
///
/// `pattern` holds the lengths of dashes and gaps in turn, beginning with a dash; an odd number of them is gone through
/// twice. `phase` is the distance into the pattern at which the line begins; it may be negative or longer than the
/// pattern. Dashes keep the vertices they go round, bit for bit; a dash of no length gives a piece of two equal points.
/// What lies outside the rectangle uses up its share of the pattern but costs nothing for each dash, so pass the clipping
/// rectangle, widened by the width of the line, and not the whole world.
///
/// The line comes out solid, merely clipped, if the pattern is empty, holds a length that is negative or not finite, or
/// adds up to nothing, and also if it would fall into more than `limit` pieces. The line is broken at a vertex that is not
/// usable; the pattern stands still there.
pub fn dash(
    rect: Rect,
    path: &[DVec2],
    pattern: &[f64],
    phase: f64,
    limit: usize,
    points: &mut Vec<DVec2>,
    ends: &mut Vec<u32>,
) {
    let (points_before, ends_before) = (points.len(), ends.len());
    let dashes = if path.len() < 2 { None } else { Dashes::new(pattern, phase) };
    let dashed = dashes.is_some_and(|mut dashes| {
        let most = ends_before.saturating_add(limit);
        dashes.follow(rect, path, points, ends, most) && dashes.end(points, ends, most)
    });
    if !dashed {
        points.truncate(points_before);
        ends.truncate(ends_before);
        clip::polyline(rect, path, points, ends);
    }
}

/// How far a polyline that comes in parts has been cut into dashes, as [`dash`] does.
pub struct Dashes<'a> {
    walk: Walk<'a>,
    /// The vertex reached.
    last: Option<DVec2>,
    /// Whether a dash is under construction.
    is_begun: bool,
}

impl<'a> Dashes<'a> {
    /// A line that begins at `phase` in a pattern; none if that is no pattern.
    pub fn new(pattern: &'a [f64], phase: f64) -> Option<Self> {
        Some(Dashes { walk: Walk::new(pattern, phase)?, last: None, is_begun: false })
    }

    /// Goes on to further vertices, and appends the dashes that lie inside the rectangle. Points behind the last end belong to
    /// a dash that has not ended; nothing but ended dashes may be taken away before the line goes on. False if there are more
    /// than `most` ends: then the line is left as it is.
    pub fn follow(
        &mut self,
        rect: Rect,
        path: &[DVec2],
        points: &mut Vec<DVec2>,
        ends: &mut Vec<u32>,
        most: usize,
    ) -> bool {
        let joint = self.last.zip(path.first().copied());
        self.last = path.last().copied().or(self.last);
        let mut pen = Pen { points, ends, most, is_begun: self.is_begun };
        let done = joint.is_none_or(|(a, b)| self.walk.segment(rect, a, b, &mut pen))
            && path.windows(2).all(|segment| self.walk.segment(rect, segment[0], segment[1], &mut pen));
        self.is_begun = pen.is_begun;
        done
    }

    /// Ends the line: what has begun is a dash.
    pub fn end(self, points: &mut Vec<DVec2>, ends: &mut Vec<u32>, most: usize) -> bool {
        Pen { points, ends, most, is_begun: self.is_begun }.lift()
    }
}

/// More dashes and gaps than any segment is cut into, whatever the limit: few enough for every round of the pattern to
/// be a step forward in spite of rounding.
const MOST_STEPS: f64 = 1e12;

/// What is appended to, with the piece under construction behind the last end.
struct Pen<'a> {
    points: &'a mut Vec<DVec2>,
    ends: &'a mut Vec<u32>,
    most: usize,
    is_begun: bool,
}

impl Pen<'_> {
    fn down(&mut self, p: DVec2) {
        if !self.is_begun {
            self.is_begun = true;
            self.points.push(p);
        }
    }

    fn to(&mut self, p: DVec2) {
        self.points.push(p);
    }

    /// Ends the piece, if there is one; false if there are too many then.
    fn lift(&mut self) -> bool {
        if std::mem::take(&mut self.is_begun) {
            let start = self.ends.last().map_or(0, |&end| end as usize);
            if self.points.len() < start + 2 {
                // Begun where the line or the rectangle ends.
                self.points.truncate(start);
            } else {
                end_subpath(self.points, self.ends);
            }
        }
        self.ends.len() <= self.most
    }
}

/// The place in the pattern.
struct Walk<'a> {
    pattern: &'a [f64],
    /// The length after which the pattern and the turn of dashes and gaps repeat.
    period: f64,
    /// Counts on for a second round if the number of lengths is odd; dashes are even.
    index: usize,
    /// What is left of the current length.
    left: f64,
}

impl<'a> Walk<'a> {
    fn new(pattern: &'a [f64], phase: f64) -> Option<Self> {
        let rounds = if pattern.len().is_multiple_of(2) { 1.0 } else { 2.0 };
        let period = rounds * pattern.iter().sum::<f64>();
        if !pattern.iter().all(|&length| length >= 0.0) || period <= 0.0 || !period.is_finite() {
            return None;
        }
        let mut walk = Self { pattern, period, index: 0, left: *pattern.first()? };
        if phase.is_finite() {
            walk.skip(phase.rem_euclid(period));
        }
        Some(walk)
    }

    fn is_dash(&self) -> bool {
        self.index.is_multiple_of(2)
    }

    fn next(&mut self) {
        let count = self.pattern.len();
        self.index = (self.index + 1) % (2 * count);
        self.left = self.pattern[self.index % count];
    }

    /// Goes on by some distance; what ends exactly there has ended.
    fn skip(&mut self, distance: f64) {
        let mut rest = distance % self.period;
        // Rounding could leave a crumb after a whole round.
        for _ in 0..=2 * self.pattern.len() {
            if rest < self.left || rest == 0.0 {
                break;
            }
            rest -= self.left;
            self.next();
        }
        self.left = (self.left - rest).max(0.0);
    }

    /// Dashes one segment; false if there were too many pieces.
    fn segment(&mut self, rect: Rect, a: DVec2, b: DVec2, pen: &mut Pen<'_>) -> bool {
        if !is_usable(a) || !is_usable(b) {
            return pen.lift();
        }
        let Some((p, q)) = clip::liang_barsky(rect, a, b) else {
            self.skip(a.distance(b));
            return pen.lift();
        };
        if p != a {
            if !pen.lift() {
                return false;
            }
            self.skip(a.distance(p));
        }
        // Distances from p, not from a: a far beginning must not eat the digits.
        let span = p.distance(q);
        if span / self.period * self.pattern.len() as f64 > MOST_STEPS {
            return false;
        }
        let (mut at, mut here) = (0.0, p);
        while at + self.left <= span {
            at += self.left;
            let end = if at == span { q } else { p + (q - p) * (at / span) };
            if self.is_dash() {
                pen.down(here);
                pen.to(end);
                if !pen.lift() {
                    return false;
                }
            }
            here = end;
            self.next();
        }
        if self.is_dash() {
            pen.down(here);
            if at < span || a == b {
                pen.to(q);
            }
        }
        self.left -= span - at;
        if q != b {
            self.skip(q.distance(b));
            return pen.lift();
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::subpaths;
    use crate::xorshift::Xorshift;

    const OPEN: Rect = (DVec2::NEG_INFINITY, DVec2::INFINITY);

    fn dashed(rect: Rect, path: &[DVec2], pattern: &[f64], phase: f64, limit: usize) -> Vec<Vec<DVec2>> {
        let (mut points, mut ends) = (vec![DVec2::NAN], vec![1]);
        dash(rect, path, pattern, phase, limit, &mut points, &mut ends);
        assert_eq!(ends.last().copied(), Some(points.len() as u32));
        subpaths(&points, &ends).skip(1).map(<[_]>::to_vec).collect()
    }

    /// Dashes of a line along x, as (begin, end).
    fn row(pattern: &[f64], phase: f64, length: f64) -> Vec<(f64, f64)> {
        let pieces = dashed(OPEN, &[DVec2::ZERO, DVec2::new(length, 0.0)], pattern, phase, 1000);
        pieces.iter().map(|piece| (piece[0].x, piece[piece.len() - 1].x)).collect()
    }

    #[test]
    fn patterns_even_odd_and_shifted() {
        assert_eq!(row(&[3.0, 1.0], 0.0, 9.0), [(0.0, 3.0), (4.0, 7.0), (8.0, 9.0)]);
        assert_eq!(row(&[3.0, 1.0], 0.0, 8.0), [(0.0, 3.0), (4.0, 7.0)]);
        assert_eq!(row(&[3.0, 1.0], 3.5, 8.0), [(0.5, 3.5), (4.5, 7.5)]);
        assert_eq!(row(&[3.0, 1.0], -1.0, 8.0), [(1.0, 4.0), (5.0, 8.0)]);
        assert_eq!(row(&[3.0, 1.0], 403.0, 8.0), row(&[3.0, 1.0], 3.0, 8.0));
        assert_eq!(row(&[1.0, 2.0, 3.0], 0.0, 12.0), [(0.0, 1.0), (3.0, 6.0), (7.0, 9.0)]);
        assert_eq!(row(&[2.0], 0.0, 8.0), [(0.0, 2.0), (4.0, 6.0)]);
    }

    #[test]
    fn dots_have_no_length() {
        assert_eq!(row(&[0.0, 2.0], 0.0, 5.0), [(0.0, 0.0), (2.0, 2.0), (4.0, 4.0)]);
        assert_eq!(row(&[0.0, 2.0], 1.0, 4.0), [(1.0, 1.0), (3.0, 3.0)]);
        assert_eq!(row(&[1.0, 0.0], 0.0, 2.0), [(0.0, 1.0), (1.0, 2.0)]);
    }

    #[test]
    fn a_dash_goes_round_the_corner() {
        let path = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(DVec2::from);
        let pieces = dashed(OPEN, &path, &[5.0, 3.0], 0.0, 100);
        assert_eq!(pieces, [vec![path[0], path[1], DVec2::new(4.0, 1.0)], vec![path[2], path[3]]]);
    }

    #[test]
    fn bad_patterns_and_too_many_pieces_leave_the_line_solid() {
        let path = [DVec2::ZERO, DVec2::new(100.0, 0.0), DVec2::new(100.0, 50.0)];
        for pattern in [&[][..], &[0.0], &[0.0, 0.0], &[-1.0, 3.0], &[f64::NAN, 1.0], &[f64::INFINITY, 1.0]] {
            assert_eq!(dashed(OPEN, &path, pattern, 0.0, 1000), [path], "{pattern:?}");
        }
        assert_eq!(dashed(OPEN, &path, &[1.0, 1.0], 0.0, 75).len(), 75);
        assert_eq!(dashed(OPEN, &path, &[1.0, 1.0], 0.0, 74), [path]);
        assert_eq!(dashed(OPEN, &path, &[1e-300, 1e-300], 0.0, usize::MAX), [path]);
        assert_eq!(dashed(OPEN, &path, &[1.0, 1.0], f64::NAN, 75).len(), 75);
    }

    #[test]
    fn a_bad_vertex_breaks_and_a_dot_stays() {
        let path = [DVec2::ZERO, DVec2::X, DVec2::NAN, DVec2::Y, DVec2::ONE];
        assert_eq!(dashed(OPEN, &path, &[9.0, 1.0], 0.0, 10), [path[..2].to_vec(), path[3..].to_vec()]);
        assert_eq!(dashed(OPEN, &[DVec2::ONE; 2], &[9.0, 1.0], 0.0, 10), [[DVec2::ONE; 2]]);
        assert_eq!(dashed(OPEN, &[DVec2::ONE], &[9.0, 1.0], 0.0, 10), [[DVec2::ONE]]);
        assert!(dashed(OPEN, &[], &[9.0, 1.0], 0.0, 10).is_empty());
    }

    #[test]
    fn dashes_and_gaps_add_up_and_dashes_lie_on_the_line() {
        let mut random = Xorshift::new(7);
        for _ in 0..300 {
            let path: Vec<DVec2> = (0..random.int(2, 9)).map(|_| random.point(-20.0, 20.0)).collect();
            let pattern: Vec<f64> = (0..random.int(1, 5)).map(|_| random.real(0.1, 9.0)).collect();
            let phase = random.real(-50.0, 50.0);
            // The gaps are the dashes of the pattern begun with a dash of no length.
            let rounds = 1 + pattern.len() % 2;
            let gaps = [vec![0.0], pattern.repeat(rounds), vec![0.0]].concat();
            let length = |pieces: &[Vec<DVec2>]| -> f64 {
                pieces.iter().flat_map(|p| p.windows(2)).map(|w| w[0].distance(w[1])).sum()
            };
            let total = length(std::slice::from_ref(&path));
            let dashes = dashed(OPEN, &path, &pattern, phase, 100_000);
            let both = length(&dashes) + length(&dashed(OPEN, &path, &gaps, phase, 100_000));
            assert!((both - total).abs() < 1e-6, "{both} {total} {pattern:?} {phase}");
            for piece in &dashes {
                assert!(
                    length(std::slice::from_ref(piece))
                        <= pattern.iter().fold(0.0_f64, |a, &b| a.max(b)) + 1e-9
                );
                for p in piece {
                    let off =
                        path.windows(2).map(|w| distance_to_segment(*p, w[0], w[1])).fold(f64::MAX, f64::min);
                    assert!(off < 1e-9);
                }
            }
        }
    }

    #[test]
    fn clipping_changes_neither_phase_nor_length() {
        let mut random = Xorshift::new(8);
        let rect = (DVec2::splat(-10.0), DVec2::splat(10.0));
        for _ in 0..300 {
            let path: Vec<DVec2> = (0..random.int(2, 9)).map(|_| random.point(-60.0, 60.0)).collect();
            let pattern = [random.real(0.5, 5.0), random.real(0.5, 5.0)];
            let (mut points, mut ends) = (vec![], vec![]);
            for piece in dashed(OPEN, &path, &pattern, 0.0, 100_000) {
                clip::polyline(rect, &piece, &mut points, &mut ends);
            }
            let pieces = dashed(rect, &path, &pattern, 0.0, 100_000);
            let ink = |pieces: &mut dyn Iterator<Item = &[DVec2]>| -> (f64, DVec2) {
                pieces.flat_map(|p| p.windows(2)).fold((0.0, DVec2::ZERO), |(length, moment), w| {
                    let l = w[0].distance(w[1]);
                    (length + l, moment + (w[0] + w[1]) * l)
                })
            };
            let (l0, m0) = ink(&mut subpaths(&points, &ends));
            let (l1, m1) = ink(&mut pieces.iter().map(Vec::as_slice));
            assert!((l0 - l1).abs() < 1e-7 && m0.distance(m1) < 1e-5, "{l0} {l1} {m0} {m1}");
        }
    }

    #[test]
    fn a_line_through_the_universe_costs_what_is_seen() {
        let far = DVec2::new(1e15, 0.0);
        let rect = (DVec2::splat(-10.0), DVec2::splat(10.0));
        let pieces = dashed(rect, &[-far, far, DVec2::NAN, -far * 1e100, far * 1e100], &[1.0, 1.0], 0.0, 100);
        assert!((18..=24).contains(&pieces.len()), "{}", pieces.len());
        assert!(pieces[1..9].iter().all(|piece| (piece[0].distance(piece[1]) - 1.0).abs() < 1e-9));
    }

    fn distance_to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
        let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        p.distance(a + (b - a) * t)
    }
}
