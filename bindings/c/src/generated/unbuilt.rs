//! The functions of the levels of GKS that are not built yet.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

use crate::argument::Out;
use crate::types::*;
use crate::unbuilt::{refuse, refusal};
use gks::Function;
use std::ffi::{c_char, c_void};

/// SET PICK IDENTIFIER.
#[unsafe(no_mangle)]
extern "C" fn gset_pick_id(_pick_id: Gint) {
    refuse(Function::SetPickIdentifier);
}

/// INITIALISE LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn ginit_loc(_ws_id: Gint, _loc_num: Gint, _init_norm_tran_num: Gint, _init_loc_pos: *const c_void, _pet: Gint, _echo_area: *const c_void, _loc_data: *const c_void) {
    refuse(Function::InitialiseLocator);
}

/// INITIALISE STROKE.
#[unsafe(no_mangle)]
extern "C" fn ginit_stroke(_ws_id: Gint, _stroke_num: Gint, _init_norm_tran_num: Gint, _init_stroke: *const c_void, _pet: Gint, _echo_area: *const c_void, _in_buf_size: Gint, _stroke_data: *const c_void) {
    refuse(Function::InitialiseStroke);
}

/// INITIALISE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn ginit_val(_ws_id: Gint, _val_num: Gint, _init_value: Gdouble, _pet: Gint, _echo_area: *const c_void, _low_value: Gdouble, _high_value: Gdouble, _val_data: *const c_void) {
    refuse(Function::InitialiseValuator);
}

/// INITIALISE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn ginit_choice(_ws_id: Gint, _choice_num: Gint, _init_status: Gint, _init_choice: Gint, _pet: Gint, _echo_area: *const c_void, _choice_data: *const c_void) {
    refuse(Function::InitialiseChoice);
}

/// INITIALISE PICK.
#[unsafe(no_mangle)]
extern "C" fn ginit_pick(_ws_id: Gint, _pick_num: Gint, _init_status: Gint, _init_pick: *const c_void, _pet: Gint, _echo_area: *const c_void, _pick_data: *const c_void) {
    refuse(Function::InitialisePick);
}

/// INITIALISE STRING.
#[unsafe(no_mangle)]
extern "C" fn ginit_string(_ws_id: Gint, _string_num: Gint, _init_string: *const c_void, _pet: Gint, _echo_area: *const c_void, _in_buf_size: Gint, _init_cur_pos: Gint, _string_data: *const c_void) {
    refuse(Function::InitialiseString);
}

/// SET LOCATOR MODE.
#[unsafe(no_mangle)]
extern "C" fn gset_loc_mode(_ws_id: Gint, _loc_num: Gint, _op_mode: Gint, _echo_switch: Gint) {
    refuse(Function::SetLocatorMode);
}

/// SET STROKE MODE.
#[unsafe(no_mangle)]
extern "C" fn gset_stroke_mode(_ws_id: Gint, _stroke_num: Gint, _op_mode: Gint, _echo_switch: Gint) {
    refuse(Function::SetStrokeMode);
}

/// SET VALUATOR MODE.
#[unsafe(no_mangle)]
extern "C" fn gset_val_mode(_ws_id: Gint, _val_num: Gint, _op_mode: Gint, _echo_switch: Gint) {
    refuse(Function::SetValuatorMode);
}

/// SET CHOICE MODE.
#[unsafe(no_mangle)]
extern "C" fn gset_choice_mode(_ws_id: Gint, _choice_num: Gint, _op_mode: Gint, _echo_switch: Gint) {
    refuse(Function::SetChoiceMode);
}

/// SET PICK MODE.
#[unsafe(no_mangle)]
extern "C" fn gset_pick_mode(_ws_id: Gint, _pick_num: Gint, _op_mode: Gint, _echo_switch: Gint) {
    refuse(Function::SetPickMode);
}

/// SET STRING MODE.
#[unsafe(no_mangle)]
extern "C" fn gset_string_mode(_ws_id: Gint, _string_num: Gint, _op_mode: Gint, _echo_switch: Gint) {
    refuse(Function::SetStringMode);
}

/// REQUEST LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn greq_loc(_ws_id: Gint, _loc_num: Gint, in_status: Out<Gint>, norm_tran_num: Out<Gint>, loc_pos: Out<Gpoint>) {
    in_status.clear();
    norm_tran_num.clear();
    loc_pos.clear();
    refuse(Function::RequestLocator);
}

/// REQUEST STROKE.
#[unsafe(no_mangle)]
extern "C" fn greq_stroke(_ws_id: Gint, _stroke_num: Gint, in_status: Out<Gint>, norm_tran_num: Out<Gint>, stroke: Out<Gpoint_list>) {
    in_status.clear();
    norm_tran_num.clear();
    stroke.count().clear();
    refuse(Function::RequestStroke);
}

/// REQUEST VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn greq_val(_ws_id: Gint, _val_num: Gint, in_status: Out<Gint>, value: Out<Gdouble>) {
    in_status.clear();
    value.clear();
    refuse(Function::RequestValuator);
}

/// REQUEST CHOICE.
#[unsafe(no_mangle)]
extern "C" fn greq_choice(_ws_id: Gint, _choice_num: Gint, in_status: Out<Gint>, choice: Out<Gint>) {
    in_status.clear();
    choice.clear();
    refuse(Function::RequestChoice);
}

/// REQUEST PICK.
#[unsafe(no_mangle)]
extern "C" fn greq_pick(_ws_id: Gint, _pick_num: Gint, in_status: Out<Gint>, pick: Out<Gpick>) {
    in_status.clear();
    pick.clear();
    refuse(Function::RequestPick);
}

/// REQUEST STRING.
#[unsafe(no_mangle)]
extern "C" fn greq_string(_ws_id: Gint, _string_num: Gint, in_status: Out<Gint>, string: Out<c_char>) {
    in_status.clear();
    string.clear();
    refuse(Function::RequestString);
}

/// SAMPLE LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gsample_loc(_ws_id: Gint, _loc_num: Gint, norm_tran_num: Out<Gint>, loc_pos: Out<Gpoint>) {
    norm_tran_num.clear();
    loc_pos.clear();
    refuse(Function::SampleLocator);
}

/// SAMPLE STROKE.
#[unsafe(no_mangle)]
extern "C" fn gsample_stroke(_ws_id: Gint, _stroke_num: Gint, norm_tran_num: Out<Gint>, stroke: Out<Gpoint_list>) {
    norm_tran_num.clear();
    stroke.count().clear();
    refuse(Function::SampleStroke);
}

/// SAMPLE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn gsample_val(_ws_id: Gint, _val_num: Gint, value: Out<Gdouble>) {
    value.clear();
    refuse(Function::SampleValuator);
}

/// SAMPLE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn gsample_choice(_ws_id: Gint, _choice_num: Gint, in_status: Out<Gint>, choice: Out<Gint>) {
    in_status.clear();
    choice.clear();
    refuse(Function::SampleChoice);
}

/// SAMPLE PICK.
#[unsafe(no_mangle)]
extern "C" fn gsample_pick(_ws_id: Gint, _pick_num: Gint, in_status: Out<Gint>, pick: Out<Gpick>) {
    in_status.clear();
    pick.clear();
    refuse(Function::SamplePick);
}

/// SAMPLE STRING.
#[unsafe(no_mangle)]
extern "C" fn gsample_string(_ws_id: Gint, _string_num: Gint, string: Out<c_char>) {
    string.clear();
    refuse(Function::SampleString);
}

/// AWAIT EVENT.
#[unsafe(no_mangle)]
extern "C" fn gawait_event(_timeout: Gdouble, ws_id: Out<Gint>, in_class: Out<Gint>, in_num: Out<Gint>) {
    ws_id.clear();
    in_class.clear();
    in_num.clear();
    refuse(Function::AwaitEvent);
}

/// FLUSH DEVICE EVENTS.
#[unsafe(no_mangle)]
extern "C" fn gflush_events(_ws_id: Gint, _in_class: Gint, _in_num: Gint) {
    refuse(Function::FlushDeviceEvents);
}

/// GET LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gget_loc(norm_tran_num: Out<Gint>, loc_pos: Out<Gpoint>) {
    norm_tran_num.clear();
    loc_pos.clear();
    refuse(Function::GetLocator);
}

/// GET STROKE.
#[unsafe(no_mangle)]
extern "C" fn gget_stroke(norm_tran_num: Out<Gint>, stroke: Out<Gpoint_list>) {
    norm_tran_num.clear();
    stroke.count().clear();
    refuse(Function::GetStroke);
}

/// GET VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn gget_val(value: Out<Gdouble>) {
    value.clear();
    refuse(Function::GetValuator);
}

/// GET CHOICE.
#[unsafe(no_mangle)]
extern "C" fn gget_choice(in_status: Out<Gint>, choice: Out<Gint>) {
    in_status.clear();
    choice.clear();
    refuse(Function::GetChoice);
}

/// GET PICK.
#[unsafe(no_mangle)]
extern "C" fn gget_pick(in_status: Out<Gint>, pick: Out<Gpick>) {
    in_status.clear();
    pick.clear();
    refuse(Function::GetPick);
}

/// GET STRING.
#[unsafe(no_mangle)]
extern "C" fn gget_string(string: Out<c_char>) {
    string.clear();
    refuse(Function::GetString);
}

/// INQUIRE CURRENT PICK IDENTIFIER VALUE.
#[unsafe(no_mangle)]
extern "C" fn ginq_cur_pick_id(err_ind: Out<Gint>, pick_id: Out<Gint>) {
    pick_id.clear();
    err_ind.set(refusal(Function::InquireCurrentPickIdentifierValue));
}

/// INQUIRE MORE SIMULTANEOUS EVENTS.
#[unsafe(no_mangle)]
extern "C" fn ginq_more_simult_events(err_ind: Out<Gint>, simult_events: Out<Gint>) {
    simult_events.clear();
    err_ind.set(refusal(Function::InquireMoreSimultaneousEvents));
}

/// INQUIRE LOCATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_loc_st(_ws_id: Gint, _loc_num: Gint, _type: Gint, _store: *const c_void, err_ind: Out<Gint>, op_mode: Out<Gint>, echo_switch: Out<Gint>, init_norm_tran_num: Out<Gint>, init_loc_pos: Out<Gpoint>, pet: Out<Gint>, echo_area: Out<Glimit>, loc_data: Out<*mut c_void>) {
    op_mode.clear();
    echo_switch.clear();
    init_norm_tran_num.clear();
    init_loc_pos.clear();
    pet.clear();
    echo_area.clear();
    loc_data.clear();
    err_ind.set(refusal(Function::InquireLocatorDeviceState));
}

/// INQUIRE STROKE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_stroke_st(_ws_id: Gint, _stroke_num: Gint, _type: Gint, _store: *const c_void, err_ind: Out<Gint>, op_mode: Out<Gint>, echo_switch: Out<Gint>, init_norm_tran_num: Out<Gint>, init_stroke: Out<*mut c_void>, pet: Out<Gint>, echo_area: Out<Glimit>, in_buf_size: Out<Gint>, stroke_data: Out<*mut c_void>) {
    op_mode.clear();
    echo_switch.clear();
    init_norm_tran_num.clear();
    init_stroke.clear();
    pet.clear();
    echo_area.clear();
    in_buf_size.clear();
    stroke_data.clear();
    err_ind.set(refusal(Function::InquireStrokeDeviceState));
}

/// INQUIRE VALUATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_val_st(_ws_id: Gint, _val_num: Gint, _store: *const c_void, err_ind: Out<Gint>, op_mode: Out<Gint>, echo_switch: Out<Gint>, init_value: Out<Gdouble>, pet: Out<Gint>, echo_area: Out<Glimit>, low_value: Out<Gdouble>, high_value: Out<Gdouble>, val_data: Out<*mut c_void>) {
    op_mode.clear();
    echo_switch.clear();
    init_value.clear();
    pet.clear();
    echo_area.clear();
    low_value.clear();
    high_value.clear();
    val_data.clear();
    err_ind.set(refusal(Function::InquireValuatorDeviceState));
}

/// INQUIRE CHOICE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_choice_st(_ws_id: Gint, _choice_num: Gint, _store: *const c_void, err_ind: Out<Gint>, op_mode: Out<Gint>, echo_switch: Out<Gint>, init_status: Out<Gint>, init_choice: Out<Gint>, pet: Out<Gint>, echo_area: Out<Glimit>, choice_data: Out<*mut c_void>) {
    op_mode.clear();
    echo_switch.clear();
    init_status.clear();
    init_choice.clear();
    pet.clear();
    echo_area.clear();
    choice_data.clear();
    err_ind.set(refusal(Function::InquireChoiceDeviceState));
}

/// INQUIRE PICK DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_pick_st(_ws_id: Gint, _pick_num: Gint, _type: Gint, _store: *const c_void, err_ind: Out<Gint>, op_mode: Out<Gint>, echo_switch: Out<Gint>, init_status: Out<Gint>, init_pick: Out<Gpick>, pet: Out<Gint>, echo_area: Out<Glimit>, pick_data: Out<*mut c_void>) {
    op_mode.clear();
    echo_switch.clear();
    init_status.clear();
    init_pick.clear();
    pet.clear();
    echo_area.clear();
    pick_data.clear();
    err_ind.set(refusal(Function::InquirePickDeviceState));
}

/// INQUIRE STRING DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_string_st(_ws_id: Gint, _string_num: Gint, _store: *const c_void, err_ind: Out<Gint>, op_mode: Out<Gint>, echo_switch: Out<Gint>, init_string: Out<*mut c_void>, pet: Out<Gint>, echo_area: Out<Glimit>, in_buf_size: Out<Gint>, init_cur_pos: Out<Gint>, string_data: Out<*mut c_void>) {
    op_mode.clear();
    echo_switch.clear();
    init_string.clear();
    pet.clear();
    echo_area.clear();
    in_buf_size.clear();
    init_cur_pos.clear();
    string_data.clear();
    err_ind.set(refusal(Function::InquireStringDeviceState));
}

/// INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES.
#[unsafe(no_mangle)]
extern "C" fn ginq_num_avail_in(_ws_type: Gint, err_ind: Out<Gint>, num_in: Out<Gnum_in>) {
    num_in.clear();
    err_ind.set(refusal(Function::InquireNumberOfAvailableLogicalInputDevices));
}

/// INQUIRE DEFAULT LOCATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_loc_data(_ws_type: Gint, _loc_num: Gint, _store: *const c_void, err_ind: Out<Gint>, loc_pos: Out<Gpoint>, pet_list: Out<*mut c_void>, echo_area: Out<Glimit>, loc_data: Out<*mut c_void>) {
    loc_pos.clear();
    pet_list.clear();
    echo_area.clear();
    loc_data.clear();
    err_ind.set(refusal(Function::InquireDefaultLocatorDeviceData));
}

/// INQUIRE DEFAULT STROKE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_stroke_data(_ws_type: Gint, _stroke_num: Gint, _store: *const c_void, err_ind: Out<Gint>, max_buf_size: Out<Gint>, pet_list: Out<*mut c_void>, echo_area: Out<Glimit>, buf_size: Out<Gint>, stroke_data: Out<*mut c_void>) {
    max_buf_size.clear();
    pet_list.clear();
    echo_area.clear();
    buf_size.clear();
    stroke_data.clear();
    err_ind.set(refusal(Function::InquireDefaultStrokeDeviceData));
}

/// INQUIRE DEFAULT VALUATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_val_data(_ws_type: Gint, _val_num: Gint, _store: *const c_void, err_ind: Out<Gint>, def_value: Out<Gdouble>, pet_list: Out<*mut c_void>, echo_area: Out<Glimit>, low_value: Out<Gdouble>, high_value: Out<Gdouble>, val_data: Out<*mut c_void>) {
    def_value.clear();
    pet_list.clear();
    echo_area.clear();
    low_value.clear();
    high_value.clear();
    val_data.clear();
    err_ind.set(refusal(Function::InquireDefaultValuatorDeviceData));
}

/// INQUIRE DEFAULT CHOICE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_choice_data(_ws_type: Gint, _choice_num: Gint, _store: *const c_void, err_ind: Out<Gint>, max_choices: Out<Gint>, pet_list: Out<*mut c_void>, echo_area: Out<Glimit>, choice_data: Out<*mut c_void>) {
    max_choices.clear();
    pet_list.clear();
    echo_area.clear();
    choice_data.clear();
    err_ind.set(refusal(Function::InquireDefaultChoiceDeviceData));
}

/// INQUIRE DEFAULT PICK DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_pick_data(_ws_type: Gint, _pick_num: Gint, _store: *const c_void, err_ind: Out<Gint>, pet_list: Out<*mut c_void>, echo_area: Out<Glimit>, pick_data: Out<*mut c_void>) {
    pet_list.clear();
    echo_area.clear();
    pick_data.clear();
    err_ind.set(refusal(Function::InquireDefaultPickDeviceData));
}

/// INQUIRE DEFAULT STRING DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_string_data(_ws_type: Gint, _string_num: Gint, _store: *const c_void, err_ind: Out<Gint>, max_buf_size: Out<Gint>, pet_list: Out<*mut c_void>, echo_area: Out<Glimit>, buf_size: Out<Gint>, init_pos: Out<Gint>, string_data: Out<*mut c_void>) {
    max_buf_size.clear();
    pet_list.clear();
    echo_area.clear();
    buf_size.clear();
    init_pos.clear();
    string_data.clear();
    err_ind.set(refusal(Function::InquireDefaultStringDeviceData));
}

/// INQUIRE INPUT QUEUE OVERFLOW.
#[unsafe(no_mangle)]
extern "C" fn ginq_in_overf(err_ind: Out<Gint>, ws_id: Out<Gint>, in_class: Out<Gint>, in_num: Out<Gint>) {
    ws_id.clear();
    in_class.clear();
    in_num.clear();
    err_ind.set(refusal(Function::InquireInputQueueOverflow));
}
