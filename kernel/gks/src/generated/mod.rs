//! Copied out of the tables in `spec/gks`.
//!
//! Written by `gks-spec generate`; do not edit.

#[rustfmt::skip]
pub mod error_text;

#[rustfmt::skip]
pub mod function;
