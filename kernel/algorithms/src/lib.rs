//! The textbook shelf: one algorithm a file, named after its author or its name in the textbooks.
//!
//! Every algorithm is a pure function, or a value that keeps nothing but its storage between two calls. None draws and
//! none knows what its result is for: pixels, spans and segments go to a closure, points are appended to vectors of the
//! caller, so that nothing is allocated for each primitive. Algorithms for the same job have the same signature.
//!
//! Angles are radians, anticlockwise with y upwards. Several polylines or rings are a path set (see [`path`]). Points
//! that are not finite never cause a panic or an endless loop: they break a polyline and are left out of a ring. What
//! fills a raster takes the rectangle of its pixels and does no work in proportion to what lies outside.
//! The sources are collected in `BIBLIOGRAPHY.md`.

pub mod circle;
pub mod clip;
pub mod coverage;
pub mod curve;
pub mod ellipse;
pub mod fill;
pub mod line;
pub mod path;
pub mod polygon;
pub mod rect;

#[cfg(test)]
mod picture;
#[cfg(test)]
mod xorshift;
