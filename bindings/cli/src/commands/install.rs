//! `gks install`: puts what users of the library need into a folder, out of a checkout.
//!
//! | folder | what is in it |
//! |---|---|
//! | `bin` | this command |
//! | `lib` | `libgks.so`, `libgks.a`, and in `pkgconfig` what pkg-config reads |
//! | `lib/gks` | the libraries for programs of other GKS, by the names under which these ask for them |
//! | `include` | the header for C, the include files for Fortran |
//! | `include/xgks`, `include/gr` | the headers of XGKS and of GR |
//!
//! The libraries of other names lie apart so that they stand in for the original ones only where they are asked to. The
//! folder may be moved.

use super::Failure;
use crate::libraries::{LIBRARIES, build, checkout};
use gks_workstations::dialect::Dialect;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What pkg-config reads, without the version.
const DESCRIPTION: &str = include_str!("../../../c/gks.pc.in");

/// Headers and include files: where they lie below `bindings`, and below the folder.
const INCLUDED: [(&str, &str); 8] = [
    ("c/include/gks.h", "include/gks.h"),
    ("c/include/gks_extra.h", "include/gks_extra.h"),
    ("fortran/include/gks.inc", "include/gks.inc"),
    ("fortran/include/gkspar.inc", "include/gkspar.inc"),
    ("fortran/include/GKS_PAR", "include/GKS_PAR"),
    ("fortran/include/ENUM.INC", "include/ENUM.INC"),
    ("compat/xgks/include/xgks.h", "include/xgks/xgks.h"),
    ("compat/gr/include/gks.h", "include/gr/gks.h"),
];

/// Installs below a folder, which is made if it is not there, and prints what is put where.
pub fn run(prefix: &Path) -> Result<ExitCode, Failure> {
    let command = env::current_exe()?;
    let folder = command.parent().ok_or("the command has no folder")?;
    let root = checkout(folder).ok_or("this command lies in no checkout, from which it could install")?;
    let put = |from: PathBuf, to: &str| place(&prefix.join(to), |draft| fs::copy(from, draft).map(|_| ()));
    for library in LIBRARIES {
        build(root, folder, library.package, false)?;
        let apart = if library.dialect == Dialect::Iso { "lib" } else { "lib/gks" };
        put(folder.join(library.built), &format!("{apart}/{}", library.soname))?;
    }
    put(folder.join("libgks.a"), "lib/libgks.a")?;
    for (from, to) in INCLUDED {
        put(root.join("bindings").join(from), to)?;
    }
    let description = DESCRIPTION.replace("@VERSION@", env!("CARGO_PKG_VERSION"));
    place(&prefix.join("lib/pkgconfig/gks.pc"), |draft| fs::write(draft, description))?;
    put(command.clone(), "bin/gks")?;
    Ok(ExitCode::SUCCESS)
}

/// Makes a file under another name and renames it, so that what is there may be in use.
fn place(file: &Path, make: impl FnOnce(&Path) -> std::io::Result<()>) -> Result<(), Failure> {
    let said = |error: std::io::Error| format!("{}: {error}", file.display());
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder).map_err(said)?;
    }
    let mut draft = file.as_os_str().to_owned();
    draft.push(".new");
    let draft = Path::new(&draft);
    make(draft).and_then(|()| fs::rename(draft, file)).map_err(said)?;
    println!("{}", file.display());
    Ok(())
}
