//! Logical input values: what input functions give to an application, in world coordinates.

use gks_geometry::{Point, Wc};

/// A position entered with a locator.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct LocatorValue {
    /// The normalization transformation whose world coordinates the position has.
    pub transformation: i32,
    /// The position.
    pub position: Point<Wc>,
}

/// Positions entered with a stroke device.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StrokeValue {
    /// The normalization transformation whose world coordinates the positions have.
    pub transformation: i32,
    /// The positions, in the order in which they were entered.
    pub points: Vec<Point<Wc>>,
}

/// What was picked.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct PickValue {
    /// The name of the segment.
    pub segment: i32,
    /// The pick identifier of the primitive.
    pub identifier: i32,
}

/// A logical input value of any class.
#[derive(Clone, Debug, PartialEq)]
pub enum InputValue {
    /// Of a locator.
    Locator(LocatorValue),
    /// Of a stroke device.
    Stroke(StrokeValue),
    /// Of a valuator.
    Valuator(f64),
    /// Of a choice device: the number of an alternative, from 1, or that none is chosen.
    Choice(Option<i32>),
    /// Of a pick device: what was picked, or that nothing was.
    Pick(Option<PickValue>),
    /// Of a string device.
    String(String),
}

/// The value of one class among [`InputValue`]s.
pub(crate) trait OfClass: Sized {
    /// The value, if it is one of this class.
    fn of(value: InputValue) -> Option<Self>;
}

macro_rules! classes {
    ($($variant:ident: $type:ty;)+) => { $(
        impl OfClass for $type {
            fn of(value: InputValue) -> Option<Self> {
                match value {
                    InputValue::$variant(value) => Some(value),
                    _ => None,
                }
            }
        }
    )+ };
}

classes! {
    Locator: LocatorValue;
    Stroke: StrokeValue;
    Valuator: f64;
    Choice: Option<i32>;
    Pick: Option<PickValue>;
    String: String;
}

/// How a REQUEST ended, and whether a choice or a pick holds a value, as language bindings number it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum InputStatus {
    /// The operator refused to answer, or nobody can.
    None = 0,
    /// There is a value.
    Ok = 1,
    /// The operator answered that he chooses or picks nothing.
    NoInput = 2,
}

impl InputStatus {
    /// The status with a number.
    pub const fn from_number(number: i32) -> Option<Self> {
        match number {
            0 => Some(InputStatus::None),
            1 => Some(InputStatus::Ok),
            2 => Some(InputStatus::NoInput),
            _ => None,
        }
    }

    /// The status of a value of a choice or a pick.
    pub const fn of<T>(value: Option<&T>) -> Self {
        match value {
            Some(_) => InputStatus::Ok,
            None => InputStatus::NoInput,
        }
    }

    /// The status of what a REQUEST of a choice or a pick gave.
    pub const fn of_request<T>(answer: &Option<Option<T>>) -> Self {
        match answer {
            Some(value) => InputStatus::of(value.as_ref()),
            None => InputStatus::None,
        }
    }
}

/// How a logical input device is operated.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum OperatingMode {
    /// The application waits for the operator.
    Request = 0,
    /// The application asks for the current value at any time.
    Sample = 1,
    /// The operator makes events, which the application takes from a queue.
    Event = 2,
}

impl OperatingMode {
    /// The mode with a number.
    pub const fn from_number(number: i32) -> Option<Self> {
        match number {
            0 => Some(OperatingMode::Request),
            1 => Some(OperatingMode::Sample),
            2 => Some(OperatingMode::Event),
            _ => None,
        }
    }
}
