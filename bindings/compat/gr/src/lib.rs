//! The GKS of the GR framework: the library that programs built against its `libGKS.so` load.
//!
//! It has the functions `gks_*` with double precision, the C names of the draft of 1988 ([`classic`]), and the Fortran
//! binding of this project. Everything
//! runs on the kernel that the other bindings share, in the dialect `gr`: the workstation types are those of
//! GR. What GR has beyond the standard is done where there is something to do it with ([`extension`]);
//! the rest is remembered, so that inquiries give it back, or has no effect ([`absent`], [`private`]).
//!
//! # Contract
//!
//! What the C language asks of a caller is asked here too, of every function: a pointer is null or points to
//! as many values of its type as the function reads or sets, for the time of the call; strings end with a zero
//! byte; no other thread changes the memory meanwhile. All `unsafe` code of this crate rests on this alone.
#![allow(unsafe_code, reason = "a language binding")]
#![allow(non_snake_case, reason = "the name of the library")]
#![allow(clippy::too_many_arguments, reason = "the functions have as many as they have")]

mod absent;
mod argument;
mod attribute;
mod classic;
mod control;
mod extension;
mod gdp;
mod image;
mod input;
mod inquiry;
mod output;
mod path;
mod private;
mod resample;
mod slant;
mod transformation;

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
    preset_dialect(Dialect::Gr);
}
