//! L. Carpenter, "The A-buffer, an antialiased hidden surface method", SIGGRAPH 1984: coverage as one bit for each of
//! the sample points of a pixel, here 8 by 8 in a word of 64 bits.

use crate::rect::IRect;
use glam::DVec2;
use std::ops::Range;

/// The number of sample points of a pixel.
pub const SAMPLES: u32 = 64;

/// Sample rows in a pixel, and sample columns.
pub const SIDE: f64 = 8.0;
/// The first sample of each sample row of a pixel; times a byte, it is that byte in every row.
const EACH_ROW: u64 = 0x0101_0101_0101_0101;
/// The fixed point numbers in which edges are followed.
const ONE: f64 = (1u64 << 32) as f64;
/// Coordinates are brought this near in pixels before they become fixed point numbers.
const FARTHEST: f64 = (1 << 26) as f64;

/// The samples of a raster that lie in the union of convex polygons.
///
/// Byte *j* of a word is sample row *j* of a pixel from the top, its bit *i* sample *i* of that row from the left. All
/// words are zero between two shapes, so that the storage serves windows of any size; keep the value to save allocating.
///
/// Which samples of a row a polygon has does not depend on where the window begins or ends below row 0: a raster may be
/// drawn in bands.
#[derive(Debug, Default)]
pub struct SampleMask {
    window: IRect,
    stride: usize,
    bits: Vec<u64>,
    /// The columns of each row in which there may be samples.
    spans: Vec<(u32, u32)>,
    /// The rows in which there may be samples.
    rows: (usize, usize),
}

/// The edges of a convex polygon from its top to its bottom on one side.
struct Chain<'a> {
    ring: &'a [DVec2],
    at: usize,
    forward: bool,
    /// Where the edge meets the sample row, half a sample to the right, in fixed point samples.
    x: i64,
    slope: i64,
    /// The first sample row in which the edge is followed; it may lie above the window.
    begin: i32,
    /// The first sample row that the edge does not meet any more.
    end: i32,
}

/// The first sample row at or below an ordinate given in samples.
#[inline]
fn sample_row(y: f64) -> i32 {
    (y + 0.5) as i32
}

impl Chain<'_> {
    /// Where the edge meets a sample row, if `x` is where it meets another.
    #[inline]
    fn meets(&self, row: i32, other: i32) -> i64 {
        self.x.wrapping_add(self.slope.wrapping_mul(i64::from(row) - i64::from(other)))
    }

    /// Goes on to the edge that meets a sample row; false if there is none.
    #[inline]
    fn reach(&mut self, row: i32, corner: DVec2) -> bool {
        // Edges are followed from where they begin, but not from above row 0.
        let first = corner.y.min(0.0);
        let count = self.ring.len();
        for _ in 0..count {
            let next = match self.forward {
                true if self.at + 1 == count => 0,
                true => self.at + 1,
                false if self.at == 0 => count - 1,
                false => self.at - 1,
            };
            let (a, b) = (self.ring[self.at], self.ring[next]);
            self.at = next;
            self.end = sample_row((b.y - corner.y) * SIDE);
            if self.end > row {
                let slope = (b.x - a.x) / (b.y - a.y);
                let above = ((corner.y - first) * SIDE) as i32;
                self.begin = sample_row((a.y.max(first) - first) * SIDE) - above;
                let y = (f64::from(self.begin) + 0.5) / SIDE + corner.y;
                let x = (a.x + (y - a.y) * slope).max(a.x.min(b.x)).min(a.x.max(b.x));
                self.slope = (slope * ONE) as i64;
                self.x = (((x - corner.x) * SIDE + 0.5) * ONE) as i64;
                self.x = self.meets(row, self.begin);
                return true;
            }
        }
        false
    }
}

impl SampleMask {
    /// A mask without storage.
    pub fn new() -> Self {
        Self::default()
    }

    /// Begins a shape of which only the pixels in a window matter.
    pub fn begin(&mut self, window: IRect) {
        self.clear();
        let (width, height) = if window.is_empty() {
            (0, 0)
        } else {
            (window.max.x.abs_diff(window.min.x) as usize, window.max.y.abs_diff(window.min.y) as usize)
        };
        self.window = window;
        self.stride = width;
        if self.bits.len() < width * height {
            // All bits are clear; fresh memory costs nothing where it is not touched.
            self.bits = vec![0; width * height];
        }
        self.spans.clear();
        self.spans.resize(height, (u32::MAX, 0));
        self.rows = (height, 0);
    }

    fn clear(&mut self) {
        for row in self.rows.0..self.rows.1 {
            let (from, to) = self.spans[row];
            if from < to {
                self.bits[row * self.stride..][from as usize..to as usize].fill(0);
            }
        }
        self.rows = (0, 0);
    }

    /// Adds the samples inside of a convex polygon, whichever way round. A sample on an edge belongs to one of two
    /// polygons with that edge in common. Vertices must be numbers; those far from the window are brought nearer.
    pub fn polygon(&mut self, ring: &[DVec2]) {
        let Some(&first) = ring.first() else { return };
        let (mut low, mut high, mut top) = (first, first, 0);
        for (i, &p) in ring.iter().enumerate() {
            if p.y < low.y {
                top = i;
            }
            (low, high) = (low.min(p), high.max(p));
        }
        let (min, max) = (self.window.min.as_dvec2(), self.window.max.as_dvec2());
        if !(low.x < max.x && low.y < max.y && high.x > min.x && high.y > min.y) {
            return;
        }
        if low.min_element() < -FARTHEST || high.max_element() > FARTHEST {
            return self.far(ring);
        }
        let height = (self.spans.len() * SIDE as usize) as i32;
        let mut row = sample_row(((low.y - min.y) * SIDE).max(0.0));
        let last = sample_row((high.y - min.y) * SIDE).min(height);
        let chain = |forward| Chain { ring, at: top, forward, x: 0, slope: 0, begin: row, end: row };
        let (mut a, mut b) = (chain(true), chain(false));
        while row < last {
            if a.end <= row && !a.reach(row, min) || b.end <= row && !b.reach(row, min) {
                break;
            }
            let (from, end) = (a.begin.max(b.begin), a.end.min(b.end));
            let to = end.min(last);
            // They may meet in the first or in the last row that they share, but not in both.
            let both_ends = |c: &Chain<'_>| (c.meets(from, row) >> 1) + (c.meets(end - 1, row) >> 1);
            if both_ends(&a) <= both_ends(&b) {
                self.trapezoid(row, to, (&mut a.x, a.slope), (&mut b.x, b.slope));
            } else {
                self.trapezoid(row, to, (&mut b.x, b.slope), (&mut a.x, a.slope));
            }
            row = to;
        }
    }

    /// Adds all samples of pixels of a row of the window, from one to before another.
    pub fn pixels(&mut self, row: i32, from: i32, to: i32) {
        let (corner, end) = (self.window.min, self.window.max);
        let (from, to) = (from.max(corner.x), to.min(end.x));
        if row < corner.y || row >= end.y || from >= to {
            return;
        }
        let row = (row - corner.y) as usize;
        let (from, to) = ((from - corner.x) as u32, (to - corner.x) as u32);
        self.bits[row * self.stride..][from as usize..to as usize].fill(u64::MAX);
        let span = &mut self.spans[row];
        *span = (span.0.min(from), span.1.max(to));
        self.rows = (self.rows.0.min(row), self.rows.1.max(row + 1));
    }

    /// The sample rows of the window, counted from the top of the raster.
    #[inline]
    pub(super) fn window_rows(&self) -> Range<i64> {
        i64::from(self.window.min.y) * SIDE as i64..i64::from(self.window.max.y) * SIDE as i64
    }

    /// Notes that there may be samples in some sample rows and columns of the raster; false if none of them is in the window.
    /// The rows lie in the window.
    #[inline]
    pub(super) fn widen(&mut self, rows: Range<i64>, columns: Range<i64>) -> bool {
        let columns = self.columns_within(columns);
        if rows.is_empty() || columns.is_empty() {
            return false;
        }
        let top = self.window_rows().start;
        let (first, last) = ((rows.start - top) as usize >> 3, (rows.end - top + 7) as usize >> 3);
        for span in &mut self.spans[first..last] {
            *span = (span.0.min(columns.start >> 3), span.1.max((columns.end + 7) >> 3));
        }
        self.rows = (self.rows.0.min(first), self.rows.1.max(last));
        true
    }

    /// Adds all samples of some sample rows and columns of the raster, for which [`SampleMask::widen`] was called.
    #[inline]
    pub(super) fn add_rows(&mut self, rows: Range<i64>, columns: Range<i64>) {
        let columns = self.columns_within(columns);
        let top = self.window_rows().start;
        let mut at = rows.start;
        while at < rows.end {
            let (row, within) = ((at - top) as usize >> 3, (at - top) & 7);
            let count = (8 - within).min(rows.end - at);
            let chosen = (EACH_ROW >> (8 * (8 - count))) << (8 * within);
            add(&mut self.bits[row * self.stride..][..self.stride], columns.start, columns.end, chosen);
            at += count;
        }
    }

    /// The sample columns in the window, counted from its left side.
    #[inline]
    fn columns_within(&self, columns: Range<i64>) -> Range<u32> {
        let left = i64::from(self.window.min.x) * SIDE as i64;
        let within = |column: i64| (column - left).clamp(0, self.stride as i64 * 8) as u32;
        within(columns.start)..within(columns.end)
    }

    /// Adds a polygon some of whose vertices are far away, after what is far is cut off.
    #[cold]
    fn far(&mut self, ring: &[DVec2]) {
        let (mut points, mut ends) = (Vec::new(), Vec::new());
        let near = (DVec2::splat(-FARTHEST), DVec2::splat(FARTHEST));
        crate::clip::sutherland_hodgman(near, ring, &mut points, &mut ends);
        for ring in crate::path::subpaths(&points, &ends) {
            self.polygon(ring);
        }
    }

    /// Adds the samples of sample rows between two edges.
    fn trapezoid(&mut self, from: i32, to: i32, left: (&mut i64, i64), right: (&mut i64, i64)) {
        let ((left, left_step), (right, right_step)) = (left, right);
        let limit = (self.stride as i64) * 8;
        let column = |x: i64| (x >> 32).clamp(0, limit) as u32;
        let mut at = from;
        while at < to {
            let within = at & 7;
            let count = (8 - within).min(to - at);
            let row = (at >> 3) as usize;
            let steps = i64::from(count - 1);
            let (s, e) = (column(*left), column(*right));
            let last_s = column(left.wrapping_add(left_step.wrapping_mul(steps)));
            let last_e = column(right.wrapping_add(right_step.wrapping_mul(steps)));
            let (low, high) = (s.min(last_s), e.max(last_e));
            if low < high {
                let line = &mut self.bits[row * self.stride..][..self.stride];
                let span = &mut self.spans[row];
                *span = (span.0.min(low >> 3), span.1.max((high + 7) >> 3));
                if s == last_s && e == last_e {
                    let rows = (EACH_ROW >> (8 * (8 - count))) << (8 * within);
                    add(line, s, e, rows);
                } else {
                    let (mut x, mut y) = (*left, *right);
                    for k in within..within + count {
                        add(line, column(x), column(y), 1 << (8 * k));
                        x = x.wrapping_add(left_step);
                        y = y.wrapping_add(right_step);
                    }
                }
            }
            *left = left.wrapping_add(left_step.wrapping_mul(steps + 1));
            *right = right.wrapping_add(right_step.wrapping_mul(steps + 1));
            at += count;
        }
        self.rows = (self.rows.0.min((from >> 3) as usize), self.rows.1.max(((to + 7) >> 3) as usize));
    }

    /// Gives the words of each row in which there may be samples (row, first column, words) and empties the mask.
    pub fn drain(&mut self, mut give: impl FnMut(i32, i32, &[u64])) {
        for row in self.rows.0..self.rows.1 {
            let (from, to) = self.spans[row];
            if from < to {
                let words = &mut self.bits[row * self.stride..][from as usize..to as usize];
                let corner = self.window.min;
                give(corner.y.wrapping_add(row as i32), corner.x.wrapping_add_unsigned(from), words);
                words.fill(0);
            }
        }
        self.rows = (0, 0);
        self.spans.clear();
        self.stride = 0;
        self.window = IRect::default();
    }
}

/// Adds samples from one to before another in the sample rows chosen.
#[inline]
fn add(line: &mut [u64], from: u32, to: u32, rows: u64) {
    if from >= to {
        return;
    }
    let (p, q) = ((from >> 3) as usize, ((to - 1) >> 3) as usize);
    let first = (0xFF << (from & 7)) & 0xFF;
    let last = 0xFF >> (7 - ((to - 1) & 7));
    if p == q {
        line[p] |= (first & last) * rows;
    } else {
        let line = &mut line[p..=q];
        line[0] |= first * rows;
        line[q - p] |= last * rows;
        for word in &mut line[1..q - p] {
            *word |= 0xFF * rows;
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::path::Rule;
    use crate::polygon::contains;
    use crate::xorshift::Xorshift;
    use glam::IVec2;
    use std::collections::BTreeMap;

    /// The words of a mask that are not zero, by column and row.
    pub(in super::super) fn words(mask: &mut SampleMask) -> BTreeMap<(i32, i32), u64> {
        let mut found = BTreeMap::new();
        mask.drain(|row, column, words| {
            let all = (column..).zip(words).map(|(column, &word)| ((column, row), word));
            found.extend(all.filter(|(_, word)| *word != 0));
        });
        found
    }

    fn samples(mask: &mut SampleMask) -> u32 {
        words(mask).values().map(|word| word.count_ones()).sum()
    }

    fn ring(points: &[(f64, f64)]) -> Vec<DVec2> {
        points.iter().map(|&p| p.into()).collect()
    }

    #[test]
    fn a_quarter_of_a_pixel_is_sixteen_samples() {
        let mut mask = SampleMask::new();
        mask.begin(IRect::of_size(3, 2));
        mask.polygon(&ring(&[(1.5, 0.0), (2.0, 0.0), (2.0, 0.5), (1.5, 0.5)]));
        assert_eq!(words(&mut mask), BTreeMap::from([((1, 0), 0xF0F0_F0F0)]));
        mask.begin(IRect::of_size(3, 2));
        mask.polygon(&ring(&[(0.0, 0.0), (0.0, 1.0), (3.0, 1.0), (3.0, 0.0)]));
        mask.pixels(1, -5, 1);
        let all = u64::MAX;
        assert_eq!(
            words(&mut mask),
            BTreeMap::from([((0, 0), all), ((1, 0), all), ((2, 0), all), ((0, 1), all)])
        );
    }

    #[test]
    fn agrees_with_the_test_of_every_sample() {
        let mut random = Xorshift::new(40);
        let mut mask = SampleMask::new();
        for round in 0..200 {
            let window = IRect::new(random.grid(-5, 5), random.grid(6, 12));
            // Triangles of any shape, some of them as thin as the distance of samples, and steep rectangles.
            let a = random.point(-10.0, 20.0);
            let reach = if round % 2 == 0 { 20.0 } else { 0.3 };
            let polygon = match round % 3 {
                0 => {
                    let (along, side) =
                        (random.point(-0.1, 0.1) + DVec2::new(0.0, 15.0), DVec2::new(0.6, 0.0));
                    vec![a, a + along, a + along + side, a + side]
                }
                _ => vec![a, a + random.point(-reach, reach), a + random.point(-20.0, 20.0)],
            };
            mask.begin(window);
            mask.polygon(&polygon);
            let found = words(&mut mask);
            for (y, x) in
                (window.min.y..window.max.y).flat_map(|y| (window.min.x..window.max.x).map(move |x| (y, x)))
            {
                let word = found.get(&(x, y)).copied().unwrap_or(0);
                for bit in 0..SAMPLES {
                    let within = DVec2::new(f64::from(bit % 8) + 0.5, f64::from(bit / 8) + 0.5) / 8.0;
                    let sample = DVec2::new(x.into(), y.into()) + within;
                    let inside = contains(&polygon, &[polygon.len() as u32], Rule::NonZero, sample);
                    assert_eq!(word >> bit & 1 == 1, inside, "{polygon:?} {sample}");
                }
            }
        }
    }

    #[test]
    fn a_polygon_has_the_same_samples_in_bands() {
        let mut random = Xorshift::new(42);
        let mut mask = SampleMask::new();
        for round in 0..2000 {
            // Many edges of corners on samples lead through other samples.
            let reach = if round % 4 == 0 { FARTHEST * 1e3 } else { 40.0 };
            let grid = |p: DVec2| ((p * 16.0).round() + 1.0) / 16.0;
            let corner = |p: DVec2| if round % 4 == 1 { p } else { grid(p) };
            let polygon: Vec<DVec2> = (0..3).map(|_| corner(random.point(-reach, reach) + 10.0)).collect();
            let mut bands = |height: i32| {
                let mut found = BTreeMap::new();
                for top in (0..24).step_by(height as usize) {
                    mask.begin(IRect::new(IVec2::new(1, top), IVec2::new(21, top + height)));
                    mask.polygon(&polygon);
                    found.append(&mut words(&mut mask));
                }
                found
            };
            let whole = bands(24);
            for height in [1, 3, 8] {
                assert!(whole == bands(height), "{round}: {polygon:?} in bands of {height}");
            }
        }
    }

    #[test]
    fn neighbours_share_no_sample_and_leave_none_out() {
        let mut random = Xorshift::new(41);
        let mut mask = SampleMask::new();
        let corners = ring(&[(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)]);
        for _ in 0..200 {
            let middle = random.grid(0, 144).as_dvec2() / 16.0;
            let mut sum = 0;
            for i in 0..4 {
                mask.begin(IRect::of_size(9, 9));
                mask.polygon(&[corners[i], corners[(i + 1) % 4], middle]);
                sum += samples(&mut mask);
            }
            assert_eq!(sum, 81 * SAMPLES, "{middle}");
        }
    }

    #[test]
    fn what_overlaps_counts_once() {
        let mut mask = SampleMask::new();
        mask.begin(IRect::of_size(8, 8));
        for _ in 0..3 {
            mask.polygon(&ring(&[(0.3, 0.3), (6.1, 1.2), (3.3, 7.2)]));
        }
        let three = words(&mut mask);
        mask.begin(IRect::of_size(8, 8));
        mask.polygon(&ring(&[(0.3, 0.3), (3.3, 7.2), (6.1, 1.2)]));
        assert_eq!(three, words(&mut mask));
    }

    #[test]
    fn the_storage_is_empty_for_the_next_shape_in_any_window() {
        let mut mask = SampleMask::new();
        let all = ring(&[(-9.0, -9.0), (90.0, -9.0), (90.0, 90.0), (-9.0, 90.0)]);
        for (width, height, drained) in [(30, 20, true), (7, 9, false), (20, 30, true), (3, 3, true)] {
            mask.begin(IRect::of_size(width, height));
            mask.polygon(&all);
            if drained {
                assert_eq!(samples(&mut mask), (width * height) as u32 * SAMPLES);
            }
            mask.begin(IRect::of_size(31, 31));
            assert_eq!(samples(&mut mask), 0);
        }
    }

    #[test]
    fn far_and_flat_polygons() {
        let mut mask = SampleMask::new();
        for far in [1e5, 1e9, 1e40, 1e150] {
            mask.begin(IRect::of_size(4, 3));
            mask.polygon(&ring(&[(-far, 1.0), (far, 1.0), (far, 2.0), (-far, 2.0)]));
            assert_eq!(samples(&mut mask), 4 * SAMPLES, "{far}");
            mask.begin(IRect::of_size(4, 3));
            mask.polygon(&ring(&[(2.0, -far), (4.0, far), (0.0, far)]));
            assert!(samples(&mut mask) > 0, "{far}");
        }
        mask.begin(IRect::of_size(4, 3));
        for flat in
            [vec![], vec![(1.0, 1.0)], vec![(1.0, 1.0), (3.0, 2.0)], vec![(0.0, 1.0), (4.0, 1.0), (2.0, 1.0)]]
        {
            mask.polygon(&ring(&flat));
        }
        assert_eq!(samples(&mut mask), 0);
        mask.begin(IRect::default());
        mask.polygon(&ring(&[(0.0, 0.0), (4.0, 0.0), (2.0, 9.0)]));
        assert_eq!(samples(&mut mask), 0);
    }
}
