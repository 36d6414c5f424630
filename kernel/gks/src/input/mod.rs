//! Input: logical input devices, what the operator enters with them, and the queue of events.
//!
//! The kernel keeps the state of every device and knows the operating modes; the driver knows which devices
//! are started and what the operator does. All positions cross the border in metres on the display surface.

mod device;
mod event;
mod initialise;
mod inquiry;
mod measure;
mod menu;
mod mode;
mod pick;
mod queue;
mod record;
mod request;
mod sample;
mod value;

pub use device::DeviceState;
pub use gks_pipeline::input::{Detail, InputClass};
pub use inquiry::DefaultDevice;
pub use value::{InputStatus, InputValue, LocatorValue, OperatingMode, PickValue, StrokeValue};

pub(crate) use device::Devices;
pub(crate) use queue::EventQueue;

use crate::{Error, Function, Gks, Result};
use device::Device;
use gks_pipeline::description::Category;
use gks_pipeline::input::LogicalDevice;

/// The device of a class with a number.
fn logical(class: InputClass, number: i32) -> LogicalDevice {
    LogicalDevice { class, number }
}

/// Checks that a function of input may be used on workstations of a category. Errors: 37, 38.
fn serves(function: Function, category: Category) -> Result<()> {
    let number = match category {
        Category::OutIn => return Ok(()),
        Category::Input => 37,
        _ if function.errors().contains(&37) => 37,
        _ => 38,
    };
    if function.errors().contains(&number) { Err(Error::new(number, function)) } else { Ok(()) }
}

#[cold]
fn no_device(function: Function, device: LogicalDevice) -> Error {
    Error::new(140, function).because(format!("{:?} {}", device.class, device.number).to_lowercase())
}

impl Gks {
    /// Checks that a workstation is open and has input. Errors: 20, 25, 37, 38.
    fn check_input(&self, function: Function, id: i32) -> Result<()> {
        let open = self.workstation(function, id)?;
        serves(function, open.workstation.description().category)
    }

    /// The state of a device. Errors: 20, 25, 37, 38, 140.
    fn input_device(&self, function: Function, id: i32, device: LogicalDevice) -> Result<&Device> {
        self.check_input(function, id)?;
        let open = self.workstation(function, id)?;
        open.input.get(device).ok_or_else(|| no_device(function, device))
    }
}
