//! Pick: the segment and the primitive at a position, and the pick identifiers of primitives.

use super::value::PickValue;
use crate::{Error, Function, Gks, Result};
use gks_geometry::{Dc, Point};
use gks_pipeline::pick::Aperture;
use gks_pipeline::segment::Segments;
use gks_pipeline::workstation::Workstation;

impl Gks {
    /// SET PICK IDENTIFIER: what primitives of segments are told apart by when one is picked.
    ///
    /// Errors: 8, 97 (negative).
    pub fn set_pick_identifier(&mut self, identifier: i32) -> Result<()> {
        const F: Function = Function::SetPickIdentifier;
        self.check_state(F)?;
        if identifier < 0 {
            return Err(Error::new(97, F).because(format!("pick identifier {identifier}")));
        }
        self.pick = identifier;
        Ok(())
    }

    /// INQUIRE CURRENT PICK IDENTIFIER VALUE. Error: 8.
    pub fn inquire_current_pick_identifier_value(&self) -> Result<i32> {
        self.check_state(Function::InquireCurrentPickIdentifierValue)?;
        Ok(self.pick)
    }
}

/// What is hit by the square around a position on the display surface: of the visible and detectable segments of
/// a workstation the one that is drawn last, and in it the primitive that is drawn last.
pub(super) fn at(
    segments: &Segments,
    id: i32,
    workstation: &mut Workstation,
    position: Point<Dc>,
    half: f64,
) -> Option<PickValue> {
    let mut aperture = Aperture::new(&workstation.description().surface, position, half);
    let candidates = segments.on(id).rev().filter(|segment| segment.is_shown() && segment.detectable);
    for segment in candidates {
        let mut found = None;
        for item in &segment.recording {
            // Only a device fails, and there is none.
            let hit = aperture.meets(workstation, &item, &segment.appearance.transformation);
            if hit.unwrap_or(false) {
                found = Some(PickValue { segment: segment.name(), identifier: item.pick });
            }
        }
        if found.is_some() {
            return found;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Detectability;
    use crate::test_device::{PLAIN, active, number};
    use crate::{CoordinateSwitch, Visibility};

    /// A kernel with a line in segment 1, two areas one over the other in segments 2 and 3, and text in segment 4.
    fn drawn() -> Gks {
        let (mut gks, _) = active(&[PLAIN]);
        let mut segment = |name, pick, draw: &dyn Fn(&mut Gks)| {
            gks.create_segment(name).unwrap();
            gks.set_pick_identifier(pick).unwrap();
            draw(&mut gks);
            gks.close_segment().unwrap();
            gks.set_detectability(name, Detectability::Detectable).unwrap();
        };
        segment(1, 10, &|gks| gks.polyline(&[(0.1, 0.1), (0.9, 0.1)]).unwrap());
        let square = [(0.2, 0.2), (0.6, 0.2), (0.6, 0.6), (0.2, 0.6)];
        segment(2, 20, &|gks| {
            gks.set_fill_area_interior_style(gks_pipeline::look::InteriorStyle::Solid).unwrap();
            gks.fill_area(&square).unwrap();
            gks.set_pick_identifier(21).unwrap();
            gks.fill_area(&square.map(|(x, y)| (x + 0.2, y + 0.2))).unwrap();
        });
        segment(3, 30, &|gks| gks.fill_area(&square.map(|(x, y)| (x + 0.3, y))).unwrap());
        segment(4, 40, &|gks| {
            gks.set_character_height(0.1).unwrap();
            gks.text((0.1, 0.8), "O").unwrap();
        });
        gks
    }

    /// What is picked at a position given in NDC: the name and the pick identifier.
    fn picked(gks: &mut Gks, x: f64, y: f64) -> Option<(i32, i32)> {
        let workstation = &mut gks.workstations.get_mut(&1).unwrap().workstation;
        let position = workstation.device_map().point(Point::new(x, y));
        at(&gks.segments, 1, workstation, position, 0.001).map(|value| (value.segment, value.identifier))
    }

    #[test]
    fn what_is_drawn_last_is_picked() {
        let mut gks = drawn();
        assert_eq!(picked(&mut gks, 0.5, 0.1), Some((1, 10)));
        assert_eq!(picked(&mut gks, 0.5, 0.104), Some((1, 10)));
        assert_eq!(picked(&mut gks, 0.5, 0.12), None);
        assert_eq!(picked(&mut gks, 0.3, 0.3), Some((2, 20)));
        assert_eq!(picked(&mut gks, 0.45, 0.5), Some((2, 21)));
        assert_eq!(picked(&mut gks, 0.55, 0.3), Some((3, 30)));
        gks.set_segment_priority(2, 0.5).unwrap();
        assert_eq!(picked(&mut gks, 0.55, 0.3), Some((2, 20)));
        // Inside of the letter, beside its strokes.
        assert_eq!(picked(&mut gks, 0.15, 0.85), Some((4, 40)));
    }

    #[test]
    fn only_visible_and_detectable_segments_are_picked_where_they_have_been_moved() {
        let mut gks = drawn();
        gks.set_detectability(3, Detectability::Undetectable).unwrap();
        assert_eq!(picked(&mut gks, 0.55, 0.3), Some((2, 20)));
        gks.set_visibility(2, Visibility::Invisible).unwrap();
        assert_eq!(picked(&mut gks, 0.55, 0.3), None);
        let ndc = CoordinateSwitch::Ndc;
        let moved = gks.evaluate_transformation_matrix((0.0, 0.0), (0.0, 0.7), 0.0, (1.0, 1.0), ndc).unwrap();
        gks.set_segment_transformation(1, moved).unwrap();
        assert_eq!(picked(&mut gks, 0.5, 0.1), None);
        assert_eq!(picked(&mut gks, 0.5, 0.8), Some((1, 10)));
    }

    #[test]
    fn pick_identifiers_are_not_negative() {
        let (mut gks, _) = active(&[PLAIN]);
        assert_eq!(number(gks.set_pick_identifier(-1)), 97);
        gks.set_pick_identifier(7).unwrap();
        assert_eq!(gks.inquire_current_pick_identifier_value(), Ok(7));
    }
}
