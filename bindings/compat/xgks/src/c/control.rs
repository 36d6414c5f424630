//! Control functions.

use super::argument::{Address, call, call_instance, choice};
use super::error::{Gfile, set_stream};
use super::types::{Gchar, Gint, Glong};
use gks::Function;
use gks_instance::ErrorFile;
use gks_pipeline::description::{DeferralMode, RegenerationMode};

/// Names of workstation types, which the Fortran binding numbers from 1 on.
const TYPES: [&str; 3] = ["MI", "MO", "WISS"];
/// The number of the type of windows, which is what any other name is: that of a display.
const WINDOW: Gint = 4;

/// The number of the workstation type of a name; a window for a null pointer.
pub(crate) fn kind(name: Address<Gchar>) -> Gint {
    let name = name.text();
    TYPES.iter().zip(1..).find(|(known, _)| **known == name).map_or(WINDOW, |(_, number)| number)
}

/// The name of the workstation type of a number.
pub(crate) fn kind_name(number: Gint) -> &'static str {
    usize::try_from(number - 1).ok().and_then(|at| TYPES.get(at)).unwrap_or(&"X")
}

/// OPEN GKS, with the stream for errors. The memory needs no limit.
#[unsafe(no_mangle)]
extern "C" fn gopengks(err_file: *mut Gfile, _memory: Glong) -> Gint {
    call_instance(Function::OpenGks, |instance| {
        instance.open_gks(ErrorFile::Stderr)?;
        set_stream(err_file);
        Ok(())
    })
}

/// CLOSE GKS.
#[unsafe(no_mangle)]
extern "C" fn gclosegks() -> Gint {
    call(Function::CloseGks, gks::Gks::close_gks)
}

/// EMERGENCY CLOSE GKS.
#[unsafe(no_mangle)]
extern "C" fn gemergencyclosegks() -> Gint {
    gks_instance::emergency_close_gks();
    0
}

/// OPEN WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gopenws(ws_id: Gint, connection: Address<Gchar>, ws_type: Address<Gchar>) -> Gint {
    call_instance(Function::OpenWorkstation, |instance| {
        let kind = kind(ws_type);
        // The connection of a window is the name of its display, which does not matter.
        let connection = if kind == WINDOW { "".into() } else { connection.text() };
        instance.open_workstation(ws_id, &connection, kind)
    })
}

/// CLOSE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gclosews(ws_id: Gint) -> Gint {
    call_instance(Function::CloseWorkstation, |instance| instance.close_workstation(ws_id))
}

/// ACTIVATE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gactivatews(ws_id: Gint) -> Gint {
    call(Function::ActivateWorkstation, |gks| gks.activate_workstation(ws_id))
}

/// DEACTIVATE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gdeactivatews(ws_id: Gint) -> Gint {
    call(Function::DeactivateWorkstation, |gks| gks.deactivate_workstation(ws_id))
}

/// CLEAR WORKSTATION: 0 conditionally, 1 always.
#[unsafe(no_mangle)]
extern "C" fn gclearws(ws_id: Gint, control_flag: Gint) -> Gint {
    call_instance(Function::ClearWorkstation, |instance| instance.clear_workstation(ws_id, control_flag != 0))
}

/// UPDATE WORKSTATION: 0 perform, 1 postpone.
#[unsafe(no_mangle)]
extern "C" fn gupdatews(ws_id: Gint, regeneration: Gint) -> Gint {
    call(Function::UpdateWorkstation, |gks| gks.update_workstation(ws_id, regeneration == 0))
}

/// SET DEFERRAL STATE.
#[unsafe(no_mangle)]
extern "C" fn gsetdeferst(ws_id: Gint, deferral: Gint, regeneration: Gint) -> Gint {
    const F: Function = Function::SetDeferralState;
    call(F, |gks| {
        let deferral = choice(DeferralMode::from_number(deferral), F)?;
        gks.set_deferral_state(ws_id, deferral, choice(RegenerationMode::from_number(regeneration), F)?)
    })
}

/// MESSAGE.
#[unsafe(no_mangle)]
extern "C" fn gmessage(ws_id: Gint, text: Address<Gchar>) -> Gint {
    call(Function::Message, |gks| gks.message(ws_id, &text.text()))
}
