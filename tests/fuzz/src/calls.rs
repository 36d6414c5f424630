//! Any sequence of calls of the Fortran binding, with any arguments.

use crate::arguments::Arguments;
use crate::generated::{SUBROUTINES, gacwk_, geclks_, gopks_, gopwk_};
use gks_pipeline::generated::numbers::workstation_type as own;
use std::ffi::c_int;
use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, Once, PoisonError};

// The subroutines come with the binding.
use gks_fortran as _;

/// The most calls of one run: later ones would only make runs longer.
const CALLS: usize = 200;

/// The workstations that a run begins with, as many of them as it says: identifier, connection, type, and whether it
/// can be active.
const BEGINNING: [(c_int, c_int, c_int, bool); 6] = [
    (1, 0, own::FRAMEBUFFER, true),
    (2, 0, own::SCRIPTED, true),
    (3, 0, own::WISS, true),
    (4, 4, own::GKSM, true),
    (5, METAFILE, own::MI, false),
    (6, 0, own::FRAMEBUFFER8, true),
];

/// The connection of a metafile that is there from the start.
const METAFILE: c_int = 9;

/// The script of the operator.
const SCRIPT: &str = "script";

/// Whether an error has been reported since the last call.
static REPORTED: AtomicBool = AtomicBool::new(false);

/// ERROR HANDLING that only takes notice.
///
/// # Safety
///
/// Nothing is read.
#[unsafe(no_mangle)]
unsafe extern "C" fn gerhnd_(_: *const c_int, _: *const c_int, _: *const c_int) {
    REPORTED.store(true, Ordering::Relaxed);
}

/// The names of all subroutines.
pub fn subroutines() -> impl Iterator<Item = &'static str> {
    SUBROUTINES.iter().map(|subroutine| subroutine.name)
}

/// Makes the calls that `input` says, from OPEN GKS to EMERGENCY CLOSE GKS.
pub fn run(input: &[u8]) {
    run_and_tell(input, |_, _| {});
}

/// [`run`], telling for every call the name of the subroutine and whether it has met no error.
///
/// Files go to a directory of its own, which is empty at first but for a metafile and a script; display surfaces are
/// small. With `GKS_FUZZ_TRACE` in the environment the names of the subroutines are printed before they are called.
pub fn run_and_tell(input: &[u8], mut tell: impl FnMut(&'static str, bool)) {
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _turn = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    prepare();
    let trace = std::env::var_os("GKS_FUZZ_TRACE").is_some();
    let mut arguments = Arguments::new(input);
    let opened = arguments.choose(1 << BEGINNING.len());
    let activated = arguments.choose(1 << BEGINNING.len());
    fs::write(SCRIPT, arguments.script()).expect("a file can be written");
    // SAFETY: INTEGERs as the table lists them.
    unsafe {
        gopks_(&mut 0, &mut 0);
        for (i, (mut id, mut connection, mut kind, can_be_active)) in BEGINNING.into_iter().enumerate() {
            if opened >> i & 1 == 0 {
                gopwk_(&mut id, &mut connection, &mut kind);
                if can_be_active && activated >> i & 1 == 0 {
                    gacwk_(&mut id);
                }
            }
        }
    }
    for _ in 0..CALLS {
        if arguments.is_exhausted() {
            break;
        }
        let chosen = &SUBROUTINES[arguments.choose(SUBROUTINES.len())];
        if trace {
            eprintln!("{}", chosen.name);
        }
        REPORTED.store(false, Ordering::Relaxed);
        (chosen.call)(&mut arguments);
        tell(chosen.name, !REPORTED.load(Ordering::Relaxed) && arguments.last_indicator() == 0);
    }
    // SAFETY: no arguments.
    unsafe { geclks_() };
}

/// Goes to an empty directory with a metafile to read.
fn prepare() {
    static ONCE: Once = Once::new();
    let metafile = format!("gks.{METAFILE}.gksm");
    ONCE.call_once(|| {
        let place = std::env::temp_dir().join(format!("gks-fuzz-{}", std::process::id()));
        fs::create_dir_all(&place).expect("a directory to work in");
        std::env::set_current_dir(&place).expect("a directory to work in");
        // SAFETY: nothing else runs yet.
        unsafe {
            std::env::set_var("GKS_OPTIONS", "size=64x64");
            std::env::set_var("GKS_SCRIPT", SCRIPT);
        }
    });
    for file in fs::read_dir(".").expect("the directory is there").flatten() {
        // One that cannot be removed is overwritten.
        let _ = fs::remove_file(file.path());
    }
    let bytes = include_bytes!("../corpus/gksm/formatted.gksm");
    fs::write(metafile, bytes).expect("a file can be written");
}
