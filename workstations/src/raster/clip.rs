//! The clip operator of raster devices: what a rectangle leaves of each pixel.

use super::composite::times;
use gks_geometry::{Du, Rect};
use std::ops::Range;

/// A clipping rectangle on a raster. The part of a pixel that it leaves is the product of a part in x and a
/// part in y.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Window {
    columns: Side,
    rows: Side,
}

/// One direction of a [`Window`].
#[derive(Clone, Debug, PartialEq)]
struct Side {
    /// The limits, on the raster.
    limits: (f64, f64),
    /// The pixels of which something is left.
    touched: Range<u32>,
    /// The pixels of which everything is left.
    whole: Range<u32>,
    /// The pixels whose centre is left.
    centred: Range<u32>,
}

impl Side {
    fn new(low: f64, high: f64, size: u32, antialias: bool) -> Self {
        let length = f64::from(size);
        let (low, high) = (low.max(0.0), high.min(length));
        let range = |from: f64, to: f64| {
            let from = from.clamp(0.0, length) as u32;
            from..(to.clamp(0.0, length) as u32).max(from)
        };
        let centred = range((low - 0.5).ceil(), (high - 0.5).ceil());
        if antialias {
            let (touched, whole) = (range(low.floor(), high.ceil()), range(low.ceil(), high.floor()));
            Side { limits: (low, high), touched, whole, centred }
        } else {
            Side { limits: (low, high), touched: centred.clone(), whole: centred.clone(), centred }
        }
    }

    fn coverage(&self, at: u32) -> u8 {
        if self.whole.contains(&at) {
            return 255;
        }
        if !self.touched.contains(&at) {
            return 0;
        }
        let at = f64::from(at);
        let left = (at + 1.0).min(self.limits.1) - at.max(self.limits.0);
        (left.clamp(0.0, 1.0) * 255.0).round() as u8
    }
}

impl Window {
    /// The window that a clipping rectangle, or none, leaves of a raster. Pixels at its edge are partly
    /// left if `antialias` is set, else they are left if their centre is inside.
    pub(super) fn new(clip: Option<Rect<Du>>, width: u32, height: u32, antialias: bool) -> Self {
        let all = Rect::new(0.0, f64::from(width), 0.0, f64::from(height));
        let [left, right, top, bottom] = clip.unwrap_or(all).limits();
        Window {
            columns: Side::new(left, right, width, antialias),
            rows: Side::new(top, bottom, height, antialias),
        }
    }

    /// The columns and rows of pixels whose centre is left.
    pub(super) fn centred(&self) -> (Range<u32>, Range<u32>) {
        (self.columns.centred.clone(), self.rows.centred.clone())
    }

    /// How much of 255 parts of a pixel is left.
    #[inline]
    pub(super) fn coverage(&self, column: u32, row: u32) -> u8 {
        times(self.columns.coverage(column), self.rows.coverage(row))
    }

    /// The pixels of which something is left and that lie in a rectangle: columns, rows.
    pub(super) fn touched_by(&self, bounds: &Rect<Du>) -> (Range<u32>, Range<u32>) {
        let cut = |side: &Range<u32>, low: f64, high: f64| {
            let start = side.start.max(low.floor().clamp(0.0, f64::from(u32::MAX)) as u32);
            start..side.end.min(high.ceil().clamp(0.0, f64::from(u32::MAX)) as u32).max(start)
        };
        let [left, right, top, bottom] = bounds.limits();
        (cut(&self.columns.touched, left, right), cut(&self.rows.touched, top, bottom))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EVERYTHING: Rect<Du> = Rect::new(-1e9, 1e9, -1e9, 1e9);

    #[test]
    fn pixels_at_the_edge_are_left_in_part() {
        let window = Window::new(Some(Rect::new(1.5, 4.0, 1.0, 2.25)), 6, 4, true);
        let row = |r| -> Vec<u8> { (0..6).map(|c| window.coverage(c, r)).collect() };
        assert_eq!(row(0), [0; 6]);
        assert_eq!(row(1), [0, 128, 255, 255, 0, 0]);
        assert_eq!(row(2), [0, 32, 64, 64, 0, 0]);
        let aliased = Window::new(Some(Rect::new(1.5, 4.0, 1.0, 2.25)), 6, 4, false);
        assert_eq!(aliased.touched_by(&EVERYTHING), (1..4, 1..2));
    }

    #[test]
    fn a_thin_window_inside_of_one_pixel_leaves_a_little_of_it() {
        let window = Window::new(Some(Rect::new(2.25, 2.75, 0.0, 4.0)), 4, 4, true);
        assert_eq!(window.coverage(2, 1), 128);
        assert_eq!(window.coverage(1, 1), 0);
    }

    #[test]
    fn far_and_empty_rectangles_do_no_harm() {
        for clip in [
            Rect::new(-1e300, 1e300, -1e300, 1e300),
            Rect::new(50.0, 60.0, 50.0, 60.0),
            Rect::new(-60.0, -50.0, 0.0, 4.0),
            Rect::new(3.0, 1.0, 3.0, 1.0),
            Rect::new(f64::NAN, f64::NAN, f64::NAN, f64::NAN),
        ] {
            let window = Window::new(Some(clip), 4, 4, true);
            let (columns, rows) = window.touched_by(&EVERYTHING);
            assert!(columns.end <= 4 && rows.end <= 4);
        }
        let beside = Window::new(Some(Rect::new(50.0, 60.0, 0.0, 4.0)), 4, 4, true);
        assert!(beside.touched_by(&EVERYTHING).0.is_empty());
    }
}
