//! Benchmarks: what drawing through the kernel costs, how near the pictures are to the true ones, and what
//! tiny-skia needs for the same in the same process.
//!
//! The workloads are W1 to W10 of the tables in the README and a few more, each at three sizes, so that growth
//! shows. Every measurement is made in a process of its own. Time is processor time: medians of five samples
//! of at least 0.3 s each, those of the kernel and of the yardstick in turn.

pub mod area;
pub mod cells;
pub mod clock;
pub mod curve;
pub mod line;
pub mod marker;
pub mod measurement;
pub mod random;
pub mod reference;
pub mod report;
pub mod scene;
pub mod skia;
pub mod text;
pub mod workload;
