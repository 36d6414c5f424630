//! What the dynamic linker would load for a program, and where it looks for it.

use crate::binary::Binary;
use crate::libraries::Library;
use std::collections::{BTreeMap, VecDeque};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};

/// A program with the libraries that it needs, directly or not.
#[derive(Debug)]
pub struct Loading {
    /// The program.
    pub program: Binary,
    /// The libraries that were found, by their names, with what they say; none for one that cannot be read.
    pub libraries: BTreeMap<String, Option<(PathBuf, Binary)>>,
}

impl Loading {
    /// The libraries of a program, nearest first as the dynamic linker takes them.
    pub fn of(path: &Path, program: Binary) -> Loading {
        let mut libraries = BTreeMap::new();
        let usual = usual_folders();
        let mut queue: VecDeque<(String, Vec<PathBuf>)> = wanted(path, &program);
        while let Some((name, own)) = queue.pop_front() {
            if libraries.contains_key(&name) {
                continue;
            }
            let mut files = own.iter().chain(&usual).map(|folder| folder.join(&name));
            let found = files.find_map(|file| Binary::read(&file).ok().map(|binary| (file, binary)));
            if let Some((file, binary)) = &found {
                queue.extend(wanted(file, binary));
            }
            libraries.insert(name, found);
        }
        Loading { program, libraries }
    }

    /// The GKS that the program asks for: our library, and the name by which the program means it.
    pub fn gks(&self) -> Option<(&'static Library, &str)> {
        let direct = self.program.needed.iter().chain(self.libraries.keys());
        direct.into_iter().find_map(|name| Library::by_name(name).map(|library| (library, name.as_str())))
    }

    /// Whether the program or one of its libraries has `name` looked for in folders of its own before those of
    /// the environment.
    pub fn insists(&self, name: &str) -> bool {
        let libraries = self.libraries.values().flatten().map(|(_, binary)| binary);
        let mut all = libraries.chain([&self.program]);
        all.any(|binary| !binary.rpath.is_empty() && binary.needed.iter().any(|needed| needed == name))
    }
}

/// The names that a file needs with the folders in which it has them looked for.
fn wanted(path: &Path, binary: &Binary) -> VecDeque<(String, Vec<PathBuf>)> {
    let origin = fs::canonicalize(path).ok().and_then(|file| file.parent().map(Path::to_path_buf));
    let origin = origin.unwrap_or_default().display().to_string();
    let resolved =
        |folder: &String| PathBuf::from(folder.replace("${ORIGIN}", &origin).replace("$ORIGIN", &origin));
    let folders: Vec<PathBuf> = binary.rpath.iter().chain(&binary.runpath).map(resolved).collect();
    binary.needed.iter().map(|name| (name.clone(), folders.clone())).collect()
}

/// The folders of `LD_LIBRARY_PATH`, those of the configuration of the dynamic linker, and the standard ones.
fn usual_folders() -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> =
        env::var_os("LD_LIBRARY_PATH").map(|path| env::split_paths(&path).collect()).unwrap_or_default();
    let entries = fs::read_dir("/etc/ld.so.conf.d").into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    files.sort();
    for file in std::iter::once(PathBuf::from("/etc/ld.so.conf")).chain(files) {
        let text = fs::read_to_string(file).unwrap_or_default();
        folders.extend(text.lines().map(str::trim).filter(|line| line.starts_with('/')).map(PathBuf::from));
    }
    folders.extend(["/lib64", "/usr/lib64", "/lib", "/usr/lib"].map(PathBuf::from));
    folders
}

/// The file of a program: its path, or the first of its name in `PATH`.
pub fn which(program: &Path) -> Option<PathBuf> {
    if program.components().count() > 1 {
        return program.is_file().then(|| program.to_path_buf());
    }
    let path = env::var_os("PATH")?;
    env::split_paths(&path).map(|folder| folder.join(program)).find(|file| file.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::binary::Kind;

    #[test]
    fn libraries_of_libraries_are_found() {
        let this = env::current_exe().expect("the test has a file");
        let loading = Loading::of(&this, Binary::read(&this).expect("it can be read"));
        let libc = loading.libraries.iter().find(|(name, _)| name.starts_with("libc.so"));
        let (_, binary) = libc.and_then(|(_, found)| found.as_ref()).expect("the library of C is there");
        // The library of C can be run too, to say its version.
        assert!(matches!(binary.kind, Kind::Library | Kind::Dynamic));
        assert!(binary.offered.contains("write"));
        assert!(loading.gks().is_none());
    }
}
