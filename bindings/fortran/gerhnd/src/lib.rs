//! The default error handling procedure of the Fortran binding, GERHND.
//!
//! It is alone in this crate so that it is alone in its member of the static library: a linker takes the
//! member only if the program has no GERHND of its own. In the shared library the program's own definition
//! comes first because the call goes through the dynamic symbol.
#![allow(unsafe_code, reason = "a language binding")]

use std::ffi::c_int;

unsafe extern "C" {
    fn gerlog_(error: *const c_int, function: *const c_int, file: *const c_int);
}

/// ERROR HANDLING: logs the error.
///
/// # Safety
///
/// The arguments must point to INTEGERs: error number, function identifier, error file.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gerhnd_(error: *const c_int, function: *const c_int, file: *const c_int) {
    // SAFETY: the arguments are passed on as they came.
    unsafe { gerlog_(error, function, file) }
}
