//! Error handling: the handler that a program may replace, and logging.

use crate::argument::{In, Out};
use crate::types::Gint;
use gks::{Error, Function};
use gks_instance::{ErrorFile, STANDARD_OUTPUT};
use std::ffi::{CString, c_char, c_int, c_void};
use std::sync::{Mutex, PoisonError};

/// An error handling function of a program: error number, function identifier, name of the error file, which
/// is null for the standard error output.
type ErrorHandler = unsafe extern "C" fn(Gint, Gint, In<c_char>);

unsafe extern "C" {
    /// The default handler, or a function of that name of the program.
    fn gerr_hand(err_num: Gint, func_num: Gint, err_file: In<c_char>);

    /// Writes out what is buffered for a stream, for all of them at a null pointer.
    fn fflush(stream: *mut c_void) -> c_int;
}

/// The handler that the program has set; the default one where there is none.
static HANDLER: Mutex<Option<ErrorHandler>> = Mutex::new(None);

/// The function identifier of functions that have none.
const NO_FUNCTION: Gint = -1;

fn exchange(handler: Option<ErrorHandler>) -> ErrorHandler {
    let mut current = HANDLER.lock().unwrap_or_else(PoisonError::into_inner);
    std::mem::replace(&mut *current, handler).unwrap_or(gerr_hand)
}

/// Hands an error to the error handler of the program.
#[cold]
pub(crate) fn report(error: &Error, file: &ErrorFile) {
    let handler = HANDLER.lock().unwrap_or_else(PoisonError::into_inner).unwrap_or(gerr_hand);
    let name = match file {
        ErrorFile::Stderr => None,
        ErrorFile::Stdout => CString::new(STANDARD_OUTPUT).ok(),
        ErrorFile::Path(path) => CString::new(path.as_str()).ok(),
    };
    let name = In::of(name.as_deref());
    // SAFETY: the program gave a function of this type; the name lives until it returns.
    unsafe { handler(error.number, error.function.id().unwrap_or(NO_FUNCTION), name) }
}

/// What `gerr_log` does: writes an error to an error file, after what the program has written itself.
#[unsafe(no_mangle)]
extern "C" fn gks_log_c_error(err_num: Gint, func_num: Gint, err_file: In<c_char>) {
    // SAFETY: a null pointer is allowed. If a stream cannot be written, the program finds out by itself.
    let _ = unsafe { fflush(std::ptr::null_mut()) };
    gks_instance::log(err_num, func_num, &ErrorFile::from_name(&err_file.text()));
}

/// SET ERROR HANDLER: has a function of the program called for errors, or, for a null pointer, the default
/// one again. The former handler is given back.
#[unsafe(no_mangle)]
extern "C" fn gset_err_hand(new_err_hand: Option<ErrorHandler>, old_err_hand: Out<ErrorHandler>) {
    old_err_hand.set(exchange(new_err_hand));
}

/// EMERGENCY CLOSE GKS.
#[unsafe(no_mangle)]
extern "C" fn gemergency_close_gks() {
    // An error handler may call it too, for which reason it runs as an inquiry does.
    let _ = gks_instance::inquire(Function::EmergencyCloseGks, |gks| {
        gks.emergency_close_gks();
        Ok(())
    });
}
