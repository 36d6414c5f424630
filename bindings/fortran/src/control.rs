//! Control: opening and closing, clearing and updating, messages.

use crate::argument::{Character, Integer};
use crate::call::{call_instance, check_state, subroutines};
use crate::{ncar, xgks};
use gks::{Error, Function, OperatingState};
use gks_instance::{ErrorFile, from_latin1};

/// GOPKS: OPEN GKS. The number of memory units for the buffer area does not matter.
#[unsafe(no_mangle)]
extern "C" fn gopks_(errfil: Integer, _bufa: Integer) {
    const F: Function = Function::OpenGks;
    call_instance(F, |instance| {
        let unit = errfil.get();
        if unit < 0 && instance.gks.inquire_operating_state_value() == OperatingState::Gkcl {
            return Err(Error::new(200, F).because(format!("unit {unit}")));
        }
        ncar::share_error_unit(instance.dialect, unit);
        instance.open_gks(xgks::error_file(instance, unit).unwrap_or_else(|| ErrorFile::from_unit(unit)))
    });
}

/// GOPWK: OPEN WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gopwk_(wkid: Integer, conid: Integer, wtype: Integer) {
    call_instance(Function::OpenWorkstation, |instance| {
        let (conid, wtype) = (conid.get(), wtype.get());
        let name = xgks::connection(instance, conid, wtype).unwrap_or_else(|| conid.to_string());
        instance.open_workstation(wkid.get(), &name, wtype)
    });
}

/// GUWK: UPDATE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn guwk_(wkid: Integer, regfl: Integer) {
    const F: Function = Function::UpdateWorkstation;
    call_instance(F, |instance| {
        check_state(&instance.gks, F)?;
        instance.update_workstation(wkid.get(), regfl.choice(F)?)
    });
}

/// GECLKS: EMERGENCY CLOSE GKS. It is allowed while an error is being handled, too.
#[unsafe(no_mangle)]
extern "C" fn geclks_() {
    gks_instance::emergency_close_gks();
}

/// GCLWK: CLOSE WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gclwk_(wkid: Integer) {
    const F: Function = Function::CloseWorkstation;
    call_instance(F, |instance| {
        check_state(&instance.gks, F)?;
        instance.close_workstation(wkid.get())
    });
}

/// GCLRWK: CLEAR WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gclrwk_(wkid: Integer, cofl: Integer) {
    const F: Function = Function::ClearWorkstation;
    call_instance(F, |instance| {
        check_state(&instance.gks, F)?;
        instance.clear_workstation(wkid.get(), cofl.choice(F)?)
    });
}

subroutines! {
    gclks_() CloseGks => gks::Gks::close_gks;
    gacwk_(wkid: Integer) ActivateWorkstation => |gks| gks.activate_workstation(wkid.get());
    gdawk_(wkid: Integer) DeactivateWorkstation => |gks| gks.deactivate_workstation(wkid.get());
    gsds_(wkid: Integer, defmod: Integer, regmod: Integer) SetDeferralState
        => |gks| gks.set_deferral_state(wkid.get(), defmod.choice(F)?, regmod.choice(F)?);
    gmsg_(wkid: Integer, mess: Character, length: usize) Message
        => |gks| gks.message(wkid.get(), from_latin1(mess.slice(0, length)).trim_end());
    gmsgs_(wkid: Integer, lstr: Integer, mess: Character, length: usize) Message
        => |gks| gks.message(wkid.get(), &from_latin1(mess.slice(0, length.min(lstr.count()))));
}
