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
