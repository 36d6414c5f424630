//! Rectangles: closed real ones to clip against, half-open pixel ones to plot into.

use glam::{DVec2, IVec2};

/// A closed, axis-parallel rectangle as its lower left and upper right corner: the boundary belongs to it.
///
/// Corners may be infinite, which leaves that side open. A rectangle whose first corner exceeds the second holds
/// nothing.
pub type Rect = (DVec2, DVec2);

/// A rectangle of pixels: `min` is its first pixel, `max` lies one beyond the last in both directions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct IRect {
    /// The first column and row.
    pub min: IVec2,
    /// One past the last column and row.
    pub max: IVec2,
}

impl IRect {
    /// The pixels from `min` up to but not including `max`.
    pub const fn new(min: IVec2, max: IVec2) -> Self {
        Self { min, max }
    }

    /// The raster of the given width and height whose first pixel is (0, 0).
    pub const fn of_size(width: i32, height: i32) -> Self {
        Self { min: IVec2::ZERO, max: IVec2::new(width, height) }
    }

    /// Whether there is no pixel in the rectangle.
    pub fn is_empty(self) -> bool {
        self.min.x >= self.max.x || self.min.y >= self.max.y
    }

    /// Whether pixel (x, y) lies in the rectangle.
    pub fn contains(self, x: i32, y: i32) -> bool {
        self.min.x <= x && x < self.max.x && self.min.y <= y && y < self.max.y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_far_edge_is_outside() {
        let raster = IRect::of_size(3, 2);
        assert!(raster.contains(0, 0) && raster.contains(2, 1));
        assert!(!raster.contains(3, 0) && !raster.contains(0, 2) && !raster.contains(-1, 0));
        assert!(!raster.is_empty());
        assert!(IRect::new(IVec2::new(4, 0), IVec2::new(4, 9)).is_empty());
    }
}
