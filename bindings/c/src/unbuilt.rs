//! Calls of what is not built yet.

use crate::argument::call;
use crate::types::Gint;
use gks::{Error, Function, Gks};
use gks_pipeline::generated::numbers::ERROR_LEVEL_NOT_BUILT;

fn missing(gks: &Gks, function: Function) -> gks::Result<()> {
    gks_instance::check_state(gks, function)?;
    Err(Error::new(ERROR_LEVEL_NOT_BUILT, function))
}

/// Reports that a function is not built, or that the operating state is wrong.
pub(crate) fn refuse(function: Function) {
    call(function, |gks| missing(gks, function));
}

/// The error indicator of an inquiry that is not built.
pub(crate) fn refusal(function: Function) -> Gint {
    gks_instance::inquire(function, |gks| missing(gks, function)).err().unwrap_or(0)
}
