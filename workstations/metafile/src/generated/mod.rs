//! Copied out of the tables in `spec/cgm`.
//!
//! Written by `gks-spec generate`; do not edit.

#[rustfmt::skip]
pub mod elements;
