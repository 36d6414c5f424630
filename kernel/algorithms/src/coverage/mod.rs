//! Coverage: how much of each pixel a shape covers.
//!
//! [`AreaMask`] measures areas exactly and adds them up: right where edges do not overlap inside of a pixel, as those of an
//! area. [`SampleMask`] takes the union of convex polygons, point sample by point sample: what overlaps itself inside of a pixel,
//! as a dense polyline does, counts once. Both keep nothing but their storage between two shapes.

mod area_mask;
mod brush;
mod group;
mod sample_mask;

pub use area_mask::{AreaMask, Cover, Gain};
pub use brush::Brush;
pub use sample_mask::{SAMPLES, SIDE, SampleMask};
