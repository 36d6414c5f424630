//! Any sequence of calls of the Fortran binding, with any arguments.

use crate::arguments::Arguments;
use crate::generated::{SUBROUTINES, gacwk_, geclks_, gopks_, gopwk_};
use std::ffi::c_int;
use std::sync::{Mutex, Once};

// The subroutines come with the binding.
use gks_fortran as _;

/// The most calls of one run: later ones would only make runs longer.
const CALLS: usize = 200;

/// Workstation types to begin with: pixels in memory, pixels with indices, nothing, segment storage.
const KINDS: [c_int; 4] = [120, 121, 900, 1];

/// ERROR HANDLING that does nothing: errors are what this is about.
///
/// # Safety
///
/// Nothing is read.
#[unsafe(no_mangle)]
unsafe extern "C" fn gerhnd_(_: *const c_int, _: *const c_int, _: *const c_int) {}

/// Makes the calls that `input` says, from OPEN GKS to EMERGENCY CLOSE GKS.
///
/// Files go to a directory of its own, display surfaces are small. With `GKS_FUZZ_TRACE` in the environment the
/// names of the subroutines are printed before they are called.
pub fn run(input: &[u8]) {
    static PREPARED: Once = Once::new();
    PREPARED.call_once(|| {
        let place = std::env::temp_dir().join(format!("gks-fuzz-{}", std::process::id()));
        std::fs::create_dir_all(&place).expect("a directory to work in");
        std::env::set_current_dir(&place).expect("a directory to work in");
        // SAFETY: nothing else runs yet.
        unsafe { std::env::set_var("GKS_OPTIONS", "size=64x64") };
    });
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _turn = ONE_AT_A_TIME.lock();
    let trace = std::env::var_os("GKS_FUZZ_TRACE").is_some();
    let mut arguments = Arguments::new(input);
    let kinds = arguments.choose(16);
    // SAFETY: INTEGERs as the table lists them.
    unsafe {
        gopks_(&mut 0, &mut 0);
        for mut id in 1..=2_i32 {
            let mut kind = KINDS[kinds >> (2 * (id - 1)) & 3];
            gopwk_(&mut id, &mut 0, &mut kind);
            gacwk_(&mut id);
        }
    }
    for _ in 0..CALLS {
        if arguments.is_exhausted() {
            break;
        }
        let chosen = arguments.choose(SUBROUTINES.len());
        if trace {
            eprintln!("{}", SUBROUTINES[chosen].name);
        }
        (SUBROUTINES[chosen].call)(&mut arguments);
    }
    // SAFETY: no arguments.
    unsafe { geclks_() };
}
