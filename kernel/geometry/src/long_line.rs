//! Polylines in pieces: long ones are never held as a whole.

use crate::{Map, Ndc, Paths, Point, Points, Rect, Space, Wc};
use glam::{DMat2, DVec2};
use std::convert::Infallible;
use std::marker::PhantomData;
use std::ops::Range;

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
    #[inline]
    fn pieces<E>(&self, mut each: impl FnMut(Piece<'_>) -> Result<(), E>) -> Result<(), E> {
        for points in self.iter().filter(|path| !path.is_empty()) {
            each(Piece { points, starts: true, ends: true })?;
        }
        Ok(())
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
    /// The bounds of every [`PIECE`] points in world coordinates, if all of them are finite.
    parts: &'a [Option<Rect<Wc>>],
    /// The bounds of all points, likewise.
    whole: Option<Rect<Wc>>,
    space: PhantomData<S>,
}

impl<'a> LongLine<'a, Ndc> {
    /// The image of points under a normalization transformation. The bounds of its parts, of which there is one for each of
    /// many points, are kept in `parts`.
    pub fn new(
        points: Points<'a>,
        normalization: Map<Wc, Ndc>,
        parts: &'a mut Vec<Option<Rect<Wc>>>,
    ) -> Self {
        parts.clear();
        parts.extend((0..points.len()).step_by(PIECE).map(|from| points.part(from..from + PIECE).bounds()));
        let finite = parts.iter().all(Option::is_some);
        let whole =
            Rect::around(parts.iter().flatten().flat_map(|part| [part.min, part.max])).filter(|_| finite);
        LongLine { points, normalization, map: Map::IDENTITY, parts, whole, space: PhantomData }
    }

    /// The line in another space.
    pub fn mapped<S: Space>(&self, map: &Map<Ndc, S>) -> LongLine<'a, S> {
        let LongLine { points, normalization, parts, whole, .. } = *self;
        LongLine { points, normalization, map: *map, parts, whole, space: PhantomData }
    }
}

impl<S: Space> LongLine<'_, S> {
    /// The number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Whether all points are finite, so that the line is one path.
    pub fn is_whole(&self) -> bool {
        // What lies between two finite points has a finite image, too.
        self.whole.is_some_and(|bounds| bounds.corners().iter().all(|&p| self.image(p.0).is_some()))
    }

    /// The number of points in those parts of the line that are not known to lie wholly on one side of a rectangle.
    pub fn len_near(&self, near: &Rect<S>) -> usize {
        let part = |(i, _)| PIECE.min(self.len() - i * PIECE);
        self.parts.iter().enumerate().filter(|(_, part)| !self.is_beside(part, near)).map(part).sum()
    }

    /// Whether a part of the line is known to lie wholly on one side of a rectangle.
    fn is_beside(&self, part: &Option<Rect<Wc>>, near: &Rect<S>) -> bool {
        let Some(part) = part else { return false };
        let corners = part.corners().map(|p| self.image(p.0));
        let bounds = Rect::around(corners.iter().flatten().map(|&p| Point::from_vec(p)));
        corners.iter().all(Option::is_some) && bounds.is_some_and(|bounds| !bounds.meets(near))
    }

    /// Calls `each` with the pieces of all paths in order, until it fails. Of pieces that are known to lie wholly on one side of
    /// a rectangle come the first and the last point only.
    pub fn pieces_near<E>(
        &self,
        near: &Rect<S>,
        each: impl FnMut(Piece<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        self.walk(Some(near), each)
    }

    fn walk<E>(
        &self,
        near: Option<&Rect<S>>,
        mut each: impl FnMut(Piece<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let (normalization, map) = (self.normalization.0, self.map.0);
        let mut buffer = [DVec2::ZERO; PIECE];
        let (mut from, mut starts, is_whole) = (0, true, self.is_whole());
        for part in self.parts {
            let to = self.len().min(from + PIECE);
            let points = self.points.part(from..to);
            let images = &mut buffer[..to - from];
            // The piece after this one tells whether a path ends here.
            let goes_on = to < self.len() && (is_whole || self.point(to).is_some());
            let mut finite = true;
            if let Some((first, last)) = self.beside(part, near, from..to) {
                give(&[first, last], starts, !goes_on, &mut each)?;
                starts = !goes_on;
            } else if is_whole {
                points.map_to(|p| map.transform_point2(normalization.transform_point2(p)), images);
                give(images, starts, !goes_on, &mut each)?;
                starts = false;
            } else {
                points.map_to(
                    |p| {
                        let p = normalization.transform_point2(p);
                        finite &= p.is_finite();
                        map.transform_point2(p)
                    },
                    images,
                );
                if finite {
                    give(images, starts, !goes_on, &mut each)?;
                    starts = !goes_on;
                } else {
                    self.broken(points, goes_on, &mut starts, &mut each)?;
                }
            }
            from = to;
        }
        Ok(())
    }

    /// The first and the last point of a part that is known to lie wholly on one side of a rectangle, if there is one.
    fn beside(
        &self,
        part: &Option<Rect<Wc>>,
        near: Option<&Rect<S>>,
        points: Range<usize>,
    ) -> Option<(DVec2, DVec2)> {
        near.filter(|near| points.len() > 2 && self.is_beside(part, near))?;
        Some((self.point(points.start)?, self.point(points.end - 1)?))
    }

    /// A point of the line; none if there is no such point or it is not finite.
    pub fn point(&self, index: usize) -> Option<DVec2> {
        let mut point = [DVec2::ZERO];
        self.points.part(index..index + 1).map_to(|p| p, &mut point);
        if index < self.len() { self.image(point[0]) } else { None }
    }

    /// The image of a point, if it is finite in NDC.
    ///
    /// The maps are not fused: points come out bit for bit as those do that are kept in NDC in between.
    #[inline]
    fn image(&self, p: DVec2) -> Option<DVec2> {
        let p = self.normalization.0.transform_point2(p);
        p.is_finite().then(|| self.map.0.transform_point2(p))
    }

    /// The smallest rectangle around all points, or none if there is no point.
    pub fn bounds(&self) -> Option<Rect<S>> {
        let (normalization, map) = (&self.normalization.0.matrix2, &self.map.0.matrix2);
        let upright = |m: &DMat2| m.x_axis.y == 0.0 && m.y_axis.x == 0.0;
        if let Some(whole) = self.whole
            && upright(normalization)
            && upright(map)
            && self.is_whole()
        {
            // Rounding keeps the order of numbers, so the extremes are images of extremes.
            return Rect::around([whole.min, whole.max].map(|p| self.map.point(self.normalization.point(p))));
        }
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let done = self.pieces::<Infallible>(|piece| {
            for &p in piece.points {
                (low, high) = (low.min(p), high.max(p));
            }
            Ok(())
        });
        let Ok(()) = done;
        (low.x <= high.x).then(|| Rect { min: Point::from_vec(low), max: Point::from_vec(high) })
    }

    /// Gives the parts of points that are broken somewhere; `starts` tells whether a path starts with the first of them, and
    /// afterwards with the one after the last.
    #[cold]
    fn broken<E>(
        &self,
        points: Points<'_>,
        goes_on: bool,
        starts: &mut bool,
        each: &mut impl FnMut(Piece<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut path = Vec::new();
        let mut images = Vec::with_capacity(points.len());
        points.for_each(|p| images.push(self.image(p)));
        for image in images.into_iter().chain((!goes_on).then_some(None)) {
            match image {
                Some(p) => path.push(p),
                None => {
                    give(&path, *starts, true, each)?;
                    path.clear();
                    *starts = true;
                }
            }
        }
        give(&path, *starts, false, each)?;
        *starts &= path.is_empty();
        Ok(())
    }
}

/// Hands a piece on, unless it is a path of a single point or has none.
fn give<E>(
    points: &[DVec2],
    starts: bool,
    ends: bool,
    each: &mut impl FnMut(Piece<'_>) -> Result<(), E>,
) -> Result<(), E> {
    if points.len() > usize::from(starts && ends) { each(Piece { points, starts, ends }) } else { Ok(()) }
}

impl<S: Space> Pieces for LongLine<'_, S> {
    fn pieces<E>(&self, each: impl FnMut(Piece<'_>) -> Result<(), E>) -> Result<(), E> {
        self.walk(None, each)
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
            let mut parts = Vec::new();
            let line = LongLine::new(Points::from(&points), Map::IDENTITY, &mut parts);
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
        let mut parts = Vec::new();
        let line = LongLine::new(Points::from(&points), normalization, &mut parts);
        let to_device = Map::window_to_viewport(&Rect::UNIT, &Rect::new(0.0, 100.0, 0.0, 100.0));
        let bounds = line.mapped::<crate::Du>(&to_device).bounds().unwrap();
        assert_eq!(bounds.limits().map(f64::round), [10.0, 30.0, 20.0, 60.0]);
        let nothing = LongLine::new(Points::from(&points[2..]), normalization, &mut parts);
        assert_eq!(nothing.bounds(), None);
    }

    #[test]
    fn of_pieces_beside_a_rectangle_come_their_ends() {
        // Eight rows of pieces, each in an order of its own, the third one with a gap.
        let mut points: Vec<(f64, f64)> =
            (0..8 * PIECE).map(|i| ((i * 7 % PIECE) as f64, i as f64)).collect();
        points[2 * PIECE + 5].0 = f64::NAN;
        let mut parts = Vec::new();
        let line = LongLine::new(Points::from(&points), Map::IDENTITY, &mut parts);
        let near = Rect::new(0.0, 9.0, 4.5 * PIECE as f64, 4.6 * PIECE as f64);
        assert_eq!(line.len_near(&near), 2 * PIECE);
        let mut given = Vec::new();
        line.pieces_near::<()>(&near, |piece| {
            given.push((piece.points.len(), piece.starts, piece.ends));
            Ok(())
        })
        .unwrap();
        let gap = [(2, true, false), (2, false, false), (5, false, true), (PIECE - 6, true, false)];
        let rest = [
            (2, false, false),
            (PIECE, false, false),
            (2, false, false),
            (2, false, false),
            (2, false, true),
        ];
        assert_eq!(given, [gap.as_slice(), &rest].concat());
        let mut count = 0;
        line.pieces::<()>(|piece| {
            count += piece.points.len();
            Ok(())
        })
        .unwrap();
        assert_eq!(count, 8 * PIECE - 1);
    }

    #[test]
    fn a_failure_ends_the_walk() {
        let points: Vec<(f64, f64)> = (0..5 * PIECE).map(point).collect();
        let mut calls = 0;
        let failed = LongLine::new(Points::from(&points), Map::IDENTITY, &mut Vec::new()).pieces(|_| {
            calls += 1;
            Err(calls)
        });
        assert_eq!(failed, Err(1));
    }
}
