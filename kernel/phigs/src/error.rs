//! The errors of PHIGS.

/// An error that the standard defines, with the function that met it. The function had no effect.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("PHIGS error {number} in {function}: {detail}")]
pub struct Error {
    /// The error number of the standard.
    pub number: i32,
    /// The standard's name of the function.
    pub function: &'static str,
    /// What was wrong.
    pub detail: String,
}

impl Error {
    pub(crate) fn new(number: i32, function: &'static str, detail: impl Into<String>) -> Self {
        Error { number, function, detail: detail.into() }
    }
}

/// The result of a function of PHIGS.
pub type Result<T> = std::result::Result<T, Error>;
