//! Copied out of `spec/numbers.toml`.
//!
//! Written by `gks-spec generate`; do not edit.

#[rustfmt::skip]
pub mod numbers;
