//! Input: initialising devices and setting their modes, requests, samples, events, and inquiries.

mod event;
mod initialise;
mod inquiry;
mod request;

use crate::answer::{Clear, Output, TOO_SMALL};
use crate::argument::{Argument, Character, Enumeration, Integer, Real, integer};
use crate::data_record::LINE;
use gks::{
    DataRecord, Error, Function, InputClass, InputStatus, LocatorValue, OperatingMode, PickValue, StrokeValue,
};
use std::ffi::c_int;

/// The integer for no input class.
pub(crate) const NO_CLASS: c_int = 0;

macro_rules! enumerations {
    ($($name:ty),+) => { $(
        impl Enumeration for $name {
            fn from_number(number: c_int) -> Option<Self> {
                <$name>::from_number(number)
            }

            fn number(self) -> c_int {
                self as c_int
            }
        }
    )+ };
}

enumerations! { InputClass, InputStatus, OperatingMode }

/// The two variables of an abscissa and an ordinate.
type Pair = (Real, Real);

/// Where a locator value goes.
pub(crate) type LocatorOutput = (Integer, Pair);

impl Output<LocatorValue> for LocatorOutput {
    fn put(self, value: LocatorValue) -> c_int {
        (self.0, self.1).put((value.transformation, value.position))
    }
}

/// Where a stroke value goes: transformation number, number of points, and arrays of `room` elements.
#[derive(Copy, Clone)]
pub(crate) struct Points {
    pub(crate) transformation: Integer,
    pub(crate) room: usize,
    pub(crate) count: Integer,
    pub(crate) x: Real,
    pub(crate) y: Real,
}

impl Clear for Points {
    fn clear(self) {
        self.transformation.set(0);
        self.count.set(0);
    }
}

/// Points that do not fit are left out; the number is that of all.
impl Output<StrokeValue> for Points {
    fn put(self, value: StrokeValue) -> c_int {
        self.transformation.set(value.transformation);
        self.count.set(integer(value.points.len()));
        let fits = value.points.len() <= self.room;
        let points = || value.points.iter().take(self.room);
        self.x.set_from(0, points().map(|p| p.x() as f32));
        self.y.set_from(0, points().map(|p| p.y() as f32));
        if fits { 0 } else { TOO_SMALL }
    }
}

/// Where the status and the number of a choice go.
pub(crate) type ChoiceOutput = (Integer, Integer);

impl Output<Option<c_int>> for ChoiceOutput {
    fn put(self, value: Option<c_int>) -> c_int {
        (self.0, self.1).put((InputStatus::of(value.as_ref()), value.unwrap_or(0)))
    }
}

/// Where the status, the segment name and the pick identifier of a pick go.
pub(crate) type PickOutput = (Integer, Integer, Integer);

impl Output<Option<PickValue>> for PickOutput {
    fn put(self, value: Option<PickValue>) -> c_int {
        let status = InputStatus::of(value.as_ref());
        let (segment, identifier) = value.map_or((0, 0), |value| (value.segment, value.identifier));
        (self.0, self.1, self.2).put((status, segment, identifier))
    }
}

/// Where text goes: its length, and a string of `room` characters.
#[derive(Copy, Clone)]
pub(crate) struct Text {
    pub(crate) count: Integer,
    pub(crate) room: usize,
    pub(crate) text: Character,
}

impl Clear for Text {
    fn clear(self) {
        self.count.set(0);
        self.text.set_text(self.room, b"");
    }
}

/// One character for each character that Latin-1 has, a question mark for any other one. Characters that do
/// not fit are left out, and the length is that of what is there.
impl Output<String> for Text {
    fn put(self, value: String) -> c_int {
        let bytes: Vec<u8> = value.chars().map(|c| u8::try_from(c).unwrap_or(b'?')).collect();
        let fits = self.text.set_text(self.room, &bytes);
        self.count.set(integer(bytes.len().min(self.room)));
        if fits { 0 } else { TOO_SMALL }
    }
}

/// Where a data record goes: the number of its lines, and at most `room` lines.
#[derive(Copy, Clone)]
pub(crate) struct Record {
    pub(crate) room: usize,
    pub(crate) count: Integer,
    pub(crate) lines: Character,
}

impl Clear for Record {
    fn clear(self) {
        self.count.set(0);
    }
}

impl Output<DataRecord> for Record {
    fn put(self, value: DataRecord) -> c_int {
        if self.room == 0 && value.is_empty() {
            self.count.set(0);
            return 0;
        }
        match value.pack(self.room) {
            Ok(lines) => {
                self.count.set(integer(lines.len()));
                debug_assert_eq!(lines.as_flattened().len(), lines.len() * LINE);
                self.lines.set_from(0, lines.as_flattened().iter().copied());
                0
            }
            Err(error) => {
                self.count.set(0);
                error.number
            }
        }
    }
}

/// Gives the value of a function that is no inquiry to the variables of the program; where there is none they
/// are set to zero. Error: 2001 (an array or a string is too small, and has what fits).
pub(crate) fn give<V, O: Output<V>>(
    function: Function,
    outputs: O,
    value: impl FnOnce(&mut gks::Gks) -> gks::Result<V>,
) {
    outputs.clear();
    crate::call::call(function, |gks| match outputs.put(value(gks)?) {
        0 => Ok(()),
        number => Err(Error::new(number, function)),
    });
}

/// What a REQUEST gives: its status in front of the value, unless the value has one.
impl<V, O: Output<V>> Output<Option<V>> for Requested<O> {
    fn put(self, value: Option<V>) -> c_int {
        match value {
            Some(value) => {
                self.status.set(InputStatus::Ok as c_int);
                // A choice and a pick have a status of their own, which replaces this one.
                self.value.put(value)
            }
            None => {
                self.clear();
                0
            }
        }
    }
}

/// Where the answer to a REQUEST goes.
#[derive(Copy, Clone)]
pub(crate) struct Requested<O> {
    pub(crate) status: Integer,
    pub(crate) value: O,
}

impl<O: Clear> Clear for Requested<O> {
    fn clear(self) {
        self.value.clear();
        self.status.set(InputStatus::None as c_int);
    }
}

/// The first `count` characters of a string that has `length`.
pub(crate) fn characters<'a>(string: Argument<u8>, count: Integer, length: usize) -> &'a [u8] {
    string.slice(0, length.min(count.count()))
}
