//! Ellipses: points of arcs given by conjugate half diameters, pixels of outlines parallel to the axes.

mod flatten;
mod midpoint;

pub use flatten::flatten;
pub use midpoint::midpoint;
