//! M. Cyrus and J. Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics 3(1), 1978: segment
//! against convex polygon.

use crate::path::is_usable;
use crate::polygon::ring_area;
use glam::DVec2;

/// The part of segment a-b inside a convex polygon, whichever way round its vertices run.
///
/// Ends that are inside come back bit for bit; the boundary is inside. A polygon without area has no inside, and for one
/// that is not convex the result is that of the common part of its half planes.
pub fn cyrus_beck(convex: &[DVec2], a: DVec2, b: DVec2) -> Option<(DVec2, DVec2)> {
    if !is_usable(a) || !is_usable(b) {
        return None;
    }
    let area = ring_area(convex);
    if area == 0.0 || !area.is_finite() {
        return None;
    }
    let d = b - a;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let mut last = *convex.last()?;
    for &vertex in convex {
        let inward = (vertex - last).perp() * area.signum();
        last = vertex;
        let depth = inward.dot(a - vertex);
        let gain = inward.dot(d);
        if gain > 0.0 {
            enter = enter.max(-depth / gain);
        } else if gain < 0.0 {
            leave = leave.min(-depth / gain);
        } else if depth < 0.0 {
            return None;
        }
        if enter > leave {
            return None;
        }
    }
    let start = if enter > 0.0 { a + d * enter } else { a };
    let end = if leave < 1.0 { a + d * leave } else { b };
    Some((start, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [DVec2; 3] = [DVec2::new(0.0, 0.0), DVec2::new(4.0, 0.0), DVec2::new(0.0, 4.0)];

    #[test]
    fn a_triangle_cuts_at_its_slope() {
        let cut = cyrus_beck(&TRIANGLE, DVec2::new(-1.0, 1.0), DVec2::new(7.0, 1.0));
        assert_eq!(cut, Some((DVec2::new(0.0, 1.0), DVec2::new(3.0, 1.0))));
        assert_eq!(cyrus_beck(&TRIANGLE, DVec2::new(3.0, 3.0), DVec2::new(9.0, 1.0)), None);
        let within = (DVec2::new(0.1, 0.2), DVec2::new(1.1, 0.7));
        assert_eq!(cyrus_beck(&TRIANGLE, within.0, within.1), Some(within));
    }

    #[test]
    fn no_area_no_inside() {
        let line = [DVec2::ZERO, DVec2::X, DVec2::new(2.0, 0.0)];
        assert_eq!(cyrus_beck(&line, DVec2::NEG_X, DVec2::X), None);
        assert_eq!(cyrus_beck(&[], DVec2::NEG_X, DVec2::X), None);
        assert_eq!(cyrus_beck(&[DVec2::NAN; 3], DVec2::NEG_X, DVec2::X), None);
    }
}
