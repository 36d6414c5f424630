//! What decoders of all encodings have in common.

use super::element::Element;
use crate::generated::elements::Row;
use gks_pipeline::record::{Skipped, SourceError};

/// Gives the elements of a metafile one by one.
pub trait Decoder: Send {
    /// The next element, or none after the last one.
    ///
    /// After an error that cannot be put right there is no further element.
    fn next(&mut self) -> Result<Option<Element>, SourceError>;

    /// The elements that have been skipped because they are unknown or make no sense.
    fn skipped(&self) -> &Skipped;
}

/// What is told of an element that is in no table.
pub(super) fn unknown(code: impl std::fmt::Display) -> String {
    format!("unknown element {code}")
}

/// What is told of an element whose parameters make no sense.
pub(super) fn senseless(row: &Row) -> String {
    format!("{} with senseless parameters", row.name)
}
