//! Simplification: what the pipeline does with a mark that a device refused.
//!
//! Each file takes one kind of mark apart into simpler ones. The end of every chain is a set of solid,
//! unclipped lines, which every device draws.

pub mod cells;
pub mod curve;
pub mod dashed;
pub mod glow;
pub mod hatch;
pub mod line;
pub mod marker;
pub mod pattern;
pub mod sector;
pub mod text;
pub mod wide;
