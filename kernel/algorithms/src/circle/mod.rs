//! Circles and circular arcs.

mod three_points;

pub use three_points::{Arc, three_points};
