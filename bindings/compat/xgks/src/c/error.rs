//! Error handling: `gerrorhand`, which a program may replace, and `gerrorlog`.

use super::function::{name, number};
use super::types::Gint;
use gks::Error;
use std::ffi::{CString, c_char, c_int, c_void};
use std::sync::atomic::{AtomicPtr, Ordering};

/// A stream of C.
pub(crate) type Gfile = c_void;

/// An error handling function: error number, function identifier, stream of OPEN GKS.
type Handler = extern "C" fn(Gint, Gint, *mut Gfile) -> Gint;

unsafe extern "C" {
    fn fputs(text: *const c_char, stream: *mut Gfile) -> c_int;
    fn fflush(stream: *mut Gfile) -> c_int;
    fn dlsym(handle: *mut c_void, symbol: *const c_char) -> *mut c_void;
}

/// The stream that the program has given to OPEN GKS.
static STREAM: AtomicPtr<Gfile> = AtomicPtr::new(std::ptr::null_mut());

/// Sets the stream that errors are logged to; the standard error output for a null pointer.
pub(crate) fn set_stream(stream: *mut Gfile) {
    STREAM.store(stream, Ordering::Relaxed);
}

/// Hands an error to the error handling function, to that of the program where it has one, as an error of the function
/// with a number, which is that of the error's own function if none is given.
#[cold]
pub(crate) fn report(error: &Error, function: Option<Gint>) {
    // SAFETY: a null handle means all that is loaded, the program first; the name ends with a zero byte.
    let address = unsafe { dlsym(std::ptr::null_mut(), c"gerrorhand".as_ptr()) };
    let handler: Handler = if address.is_null() {
        gerrorhand
    } else {
        // SAFETY: a function of this name has this type.
        unsafe { std::mem::transmute::<*mut c_void, Handler>(address) }
    };
    let stream = STREAM.load(Ordering::Relaxed);
    handler(error.number, function.unwrap_or_else(|| number(error.function)), stream);
}

/// ERROR HANDLING: logs the error.
#[unsafe(no_mangle)]
extern "C" fn gerrorhand(number: Gint, function: Gint, stream: *mut Gfile) -> Gint {
    gerrorlog(number, function, stream)
}

/// ERROR LOGGING: writes name of the function, number and text of an error to a stream, to the standard error output for a
/// null pointer. Functions are known by their numbers in XGKS.
#[unsafe(no_mangle)]
extern "C" fn gerrorlog(number: Gint, function: Gint, stream: *mut Gfile) -> Gint {
    let text = gks::generated::error_text::text(number).unwrap_or("unknown error");
    let name = name(function).map_or_else(|| "an unknown function".to_owned(), |name| format!("{name}()"));
    let line = format!("{name} {number:4} {text}\n");
    let Some(line_c) = CString::new(line.as_str()).ok().filter(|_| !stream.is_null()) else {
        eprint!("{line}");
        return 0;
    };
    // SAFETY: the stream of the program, which is open; the text ends with a zero byte.
    let _ = unsafe { (fputs(line_c.as_ptr(), stream), fflush(stream)) };
    0
}
