//! SET MODE: how a device is operated, and whether its value is echoed.

use super::measure::setting;
use super::value::OperatingMode;
use super::{logical, no_device};
use crate::gks::device_error;
use crate::{Function, Gks, Result};
use gks_pipeline::input::{InputClass, LogicalDevice};

macro_rules! modes {
    ($($(#[$doc:meta])* $name:ident, $function:ident, $class:ident;)+) => {
        impl Gks { $(
            $(#[$doc])*
            pub fn $name(&mut self, id: i32, number: i32, mode: OperatingMode, echo: bool) -> Result<()> {
                self.set_mode(Function::$function, id, logical(InputClass::$class, number), mode, echo)
            }
        )+ }
    };
}

modes! {
    /// SET LOCATOR MODE: in SAMPLE and EVENT an interaction begins at once, from the initial value.
    ///
    /// Errors: 7, 20, 25, 38, 140 (no such device), 303.
    set_locator_mode, SetLocatorMode, Locator;
    /// SET STROKE MODE. Errors: as SET LOCATOR MODE.
    set_stroke_mode, SetStrokeMode, Stroke;
    /// SET VALUATOR MODE. Errors: as SET LOCATOR MODE.
    set_valuator_mode, SetValuatorMode, Valuator;
    /// SET CHOICE MODE. Errors: as SET LOCATOR MODE.
    set_choice_mode, SetChoiceMode, Choice;
    /// SET PICK MODE. Errors: as SET LOCATOR MODE, with 37 in the place of 38.
    set_pick_mode, SetPickMode, Pick;
    /// SET STRING MODE. Errors: as SET LOCATOR MODE.
    set_string_mode, SetStringMode, String;
}

impl Gks {
    fn set_mode(
        &mut self,
        function: Function,
        id: i32,
        device: LogicalDevice,
        mode: OperatingMode,
        echo: bool,
    ) -> Result<()> {
        self.check_state(function)?;
        self.input_device(function, id, device)?;
        if mode != OperatingMode::Request {
            self.before_interaction(function, id)?;
        }
        let Gks { workstations, normalization, .. } = self;
        let Some(open) = workstations.get_mut(&id) else { return Err(no_device(function, device)) };
        let state = open.input.get_mut(device).ok_or_else(|| no_device(function, device))?;
        let failed = |error| device_error(function, &error);
        if state.mode != OperatingMode::Request
            && let Some(operator) = open.workstation.input()
        {
            operator.stop(device).map_err(failed)?;
        }
        (state.mode, state.echo) = (mode, echo);
        if mode == OperatingMode::Request {
            return Ok(());
        }
        let setting = setting(normalization, &mut open.workstation, state);
        match open.workstation.input() {
            Some(operator) => operator.start(device, &setting).map_err(failed),
            None => Ok(()),
        }
    }
}
