//! F. P. Preparata and M. I. Shamos, "Computational Geometry", Springer 1985, section 1.2: the bounding rectangle.

use crate::path::is_usable;
use crate::rect::Rect;
use glam::DVec2;

/// The smallest rectangle round the points, or none if no point is usable.
pub fn bounds(points: &[DVec2]) -> Option<Rect> {
    let mut usable = points.iter().copied().filter(|&p| is_usable(p));
    let first = usable.next()?;
    Some(usable.fold((first, first), |(min, max), p| (min.min(p), max.max(p))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_all_points_and_no_more() {
        let points = [DVec2::new(3.0, -1.0), DVec2::NAN, DVec2::new(-2.0, 5.0), DVec2::INFINITY];
        assert_eq!(bounds(&points), Some((DVec2::new(-2.0, -1.0), DVec2::new(3.0, 5.0))));
        assert_eq!(bounds(&points[1..2]), None);
        assert_eq!(bounds(&[]), None);
    }
}
