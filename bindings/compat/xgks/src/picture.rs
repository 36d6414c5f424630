//! Pictures of metafile workstations: saving frames and setting sizes, by private functions of XGKS.

use crate::table::{Entry, workstation_at, workstation_of};
use std::ffi::{CStr, c_char, c_int, c_void};

/// The result of a function that has done what it should.
const DONE: c_int = 0;
/// The result of a function that could not.
const FAILED: c_int = 1;

/// Two numbers, handed over by value.
#[repr(C)]
#[derive(Copy, Clone, Debug)]
pub(crate) struct Pair {
    pub(crate) x: f32,
    pub(crate) y: f32,
}

fn save(metafile: *const c_void, file: *const c_char, background: bool) -> c_int {
    let Some(id) = workstation_of(metafile).filter(|_| !file.is_null()) else { return FAILED };
    // SAFETY: the contract of the crate.
    let name = gks_instance::from_utf8_or_latin1(unsafe { CStr::from_ptr(file) }.to_bytes());
    match gks_instance::with(|instance| instance.save_frame(id, name.trim(), background)) {
        Ok(true) => DONE,
        Ok(false) => FAILED,
        Err(error) => {
            eprintln!("{error}");
            FAILED
        }
    }
}

/// Saves the picture of a metafile as it is now.
#[unsafe(no_mangle)]
extern "C" fn GIFFlush(metafile: *const c_void, file: *const c_char) -> c_int {
    save(metafile, file, true)
}

/// The same with a white background that is transparent.
#[unsafe(no_mangle)]
extern "C" fn GIFFlusht0(metafile: *const c_void, file: *const c_char) -> c_int {
    save(metafile, file, false)
}

/// The same with a black background that is transparent.
#[unsafe(no_mangle)]
extern "C" fn GIFFlusht1(metafile: *const c_void, file: *const c_char) -> c_int {
    save(metafile, file, false)
}

/// Sets the size in pixels of the picture of a workstation.
#[unsafe(no_mangle)]
extern "C" fn GIFresize(workstation: *const Entry, size: Pair) -> c_int {
    let Some(id) = workstation_at(workstation) else { return FAILED };
    // Numbers that are none become 0, which is no size.
    gks_instance::with(|instance| instance.resize_picture(id, size.x as u32, size.y as u32));
    DONE
}

/// Sets the size of a page of PostScript, of which the proportions matter: the window is shown as large as the
/// page allows whatever they are.
#[unsafe(no_mangle)]
extern "C" fn PSresize(_workstation: *const Entry, _size: Pair) -> c_int {
    DONE
}

/// Sets whether windows appear at once. There are none.
#[unsafe(no_mangle)]
extern "C" fn WindowMapping(_mapped: c_int) {}

/// Handles what the window system has to say. There is none.
#[unsafe(no_mangle)]
extern "C" fn xProcessEvents() {}
