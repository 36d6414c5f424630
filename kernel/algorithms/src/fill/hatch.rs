//! K. Brassel and R. Fegeas, "An Algorithm for Shading of Regions on Vector Display Devices", Computer Graphics (SIGGRAPH)
//! 13(2), 1979: parallel lines across the inside of rings.

use super::edge_table::{EdgeTable, Rows};
use crate::clip::liang_barsky;
use crate::path::{Rule, is_usable, ring_edges};
use crate::polygon::bounds;
use crate::rect::Rect;
use glam::DVec2;

/// The endless family of parallel lines with which areas are hatched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HatchLines {
    /// The direction of the lines, in radians, anticlockwise from the x axis (with y upwards).
    pub angle: f64,
    /// The distance of neighbouring lines, more than zero.
    pub spacing: f64,
    /// A point on one of the lines. Areas hatched with the same origin match where they meet.
    pub origin: DVec2,
    /// The most lines that one area may get; beyond it only every second, third, ... line of the family is drawn.
    pub limit: u32,
}

/// The hatcher: a value that keeps its table of edges from one area to the next.
#[derive(Debug, Default)]
pub struct Hatch {
    table: EdgeTable,
}

impl Hatch {
    /// A hatcher with an empty table.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives the pieces of the lines that lie inside the rings and the rectangle, line by line, each in the direction
    /// of the angle.
    ///
    /// A line along an edge of the area belongs to the area on its left, so that it is drawn once between two
    /// neighbours. Lines thinned out because of the limit are still numbered from the origin, so neighbours with the
    /// same thinning match. Gives nothing if the spacing is not a positive number, and leaves out vertices that are not
    /// usable.
    pub fn segments(
        &mut self,
        points: &[DVec2],
        ends: &[u32],
        rule: Rule,
        lines: &HatchLines,
        rect: Rect,
        mut segment: impl FnMut(DVec2, DVec2),
    ) {
        let Some(frame) = Frame::new(lines) else { return };
        let Some(rows) = frame.rows(points, rect, lines.limit) else { return };
        self.table.clear();
        ring_edges(points, ends, |a, b| {
            let (a, b) = (frame.enter(a), frame.enter(b));
            if is_usable(a) && is_usable(b) {
                self.table.add(a, b, rows);
            }
        });
        self.table.sweep(rows, rule, |_, number, from, to| {
            if from < to && to.is_finite() {
                let (a, b) = (frame.leave(from, number), frame.leave(to, number));
                if let Some((a, b)) = liang_barsky(rect, a, b).filter(|(a, b)| a != b) {
                    segment(a, b);
                }
            }
        });
    }
}

/// Coordinates along the lines (x, a length) and across them (y, the number of the line).
struct Frame {
    along: DVec2,
    /// How far from zero line 0 runs.
    across: f64,
    spacing: f64,
}

impl Frame {
    fn new(lines: &HatchLines) -> Option<Self> {
        // A sine of 1e-16 would tilt lines meant to be parallel to an axis.
        let exact = |v: f64| if v.abs() < 1e-15 { 0.0 } else { v };
        let along = DVec2::from_angle(lines.angle);
        let along = DVec2::new(exact(along.x), exact(along.y));
        let spacing = lines.spacing;
        let usable = is_usable(along) && is_usable(lines.origin) && spacing > 0.0 && spacing.is_finite();
        usable.then(|| Self { along, across: along.perp_dot(lines.origin), spacing })
    }

    fn enter(&self, p: DVec2) -> DVec2 {
        DVec2::new(self.along.dot(p), (self.along.perp_dot(p) - self.across) / self.spacing)
    }

    fn leave(&self, along: f64, number: f64) -> DVec2 {
        self.along * along + self.along.perp() * (self.across + number * self.spacing)
    }

    /// The lines that can be seen, thinned out to the limit.
    fn rows(&self, points: &[DVec2], rect: Rect, limit: u32) -> Option<Rows> {
        let across = |(min, max): Rect| {
            let corners = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
            let numbers = corners.map(|p| self.enter(p).y);
            (
                numbers.into_iter().fold(f64::INFINITY, f64::min),
                numbers.into_iter().fold(f64::NEG_INFINITY, f64::max),
            )
        };
        let (mut from, mut to) = across(bounds(points)?);
        if is_usable(rect.0) && is_usable(rect.1) {
            let seen = across(rect);
            (from, to) = (from.max(seen.0), to.min(seen.1));
        }
        let count = to.floor() - from.ceil() + 1.0;
        if !count.is_finite() || count < 1.0 || limit == 0 {
            return None;
        }
        let step = (count / f64::from(limit)).ceil();
        let first = (from / step).ceil() * step;
        // Counting from a multiple of the step may need one line more or less than the division above told.
        let count = ((to - first) / step).floor() + 1.0;
        (count >= 1.0).then(|| Rows { first, step, count: count.min(f64::from(limit)) as u32 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::{area, contains};
    use crate::xorshift::Xorshift;
    use std::f64::consts::FRAC_PI_2;

    const OPEN: Rect = (DVec2::NEG_INFINITY, DVec2::INFINITY);
    const LEVEL: HatchLines = HatchLines { angle: 0.0, spacing: 2.0, origin: DVec2::ZERO, limit: 1000 };

    fn hatched(points: &[DVec2], ends: &[u32], lines: &HatchLines, rect: Rect) -> Vec<(DVec2, DVec2)> {
        let mut segments = vec![];
        Hatch::new().segments(points, ends, Rule::EvenOdd, lines, rect, |a, b| segments.push((a, b)));
        segments
    }

    fn square(from: f64, to: f64) -> [DVec2; 4] {
        [DVec2::new(from, from), DVec2::new(to, from), DVec2::new(to, to), DVec2::new(from, to)]
    }

    fn row(x0: f64, x1: f64, y: f64) -> (DVec2, DVec2) {
        (DVec2::new(x0, y), DVec2::new(x1, y))
    }

    #[test]
    fn level_and_upright_lines_are_exact() {
        let ring = square(0.1, 5.7);
        assert_eq!(hatched(&ring, &[4], &LEVEL, OPEN), [row(0.1, 5.7, 2.0), row(0.1, 5.7, 4.0)]);
        let upright = HatchLines { angle: FRAC_PI_2, ..LEVEL };
        let expected = [4.0, 2.0].map(|x| (DVec2::new(x, 0.1), DVec2::new(x, 5.7)));
        assert_eq!(hatched(&ring, &[4], &upright, OPEN), expected);
        let shifted = HatchLines { origin: DVec2::new(77.0, 1.0), ..LEVEL };
        assert_eq!(hatched(&ring, &[4], &shifted, OPEN), [1.0, 3.0, 5.0].map(|y| row(0.1, 5.7, y)));
    }

    #[test]
    fn a_hole_parts_the_line_and_the_rectangle_cuts_it() {
        let rings = [square(-1.0, 11.0), square(3.0, 5.0)].concat();
        let lines = HatchLines { spacing: 4.0, ..LEVEL };
        let pieces = hatched(&rings, &[4, 8], &lines, (DVec2::new(1.0, 3.0), DVec2::new(9.0, 9.0)));
        assert_eq!(pieces, [row(1.0, 3.0, 4.0), row(5.0, 9.0, 4.0), row(1.0, 9.0, 8.0)]);
    }

    #[test]
    fn a_line_on_a_common_edge_is_drawn_once() {
        let (below, above) = (square(0.0, 2.0), square(0.0, 2.0).map(|p| p + DVec2::new(0.0, 2.0)));
        let drawn = [below, above].map(|ring| hatched(&ring, &[4], &LEVEL, OPEN)).concat();
        assert_eq!(drawn, [row(0.0, 2.0, 0.0), row(0.0, 2.0, 2.0)]);
    }

    #[test]
    fn lines_lie_in_the_area_and_measure_it() {
        let mut random = Xorshift::new(11);
        for _ in 0..200 {
            let ring: Vec<DVec2> = (0..random.int(3, 9)).map(|_| random.point(-10.0, 10.0)).collect();
            let ends = [ring.len() as u32];
            let lines = HatchLines {
                angle: random.real(-4.0, 4.0),
                spacing: random.real(0.1, 0.5),
                origin: random.point(-99.0, 99.0),
                limit: 1000,
            };
            let normal = DVec2::from_angle(lines.angle).perp();
            for (a, b) in hatched(&ring, &ends, &lines, OPEN) {
                for t in [0.001, 0.3, 0.7, 0.999] {
                    let p = a.lerp(b, t);
                    assert!(a.distance(b) < 1e-3 || contains(&ring, &ends, Rule::EvenOdd, p));
                }
                let number = normal.dot(a - lines.origin) / lines.spacing;
                assert!((number - number.round()).abs() < 1e-9);
                assert!((b - a).dot(DVec2::from_angle(lines.angle)) > 0.0);
            }
        }
        let triangle = [DVec2::new(-3.0, 1.0), DVec2::new(8.0, 2.0), DVec2::new(4.0, 9.0)];
        let fine = HatchLines { angle: 0.7, spacing: 0.001, origin: DVec2::ONE, limit: 100_000 };
        let ink: f64 = hatched(&triangle, &[3], &fine, OPEN).iter().map(|(a, b)| a.distance(*b)).sum();
        assert!((ink * fine.spacing - area(&triangle, &[3])).abs() < 1e-3);
    }

    #[test]
    fn too_many_lines_are_thinned_out_from_the_origin() {
        let ring = square(-100.0, 100.0);
        let lines = HatchLines { spacing: 1.0, limit: 50, ..LEVEL };
        let rows: Vec<f64> = hatched(&ring, &[4], &lines, OPEN).iter().map(|(a, _)| a.y).collect();
        assert!(
            rows.len() <= 50 && rows.contains(&0.0) && rows.windows(2).all(|w| w[1] - w[0] == 5.0),
            "{rows:?}"
        );
        let tiny = HatchLines { spacing: 1e-200, limit: 50, ..LEVEL };
        assert!(hatched(&ring, &[4], &tiny, OPEN).len() <= 50);
        let vast = hatched(&square(-1e12, 1e12), &[4], &LEVEL, (DVec2::ZERO, DVec2::splat(9.0)));
        assert_eq!(vast, [0.0, 2.0, 4.0, 6.0, 8.0].map(|y| row(0.0, 9.0, y)));
    }

    #[test]
    fn bad_input_gives_no_lines() {
        let ring = square(0.0, 9.0);
        let with = |lines: &HatchLines| hatched(&ring, &[4], lines, OPEN).len();
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 5e-324] {
            assert_eq!(with(&HatchLines { spacing: bad, ..LEVEL }), 0);
        }
        assert_eq!(with(&HatchLines { angle: f64::NAN, ..LEVEL }), 0);
        assert_eq!(with(&HatchLines { origin: DVec2::INFINITY, ..LEVEL }), 0);
        assert_eq!(with(&HatchLines { limit: 0, ..LEVEL }), 0);
        assert!(hatched(&[DVec2::NAN; 3], &[3], &LEVEL, OPEN).is_empty());
        assert!(hatched(&ring, &[4], &LEVEL, (DVec2::ONE, DVec2::ZERO)).is_empty());
    }
}
