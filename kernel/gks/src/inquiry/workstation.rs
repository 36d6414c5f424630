//! Inquiries of the workstation state list: control and transformation.

use super::serves;
use crate::gks::OpenWorkstation;
use crate::{Error, Function, Gks, Result};
use gks_pipeline::description::{DeferralMode, RegenerationMode};
use gks_pipeline::workstation::WorkstationTransformation;

/// When output becomes visible on a workstation, and what its display surface shows.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct DeferralAndUpdateStates {
    /// Deferral mode.
    pub deferral: DeferralMode,
    /// Implicit regeneration mode.
    pub regeneration: RegenerationMode,
    /// Whether nothing has been drawn since the display surface was cleared.
    pub empty: bool,
    /// Whether the next update has to start a new frame.
    pub new_frame_necessary: bool,
}

/// The workstation transformation asked for and the one in force.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct WorkstationTransformationState {
    /// Whether the transformation asked for waits for a new frame: the update state PENDING.
    pub pending: bool,
    /// Window and viewport asked for.
    pub requested: WorkstationTransformation,
    /// Window and viewport in force.
    pub current: WorkstationTransformation,
}

impl Gks {
    /// The open workstation with an identifier for an inquiry.
    ///
    /// Errors: those of the state and the category, 20 (identifier below 1), 25 (not open).
    pub(crate) fn inquired(&self, function: Function, id: i32) -> Result<&OpenWorkstation> {
        self.check_state(function)?;
        let Some(open) = self.workstations.get(&id) else {
            return Err(Error::new(if id < 1 { 20 } else { 25 }, function));
        };
        serves(function, open.workstation.description().category)?;
        Ok(open)
    }

    /// INQUIRE WORKSTATION CONNECTION AND TYPE, as they were given to OPEN WORKSTATION. Errors: 7, 20, 25.
    pub fn inquire_workstation_connection_and_type(&self, id: i32) -> Result<(&str, i32)> {
        let open = self.inquired(Function::InquireWorkstationConnectionAndType, id)?;
        Ok((&open.connection, open.kind))
    }

    /// INQUIRE WORKSTATION STATE: whether the workstation is active. Errors: 7, 20, 25, 33 (MI), 35 (INPUT).
    pub fn inquire_workstation_state(&self, id: i32) -> Result<bool> {
        Ok(self.inquired(Function::InquireWorkstationState, id)?.active)
    }

    /// INQUIRE WORKSTATION DEFERRAL AND UPDATE STATES. Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    pub fn inquire_workstation_deferral_and_update_states(&self, id: i32) -> Result<DeferralAndUpdateStates> {
        let open = self.inquired(Function::InquireWorkstationDeferralAndUpdateStates, id)?;
        let (deferral, regeneration) = open.workstation.deferral();
        Ok(DeferralAndUpdateStates {
            deferral,
            regeneration,
            empty: open.workstation.is_empty(),
            new_frame_necessary: open.workstation.is_new_frame_necessary(),
        })
    }

    /// INQUIRE WORKSTATION TRANSFORMATION. Errors: 7, 20, 25, 33 (MI), 36 (WISS).
    pub fn inquire_workstation_transformation(&self, id: i32) -> Result<WorkstationTransformationState> {
        let open = self.inquired(Function::InquireWorkstationTransformation, id)?;
        Ok(WorkstationTransformationState {
            pending: open.workstation.is_pending(),
            requested: open.workstation.requested(),
            current: open.workstation.current(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{CATEGORIES, INDEXED, PLAIN, active, closed, open};
    use gks_geometry::Rect;
    use gks_pipeline::description::Category;

    #[test]
    fn states_identifiers_and_categories_are_checked_in_this_order() {
        let all = |gks: &Gks, id| {
            [
                gks.inquire_workstation_connection_and_type(id).map(drop),
                gks.inquire_workstation_state(id).map(drop),
                gks.inquire_workstation_deferral_and_update_states(id).map(drop),
                gks.inquire_workstation_transformation(id).map(drop),
            ]
            .map(|result| result.map_or_else(|error| error.number, |()| 0))
        };
        assert_eq!(all(&closed(), -1), [7; 4]);
        assert_eq!(all(&open(&[]).0, -1), [7; 4]);
        use Category::{Input, MetafileInput, MetafileOutput, Wiss};
        let kinds = [MetafileInput, Input, Wiss, MetafileOutput].map(|c| CATEGORIES + c as i32);
        let (gks, _) = open(&kinds);
        assert_eq!(all(&gks, 0), [20; 4]);
        assert_eq!(all(&gks, 9), [25; 4]);
        assert_eq!(all(&gks, 1), [0, 33, 33, 33]);
        assert_eq!(all(&gks, 2), [0, 35, 35, 0]);
        assert_eq!(all(&gks, 3), [0, 0, 36, 36]);
        assert_eq!(all(&gks, 4), [0; 4]);
    }

    #[test]
    fn connection_type_and_state_are_those_of_the_workstation() {
        let (mut gks, _) = open(&[PLAIN]);
        gks.open_workstation(5, "file.png", INDEXED).unwrap();
        assert_eq!(gks.inquire_workstation_connection_and_type(5), Ok(("file.png", INDEXED)));
        assert_eq!(gks.inquire_workstation_connection_and_type(1), Ok(("", PLAIN)));
        assert_eq!(gks.inquire_workstation_state(5), Ok(false));
        gks.activate_workstation(5).unwrap();
        assert_eq!(gks.inquire_workstation_state(5), Ok(true));
        assert_eq!(gks.inquire_workstation_state(1), Ok(false));
    }

    #[test]
    fn the_display_surface_tells_whether_it_is_empty_and_out_of_date() {
        let (mut gks, _) = active(&[PLAIN]);
        let start = DeferralAndUpdateStates {
            deferral: DeferralMode::Asti,
            regeneration: RegenerationMode::Suppressed,
            empty: true,
            new_frame_necessary: false,
        };
        let states = |gks: &Gks| gks.inquire_workstation_deferral_and_update_states(1).unwrap();
        assert_eq!(states(&gks), start);
        gks.set_deferral_state(1, DeferralMode::Bnil, RegenerationMode::Suppressed).unwrap();
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        let drawn = DeferralAndUpdateStates { deferral: DeferralMode::Bnil, empty: false, ..start };
        assert_eq!(states(&gks), drawn);
        gks.set_workstation_window(1, (0.0, 0.5, 0.0, 0.5)).unwrap();
        assert_eq!(states(&gks), DeferralAndUpdateStates { new_frame_necessary: true, ..drawn });
        gks.update_workstation(1, true).unwrap();
        assert_eq!(states(&gks), DeferralAndUpdateStates { deferral: DeferralMode::Bnil, ..start });
    }

    #[test]
    fn a_transformation_is_pending_until_a_new_frame() {
        let (mut gks, _) = active(&[INDEXED]);
        let state = |gks: &Gks| gks.inquire_workstation_transformation(1).unwrap();
        let whole = WorkstationTransformation { window: Rect::UNIT, viewport: Rect::new(0.0, 0.2, 0.0, 0.1) };
        let start = WorkstationTransformationState { pending: false, requested: whole, current: whole };
        assert_eq!(state(&gks), start);
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        gks.set_workstation_window(1, (0.0, 0.5, 0.0, 0.5)).unwrap();
        gks.set_workstation_viewport(1, (0.0, 0.05, 0.0, 0.05)).unwrap();
        let asked = WorkstationTransformation {
            window: Rect::new(0.0, 0.5, 0.0, 0.5),
            viewport: Rect::new(0.0, 0.05, 0.0, 0.05),
        };
        assert_eq!(state(&gks), WorkstationTransformationState { pending: true, requested: asked, ..start });
        gks.clear_workstation(1, true).unwrap();
        let done = WorkstationTransformationState { pending: false, requested: asked, current: asked };
        assert_eq!(state(&gks), done);
    }
}
