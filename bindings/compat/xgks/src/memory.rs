//! The allocation functions of XGKS, which its programs call for their own memory.

use std::ffi::c_void;

unsafe extern "C" {
    fn malloc(size: usize) -> *mut c_void;
    fn realloc(address: *mut c_void, size: usize) -> *mut c_void;
    fn free(address: *mut c_void);
}

/// Allocates memory; a null pointer where there is none.
#[unsafe(no_mangle)]
extern "C" fn umalloc(size: usize) -> *mut c_void {
    // SAFETY: any size may be asked for.
    unsafe { malloc(size) }
}

/// Changes the size of memory that [`umalloc`] has allocated.
#[unsafe(no_mangle)]
extern "C" fn urealloc(address: *mut c_void, size: usize) -> *mut c_void {
    // SAFETY: the contract of the crate; a null pointer is allowed.
    unsafe { realloc(address, size) }
}

/// Frees memory that [`umalloc`] has allocated.
#[unsafe(no_mangle)]
extern "C" fn ufree(address: *mut c_void) {
    // SAFETY: the contract of the crate; a null pointer is allowed.
    unsafe { free(address) }
}
