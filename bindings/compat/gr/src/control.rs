//! Control functions and segments.

use crate::argument::{Address, call, call_instance, choice};
use crate::extension;
use gks::{Function, Gks};
use gks_instance::ErrorFile;
use gks_pipeline::description::{DeferralMode, RegenerationMode};
use std::ffi::{c_char, c_int};

/// Prepares the library. There is nothing to prepare.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_init_gks() {}

/// OPEN GKS, with the Fortran unit for errors.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_open_gks(unit: c_int) {
    call_instance(Function::OpenGks, |instance| {
        instance.open_gks(ErrorFile::from_unit(unit.max(0)))?;
        extension::set_clipping(&mut instance.gks)
    });
}

/// CLOSE GKS.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_close_gks() {
    call(Function::CloseGks, Gks::close_gks);
}

/// EMERGENCY CLOSE GKS.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_emergency_close() {
    gks_instance::emergency_close_gks();
}

/// OPEN WORKSTATION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_open_ws(ws_id: c_int, connection: Address<c_char>, kind: c_int) {
    call(Function::OpenWorkstation, |gks| {
        gks.open_workstation(ws_id, &connection.text(), kind)?;
        extension::set_nominal_sizes(gks, ws_id)
    });
}

/// CLOSE WORKSTATION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_close_ws(ws_id: c_int) {
    call(Function::CloseWorkstation, |gks| gks.close_workstation(ws_id));
}

/// ACTIVATE WORKSTATION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_activate_ws(ws_id: c_int) {
    call(Function::ActivateWorkstation, |gks| gks.activate_workstation(ws_id));
}

/// DEACTIVATE WORKSTATION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_deactivate_ws(ws_id: c_int) {
    call(Function::DeactivateWorkstation, |gks| gks.deactivate_workstation(ws_id));
}

/// CLEAR WORKSTATION: 0 conditionally, 1 always.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_clear_ws(ws_id: c_int, control_flag: c_int) {
    call(Function::ClearWorkstation, |gks| gks.clear_workstation(ws_id, control_flag != 0));
}

/// UPDATE WORKSTATION: 0 postpone, 1 perform. GR's further flag 2 asks for a page to be kept while it is written.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_update_ws(ws_id: c_int, regeneration: c_int) {
    call(Function::UpdateWorkstation, |gks| gks.update_workstation(ws_id, regeneration != 0));
}

/// SET DEFERRAL STATE.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_deferral_state(ws_id: c_int, deferral: c_int, regeneration: c_int) {
    const F: Function = Function::SetDeferralState;
    call(F, |gks| {
        let deferral = choice(DeferralMode::from_number(deferral), F)?;
        gks.set_deferral_state(ws_id, deferral, choice(RegenerationMode::from_number(regeneration), F)?)
    });
}

/// MESSAGE.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_message(ws_id: c_int, text: Address<c_char>) {
    call(Function::Message, |gks| gks.message(ws_id, &text.text()));
}

/// Segment functions of one or two numbers.
macro_rules! segments {
    ($($name:ident($($argument:ident),*) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name($($argument: c_int),*) {
            call(Function::$function, |gks| gks.$method($($argument),*));
        }
    )+ };
}

segments! {
    gks_create_seg(name) CreateSegment => create_segment;
    gks_delete_seg(name) DeleteSegment => delete_segment;
    gks_assoc_seg_with_ws(ws_id, name) AssociateSegmentWithWorkstation => associate_segment_with_workstation;
    gks_copy_seg_to_ws(ws_id, name) CopySegmentToWorkstation => copy_segment_to_workstation;
    gks_redraw_seg_on_ws(ws_id) RedrawAllSegmentsOnWorkstation => redraw_all_segments_on_workstation;
}

/// CLOSE SEGMENT.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_close_seg() {
    call(Function::CloseSegment, Gks::close_segment);
}

/// SET SEGMENT TRANSFORMATION, by a matrix of three rows of two numbers.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_seg_xform(name: c_int, matrix: Address<f64>) {
    const F: Function = Function::SetSegmentTransformation;
    call(F, |gks| {
        let matrix: Option<[f64; 6]> = matrix.array(6).try_into().ok();
        let m = choice(matrix, F)?;
        gks.set_segment_transformation(name, [[m[0], m[2], m[4]], [m[1], m[3], m[5]]])
    });
}

/// INQUIRE NAME OF OPEN SEGMENT.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_open_segn(error: Address<c_int>, name: Address<c_int>) {
    crate::argument::inquire(Function::InquireNameOfOpenSegment, error, |gks| {
        name.set(gks.inquire_name_of_open_segment()?);
        Ok(())
    });
}
