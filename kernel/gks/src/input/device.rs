//! The part of the workstation state list about logical input devices.

use super::menu::Menu;
use super::value::{InputValue, LocatorValue, OfClass, OperatingMode, StrokeValue};
use crate::DataRecord;
use gks_geometry::{Dc, Point, Rect};
use gks_pipeline::description::Description;
use gks_pipeline::generated::numbers;
use gks_pipeline::input::{Detail, InputClass, LogicalDevice};

/// All input classes, in their order.
pub(crate) const CLASSES: [InputClass; 6] = [
    InputClass::Locator,
    InputClass::Stroke,
    InputClass::Valuator,
    InputClass::Choice,
    InputClass::Pick,
    InputClass::String,
];

/// The state of a logical input device.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Device {
    pub(crate) mode: OperatingMode,
    pub(crate) echo: bool,
    pub(crate) initial: InputValue,
    pub(crate) prompt: i32,
    pub(crate) area: Rect<Dc>,
    /// What the data record says to the driver.
    pub(crate) detail: Detail,
    /// The picture whose parts are the alternatives.
    pub(crate) menu: Option<Menu>,
    /// The data record as it was given.
    pub(crate) record: DataRecord,
}

/// The state of a logical input device, as inquiries give it.
#[derive(Clone, Debug, PartialEq)]
pub struct DeviceState<V> {
    /// The operating mode.
    pub mode: OperatingMode,
    /// Whether the value is echoed.
    pub echo: bool,
    /// The initial value.
    pub initial: V,
    /// The prompt and echo type.
    pub prompt: i32,
    /// The echo area, in metres on the display surface.
    pub area: Rect<Dc>,
    /// What only one class has: buffer sizes, limits, alternatives.
    pub detail: Detail,
    /// The data record.
    pub record: DataRecord,
}

impl Device {
    /// The device of a class as OPEN WORKSTATION sets it.
    pub(crate) fn new(class: InputClass, description: &Description) -> Device {
        let (width, height) = description.size();
        let centre = Point::new(numbers::INPUT_LOCATOR_POSITION, numbers::INPUT_LOCATOR_POSITION);
        let initial = match class {
            InputClass::Locator => InputValue::Locator(LocatorValue { transformation: 0, position: centre }),
            InputClass::Stroke => InputValue::Stroke(StrokeValue::default()),
            InputClass::Valuator => InputValue::Valuator(numbers::INPUT_VALUATOR_VALUE),
            InputClass::Choice => InputValue::Choice(None),
            InputClass::Pick => InputValue::Pick(None),
            InputClass::String => InputValue::String(String::new()),
        };
        Device {
            mode: OperatingMode::Request,
            echo: true,
            initial,
            prompt: 1,
            area: Rect::new(0.0, width, 0.0, height),
            detail: default_detail(class, description),
            menu: None,
            record: DataRecord::default(),
        }
    }

    /// The state as an inquiry gives it; none for a device of another class.
    pub(crate) fn state<V: OfClass>(&self) -> Option<DeviceState<V>> {
        Some(DeviceState {
            mode: self.mode,
            echo: self.echo,
            initial: V::of(self.initial.clone())?,
            prompt: self.prompt,
            area: self.area,
            detail: self.detail.clone(),
            record: self.record.clone(),
        })
    }
}

/// What the data record of a device says that has none.
pub(crate) fn default_detail(class: InputClass, description: &Description) -> Detail {
    let (width, height) = description.size();
    let side = width.min(height);
    match class {
        InputClass::Locator => Detail::Locator,
        InputClass::Stroke => Detail::Stroke {
            buffer: numbers::INPUT_BUFFER_STROKE,
            interval: (side * numbers::INPUT_STROKE_INTERVAL, side * numbers::INPUT_STROKE_INTERVAL),
        },
        InputClass::Valuator => {
            Detail::Valuator { low: numbers::INPUT_VALUATOR_LOW, high: numbers::INPUT_VALUATOR_HIGH }
        }
        InputClass::Choice => Detail::Choice {
            alternatives: numbers::MAX_CHOICE_ALTERNATIVES as i32,
            enabled: Vec::new(),
            names: Vec::new(),
        },
        InputClass::Pick => Detail::Pick { aperture: side * numbers::INPUT_PICK_APERTURE },
        InputClass::String => Detail::String { buffer: numbers::INPUT_BUFFER_STRING, cursor: 1 },
    }
}

/// The prompt and echo types of the devices of a class.
pub(crate) fn prompts(class: InputClass) -> &'static [i32] {
    numbers::PROMPTS.get(place(class)).copied().unwrap_or_default()
}

/// The place of a class among all.
pub(crate) fn place(class: InputClass) -> usize {
    class as usize - 1
}

/// The logical input devices of a workstation.
pub(crate) struct Devices([Vec<Device>; 6]);

impl Devices {
    /// The devices of a workstation that is opened.
    pub(crate) fn new(description: &Description) -> Devices {
        Devices(CLASSES.map(|class| {
            let count = description.input[place(class)] as usize;
            (0..count).map(|_| Device::new(class, description)).collect()
        }))
    }

    /// A device, if there is one with that number.
    pub(crate) fn get(&self, device: LogicalDevice) -> Option<&Device> {
        let number = usize::try_from(device.number).ok()?.checked_sub(1)?;
        self.0[place(device.class)].get(number)
    }

    /// A device to be changed.
    pub(crate) fn get_mut(&mut self, device: LogicalDevice) -> Option<&mut Device> {
        let number = usize::try_from(device.number).ok()?.checked_sub(1)?;
        self.0[place(device.class)].get_mut(number)
    }

    /// Whether a device is in mode EVENT.
    pub(crate) fn makes_events(&self) -> bool {
        self.0.iter().flatten().any(|device| device.mode == OperatingMode::Event)
    }
}
