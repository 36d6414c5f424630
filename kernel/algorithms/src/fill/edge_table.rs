//! C. Wylie, G. Romney, D. Evans and A. Erdahl, "Half-tone perspective drawings by computer", AFIPS Fall Joint Computer
//! Conference 1967; Foley, van Dam, Feiner and Hughes, "Computer Graphics: Principles and Practice", 2nd ed., 1990,
//! section 3.6: scan-line filling with an edge table and a list of active edges.

use crate::path::{Rule, ring_edges};
use crate::rect::IRect;
use glam::DVec2;

/// The edges of an area sorted by the row in which they begin, and those that the current row crosses.
///
/// The value holds nothing but storage between two areas; keep it to save allocating it again.
#[derive(Debug, Default)]
pub struct EdgeTable {
    edges: Vec<Edge>,
    active: Vec<Crossing>,
}

/// Parallel rows at `first`, `first + step` and so on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows {
    pub(super) first: f64,
    pub(super) step: f64,
    pub(super) count: u32,
}

#[derive(Debug)]
struct Edge {
    /// The first row the edge crosses and the first that it does not cross any more.
    rows: (u32, u32),
    low: DVec2,
    slope: f64,
    /// Bounds of x, which rounding must not overstep.
    x: (f64, f64),
    turn: i32,
}

#[derive(Debug)]
struct Crossing {
    x: f64,
    edge: u32,
}

impl EdgeTable {
    /// A table without edges.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives the spans of pixels (row y, first column, one past the last column) whose centres lie inside the rings.
    ///
    /// Pixel (x, y) has its centre at (x + 0.5, y + 0.5); a centre on a left or lower edge is inside, on a right or upper
    /// one outside. Rows come in ascending order, spans of a row from left to right and without overlap. Vertices that
    /// are not usable are left out. Takes O(n log n) steps for n edges, and for each row in `clip` as many as there are
    /// edges that cross it.
    pub fn spans(
        &mut self,
        points: &[DVec2],
        ends: &[u32],
        rule: Rule,
        clip: IRect,
        mut span: impl FnMut(i32, i32, i32),
    ) {
        if clip.is_empty() {
            return;
        }
        let count = clip.max.y.abs_diff(clip.min.y);
        let rows = Rows { first: f64::from(clip.min.y) + 0.5, step: 1.0, count };
        let (left, right) = (f64::from(clip.min.x), f64::from(clip.max.x));
        self.clear();
        ring_edges(points, ends, |a, b| {
            // An edge right of all columns turns nothing inside out that could be seen.
            if a.x.min(b.x) < right {
                self.add(a, b, rows);
            }
        });
        let column = |x: f64| (x - 0.5).ceil().max(left).min(right) as i32;
        self.sweep(rows, rule, |row, _, from, to| {
            let (from, to) = (column(from), column(to));
            if from < to {
                span(clip.min.y.wrapping_add_unsigned(row), from, to);
            }
        });
    }

    pub(super) fn clear(&mut self) {
        self.edges.clear();
    }

    /// Enters an edge unless no row crosses it. Both ends must be usable.
    pub(super) fn add(&mut self, a: DVec2, b: DVec2, rows: Rows) {
        let (low, high, turn) = if a.y <= b.y { (a, b, 1) } else { (b, a, -1) };
        // One monotone function for every vertex, so that each row is crossed an even number of times by each ring.
        let row = |y: f64| ((y - rows.first) / rows.step).ceil().clamp(0.0, f64::from(rows.count)) as u32;
        let (from, to) = (row(low.y), row(high.y));
        if from < to {
            let slope = (high.x - low.x) / (high.y - low.y);
            let x = (low.x.min(high.x), low.x.max(high.x));
            self.edges.push(Edge { rows: (from, to), low, slope, x, turn });
        }
    }

    /// Gives the stretches inside, row by row: number of the row, its y, and the x where it begins and ends.
    ///
    /// A stretch with no edge to end it ends at infinity.
    pub(super) fn sweep(&mut self, rows: Rows, rule: Rule, mut stretch: impl FnMut(u32, f64, f64, f64)) {
        let Self { edges, active } = self;
        edges.sort_unstable_by_key(|edge| edge.rows.0);
        active.clear();
        let mut next = 0;
        let mut row = 0;
        while row < rows.count {
            if active.is_empty() {
                let Some(edge) = edges.get(next) else { break };
                row = row.max(edge.rows.0);
            }
            while edges.get(next).is_some_and(|edge| edge.rows.0 == row) {
                active.push(Crossing { x: 0.0, edge: next as u32 });
                next += 1;
            }
            let y = rows.first + f64::from(row) * rows.step;
            active.retain_mut(|crossing| {
                let edge = &edges[crossing.edge as usize];
                crossing.x = (edge.low.x + (y - edge.low.y) * edge.slope).max(edge.x.0).min(edge.x.1);
                row < edge.rows.1
            });
            if !active.is_sorted_by(|a, b| a.x <= b.x) {
                active.sort_unstable_by(|a, b| a.x.total_cmp(&b.x));
            }
            let mut winding = 0;
            let mut from = 0.0;
            for crossing in active.iter() {
                let was_inside = rule.is_inside(winding);
                winding += edges[crossing.edge as usize].turn;
                match (was_inside, rule.is_inside(winding)) {
                    (false, true) => from = crossing.x,
                    (true, false) => stretch(row, y, from, crossing.x),
                    _ => {}
                }
            }
            if rule.is_inside(winding) {
                stretch(row, y, from, f64::INFINITY);
            }
            row += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::contains;
    use crate::xorshift::Xorshift;
    use glam::IVec2;

    const RULES: [Rule; 2] = [Rule::EvenOdd, Rule::NonZero];

    fn picture(points: &[DVec2], ends: &[u32], rule: Rule, clip: IRect) -> Vec<String> {
        let (width, height) = (clip.max.x - clip.min.x, clip.max.y - clip.min.y);
        let mut rows = vec![vec!['.'; width as usize]; height as usize];
        let mut last = (i32::MIN, 0);
        EdgeTable::new().spans(points, ends, rule, clip, |y, from, to| {
            assert!(from < to && (y, from) >= last, "out of order or overlapping");
            last = (y, to);
            rows[(y - clip.min.y) as usize][(from - clip.min.x) as usize..(to - clip.min.x) as usize]
                .fill('#');
        });
        rows.into_iter().map(|row| row.into_iter().collect()).collect()
    }

    fn ring(points: &[(f64, f64)]) -> Vec<DVec2> {
        points.iter().map(|&p| p.into()).collect()
    }

    #[test]
    fn a_triangle_and_a_square_with_a_hole() {
        let triangle = ring(&[(0.0, 0.0), (8.0, 0.0), (0.0, 4.0)]);
        let expected = ["#######.", "#####...", "###.....", "#......."];
        assert_eq!(picture(&triangle, &[3], Rule::EvenOdd, IRect::of_size(8, 4)), expected);
        let square = ring(&[
            (1.0, 1.0),
            (6.0, 1.0),
            (6.0, 5.0),
            (1.0, 5.0),
            (2.5, 2.5),
            (4.5, 2.5),
            (4.5, 4.0),
            (2.5, 4.0),
        ]);
        let expected = [".......", ".#####.", ".#..##.", ".#..##.", ".#####.", "......."];
        assert_eq!(picture(&square, &[4, 8], Rule::EvenOdd, IRect::of_size(7, 6)), expected);
        let expected = [".......", ".#####.", ".#####.", ".#####.", ".#####.", "......."];
        assert_eq!(picture(&square, &[4, 8], Rule::NonZero, IRect::of_size(7, 6)), expected);
    }

    #[test]
    fn agrees_with_the_test_of_every_pixel_centre() {
        let mut random = Xorshift::new(9);
        for round in 0..200 {
            let clip = IRect::new(random.grid(-5, 5), random.grid(10, 30));
            let count = random.int(3, 30);
            let points: Vec<DVec2> = (0..count)
                .map(|_| {
                    if round % 2 == 0 {
                        random.point(-20.0, 40.0)
                    } else {
                        random.grid(-40, 80).as_dvec2() / 2.0
                    }
                })
                .collect();
            let ends = [random.int(0, count) as u32, count as u32];
            for rule in RULES {
                let rows = picture(&points, &ends, rule, clip);
                for (y, row) in (clip.min.y..).zip(&rows) {
                    for (x, pixel) in (clip.min.x..).zip(row.chars()) {
                        let centre = IVec2::new(x, y).as_dvec2() + 0.5;
                        assert_eq!(pixel == '#', contains(&points, &ends, rule, centre), "{x} {y} {rule:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn neighbours_fill_each_pixel_once() {
        let mut random = Xorshift::new(10);
        let clip = IRect::of_size(20, 20);
        let corners = ring(&[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)]);
        for _ in 0..100 {
            let middle = random.grid(0, 40).as_dvec2() / 2.0;
            let mut count = 0;
            for i in 0..4 {
                let triangle = [corners[i], corners[(i + 1) % 4], middle];
                EdgeTable::new()
                    .spans(&triangle, &[3], Rule::EvenOdd, clip, |_, from, to| count += to - from);
            }
            assert_eq!(count, 400, "{middle}");
        }
    }

    #[test]
    fn huge_and_bad_coordinates() {
        let far = 1e150;
        let all = ring(&[
            (-far, -far),
            (far, -far),
            (f64::NAN, 0.0),
            (far, far),
            (-far, far),
            (0.0, f64::INFINITY),
        ]);
        assert_eq!(picture(&all, &[6], Rule::EvenOdd, IRect::of_size(3, 2)), ["###", "###"]);
        let whole = IRect::new(IVec2::MIN, IVec2::MAX);
        let mut area = 0;
        let small = ring(&[(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)]);
        EdgeTable::new().spans(&small, &[4], Rule::NonZero, whole, |_, from, to| area += to - from);
        assert_eq!(area, 9);
        assert_eq!(picture(&[DVec2::NAN; 3], &[3], Rule::EvenOdd, IRect::of_size(2, 1)), [".."]);
        assert_eq!(picture(&[], &[], Rule::EvenOdd, IRect::of_size(2, 1)), [".."]);
        EdgeTable::new().spans(&small, &[4], Rule::EvenOdd, IRect::new(IVec2::MAX, IVec2::MIN), |_, _, _| {
            panic!("an empty raster has no spans");
        });
    }

    #[test]
    fn the_table_is_empty_again_for_the_next_area() {
        let mut table = EdgeTable::new();
        let clip = IRect::of_size(9, 9);
        let mut spans = vec![];
        for x in [0.0, 5.0] {
            let square = ring(&[(x, 0.0), (x + 2.0, 0.0), (x + 2.0, 1.0), (x, 1.0)]);
            table.spans(&square, &[4], Rule::EvenOdd, clip, |y, from, to| spans.push((y, from, to)));
        }
        assert_eq!(spans, [(0, 0, 2), (0, 5, 7)]);
    }
}
