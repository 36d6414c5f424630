//! Metafiles: GKSM and CGM, written from and read into the stream of records at the waist.
//!
//! A writer is a [`gks_pipeline::record::Recorder`] over a sink, a reader a [`gks_pipeline::record::Source`]
//! over bytes. Neither opens files, and neither believes a count in a file before the data is there.

pub mod cgm;
mod format;
pub mod generated;
pub mod gksm;
mod input;

pub use format::{Format, Opened, ReadOptions, open_source};
