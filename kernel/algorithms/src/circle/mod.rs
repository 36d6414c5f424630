//! Circles and circular arcs.

mod midpoint;
mod three_points;

pub use midpoint::midpoint;
pub use three_points::{Arc, three_points};
