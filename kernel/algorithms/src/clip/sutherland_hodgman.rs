//! I. E. Sutherland and G. W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1), 1974: ring against
//! rectangle or convex polygon.

use super::{cohen_sutherland, meet_horizontal, meet_vertical};
use crate::path::{end_subpath, is_usable};
use crate::polygon::ring_area;
use crate::rect::Rect;
use glam::DVec2;

/// Appends the part of a ring that lies inside the rectangle, as one ring or none.
///
/// Vertices inside are kept bit for bit, cut points lie exactly on the side that cuts. A concave ring that falls apart is
/// still one ring, its parts joined by edges that run to and fro along the rectangle: right for filling by either
/// rule, wrong for drawing the edge. Repeated vertices are dropped, and so is a ring of fewer than three. Each ring of a
/// set may be clipped by itself; how often the rings turn round a point inside the rectangle does not change.
pub fn sutherland_hodgman(rect: Rect, ring: &[DVec2], points: &mut Vec<DVec2>, ends: &mut Vec<u32>) {
    let start = points.len();
    let code = |p: &DVec2| cohen_sutherland::outcode(rect, *p);
    let usable = || ring.iter().filter(|&&p| is_usable(p));
    let (any, all) = usable().fold((0, u8::MAX), |(any, all), p| (any | code(p), all & code(p)));
    if any == 0 {
        points.extend(usable());
    } else if all == 0 {
        let mut pipeline = Pipeline { rect, stages: [None; 4], points, start };
        usable().for_each(|&p| pipeline.feed(0, p));
        pipeline.flush();
    }
    close(start, points, ends);
}

/// The four clippers of the paper, one after the other, each remembering the first and the last point it was given.
struct Pipeline<'a> {
    rect: Rect,
    stages: [Option<(DVec2, DVec2)>; 4],
    points: &'a mut Vec<DVec2>,
    start: usize,
}

impl Pipeline<'_> {
    fn is_inside(&self, side: usize, p: DVec2) -> bool {
        let (min, max) = self.rect;
        match side {
            0 => p.x >= min.x,
            1 => p.y >= min.y,
            2 => p.x <= max.x,
            _ => p.y <= max.y,
        }
    }

    fn meet(&self, side: usize, a: DVec2, b: DVec2) -> DVec2 {
        let (min, max) = self.rect;
        match side {
            0 => meet_vertical(a, b, min.x),
            1 => meet_horizontal(a, b, min.y),
            2 => meet_vertical(a, b, max.x),
            _ => meet_horizontal(a, b, max.y),
        }
    }

    fn feed(&mut self, side: usize, p: DVec2) {
        if side == 4 {
            if self.points[self.start..].last() != Some(&p) {
                self.points.push(p);
            }
            return;
        }
        let inside = self.is_inside(side, p);
        let first = match self.stages[side] {
            None => p,
            Some((first, last)) => {
                self.cross(side, last, p);
                first
            }
        };
        self.stages[side] = Some((first, p));
        if inside {
            self.feed(side + 1, p);
        }
    }

    fn cross(&mut self, side: usize, a: DVec2, b: DVec2) {
        if self.is_inside(side, a) != self.is_inside(side, b) {
            self.feed(side + 1, self.meet(side, a, b));
        }
    }

    fn flush(&mut self) {
        for side in 0..4 {
            if let Some((first, last)) = self.stages[side] {
                self.cross(side, last, first);
            }
        }
    }
}

/// Appends the part of a ring that lies inside a convex polygon, as one ring or none.
///
/// The polygon may run either way round; one without area has no inside. `scratch` is cleared and used. In all else as
/// [`sutherland_hodgman`], but for cut points lying on the side only up to rounding.
pub fn sutherland_hodgman_convex(
    convex: &[DVec2],
    ring: &[DVec2],
    scratch: &mut Vec<DVec2>,
    points: &mut Vec<DVec2>,
    ends: &mut Vec<u32>,
) {
    let area = ring_area(convex);
    let Some(&last) = convex.last() else { return };
    if area == 0.0 || !area.is_finite() {
        return;
    }
    let start = points.len();
    points.extend(ring.iter().filter(|&&p| is_usable(p)));
    let mut from = last;
    for &to in convex {
        let inward = (to - from).perp() * area.signum();
        scratch.clear();
        scratch.extend_from_slice(&points[start..]);
        points.truncate(start);
        clip_half_plane(from, inward, scratch, points);
        from = to;
    }
    close(start, points, ends);
}

/// Appends the part of a ring on the inward side of the line through `on`.
fn clip_half_plane(on: DVec2, inward: DVec2, ring: &[DVec2], points: &mut Vec<DVec2>) {
    let Some(&last) = ring.last() else { return };
    let (mut a, mut depth_a) = (last, inward.dot(last - on));
    for &b in ring {
        let depth_b = inward.dot(b - on);
        if (depth_a < 0.0) != (depth_b < 0.0) {
            // From the outer end to the inner one, so that both directions of an edge are cut alike.
            let (outer, inner) =
                if depth_a < 0.0 { ((a, depth_a), (b, depth_b)) } else { ((b, depth_b), (a, depth_a)) };
            points.push(outer.0 + (inner.0 - outer.0) * (outer.1 / (outer.1 - inner.1)));
        }
        if depth_b >= 0.0 {
            points.push(b);
        }
        (a, depth_a) = (b, depth_b);
    }
}

/// Drops repeated vertices of the ring begun at `start` and ends it, or drops it altogether.
fn close(start: usize, points: &mut Vec<DVec2>, ends: &mut Vec<u32>) {
    let mut kept = start;
    for i in start..points.len() {
        if kept == start || points[kept - 1] != points[i] {
            points[kept] = points[i];
            kept += 1;
        }
    }
    while kept > start + 1 && points[kept - 1] == points[start] {
        kept -= 1;
    }
    points.truncate(if kept - start < 3 { start } else { kept });
    if points.len() > start {
        end_subpath(points, ends);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Rule;
    use crate::polygon::contains;
    use crate::xorshift::Xorshift;

    const RECT: Rect = (DVec2::ZERO, DVec2::new(10.0, 10.0));
    const SQUARE: [DVec2; 4] =
        [DVec2::ZERO, DVec2::new(10.0, 0.0), DVec2::new(10.0, 10.0), DVec2::new(0.0, 10.0)];

    fn clipped(ring: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let ring: Vec<DVec2> = ring.iter().map(|&p| p.into()).collect();
        let (mut points, mut ends) = (vec![], vec![]);
        sutherland_hodgman(RECT, &ring, &mut points, &mut ends);
        assert!(ends.len() <= 1 && ends.iter().all(|&end| end as usize == points.len()));
        points.into_iter().map(Into::into).collect()
    }

    #[test]
    fn a_corner_cut_off_and_a_ring_round_the_rectangle() {
        let triangle = clipped(&[(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)]);
        assert_eq!(triangle, [(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]);
        let round = clipped(&[(-5.0, -5.0), (15.0, -5.0), (15.0, 15.0), (-5.0, 15.0)]);
        assert_eq!(round.len(), 4);
        for corner in SQUARE {
            assert!(round.contains(&corner.into()));
        }
    }

    #[test]
    fn inside_is_kept_and_outside_or_flat_dropped() {
        let ring = [(1.0, 1.0), (9.0, 2.0), (0.1, 0.7)];
        assert_eq!(clipped(&ring), ring);
        assert_eq!(clipped(&[(1.0, 1.0), (9.0, 2.0), (9.0, 2.0), (3.0, 7.0), (1.0, 1.0)]).len(), 3);
        assert!(clipped(&[(11.0, 1.0), (19.0, 2.0), (12.0, 9.0)]).is_empty());
        assert!(clipped(&[(-5.0, 10.0), (5.0, 10.0), (0.0, 15.0)]).len() < 3);
        assert!(clipped(&[(1.0, 1.0), (f64::NAN, 2.0), (3.0, 3.0)]).is_empty());
        assert!(clipped(&[]).is_empty());
    }

    #[test]
    fn filling_is_the_same_inside_the_rectangle_by_both_rules() {
        let mut random = Xorshift::new(6);
        for _ in 0..300 {
            let ring: Vec<DVec2> = (0..random.int(3, 12)).map(|_| random.point(-8.0, 18.0)).collect();
            let whole = [ring.len() as u32];
            let (mut points, mut ends) = (vec![], vec![]);
            sutherland_hodgman(RECT, &ring, &mut points, &mut ends);
            let (mut convex, mut convex_ends) = (vec![], vec![]);
            sutherland_hodgman_convex(&SQUARE, &ring, &mut vec![], &mut convex, &mut convex_ends);
            for rule in [Rule::EvenOdd, Rule::NonZero] {
                for _ in 0..100 {
                    let p = random.point(-8.0, 18.0);
                    let within = p.min_element() >= 0.0 && p.max_element() <= 10.0;
                    let expected = within && contains(&ring, &whole, rule, p);
                    assert_eq!(contains(&points, &ends, rule, p), expected);
                    assert_eq!(contains(&convex, &convex_ends, rule, p), expected);
                }
            }
        }
    }

    #[test]
    fn a_triangle_clips_a_square() {
        let triangle = [DVec2::new(5.0, -5.0), DVec2::new(15.0, 5.0), DVec2::new(5.0, 15.0)];
        let (mut points, mut ends, mut scratch) = (vec![DVec2::ONE], vec![1], vec![DVec2::NAN]);
        sutherland_hodgman_convex(&triangle, &SQUARE, &mut scratch, &mut points, &mut ends);
        assert_eq!(ends, [1, 5]);
        assert_eq!(ring_area(&points[1..]).abs(), 50.0);
    }
}
