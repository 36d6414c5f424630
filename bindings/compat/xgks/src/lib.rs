//! XGKS: the library that programs built against XGKS 2.6 load.
//!
//! It has the Fortran binding of this project, the binding to C of the draft of 1988, which XGKS has, its
//! escapes, and those of its private functions that programs call. Everything runs on the kernel that the
//! other bindings share, in the dialect `xgks`: workstation types, connections and pictures are those of
//! `gks-instance` and `gks-workstations`.
//!
//! # Contract
//!
//! What the languages ask of a caller is asked here too, of every function: a pointer is null or points to as
//! many values of its type as the function reads or sets, for the time of the call; strings end with a zero
//! byte; no other thread changes the memory meanwhile. All `unsafe` code of this crate rests on this alone.
#![allow(unsafe_code, reason = "a language binding")]
#![allow(clippy::too_many_arguments, reason = "the functions have as many as they have")]

mod c;
mod escape;
mod memory;
mod picture;
mod state;
mod table;
mod text_vector;

// The Fortran binding is part of the library: its functions are exported by their own names.
use gks_fortran as _;
use gks_gerhnd as _;
use gks_gerlog as _;

use gks_instance::{Dialect, preset_dialect};

/// Runs when the library is loaded, before any of its functions can be called.
#[used]
#[cfg_attr(target_os = "linux", unsafe(link_section = ".init_array"))]
#[cfg_attr(target_os = "macos", unsafe(link_section = "__DATA,__mod_init_func"))]
static PRESET: extern "C" fn() = preset;

extern "C" fn preset() {
    preset_dialect(Dialect::Xgks);
}
