//! Inquiries of input devices: their state, and what the workstation description table says about them.
//!
//! Lists, strings and data records lie in a store.
#![allow(clippy::too_many_arguments, reason = "the functions of the standard have as many")]

use super::buffer;
use super::record::{Gchoice_data, Gloc_data, Gstroke_data, Nothing};
use crate::argument::{In, Out, choice as enumeration, inquire, integer};
use crate::store::{self, Gstore};
use crate::types::{Gdouble, Gint, Gint_list, Glimit, Gnum_in, Gpick, Gpoint, Gpoint_list};
use gks::{Detail, DeviceState, Function, InputStatus, ValueType};
use std::ffi::c_char;

/// What is set for every device: mode, echo switch, prompt and echo type, echo area.
type Common = (Out<Gint>, Out<Gint>, Out<Gint>, Out<Glimit>);

fn set_common<V>((op_mode, echo_switch, pet, echo_area): Common, state: &DeviceState<V>) {
    op_mode.set(state.mode as Gint);
    echo_switch.set(state.echo.into());
    pet.set(state.prompt);
    echo_area.set(state.area.into());
}

fn of(function: Function, inq_type: Gint) -> gks::Result<ValueType> {
    enumeration(function, inq_type, ValueType::from_number)
}

/// The limits of a valuator.
fn limits(detail: &Detail) -> (f64, f64) {
    match detail {
        Detail::Valuator { low, high } => (*low, *high),
        _ => (0.0, 0.0),
    }
}

/// INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES.
#[unsafe(no_mangle)]
extern "C" fn ginq_num_avail_in(ws_type: Gint, err_ind: Out<Gint>, num_in: Out<Gnum_in>) {
    inquire(Function::InquireNumberOfAvailableLogicalInputDevices, err_ind, |gks| {
        let counts = gks.inquire_number_of_available_logical_input_devices(ws_type)?;
        let [loc, stroke, val, choice, pick, string] = counts.map(integer);
        num_in.set(Gnum_in { loc, stroke, val, choice, pick, string });
        Ok(())
    });
}

/// INQUIRE LOCATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_loc_st(
    ws_id: Gint,
    loc_num: Gint,
    inq_type: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    op_mode: Out<Gint>,
    echo_switch: Out<Gint>,
    init_norm_tran_num: Out<Gint>,
    init_loc_pos: Out<Gpoint>,
    pet: Out<Gint>,
    echo_area: Out<Glimit>,
    loc_data: Out<*const Gloc_data>,
) {
    const F: Function = Function::InquireLocatorDeviceState;
    loc_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let state = gks.inquire_locator_device_state(ws_id, loc_num, of(F, inq_type)?)?;
        set_common((op_mode, echo_switch, pet, echo_area), &state);
        super::set_locator(state.initial, init_norm_tran_num, init_loc_pos);
        loc_data.set(store::device(F, store, |kept| kept.locator(state.prompt, &state.record))?);
        Ok(())
    });
}

/// INQUIRE STROKE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_stroke_st(
    ws_id: Gint,
    stroke_num: Gint,
    inq_type: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    op_mode: Out<Gint>,
    echo_switch: Out<Gint>,
    init_norm_tran_num: Out<Gint>,
    init_stroke: Out<*const Gpoint_list>,
    pet: Out<Gint>,
    echo_area: Out<Glimit>,
    in_buf_size: Out<Gint>,
    stroke_data: Out<*const Gstroke_data>,
) {
    const F: Function = Function::InquireStrokeDeviceState;
    init_stroke.set(std::ptr::null());
    stroke_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let state = gks.inquire_stroke_device_state(ws_id, stroke_num, of(F, inq_type)?)?;
        set_common((op_mode, echo_switch, pet, echo_area), &state);
        init_norm_tran_num.set(state.initial.transformation);
        in_buf_size.set(integer(buffer(&state.detail)));
        let (points, data) = store::device(F, store, |kept| {
            let points = kept.points(state.initial.points.iter().map(|&p| p.into()));
            (points, kept.stroke(state.prompt, &state.record))
        })?;
        init_stroke.set(points);
        stroke_data.set(data);
        Ok(())
    });
}

/// INQUIRE VALUATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_val_st(
    ws_id: Gint,
    val_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    op_mode: Out<Gint>,
    echo_switch: Out<Gint>,
    init_value: Out<Gdouble>,
    pet: Out<Gint>,
    echo_area: Out<Glimit>,
    low_value: Out<Gdouble>,
    high_value: Out<Gdouble>,
    val_data: Out<*const Nothing>,
) {
    const F: Function = Function::InquireValuatorDeviceState;
    val_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let state = gks.inquire_valuator_device_state(ws_id, val_num)?;
        set_common((op_mode, echo_switch, pet, echo_area), &state);
        init_value.set(state.initial);
        let (low, high) = limits(&state.detail);
        low_value.set(low);
        high_value.set(high);
        val_data.set(store::device(F, store, store::Device::nothing)?);
        Ok(())
    });
}

/// INQUIRE CHOICE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_choice_st(
    ws_id: Gint,
    choice_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    op_mode: Out<Gint>,
    echo_switch: Out<Gint>,
    init_status: Out<Gint>,
    init_choice: Out<Gint>,
    pet: Out<Gint>,
    echo_area: Out<Glimit>,
    choice_data: Out<*const Gchoice_data>,
) {
    const F: Function = Function::InquireChoiceDeviceState;
    choice_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let state = gks.inquire_choice_device_state(ws_id, choice_num)?;
        set_common((op_mode, echo_switch, pet, echo_area), &state);
        init_status.set(InputStatus::of(state.initial.as_ref()) as Gint);
        init_choice.set(state.initial.unwrap_or(0));
        choice_data.set(store::device(F, store, |kept| kept.choice(state.prompt, &state.record))?);
        Ok(())
    });
}

/// INQUIRE PICK DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_pick_st(
    ws_id: Gint,
    pick_num: Gint,
    inq_type: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    op_mode: Out<Gint>,
    echo_switch: Out<Gint>,
    init_status: Out<Gint>,
    init_pick: Out<Gpick>,
    pet: Out<Gint>,
    echo_area: Out<Glimit>,
    pick_data: Out<*const Nothing>,
) {
    const F: Function = Function::InquirePickDeviceState;
    pick_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let state = gks.inquire_pick_device_state(ws_id, pick_num, of(F, inq_type)?)?;
        set_common((op_mode, echo_switch, pet, echo_area), &state);
        super::set_pick(state.initial, init_status, init_pick);
        pick_data.set(store::device(F, store, store::Device::nothing)?);
        Ok(())
    });
}

/// INQUIRE STRING DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_string_st(
    ws_id: Gint,
    string_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    op_mode: Out<Gint>,
    echo_switch: Out<Gint>,
    init_string: Out<*const c_char>,
    pet: Out<Gint>,
    echo_area: Out<Glimit>,
    in_buf_size: Out<Gint>,
    init_cur_pos: Out<Gint>,
    string_data: Out<*const Nothing>,
) {
    const F: Function = Function::InquireStringDeviceState;
    init_string.set(std::ptr::null());
    string_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let state = gks.inquire_string_device_state(ws_id, string_num)?;
        set_common((op_mode, echo_switch, pet, echo_area), &state);
        if let Detail::String { buffer, cursor } = state.detail {
            in_buf_size.set(integer(buffer));
            init_cur_pos.set(integer(cursor));
        }
        let (text, data) = store::device(F, store, |kept| (kept.text(&state.initial), kept.nothing()))?;
        init_string.set(text);
        string_data.set(data);
        Ok(())
    });
}

/// INQUIRE DEFAULT LOCATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_loc_data(
    ws_type: Gint,
    loc_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    loc_pos: Out<Gpoint>,
    pet_list: Out<*const Gint_list>,
    echo_area: Out<Glimit>,
    loc_data: Out<*const Gloc_data>,
) {
    const F: Function = Function::InquireDefaultLocatorDeviceData;
    pet_list.set(std::ptr::null());
    loc_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let device = gks.inquire_default_locator_device_data(ws_type, loc_num)?;
        loc_pos.set(device.initial.position.into());
        echo_area.set(device.area.into());
        let keep = |kept: &mut store::Device| (kept.prompts(device.prompts), kept.locator(1, &device.record));
        let (prompts, data) = store::device(F, store, keep)?;
        pet_list.set(prompts);
        loc_data.set(data);
        Ok(())
    });
}

/// INQUIRE DEFAULT STROKE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_stroke_data(
    ws_type: Gint,
    stroke_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    max_buf_size: Out<Gint>,
    pet_list: Out<*const Gint_list>,
    echo_area: Out<Glimit>,
    buf_size: Out<Gint>,
    stroke_data: Out<*const Gstroke_data>,
) {
    const F: Function = Function::InquireDefaultStrokeDeviceData;
    pet_list.set(std::ptr::null());
    stroke_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let device = gks.inquire_default_stroke_device_data(ws_type, stroke_num)?;
        max_buf_size.set(integer(device.greatest_buffer));
        echo_area.set(device.area.into());
        buf_size.set(integer(buffer(&device.detail)));
        let keep = |kept: &mut store::Device| (kept.prompts(device.prompts), kept.stroke(1, &device.record));
        let (prompts, data) = store::device(F, store, keep)?;
        pet_list.set(prompts);
        stroke_data.set(data);
        Ok(())
    });
}

/// INQUIRE DEFAULT VALUATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_val_data(
    ws_type: Gint,
    val_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    def_value: Out<Gdouble>,
    pet_list: Out<*const Gint_list>,
    echo_area: Out<Glimit>,
    low_value: Out<Gdouble>,
    high_value: Out<Gdouble>,
    val_data: Out<*const Nothing>,
) {
    const F: Function = Function::InquireDefaultValuatorDeviceData;
    pet_list.set(std::ptr::null());
    val_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let device = gks.inquire_default_valuator_device_data(ws_type, val_num)?;
        def_value.set(device.initial);
        echo_area.set(device.area.into());
        let (low, high) = limits(&device.detail);
        low_value.set(low);
        high_value.set(high);
        let (prompts, data) = store::device(F, store, |kept| (kept.prompts(device.prompts), kept.nothing()))?;
        pet_list.set(prompts);
        val_data.set(data);
        Ok(())
    });
}

/// INQUIRE DEFAULT CHOICE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_choice_data(
    ws_type: Gint,
    choice_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    max_choices: Out<Gint>,
    pet_list: Out<*const Gint_list>,
    echo_area: Out<Glimit>,
    choice_data: Out<*const Gchoice_data>,
) {
    const F: Function = Function::InquireDefaultChoiceDeviceData;
    pet_list.set(std::ptr::null());
    choice_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let device = gks.inquire_default_choice_device_data(ws_type, choice_num)?;
        if let Detail::Choice { alternatives, .. } = device.detail {
            max_choices.set(alternatives);
        }
        echo_area.set(device.area.into());
        let keep = |kept: &mut store::Device| (kept.prompts(device.prompts), kept.choice(1, &device.record));
        let (prompts, data) = store::device(F, store, keep)?;
        pet_list.set(prompts);
        choice_data.set(data);
        Ok(())
    });
}

/// INQUIRE DEFAULT PICK DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_pick_data(
    ws_type: Gint,
    pick_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    pet_list: Out<*const Gint_list>,
    echo_area: Out<Glimit>,
    pick_data: Out<*const Nothing>,
) {
    const F: Function = Function::InquireDefaultPickDeviceData;
    pet_list.set(std::ptr::null());
    pick_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let device = gks.inquire_default_pick_device_data(ws_type, pick_num)?;
        echo_area.set(device.area.into());
        let (prompts, data) = store::device(F, store, |kept| (kept.prompts(device.prompts), kept.nothing()))?;
        pet_list.set(prompts);
        pick_data.set(data);
        Ok(())
    });
}

/// INQUIRE DEFAULT STRING DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_string_data(
    ws_type: Gint,
    string_num: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    max_buf_size: Out<Gint>,
    pet_list: Out<*const Gint_list>,
    echo_area: Out<Glimit>,
    buf_size: Out<Gint>,
    init_pos: Out<Gint>,
    string_data: Out<*const Nothing>,
) {
    const F: Function = Function::InquireDefaultStringDeviceData;
    pet_list.set(std::ptr::null());
    string_data.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let device = gks.inquire_default_string_device_data(ws_type, string_num)?;
        max_buf_size.set(integer(device.greatest_buffer));
        echo_area.set(device.area.into());
        if let Detail::String { buffer, cursor } = device.detail {
            buf_size.set(integer(buffer));
            init_pos.set(integer(cursor));
        }
        let (prompts, data) = store::device(F, store, |kept| (kept.prompts(device.prompts), kept.nothing()))?;
        pet_list.set(prompts);
        string_data.set(data);
        Ok(())
    });
}
