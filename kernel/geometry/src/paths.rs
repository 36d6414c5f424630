//! Sets of polygonal paths: what polylines, rings of areas and strokes of characters have in common.

use crate::extremes::Extremes;
use crate::{Map, Pieces, Point, Rect, Space};
use glam::DVec2;
use std::convert::Infallible;
use std::marker::PhantomData;

/// A borrowed set of paths in space `S`.
///
/// Path *i* consists of the points from `ends[i - 1]` (0 for the first) up to, not including, `ends[i]`.
/// The points are plain vectors, so that algorithms that know no spaces read them without a copy.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Paths<'a, S: Space> {
    /// The points of all paths, one path after the other.
    pub points: &'a [DVec2],
    /// The exclusive end of each path in `points`, increasing.
    pub ends: &'a [u32],
    space: PhantomData<S>,
}

impl<'a, S: Space> Paths<'a, S> {
    /// The set with the given points and ends.
    #[inline]
    pub const fn new(points: &'a [DVec2], ends: &'a [u32]) -> Self {
        Paths { points, ends, space: PhantomData }
    }

    /// The paths one by one.
    pub fn iter(&self) -> impl Iterator<Item = &'a [DVec2]> + use<'a, S> {
        let points = self.points;
        let mut start = 0;
        self.ends.iter().map(move |&end| {
            let path = &points[start..end as usize];
            start = end as usize;
            path
        })
    }

    /// Whether there is no point in the set.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The smallest rectangle around all points that are numbers, or none for an empty set.
    #[inline]
    pub fn bounds(&self) -> Option<Rect<S>> {
        /// So few points are compared one after the other.
        const FEW: usize = 16;
        let (&first, rest) = self.points.split_first()?;
        if rest.len() > FEW {
            return Some(self.bounds_of_many());
        }
        let (mut low, mut high) = (first, first);
        for &p in rest {
            (low, high) = (low.min(p), high.max(p));
        }
        Some(Rect { min: Point::from_vec(low), max: Point::from_vec(high) })
    }

    #[inline(never)]
    fn bounds_of_many(&self) -> Rect<S> {
        let (x, y) = Extremes::of_pairs(self.points, DVec2::to_array);
        Rect { min: Point::new(x.low, y.low), max: Point::new(x.high, y.high) }
    }
}

/// An owned set of paths in space `S`, reused as scratch space from primitive to primitive.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PathBuf<S: Space> {
    /// The points of all paths, one path after the other.
    pub points: Vec<DVec2>,
    /// The exclusive end of each path in `points`.
    pub ends: Vec<u32>,
    space: PhantomData<S>,
}

impl<S: Space> PathBuf<S> {
    /// The empty set.
    pub const fn new() -> Self {
        PathBuf { points: Vec::new(), ends: Vec::new(), space: PhantomData }
    }

    /// Removes all paths and keeps the memory.
    pub fn clear(&mut self) {
        self.points.clear();
        self.ends.clear();
    }

    /// Adds a point to the path being built.
    #[inline]
    pub fn push(&mut self, p: DVec2) {
        self.points.push(p);
    }

    /// Where the path being built starts.
    pub fn start(&self) -> usize {
        self.ends.last().map_or(0, |&e| e as usize)
    }

    /// Ends the path being built; a path without points is not recorded.
    pub fn end(&mut self) {
        if self.points.len() > self.start() {
            self.ends.push(self.points.len() as u32);
        }
    }

    /// Ends the path being built if it has at least `least` points, else takes its points back.
    pub fn end_or_drop(&mut self, least: usize) {
        let start = self.start();
        if self.points.len() >= start + least {
            self.ends.push(self.points.len() as u32);
        } else {
            self.points.truncate(start);
        }
    }

    /// Adds a whole path.
    pub fn add(&mut self, path: impl IntoIterator<Item = DVec2>) {
        self.points.extend(path);
        self.end();
    }

    /// Adds the images of all `paths` under `map`.
    pub fn add_mapped<A: Space>(&mut self, paths: Paths<'_, A>, map: &Map<A, S>) {
        let offset = self.points.len() as u32;
        self.points.extend(paths.points.iter().map(|&p| map.0.transform_point2(p)));
        self.ends.extend(paths.ends.iter().map(|&e| e + offset));
    }

    /// Adds all `paths` as they are.
    pub fn add_all(&mut self, paths: Paths<'_, S>) {
        let offset = self.points.len() as u32;
        self.points.extend_from_slice(paths.points);
        self.ends.extend(paths.ends.iter().map(|&e| e + offset));
    }

    /// Adds paths that come piece by piece.
    pub fn add_pieces(&mut self, paths: &impl Pieces) {
        let done = paths.pieces::<Infallible>(|piece| {
            self.points.extend_from_slice(piece.points);
            if piece.ends {
                self.end();
            }
            Ok(())
        });
        let Ok(()) = done;
    }

    /// The set as a borrowed one.
    #[inline]
    pub fn as_paths(&self) -> Paths<'_, S> {
        Paths::new(&self.points, &self.ends)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ndc;

    #[test]
    fn paths_are_cut_at_their_ends() {
        let mut set = PathBuf::<Ndc>::new();
        set.add([DVec2::ZERO, DVec2::ONE]);
        set.add([]);
        set.push(DVec2::X);
        set.end_or_drop(2);
        set.add([DVec2::Y]);
        let lengths: Vec<usize> = set.as_paths().iter().map(<[DVec2]>::len).collect();
        assert_eq!(lengths, [2, 1]);
        assert_eq!(set.as_paths().bounds(), Some(Rect::UNIT));
    }
}
