//! Long dashed lines, whose dashes are not held but for some at a time: for drivers that draw long lines, and for those
//! that refuse them.

use crate::painter::MOST_DASHES;
use gks_algorithms::clip::liang_barsky;
use gks_algorithms::line::Dashes;
use gks_geometry::{Du, LongLine, PathBuf, Paths, Pieces, Rect};
use std::convert::Infallible;

/// As many points of dashes are held at a time.
const HELD: usize = 1 << 16;

/// Gives the dashes of a line that lie inside of a rectangle, many at a time, in order; they begin anew with every path. `held`
/// is where they are held.
pub fn dashes(
    line: &LongLine<'_, Du>,
    pattern: &[f64],
    inside: &Rect<Du>,
    held: &mut PathBuf<Du>,
    mut each: impl FnMut(Paths<'_, Du>),
) {
    let rect = (inside.min.0, inside.max.0);
    held.clear();
    let mut cut = None;
    let done = line.pieces::<Infallible>(|piece| {
        if piece.starts {
            cut = Dashes::new(pattern, 0.0);
        }
        let (points, ends) = (&mut held.points, &mut held.ends);
        if let Some(cut) = &mut cut {
            cut.follow(rect, piece.points, points, ends, usize::MAX);
        }
        if let Some(cut) = cut.take_if(|_| piece.ends) {
            cut.end(points, ends, usize::MAX);
        }
        if held.points.len() >= HELD {
            let start = held.start();
            each(Paths::new(&held.points[..start], &held.ends));
            held.points.drain(..start);
            held.ends.clear();
        }
        Ok(())
    });
    let Ok(()) = done;
    each(held.as_paths());
}

/// Whether a line is to be drawn solid: by a pattern that is none, or because it has more dashes inside of a rectangle than a
/// line is cut into.
pub fn is_solid(line: &LongLine<'_, Du>, pattern: &[f64], inside: &Rect<Du>) -> bool {
    if Dashes::new(pattern, 0.0).is_none() {
        return true;
    }
    let Some(seen) = line.bounds().and_then(|bounds| bounds.intersection(inside)) else { return false };
    let dashes = pattern.len().div_ceil(2) as f64;
    let most = pattern.iter().sum::<f64>() / dashes * MOST_DASHES as f64;
    if (seen.max.0 - seen.min.0).length() * line.len() as f64 <= most {
        return false;
    }
    let rect = (inside.min.0, inside.max.0);
    let (mut length, mut last) = (0.0, None);
    let counted = line.pieces(|piece| {
        for &p in piece.points {
            if let Some((a, b)) = last.and_then(|last| liang_barsky(rect, last, p)) {
                length += a.distance(b);
            }
            last = Some(p);
        }
        last = last.filter(|_| !piece.ends);
        if length > most { Err(()) } else { Ok(()) }
    });
    counted.is_err()
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_algorithms::line::dash;
    use gks_geometry::{Map, Points};

    /// A line of many points, broken in two.
    fn points() -> Vec<(f64, f64)> {
        let noise = |i: u32| f64::from(i * 7919 % 1009) / 1009.0;
        let mut points: Vec<(f64, f64)> =
            (0..100_000).map(|i| (f64::from(i) * 0.001, 100.0 * noise(i))).collect();
        points[70_001].1 = f64::NAN;
        points
    }

    #[test]
    fn dashes_of_a_long_line_are_those_of_its_paths() {
        let points = points();
        let mut parts = Vec::new();
        let line = LongLine::new(Points::from(&points), Map::IDENTITY, &mut parts).mapped(&Map::IDENTITY);
        let inside = Rect::new(5.0, 90.0, 10.0, 80.0);
        let (mut paths, mut expected, mut found) =
            (PathBuf::<Du>::new(), PathBuf::<Du>::new(), PathBuf::new());
        paths.add_pieces(&line);
        let pattern = [20.0, 3.0];
        for path in paths.as_paths().iter() {
            let rect = (inside.min.0, inside.max.0);
            dash(rect, path, &pattern, 0.0, usize::MAX, &mut expected.points, &mut expected.ends);
        }
        let mut most = 0;
        dashes(&line, &pattern, &inside, &mut PathBuf::new(), |paths| {
            most = most.max(paths.points.len());
            found.add_mapped(paths, &Map::<Du, Du>::IDENTITY);
        });
        assert!(found.points.len() > 2 * HELD && most < 2 * HELD, "{most} of {}", found.points.len());
        assert!(found == expected);
    }

    #[test]
    fn lines_of_too_many_dashes_and_of_no_pattern_are_solid() {
        let points = points();
        let mut parts = Vec::new();
        let line = LongLine::new(Points::from(&points), Map::IDENTITY, &mut parts).mapped(&Map::IDENTITY);
        let all = Rect::new(0.0, 100.0, 0.0, 100.0);
        // The line is some 2,580,000 long.
        assert!(!is_solid(&line, &[0.17, 0.1], &all));
        assert!(is_solid(&line, &[0.15, 0.1], &all));
        assert!(!is_solid(&line, &[0.15, 0.1], &Rect::new(0.0, 50.0, 0.0, 100.0)));
        assert!(!is_solid(&line, &[0.15, 0.1], &Rect::new(200.0, 250.0, 0.0, 100.0)));
        assert!(is_solid(&line, &[0.0, 0.0], &all) && is_solid(&line, &[], &all));
    }
}
