//! REQUEST: the application waits for the operator.

use super::measure::setting;
use super::value::{InputValue, LocatorValue, OfClass, OperatingMode, PickValue, StrokeValue};
use super::{logical, no_device};
use crate::gks::{device_error, receiving_error};
use crate::{Error, Function, Gks, Result};
use gks_pipeline::input::{InputClass, LogicalDevice, Report};

macro_rules! requests {
    ($($(#[$doc:meta])* $name:ident, $function:ident, $class:ident -> $value:ty;)+) => {
        impl Gks { $(
            $(#[$doc])*
            pub fn $name(&mut self, id: i32, number: i32) -> Result<Option<$value>> {
                let value = self.request(Function::$function, id, logical(InputClass::$class, number))?;
                Ok(value.and_then(<$value>::of))
            }
        )+ }
    };
}

requests! {
    /// REQUEST LOCATOR: waits for a position; none if the operator breaks or is gone.
    ///
    /// Errors: 7, 20, 25, 38, 140 (no such device), 141 (not in mode REQUEST), 303, 305.
    request_locator, RequestLocator, Locator -> LocatorValue;
    /// REQUEST STROKE: waits for positions. Errors: as REQUEST LOCATOR.
    request_stroke, RequestStroke, Stroke -> StrokeValue;
    /// REQUEST VALUATOR: waits for a number. Errors: as REQUEST LOCATOR.
    request_valuator, RequestValuator, Valuator -> f64;
    /// REQUEST CHOICE: waits for an alternative, of which the operator may choose none. Errors: as REQUEST
    /// LOCATOR.
    request_choice, RequestChoice, Choice -> Option<i32>;
    /// REQUEST PICK: waits for the operator to point at something, which may be nothing. Errors: as REQUEST
    /// LOCATOR, with 37 in the place of 38.
    request_pick, RequestPick, Pick -> Option<PickValue>;
    /// REQUEST STRING: waits for text. Errors: as REQUEST LOCATOR.
    request_string, RequestString, String -> String;
}

impl Gks {
    /// Waits for the value of a device; none if the operator breaks or is gone. What the operator does with
    /// devices in mode EVENT meanwhile is queued.
    fn request(&mut self, function: Function, id: i32, device: LogicalDevice) -> Result<Option<InputValue>> {
        self.check_state(function)?;
        if self.input_device(function, id, device)?.mode != OperatingMode::Request {
            return Err(Error::new(141, function));
        }
        self.update_before_input(id, device.class)?;
        self.before_interaction(function, id)?;
        let failed = |error| device_error(function, &error);
        let Gks { workstations, normalization, .. } = self;
        let Some(open) = workstations.get_mut(&id) else { return Ok(None) };
        let state = open.input.get(device).ok_or_else(|| no_device(function, device))?;
        let setting = setting(normalization, &open.workstation, state);
        let Some(operator) = open.workstation.input() else { return Ok(None) };
        operator.start(device, &setting).map_err(failed)?;
        let answer = self.answer(function, id, device);
        let stopped = match self.workstation_mut(function, id)?.workstation.input() {
            Some(operator) => operator.stop(device).map_err(failed),
            None => Ok(()),
        };
        let answer = answer?;
        stopped.and(Ok(answer))
    }

    /// Takes what the operator reports until it is about `device`.
    fn answer(&mut self, function: Function, id: i32, device: LogicalDevice) -> Result<Option<InputValue>> {
        loop {
            let open = self.workstation_mut(function, id)?;
            let Some(operator) = open.workstation.input() else { return Ok(None) };
            let report = operator.wait(None).map_err(|error| receiving_error(function, &error))?;
            let Report::Trigger(mut measures) = report else { return Ok(None) };
            let mine = measures.iter().position(|(of, _)| *of == device).map(|at| measures.remove(at).1);
            self.queue_events(id, measures);
            if let Some(measure) = mine {
                return Ok(self.input_value(id, device, measure));
            }
        }
    }
}
