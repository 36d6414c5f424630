//! GKSM, the metafile of ISO 7942, annex E: a header that tells how numbers are coded, and items.

mod fields;
mod formatted;
mod header;
mod reader;
mod writer;

pub(crate) use header::is_header;
pub use reader::Reader;
pub use writer::{Coding, Writer};
