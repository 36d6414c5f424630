//! Control: opening and closing, workstations, clearing and updating.

use crate::gks::{OpenWorkstation, device_error};
use crate::input::Devices;
use crate::metafile::Items;
use crate::{Error, Function, Gks, OperatingState, Result};
use gks_pipeline::colour::Colour;
use gks_pipeline::description::{Category, DeferralMode, OpenError, RegenerationMode};
use gks_pipeline::generated::numbers;
use gks_pipeline::input::InputClass;
use gks_pipeline::record::Record;
use gks_pipeline::workstation::Workstation;

impl Gks {
    /// OPEN GKS: sets the operating state to GKOP and all state lists to their initial values.
    ///
    /// The error file belongs to the language bindings. Error: 1.
    pub fn open_gks(&mut self) -> Result<()> {
        self.check_state(Function::OpenGks)?;
        self.reset();
        self.state = OperatingState::Gkop;
        Ok(())
    }

    /// CLOSE GKS. Error: 2.
    pub fn close_gks(&mut self) -> Result<()> {
        self.check_state(Function::CloseGks)?;
        self.state = OperatingState::Gkcl;
        Ok(())
    }

    /// OPEN WORKSTATION: opens a workstation of a type under an identifier of the caller's choice.
    ///
    /// The connection is a file name, possibly with options, or a number; see the catalogue of the
    /// installation. Type 0 is the type that the user of the program chose.
    ///
    /// Errors: 8, 20 (identifier not positive), 21 (connection), 22 (negative type), 23 (no such type),
    /// 24 (identifier in use), 26 (cannot be opened), 28 (segment storage is open already), 42 (too many
    /// workstations).
    pub fn open_workstation(&mut self, id: i32, connection: &str, kind: i32) -> Result<()> {
        const F: Function = Function::OpenWorkstation;
        self.check_state(F)?;
        if id < 1 {
            return Err(Error::new(20, F).because(format!("workstation identifier {id}")));
        }
        if kind < 0 {
            return Err(Error::new(22, F).because(format!("workstation type {kind}")));
        }
        let Some(description) = self.catalogue.describe(kind) else {
            return Err(Error::new(23, F).because(format!("workstation type {kind}")));
        };
        if self.workstations.contains_key(&id) {
            return Err(Error::new(24, F).because(format!("workstation identifier {id}")));
        }
        if description.category == Category::Wiss && self.storage().is_some() {
            return Err(Error::new(28, F));
        }
        if self.workstations.len() >= numbers::MAX_OPEN_WORKSTATIONS as usize {
            return Err(Error::new(42, F));
        }
        let (device, description) = self.catalogue.open(kind, connection).map_err(|e| open_error(F, &e))?;
        let mut tables = self.defaults.tables.clone();
        // Who reads a metafile begins with colours of his own.
        let is_metafile = description.category == Category::MetafileOutput;
        let most = description.colour_table_length() as usize;
        let colours =
            (0..).zip(self.defaults.colours.iter().take(most).map(|&colour| Colour::from_packed(colour)));
        for (index, colour) in colours.clone().filter(|_| !is_metafile) {
            tables.colours.set(index, colour);
        }
        let input = Devices::new(&description);
        let workstation = Workstation::new(device, description, tables);
        let connection = connection.to_owned();
        let items = Items::default();
        let open =
            OpenWorkstation { workstation, connection, kind, active: false, changed: false, input, items };
        self.workstations.insert(id, open);
        if self.state == OperatingState::Gkop {
            self.state = OperatingState::Wsop;
        }
        for (index, colour) in colours.filter(|_| is_metafile) {
            self.set_colour_representation(id, index as i32, colour)?;
        }
        Ok(())
    }

    /// CLOSE WORKSTATION: completes the picture and closes the device. Segments that are associated with no
    /// other workstation are deleted.
    ///
    /// A necessary new frame is made, unless primitives outside of segments would be lost with it: nobody is
    /// there to see them vanish. The workstation is closed even if completing the picture fails. Its events are
    /// removed from the queue. Errors: 7, 20, 25, 29 (active), 147 (event reports have been lost; the next call
    /// will close it), 303.
    pub fn close_workstation(&mut self, id: i32) -> Result<()> {
        const F: Function = Function::CloseWorkstation;
        self.check_state(F)?;
        if self.workstation(F, id)?.active {
            return Err(Error::new(29, F).because(format!("workstation identifier {id}")));
        }
        self.check_overflow(F)?;
        self.remove_workstation(F, id)
    }

    fn remove_workstation(&mut self, function: Function, id: i32) -> Result<()> {
        let Some(mut open) = self.workstations.remove(&id) else { return Ok(()) };
        self.events.forget(id);
        let worth = open.workstation.is_worth_redrawing();
        let redrawn = if worth { open.workstation.redraw(self.segments.on(id)) } else { Ok(()) };
        self.segments.forget(id);
        if self.workstations.is_empty() {
            self.state = OperatingState::Gkop;
        }
        redrawn.and(open.workstation.close()).map_err(|e| device_error(function, &e))
    }

    /// ACTIVATE WORKSTATION: output goes to the workstation from now on.
    ///
    /// Errors: 6, 20, 25, 29 (already active), 33, 35, 43 (too many).
    pub fn activate_workstation(&mut self, id: i32) -> Result<()> {
        const F: Function = Function::ActivateWorkstation;
        self.check_state(F)?;
        let active = self.workstations.values().filter(|open| open.active).count();
        let open = self.workstation_mut(F, id)?;
        if open.active {
            return Err(Error::new(29, F).because(format!("workstation identifier {id}")));
        }
        suits(F, open.workstation.description().category)?;
        if active >= numbers::MAX_ACTIVE_WORKSTATIONS as usize {
            return Err(Error::new(43, F));
        }
        open.active = true;
        self.state = OperatingState::Wsac;
        Ok(())
    }

    /// DEACTIVATE WORKSTATION: output no longer goes to the workstation.
    ///
    /// Errors: 3, 20, 30 (not active).
    pub fn deactivate_workstation(&mut self, id: i32) -> Result<()> {
        const F: Function = Function::DeactivateWorkstation;
        self.check_state(F)?;
        if id < 1 {
            return Err(Error::new(20, F).because(format!("workstation identifier {id}")));
        }
        match self.workstations.get_mut(&id) {
            Some(open) if open.active => open.active = false,
            _ => return Err(Error::new(30, F).because(format!("workstation identifier {id}"))),
        }
        if !self.workstations.values().any(|open| open.active) {
            self.state = OperatingState::Wsop;
        }
        Ok(())
    }

    /// CLEAR WORKSTATION: starts a new picture. What was drawn is completed; nothing is written for a
    /// picture in which nothing was drawn. Segments that are associated with no other workstation are deleted.
    ///
    /// `always` has a display surface cleared that has been read but not drawn on; no page is written for one
    /// that has not even been read. Errors: 6, 20, 25, 33, 35, 303.
    pub fn clear_workstation(&mut self, id: i32, always: bool) -> Result<()> {
        const F: Function = Function::ClearWorkstation;
        self.check_state(F)?;
        let cleared = self.suitable_workstation(F, id)?.clear(always).map_err(|e| device_error(F, &e));
        self.segments.forget(id);
        cleared
    }

    /// UPDATE WORKSTATION: makes all output visible and, if `perform` is set and a new frame is necessary,
    /// draws the picture again as REDRAW ALL SEGMENTS ON WORKSTATION does.
    ///
    /// Errors: 7, 20, 25, 33, 35, 36, 303.
    pub fn update_workstation(&mut self, id: i32, perform: bool) -> Result<()> {
        const F: Function = Function::UpdateWorkstation;
        self.check_state(F)?;
        self.suitable_workstation(F, id)?;
        let Some(open) = self.workstations.get_mut(&id) else { return Ok(()) };
        open.workstation.update(perform, self.segments.on(id)).map_err(|e| device_error(F, &e))
    }

    /// REDRAW ALL SEGMENTS ON WORKSTATION: clears the display surface, lets the requested workstation
    /// transformation take effect and draws all visible segments in the order of their priority.
    ///
    /// What was drawn outside of segments is lost. A picture in memory or in a file that is not complete is
    /// replaced; where pages have gone to paper or into a stream the new picture is on the next page.
    /// Errors: 7, 20, 25, 33, 35, 36, 303.
    pub fn redraw_all_segments_on_workstation(&mut self, id: i32) -> Result<()> {
        const F: Function = Function::RedrawAllSegmentsOnWorkstation;
        self.check_state(F)?;
        self.suitable_workstation(F, id)?;
        self.regenerate(F, id)
    }

    /// Draws the picture of a workstation again.
    pub(crate) fn regenerate(&mut self, function: Function, id: i32) -> Result<()> {
        let Some(open) = self.workstations.get_mut(&id) else { return Ok(()) };
        open.workstation.redraw(self.segments.on(id)).map_err(|e| device_error(function, &e))
    }

    /// Makes a regeneration that is due and not deferred.
    pub(crate) fn settle(&mut self, function: Function, id: i32) -> Result<()> {
        let workstation = self.workstations.get(&id).map(|open| &open.workstation);
        let now = workstation.is_some_and(|w| w.is_prompt() && w.is_regeneration_due());
        if now { self.regenerate(function, id) } else { Ok(()) }
    }

    /// Makes visible what may not wait for an interaction with a workstation: everything deferred there, and
    /// on workstations whose deferral mode is BNIG.
    pub fn before_interaction(&mut self, function: Function, with: i32) -> Result<()> {
        let mut failure = Ok(());
        for (&id, OpenWorkstation { workstation, .. }) in &mut self.workstations {
            if id != with && workstation.deferral().0 != DeferralMode::Bnig {
                continue;
            }
            let due = workstation.is_regeneration_due();
            let done = if due { workstation.redraw(self.segments.on(id)) } else { Ok(()) };
            let done = done.and(workstation.flush());
            failure = failure.and(done.map_err(|e| device_error(function, &e)));
        }
        failure
    }

    /// Makes changes of segments visible before REQUEST and SAMPLE, where the initial values say so.
    pub(crate) fn update_before_input(&mut self, id: i32, class: InputClass) -> Result<()> {
        let updates = self.defaults.updates_before_input && class != InputClass::Pick;
        let Some(open) = self.workstations.get_mut(&id).filter(|open| updates && open.changed) else {
            return Ok(());
        };
        open.changed = false;
        self.update_workstation(id, true)
    }

    /// SET DEFERRAL STATE: how long output may be delayed, and whether changes may redraw the picture
    /// unasked.
    ///
    /// Errors: 7, 20, 25, 33, 35, 36, 303.
    pub fn set_deferral_state(
        &mut self,
        id: i32,
        deferral: DeferralMode,
        regeneration: RegenerationMode,
    ) -> Result<()> {
        const F: Function = Function::SetDeferralState;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let deferred = workstation.is_regeneration_due();
        let allowed = regeneration == RegenerationMode::Allowed;
        let set = workstation.set_deferral(deferral, regeneration).map_err(|e| device_error(F, &e));
        // What was due is not given up by forbidding it.
        if deferred && !allowed { self.regenerate(F, id).and(set) } else { self.settle(F, id).and(set) }
    }

    /// MESSAGE: passes a text to the user of a workstation, beside the picture.
    ///
    /// The text goes to the handler of [`Gks::on_message`]. Errors: 7, 20, 25, 36.
    pub fn message(&mut self, id: i32, text: &str) -> Result<()> {
        const F: Function = Function::Message;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let recorded = workstation.control(&Record::Message(text)).map_err(|e| device_error(F, &e));
        // The text is in the metafile, where nobody can read it now.
        if workstation.description().category == Category::MetafileOutput {
            return recorded;
        }
        if let Some(handler) = &mut self.on_message {
            handler(id, text);
        }
        Ok(())
    }

    /// EMERGENCY CLOSE GKS: completes and closes whatever is open, in any state.
    pub fn emergency_close_gks(&mut self) {
        if self.state == OperatingState::Sgop {
            let _ = self.end_segment(Function::EmergencyCloseGks);
        }
        let ids: Vec<i32> = self.workstations.keys().copied().collect();
        for id in ids {
            // Each workstation is closed as well as possible; there is nobody left to hear of failures.
            let _ = self.remove_workstation(Function::EmergencyCloseGks, id);
        }
        self.state = OperatingState::Gkcl;
    }

    /// The operating state. INQUIRE OPERATING STATE VALUE.
    #[inline]
    pub fn inquire_operating_state_value(&self) -> OperatingState {
        self.state
    }

    /// The open workstation with an identifier, to be changed, if the function is one for its category.
    ///
    /// Errors: 20, 25, and those of 33 (MI), 35 (INPUT) and 36 (WISS) that the standard lists for the
    /// function.
    pub(crate) fn suitable_workstation(&mut self, function: Function, id: i32) -> Result<&mut Workstation> {
        let workstation = &mut self.workstation_mut(function, id)?.workstation;
        suits(function, workstation.description().category)?;
        Ok(workstation)
    }
}

/// The error of a workstation that cannot be opened: 21, 23 or 26.
pub(crate) fn open_error(function: Function, error: &OpenError) -> Error {
    let number = match error {
        OpenError::NoSuchType(_) => 23,
        OpenError::Connection(..) => 21,
        OpenError::CannotOpen(_) => 26,
    };
    Error::new(number, function).because(error.to_string())
}

/// Checks that a function may be used on workstations of a category.
fn suits(function: Function, category: Category) -> Result<()> {
    let number = match category {
        Category::MetafileInput => 33,
        Category::Input => 35,
        Category::Wiss => 36,
        Category::Output | Category::OutIn | Category::MetafileOutput => return Ok(()),
    };
    if function.errors().contains(&number) { Err(Error::new(number, function)) } else { Ok(()) }
}

impl Drop for Gks {
    /// A kernel that is dropped open completes its pictures, as EMERGENCY CLOSE GKS does.
    fn drop(&mut self) {
        self.emergency_close_gks();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{BROKEN, CATEGORIES, Event, INDEXED, PLAIN, active, closed, number, open};
    use std::sync::{Arc, Mutex};

    const LINE: [(f64, f64); 2] = [(0.0, 0.0), (1.0, 1.0)];

    /// A number for each event: 1 begin, 2 draw, 3 end, 4 close, 5 erase.
    fn course(events: &[Event]) -> Vec<u32> {
        let kind = |event: &Event| match event {
            Event::Begin(_) => 1,
            Event::Draw(..) => 2,
            Event::End => 3,
            Event::Close => 4,
            Event::Erase(_) => 5,
        };
        events.iter().map(kind).collect()
    }

    #[test]
    fn functions_need_their_operating_states() {
        let mut gks = closed();
        assert_eq!(number(gks.close_gks()), 2);
        assert_eq!(number(gks.open_workstation(0, "", -1)), 8);
        assert_eq!(number(gks.close_workstation(0)), 7);
        assert_eq!(number(gks.clear_workstation(0, true)), 6);
        assert_eq!(number(gks.update_workstation(0, true)), 7);
        assert_eq!(number(gks.message(0, "")), 7);
        gks.open_gks().unwrap();
        assert_eq!(number(gks.open_gks()), 1);
        assert_eq!(number(gks.activate_workstation(0)), 6);
        assert_eq!(number(gks.deactivate_workstation(0)), 3);
        gks.open_workstation(1, "", PLAIN).unwrap();
        assert_eq!(gks.inquire_operating_state_value(), OperatingState::Wsop);
        assert_eq!(number(gks.close_gks()), 2);
        gks.activate_workstation(1).unwrap();
        assert_eq!(gks.inquire_operating_state_value(), OperatingState::Wsac);
        assert_eq!(number(gks.close_workstation(1)), 29);
        gks.deactivate_workstation(1).unwrap();
        assert_eq!(gks.inquire_operating_state_value(), OperatingState::Wsop);
        gks.close_workstation(1).unwrap();
        assert_eq!(gks.inquire_operating_state_value(), OperatingState::Gkop);
        gks.close_gks().unwrap();
    }

    #[test]
    fn a_workstation_that_cannot_be_opened_is_reported() {
        let (mut gks, _) = open(&[PLAIN]);
        let refused =
            |gks: &mut Gks, id, connection, kind| number(gks.open_workstation(id, connection, kind));
        assert_eq!(refused(&mut gks, 0, "nonsense", -1), 20);
        assert_eq!(refused(&mut gks, 1, "nonsense", -1), 22);
        assert_eq!(refused(&mut gks, 1, "nonsense", 31_999), 23);
        assert_eq!(refused(&mut gks, 1, "nonsense", PLAIN), 24);
        assert_eq!(refused(&mut gks, 2, "nonsense", PLAIN), 21);
        assert_eq!(refused(&mut gks, 2, "unwritable", PLAIN), 26);
        for id in 2..=32 {
            gks.open_workstation(id, "", PLAIN).unwrap();
        }
        assert_eq!(refused(&mut gks, 33, "", PLAIN), 42);
    }

    #[test]
    fn identifiers_are_checked() {
        let (mut gks, _) = active(&[PLAIN]);
        for (id, error) in [(0, 20), (7, 25)] {
            assert_eq!(number(gks.close_workstation(id)), error);
            assert_eq!(number(gks.activate_workstation(id)), error);
            assert_eq!(number(gks.clear_workstation(id, true)), error);
            assert_eq!(number(gks.update_workstation(id, true)), error);
            assert_eq!(number(gks.message(id, "")), error);
            let deferral = gks.set_deferral_state(id, DeferralMode::Asap, RegenerationMode::Allowed);
            assert_eq!(number(deferral), error);
        }
        assert_eq!(number(gks.activate_workstation(1)), 29);
        assert_eq!(number(gks.deactivate_workstation(0)), 20);
        assert_eq!(number(gks.deactivate_workstation(7)), 30);
    }

    #[test]
    fn functions_refuse_categories_that_the_standard_names() {
        let kinds = [Category::MetafileInput, Category::Input, Category::Wiss, Category::MetafileOutput];
        let (mut gks, _) = open(&kinds.map(|category| CATEGORIES + category as i32));
        let mut errors = |id| {
            let number = |result: Result<()>| result.err().map_or(0, |e| e.number);
            [
                number(gks.activate_workstation(id)),
                number(gks.clear_workstation(id, true)),
                number(gks.update_workstation(id, true)),
                number(gks.set_deferral_state(id, DeferralMode::Asap, RegenerationMode::Allowed)),
                number(gks.message(id, "")),
            ]
        };
        assert_eq!(errors(1), [33, 33, 33, 33, 0]);
        assert_eq!(errors(2), [35, 35, 35, 35, 0]);
        assert_eq!(errors(3), [0, 0, 36, 36, 36]);
        assert_eq!(errors(4), [0, 0, 0, 0, 0]);
    }

    #[test]
    fn a_page_is_written_for_what_was_drawn_and_one_at_least() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.clear_workstation(1, true).unwrap();
        gks.polyline(&LINE).unwrap();
        gks.clear_workstation(1, false).unwrap();
        gks.clear_workstation(1, true).unwrap();
        assert_eq!(course(&log.take()), [1, 2, 3]);
        gks.polyline(&LINE).unwrap();
        gks.emergency_close_gks();
        assert_eq!(course(&log.take()), [1, 2, 3, 4]);
        let (mut gks, log) = open(&[PLAIN]);
        gks.close_workstation(1).unwrap();
        assert_eq!(course(&log.take()), [1, 3, 4]);
    }

    #[test]
    fn an_empty_surface_that_was_read_is_cleared_only_always() {
        let (mut gks, log) = open(&[INDEXED]);
        let read = |gks: &mut Gks| {
            let open = gks.workstations.get_mut(&1).unwrap();
            assert!(open.workstation.frame_buffer().unwrap().is_some());
        };
        read(&mut gks);
        gks.clear_workstation(1, false).unwrap();
        assert_eq!(course(&log.take()), [1]);
        gks.clear_workstation(1, true).unwrap();
        assert_eq!(course(&log.take()), [3]);
    }

    #[test]
    fn a_workstation_whose_device_fails_can_be_closed() {
        let (mut gks, log) = active(&[BROKEN]);
        assert_eq!(number(gks.polyline(&LINE)), 303);
        gks.deactivate_workstation(1).unwrap();
        gks.close_workstation(1).unwrap();
        assert_eq!(course(&log.take()), [1, 3, 4]);
    }

    #[test]
    fn messages_go_to_the_handler() {
        let heard = Arc::new(Mutex::new(Vec::new()));
        let (mut gks, _) = open(&[PLAIN]);
        gks.message(1, "nobody hears").unwrap();
        let ear = Arc::clone(&heard);
        gks.on_message(Box::new(move |id, text| ear.lock().unwrap().push((id, text.to_owned()))));
        gks.message(1, "hello").unwrap();
        assert_eq!(*heard.lock().unwrap(), [(1, "hello".to_owned())]);
    }
}
