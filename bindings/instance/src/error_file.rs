//! Where errors are logged.

use std::fs::OpenOptions;
use std::io::Write;

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

    /// The file of a name; an empty one means the standard error output.
    pub fn from_name(name: &str) -> Self {
        if name.is_empty() { ErrorFile::Stderr } else { ErrorFile::Path(name.to_owned()) }
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
