//! Calls of what is not built yet.

use crate::call::{call, check_state};
use gks::{Error, Function, Gks};
use gks_pipeline::generated::numbers::ERROR_LEVEL_NOT_BUILT;
use std::ffi::c_int;

fn missing(gks: &Gks, function: Function) -> gks::Result<()> {
    check_state(gks, function)?;
    Err(Error::new(ERROR_LEVEL_NOT_BUILT, function))
}

/// Reports that a function is not built, or that the operating state is wrong.
pub(crate) fn refuse(function: Function) {
    call(function, |gks| missing(gks, function));
}

/// The error indicator of an inquiry that is not built.
pub(crate) fn refusal(function: Function) -> c_int {
    gks_instance::inquire(function, |gks| missing(gks, function)).err().unwrap_or(0)
}
