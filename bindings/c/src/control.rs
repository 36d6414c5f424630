//! Control functions, escapes apart.

use crate::argument::{In, call, choice, flag};
use crate::error::report;
use crate::types::Gint;
use gks::{Error, Function, Gks};
use gks_instance::ErrorFile;
use gks_pipeline::description::{DeferralMode, RegenerationMode};
use std::ffi::c_char;

/// OPEN GKS, with the name of the error file, the standard error output for a null pointer. The memory needs
/// no limit. Error 200: the file cannot be written.
#[unsafe(no_mangle)]
extern "C" fn gopen_gks(err_file: In<c_char>, _mem_unit: usize) {
    const F: Function = Function::OpenGks;
    gks_instance::call_instance(F, report, |instance| {
        gks_instance::check_state(&instance.gks, F)?;
        let file = ErrorFile::from_name(&err_file.text());
        if !file.is_valid() {
            return Err(Error::new(200, F).because(err_file.text()));
        }
        instance.open_gks(file)
    });
}

/// CLOSE GKS.
#[unsafe(no_mangle)]
extern "C" fn gclose_gks() {
    call(Function::CloseGks, Gks::close_gks);
}

/// OPEN WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gopen_ws(ws_id: Gint, conn_id: In<c_char>, ws_type: Gint) {
    const F: Function = Function::OpenWorkstation;
    gks_instance::call_instance(F, report, |instance| {
        gks_instance::check_state(&instance.gks, F)?;
        instance.open_workstation(ws_id, &conn_id.text(), ws_type)
    });
}

/// CLOSE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gclose_ws(ws_id: Gint) {
    call(Function::CloseWorkstation, |gks| gks.close_workstation(ws_id));
}

/// ACTIVATE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gactivate_ws(ws_id: Gint) {
    call(Function::ActivateWorkstation, |gks| gks.activate_workstation(ws_id));
}

/// DEACTIVATE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gdeactivate_ws(ws_id: Gint) {
    call(Function::DeactivateWorkstation, |gks| gks.deactivate_workstation(ws_id));
}

/// CLEAR WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gclear_ws(ws_id: Gint, ctrl_flag: Gint) {
    const F: Function = Function::ClearWorkstation;
    call(F, |gks| gks.clear_workstation(ws_id, flag(F, ctrl_flag)?));
}

/// UPDATE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gupd_ws(ws_id: Gint, upd_regen_flag: Gint) {
    const F: Function = Function::UpdateWorkstation;
    gks_instance::call_instance(F, report, |instance| {
        gks_instance::check_state(&instance.gks, F)?;
        instance.update_workstation(ws_id, flag(F, upd_regen_flag)?)
    });
}

/// SET DEFERRAL STATE.
#[unsafe(no_mangle)]
extern "C" fn gset_defer_st(ws_id: Gint, defer_mode: Gint, irg_mode: Gint) {
    const F: Function = Function::SetDeferralState;
    call(F, |gks| {
        let deferral = choice(F, defer_mode, DeferralMode::from_number)?;
        gks.set_deferral_state(ws_id, deferral, choice(F, irg_mode, RegenerationMode::from_number)?)
    });
}

/// MESSAGE.
#[unsafe(no_mangle)]
extern "C" fn gmessage(ws_id: Gint, message: In<c_char>) {
    call(Function::Message, |gks| gks.message(ws_id, &message.text()));
}
