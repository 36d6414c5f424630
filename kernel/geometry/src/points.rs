//! The arrays of points that applications hand over, as they are.

use crate::extremes::Extremes;
use crate::{Point, Rect, Wc};
use glam::{DAffine2, DVec2};
use std::ops::Range;

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

impl<'a> Points<'a> {
    /// The number of points.
    #[inline]
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

    /// Adds the images of all points under a map. Whether all of them are finite.
    pub fn add_mapped(&self, map: &DAffine2, images: &mut Vec<DVec2>) -> bool {
        match *self {
            Points::Tuples(p) => add_mapped(map, p.iter().map(|&(x, y)| DVec2::new(x, y)), images),
            Points::Arrays(p) => add_mapped(map, p.iter().map(|&p| p.into()), images),
            Points::Singles(p) => {
                add_mapped(map, p.iter().map(|&[x, y]| DVec2::new(x.into(), y.into())), images)
            }
            Points::SplitSingles(x, y) => {
                let points = x.iter().zip(y).map(|(&x, &y)| DVec2::new(x.into(), y.into()));
                add_mapped(map, points, images)
            }
            Points::Split(x, y) => add_mapped(map, x.iter().zip(y).map(|(&x, &y)| DVec2::new(x, y)), images),
        }
    }

    /// Some of the points.
    pub fn part(&self, range: Range<usize>) -> Points<'a> {
        let range = range.start.min(self.len())..range.end.min(self.len());
        match *self {
            Points::Tuples(p) => Points::Tuples(&p[range]),
            Points::Arrays(p) => Points::Arrays(&p[range]),
            Points::Singles(p) => Points::Singles(&p[range]),
            Points::SplitSingles(x, y) => Points::SplitSingles(&x[range.clone()], &y[range]),
            Points::Split(x, y) => Points::Split(&x[range.clone()], &y[range]),
        }
    }

    /// Puts the images of the points into a slice, as many as there are of both.
    #[inline]
    pub fn map_to(&self, mut map: impl FnMut(DVec2) -> DVec2, images: &mut [DVec2]) {
        match *self {
            Points::Tuples(p) => {
                images.iter_mut().zip(p).for_each(|(image, &(x, y))| *image = map(DVec2::new(x, y)));
            }
            Points::Arrays(p) => images.iter_mut().zip(p).for_each(|(image, &p)| *image = map(p.into())),
            Points::Singles(p) => images
                .iter_mut()
                .zip(p)
                .for_each(|(image, &[x, y])| *image = map(DVec2::new(x.into(), y.into()))),
            Points::SplitSingles(x, y) => images
                .iter_mut()
                .zip(x.iter().zip(y))
                .for_each(|(image, (&x, &y))| *image = map(DVec2::new(x.into(), y.into()))),
            Points::Split(x, y) => images
                .iter_mut()
                .zip(x.iter().zip(y))
                .for_each(|(image, (&x, &y))| *image = map(DVec2::new(x, y))),
        }
    }

    /// The smallest rectangle around all points, or none if one of them is not finite or there is none.
    pub fn bounds(&self) -> Option<Rect<Wc>> {
        let (x, y) = match *self {
            Points::Tuples(p) => Extremes::of_pairs(p, |&(x, y)| [x, y]),
            Points::Arrays(p) => Extremes::of_pairs(p, |&p| p),
            Points::Singles(p) => Extremes::of_pairs(p, |&p| p),
            Points::SplitSingles(x, y) => (Extremes::of(&x[..self.len()]), Extremes::of(&y[..self.len()])),
            Points::Split(x, y) => (Extremes::of(&x[..self.len()]), Extremes::of(&y[..self.len()])),
        };
        let bounds = || Rect { min: Point::new(x.low, y.low), max: Point::new(x.high, y.high) };
        (x.finite && y.finite && !self.is_empty()).then(bounds)
    }

    /// Calls `each` with every point in turn.
    #[inline]
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

/// One pass without a branch in it.
#[inline]
fn add_mapped(map: &DAffine2, points: impl Iterator<Item = DVec2>, images: &mut Vec<DVec2>) -> bool {
    let mut finite = true;
    images.extend(points.map(|p| {
        let image = map.transform_point2(p);
        finite &= image.is_finite();
        image
    }));
    finite
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_layout_has_the_same_images() {
        let map = DAffine2::from_cols_array(&[2.0, 0.0, 0.0, 3.0, 1.0, -1.0]);
        let layouts = [
            Points::Tuples(&[(0.5, 1.0), (2.0, 4.0)]),
            Points::Arrays(&[[0.5, 1.0], [2.0, 4.0]]),
            Points::Singles(&[[0.5, 1.0], [2.0, 4.0]]),
            Points::SplitSingles(&[0.5, 2.0], &[1.0, 4.0, 9.0]),
            Points::Split(&[0.5, 2.0, 7.0], &[1.0, 4.0]),
        ];
        for points in layouts {
            let mut images = vec![DVec2::ZERO];
            assert!(points.add_mapped(&map, &mut images), "{points:?}");
            assert_eq!(images, [DVec2::ZERO, DVec2::new(2.0, 2.0), DVec2::new(5.0, 11.0)], "{points:?}");
        }
    }

    #[test]
    fn bounds_and_parts_of_every_layout() {
        let pairs: Vec<(f64, f64)> =
            (0..11).map(|i| (f64::from(i * 7 % 11), f64::from(i * 5 % 11 - 4))).collect();
        let arrays: Vec<[f64; 2]> = pairs.iter().map(|&p| p.into()).collect();
        let singles: Vec<[f32; 2]> = pairs.iter().map(|&(x, y)| [x as f32, y as f32]).collect();
        let (x, y): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
        let (a, b): (Vec<f32>, Vec<f32>) = singles.iter().map(|&[x, y]| (x, y)).unzip();
        let layouts = [
            Points::Tuples(&pairs),
            Points::Arrays(&arrays),
            Points::Singles(&singles),
            Points::SplitSingles(&a, &b),
            Points::Split(&x, &y),
        ];
        for points in layouts {
            assert_eq!(points.bounds(), Some(Rect::new(0.0, 10.0, -4.0, 6.0)), "{points:?}");
            let mut images = [DVec2::ZERO; 3];
            points.part(9..200).map_to(|p| p * 2.0, &mut images);
            assert_eq!(images, [DVec2::new(16.0, -6.0), DVec2::new(8.0, 4.0), DVec2::ZERO], "{points:?}");
        }
        assert_eq!(Points::Tuples(&[]).bounds(), None);
        for odd in [f64::NAN, f64::INFINITY] {
            assert_eq!(Points::Tuples(&[(0.0, 1.0), (2.0, odd), (3.0, 3.0)]).bounds(), None);
        }
    }

    #[test]
    fn what_is_not_finite_is_told() {
        let map = DAffine2::IDENTITY;
        for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for point in [(odd, 0.0), (0.0, odd)] {
                assert!(!Points::Tuples(&[(0.0, 0.0), point]).add_mapped(&map, &mut Vec::new()), "{point:?}");
            }
        }
    }
}
