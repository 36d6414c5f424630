//! Axis-parallel rectangles.

use crate::{Point, Space, Vector};
use glam::DVec2;

/// An axis-parallel rectangle with `min <= max` in both directions; its boundary belongs to it.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub struct Rect<S: Space> {
    /// The lower left corner.
    pub min: Point<S>,
    /// The upper right corner.
    pub max: Point<S>,
}

impl<S: Space> Rect<S> {
    /// The unit square.
    pub const UNIT: Rect<S> = Rect { min: Point::new(0.0, 0.0), max: Point::new(1.0, 1.0) };

    /// The rectangle with the limits in the order the standards use: XMIN, XMAX, YMIN, YMAX.
    #[inline]
    pub const fn new(xmin: f64, xmax: f64, ymin: f64, ymax: f64) -> Self {
        Rect { min: Point::new(xmin, ymin), max: Point::new(xmax, ymax) }
    }

    /// The limits in the order XMIN, XMAX, YMIN, YMAX.
    pub const fn limits(&self) -> [f64; 4] {
        [self.min.x(), self.max.x(), self.min.y(), self.max.y()]
    }

    /// The smallest rectangle that contains all finite `points`, or none if there are none.
    pub fn around(points: impl IntoIterator<Item = Point<S>>) -> Option<Self> {
        let mut found: Option<(DVec2, DVec2)> = None;
        for p in points {
            if p.is_finite() {
                found = Some(match found {
                    None => (p.0, p.0),
                    Some((lo, hi)) => (lo.min(p.0), hi.max(p.0)),
                });
            }
        }
        found.map(|(lo, hi)| Rect { min: Point::from_vec(lo), max: Point::from_vec(hi) })
    }

    /// The extent in x.
    #[inline]
    pub fn width(&self) -> f64 {
        self.max.x() - self.min.x()
    }

    /// The extent in y.
    #[inline]
    pub fn height(&self) -> f64 {
        self.max.y() - self.min.y()
    }

    /// The middle.
    pub fn centre(&self) -> Point<S> {
        Point::from_vec((self.min.0 + self.max.0) * 0.5)
    }

    /// Whether all limits are finite and the rectangle has an area, as windows and viewports must.
    pub fn is_proper(&self) -> bool {
        self.min.is_finite()
            && self.max.is_finite()
            && self.min.x() < self.max.x()
            && self.min.y() < self.max.y()
    }

    /// Whether `p` lies inside or on the boundary.
    #[inline]
    pub fn contains(&self, p: Point<S>) -> bool {
        p.x() >= self.min.x() && p.x() <= self.max.x() && p.y() >= self.min.y() && p.y() <= self.max.y()
    }

    /// Whether `other` lies wholly inside this rectangle.
    #[inline]
    pub fn contains_rect(&self, other: &Rect<S>) -> bool {
        self.contains(other.min) && self.contains(other.max)
    }

    /// Whether the two rectangles share at least one point.
    #[inline]
    pub fn meets(&self, other: &Rect<S>) -> bool {
        self.min.x() <= other.max.x()
            && other.min.x() <= self.max.x()
            && self.min.y() <= other.max.y()
            && other.min.y() <= self.max.y()
    }

    /// The common part, or none where there is none.
    pub fn intersection(&self, other: &Rect<S>) -> Option<Rect<S>> {
        self.meets(other).then(|| Rect {
            min: Point::from_vec(self.min.0.max(other.min.0)),
            max: Point::from_vec(self.max.0.min(other.max.0)),
        })
    }

    /// The rectangle grown by `margin` on all sides.
    pub fn grown(&self, margin: f64) -> Rect<S> {
        let m = Vector::new(margin, margin);
        Rect { min: self.min - m, max: self.max + m }
    }

    /// The corners, anticlockwise from the lower left one.
    pub fn corners(&self) -> [Point<S>; 4] {
        let (a, b) = (self.min, self.max);
        [a, Point::new(b.x(), a.y()), b, Point::new(a.x(), b.y())]
    }
}

impl<S: Space> From<(f64, f64, f64, f64)> for Rect<S> {
    fn from((xmin, xmax, ymin, ymax): (f64, f64, f64, f64)) -> Self {
        Rect::new(xmin, xmax, ymin, ymax)
    }
}

impl<S: Space> From<[f64; 4]> for Rect<S> {
    fn from([xmin, xmax, ymin, ymax]: [f64; 4]) -> Self {
        Rect::new(xmin, xmax, ymin, ymax)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ndc;

    #[test]
    fn intersection_is_common_part_or_nothing() {
        let a = Rect::<Ndc>::new(0.0, 2.0, 0.0, 2.0);
        let b = Rect::new(1.0, 3.0, -1.0, 1.0);
        assert_eq!(a.intersection(&b), Some(Rect::new(1.0, 2.0, 0.0, 1.0)));
        assert_eq!(a.intersection(&Rect::new(2.5, 3.0, 0.0, 1.0)), None);
    }

    #[test]
    fn proper_refuses_reversed_flat_and_infinite_limits() {
        assert!(Rect::<Ndc>::UNIT.is_proper());
        assert!(!Rect::<Ndc>::new(1.0, 0.0, 0.0, 1.0).is_proper());
        assert!(!Rect::<Ndc>::new(0.0, 0.0, 0.0, 1.0).is_proper());
        assert!(!Rect::<Ndc>::new(0.0, f64::INFINITY, 0.0, 1.0).is_proper());
        assert!(!Rect::<Ndc>::new(f64::NAN, 1.0, 0.0, 1.0).is_proper());
    }
}
