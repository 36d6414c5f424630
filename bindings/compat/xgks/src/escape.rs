//! The escapes of XGKS that are functions of their own, in C and in Fortran.

use crate::picture::Pair;
use gks_instance::from_latin1;
use std::ffi::{c_char, c_int, c_ulong, c_void};

/// The result of a function that has done what it should.
const DONE: c_int = 0;

/// What the library calls itself.
const VERSION: &str = concat!("gks ", env!("CARGO_PKG_VERSION"), " (XGKS 2.6)");

/// SET DEVICE COORDINATE SIZE: the units in which viewports of a workstation are given. They are metres here whatever is set;
/// a workstation that shows its window as large as it can, as all do at first, looks the same.
#[unsafe(no_mangle)]
extern "C" fn gescsetdcsize(_ws_id: c_int, _size: Pair) -> c_int {
    DONE
}

/// SET DEVICE COORDINATE SIZE, for Fortran.
#[unsafe(no_mangle)]
extern "C" fn gessdc_(_ws_id: *const c_int, _x: *const f32, _y: *const f32) {}

/// Sets which bits of the colour index of a window are drawn. There are no windows.
#[unsafe(no_mangle)]
extern "C" fn gescsetcolourmask(_ws_id: c_int, _mask: c_ulong) -> c_int {
    DONE
}

/// The same for Fortran.
#[unsafe(no_mangle)]
extern "C" fn gesscm_(_ws_id: *const c_int, _mask: *const c_int) {}

/// Sets whether primitives outside of segments are kept when a window is drawn again. There are no windows.
#[unsafe(no_mangle)]
extern "C" fn gescstoreprimi(_ws_id: c_int, _store: c_int) -> c_int {
    DONE
}

/// The same for Fortran.
#[unsafe(no_mangle)]
extern "C" fn gessrp_(_ws_id: *const c_int, _store: *const c_int) {}

/// Sets what is called when a window has been drawn again. There are no windows.
#[unsafe(no_mangle)]
extern "C" fn gescredrawnotify(_ws_id: c_int, _function: *const c_void) -> c_int {
    DONE
}

/// The same for Fortran.
#[unsafe(no_mangle)]
extern "C" fn gessrn_(_ws_id: *const c_int, _function: *const c_void) {}

/// Sets whether the window system keeps what is covered. There is none.
#[unsafe(no_mangle)]
extern "C" fn gescsetbackingstore(_ws_id: c_int, _on: c_int) {}

/// The same for Fortran.
#[unsafe(no_mangle)]
extern "C" fn gessbs_(_ws_id: *const c_int, _on: *const c_int) {}

/// The same for Fortran, always on.
#[unsafe(no_mangle)]
extern "C" fn gxconfig_(_ws_id: *const c_int) {}

/// Sets the title of windows. There are none.
#[unsafe(no_mangle)]
extern "C" fn gescsetprogname(_name: *const c_char) {}

/// The same for Fortran.
#[unsafe(no_mangle)]
extern "C" fn gesspn_(_name: *const c_char, _length: usize) {}

/// The same for Fortran.
#[unsafe(no_mangle)]
extern "C" fn gxname_(_name: *const c_char, _length: usize) {}

/// Gives the display, the window and the graphics context of a workstation, which are null: there are none.
#[unsafe(no_mangle)]
extern "C" fn gescinqxattr(
    _ws_id: c_int,
    display: *mut *mut c_void,
    window: *mut c_ulong,
    gc: *mut *mut c_void,
) -> c_int {
    for address in [display, gc] {
        if !address.is_null() {
            // SAFETY: the contract of the crate.
            unsafe { address.write(std::ptr::null_mut()) }
        }
    }
    if !window.is_null() {
        // SAFETY: the contract of the crate.
        unsafe { window.write(0) }
    }
    DONE
}

/// SET CONNECTION IDENTIFIER: the connection of workstations that are opened from now on. A blank ends the name.
#[unsafe(no_mangle)]
extern "C" fn gescid_(name: *const u8, length: usize) {
    if name.is_null() || length > isize::MAX as usize {
        return;
    }
    // SAFETY: a CHARACTER string of this length.
    let name = from_latin1(unsafe { std::slice::from_raw_parts(name, length) });
    let name = name.split(' ').next().unwrap_or_default().to_owned();
    gks_instance::with(|instance| instance.metafile_name = Some(name).filter(|name| !name.is_empty()));
}

/// Gives the name and the version of the library, and their length.
#[unsafe(no_mangle)]
extern "C" fn gesfv_(text: *mut u8, length: *mut c_int, room: usize) {
    let used = VERSION.len().min(room);
    if !text.is_null() {
        for (i, byte) in VERSION.bytes().chain(std::iter::repeat(b' ')).take(room).enumerate() {
            // SAFETY: a CHARACTER string of this length.
            unsafe { text.add(i).write(byte) }
        }
    }
    if !length.is_null() {
        // SAFETY: an INTEGER.
        unsafe { length.write(used as c_int) }
    }
}
