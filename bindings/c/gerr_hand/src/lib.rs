//! The default error handling function of the C binding, `gerr_hand`.
//!
//! It is alone in this crate so that it is alone in its member of the static library: a linker takes the
//! member only if the program has no `gerr_hand` of its own. In the shared library the program's own definition
//! comes first because the call goes through the dynamic symbol. A program may as well set a handler of any
//! name while it runs, by `gset_err_hand`.
#![allow(unsafe_code, reason = "a language binding")]

use std::ffi::{c_char, c_int};

unsafe extern "C" {
    fn gerr_log(err_num: c_int, func_num: c_int, err_file: *const c_char);
}

/// ERROR HANDLING: logs the error.
///
/// # Safety
///
/// `err_file` must be null or point to a string that ends with a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gerr_hand(err_num: c_int, func_num: c_int, err_file: *const c_char) {
    // SAFETY: the arguments are passed on as they came.
    unsafe { gerr_log(err_num, func_num, err_file) }
}
