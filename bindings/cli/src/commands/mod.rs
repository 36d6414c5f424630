//! The subcommands of `gks`, one a file.

pub mod compile;
pub mod coverage;
pub mod demo;
pub mod doctor;
pub mod run;
pub mod workstations;

/// What ends a command early: a message for the user.
pub type Failure = Box<dyn std::error::Error>;
