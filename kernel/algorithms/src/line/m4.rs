//! U. Jugel, Z. Jerzak, G. Hackenbroich and V. Markl, "M4: A Visualization-Oriented Time Series Data Aggregation",
//! Proceedings of the VLDB Endowment 7(10), 2014: reducing a polyline to four vertices a column.

use crate::path::{LARGEST, is_usable};
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
        if self.run.column.0 <= p.x && p.x < self.run.column.1 && p.y.abs() <= LARGEST {
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
