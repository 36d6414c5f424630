//! Control: opening and closing, workstations, clearing and updating.

use crate::gks::{OpenWorkstation, device_error};
use crate::{Error, Function, Gks, OperatingState, Result};
use gks_pipeline::description::{Category, DeferralMode, OpenError, RegenerationMode};
use gks_pipeline::generated::numbers;
use gks_pipeline::tables::Tables;
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
    /// 24 (identifier in use), 26 (cannot be opened), 42 (too many workstations).
    pub fn open_workstation(&mut self, id: i32, connection: &str, kind: i32) -> Result<()> {
        const F: Function = Function::OpenWorkstation;
        self.check_state(F)?;
        if id < 1 {
            return Err(Error::new(20, F).because(format!("workstation identifier {id}")));
        }
        if kind < 0 {
            return Err(Error::new(22, F).because(format!("workstation type {kind}")));
        }
        if self.catalogue.describe(kind).is_none() {
            return Err(Error::new(23, F).because(format!("workstation type {kind}")));
        }
        if self.workstations.contains_key(&id) {
            return Err(Error::new(24, F).because(format!("workstation identifier {id}")));
        }
        if self.workstations.len() >= numbers::MAX_OPEN_WORKSTATIONS as usize {
            return Err(Error::new(42, F));
        }
        let (device, description) = self.catalogue.open(kind, connection).map_err(|e| {
            let number = match e {
                OpenError::NoSuchType(_) => 23,
                OpenError::Connection(..) => 21,
                OpenError::CannotOpen(_) => 26,
            };
            Error::new(number, F).because(e.to_string())
        })?;
        let workstation = Workstation::new(device, description, Tables::predefined());
        let connection = connection.to_owned();
        self.workstations.insert(id, OpenWorkstation { workstation, connection, kind, active: false });
        if self.state == OperatingState::Gkop {
            self.state = OperatingState::Wsop;
        }
        Ok(())
    }

    /// CLOSE WORKSTATION: completes the picture and closes the device.
    ///
    /// The workstation is closed even if completing the picture fails. Errors: 7, 20, 25, 29 (active), 303.
    pub fn close_workstation(&mut self, id: i32) -> Result<()> {
        const F: Function = Function::CloseWorkstation;
        self.check_state(F)?;
        if self.workstation(F, id)?.active {
            return Err(Error::new(29, F).because(format!("workstation identifier {id}")));
        }
        self.remove_workstation(F, id)
    }

    fn remove_workstation(&mut self, function: Function, id: i32) -> Result<()> {
        let Some(open) = self.workstations.remove(&id) else { return Ok(()) };
        if self.workstations.is_empty() {
            self.state = OperatingState::Gkop;
        }
        open.workstation.close().map_err(|e| device_error(function, &e))
    }

    /// ACTIVATE WORKSTATION: output goes to the workstation from now on.
    ///
    /// Errors: 6, 20, 25, 29 (already active), 43 (too many).
    pub fn activate_workstation(&mut self, id: i32) -> Result<()> {
        const F: Function = Function::ActivateWorkstation;
        self.check_state(F)?;
        let active = self.workstations.values().filter(|open| open.active).count();
        let open = self.workstation_mut(F, id)?;
        if open.active {
            return Err(Error::new(29, F).because(format!("workstation identifier {id}")));
        }
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
    /// picture in which nothing was drawn.
    ///
    /// `always` has the display surface cleared even if it is empty. Errors: 6, 20, 25, 303.
    pub fn clear_workstation(&mut self, id: i32, _always: bool) -> Result<()> {
        const F: Function = Function::ClearWorkstation;
        self.check_state(F)?;
        self.workstation_mut(F, id)?.workstation.clear().map_err(|e| device_error(F, &e))
    }

    /// UPDATE WORKSTATION: makes all output visible and, if `perform` is set and a new frame is necessary,
    /// starts the new frame.
    ///
    /// Errors: 7, 20, 25, 303.
    pub fn update_workstation(&mut self, id: i32, perform: bool) -> Result<()> {
        const F: Function = Function::UpdateWorkstation;
        self.check_state(F)?;
        self.workstation_mut(F, id)?.workstation.update(perform).map_err(|e| device_error(F, &e))
    }

    /// SET DEFERRAL STATE: how long output may be delayed, and whether changes may redraw the picture
    /// unasked.
    ///
    /// Errors: 7, 20, 25, 303.
    pub fn set_deferral_state(
        &mut self,
        id: i32,
        deferral: DeferralMode,
        regeneration: RegenerationMode,
    ) -> Result<()> {
        const F: Function = Function::SetDeferralState;
        self.check_state(F)?;
        let workstation = &mut self.workstation_mut(F, id)?.workstation;
        workstation.set_deferral(deferral, regeneration).map_err(|e| device_error(F, &e))
    }

    /// MESSAGE: passes a text to the user of a workstation, beside the picture.
    ///
    /// The text goes to the handler of [`Gks::on_message`]. Errors: 7, 20, 25.
    pub fn message(&mut self, id: i32, text: &str) -> Result<()> {
        const F: Function = Function::Message;
        self.check_state(F)?;
        self.workstation(F, id)?;
        if let Some(handler) = &mut self.on_message {
            handler(id, text);
        }
        Ok(())
    }

    /// EMERGENCY CLOSE GKS: completes and closes whatever is open, in any state.
    pub fn emergency_close_gks(&mut self) {
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

    /// The open workstation with an identifier, to be changed, if it draws or records what is drawn.
    ///
    /// Errors: 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    pub(crate) fn drawing_workstation(&mut self, function: Function, id: i32) -> Result<&mut Workstation> {
        let workstation = &mut self.workstation_mut(function, id)?.workstation;
        Gks::drawing_category(function, workstation.description().category)?;
        Ok(workstation)
    }

    /// Checks that a workstation draws. Errors: 33 (MI), 35 (INPUT), 36 (WISS).
    pub(crate) fn drawing_category(function: Function, category: Category) -> Result<()> {
        match category {
            Category::MetafileInput => Err(Error::new(33, function)),
            Category::Input => Err(Error::new(35, function)),
            Category::Wiss => Err(Error::new(36, function)),
            Category::Output | Category::OutIn | Category::MetafileOutput => Ok(()),
        }
    }
}

impl Drop for Gks {
    /// A kernel that is dropped open completes its pictures, as EMERGENCY CLOSE GKS does.
    fn drop(&mut self) {
        self.emergency_close_gks();
    }
}
