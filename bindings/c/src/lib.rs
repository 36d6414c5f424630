//! The C binding of GKS (ISO/IEC 8651-4:1991) and, with the Fortran binding in it, the library `libgks`.
//!
//! Each function converts its arguments, runs one method of the kernel that the bindings share, and converts
//! the results. An error of a function that is no inquiry goes to the error handler of the program; an inquiry
//! returns it in its error indicator.
//!
//! # Contract
//!
//! What the C language asks of a caller is asked here too, of every function: a pointer is null or points to
//! as many values of its type as the function reads or sets, for the time of the call; strings end with a zero
//! byte; no other thread changes the memory meanwhile. A null pointer to a result has that result left out; a
//! null pointer to points or to text is an empty list or text; any other null pointer is error 2200. All
//! `unsafe` code of this crate rests on this contract alone.
#![allow(unsafe_code, reason = "a language binding")]

mod argument;
mod attributes;
mod control;
mod error;
mod escape;
mod frame_buffer;
mod hlu;
mod input;
mod inquiry;
mod metafile;
mod output;
mod segment;
mod store;
mod transformation;
mod types;

// The Fortran binding is part of the library: its functions are exported by their own names.
use gks_fortran as _;
use gks_gerhnd as _;
use gks_gerlog as _;
// What a program may replace is in crates of its own.
use gks_gerr_hand as _;
use gks_gerr_log as _;
