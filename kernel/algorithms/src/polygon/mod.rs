//! Polygons: measures and tests of rings.

mod area;
mod bounds;
mod crossing;

pub use area::{area, ring_area};
pub use bounds::bounds;
pub use crossing::contains;
