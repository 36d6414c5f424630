//! Lines: dashing and reducing polylines.

mod dash;

pub use dash::dash;
