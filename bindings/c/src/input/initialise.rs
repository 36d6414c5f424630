//! INITIALISE and SET MODE.
#![allow(clippy::too_many_arguments, reason = "the functions of the standard have as many")]

use super::record::{self, Gchoice_data, Gloc_data, Gstroke_data, Nothing};
use crate::argument::{In, array, call, choice as enumeration, flag};
use crate::types::{Gdouble, Gint, Glimit, Gpoint, Gpoint_list};
use gks::{DataRecord, Function, InputStatus, OperatingMode};
use std::ffi::c_char;

/// INITIALISE LOCATOR. A null pointer is an empty data record, here and in what follows.
#[unsafe(no_mangle)]
extern "C" fn ginit_loc(
    ws_id: Gint,
    loc_num: Gint,
    init_norm_tran_num: Gint,
    init_loc_pos: In<Gpoint>,
    pet: Gint,
    echo_area: In<Glimit>,
    loc_data: In<Gloc_data>,
) {
    const F: Function = Function::InitialiseLocator;
    call(F, |gks| {
        let (position, area) = (init_loc_pos.needed(F)?, echo_area.needed(F)?);
        let record = record::locator(pet, loc_data);
        gks.initialise_locator(ws_id, loc_num, init_norm_tran_num, position, pet, area, &record)
    });
}

/// INITIALISE STROKE.
#[unsafe(no_mangle)]
extern "C" fn ginit_stroke(
    ws_id: Gint,
    stroke_num: Gint,
    init_norm_tran_num: Gint,
    init_stroke: In<Gpoint_list>,
    pet: Gint,
    echo_area: In<Glimit>,
    in_buf_size: Gint,
    stroke_data: In<Gstroke_data>,
) {
    const F: Function = Function::InitialiseStroke;
    call(F, |gks| {
        let area = echo_area.needed(F)?;
        let points = init_stroke.get().map_or(&[][..], |list| array(list.points, list.num_points));
        let points: Vec<(f64, f64)> = points.iter().map(|&p| p.into()).collect();
        let record = record::stroke(pet, stroke_data);
        let transformation = init_norm_tran_num;
        gks.initialise_stroke(ws_id, stroke_num, transformation, &points, pet, area, in_buf_size, &record)
    });
}

/// INITIALISE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn ginit_val(
    ws_id: Gint,
    val_num: Gint,
    init_value: Gdouble,
    pet: Gint,
    echo_area: In<Glimit>,
    low_value: Gdouble,
    high_value: Gdouble,
    _val_data: In<Nothing>,
) {
    const F: Function = Function::InitialiseValuator;
    call(F, |gks| {
        let (area, record) = (echo_area.needed(F)?, DataRecord::default());
        gks.initialise_valuator(ws_id, val_num, init_value, pet, area, low_value, high_value, &record)
    });
}

/// INITIALISE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn ginit_choice(
    ws_id: Gint,
    choice_num: Gint,
    init_status: Gint,
    init_choice: Gint,
    pet: Gint,
    echo_area: In<Glimit>,
    choice_data: In<Gchoice_data>,
) {
    const F: Function = Function::InitialiseChoice;
    call(F, |gks| {
        let status = enumeration(F, init_status, InputStatus::from_number)?;
        let (area, record) = (echo_area.needed(F)?, record::choice(pet, choice_data));
        gks.initialise_choice(ws_id, choice_num, status, init_choice, pet, area, &record)
    });
}

/// INITIALISE PICK.
#[unsafe(no_mangle)]
extern "C" fn ginit_pick(
    ws_id: Gint,
    pick_num: Gint,
    init_status: Gint,
    init_pick: In<crate::types::Gpick>,
    pet: Gint,
    echo_area: In<Glimit>,
    _pick_data: In<Nothing>,
) {
    const F: Function = Function::InitialisePick;
    call(F, |gks| {
        let status = enumeration(F, init_status, InputStatus::from_number)?;
        let (area, record) = (echo_area.needed(F)?, DataRecord::default());
        // Nothing picked needs no pick.
        let (segment, identifier) = match (status, init_pick.get()) {
            (_, Some(pick)) => (pick.seg_name, pick.pick_id),
            (InputStatus::NoInput, None) => (0, 0),
            (_, None) => init_pick.needed(F).map(|pick| (pick.seg_name, pick.pick_id))?,
        };
        gks.initialise_pick(ws_id, pick_num, status, segment, identifier, pet, area, &record)
    });
}

/// INITIALISE STRING.
#[unsafe(no_mangle)]
extern "C" fn ginit_string(
    ws_id: Gint,
    string_num: Gint,
    init_string: In<c_char>,
    pet: Gint,
    echo_area: In<Glimit>,
    in_buf_size: Gint,
    init_cur_pos: Gint,
    _string_data: In<Nothing>,
) {
    const F: Function = Function::InitialiseString;
    call(F, |gks| {
        let (area, record, string) = (echo_area.needed(F)?, DataRecord::default(), init_string.text());
        gks.initialise_string(ws_id, string_num, &string, pet, area, in_buf_size, init_cur_pos, &record)
    });
}

macro_rules! modes {
    ($($name:ident $function:ident $method:ident)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_id: Gint, in_num: Gint, op_mode: Gint, echo_switch: Gint) {
            const F: Function = Function::$function;
            call(F, |gks| {
                let mode = enumeration(F, op_mode, OperatingMode::from_number)?;
                gks.$method(ws_id, in_num, mode, flag(F, echo_switch)?)
            });
        }
    )+ };
}

modes! {
    gset_loc_mode SetLocatorMode set_locator_mode
    gset_stroke_mode SetStrokeMode set_stroke_mode
    gset_val_mode SetValuatorMode set_valuator_mode
    gset_choice_mode SetChoiceMode set_choice_mode
    gset_pick_mode SetPickMode set_pick_mode
    gset_string_mode SetStringMode set_string_mode
}
