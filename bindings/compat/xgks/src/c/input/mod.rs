//! Input: initialising devices and setting their modes, requests, samples, events, and inquiries.
//!
//! A program has room for what a device enters: for as many points, or bytes with the zero byte at the end, as the buffer
//! holds that it has given to INITIALISE, or as that of XGKS holds, which is all that a program knows that has
//! given none.

mod event;
mod initialise;
mod inquiry;
mod record;
mod request;

use super::argument::{Address, allocated, integer};
use super::types::{Gchar, Gchoice, Gfloat, Gint, Gloc, Gpick, Gpoint, Gstroke};
use gks::{Detail, DeviceState, Gks, LocatorValue, PickValue, StrokeValue};

/// The points that the buffer of a stroke device holds which was not initialised.
const STROKE_BUFFER: Gint = 64;
/// The bytes that the buffer of a string device holds which was not initialised.
const STRING_BUFFER: Gint = 1024;

/// The status of a choice or a pick: there is one, there is none, the operator refused.
const OK: Gint = 0;
const NOTHING: Gint = 1;
const REFUSED: Gint = 2;

impl From<LocatorValue> for Gloc {
    fn from(value: LocatorValue) -> Self {
        Gloc { transform: value.transformation, position: value.position.into() }
    }
}

impl From<Option<i32>> for Gchoice {
    fn from(value: Option<i32>) -> Self {
        Gchoice { status: if value.is_some() { OK } else { NOTHING }, choice: value.unwrap_or(0) }
    }
}

impl From<Option<PickValue>> for Gpick {
    fn from(value: Option<PickValue>) -> Self {
        let (status, seg, pickid) = value.map_or((NOTHING, 0, 0), |v| (OK, v.segment, v.identifier));
        Gpick { status, seg, pickid }
    }
}

/// A stroke with memory of its own, which belongs to the program.
fn allocated_stroke(value: &StrokeValue) -> Gstroke {
    let points: Vec<Gpoint> = value.points.iter().map(|&p| p.into()).collect();
    let address = allocated(&points);
    let n_points = if address.is_null() { 0 } else { integer(points.len()) };
    Gstroke { transform: value.transformation, n_points, points: address }
}

/// Sets a stroke in the room of the program.
fn set_stroke(value: &StrokeValue, room: Gint, stroke: Address<Gstroke>) {
    let count = value.points.len().min(usize::try_from(room).unwrap_or(0));
    if let Some(given) = stroke.value() {
        let points = Address::at(given.points);
        let n_points = if points.is_null() { 0 } else { integer(count) };
        points.set_all(value.points.iter().take(count).map(|&p| p.into()));
        stroke.set(Gstroke { transform: value.transformation, n_points, ..given });
    }
}

/// Sets a string in the room of the program. What ends a string cannot be in it, and characters that do not fit are
/// left out.
fn set_string(value: &str, room: Gint, string: Address<Gchar>) {
    let most = usize::try_from(room).unwrap_or(0).saturating_sub(1);
    let end = (0..=most.min(value.len())).rev().find(|&end| value.is_char_boundary(end)).unwrap_or(0);
    let bytes = value.as_bytes()[..end].iter().take_while(|&&byte| byte != 0);
    string.set_all(bytes.map(|&byte| byte as Gchar).chain([0]));
}

/// The size of the input buffer of a device: that of its data record, or the usual one if it has none.
fn buffer<V>(state: &DeviceState<V>, usual: Gint) -> Gint {
    match state.detail {
        Detail::Stroke { buffer, .. } | Detail::String { buffer, .. }
            if !state.record.integers.is_empty() =>
        {
            integer(buffer)
        }
        _ => usual,
    }
}

/// How many points a program has room for.
fn stroke_room(gks: &Gks, ws_id: Gint, device: Gint) -> Gint {
    let state = gks.inquire_stroke_device_state(ws_id, device, gks::ValueType::Set);
    state.map_or(0, |state| buffer(&state, STROKE_BUFFER))
}

/// How many bytes a program has room for.
fn string_room(gks: &Gks, ws_id: Gint, device: Gint) -> Gint {
    gks.inquire_string_device_state(ws_id, device).map_or(0, |state| buffer(&state, STRING_BUFFER))
}

/// A number of the kernel as the program gets it.
fn real(value: f64) -> Gfloat {
    value as Gfloat
}
