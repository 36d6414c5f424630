//! Error logging, which GERLOG asks for.

use crate::argument::Integer;
use crate::call::NAMED_FILE;
use gks_instance::ErrorFile;
use std::ffi::c_int;

/// What GERLOG does: writes an error to the error file of a unit.
#[unsafe(no_mangle)]
extern "C" fn gks_log_error(error: Integer, function: Integer, file: Integer) {
    let file = match file.get() {
        NAMED_FILE => gks_instance::with(|instance| instance.error_file.clone()),
        unit => {
            flush(unit);
            ErrorFile::from_unit(unit)
        }
    };
    gks_instance::log(error.get(), function.get(), &file);
}

#[cfg(target_os = "linux")]
unsafe extern "C" {
    fn dlsym(handle: *mut std::ffi::c_void, symbol: *const std::ffi::c_char) -> *mut std::ffi::c_void;
}

/// Has gfortran's own library write out what a program has written to a unit, so that messages stand in order
/// among the lines of the program. Nothing happens in a process without that library.
#[cfg(target_os = "linux")]
fn flush(unit: c_int) {
    // SAFETY: a null handle means all that is loaded, and the name ends with a zero byte.
    let address = unsafe { dlsym(std::ptr::null_mut(), c"_gfortran_flush_i4".as_ptr()) };
    if address.is_null() {
        return;
    }
    // SAFETY: gfortran's library has the subroutine FLUSH, of one INTEGER, under this name.
    let flush: extern "C" fn(*const c_int) = unsafe { std::mem::transmute(address) };
    flush(&unit);
}

#[cfg(not(target_os = "linux"))]
fn flush(_unit: c_int) {}
