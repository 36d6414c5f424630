//! The subcommands of `gks`, one a file.

pub mod bench;
pub mod compile;
pub mod coverage;
pub mod demo;
pub mod doctor;
pub mod info;
pub mod install;
pub mod play;
pub mod run;
pub mod workstations;

use gks_pipeline::generated::numbers::WORKSTATION_TYPES;

/// The extension of the files of a workstation type; empty if it writes none.
pub(crate) fn extension(number: i32) -> &'static str {
    WORKSTATION_TYPES.iter().find(|t| t.number == number).map_or("", |t| t.extension)
}

/// What ends a command early: a message for the user.
pub type Failure = Box<dyn std::error::Error>;
