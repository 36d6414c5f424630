//! Units of Fortran programs.

use std::ffi::{c_char, c_int, c_void};

#[cfg(target_os = "linux")]
unsafe extern "C" {
    fn dlsym(handle: *mut c_void, symbol: *const c_char) -> *mut c_void;
}

/// The name of the file that a Fortran program has connected to a unit, as gfortran's own library knows it. None
/// for a unit that is not connected, and in a process without that library.
#[cfg(target_os = "linux")]
pub fn file_of_unit(unit: i32) -> Option<String> {
    // SAFETY: a null handle means all that is loaded, and the name ends with a zero byte.
    let address = unsafe { dlsym(std::ptr::null_mut(), c"_gfortran_fnum_i4".as_ptr()) };
    if address.is_null() {
        return None;
    }
    // SAFETY: gfortran's library has the function FNUM, from one INTEGER to one, under this name.
    let descriptor: extern "C" fn(*const c_int) -> c_int = unsafe { std::mem::transmute(address) };
    let number = descriptor(&unit);
    let file = std::fs::read_link(format!("/proc/self/fd/{number}")).ok()?;
    (number > 2 && file.is_file()).then(|| file.to_string_lossy().into_owned())
}

/// The name of the file of a unit, which cannot be found out here.
#[cfg(not(target_os = "linux"))]
pub fn file_of_unit(_unit: i32) -> Option<String> {
    None
}
