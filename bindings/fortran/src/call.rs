//! Calls of the kernel, and the way of their errors to the program.

use gks::{Error, Function, Gks};
use gks_instance::{ErrorFile, Instance};
use std::ffi::c_int;

unsafe extern "C" {
    /// The error handling procedure: the program's own, or the one of this library.
    fn gerhnd_(error: *const c_int, function: *const c_int, file: *const c_int);
}

/// The unit in the place of an error file that has a name and no unit.
pub(crate) const NAMED_FILE: c_int = -1;

/// The identifier in the place of that of a function that has none.
const NO_FUNCTION: c_int = -1;

/// Hands an error to the error handling procedure.
pub(crate) fn report(error: &Error, file: &ErrorFile) {
    let function = error.function.id().unwrap_or(NO_FUNCTION);
    let unit = file.unit().unwrap_or(NAMED_FILE);
    // SAFETY: GERHND takes three INTEGERs.
    unsafe { gerhnd_(&error.number, &function, &unit) }
}

/// Runs a function of the kernel that is not an inquiry.
///
/// Operating states are checked before arguments, which the binding may find wrong before the kernel sees them.
#[inline]
pub(crate) fn call<R>(function: Function, f: impl FnOnce(&mut Gks) -> gks::Result<R>) -> Option<R> {
    gks_instance::call(function, report, |gks| {
        check_state(gks, function)?;
        f(gks)
    })
}

/// [`call`] for functions that need more than the kernel, and check the operating state themselves.
pub(crate) fn call_instance(function: Function, f: impl FnOnce(&mut Instance) -> gks::Result<()>) {
    gks_instance::call_instance(function, report, f);
}

/// The error of a function that may not be called in the operating state.
#[inline]
pub(crate) fn check_state(gks: &Gks, function: Function) -> gks::Result<()> {
    if function.states().contains(gks.inquire_operating_state_value()) {
        Ok(())
    } else {
        Err(Error::new(function.state_error(), function))
    }
}

/// Defines subroutines that are not inquiries. In the call, `F` is the function.
macro_rules! subroutines {
    ($($name:ident($($argument:ident: $type:ty),* $(,)?) $function:ident => $call:expr;)+) => { $(
        #[unsafe(no_mangle)]
        extern "C" fn $name($($argument: $type),*) {
            const F: gks::Function = gks::Function::$function;
            $crate::call::call(F, $call);
        }
    )+ };
}
pub(crate) use subroutines;
