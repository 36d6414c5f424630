//! Exact areas, after E. Catmull, "A hidden-surface algorithm with anti-aliasing", SIGGRAPH 1978; kept as signed areas
//! of edges in cells that are summed up along each row, as R. Levien's libart (1998) and FreeType do.

use super::group::{GROUP, covered, parts};
use crate::path::{Rule, ring_edges, subpaths};
use crate::rect::IRect;
use glam::DVec2;
use std::ops::Range;

/// The binary places of a coordinate.
const PLACES: u32 = 8;
/// Steps of a coordinate in a pixel.
const STEPS: i32 = 1 << PLACES;
/// What makes 1 in fixed-point numbers with 32 binary places.
const FRACTION: f64 = (1_u64 << 32) as f64;
/// A whole pixel: twice the area in steps.
pub(super) const WHOLE: i32 = 2 * STEPS * STEPS;
/// What makes a product the quotient of a number up to the square of [`STEPS`] by one up to `STEPS`, with 32 binary places.
const RECIPROCALS: [u64; 2 * STEPS as usize] = {
    let mut table = [0; 2 * STEPS as usize];
    let mut divisor = 1;
    while divisor < table.len() {
        table[divisor] = (1 << 32) / divisor as u64 + 1;
        divisor += 1;
    }
    table
};

/// How many times what is covered of a pixel counts, up to the whole pixel.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Gain {
    /// As it is.
    One,
    /// Twice: pixels that are half covered are covered.
    Double,
}

/// How much of neighbouring pixels of a row is covered, in parts of 255.
#[derive(Copy, Clone, Debug)]
pub enum Cover<'a> {
    /// So many pixels are covered alike, by more than nothing.
    Alike(usize, u8),
    /// The parts of each of them, eight except at the end of a row.
    Each(&'a [u8]),
}

impl Cover<'_> {
    /// The parts of one pixel after the other.
    pub fn parts(&self) -> impl Iterator<Item = u8> {
        let (count, alike, each) = match *self {
            Cover::Alike(count, part) => (count, part, [].as_slice()),
            Cover::Each(parts) => (0, 0, parts),
        };
        std::iter::repeat_n(alike, count).chain(each.iter().copied())
    }
}

/// The area of each pixel of a raster that rings cover.
///
/// All cells are zero between two areas, so that the storage serves windows of any size; keep the value to save
/// allocating.
#[derive(Debug, Default)]
pub struct AreaMask {
    width: usize,
    height: usize,
    /// For each pixel, and a few more in each row, by how much more of it is covered than of the one before.
    cells: Vec<i32>,
    /// The cells of a row, which are whole groups.
    stride: usize,
    /// For each row, a bit for each section of it whose cells may not all be zero.
    touched: Vec<u64>,
    /// The binary logarithm of the cells of a section.
    section: u32,
    rows: (usize, usize),
}

impl AreaMask {
    /// A mask without storage.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives how much of the pixels in a window is covered by rings: the row, the first column, and what is covered from
    /// there on. Rows come in ascending order, pixels from left to right, those left out are not covered.
    ///
    /// Where rings overlap inside of a pixel, the areas are added before the rule decides. Vertices that are not
    /// usable are left out. What is covered counts `gain` times, up to the whole pixel.
    pub fn cover(
        &mut self,
        points: &[DVec2],
        ends: &[u32],
        look: (Rule, Gain),
        window: IRect,
        mut put: impl FnMut(i32, i32, Cover<'_>),
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
            self.sweep(row, look, |column, cover| put(y, window.min.x + column as i32, cover));
        }
    }

    fn begin(&mut self, window: IRect) {
        self.width = (window.max.x - window.min.x) as usize;
        self.height = (window.max.y - window.min.y) as usize;
        // An edge at the right side of the window enters three cells behind it.
        self.stride = (self.width + 3).next_multiple_of(GROUP);
        let section = self.stride.div_ceil(u64::BITS as usize).next_power_of_two().max(GROUP);
        self.section = section.trailing_zeros();
        if self.cells.len() < self.stride * self.height {
            self.cells.resize(self.stride * self.height, 0);
        }
        if self.touched.len() < self.height {
            self.touched.resize(self.height, 0);
        }
        self.rows = (self.height, 0);
    }

    /// Enters all edges of rings inside of the window, whose vertices are rounded once.
    fn whole_rings(&mut self, points: &[DVec2], ends: &[u32], corner: DVec2) {
        for ring in subpaths(points, ends) {
            let Some(&last) = ring.last() else { continue };
            let mut before = fixed(last - corner);
            let mut heights = (before.1, before.1);
            for &vertex in ring {
                let here = fixed(vertex - corner);
                let (run, fall) = (here.0 - before.0, here.1 - before.1);
                if run.abs() <= STEPS && fall.abs() <= STEPS {
                    self.short_line(before, here);
                } else if fall > 0 {
                    self.line(before, here, 1);
                } else {
                    self.line(here, before, -1);
                }
                before = here;
                heights = (heights.0.min(here.1), heights.1.max(here.1));
            }
            if heights.0 < heights.1 {
                let (first, last) = ((heights.0 >> PLACES) as usize, ((heights.1 - 1) >> PLACES) as usize);
                self.rows = (self.rows.0.min(first), self.rows.1.max(last + 1));
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
        let slope = (run / fall * FRACTION) as i64;
        let mut exact = (i64::from(x0) << 32) + i64::from((first as i32 + 1) * STEPS - y0) * slope;
        let (mut x, mut y) = (x0, y0);
        for row in first..=last {
            let below = (row as i32 + 1) * STEPS;
            let (next_x, next_y) = if row == last { (x1, y1) } else { ((exact >> 32) as i32, below) };
            self.piece(row, (x, next_x), (next_y - y) * turn, steepness);
            (x, y) = (next_x, next_y);
            exact += slope * i64::from(STEPS);
        }
    }

    /// Enters a line inside of the window that goes down or up by no more than a pixel, and no more than that aside: what
    /// processors foretell badly, in which of its two rows and columns it lies, decides no branch.
    #[inline]
    fn short_line(&mut self, a: (i32, i32), b: (i32, i32)) {
        if a.1 == b.1 {
            return;
        }
        let is_down = a.1 < b.1;
        let ((x0, y0), (x1, y1)) = if is_down { (a, b) } else { (b, a) };
        let turn = if is_down { 1 } else { -1 };
        let (run, fall) = (x1.abs_diff(x0), y1.abs_diff(y0));
        let (first, last) = (y0 >> PLACES, (y1 - 1) >> PLACES);
        // Where it goes on to the next row, or its end; what lies beyond has then no height.
        let y = y1.min((first + 1) << PLACES);
        let aside = quotient(y.abs_diff(y0) * run, fall) as i32;
        let x = if x0 <= x1 { x0 + aside } else { x0 - aside };
        for (row, (from, to), rise) in [(first, (x0, x), y - y0), (last, (x, x1), y1 - y)] {
            let beyond = |across: i32| (quotient(across as u32 * fall, run) as i32).min(rise) * turn;
            self.two_cells(row as usize, (from.min(to), from.max(to)), rise * turn, beyond);
        }
    }

    /// Enters the part of a line in one row that reaches no farther than into the next column; `beyond` tells how far it goes
    /// down while it goes so many steps aside there.
    #[inline(always)]
    fn two_cells(
        &mut self,
        row: usize,
        (left, right): (i32, i32),
        rise: i32,
        beyond: impl FnOnce(i32) -> i32,
    ) {
        let column = left >> PLACES;
        let (left, right) = (left & (STEPS - 1), right - (column << PLACES));
        let across = right - STEPS;
        let beyond = beyond(across.max(0));
        let (here, places) = (rise - beyond, left + right.min(STEPS));
        let column = column as usize;
        self.touch(row, column, column + 2);
        let start = row * self.stride + column;
        // What lies right of the middle of the two ends is covered, and all of the next pixel.
        if let Some([one, two, three]) = self.cells.get_mut(start..start + 3) {
            *one += here * (2 * STEPS - places);
            *two += here * places + beyond * (2 * STEPS - across);
            *three += beyond * across;
        }
    }

    /// Notes in which sections of a row cells may not be zero from now on.
    #[inline]
    fn touch(&mut self, row: usize, first: usize, last: usize) {
        let (from, to) = (first >> self.section, last >> self.section);
        self.touched[row] |= u64::MAX << from & u64::MAX >> (63 - to);
    }

    /// Enters the part of a line in one row, which goes down by `rise` steps, and by `steepness` parts of [`FRACTION`]
    /// for each step aside.
    #[inline]
    fn piece(&mut self, row: usize, (x0, x1): (i32, i32), rise: i32, steepness: i64) {
        let (left, right) = if x0 <= x1 { (x0, x1) } else { (x1, x0) };
        let (whole, sign) = (i64::from(rise.abs()), rise.signum());
        if right - left <= STEPS {
            let beyond = |across: i32| ((i64::from(across) * steepness) >> 32).min(whole) as i32 * sign;
            self.two_cells(row, (left, right), rise, beyond);
        } else {
            self.many_cells(row, (left, right), rise, steepness);
        }
    }

    /// The same for a part that reaches farther. Inlined it would take the registers of what is done most.
    #[inline(never)]
    fn many_cells(&mut self, row: usize, (left, right): (i32, i32), rise: i32, steepness: i64) {
        let (whole, sign) = (i64::from(rise.abs()), rise.signum());
        let column = |x: i32| x as usize / STEPS as usize;
        let (first, last) = (column(left), column(right - 1));
        self.touch(row, first, last + 1);
        let start = row * self.stride + first;
        let cells = &mut self.cells[start..start + last - first + 2];
        let base = first as i32 * STEPS;
        let (left, right) = (left - base, right - base);
        let (inner, end) = cells.split_at_mut(last - first);
        let mut exact = i64::from(STEPS - left) * steepness;
        // Of what goes down in a column, the part that lies right of the line counts in the next one, too.
        let (mut places, mut sum, mut rest) = (left + STEPS, 0, 0);
        for cell in inner {
            let total = (exact >> 32).min(whole) as i32 * sign;
            let here = total - sum;
            *cell += rest + here * (2 * STEPS - places);
            (rest, places, sum) = (here * places, STEPS, total);
            exact += i64::from(STEPS) * steepness;
        }
        if let [one, two] = end {
            let (here, places) = (rise - sum, right - (last - first) as i32 * STEPS);
            *one += rest + here * (2 * STEPS - places);
            *two += here * places;
        }
    }

    /// Sums up a row, gives what is covered of it and empties it.
    fn sweep(&mut self, row: usize, look: (Rule, Gain), mut put: impl FnMut(usize, Cover<'_>)) {
        let (groups, _) = self.cells[row * self.stride..][..self.stride].as_chunks_mut::<GROUP>();
        let groups_in_section = 1 << (self.section - GROUP.trailing_zeros());
        let mut touched = std::mem::take(&mut self.touched[row]);
        let (mut sum, mut done) = (0i32, 0);
        while touched != 0 {
            let first = touched.trailing_zeros() as usize * groups_in_section;
            touched &= touched - 1;
            for (group, cells) in groups.iter_mut().enumerate().skip(first).take(groups_in_section) {
                let start = group * GROUP;
                if start > done {
                    alike(sum, look, done..start.min(self.width), &mut put);
                }
                done = start + GROUP;
                let parts = covered(std::mem::take(cells), &mut sum, look);
                if start < self.width && parts != [0; GROUP] {
                    put(start, Cover::Each(&parts[..GROUP.min(self.width - start)]));
                }
            }
        }
        alike(sum, look, done..self.width, &mut put);
    }
}

/// Gives pixels that are covered alike, if they are.
#[inline]
fn alike(sum: i32, look: (Rule, Gain), columns: Range<usize>, put: &mut impl FnMut(usize, Cover<'_>)) {
    let [part] = parts([sum], look);
    if part > 0 && !columns.is_empty() {
        put(columns.start, Cover::Alike(columns.len(), part));
    }
}

/// A point inside of the window in whole steps.
#[inline]
fn fixed(p: DVec2) -> (i32, i32) {
    /// Added to a number it leaves no room for a fraction, and its whole part in the last bits.
    const NO_FRACTION: f64 = 1.5 * (1_u64 << 52) as f64;
    let steps = |at: f64| (at * f64::from(STEPS) + NO_FRACTION).to_bits() as i32;
    (steps(p.x), steps(p.y))
}

/// The quotient, rounded down, of a number up to the square of [`STEPS`] by one from 1 to `STEPS`.
#[inline]
fn quotient(number: u32, divisor: u32) -> u32 {
    ((u64::from(number) * RECIPROCALS[divisor as usize % RECIPROCALS.len()]) >> 32) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::contains;
    use crate::xorshift::Xorshift;
    use glam::IVec2;

    /// The parts of 255 of every pixel of a window, row by row.
    fn parts(points: &[DVec2], ends: &[u32], rule: Rule, window: IRect) -> Vec<Vec<u8>> {
        parts_with(points, ends, (rule, Gain::One), window)
    }

    fn parts_with(points: &[DVec2], ends: &[u32], (rule, gain): (Rule, Gain), window: IRect) -> Vec<Vec<u8>> {
        let side = window.max - window.min;
        let mut rows = vec![vec![0; side.x as usize]; side.y as usize];
        let mut last = (i32::MIN, 0);
        AreaMask::new().cover(points, ends, (rule, gain), window, |y, from, cover| {
            assert!((y, from) >= last, "out of order or overlapping");
            let row = &mut rows[(y - window.min.y) as usize][(from - window.min.x) as usize..];
            last = match cover {
                Cover::Alike(count, part) => {
                    assert!(count > 0 && part > 0, "nothing");
                    row[..count].fill(part);
                    (y, from + count as i32)
                }
                Cover::Each(parts) => {
                    row[..parts.len()].copy_from_slice(parts);
                    (y, from + parts.len() as i32)
                }
            };
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
        let found = parts_with(&square, &[4], (Rule::EvenOdd, Gain::Double), IRect::of_size(4, 2));
        assert_eq!(found, [[191, 255, 255, 0], [64, 128, 128, 0]]);
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
    fn short_lines_cover_what_others_do() {
        let mut random = Xorshift::new(52);
        let window = IRect::of_size(3, 3);
        let size = DVec2::splat(3.0);
        // A ring right of the window covers nothing there; lines are cut to the window because of it, and not looked at
        // for being short.
        let beside = ring(&[(4.0, 0.0), (5.0, 0.0), (5.0, 3.0)]);
        let mut covered = 0;
        for round in 0..3000 {
            // Many corners lie on the borders of pixels, and some on those of the window.
            let snap = |p: DVec2| if round % 3 == 0 { p } else { (p * 4.0).round() / 4.0 };
            let middle = random.point(0.0, 3.0);
            let triangle = [0; 3].map(|_| snap((middle + random.point(-0.5, 0.5)).clamp(DVec2::ZERO, size)));
            let short = parts(&triangle, &[3], Rule::NonZero, window).concat();
            let [a, b, c] = triangle;
            assert_eq!(short, parts(&[c, b, a], &[3], Rule::NonZero, window).concat(), "{triangle:?}");
            let rings = [triangle.as_slice(), &beside].concat();
            let long = parts(&rings, &[3, 6], Rule::NonZero, window).concat();
            for (a, b) in short.iter().zip(&long) {
                assert!(a.abs_diff(*b) <= 2, "{triangle:?}: {short:?} {long:?}");
            }
            covered += usize::from(short.iter().any(|&part| part > 0));
        }
        assert!(covered > 2000, "{covered}");
    }

    #[test]
    fn huge_and_bad_coordinates_and_the_next_area() {
        let mut mask = AreaMask::new();
        let even_odd = (Rule::EvenOdd, Gain::One);
        let far = 1e150;
        let all = ring(&[(-far, -far), (far, -far), (f64::NAN, 0.0), (far, far), (-far, far)]);
        for (width, height) in [(3, 2), (200, 3), (1, 1), (64, 2), (127, 2), (5000, 1), (6, 4)] {
            let mut area = 0;
            mask.cover(&all, &[5], even_odd, IRect::of_size(width, height), |_, _, cover| {
                area += match cover {
                    Cover::Alike(count, part) => count as i32 * i32::from(part),
                    Cover::Each(parts) => parts.iter().map(|&part| i32::from(part)).sum(),
                };
            });
            assert_eq!(area, width * height * 255);
        }
        mask.cover(&all, &[5], even_odd, IRect::default(), |_, _, _| {
            panic!("an empty window is not covered")
        });
        let right = ring(&[(3.0, 0.0), (9.0, 0.0), (9.0, 2.0), (3.0, 2.0)]);
        mask.cover(&right, &[4], even_odd, IRect::of_size(3, 2), |_, _, cover| {
            assert!(cover.parts().all(|part| part == 0), "all lies outside");
        });
    }
}
