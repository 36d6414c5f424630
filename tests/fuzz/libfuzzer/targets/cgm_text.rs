//! A CGM in clear text.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| gks_fuzz::attempt(gks_fuzz::metafiles::cgm_text, input));
