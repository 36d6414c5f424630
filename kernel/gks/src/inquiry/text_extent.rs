//! Inquiry of the text extent: the room that a string takes.

use crate::{Function, Gks, Result};
use gks_geometry::{Point, Wc};
use gks_pipeline::font::{self, Layout};
use gks_pipeline::lower;

/// The room that a string takes, in world coordinates.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct TextExtent {
    /// Where to place a string that is to follow this one with the same attributes.
    pub concatenation: Point<Wc>,
    /// The corners of the parallelogram around the character bodies, anticlockwise in the text frame: lower
    /// left, lower right, upper right, upper left.
    pub corners: [Point<Wc>; 4],
}

/// The error of a workstation that is neither of category OUTPUT nor OUTIN.
const NO_OUTPUT: i32 = 39;

impl Gks {
    /// INQUIRE TEXT EXTENT: the room that a string at a position would take on a workstation, with the
    /// current attributes and the text bundles of that workstation.
    ///
    /// A string without character bodies takes none: all points are the position. Errors: 7, 20, 25, 39.
    pub fn inquire_text_extent(
        &self,
        id: i32,
        position: impl Into<Point<Wc>>,
        text: &str,
    ) -> Result<TextExtent> {
        const F: Function = Function::InquireTextExtent;
        let open = match self.inquired(F, id) {
            Err(error) if error.number == NO_OUTPUT && self.defaults.text_extent_of_metafiles => {
                self.workstation(F, id)?
            }
            inquired => inquired?,
        };
        let bundle = open.workstation.tables().text(&self.look);
        let mut layout = Layout::default();
        font::layout(text, &lower::text::style(&bundle, &self.look.text_geometry), &mut layout);
        // Text is drawn in the frame of the images of these vectors under the normalization transformation;
        // the way back through it is the frame of the vectors themselves.
        let (origin, height, width) = (position.into(), self.geometry.height(), self.geometry.width());
        let at = |p: glam::DVec2| origin + width * p.x + height * p.y;
        Ok(TextExtent { concatenation: at(layout.concatenation), corners: layout.extent.map(at) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{CATEGORIES, Drawing, Log, PLAIN, active, closed, number, open};
    use gks_pipeline::description::Category;
    use gks_pipeline::look::{AspectSourceFlags, Horizontal, Precision, TextPath, Vertical};
    use glam::{DMat2, DVec2};

    /// Font 1 is monospaced: bodies as wide as the character height, from -1/3 to 4/3 of it.
    const TOP: f64 = 4.0 / 3.0;
    const BOTTOM: f64 = -1.0 / 3.0;

    fn assert_near(actual: Point<Wc>, expected: (f64, f64), what: &str) {
        let expected = DVec2::from(expected);
        assert!(actual.0.abs_diff_eq(expected, 1e-9), "{what}: {actual:?} is not {expected}");
    }

    #[test]
    fn states_identifiers_and_categories_are_checked_in_this_order() {
        let extent = |gks: &Gks, id| number(gks.inquire_text_extent(id, (0.0, 0.0), "text"));
        assert_eq!(extent(&closed(), -1), 7);
        assert_eq!(extent(&open(&[]).0, -1), 7);
        let (gks, _) = open(&[CATEGORIES + Category::MetafileOutput as i32]);
        assert_eq!([0, 9, 1].map(|id| extent(&gks, id)), [20, 25, 39]);
    }

    /// The alignment table of the standard, for two characters of height 3, twice as wide, half a height apart.
    #[test]
    fn every_alignment_puts_the_extent_where_the_standard_says() {
        let (mut gks, _) = open(&[PLAIN]);
        gks.set_character_height(3.0).unwrap();
        gks.set_character_expansion_factor(2.0).unwrap();
        gks.set_character_spacing(0.5).unwrap();
        let (x, y) = (10.0, 20.0);
        // Lengths in world coordinates.
        let gap = 1.5;
        let (top, bottom) = (3.0 * TOP, 3.0 * BOTTOM);
        for path in [TextPath::Right, TextPath::Left, TextPath::Up, TextPath::Down] {
            let along = matches!(path, TextPath::Right | TextPath::Left);
            let length = if along { 2.0 * 6.0 + gap } else { 6.0 };
            let rise = if along { 0.0 } else { top - bottom + gap };
            gks.set_text_path(path).unwrap();
            for horizontal in [Horizontal::Normal, Horizontal::Left, Horizontal::Centre, Horizontal::Right] {
                let resolved = match (horizontal, path) {
                    (Horizontal::Normal, TextPath::Right) => Horizontal::Left,
                    (Horizontal::Normal, TextPath::Left) => Horizontal::Right,
                    (Horizontal::Normal, _) => Horizontal::Centre,
                    (given, _) => given,
                };
                let left = match resolved {
                    Horizontal::Left => x,
                    Horizontal::Right => x - length,
                    _ => x - length / 2.0,
                };
                for (vertical, lowest) in [
                    (Vertical::Normal, if path == TextPath::Down { y - top - rise } else { y }),
                    (Vertical::Top, y - top - rise),
                    (Vertical::Cap, y - 3.0 - rise),
                    (Vertical::Half, y - 1.5 - rise / 2.0),
                    (Vertical::Base, y),
                    (Vertical::Bottom, y - bottom),
                ] {
                    let what = format!("{path:?} {horizontal:?} {vertical:?}");
                    gks.set_text_alignment(horizontal, vertical).unwrap();
                    let extent = gks.inquire_text_extent(1, (x, y), "ab").unwrap();
                    let (low, high) = (lowest + bottom, lowest + rise + top);
                    let right = left + length;
                    for (corner, expected) in extent.corners.into_iter().zip([
                        (left, low),
                        (right, low),
                        (right, high),
                        (left, high),
                    ]) {
                        assert_near(corner, expected, &what);
                    }
                    let down = path == TextPath::Down;
                    let next = match (along, resolved, vertical) {
                        (true, Horizontal::Left, _) => (right + gap, y),
                        (true, Horizontal::Right, _) => (left - gap, y),
                        (true, ..) | (false, _, Vertical::Half) => (x, y),
                        (false, _, Vertical::Top | Vertical::Cap) => (x, low - gap),
                        (false, _, Vertical::Normal) if down => (x, low - gap),
                        (false, ..) => (x, high + gap),
                    };
                    assert_near(extent.concatenation, next, &what);
                }
            }
        }
    }

    #[test]
    fn the_extent_is_the_same_under_every_normalization_transformation() {
        let (mut gks, _) = open(&[PLAIN]);
        gks.set_character_height(2.0).unwrap();
        gks.set_character_up_vector((-5.0, 0.0)).unwrap();
        let plain = gks.inquire_text_extent(1, (1.0, 2.0), "abc").unwrap();
        // Turned by a right angle, text goes upwards and its top is at the left.
        assert_near(plain.concatenation, (1.0, 2.0 + 6.0), "upwards");
        assert_near(plain.corners[0], (1.0 - 2.0 * BOTTOM, 2.0), "lower left");
        assert_near(plain.corners[2], (1.0 - 2.0 * TOP, 2.0 + 6.0), "upper right");
        gks.set_window(1, (-100.0, 500.0, 3.0, 33.0)).unwrap();
        gks.set_viewport(1, (0.1, 0.2, 0.0, 1.0)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        assert_eq!(gks.inquire_text_extent(1, (1.0, 2.0), "abc"), Ok(plain));
    }

    #[test]
    fn bundles_are_those_of_the_workstation() {
        let (mut gks, _) = open(&[PLAIN, PLAIN]);
        gks.set_character_height(1.0).unwrap();
        gks.set_text_representation(2, 1, 1, Precision::Stroke, 3.0, 0.5, 1).unwrap();
        let width = |gks: &Gks, id| {
            let [left, right, ..] = gks.inquire_text_extent(id, (0.0, 0.0), "ab").unwrap().corners;
            right.x() - left.x()
        };
        assert_eq!([1, 2].map(|id| width(&gks, id)), [2.0, 2.0]);
        gks.set_aspect_source_flags(AspectSourceFlags::BUNDLED).unwrap();
        assert_eq!([1, 2].map(|id| width(&gks, id)), [2.0, 6.5]);
    }

    #[test]
    fn text_without_bodies_takes_no_room() {
        let (gks, _) = open(&[PLAIN]);
        for text in ["", "\n"] {
            let extent = gks.inquire_text_extent(1, (4.0, 5.0), text).unwrap();
            let here = Point::new(4.0, 5.0);
            assert_eq!(extent, TextExtent { concatenation: here, corners: [here; 4] });
        }
    }

    /// The points of all strokes, in device units.
    fn strokes(log: &Log) -> Vec<DVec2> {
        let mut points = Vec::new();
        for (drawing, _) in log.marks() {
            let Drawing::Lines(paths, _) = drawing else { panic!("not strokes: {drawing:?}") };
            points.extend(paths.into_iter().flatten());
        }
        points
    }

    #[test]
    fn what_is_drawn_lies_in_the_extent_and_goes_on_at_the_concatenation_point() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_window(1, (0.0, 20.0, 0.0, 50.0)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        gks.set_character_height(2.0).unwrap();
        gks.set_character_up_vector((-1.0, 3.0)).unwrap();
        gks.set_character_spacing(0.25).unwrap();
        let start = (6.0, 25.0);
        for path in [TextPath::Right, TextPath::Left, TextPath::Up, TextPath::Down] {
            // Upwards, the next string goes on where the bodies end: they have to be aligned by their bottoms.
            let vertical = if path == TextPath::Up { Vertical::Bottom } else { Vertical::Normal };
            gks.set_text_path(path).unwrap();
            gks.set_text_alignment(Horizontal::Normal, vertical).unwrap();
            gks.text(start, "WxyM").unwrap();
            let whole = strokes(&log);
            let extent = gks.inquire_text_extent(1, start, "WxyM").unwrap();
            // World coordinates to device units: 1000 units a side.
            let corner = |i: usize| extent.corners[i].0 * DVec2::new(50.0, 20.0);
            let frame = DMat2::from_cols(corner(1) - corner(0), corner(3) - corner(0)).inverse();
            for &point in &whole {
                let at = frame * (point - corner(0));
                assert!(at.min_element() > -1e-9 && at.max_element() < 1.0 + 1e-9, "{path:?}: {at}");
            }
            gks.text(start, "Wx").unwrap();
            let next = gks.inquire_text_extent(1, start, "Wx").unwrap().concatenation;
            gks.text((next.x(), next.y()), "yM").unwrap();
            let parts = strokes(&log);
            assert_eq!(parts.len(), whole.len());
            let same = |(a, b): (&DVec2, &DVec2)| a.abs_diff_eq(*b, 1e-9);
            assert!(parts.iter().zip(&whole).all(same), "{path:?}");
        }
    }
}
