//! Error logging, which GERLOG asks for.

use crate::argument::Integer;
use crate::call::NAMED_FILE;
use gks_instance::ErrorFile;
use std::ffi::c_int;
#[cfg(target_os = "linux")]
use std::ffi::{CStr, c_char, c_void};

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
    fn dlsym(handle: *mut c_void, symbol: *const c_char) -> *mut c_void;
}

/// The address of a symbol of the program or of a library that it has loaded; null where there is none.
#[cfg(target_os = "linux")]
pub(crate) fn find(symbol: &CStr) -> *mut c_void {
    // SAFETY: a null handle means all that is loaded, and the name ends with a zero byte.
    unsafe { dlsym(std::ptr::null_mut(), symbol.as_ptr()) }
}

/// Has gfortran's own library write out what a program has written to a unit, so that messages stand in order
/// among the lines of the program. Nothing happens in a process without that library.
#[cfg(target_os = "linux")]
fn flush(unit: c_int) {
    let address = find(c"_gfortran_flush_i4");
    if address.is_null() {
        return;
    }
    // SAFETY: gfortran's library has the subroutine FLUSH, of one INTEGER, under this name.
    let flush: extern "C" fn(*const c_int) = unsafe { std::mem::transmute(address) };
    flush(&unit);
}

#[cfg(not(target_os = "linux"))]
fn flush(_unit: c_int) {}
