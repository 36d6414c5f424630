//! The shared libraries of this installation, one for each family of programs, and where they are.

use crate::commands::Failure;
use gks_workstations::dialect::Dialect;
use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A library with the functions of GKS under the names and in the dialect of a family of programs.
#[derive(Debug)]
pub struct Library {
    /// The dialect that it has.
    pub dialect: Dialect,
    /// Whose programs it runs.
    pub family: &'static str,
    /// The name under which programs ask for it.
    pub soname: &'static str,
    /// What the names of all versions of the library begin with.
    stem: &'static str,
    /// The name of the file where cargo cannot give it the proper one.
    pub(crate) built: &'static str,
    /// The package that it is built from.
    pub(crate) package: &'static str,
}

const fn library(
    dialect: Dialect,
    family: &'static str,
    soname: &'static str,
    stem: &'static str,
    built: &'static str,
    package: &'static str,
) -> Library {
    Library { dialect, family, soname, stem, built, package }
}

/// The libraries. Those with functions of other types under the names of the standard come last.
pub const LIBRARIES: &[Library] = &[
    library(Dialect::Iso, "the standards for C and Fortran", "libgks.so", "libgks.so", "libgks.so", "libgks"),
    library(Dialect::Ncar, "NCAR Graphics", "libNGgks.so.1", "libNGgks.so", "libNGgks.so", "gks-ncar"),
    library(Dialect::Xgks, "XGKS", "libxgks-gfortran.so.2", "libxgks", "libxgks_gfortran.so", "gks-xgks"),
    library(Dialect::Gr, "the GR framework", "libGKS.so", "libGKS.so", "libGKS.so", "gks-gr"),
];

impl Library {
    /// The library that a program means by a name.
    pub fn by_name(name: &str) -> Option<&'static Library> {
        LIBRARIES.iter().find(|library| name.starts_with(library.stem))
    }

    /// The library of a dialect.
    pub fn of(dialect: Dialect) -> Option<&'static Library> {
        LIBRARIES.iter().find(|library| library.dialect == dialect)
    }

    /// The file of the library: beside this command, or in `lib` or `lib/gks` next to its folder, where `gks install` puts it. In a checkout it is built
    /// where it is not there.
    pub fn find(&self) -> Result<PathBuf, Failure> {
        let command = env::current_exe()?;
        let folder = command.parent().ok_or("the command has no folder")?;
        let lib = folder.parent().map(|prefix| prefix.join("lib"));
        let folders = [Some(folder.to_path_buf()), lib.clone(), lib.map(|lib| lib.join("gks"))];
        let files = folders.iter().flatten().flat_map(|f| [f.join(self.soname), f.join(self.built)]);
        let files: Vec<PathBuf> = files.collect();
        let present = || files.iter().find(|file| file.is_file());
        if let Some(root) = checkout(folder).filter(|_| present().is_none()) {
            eprintln!("gks: building {}", self.soname);
            build(root, folder, self.package, false)?;
        }
        let missing = || format!("{} is not beside this command nor in lib next to its folder", self.soname);
        Ok(present().cloned().ok_or_else(missing)?)
    }

    /// A folder that holds the library under the name `name`: its own one, or one with a link.
    pub fn folder_with(&self, name: &str) -> Result<PathBuf, Failure> {
        let file = self.find()?;
        let folder = file.parent().ok_or("the library has no folder")?;
        if file.file_name().is_some_and(|found| found == name) && self.dialect != Dialect::Iso {
            // Other libraries beside it do no harm: they have names of their own.
            return Ok(folder.to_path_buf());
        }
        let links = folder.join("gks-programs");
        let writable = std::fs::create_dir_all(&links).is_ok();
        let links =
            if writable { links } else { env::temp_dir().join(format!("gks-{}", std::process::id())) };
        std::fs::create_dir_all(&links)?;
        let link = links.join(name);
        if std::fs::read_link(&link).is_ok_and(|target| target == file) {
            return Ok(links);
        }
        // Made under another name and renamed, for the case that the same is done elsewhere at the same time.
        let draft = links.join(format!(".{name}.{}", std::process::id()));
        std::os::unix::fs::symlink(&file, &draft)?;
        std::fs::rename(&draft, &link)?;
        Ok(links)
    }
}

/// The top of the checkout that a command in `target/PROFILE` belongs to.
pub(crate) fn checkout(folder: &Path) -> Option<&Path> {
    let root = folder.parent()?.parent()?;
    root.join("bindings").join("compat").is_dir().then_some(root)
}

/// Builds a package in a checkout, in the profile of this command, where it is not up to date. Without cargo
/// what is `present` is taken as it is.
pub(crate) fn build(root: &Path, folder: &Path, package: &str, present: bool) -> Result<(), Failure> {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    // Together with the command dependencies have the features that they were built with for it.
    cargo.args(["build", "--quiet", "--package", package, "--package", "gks-cli", "--manifest-path"]);
    cargo.arg(root.join("Cargo.toml"));
    if folder.ends_with("release") {
        cargo.arg("--release");
    }
    match cargo.status() {
        Ok(status) if status.success() => Ok(()),
        Err(_) if present => Ok(()),
        Ok(status) => Err(format!("building {package} failed: {status}").into()),
        Err(error) => Err(format!("{package} is not built, and cargo does not run: {error}").into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_ask_for_libraries_by_names_of_several_versions() {
        let dialect = |name| Library::by_name(name).map(|library| library.dialect);
        assert_eq!(dialect("libNGgks.so.1"), Some(Dialect::Ncar));
        assert_eq!(dialect("libxgks-gfortran.so.2"), Some(Dialect::Xgks));
        assert_eq!(dialect("libxgks.so.2"), Some(Dialect::Xgks));
        assert_eq!(dialect("libGKS.so"), Some(Dialect::Gr));
        assert_eq!(dialect("libgks.so"), Some(Dialect::Iso));
        assert_eq!(dialect("libNGllu.so.1"), None);
    }
}
