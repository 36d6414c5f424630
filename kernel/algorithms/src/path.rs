//! Path sets: how this crate takes and gives several polylines or rings at once.
//!
//! A path set is a slice of points and a slice of ends; `ends[i]` is the index one past the last point of subpath `i`,
//! which begins where its predecessor ends. Rings are closed by implication: no last point repeats the first.

use glam::DVec2;

/// The largest absolute coordinate that takes part in a computation.
///
/// Squares and products of differences of such coordinates stay finite. A point beyond it counts as not finite.
pub const LARGEST: f64 = 1e150;

/// Whether both coordinates are numbers no larger than [`LARGEST`].
pub fn is_usable(p: DVec2) -> bool {
    p.x.abs() <= LARGEST && p.y.abs() <= LARGEST
}

/// The rule that says which points lie inside a set of rings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rule {
    /// Inside when a ray from the point crosses the rings an odd number of times.
    EvenOdd,
    /// Inside when the rings turn round the point a number of times that is not zero.
    NonZero,
}

impl Rule {
    /// Whether a point is inside round which the rings turn `winding` times, counted by signed crossings.
    pub fn is_inside(self, winding: i32) -> bool {
        match self {
            Rule::EvenOdd => winding & 1 != 0,
            Rule::NonZero => winding != 0,
        }
    }
}

/// The subpaths of a path set, in order.
///
/// Ends that run backwards or past the points are taken as empty or cut short.
pub fn subpaths<'a>(points: &'a [DVec2], ends: &'a [u32]) -> impl Iterator<Item = &'a [DVec2]> {
    let mut start = 0;
    ends.iter().map(move |&end| {
        let end = (end as usize).clamp(start, points.len());
        let path = &points[start..end];
        start = end;
        path
    })
}

/// Gives every edge of the rings, closing ones included, leaving out vertices that are not usable.
pub(crate) fn ring_edges(points: &[DVec2], ends: &[u32], mut edge: impl FnMut(DVec2, DVec2)) {
    for ring in subpaths(points, ends) {
        let mut vertices = ring.iter().copied().filter(|&p| is_usable(p));
        let Some(first) = vertices.next() else { continue };
        let mut last = first;
        for p in vertices {
            edge(last, p);
            last = p;
        }
        edge(last, first);
    }
}

/// Ends the subpath under construction at the last point.
pub(crate) fn end_subpath(points: &[DVec2], ends: &mut Vec<u32>) {
    ends.push(u32::try_from(points.len()).unwrap_or(u32::MAX));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subpaths_survive_bad_ends() {
        let points = [DVec2::ZERO; 5];
        let lengths = |ends: &[u32]| subpaths(&points, ends).map(<[_]>::len).collect::<Vec<_>>();
        assert_eq!(lengths(&[2, 5]), [2, 3]);
        assert_eq!(lengths(&[3, 1, 9]), [3, 0, 2]);
        assert_eq!(lengths(&[]), [0; 0]);
    }

    #[test]
    fn edges_close_the_ring_and_skip_what_is_not_finite() {
        let (a, b) = (DVec2::ZERO, DVec2::X);
        let mut seen = vec![];
        ring_edges(&[a, DVec2::NAN, b, DVec2::INFINITY], &[4], |p, q| seen.push((p, q)));
        assert_eq!(seen, [(a, b), (b, a)]);
    }

    #[test]
    fn rules_differ_on_even_windings() {
        assert!(Rule::EvenOdd.is_inside(-1) && Rule::NonZero.is_inside(-1));
        assert!(!Rule::EvenOdd.is_inside(2) && Rule::NonZero.is_inside(2));
        assert!(!Rule::EvenOdd.is_inside(0) && !Rule::NonZero.is_inside(0));
    }
}
