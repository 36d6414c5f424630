//! Copied out of the tables in `spec` and the sources.
//!
//! Written by `gks-spec generate`; do not edit.

#[rustfmt::skip]
pub mod coverage;

#[rustfmt::skip]
pub mod error_numbers;
