//! What happens to pictures when a process ends without CLOSE GKS.

use crate::close_at_exit;
use std::ffi::c_int;
use std::sync::Once;

unsafe extern "C" {
    fn atexit(hook: extern "C" fn()) -> c_int;
}

extern "C" fn hook() {
    close_at_exit();
}

/// Has [`close_at_exit`] called when the process ends, by `exit` or at the end of its main program.
pub(crate) fn close_when_process_ends() {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        // SAFETY: the hook takes nothing, returns nothing and does not unwind. If there is no room for one
        // more hook, the pictures of a program that forgets CLOSE GKS stay incomplete.
        let _ = unsafe { atexit(hook) };
    });
}
