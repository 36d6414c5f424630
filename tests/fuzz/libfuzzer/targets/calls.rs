//! Any sequence of calls of the Fortran binding.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| gks_fuzz::attempt(gks_fuzz::calls::run, input));
