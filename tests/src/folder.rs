//! Folders that tests write to.

use std::fs;
use std::path::{Path, PathBuf};

/// An empty folder below `parent`, which is removed with its content at the end of the test that made it.
#[derive(Debug)]
pub struct Folder(PathBuf);

impl Folder {
    /// Makes or empties the folder.
    ///
    /// # Panics
    /// Where it cannot be written.
    pub fn new(parent: &str, name: &str) -> Folder {
        let path = Path::new(parent).join(name);
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        Folder(path)
    }

    /// The name of a file in the folder.
    pub fn file(&self, name: &str) -> String {
        self.0.join(name).to_string_lossy().into_owned()
    }

    /// The names of the files in the folder, also of hidden ones, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).into_iter().flatten().flatten();
        let mut names: Vec<String> =
            entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
