//! Device drivers: from device coordinates to bytes or pixels.
//!
//! Every driver implements [`gks_pipeline::device::Device`], whose documentation is the driver manual.
//! Drivers write to a [`gks_pipeline::device::Sink`] that is handed to them; only [`catalogue`] knows file
//! names.

mod arc;
pub mod catalogue;
mod connection;
mod deflate;
pub mod dialect;
mod drivers;
pub mod environment;
pub mod hpgl;
pub mod interactive;
mod metafile;
pub mod null;
pub mod number;
pub mod options;
mod paper;
pub mod pdf;
pub mod postscript;
pub mod raster;
mod route;
pub mod scripted;
pub mod sink;
pub mod svg;
