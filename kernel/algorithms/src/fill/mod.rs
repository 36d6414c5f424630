//! Filling: the inside of rings as spans of pixels or as hatch lines.
//!
//! Both take a path set of rings, a [`crate::path::Rule`] and a rectangle outside which nothing is given; both are values
//! that keep their tables from one area to the next.

mod edge_table;
mod hatch;

pub use edge_table::EdgeTable;
pub use hatch::{Hatch, HatchLines};
