//! The default error logging function of the C binding, `gerr_log`, alone in this crate for the same reason as
//! `gerr_hand` in its own.
#![allow(unsafe_code, reason = "a language binding")]

use std::ffi::{c_char, c_int};

unsafe extern "C" {
    /// Defined by the binding itself.
    fn gks_log_c_error(err_num: c_int, func_num: c_int, err_file: *const c_char);
}

/// ERROR LOGGING: writes the error to the error file.
///
/// # Safety
///
/// `err_file` must be null or point to a string that ends with a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gerr_log(err_num: c_int, func_num: c_int, err_file: *const c_char) {
    // SAFETY: the arguments are passed on as they came.
    unsafe { gks_log_c_error(err_num, func_num, err_file) }
}
