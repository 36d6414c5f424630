//! The one kernel of a process that the C and Fortran bindings share.
//!
//! The kernel lies behind a mutex. A call of a binding converts its arguments, runs one method of [`Gks`]
//! under the lock, and reports an error after the lock has been released, because an error handler of the
//! program may inquire, log and close. No panic crosses the border: one that happens all the same is reported
//! as a system error, and the process goes on.
#![allow(unsafe_code, reason = "the hook for the end of the process is a function of C")]

mod dialect;
mod error_file;
mod exit;
mod gr_colours;
mod ncar;
mod ncar_paper;
mod prompt;
mod text;
mod unit;
mod xgks;

pub use dialect::preset_dialect;
pub use error_file::{ErrorFile, STANDARD_OUTPUT};
pub use gks_workstations::dialect::Dialect;
pub use ncar::{interior_style, ncar_record_is_read};
pub use prompt::{Controlled, PromptAttributes};
pub use text::{from_latin1, from_utf8_or_latin1};
pub use unit::file_of_unit;
pub use xgks::KeptPicture;

use gks::{Error, Function, Gks};
use gks_workstations::environment::Environment;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The kernel with what belongs to bindings alone.
pub struct Instance {
    /// The kernel.
    pub gks: Gks,
    /// Where errors are logged.
    pub error_file: ErrorFile,
    /// The dialect of the process.
    pub dialect: Dialect,
    /// The name of the next metafile, where a dialect has programs give it before OPEN WORKSTATION.
    pub metafile_name: Option<String>,
    /// What programs of NCAR Graphics have said about paper.
    paper: ncar_paper::Paper,
    /// What the environment of the process says about workstations.
    environment: Environment,
    /// The pictures that workstations keep to be written later, by workstation identifier.
    pictures: BTreeMap<i32, KeptPicture>,
    /// Error state ON: an error handler is running.
    handling: bool,
    /// The error that is being handled, with its detail, for the log.
    current: Option<Error>,
}

impl Instance {
    /// OPEN GKS with an error file. What is still open when the process ends is completed then.
    ///
    /// Error: 1.
    pub fn open_gks(&mut self, error_file: ErrorFile) -> gks::Result<()> {
        self.gks.open_gks()?;
        self.error_file = error_file;
        exit::close_when_process_ends();
        Ok(())
    }
}

static INSTANCE: Mutex<Option<Box<Instance>>> = Mutex::new(None);

/// The error for a panic, which is our bug: the standard has no number for it, so the last of its system
/// errors stands in.
const SYSTEM_ERROR: i32 = 308;

fn lock() -> MutexGuard<'static, Option<Box<Instance>>> {
    INSTANCE.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cold]
fn create() -> Box<Instance> {
    let drivers = dialect::drivers();
    let environment = drivers.environment().clone();
    let dialect = environment.dialect().unwrap_or_else(|message| {
        eprintln!("{message}; iso is used");
        Dialect::Iso
    });
    let mut gks = Gks::with_defaults(Box::new(drivers), dialect::defaults(dialect));
    gks.on_message(Box::new(|workstation, text| {
        eprintln!("GKS message on workstation {workstation}: {text}");
    }));
    Box::new(Instance {
        gks,
        error_file: ErrorFile::Stderr,
        dialect,
        metafile_name: None,
        paper: ncar_paper::Paper::default(),
        environment,
        pictures: BTreeMap::new(),
        handling: false,
        current: None,
    })
}

/// The error of a function that may not be called in the operating state. For bindings that find an argument
/// wrong before the kernel sees it.
#[inline]
pub fn check_state(gks: &Gks, function: Function) -> gks::Result<()> {
    if function.states().contains(gks.inquire_operating_state_value()) {
        Ok(())
    } else {
        Err(Error::new(function.state_error(), function))
    }
}

/// Runs `f` with the instance locked. For inquiries, which report nothing.
#[inline]
pub fn with<R>(f: impl FnOnce(&mut Instance) -> R) -> R {
    let mut guard = lock();
    f(guard.get_or_insert_with(create))
}

/// Runs an inquiry; a panic becomes a system error.
#[inline]
pub fn inquire<R>(function: Function, f: impl FnOnce(&mut Gks) -> gks::Result<R>) -> Result<R, i32> {
    match catch_unwind(AssertUnwindSafe(|| with(|instance| f(&mut instance.gks)))) {
        Ok(result) => result.map_err(|e| e.number),
        Err(_) => Err(Error::new(SYSTEM_ERROR, function).number),
    }
}

/// Runs a function that is not an inquiry. An error is handed to `report` with the lock released and the
/// error state ON; during that time other such functions have no effect.
#[inline]
pub fn call<R>(
    function: Function,
    report: impl FnOnce(&Error, &ErrorFile),
    f: impl FnOnce(&mut Gks) -> gks::Result<R>,
) -> Option<R> {
    call_instance(function, report, |instance| f(&mut instance.gks))
}

/// [`call`] for functions that need more than the kernel.
pub fn call_instance<R>(
    function: Function,
    report: impl FnOnce(&Error, &ErrorFile),
    f: impl FnOnce(&mut Instance) -> gks::Result<R>,
) -> Option<R> {
    let run = || with(|instance| if instance.handling { Ok(None) } else { f(instance).map(Some) });
    let result = catch_unwind(AssertUnwindSafe(run))
        .unwrap_or_else(|_| Err(Error::new(SYSTEM_ERROR, function).because("internal error")));
    match result {
        Ok(value) => value,
        Err(error) => {
            handle(&error, report);
            None
        }
    }
}

#[cold]
fn handle(error: &Error, report: impl FnOnce(&Error, &ErrorFile)) {
    let file = with(|instance| {
        instance.handling = true;
        instance.current = Some(error.clone());
        instance.error_file.clone()
    });
    // A handler written in another language may not unwind into this one either.
    let _ = catch_unwind(AssertUnwindSafe(|| report(error, &file)));
    with(|instance| {
        instance.handling = false;
        instance.current = None;
    });
}

/// ERROR LOGGING: writes an error to an error file, with its detail if it is the one being handled. The
/// function is given by its identifier.
pub fn log(number: i32, function: i32, file: &ErrorFile) {
    let (detail, dialect) = with(|instance| {
        let current = instance.current.as_ref().filter(|e| e.number == number);
        (current.and_then(|e| e.detail.clone()), instance.dialect)
    });
    let text = gks::generated::error_text::text(number).unwrap_or("unknown error");
    let known = Function::ALL.into_iter().find(|f| f.id() == Some(function));
    let detail = detail.map(|d| format!(" ({d})")).unwrap_or_default();
    if dialect == Dialect::Ncar {
        return file.write(&ncar::message(number, known, &format!("{text}{detail}")));
    }
    let name = known.map_or("an unknown function", Function::name);
    file.write(&format!("GKS ERROR {number} IN {name}: {text}{detail}\n"));
}

/// EMERGENCY CLOSE GKS: completes and closes whatever is open. It reports nothing, and is allowed while an error is
/// being handled, too.
pub fn emergency_close_gks() {
    let close = || {
        with(|instance| {
            instance.write_pictures();
            instance.gks.emergency_close_gks();
        });
    };
    let _ = catch_unwind(AssertUnwindSafe(close));
}

/// Completes whatever is open when the process ends without CLOSE GKS; does nothing if a call is under way.
pub fn close_at_exit() {
    if let Ok(mut guard) = INSTANCE.try_lock()
        && let Some(instance) = guard.as_mut()
    {
        let _ = catch_unwind(AssertUnwindSafe(|| {
            instance.write_pictures();
            instance.gks.emergency_close_gks();
        }));
    }
}
