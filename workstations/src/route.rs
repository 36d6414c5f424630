//! Paths on their way to a document: points become whole steps, and what cannot be seen is left out.
//!
//! Points that fall upon their predecessor are dropped, paths that end where they started are closed, and those
//! that never leave their first step are dots. What is given up on request, and only of lines, are points within
//! a tolerance of the line that remains.

use crate::number::{Decimal, nearest};
use gks_algorithms::line::{m4, sklansky_gonzalez};
use gks_geometry::{Piece, Pieces};
use gks_pipeline::device::DeviceError;
use glam::DVec2;

/// How a format draws paths; positions are in steps.
pub(crate) trait Track {
    /// Goes to the first point of a path.
    fn start(&mut self, at: [i64; 2]) -> Result<(), DeviceError>;

    /// Draws a line from one point to another one.
    fn line(&mut self, from: [i64; 2], to: [i64; 2]) -> Result<(), DeviceError>;

    /// Completes a path, with a line to its first point if it is closed.
    fn finish(&mut self, closed: bool) -> Result<(), DeviceError>;
}

/// Leads paths to a [`Track`].
pub(crate) struct Route {
    /// How many steps make a device unit.
    scale: f64,
    /// How far the points left out may lie off, in device units.
    tolerance: f64,
    /// The first point of the path.
    first: DVec2,
    /// Where the path is.
    last: [i64; 2],
    /// How many points the path has had so far, not counted beyond those that a closed path needs.
    count: usize,
    /// Whether the path has left its first step.
    started: bool,
    /// The paths that are dots.
    pub(crate) dots: Vec<[i64; 2]>,
    columns: Vec<DVec2>,
    reduced: Vec<DVec2>,
}

impl Route {
    /// For a format with steps of `decimal`, for which points of lines within `tolerance` may be left out.
    pub(crate) fn new(decimal: Decimal, tolerance: f64) -> Self {
        Route {
            scale: decimal.scale(),
            tolerance,
            first: DVec2::ZERO,
            last: [0; 2],
            count: 0,
            started: false,
            dots: Vec::new(),
            columns: Vec::new(),
            reduced: Vec::new(),
        }
    }

    /// Leads lines; paths that are dots are collected in `dots`, which is empty before.
    pub(crate) fn lines(&mut self, paths: &impl Pieces, track: &mut impl Track) -> Result<(), DeviceError> {
        self.dots.clear();
        if self.tolerance > 0.0 {
            return paths.pieces(|piece| self.reduce(piece, track));
        }
        paths.pieces(|piece| self.piece(piece, track))
    }

    /// Leads rings, which are closed; those that are dots are left out.
    pub(crate) fn rings<'p>(
        &mut self,
        rings: impl Iterator<Item = &'p [DVec2]>,
        track: &mut impl Track,
    ) -> Result<(), DeviceError> {
        for ring in rings {
            let Some((&first, rest)) = ring.split_first() else { continue };
            self.set_out(first);
            let rest = rest.strip_suffix(&[first]).unwrap_or(rest);
            self.follow(rest, track)?;
            if self.started {
                track.finish(true)?;
            }
        }
        Ok(())
    }

    fn set_out(&mut self, first: DVec2) {
        self.first = first;
        self.last = self.steps(first);
        self.count = 0;
        self.started = false;
    }

    #[inline]
    fn steps(&self, point: DVec2) -> [i64; 2] {
        [nearest(point.x, self.scale), nearest(point.y, self.scale)]
    }

    fn piece(&mut self, piece: Piece<'_>, track: &mut impl Track) -> Result<(), DeviceError> {
        let mut points = piece.points;
        if piece.starts {
            self.set_out(points[0]);
        }
        self.count = self.count.saturating_add(points.len());
        let closed = piece.ends && self.count > 3 && points.last() == Some(&self.first);
        if closed {
            points = &points[..points.len() - 1];
        }
        self.follow(points, track)?;
        if !piece.ends {
            return Ok(());
        }
        if self.started {
            track.finish(closed)
        } else {
            self.dots.push(self.last);
            Ok(())
        }
    }

    #[inline]
    fn follow(&mut self, points: &[DVec2], track: &mut impl Track) -> Result<(), DeviceError> {
        let mut last = self.last;
        for &point in points {
            let next = self.steps(point);
            if next == last {
                continue;
            }
            if !self.started {
                self.started = true;
                track.start(last)?;
            }
            track.line(last, next)?;
            last = next;
        }
        self.last = last;
        Ok(())
    }

    /// Leaves out points of a piece, but neither its first nor its last one: those of columns first, whose
    /// deviation is that of noise, then those of what is nearly straight.
    fn reduce(&mut self, piece: Piece<'_>, track: &mut impl Track) -> Result<(), DeviceError> {
        let (mut columns, mut reduced) =
            (std::mem::take(&mut self.columns), std::mem::take(&mut self.reduced));
        columns.clear();
        reduced.clear();
        let half = self.tolerance / 2.0;
        m4(piece.points.iter().copied(), half, |p| columns.push(p));
        sklansky_gonzalez(columns.iter().copied(), half, |p| reduced.push(p));
        let done = self.piece(Piece { points: &reduced, ..piece }, track);
        self.columns = columns;
        self.reduced = reduced;
        done
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::{Du, PathBuf};
    use std::fmt::Write;

    /// Writes down what is drawn.
    #[derive(Default)]
    struct Diary(String);

    impl Track for Diary {
        fn start(&mut self, at: [i64; 2]) -> Result<(), DeviceError> {
            let _ = write!(self.0, "{at:?}");
            Ok(())
        }

        fn line(&mut self, _: [i64; 2], to: [i64; 2]) -> Result<(), DeviceError> {
            let _ = write!(self.0, "-{to:?}");
            Ok(())
        }

        fn finish(&mut self, closed: bool) -> Result<(), DeviceError> {
            self.0.push_str(if closed { "-z " } else { " " });
            Ok(())
        }
    }

    fn set(paths: &[&[(f64, f64)]]) -> PathBuf<Du> {
        let mut set = PathBuf::new();
        paths.iter().for_each(|path| set.add(path.iter().map(|&p| DVec2::from(p))));
        set
    }

    fn lines(tolerance: f64, paths: &PathBuf<Du>) -> (String, Vec<[i64; 2]>) {
        let (mut route, mut diary) = (Route::new(Decimal::new(1), tolerance), Diary::default());
        route.lines(&paths.as_paths(), &mut diary).unwrap();
        (diary.0, route.dots)
    }

    #[test]
    fn what_is_drawn_are_different_steps_closed_paths_and_dots() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.0)];
        let back = [(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)];
        let slow = [(0.0, 0.0), (0.04, 0.0), (0.06, 0.0), (0.06, 0.01), (0.12, 0.0)];
        let (text, dots) = lines(0.0, &set(&[&square, &[(2.0, 3.0)], &back, &[(4.0, 4.0); 9], &slow]));
        assert_eq!(text, "[0, 0]-[10, 0]-[10, 10]-z [0, 0]-[10, 0]-[0, 0] [0, 0]-[1, 0] ");
        assert_eq!(dots, [[20, 30], [40, 40]]);
    }

    #[test]
    fn rings_are_closed_once() {
        let ring = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)];
        let closed = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.0)];
        let (mut route, mut diary) = (Route::new(Decimal::new(0), 9.0), Diary::default());
        let rings = set(&[&ring, &closed, &[(7.0, 7.0), (7.0, 7.1), (7.1, 7.0)]]);
        route.rings(rings.as_paths().iter(), &mut diary).unwrap();
        assert_eq!(diary.0, "[0, 0]-[1, 0]-[1, 1]-z [0, 0]-[1, 0]-[1, 1]-z ");
    }

    #[test]
    fn reduction_leaves_few_points_and_no_deviation_beyond_the_tolerance() {
        let wave: Vec<(f64, f64)> = (0..10_000)
            .map(|i| f64::from(i) * 0.01)
            .map(|x| (x, 20.0 * (x * 0.3).sin() + (x * 999.0).sin()))
            .collect();
        let exact = lines(0.0, &set(&[&wave])).0.matches('-').count();
        let (text, _) = lines(0.5, &set(&[&wave]));
        let few = text.matches('[').count();
        assert!(few < exact / 3 && few > 100, "{few} of {exact}");
        let points: Vec<DVec2> = text
            .trim()
            .split("]-[")
            .map(|p| p.trim_matches(['[', ']']).split_once(", ").unwrap())
            .map(|(x, y)| DVec2::new(x.parse().unwrap(), y.parse().unwrap()) / 10.0)
            .collect();
        assert!((points[0] - DVec2::from(wave[0])).length() < 0.1);
        for p in wave.iter().map(|&p| DVec2::from(p)) {
            let off = points.windows(2).map(|w| {
                let along = w[1] - w[0];
                let t = ((p - w[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                (w[0] + along * t).distance(p)
            });
            let off = off.fold(f64::INFINITY, f64::min);
            assert!(off <= 0.5 + 0.08, "{p} lies {off} off");
        }
    }
}
