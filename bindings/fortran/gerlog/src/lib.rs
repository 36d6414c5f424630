//! The default error logging procedure of the Fortran binding, GERLOG, alone in this crate for the same
//! reason as GERHND in its own.
#![allow(unsafe_code, reason = "a language binding")]

use std::ffi::c_int;

unsafe extern "C" {
    /// Defined by the binding itself.
    fn gks_log_error(error: *const c_int, function: *const c_int, file: *const c_int);
}

/// ERROR LOGGING: writes the error to the error file.
///
/// # Safety
///
/// The arguments must point to INTEGERs: error number, function identifier, error file.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gerlog_(error: *const c_int, function: *const c_int, file: *const c_int) {
    // SAFETY: the arguments are passed on as they came.
    unsafe { gks_log_error(error, function, file) }
}
