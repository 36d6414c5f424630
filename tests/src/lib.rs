//! What the tests share that look at the system from outside.

pub mod drawing;
pub mod folder;
pub mod likeness;
pub mod operation;
#[path = "../pictures/mod.rs"]
pub mod pictures;
pub mod program;
pub use gks_cli::bench::random;
pub mod reader;
