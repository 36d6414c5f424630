//! SAMPLE: the application asks what the value of a device is now.

use super::logical;
use super::value::{InputValue, LocatorValue, OfClass, OperatingMode, PickValue, StrokeValue};
use crate::gks::receiving_error;
use crate::{Error, Function, Gks, Result};
use gks_pipeline::input::{InputClass, LogicalDevice};

macro_rules! samples {
    ($($(#[$doc:meta])* $name:ident, $function:ident, $class:ident -> $value:ty;)+) => {
        impl Gks { $(
            $(#[$doc])*
            pub fn $name(&mut self, id: i32, number: i32) -> Result<$value> {
                let value = self.sample(Function::$function, id, logical(InputClass::$class, number))?;
                <$value>::of(value).ok_or_else(|| Error::new(142, Function::$function))
            }
        )+ }
    };
}

samples! {
    /// SAMPLE LOCATOR: the current position; the initial one where nobody is left to move it.
    ///
    /// Errors: 7, 20, 25, 38, 140 (no such device), 142 (not in mode SAMPLE), 303, 305.
    sample_locator, SampleLocator, Locator -> LocatorValue;
    /// SAMPLE STROKE: the points entered so far. Errors: as SAMPLE LOCATOR.
    sample_stroke, SampleStroke, Stroke -> StrokeValue;
    /// SAMPLE VALUATOR: the current number. Errors: as SAMPLE LOCATOR.
    sample_valuator, SampleValuator, Valuator -> f64;
    /// SAMPLE CHOICE: the alternative chosen now, if one is. Errors: as SAMPLE LOCATOR.
    sample_choice, SampleChoice, Choice -> Option<i32>;
    /// SAMPLE PICK: what the operator points at, if anything. Errors: as SAMPLE LOCATOR, with 37 in the place of
    /// 38.
    sample_pick, SamplePick, Pick -> Option<PickValue>;
    /// SAMPLE STRING: the text entered so far. Errors: as SAMPLE LOCATOR.
    sample_string, SampleString, String -> String;
}

impl Gks {
    fn sample(&mut self, function: Function, id: i32, device: LogicalDevice) -> Result<InputValue> {
        self.check_state(function)?;
        let state = self.input_device(function, id, device)?;
        if state.mode != OperatingMode::Sample {
            return Err(Error::new(142, function));
        }
        let initial = state.initial.clone();
        self.update_before_input(id, device.class)?;
        self.before_interaction(function, id)?;
        let measure = match self.workstation_mut(function, id)?.workstation.input() {
            Some(operator) => operator.sample(device).map_err(|error| receiving_error(function, &error))?,
            None => None,
        };
        Ok(measure.and_then(|measure| self.input_value(id, device, measure)).unwrap_or(initial))
    }
}
