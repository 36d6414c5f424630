//! The arrays of points that applications hand over, as they are.

use glam::DVec2;

/// A view of an array of points in one of the layouts that callers have. The normalization transformation is
/// the pass that reads it; nothing is copied before.
#[derive(Copy, Clone, Debug)]
pub enum Points<'a> {
    /// Pairs of numbers.
    Tuples(&'a [(f64, f64)]),
    /// Arrays of two numbers.
    Arrays(&'a [[f64; 2]]),
    /// Arrays of two single precision numbers: the points of the C binding.
    Singles(&'a [[f32; 2]]),
    /// Abscissae and ordinates apart, in single precision: Fortran's arrays. The shorter array counts.
    SplitSingles(&'a [f32], &'a [f32]),
    /// Abscissae and ordinates apart. The shorter array counts.
    Split(&'a [f64], &'a [f64]),
}

impl Points<'_> {
    /// The number of points.
    pub fn len(&self) -> usize {
        match self {
            Points::Tuples(p) => p.len(),
            Points::Arrays(p) => p.len(),
            Points::Singles(p) => p.len(),
            Points::SplitSingles(x, y) => x.len().min(y.len()),
            Points::Split(x, y) => x.len().min(y.len()),
        }
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Calls `each` with every point in turn.
    pub fn for_each(&self, mut each: impl FnMut(DVec2)) {
        match self {
            Points::Tuples(p) => p.iter().for_each(|&(x, y)| each(DVec2::new(x, y))),
            Points::Arrays(p) => p.iter().for_each(|&[x, y]| each(DVec2::new(x, y))),
            Points::Singles(p) => p.iter().for_each(|&[x, y]| each(DVec2::new(x.into(), y.into()))),
            Points::SplitSingles(x, y) => {
                x.iter().zip(*y).for_each(|(&x, &y)| each(DVec2::new(x.into(), y.into())));
            }
            Points::Split(x, y) => x.iter().zip(*y).for_each(|(&x, &y)| each(DVec2::new(x, y))),
        }
    }
}

macro_rules! from_slices {
    ($($variant:ident: $point:ty),+) => { $(
        impl<'a> From<&'a [$point]> for Points<'a> {
            fn from(points: &'a [$point]) -> Self {
                Points::$variant(points)
            }
        }
        impl<'a> From<&'a Vec<$point>> for Points<'a> {
            fn from(points: &'a Vec<$point>) -> Self {
                Points::$variant(points)
            }
        }
        impl<'a, const N: usize> From<&'a [$point; N]> for Points<'a> {
            fn from(points: &'a [$point; N]) -> Self {
                Points::$variant(points)
            }
        }
    )+ };
}
from_slices!(Tuples: (f64, f64), Arrays: [f64; 2], Singles: [f32; 2]);
