//! The state of XGKS, a variable that its tools have a copy of.
//!
//! gksm2ps is linked with parts of XGKS that look into it, and that it never calls. The linker has given it a place of this
//! size for the variable; what is in it nobody asks.

use std::cell::UnsafeCell;

/// The bytes of the state.
const SIZE: usize = 2480;

/// A variable that programs may write to.
#[repr(C)]
pub(crate) struct State(UnsafeCell<[u64; SIZE / 8]>);

// SAFETY: this library neither reads nor writes it.
unsafe impl Sync for State {}

/// The state: zeros.
#[unsafe(no_mangle)]
#[allow(non_upper_case_globals, reason = "the name that programs know")]
static xgks_state: State = State(UnsafeCell::new([0; SIZE / 8]));
