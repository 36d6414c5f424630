//! A CGM in binary.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| gks_fuzz::attempt(gks_fuzz::metafiles::cgm_binary, input));
