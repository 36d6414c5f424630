//! Pick: the segment and the primitive at a position, and the pick identifiers of primitives.

use super::value::PickValue;
use crate::gks::{OpenWorkstation, device_error};
use crate::{Error, Function, Gks, Result};
use gks_geometry::{Dc, Point};
use gks_pipeline::input::{Detail, LogicalDevice};
use gks_pipeline::pick::Aperture;
use gks_pipeline::segment::{Segment, Segments};
use gks_pipeline::trace::Trace;
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

    /// Has the operator shown what a device picks at a position: the prompt and echo types of picks are 1 the
    /// primitive, 2 all primitives of the segment with its pick identifier, 3 the segment.
    pub(super) fn point_out(
        &mut self,
        function: Function,
        id: i32,
        device: LogicalDevice,
        position: Option<Point<Dc>>,
    ) -> Result<()> {
        let Gks { workstations, segments, .. } = self;
        let Some(OpenWorkstation { workstation, input, .. }) = workstations.get_mut(&id) else {
            return Ok(());
        };
        let Some(state) = input.get(device).filter(|state| state.echo) else { return Ok(()) };
        let picked = match (position, &state.menu, &state.detail) {
            (Some(at), Some(menu), _) => menu
                .at(workstation, &state.area, at)
                .map(|alternative| menu.trace(workstation, &state.area, Some(alternative))),
            (Some(at), None, &Detail::Pick { aperture }) => {
                hit(segments, id, workstation, at, aperture).map(|hit| hit.trace(workstation, state.prompt))
            }
            _ => None,
        };
        match workstation.input() {
            Some(operator) => operator
                .show(device, picked.unwrap_or_default())
                .map_err(|error| device_error(function, &error)),
            None => Ok(()),
        }
    }
}

/// What is picked.
struct Hit<'s> {
    segment: &'s Segment,
    /// The place of the primitive among those of the segment.
    primitive: usize,
    identifier: i32,
}

impl Hit<'_> {
    /// What is echoed with a prompt and echo type, highlighted.
    fn trace(&self, workstation: &mut Workstation, prompt: i32) -> Trace {
        let place = workstation.in_picture(&self.segment.appearance.transformation);
        let items = self.segment.recording.iter();
        let trace = match prompt {
            2 => Trace::of(workstation, items.filter(|i| i.pick == self.identifier), &place, true),
            3 => Trace::of(workstation, items, &place, true),
            _ => Trace::of(workstation, items.skip(self.primitive).take(1), &place, true),
        };
        // Only a device fails, and there is none.
        trace.unwrap_or_default()
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
    let Hit { segment, identifier, .. } = hit(segments, id, workstation, position, half)?;
    Some(PickValue { segment: segment.name(), identifier })
}

fn hit<'s>(
    segments: &'s Segments,
    id: i32,
    workstation: &mut Workstation,
    position: Point<Dc>,
    half: f64,
) -> Option<Hit<'s>> {
    let mut aperture = Aperture::new(&workstation.description().surface, position, half);
    let candidates = segments.on(id).rev().filter(|segment| segment.is_shown() && segment.detectable);
    for segment in candidates {
        let place = workstation.in_picture(&segment.appearance.transformation);
        let mut found = None;
        for (primitive, item) in segment.recording.iter().enumerate() {
            // Only a device fails, and there is none.
            if aperture.meets(workstation, &item, &place).unwrap_or(false) {
                found = Some(Hit { segment, primitive, identifier: item.pick });
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
    fn a_primitive_a_group_or_a_segment_is_echoed() {
        let mut gks = drawn();
        let workstation = &mut gks.workstations.get_mut(&1).unwrap().workstation;
        let position = workstation.device_map().point(Point::new(0.3, 0.3));
        let hit = hit(&gks.segments, 1, workstation, position, 0.001).unwrap();
        let widths = [1, 2, 3].map(|prompt| hit.trace(workstation, prompt).bounds().unwrap().width().round());
        // Two squares of 400 units, one of them 200 units to the right.
        assert_eq!(widths, [400.0, 400.0, 600.0]);
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
