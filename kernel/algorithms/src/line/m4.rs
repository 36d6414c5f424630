//! U. Jugel, Z. Jerzak, G. Hackenbroich and V. Markl, "M4: A Visualization-Oriented Time Series Data Aggregation",
//! Proceedings of the VLDB Endowment 7(10), 2014: reducing a polyline to four vertices a column.

use super::column::{BLOCK, is_within, range_within};
use crate::path::is_usable;
use glam::DVec2;

/// Gives the first, the lowest, the highest and the last vertex of each run of vertices within one column.
///
/// Columns are `tolerance` wide and begin at whole multiples of it. Suits a line whose x goes forward in small steps,
/// however much its y leaps; of any other it leaves out little. A column as wide as a pixel changes hardly a pixel of the
/// line drawn, while the vertices drop to four for each column.
pub fn m4(path: impl IntoIterator<Item = DVec2>, tolerance: f64, mut emit: impl FnMut(DVec2)) {
    let mut m4 = M4::new(tolerance);
    path.into_iter().for_each(|p| m4.to(p, &mut emit));
    m4.end(&mut emit);
}

/// The reduction of [`m4`] of a path that comes vertex by vertex.
pub struct M4 {
    tolerance: f64,
    run: Run,
}

impl M4 {
    /// Begins with no vertex.
    pub fn new(tolerance: f64) -> Self {
        // Nothing lies in the column of no run.
        M4 { tolerance, run: Run::new(DVec2::NAN, (1.0, 0.0)) }
    }

    /// Goes on to the next vertex.
    #[inline]
    pub fn to(&mut self, p: DVec2, emit: &mut impl FnMut(DVec2)) {
        if is_within(p, self.run.column.0, self.run.column.1) {
            return self.run.take(p);
        }
        self.run.give(emit);
        let left = (p.x / self.tolerance).floor() * self.tolerance;
        if is_usable(p) && left.is_finite() && self.tolerance > 0.0 {
            self.run = Run::new(p, (left, left + self.tolerance));
        } else {
            self.run = Run::new(DVec2::NAN, (1.0, 0.0));
            emit(p);
        }
    }

    /// Goes on to several vertices.
    pub fn all(&mut self, path: &[DVec2], emit: &mut impl FnMut(DVec2)) {
        let mut rest = path;
        while let [p, others @ ..] = rest {
            let taken = self.run.take_some(rest);
            if taken > 0 {
                rest = &rest[taken..];
            } else {
                self.to(*p, emit);
                rest = others;
            }
        }
    }

    /// Ends the path.
    pub fn end(self, emit: &mut impl FnMut(DVec2)) {
        self.run.give(emit);
    }
}

/// Vertices one after the other in one column; the extremes with their places in the run.
struct Run {
    /// Where it begins and ends.
    column: (f64, f64),
    count: u64,
    first: DVec2,
    lowest: (u64, DVec2),
    highest: (u64, DVec2),
    last: DVec2,
}

impl Run {
    fn new(p: DVec2, column: (f64, f64)) -> Self {
        let count = u64::from(!p.is_nan());
        Run { column, count, first: p, lowest: (0, p), highest: (0, p), last: p }
    }

    /// Takes vertices as long as they lie in the column, and tells how many.
    #[inline]
    fn take_some(&mut self, path: &[DVec2]) -> usize {
        let (left, right) = self.column;
        let (mut low, mut high) = (self.lowest.1.y, self.highest.1.y);
        // Where an extreme is, or where the block begins that it is in.
        let (mut lowest, mut highest) = (None, None);
        let mut taken = 0;
        let (blocks, _) = path.as_chunks::<BLOCK>();
        for block in blocks {
            let Some(range) = range_within(block, left, right) else {
                break;
            };
            if range.0 < low {
                (low, lowest) = (range.0, Some(taken));
            }
            if range.1 > high {
                (high, highest) = (range.1, Some(taken));
            }
            taken += BLOCK;
        }
        for p in path[taken..].iter().take_while(|p| is_within(**p, left, right)) {
            if p.y < low {
                (low, lowest) = (p.y, Some(taken));
            }
            if p.y > high {
                (high, highest) = (p.y, Some(taken));
            }
            taken += 1;
        }
        let found = |from: usize, y: f64| path[from..].iter().position(|p| p.y == y).map(|i| from + i);
        if let Some(i) = lowest.and_then(|from| found(from, low)) {
            self.lowest = (self.count + i as u64, path[i]);
        }
        if let Some(i) = highest.and_then(|from| found(from, high)) {
            self.highest = (self.count + i as u64, path[i]);
        }
        if taken > 0 {
            self.last = path[taken - 1];
            self.count += taken as u64;
        }
        taken
    }

    #[inline]
    fn take(&mut self, p: DVec2) {
        if p.y < self.lowest.1.y {
            self.lowest = (self.count, p);
        }
        if p.y > self.highest.1.y {
            self.highest = (self.count, p);
        }
        self.last = p;
        self.count += 1;
    }

    fn give(&self, emit: &mut impl FnMut(DVec2)) {
        if self.count == 0 {
            return;
        }
        emit(self.first);
        let (one, other) = if self.lowest.0 < self.highest.0 {
            (self.lowest, self.highest)
        } else {
            (self.highest, self.lowest)
        };
        for (place, p) in [one, other] {
            if place > 0 && place < self.count - 1 {
                emit(p);
            }
        }
        if self.count > 1 {
            emit(self.last);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;

    #[test]
    fn vertices_may_come_one_by_one_or_many_at_a_time() {
        let mut random = Xorshift::new(12);
        for round in 0..40 {
            let mut x = 0.0;
            // A few vertices in a column, or many more than a block.
            let reach = if round % 2 == 0 { 0.2 } else { 0.02 };
            let mut path: Vec<DVec2> = (0..300)
                .map(|_| {
                    let step = random.point(-0.25 * reach, reach);
                    x += step.x;
                    DVec2::new(x, random.point(0.0, 50.0).y)
                })
                .collect();
            path[round * 7].y = f64::NAN;
            path[round * 3].x = f64::INFINITY;
            let mut one_by_one = Vec::new();
            m4(path.iter().copied(), 0.5, |p| one_by_one.push(p));
            let (mut many, mut reduction) = (Vec::new(), M4::new(0.5));
            for part in path.chunks(round + 1) {
                reduction.all(part, &mut |p| many.push(p));
            }
            reduction.end(&mut |p| many.push(p));
            assert!(one_by_one.len() < path.len());
            assert_eq!(format!("{one_by_one:?}"), format!("{many:?}"), "{} at a time", round + 1);
        }
    }
}
