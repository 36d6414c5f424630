//! How far a polyline reaches up and down while it stays in a column.

use crate::path::LARGEST;
use glam::DVec2;

/// As many vertices are looked at together, without a branch between them.
pub(super) const BLOCK: usize = 8;

/// The vertices at the beginning of a path that lie in one column.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Stay {
    /// How many there are.
    pub count: usize,
    /// The least ordinate; infinite if there is no vertex.
    pub low: f64,
    /// The greatest ordinate; minus infinity if there is no vertex.
    pub high: f64,
}

/// How long a path stays at its beginning between two abscissae, of which the second one does not count, and how far it
/// reaches meanwhile. It leaves with a vertex that is not usable.
#[inline]
pub fn stay(path: &[DVec2], left: f64, right: f64) -> Stay {
    let mut stay = Stay { count: 0, low: f64::INFINITY, high: f64::NEG_INFINITY };
    let (blocks, _) = path.as_chunks::<BLOCK>();
    for block in blocks {
        let Some((low, high)) = range_within(block, left, right) else { break };
        stay = Stay { count: stay.count + BLOCK, low: stay.low.min(low), high: stay.high.max(high) };
    }
    let rest = &path[stay.count..];
    for p in rest.iter().take_while(|p| is_within(**p, left, right)) {
        stay = Stay { count: stay.count + 1, low: stay.low.min(p.y), high: stay.high.max(p.y) };
    }
    stay
}

/// Whether a vertex is usable and lies in a column.
#[inline]
pub(super) fn is_within(p: DVec2, left: f64, right: f64) -> bool {
    left <= p.x && p.x < right && p.y.abs() <= LARGEST
}

/// The least and the greatest ordinate of vertices, if all of them are usable and lie in a column.
#[inline]
pub(super) fn range_within(block: &[DVec2; BLOCK], left: f64, right: f64) -> Option<(f64, f64)> {
    let (least, beyond) = ([left, -LARGEST], [right, LARGEST.next_up()]);
    // The abscissae are compared in vain, so that both coordinates go through the same instructions.
    let (mut low, mut high) = (block[0].to_array(), block[0].to_array());
    let mut inside = [true; 2];
    for p in block.iter().map(DVec2::to_array) {
        for i in 0..2 {
            inside[i] &= (p[i] >= least[i]) & (p[i] < beyond[i]);
            low[i] = if p[i] < low[i] { p[i] } else { low[i] };
            high[i] = if p[i] > high[i] { p[i] } else { high[i] };
        }
    }
    (inside[0] & inside[1]).then_some((low[1], high[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;

    #[test]
    fn a_path_stays_until_its_first_vertex_outside() {
        let mut random = Xorshift::new(13);
        for count in 0..60 {
            let mut path: Vec<DVec2> =
                (0..60).map(|_| DVec2::new(random.real(2.0, 3.0), random.real(-9.0, 9.0))).collect();
            path[count] = match count % 4 {
                0 => DVec2::new(3.0, 0.0),
                1 => DVec2::new(1.99, 100.0),
                2 => DVec2::new(2.5, f64::NAN),
                _ => DVec2::new(2.5, 1e151),
            };
            let found = stay(&path, 2.0, 3.0);
            let low = path[..count].iter().fold(f64::INFINITY, |low, p| low.min(p.y));
            let high = path[..count].iter().fold(f64::NEG_INFINITY, |high, p| high.max(p.y));
            assert_eq!(found, Stay { count, low, high });
        }
    }
}
