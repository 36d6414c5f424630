//! V. Klee, "Can the measure of the union of intervals [a, b] be computed in less than O(n log n) steps?", American
//! Mathematical Monthly 84(4), 1977: the union of many intervals, found by sorting them.

/// An upright line: an interval of ordinates in a column.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Upright {
    /// The number of the column.
    pub column: i64,
    /// The least ordinate.
    pub low: f64,
    /// The greatest ordinate.
    pub high: f64,
}

/// Gives as few upright lines as make up the same points: those in the same column that overlap or touch become one. They are
/// sorted by their columns, and by their ordinates within them. Ordinates must be numbers.
pub fn klee(lines: &mut [Upright], mut emit: impl FnMut(Upright)) {
    lines.sort_unstable_by(|a, b| a.column.cmp(&b.column).then(a.low.total_cmp(&b.low)));
    let mut lines = lines.iter().copied();
    let Some(mut union) = lines.next() else { return };
    for line in lines {
        if line.column == union.column && line.low <= union.high {
            union.high = union.high.max(line.high);
        } else {
            emit(std::mem::replace(&mut union, line));
        }
    }
    emit(union);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;

    #[test]
    fn the_same_points_are_covered_by_lines_that_do_not_touch() {
        let mut random = Xorshift::new(77);
        for round in 0..50 {
            let mut lines: Vec<Upright> = (0..round)
                .map(|_| {
                    let (at, length) = (random.grid(0, 40), random.grid(0, 6));
                    let low = f64::from(at.y);
                    Upright { column: i64::from(at.x % 3), low, high: low + f64::from(length.x) }
                })
                .collect();
            let covers = |lines: &[Upright], column: i64, y: f64| {
                lines.iter().any(|line| line.column == column && line.low <= y && y <= line.high)
            };
            let before = lines.clone();
            let mut union = Vec::new();
            klee(&mut lines, |line| union.push(line));
            for column in 0..3 {
                for half in 0..100 {
                    let y = f64::from(half) * 0.5;
                    assert_eq!(covers(&before, column, y), covers(&union, column, y), "{column} {y}");
                }
            }
            let apart = |pair: &[Upright]| (pair[0].column, pair[0].high) < (pair[1].column, pair[1].low);
            assert!(union.windows(2).all(apart), "{union:?}");
        }
    }
}
