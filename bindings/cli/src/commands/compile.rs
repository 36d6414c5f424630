//! `gks cc` and `gks fc`: compile and link programs with the library.
//!
//! The library and the include files are found beside the command: in a checkout in the build folder and in
//! `bindings/`, in an installation (`gks install`) in `lib` and `include` next to `bin`.

use super::Failure;
use crate::libraries::build;
use std::env;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

/// The language of a program.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Language {
    /// C, with the header `gks.h`.
    C,
    /// Fortran, with the include files `gks.inc` and `gkspar.inc`.
    Fortran,
}

/// Where the library and the include files are.
struct Places {
    library: PathBuf,
    include: [PathBuf; 2],
}

/// Runs the compiler of `language` (`CC` or `FC`, else gcc or gfortran) with `arguments` and what the library
/// needs; only compiles where the arguments say so (`-c`).
pub fn run(language: Language, arguments: &[OsString]) -> Result<ExitCode, Failure> {
    let places = find()?;
    let (variable, usual) = match language {
        Language::C => ("CC", "gcc"),
        Language::Fortran => ("FC", "gfortran"),
    };
    let compiler = env::var_os(variable).filter(|c| !c.is_empty()).unwrap_or_else(|| usual.into());
    let mut command = Command::new(&compiler);
    for folder in &places.include {
        command.arg("-I").arg(folder);
    }
    command.args(arguments);
    if !arguments.iter().any(|a| ["-c", "-S", "-E", "-fsyntax-only"].iter().any(|only| a == only)) {
        let mut rpath = OsString::from("-Wl,-rpath,");
        rpath.push(&places.library);
        command.arg("-L").arg(&places.library).arg("-lgks").arg(rpath).arg("-lm");
    }
    let status = command.status().map_err(|e| format!("{}: {e}", compiler.display()))?;
    Ok(status.code().and_then(|c| u8::try_from(c).ok()).map_or(ExitCode::FAILURE, ExitCode::from))
}

fn find() -> Result<Places, Failure> {
    let command = env::current_exe()?;
    let folder = command.parent().ok_or("the command has no folder")?;
    let prefix = folder.parent().ok_or("the command has no folder above its own")?;
    let installed = prefix.join("include");
    if installed.join("gks.h").is_file() {
        return Ok(Places { library: prefix.join("lib"), include: [installed.clone(), installed] });
    }
    // In a checkout the command lies in target/PROFILE.
    let root = prefix.parent().ok_or("neither an installation nor a checkout")?;
    let include = ["c", "fortran"].map(|binding| root.join("bindings").join(binding).join("include"));
    if !include[0].join("gks.h").is_file() {
        return Err("gks.h is neither in an installation nor in a checkout beside this command".into());
    }
    build(root, folder, "libgks", folder.join("libgks.so").is_file())?;
    Ok(Places { library: folder.to_path_buf(), include })
}
