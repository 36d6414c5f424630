//! Input: initialising devices and setting their modes, requests, samples, events, and inquiries.

mod event;
mod initialise;
mod inquiry;
pub(crate) mod record;
mod request;

use crate::argument::{Out, integer};
use crate::types::{Gdouble, Gint, Gpick, Gpoint, Gpoint_list};
use gks::{Detail, Gks, InputStatus, LocatorValue, PickValue, StrokeValue};
use std::ffi::c_char;

/// The size of the input buffer of a device that has one.
fn buffer(detail: &Detail) -> usize {
    match detail {
        Detail::Stroke { buffer, .. } | Detail::String { buffer, .. } => *buffer,
        _ => 0,
    }
}

/// Sets a position and its transformation.
fn set_locator(value: LocatorValue, norm_tran_num: Out<Gint>, loc_pos: Out<Gpoint>) {
    norm_tran_num.set(value.transformation);
    loc_pos.set(value.position.into());
}

/// Sets the points of a stroke, for which the program has room: as many as the input buffer of the device holds.
fn set_stroke(value: &StrokeValue, norm_tran_num: Out<Gint>, stroke: Out<Gpoint_list>) {
    norm_tran_num.set(value.transformation);
    stroke.count().set(integer(value.points.len()));
    // SAFETY: the address of a member of a structure that is there.
    let points = stroke.member(|list| unsafe { &raw mut (*list).points }).target();
    points.set_all(value.points.iter().map(|&p| p.into()));
}

/// Sets a choice and its status.
fn set_choice(value: Option<Gint>, in_status: Out<Gint>, choice: Out<Gint>) {
    in_status.set(InputStatus::of(value.as_ref()) as Gint);
    choice.set(value.unwrap_or(0));
}

/// Sets a pick and its status.
fn set_pick(value: Option<PickValue>, in_status: Out<Gint>, pick: Out<Gpick>) {
    in_status.set(InputStatus::of(value.as_ref()) as Gint);
    let (seg_name, pick_id) = value.map_or((0, 0), |value| (value.segment, value.identifier));
    pick.set(Gpick { seg_name, pick_id });
}

/// Sets a string in UTF-8, for which the program has room: as many bytes as the input buffer of the device holds
/// characters, and a zero byte. Characters that do not fit are left out.
fn set_string(gks: &Gks, (ws_id, string_num): (Gint, Gint), value: &str, string: Out<c_char>) {
    let state = gks.inquire_string_device_state(ws_id, string_num);
    let room = state.map_or(0, |state| buffer(&state.detail));
    let end = (0..=room.min(value.len())).rev().find(|&end| value.is_char_boundary(end)).unwrap_or(0);
    // What ends a string cannot be in it.
    let bytes = value.as_bytes()[..end].iter().take_while(|&&byte| byte != 0);
    string.set_all(bytes.map(|&byte| byte as c_char).chain([0]));
}

/// Sets a number.
fn set_value(number: f64, value: Out<Gdouble>) {
    value.set(number);
}
