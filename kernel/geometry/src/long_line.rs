//! Polylines in pieces: long ones are never held as a whole.

use crate::{Map, Ndc, Paths, Point, Points, Rect, Space, Wc};
use glam::DVec2;
use std::marker::PhantomData;

/// The most points of a long line that are mapped before they are handed on.
const PIECE: usize = 1024;

/// A part of a path: some of its points, in order.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Piece<'a> {
    /// The points, at least one.
    pub points: &'a [DVec2],
    /// Whether the first of them is the first one of the path.
    pub starts: bool,
    /// Whether the last of them is the last one of the path.
    pub ends: bool,
}

/// Paths whose points come piece by piece.
pub trait Pieces {
    /// Calls `each` with the pieces of all paths in order, until it fails.
    fn pieces<E>(&self, each: impl FnMut(Piece<'_>) -> Result<(), E>) -> Result<(), E>;
}

impl<S: Space> Pieces for Paths<'_, S> {
    fn pieces<E>(&self, mut each: impl FnMut(Piece<'_>) -> Result<(), E>) -> Result<(), E> {
        let paths = self.iter().filter(|path| !path.is_empty());
        paths.map(|points| Piece { points, starts: true, ends: true }).try_for_each(&mut each)
    }
}

/// A polyline as an application holds it, which is mapped to space `S` while it is walked.
///
/// It is broken where a point is not finite in NDC; of the parts those with at least two points are paths.
#[derive(Copy, Clone, Debug)]
pub struct LongLine<'a, S: Space> {
    points: Points<'a>,
    normalization: Map<Wc, Ndc>,
    map: Map<Ndc, S>,
    space: PhantomData<S>,
}

impl<'a> LongLine<'a, Ndc> {
    /// The image of points under a normalization transformation.
    pub fn new(points: Points<'a>, normalization: Map<Wc, Ndc>) -> Self {
        LongLine { points, normalization, map: Map::IDENTITY, space: PhantomData }
    }

    /// The line in another space.
    pub fn mapped<S: Space>(&self, map: &Map<Ndc, S>) -> LongLine<'a, S> {
        LongLine { points: self.points, normalization: self.normalization, map: *map, space: PhantomData }
    }
}

impl<S: Space> LongLine<'_, S> {
    /// Calls `each` with every point in turn; with none where the line is broken.
    ///
    /// The maps are not fused: points come out bit for bit as those do that are kept in NDC in between.
    #[inline]
    fn walk(&self, mut each: impl FnMut(Option<DVec2>)) {
        let (normalization, map) = (self.normalization.0, self.map.0);
        self.points.for_each(|p| {
            let p = normalization.transform_point2(p);
            each(p.is_finite().then(|| map.transform_point2(p)));
        });
    }

    /// The smallest rectangle around all points, or none if there is no point.
    pub fn bounds(&self) -> Option<Rect<S>> {
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        self.walk(|p| {
            if let Some(p) = p {
                low = low.min(p);
                high = high.max(p);
            }
        });
        (low.x <= high.x).then(|| Rect { min: Point::from_vec(low), max: Point::from_vec(high) })
    }
}

impl<S: Space> Pieces for LongLine<'_, S> {
    fn pieces<E>(&self, mut each: impl FnMut(Piece<'_>) -> Result<(), E>) -> Result<(), E> {
        let mut buffer = [DVec2::ZERO; PIECE];
        let (mut filled, mut starts) = (0, true);
        let mut done = Ok(());
        let mut give = |points: &[DVec2], starts, ends| {
            let is_path = points.len() > usize::from(starts && ends);
            if is_path && done.is_ok() {
                done = each(Piece { points, starts, ends });
            }
        };
        self.walk(|p| match p {
            Some(p) => {
                if filled == PIECE {
                    give(&buffer, starts, false);
                    (filled, starts) = (0, false);
                }
                buffer[filled] = p;
                filled += 1;
            }
            None => {
                give(&buffer[..filled], starts, true);
                (filled, starts) = (0, true);
            }
        });
        give(&buffer[..filled], starts, true);
        done
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PathBuf;

    fn point(i: usize) -> (f64, f64) {
        (i as f64, (i % 7) as f64)
    }

    /// The paths put together again, and how many pieces they had.
    fn collected(line: &impl Pieces) -> (PathBuf<Ndc>, usize) {
        let (mut paths, mut count, mut open) = (PathBuf::new(), 0, false);
        line.pieces::<()>(|piece| {
            assert!(piece.starts != open && !piece.points.is_empty());
            open = !piece.ends;
            count += 1;
            Ok(())
        })
        .unwrap();
        assert!(!open);
        paths.add_pieces(line);
        (paths, count)
    }

    #[test]
    fn pieces_are_the_paths_between_points_that_are_not_finite() {
        for length in [0, 1, 2, PIECE - 1, PIECE, PIECE + 1, 3 * PIECE] {
            let mut points: Vec<(f64, f64)> = (0..length).map(point).collect();
            points.push((f64::NAN, 0.0));
            points.push((5.0, 5.0));
            points.push((0.0, f64::INFINITY));
            points.extend([(1.0, 2.0), (3.0, 4.0)]);
            let line = LongLine::new(Points::from(&points), Map::IDENTITY);
            let (paths, count) = collected(&line);
            let lengths: Vec<usize> = paths.as_paths().iter().map(<[DVec2]>::len).collect();
            let expected: Vec<usize> = [length, 2].into_iter().filter(|l| *l > 1).collect();
            assert_eq!(lengths, expected);
            assert_eq!(count, length.div_ceil(PIECE) * usize::from(length > 1) + 1);
            assert_eq!(collected(&paths.as_paths()).0, paths);
        }
    }

    #[test]
    fn points_are_mapped_on_the_way() {
        let points = [[1.0, 2.0], [3.0, 6.0], [f64::NAN, -9.0]];
        let normalization = Map::window_to_viewport(&Rect::new(0.0, 10.0, 0.0, 10.0), &Rect::UNIT);
        let line = LongLine::new(Points::from(&points), normalization);
        let to_device = Map::window_to_viewport(&Rect::UNIT, &Rect::new(0.0, 100.0, 0.0, 100.0));
        let bounds = line.mapped::<crate::Du>(&to_device).bounds().unwrap();
        assert_eq!(bounds.limits().map(f64::round), [10.0, 30.0, 20.0, 60.0]);
        let nothing = LongLine::new(Points::from(&points[2..]), normalization);
        assert_eq!(nothing.bounds(), None);
    }

    #[test]
    fn a_failure_ends_the_walk() {
        let points: Vec<(f64, f64)> = (0..5 * PIECE).map(point).collect();
        let mut calls = 0;
        let failed = LongLine::new(Points::from(&points), Map::IDENTITY).pieces(|_| {
            calls += 1;
            Err(calls)
        });
        assert_eq!(failed, Err(1));
    }
}
