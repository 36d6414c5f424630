//! Wide lines as polygons: a rectangle for each segment, and what joins and ends them
//! (J. D. Foley, A. van Dam, S. K. Feiner and J. F. Hughes, "Computer Graphics: Principles and Practice", 2nd ed.,
//! 1990, section 3.9).

use gks_algorithms::ellipse::flatten;
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;
use std::f64::consts::TAU;

/// The largest deviation of the polygon that stands for a disc, in pixels.
const TOLERANCE: f64 = 0.1;

/// The width, ends and corners of a line.
#[derive(Copy, Clone, Debug)]
pub(super) struct Shape {
    /// The width.
    pub(super) width: f64,
    /// The ends.
    pub(super) cap: Cap,
    /// The corners, mitred up to ten widths.
    pub(super) join: Join,
}

impl Shape {
    /// Gives the convex polygons that make up a line through points none of which equals its neighbour. They
    /// overlap; a single point gives a dot.
    pub(super) fn polygons(&self, path: &[DVec2], mut polygon: impl FnMut(&[DVec2])) {
        let half = self.width * 0.5;
        let mut disc = Vec::new();
        let (x, y) = (DVec2::new(half, 0.0), DVec2::new(0.0, half));
        flatten(DVec2::ZERO, x, y, 0.0, TAU, TOLERANCE, &mut disc);
        let disc = |at: DVec2, polygon: &mut dyn FnMut(&[DVec2])| {
            polygon(&disc.iter().map(|&p| p + at).collect::<Vec<_>>());
        };
        let &[first, .., last] = path else {
            if let Some(&dot) = path.first() {
                match self.cap {
                    Cap::Round => disc(dot, &mut polygon),
                    _ => polygon(&[dot - x - y, dot + x - y, dot + x + y, dot - x + y]),
                }
            }
            return;
        };
        let closed = path.len() > 3 && first == last;
        let reach = if self.cap == Cap::Projecting && !closed { half } else { 0.0 };
        let direction = |segment: &[DVec2]| (segment[1] - segment[0]).normalize_or_zero();
        let mut before = if closed { Some(direction(&path[path.len() - 2..])) } else { None };
        for (i, segment) in path.windows(2).enumerate() {
            let along = direction(segment);
            let side = along.perp() * half;
            let a = if i == 0 { segment[0] - along * reach } else { segment[0] };
            let b = if i + 2 == path.len() { segment[1] + along * reach } else { segment[1] };
            polygon(&[a + side, b + side, b - side, a - side]);
            if let Some(before) = before {
                match self.join {
                    Join::Round => disc(segment[0], &mut polygon),
                    _ => self.corner(segment[0], before, along, &mut polygon),
                }
            }
            before = Some(along);
        }
        if self.cap == Cap::Round && !closed {
            disc(first, &mut polygon);
            disc(last, &mut polygon);
        }
    }

    /// The corner at a point where the line turns from one direction to another, on the outer side.
    fn corner(&self, at: DVec2, before: DVec2, after: DVec2, polygon: &mut dyn FnMut(&[DVec2])) {
        let turn = before.perp_dot(after);
        if turn == 0.0 {
            return;
        }
        let outwards = -turn.signum() * self.width * 0.5;
        let (a, b) = (before.perp() * outwards, after.perp() * outwards);
        // The miter is 1 / cos of half the turning angle times as long as the line is wide.
        let cos = before.dot(after);
        if self.join == Join::Miter && (1.0 + cos) * 0.5 >= 0.01 {
            polygon(&[at, at + a, at + (a + b) / (1.0 + cos), at + b]);
        } else {
            polygon(&[at, at + a, at + b]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_algorithms::fill::EdgeTable;
    use gks_algorithms::path::Rule;
    use gks_algorithms::rect::IRect;

    fn picture(path: &[(f64, f64)], width: f64, cap: Cap, join: Join) -> Vec<String> {
        let path: Vec<DVec2> = path.iter().map(|&p| p.into()).collect();
        let mut rows = vec![vec!['.'; 12]; 8];
        let mut table = EdgeTable::new();
        Shape { width, cap, join }.polygons(&path, |ring| {
            table.spans(ring, &[ring.len() as u32], Rule::NonZero, IRect::of_size(12, 8), |y, from, to| {
                rows[y as usize][from as usize..to as usize].fill('#');
            });
        });
        rows.into_iter().map(|row| row.into_iter().collect()).collect()
    }

    #[test]
    fn ends() {
        let line = [(3.0, 4.0), (9.0, 4.0)];
        let row = |cap| picture(&line, 4.0, cap, Join::Miter)[3].clone();
        assert_eq!(row(Cap::Butt), "...######...");
        assert_eq!(row(Cap::Projecting), ".##########.");
        let round = picture(&line, 4.0, Cap::Round, Join::Miter);
        assert_eq!(
            round,
            [
                "............",
                "............",
                "..########..",
                ".##########.",
                ".##########.",
                "..########..",
                "............",
                "............"
            ]
        );
    }

    #[test]
    fn corners() {
        let angle = [(2.2, 8.0), (2.2, 2.2), (12.0, 2.2)];
        let top = |join| picture(&angle, 4.0, Cap::Butt, join)[..3].to_vec();
        assert_eq!(top(Join::Miter), ["############", "############", "############"]);
        assert_eq!(top(Join::Bevel), ["..##########", ".###########", "############"].map(String::from));
        assert_eq!(top(Join::Round), [".###########", "############", "############"].map(String::from));
    }

    #[test]
    fn a_closed_line_has_no_ends_and_a_sharp_corner_no_miter() {
        let ring = [(3.0, 2.0), (9.0, 2.0), (9.0, 6.0), (3.0, 6.0), (3.0, 2.0)];
        let closed = picture(&ring, 2.0, Cap::Butt, Join::Miter);
        assert_eq!(closed[1], "..########..");
        assert_eq!(closed[3], "..##....##..");
        let mut reach = 0.0f64;
        let sharp = [DVec2::ZERO, DVec2::new(100.0, 0.0), DVec2::new(0.0, 1.0)];
        Shape { width: 2.0, cap: Cap::Butt, join: Join::Miter }
            .polygons(&sharp, |ring| reach = ring.iter().fold(reach, |far, p| far.max(p.x)));
        assert!(reach < 101.1, "{reach}");
    }

    #[test]
    fn a_dot_is_square_or_round() {
        let square = picture(&[(4.0, 4.0)], 4.0, Cap::Butt, Join::Miter);
        assert_eq!(square[2], "..####......");
        let round = picture(&[(4.0, 4.0)], 4.0, Cap::Round, Join::Miter);
        assert_eq!((&*round[2], &*round[3]), ("...##.......", "..####......"));
        assert_eq!(picture(&[], 4.0, Cap::Round, Join::Miter), ["............"; 8]);
    }
}
