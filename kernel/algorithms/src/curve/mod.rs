//! Curves: flattening Bezier curves, and splines through given points.
//!
//! A chain of cubic Bezier pieces is held as its first point followed by three points for each piece: two control
//! points and the end, where the next piece begins.

mod bezier;
mod natural_spline;

pub use bezier::{chain, cubic, cubic_within, quadratic, quadratic_within};
pub use natural_spline::NaturalSpline;
