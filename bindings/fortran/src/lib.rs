//! The Fortran binding of GKS (ISO 8651-1), as subroutines for the calling conventions of gfortran.
//!
//! A subroutine `GXXX` is the symbol `gxxx_`. Every argument is an address: of an INTEGER (32 bits), of a REAL
//! (32 bits), of an array of them with the first index running fastest, or of the characters of a CHARACTER
//! string. The lengths of the strings, of 64 bits, follow all other arguments, in the order of the strings.
//!
//! The caller keeps the rules of Fortran: there are as many arguments as the subroutine has, of its types, and
//! arrays and strings are as long as other arguments say. That is the contract of every function of this crate,
//! and why none of them is marked `unsafe`: nothing but a Fortran program can make their arguments. One rule
//! need not be kept, because programs break it: one variable may stand for several arguments.
//!
//! Errors of subroutines that are not inquiries go to GERHND, which a program may replace; inquiries return
//! them in their error indicator and set everything else to zero.
#![allow(unsafe_code, reason = "a language binding")]
#![allow(clippy::too_many_arguments, reason = "the subroutines of the standard have as many as they have")]

use gks_gerhnd as _;
use gks_gerlog as _;

mod answer;
mod argument;
mod attributes;
mod call;
mod control;
mod data_record;
mod error_log;
mod input;
mod inquiry;
mod metafile;
mod ncar;
mod output;
mod representation;
mod segment;
mod transformation;
mod xgks;
