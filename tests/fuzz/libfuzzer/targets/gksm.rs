//! A metafile of GKS.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| gks_fuzz::attempt(gks_fuzz::metafiles::gksm, input));
