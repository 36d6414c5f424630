//! Exact areas, after E. Catmull, "A hidden-surface algorithm with anti-aliasing", SIGGRAPH 1978; kept as signed areas
//! of edges in cells that are summed up along each row, as R. Levien's libart (1998) and FreeType do.

use crate::path::{Rule, ring_edges, subpaths};
use crate::rect::IRect;
use glam::DVec2;

/// Steps of a coordinate in a pixel.
const STEPS: i32 = 256;
/// What makes 1 in fixed-point numbers with 32 binary places.
const FRACTION: f64 = (1_u64 << 32) as f64;
/// A whole pixel: twice the area in steps.
const WHOLE: i32 = 2 * STEPS * STEPS;

/// The area of each pixel of a raster that rings cover.
///
/// All cells are zero between two areas, so that the storage serves windows of any size; keep the value to save
/// allocating.
#[derive(Debug, Default)]
pub struct AreaMask {
    width: usize,
    height: usize,
    /// For each pixel, and one more in each row, by how much more of it is covered than of the one before.
    cells: Vec<i32>,
    /// A bit for each cell that may not be zero.
    touched: Vec<u64>,
    words: usize,
    rows: (usize, usize),
}

impl AreaMask {
    /// A mask without storage.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives how much of the pixels in a window is covered by rings: runs of pixels of one row that are covered
    /// alike (row, first column, one past the last one, parts of 255). Rows come in ascending order, runs from left to
    /// right, pixels that are not covered not at all.
    ///
    /// Where rings overlap inside of a pixel, the areas are added before the rule decides. Vertices that are not
    /// usable are left out. What is covered counts `gain` times, up to the whole pixel.
    pub fn runs(
        &mut self,
        points: &[DVec2],
        ends: &[u32],
        (rule, gain): (Rule, u8),
        window: IRect,
        mut run: impl FnMut(i32, i32, i32, u8),
    ) {
        if window.is_empty() {
            return;
        }
        self.begin(window);
        let (corner, size) = (window.min.as_dvec2(), (window.max - window.min).as_dvec2());
        let far = window.max.as_dvec2();
        // Not all of them if one is no number.
        if points.iter().all(|p| p.x >= corner.x && p.x <= far.x && p.y >= corner.y && p.y <= far.y) {
            self.whole_rings(points, ends, corner);
        } else {
            ring_edges(points, ends, |a, b| self.edge(a - corner, b - corner, size));
        }
        for row in self.rows.0..self.rows.1 {
            let y = window.min.y + row as i32;
            self.sweep(row, (rule, gain), |from, to, covered| {
                run(y, window.min.x + from, window.min.x + to, covered);
            });
        }
    }

    fn begin(&mut self, window: IRect) {
        self.width = (window.max.x - window.min.x) as usize;
        self.height = (window.max.y - window.min.y) as usize;
        self.words = (self.width + 1) / 64 + 1;
        let (cells, words) = ((self.width + 2) * self.height, self.words * self.height);
        if self.cells.len() < cells {
            self.cells.resize(cells, 0);
        }
        if self.touched.len() < words {
            self.touched.resize(words, 0);
        }
        self.rows = (self.height, 0);
    }

    /// Enters all edges of rings inside of the window, whose vertices are rounded once.
    fn whole_rings(&mut self, points: &[DVec2], ends: &[u32], corner: DVec2) {
        for ring in subpaths(points, ends) {
            let Some(&last) = ring.last() else { continue };
            let mut before = fixed(last - corner);
            for &vertex in ring {
                let here = fixed(vertex - corner);
                if before.1 < here.1 {
                    self.line(before, here, 1);
                } else {
                    self.line(here, before, -1);
                }
                before = here;
            }
        }
    }

    /// Enters an edge, cut to the window. What lies left of it counts at its left side, what lies right of it not at all.
    #[inline]
    fn edge(&mut self, a: DVec2, b: DVec2, size: DVec2) {
        // Either way round, an edge has the same cells.
        let (low, high, turn) = if a.y <= b.y { (a, b, 1) } else { (b, a, -1) };
        if low.y >= size.y || high.y <= 0.0 {
            return;
        }
        let inside = |p: DVec2| p.x >= 0.0 && p.x <= size.x && p.y >= 0.0 && p.y <= size.y;
        if inside(low) && inside(high) {
            return self.line(fixed(low), fixed(high), turn);
        }
        let slope = (high.x - low.x) / (high.y - low.y);
        let at = |y: f64| {
            let x = (low.x + (y - low.y) * slope).max(low.x.min(high.x)).min(low.x.max(high.x));
            DVec2::new(x, y)
        };
        let (from, to) = (low.y.max(0.0), high.y.min(size.y));
        let mut stops = [from, to, to, to];
        let crossing = |x: f64| (low.y + (x - low.x) / slope).max(from).min(to);
        if slope != 0.0 {
            let (one, other) = (crossing(0.0), crossing(size.x));
            stops = [from, one.min(other), one.max(other), to];
        }
        for pair in stops.windows(2) {
            if pair[0] < pair[1] {
                let ends = [pair[0], pair[1]].map(at);
                let middle = (ends[0].x + ends[1].x) * 0.5;
                if middle < size.x {
                    let [a, b] = ends.map(|p| fixed(DVec2::new(p.x.max(0.0).min(size.x), p.y)));
                    self.line(a, b, turn);
                }
            }
        }
    }

    /// Enters a line that runs downwards inside of the window, given in steps.
    #[inline]
    fn line(&mut self, (x0, y0): (i32, i32), (x1, y1): (i32, i32), turn: i32) {
        if y0 == y1 {
            return;
        }
        let row = |y: i32| y as usize / STEPS as usize;
        let (first, last) = (row(y0), row(y1 - 1));
        self.rows = (self.rows.0.min(first), self.rows.1.max(last + 1));
        let (run, fall) = (f64::from(x1 - x0), f64::from(y1 - y0));
        // How far down the line goes for each step aside; it leaves a row at once if that is more than a row.
        let within = x0 / STEPS == x1 / STEPS;
        let steepness = if within { 0 } else { ((fall / run.abs()).min(f64::from(STEPS)) * FRACTION) as i64 };
        if first == last {
            return self.piece(first, (x0, x1), (y1 - y0) * turn, steepness);
        }
        let slope = (run / fall * FRACTION) as i64;
        let below = (first as i32 + 1) * STEPS;
        let mut exact = (i64::from(x0) << 32) + i64::from(below - y0) * slope;
        let (mut x, mut rise) = (x0, below - y0);
        for row in first..last {
            let next = (exact >> 32) as i32;
            self.piece(row, (x, next), rise * turn, steepness);
            (x, rise) = (next, STEPS);
            exact += slope * i64::from(STEPS);
        }
        self.piece(last, (x, x1), (y1 - last as i32 * STEPS) * turn, steepness);
    }

    /// Enters the part of a line in one row, which goes down by `rise` steps, and by `steepness` parts of [`FRACTION`]
    /// for each step aside.
    #[inline]
    fn piece(&mut self, row: usize, (x0, x1): (i32, i32), rise: i32, steepness: i64) {
        let (left, right) = if x0 <= x1 { (x0, x1) } else { (x1, x0) };
        let column = |x: i32| x as usize / STEPS as usize;
        let (first, last) = (column(left), column((right - 1).max(left)));
        touch(&mut self.touched[row * self.words..][..self.words], first, last + 1);
        let start = row * (self.width + 2) + first;
        let cells = &mut self.cells[start..start + last - first + 2];
        // What lies right of the middle of the two ends is covered, and all of the next pixel.
        let mut enter = |column: usize, places: i32, rise: i32| {
            cells[column] += rise * (2 * STEPS - places);
            cells[column + 1] += rise * places;
        };
        let base = first as i32 * STEPS;
        let (left, right) = (left - base, right - base);
        if first == last {
            return enter(0, left + right, rise);
        }
        let (whole, sign) = (i64::from(rise.abs()), rise.signum());
        let mut exact = i64::from(STEPS - left) * steepness;
        let (mut x, mut sum) = (left, 0);
        for column in 0..last - first {
            let total = (exact >> 32).min(whole) as i32 * sign;
            enter(column, x + STEPS, total - sum);
            (x, sum) = (0, total);
            exact += i64::from(STEPS) * steepness;
        }
        enter(last - first, x + right - (last - first) as i32 * STEPS, rise - sum);
    }

    /// Sums up a row, gives its runs and empties it.
    fn sweep(&mut self, row: usize, (rule, gain): (Rule, u8), mut run: impl FnMut(i32, i32, u8)) {
        let cells = &mut self.cells[row * (self.width + 2)..][..self.width + 2];
        let touched = &mut self.touched[row * self.words..][..self.words];
        // What is entered right of the window counts for nothing.
        touched[self.width >> 6] &= !(u64::MAX << (self.width & 63));
        touched[(self.width >> 6) + 1..].fill(0);
        let (mut sum, mut covered, mut from) = (0i32, 0, 0);
        for (word, bits) in touched.iter_mut().enumerate() {
            let mut left = std::mem::take(bits);
            while left != 0 {
                let at = word * 64 + left.trailing_zeros() as usize;
                left &= left - 1;
                let now = sum.wrapping_add(std::mem::take(&mut cells[at]));
                if now != sum {
                    sum = now;
                    let part = part_covered(sum, rule, gain);
                    if part != covered {
                        if covered > 0 && from < at {
                            run(from as i32, at as i32, covered);
                        }
                        (covered, from) = (part, at);
                    }
                }
            }
        }
        if covered > 0 && from < self.width {
            run(from as i32, self.width as i32, covered);
        }
        cells[self.width..].fill(0);
    }
}

/// Sets the bits of cells, the last one included.
#[inline]
fn touch(touched: &mut [u64], first: usize, last: usize) {
    let (from, to) = (u64::MAX << (first & 63), u64::MAX >> (63 - (last & 63)));
    let (one, other) = (first >> 6, last >> 6);
    if one == other {
        touched[one] |= from & to;
    } else {
        touched[one] |= from;
        touched[one + 1..other].fill(u64::MAX);
        touched[other] |= to;
    }
}

/// A point inside of the window in whole steps.
#[inline]
fn fixed(p: DVec2) -> (i32, i32) {
    let steps = |at: f64| (at * f64::from(STEPS) + 0.5) as i32;
    (steps(p.x), steps(p.y))
}

/// How many of 255 parts of a pixel are covered where areas add up to `sum` and count `gain` times.
#[inline]
fn part_covered(sum: i32, rule: Rule, gain: u8) -> u8 {
    let area = sum.unsigned_abs();
    let whole = WHOLE as u32;
    let area = match rule {
        Rule::NonZero => area.min(whole),
        Rule::EvenOdd => {
            let twice = area % (2 * whole);
            twice.min(2 * whole - twice)
        }
    };
    let area = (area * u32::from(gain)).min(whole);
    ((area * 255 + whole / 2) / whole) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::contains;
    use crate::xorshift::Xorshift;
    use glam::IVec2;

    /// The parts of 255 of every pixel of a window, row by row.
    fn parts(points: &[DVec2], ends: &[u32], rule: Rule, window: IRect) -> Vec<Vec<u8>> {
        let side = window.max - window.min;
        let mut rows = vec![vec![0; side.x as usize]; side.y as usize];
        let mut last = (i32::MIN, 0);
        AreaMask::new().runs(points, ends, (rule, 1), window, |y, from, to, covered| {
            assert!(from < to && (y, from) >= last && covered > 0, "out of order, overlapping or nothing");
            last = (y, to);
            let row = &mut rows[(y - window.min.y) as usize];
            row[(from - window.min.x) as usize..(to - window.min.x) as usize].fill(covered);
        });
        rows
    }

    fn ring(points: &[(f64, f64)]) -> Vec<DVec2> {
        points.iter().map(|&p| p.into()).collect()
    }

    #[test]
    fn a_square_and_a_triangle_by_their_areas() {
        let square = ring(&[(0.5, 0.25), (3.0, 0.25), (3.0, 2.0), (0.5, 2.0)]);
        let found = parts(&square, &[4], Rule::EvenOdd, IRect::of_size(4, 3));
        assert_eq!(found, [[96, 191, 191, 0], [128, 255, 255, 0], [0, 0, 0, 0]]);
        let triangle = ring(&[(0.0, 0.0), (4.0, 0.0), (0.0, 2.0)]);
        let found = parts(&triangle, &[3], Rule::NonZero, IRect::of_size(4, 2));
        assert_eq!(found, [[255, 255, 191, 64], [191, 64, 0, 0]]);
    }

    #[test]
    fn gain_fills_pixels_that_are_half_covered() {
        let square = ring(&[(0.5, 0.25), (3.0, 0.25), (3.0, 1.25), (0.5, 1.25)]);
        let mut found = Vec::new();
        let window = IRect::of_size(4, 2);
        AreaMask::new().runs(&square, &[4], (Rule::EvenOdd, 2), window, |y, from, to, covered| {
            found.push((y, from, to, covered));
        });
        assert_eq!(found, [(0, 0, 1, 191), (0, 1, 3, 255), (1, 0, 1, 64), (1, 1, 3, 128)]);
    }

    #[test]
    fn rules_differ_where_rings_overlap() {
        let mut rings = ring(&[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)]);
        rings.extend(ring(&[(1.0, 0.0), (2.5, 0.0), (2.5, 1.0), (1.0, 1.0)]));
        let row = |rule| parts(&rings, &[4, 8], rule, IRect::of_size(4, 1)).concat();
        assert_eq!(row(Rule::NonZero), [255; 4]);
        assert_eq!(row(Rule::EvenOdd), [255, 0, 128, 255]);
    }

    #[test]
    fn agrees_with_many_samples() {
        let mut random = Xorshift::new(50);
        for round in 0..40 {
            let window = IRect::new(random.grid(-4, 4), random.grid(5, 14));
            let far = if round % 2 == 0 { 18.0 } else { 400.0 };
            let triangle = [0; 3].map(|_| random.point(-far, far));
            let found = parts(&triangle, &[3], Rule::EvenOdd, window);
            for (y, row) in (window.min.y..).zip(&found) {
                for (x, &part) in (window.min.x..).zip(row) {
                    let inside = (0..400)
                        .filter(|i| {
                            let within = DVec2::new(f64::from(i % 20) + 0.5, f64::from(i / 20) + 0.5) / 20.0;
                            contains(&triangle, &[3], Rule::EvenOdd, IVec2::new(x, y).as_dvec2() + within)
                        })
                        .count();
                    let expected = inside as f64 * 255.0 / 400.0;
                    assert!(
                        (f64::from(part) - expected).abs() < 9.0,
                        "{triangle:?} {x} {y}: {part} {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn neighbours_make_up_the_whole() {
        let mut random = Xorshift::new(51);
        let corners = ring(&[(-1.0, 0.0), (11.0, 0.0), (11.0, 9.0), (-1.0, 9.0)]);
        for _ in 0..100 {
            let middle = random.point(0.0, 9.0);
            let mut sums = vec![0u32; 81];
            for i in 0..4 {
                let triangle = [corners[i], corners[(i + 1) % 4], middle];
                for (sum, part) in
                    sums.iter_mut().zip(parts(&triangle, &[3], Rule::NonZero, IRect::of_size(9, 9)).concat())
                {
                    *sum += u32::from(part);
                }
            }
            assert!(sums.iter().all(|sum| (253..=257).contains(sum)), "{middle}: {sums:?}");
        }
    }

    #[test]
    fn huge_and_bad_coordinates_and_the_next_area() {
        let mut mask = AreaMask::new();
        let far = 1e150;
        let all = ring(&[(-far, -far), (far, -far), (f64::NAN, 0.0), (far, far), (-far, far)]);
        for (width, height) in [(3, 2), (200, 3), (1, 1), (64, 2), (127, 2)] {
            let mut area = 0;
            mask.runs(
                &all,
                &[5],
                (Rule::EvenOdd, 1),
                IRect::of_size(width, height),
                |_, from, to, covered| {
                    area += (to - from) * i32::from(covered);
                },
            );
            assert_eq!(area, width * height * 255);
        }
        mask.runs(&all, &[5], (Rule::EvenOdd, 1), IRect::default(), |_, _, _, _| {
            panic!("an empty window has no runs")
        });
        let right = ring(&[(3.0, 0.0), (9.0, 0.0), (9.0, 2.0), (3.0, 2.0)]);
        mask.runs(&right, &[4], (Rule::EvenOdd, 1), IRect::of_size(3, 2), |_, _, _, _| {
            panic!("all lies outside")
        });
    }
}
