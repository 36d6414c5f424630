//! Inquiries of input devices: their state, and what the workstation description table says about them.

use super::device::{Device, DeviceState, place, prompts};
use super::value::{LocatorValue, OfClass, PickValue, StrokeValue};
use super::{logical, no_device, serves};
use crate::inquiry::ValueType;
use crate::{DataRecord, Error, Function, Gks, Result};
use gks_geometry::{Dc, Rect};
use gks_pipeline::description::Description;
use gks_pipeline::generated::numbers;
use gks_pipeline::input::{Detail, InputClass};

/// What the workstation description table says about an input device.
#[derive(Clone, Debug, PartialEq)]
pub struct DefaultDevice<V> {
    /// The initial value.
    pub initial: V,
    /// The prompt and echo types that there are.
    pub prompts: &'static [i32],
    /// The echo area, in metres on the display surface.
    pub area: Rect<Dc>,
    /// What only one class has: buffer sizes, limits, alternatives.
    pub detail: Detail,
    /// The greatest size of a buffer, of points or characters; 0 for a class without one.
    pub greatest_buffer: usize,
    /// The data record.
    pub record: DataRecord,
}

macro_rules! inquiries {
    ($($class:ident -> $value:ty {
        $(#[$doc:meta])* $name:ident, $function:ident;
        $(#[$default_doc:meta])* $default:ident, $default_function:ident;
    })+) => {
        impl Gks { $(
            $(#[$doc])*
            pub fn $name(&self, id: i32, number: i32) -> Result<DeviceState<$value>> {
                self.device_state(Function::$function, id, InputClass::$class, number)
            }

            $(#[$default_doc])*
            pub fn $default(&self, kind: i32, number: i32) -> Result<DefaultDevice<$value>> {
                self.default_device(Function::$default_function, kind, InputClass::$class, number)
            }
        )+ }
    };
}

inquiries! {
    Valuator -> f64 {
        /// INQUIRE VALUATOR DEVICE STATE. Errors: 7, 20, 25, 38, 140.
        inquire_valuator_device_state, InquireValuatorDeviceState;
        /// INQUIRE DEFAULT VALUATOR DEVICE DATA of a workstation type. Errors: 8, 22, 23, 38, 140.
        inquire_default_valuator_device_data, InquireDefaultValuatorDeviceData;
    }
    Choice -> Option<i32> {
        /// INQUIRE CHOICE DEVICE STATE. Errors: 7, 20, 25, 38, 140.
        inquire_choice_device_state, InquireChoiceDeviceState;
        /// INQUIRE DEFAULT CHOICE DEVICE DATA of a workstation type. Errors: 8, 22, 23, 38, 140.
        inquire_default_choice_device_data, InquireDefaultChoiceDeviceData;
    }
    String -> String {
        /// INQUIRE STRING DEVICE STATE. Errors: 7, 20, 25, 38, 140.
        inquire_string_device_state, InquireStringDeviceState;
        /// INQUIRE DEFAULT STRING DEVICE DATA of a workstation type. Errors: 8, 22, 23, 38, 140.
        inquire_default_string_device_data, InquireDefaultStringDeviceData;
    }
}

macro_rules! realized {
    ($($class:ident -> $value:ty {
        $(#[$doc:meta])* $name:ident, $function:ident;
        $(#[$default_doc:meta])* $default:ident, $default_function:ident;
    })+) => {
        impl Gks { $(
            $(#[$doc])*
            ///
            /// What is realized is what was set: a driver that lacks a prompt or echo has one in its place.
            pub fn $name(&self, id: i32, number: i32, _of: ValueType) -> Result<DeviceState<$value>> {
                self.device_state(Function::$function, id, InputClass::$class, number)
            }

            $(#[$default_doc])*
            pub fn $default(&self, kind: i32, number: i32) -> Result<DefaultDevice<$value>> {
                self.default_device(Function::$default_function, kind, InputClass::$class, number)
            }
        )+ }
    };
}

realized! {
    Locator -> LocatorValue {
        /// INQUIRE LOCATOR DEVICE STATE. Errors: 7, 20, 25, 38, 140.
        inquire_locator_device_state, InquireLocatorDeviceState;
        /// INQUIRE DEFAULT LOCATOR DEVICE DATA of a workstation type. Errors: 8, 22, 23, 38, 140.
        inquire_default_locator_device_data, InquireDefaultLocatorDeviceData;
    }
    Stroke -> StrokeValue {
        /// INQUIRE STROKE DEVICE STATE. Errors: 7, 20, 25, 38, 140.
        inquire_stroke_device_state, InquireStrokeDeviceState;
        /// INQUIRE DEFAULT STROKE DEVICE DATA of a workstation type. Errors: 8, 22, 23, 38, 140.
        inquire_default_stroke_device_data, InquireDefaultStrokeDeviceData;
    }
    Pick -> Option<PickValue> {
        /// INQUIRE PICK DEVICE STATE. Errors: 7, 20, 25, 37, 140.
        inquire_pick_device_state, InquirePickDeviceState;
        /// INQUIRE DEFAULT PICK DEVICE DATA of a workstation type. Errors: 8, 22, 23, 37, 140.
        inquire_default_pick_device_data, InquireDefaultPickDeviceData;
    }
}

impl Gks {
    /// INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES of a workstation type: locators, strokes, valuators,
    /// choices, picks and strings. Errors: 8, 22, 23, 38.
    pub fn inquire_number_of_available_logical_input_devices(&self, kind: i32) -> Result<[u32; 6]> {
        Ok(self.described_input(Function::InquireNumberOfAvailableLogicalInputDevices, kind)?.input)
    }

    fn described_input(&self, function: Function, kind: i32) -> Result<Description> {
        self.check_state(function)?;
        if kind < 0 {
            return Err(Error::new(22, function));
        }
        let description = self.catalogue.describe(kind).ok_or_else(|| Error::new(23, function))?;
        serves(function, description.category)?;
        Ok(description)
    }

    fn device_state<V: OfClass>(
        &self,
        function: Function,
        id: i32,
        class: InputClass,
        number: i32,
    ) -> Result<DeviceState<V>> {
        self.check_state(function)?;
        let device = logical(class, number);
        self.input_device(function, id, device)?.state().ok_or_else(|| no_device(function, device))
    }

    fn default_device<V: OfClass>(
        &self,
        function: Function,
        kind: i32,
        class: InputClass,
        number: i32,
    ) -> Result<DefaultDevice<V>> {
        let description = self.described_input(function, kind)?;
        let missing = || no_device(function, logical(class, number));
        let count = description.input[place(class)];
        if !u32::try_from(number).is_ok_and(|number| (1..=count).contains(&number)) {
            return Err(missing());
        }
        let state: DeviceState<V> = Device::new(class, &description).state().ok_or_else(missing)?;
        let DeviceState { initial, area, detail, record, .. } = state;
        let greatest_buffer = match class {
            InputClass::Stroke => numbers::MAX_STROKE_POINTS as usize,
            InputClass::String => numbers::MAX_STRING_CHARACTERS as usize,
            _ => 0,
        };
        Ok(DefaultDevice { initial, prompts: prompts(class), area, detail, greatest_buffer, record })
    }
}
