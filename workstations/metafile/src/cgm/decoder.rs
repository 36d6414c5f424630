//! What decoders of all encodings have in common.

use super::element::Element;
use gks_pipeline::record::SourceError;

/// Gives the elements of a metafile one by one.
pub trait Decoder: Send {
    /// The next element, or none after the last one.
    ///
    /// After an error that cannot be put right there is no further element.
    fn next(&mut self) -> Result<Option<Element>, SourceError>;

    /// How many elements have been skipped because they are unknown or make no sense.
    fn skipped(&self) -> u64;
}
