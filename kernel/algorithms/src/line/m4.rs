//! U. Jugel, Z. Jerzak, G. Hackenbroich and V. Markl, "M4: A Visualization-Oriented Time Series Data Aggregation",
//! Proceedings of the VLDB Endowment 7(10), 2014: reducing a polyline to four vertices a column.

use crate::path::is_usable;
use glam::DVec2;

/// Gives the first, the lowest, the highest and the last vertex of each run of vertices within one column.
///
/// Columns are `tolerance` wide and begin at whole multiples of it. Suits a line whose x goes forward in small steps,
/// however much its y leaps; of any other it leaves out little. A column as wide as a pixel changes hardly a pixel of the
/// line drawn, while the vertices drop to four for each column.
pub fn m4(path: impl IntoIterator<Item = DVec2>, tolerance: f64, mut emit: impl FnMut(DVec2)) {
    let mut run: Option<Run> = None;
    for p in path {
        let column = (p.x / tolerance).floor();
        if let Some(run) = run.as_mut().filter(|run| run.column == column && is_usable(p)) {
            run.take(p);
            continue;
        }
        if let Some(run) = run.take() {
            run.give(&mut emit);
        }
        if is_usable(p) && column.is_finite() && tolerance > 0.0 {
            run = Some(Run { column, count: 1, first: p, lowest: (0, p), highest: (0, p), last: p });
        } else {
            emit(p);
        }
    }
    if let Some(run) = run {
        run.give(&mut emit);
    }
}

/// Vertices one after the other in one column; the extremes with their places in the run.
struct Run {
    column: f64,
    count: u64,
    first: DVec2,
    lowest: (u64, DVec2),
    highest: (u64, DVec2),
    last: DVec2,
}

impl Run {
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

    fn give(self, emit: &mut impl FnMut(DVec2)) {
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
