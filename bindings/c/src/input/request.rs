//! REQUEST and SAMPLE.

use super::{set_choice, set_locator, set_pick, set_string, set_stroke, set_value};
use crate::argument::{Out, call};
use crate::types::{Gdouble, Gint, Gpick, Gpoint, Gpoint_list};
use gks::{Function, InputStatus};
use std::ffi::c_char;

/// Runs a REQUEST, which sets what it gives by `set`; the status is NONE where it gives nothing.
fn request<V>(
    function: Function,
    in_status: Out<Gint>,
    ask: impl FnOnce(&mut gks::Gks) -> gks::Result<Option<V>>,
    set: impl FnOnce(&gks::Gks, V),
) {
    in_status.set(InputStatus::None as Gint);
    call(function, |gks| {
        if let Some(value) = ask(gks)? {
            in_status.set(InputStatus::Ok as Gint);
            set(gks, value);
        }
        Ok(())
    });
}

/// REQUEST LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn greq_loc(
    ws_id: Gint,
    loc_num: Gint,
    in_status: Out<Gint>,
    norm_tran_num: Out<Gint>,
    loc_pos: Out<Gpoint>,
) {
    let ask = |gks: &mut gks::Gks| gks.request_locator(ws_id, loc_num);
    request(Function::RequestLocator, in_status, ask, |_, value| set_locator(value, norm_tran_num, loc_pos));
}

/// REQUEST STROKE. The program has room for as many points as the input buffer of the device holds.
#[unsafe(no_mangle)]
extern "C" fn greq_stroke(
    ws_id: Gint,
    stroke_num: Gint,
    in_status: Out<Gint>,
    norm_tran_num: Out<Gint>,
    stroke: Out<Gpoint_list>,
) {
    let ask = |gks: &mut gks::Gks| gks.request_stroke(ws_id, stroke_num);
    request(Function::RequestStroke, in_status, ask, |_, value| set_stroke(&value, norm_tran_num, stroke));
}

/// REQUEST VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn greq_val(ws_id: Gint, val_num: Gint, in_status: Out<Gint>, value: Out<Gdouble>) {
    let ask = |gks: &mut gks::Gks| gks.request_valuator(ws_id, val_num);
    request(Function::RequestValuator, in_status, ask, |_, number| set_value(number, value));
}

/// REQUEST CHOICE.
#[unsafe(no_mangle)]
extern "C" fn greq_choice(ws_id: Gint, choice_num: Gint, in_status: Out<Gint>, choice: Out<Gint>) {
    let ask = |gks: &mut gks::Gks| gks.request_choice(ws_id, choice_num);
    request(Function::RequestChoice, in_status, ask, |_, value| set_choice(value, in_status, choice));
}

/// REQUEST PICK.
#[unsafe(no_mangle)]
extern "C" fn greq_pick(ws_id: Gint, pick_num: Gint, in_status: Out<Gint>, pick: Out<Gpick>) {
    let ask = |gks: &mut gks::Gks| gks.request_pick(ws_id, pick_num);
    request(Function::RequestPick, in_status, ask, |_, value| set_pick(value, in_status, pick));
}

/// REQUEST STRING. The program has room for as many bytes as the input buffer of the device holds, and one more.
#[unsafe(no_mangle)]
extern "C" fn greq_string(ws_id: Gint, string_num: Gint, in_status: Out<Gint>, string: Out<c_char>) {
    let ask = |gks: &mut gks::Gks| gks.request_string(ws_id, string_num);
    request(Function::RequestString, in_status, ask, |gks, value| {
        set_string(gks, (ws_id, string_num), &value, string);
    });
}

/// SAMPLE LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gsample_loc(ws_id: Gint, loc_num: Gint, norm_tran_num: Out<Gint>, loc_pos: Out<Gpoint>) {
    call(Function::SampleLocator, |gks| {
        set_locator(gks.sample_locator(ws_id, loc_num)?, norm_tran_num, loc_pos);
        Ok(())
    });
}

/// SAMPLE STROKE. The program has room for as many points as the input buffer of the device holds.
#[unsafe(no_mangle)]
extern "C" fn gsample_stroke(
    ws_id: Gint,
    stroke_num: Gint,
    norm_tran_num: Out<Gint>,
    stroke: Out<Gpoint_list>,
) {
    call(Function::SampleStroke, |gks| {
        set_stroke(&gks.sample_stroke(ws_id, stroke_num)?, norm_tran_num, stroke);
        Ok(())
    });
}

/// SAMPLE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn gsample_val(ws_id: Gint, val_num: Gint, value: Out<Gdouble>) {
    call(Function::SampleValuator, |gks| {
        set_value(gks.sample_valuator(ws_id, val_num)?, value);
        Ok(())
    });
}

/// SAMPLE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn gsample_choice(ws_id: Gint, choice_num: Gint, in_status: Out<Gint>, choice: Out<Gint>) {
    call(Function::SampleChoice, |gks| {
        set_choice(gks.sample_choice(ws_id, choice_num)?, in_status, choice);
        Ok(())
    });
}

/// SAMPLE PICK.
#[unsafe(no_mangle)]
extern "C" fn gsample_pick(ws_id: Gint, pick_num: Gint, in_status: Out<Gint>, pick: Out<Gpick>) {
    call(Function::SamplePick, |gks| {
        set_pick(gks.sample_pick(ws_id, pick_num)?, in_status, pick);
        Ok(())
    });
}

/// SAMPLE STRING. The program has room for as many bytes as the input buffer of the device holds, and one more.
#[unsafe(no_mangle)]
extern "C" fn gsample_string(ws_id: Gint, string_num: Gint, string: Out<c_char>) {
    call(Function::SampleString, |gks| {
        let value = gks.sample_string(ws_id, string_num)?;
        set_string(gks, (ws_id, string_num), &value, string);
        Ok(())
    });
}
