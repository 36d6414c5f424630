//! Where errors are logged.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

/// The name of the standard output as an error file.
pub const STANDARD_OUTPUT: &str = "/dev/stdout";

/// The error file of OPEN GKS. It is opened for each message and closed again, so that the program itself
/// may write to it in between.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ErrorFile {
    /// The standard error output: Fortran unit 0, or a null name in C.
    Stderr,
    /// The standard output: Fortran unit 6.
    Stdout,
    /// A file to which messages are appended.
    Path(String),
}

impl ErrorFile {
    /// The file of a Fortran logical unit: 0 and 6 are the standard streams, N is `fort.N`.
    pub fn from_unit(unit: i32) -> Self {
        match unit {
            0 => ErrorFile::Stderr,
            6 => ErrorFile::Stdout,
            n => ErrorFile::Path(format!("fort.{n}")),
        }
    }

    /// The Fortran logical unit of the file, if it is that of one.
    pub fn unit(&self) -> Option<i32> {
        match self {
            ErrorFile::Stderr => Some(0),
            ErrorFile::Stdout => Some(6),
            ErrorFile::Path(path) => path.strip_prefix("fort.").and_then(|unit| unit.parse().ok()),
        }
    }

    /// The file of a name; an empty one means the standard error output.
    pub fn from_name(name: &str) -> Self {
        match name {
            "" => ErrorFile::Stderr,
            STANDARD_OUTPUT => ErrorFile::Stdout,
            _ => ErrorFile::Path(name.to_owned()),
        }
    }

    /// Whether messages could be written: the file can be appended to, or its folder is there. Makes no file.
    pub fn is_valid(&self) -> bool {
        let ErrorFile::Path(path) = self else { return true };
        let path = Path::new(path);
        if path.exists() {
            return OpenOptions::new().append(true).open(path).is_ok();
        }
        path.parent().is_some_and(|folder| folder.as_os_str().is_empty() || folder.is_dir())
    }

    /// Appends a message. A message that cannot be written goes to the standard error output.
    pub fn write(&self, message: &str) {
        let written = match self {
            ErrorFile::Stderr => std::io::stderr().write_all(message.as_bytes()),
            ErrorFile::Stdout => {
                let mut out = std::io::stdout().lock();
                out.write_all(message.as_bytes()).and_then(|()| out.flush())
            }
            ErrorFile::Path(path) => OpenOptions::new()
                .create(true)
                .append(true)
                .open(path)
                .and_then(|mut file| file.write_all(message.as_bytes())),
        };
        if written.is_err() {
            let _ = std::io::stderr().write_all(message.as_bytes());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_and_files_stand_for_each_other() {
        for unit in [0, 6, 19] {
            assert_eq!(ErrorFile::from_unit(unit).unit(), Some(unit));
        }
        assert_eq!(ErrorFile::from_name("errors.log").unit(), None);
        assert_eq!(ErrorFile::from_name(""), ErrorFile::Stderr);
        assert_eq!(ErrorFile::from_name(STANDARD_OUTPUT), ErrorFile::Stdout);
    }

    #[test]
    fn a_file_in_no_folder_is_not_valid() {
        assert!(ErrorFile::Stderr.is_valid() && ErrorFile::from_name("errors.log").is_valid());
        let folder = std::env::temp_dir();
        assert!(!ErrorFile::from_name(&folder.to_string_lossy()).is_valid());
        assert!(ErrorFile::from_name(&folder.join("gks-errors").to_string_lossy()).is_valid());
        assert!(!ErrorFile::from_name(&folder.join("gks-none/errors").to_string_lossy()).is_valid());
    }

    #[test]
    fn messages_are_appended() {
        let path = std::env::temp_dir().join(format!("gks-error-file-{}", std::process::id()));
        let file = ErrorFile::from_name(&path.to_string_lossy());
        file.write("one\n");
        file.write("two\n");
        let text = std::fs::read_to_string(&path);
        std::fs::remove_file(&path).expect("the file is there");
        assert_eq!(text.expect("the file is text"), "one\ntwo\n");
    }
}
