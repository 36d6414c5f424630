//! What is fed with anything: sequences of calls, and every reader of files.
//!
//! A target is a function of bytes that must come back, whatever the bytes are. `tests/fuzz/run` lets a fuzzer
//! look for bytes from which it does not; what was found stays in `corpus/` and is tried by `cargo test`.
#![allow(unsafe_code, reason = "a program that calls a language binding")]

pub mod arguments;
pub mod calls;
#[rustfmt::skip]
mod generated;
pub mod memory;
pub mod metafiles;

/// A target: its name, which is also that of the directory of its corpus, and what it does with bytes.
pub type Target = (&'static str, fn(&[u8]));

/// Every target.
pub const TARGETS: &[Target] = &[
    ("calls", calls::run),
    ("gksm", metafiles::gksm),
    ("cgm_binary", metafiles::cgm_binary),
    ("cgm_text", metafiles::cgm_text),
    ("cgm_character", metafiles::cgm_character),
    ("ncgm", metafiles::ncgm),
];

/// Does with an input what a target does.
///
/// # Panics
/// Where more memory is held for it than [`memory::MOST`].
pub fn attempt(run: fn(&[u8]), input: &[u8]) {
    let held = memory::peak(|| run(input));
    assert!(held <= memory::MOST, "it held {} MiB", held >> 20);
}
