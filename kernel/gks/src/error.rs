//! The errors of GKS.

use crate::generated::{error_text, function::Function};

/// An error that the standard defines, with the function that met it.
///
/// The function had no effect. The message names the number, what it means and, where there is more to say,
/// which value was wrong.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("GKS error {number} in {}: {}{}", function.name(), self.text(), self.detail_text())]
pub struct Error {
    /// The error number of the standard.
    pub number: i32,
    /// The function that met the error.
    pub function: Function,
    /// Which value was wrong, where the number does not say it all.
    pub detail: Option<String>,
}

impl Error {
    /// The error `number` in `function`.
    pub fn new(number: i32, function: Function) -> Self {
        Error { number, function, detail: None }
    }

    /// The error with more to say about it.
    #[must_use]
    pub fn because(self, detail: impl Into<String>) -> Self {
        Error { detail: Some(detail.into()), ..self }
    }

    /// What the number means.
    pub fn text(&self) -> &'static str {
        error_text::text(self.number).unwrap_or("unknown error")
    }

    fn detail_text(&self) -> String {
        self.detail.as_ref().map(|d| format!(" ({d})")).unwrap_or_default()
    }
}

/// The result of a function of GKS.
pub type Result<T, E = Error> = std::result::Result<T, E>;
