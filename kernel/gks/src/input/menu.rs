//! Pictures to choose from: prompt and echo type 5 of choice devices.
//!
//! INITIALISE CHOICE copies a segment; while the device is started, the unit square of NDC fills the echo area with
//! it. The primitives with the first pick identifier of the data record are the first alternative, and so on.

use crate::DataRecord;
use gks_geometry::{Dc, Point, Rect};
use gks_pipeline::generated::numbers;
use gks_pipeline::item::Item;
use gks_pipeline::pick::Aperture;
use gks_pipeline::recording::Recording;
use gks_pipeline::segment::Segments;
use gks_pipeline::trace::Trace;
use gks_pipeline::workstation::Workstation;

/// A picture to choose from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Menu {
    picture: Recording,
    /// The pick identifier of each alternative.
    identifiers: Vec<i32>,
}

impl Menu {
    /// The menu that a data record asks for; none where there is no such segment.
    pub(super) fn of(segments: &Segments, record: &DataRecord) -> Option<Menu> {
        let (&name, identifiers) = record.integers.split_first()?;
        let segment = segments.get(name)?;
        let mut picture = Recording::new();
        for item in &segment.recording {
            picture.push_mapped(&item, &segment.appearance.transformation);
        }
        Some(Menu { picture, identifiers: identifiers.to_vec() })
    }

    /// The alternative of a primitive, from 1.
    fn alternative(&self, item: &Item<'_>) -> Option<i32> {
        let at = self.identifiers.iter().position(|&identifier| identifier == item.pick)?;
        i32::try_from(at + 1).ok()
    }

    /// The alternative at a position on the display surface, if one is there and the menu fills `area`.
    pub(super) fn at(
        &self,
        workstation: &mut Workstation,
        area: &Rect<Dc>,
        position: Point<Dc>,
    ) -> Option<i32> {
        let description = workstation.description();
        let (width, height) = description.size();
        let half = width.min(height) * numbers::INPUT_PICK_APERTURE;
        let mut aperture = Aperture::new(&description.surface, position, half);
        let place = workstation.in_area(area);
        let mut found = None;
        for item in &self.picture {
            let alternative = self.alternative(&item);
            // Only a device fails, and there is none.
            if alternative.is_some() && aperture.meets(workstation, &item, &place).unwrap_or(false) {
                found = alternative;
            }
        }
        found
    }

    /// What the menu looks like where it fills `area`, or one of its alternatives, highlighted.
    pub(super) fn trace(
        &self,
        workstation: &mut Workstation,
        area: &Rect<Dc>,
        highlighted: Option<i32>,
    ) -> Trace {
        let place = workstation.in_area(area);
        let is_wanted = |item: &Item<'_>| highlighted.is_none() || self.alternative(item) == highlighted;
        let items = self.picture.iter().filter(is_wanted);
        Trace::of(workstation, items, &place, highlighted.is_some()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Gks;
    use crate::test_device::{PLAIN, active};

    /// A kernel with a menu of two lines, the upper one first, which fills the left lower quarter of the surface.
    fn made() -> (Gks, Menu, Rect<Dc>) {
        let (mut gks, _) = active(&[PLAIN]);
        gks.create_segment(5).unwrap();
        for (pick, y) in [(8, 0.2), (7, 0.8), (9, 0.5)] {
            gks.set_pick_identifier(pick).unwrap();
            gks.polyline(&[(0.1, y), (0.9, y)]).unwrap();
        }
        gks.close_segment().unwrap();
        let menu = Menu::of(&gks.segments, &DataRecord::new(&[5, 7, 8], &[], &[])).unwrap();
        gks.delete_segment(5).unwrap();
        (gks, menu, Rect::new(0.0, 0.1, 0.0, 0.1))
    }

    #[test]
    fn the_parts_of_a_segment_are_alternatives() {
        let (mut gks, menu, area) = made();
        let workstation = &mut gks.workstations.get_mut(&1).unwrap().workstation;
        let mut at = |x, y| menu.at(workstation, &area, Point::new(x, y));
        assert_eq!([at(0.05, 0.08), at(0.05, 0.02)], [Some(1), Some(2)]);
        assert_eq!(at(0.05, 0.05), None, "its pick identifier is not in the list");
        assert_eq!(at(0.15, 0.08), None, "beside the menu");
    }

    #[test]
    fn a_menu_fills_its_area_and_one_alternative_is_highlighted() {
        let (mut gks, menu, area) = made();
        let workstation = &mut gks.workstations.get_mut(&1).unwrap().workstation;
        let all = menu.trace(workstation, &area, None).bounds().unwrap();
        // 1000 units for 0.2 m.
        let near = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(near(all.limits(), [50.0, 450.0, 100.0, 400.0]), "{all:?}");
        let second = menu.trace(workstation, &area, Some(2));
        assert!(near(second.bounds().unwrap().limits(), [50.0, 450.0, 100.0, 100.0]));
        assert!(menu.trace(workstation, &area, Some(3)).is_empty());
    }

    #[test]
    fn a_segment_that_there_is_not_makes_no_menu() {
        let (gks, _) = active(&[PLAIN]);
        assert_eq!(Menu::of(&gks.segments, &DataRecord::new(&[5, 7, 8], &[], &[])), None);
        assert_eq!(Menu::of(&gks.segments, &DataRecord::default()), None);
    }
}
