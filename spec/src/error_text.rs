//! Writes `kernel/gks/src/generated/error_text.rs`: the sentence for every error number.

use std::fmt::Write as _;

use crate::tables::Tables;

const HEAD: &str = "\
//! The sentences that go with the error numbers.
//!
//! Written by `gks-spec generate` from `spec/gks/errors.toml`; do not edit.

/// The sentence for an error number; `None` for a number that no standard, binding or known implementation uses.
#[must_use]
pub fn text(number: i32) -> Option<&'static str> {
    Some(match number {
";

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut out = String::from(HEAD);
    for error in &tables.errors {
        let _ = writeln!(out, "        {} => {:?},", error.number, error.text);
    }
    out += "        _ => return None,\n    })\n}\n";
    out
}
