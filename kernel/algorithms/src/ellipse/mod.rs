//! Ellipses: given by a centre and two conjugate half diameters.

mod flatten;

pub use flatten::flatten;
