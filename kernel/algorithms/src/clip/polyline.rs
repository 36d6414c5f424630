//! After the outcodes of Cohen and Sutherland and the cut of Liang and Barsky (1984): the pieces of a polyline inside a
//! rectangle.

use super::cohen_sutherland::outcode;
use super::liang_barsky;
use crate::path::{end_subpath, is_usable};
use crate::rect::Rect;
use glam::DVec2;

/// Appends the pieces of a polyline that lie inside the rectangle.
///
/// Vertices inside are kept bit for bit and in one piece as long as the line stays inside. A line that only touches the
/// rectangle from outside leaves nothing; two equal vertices inside are kept, as is a path of a single point. The line
/// is broken at a vertex that is not usable.
pub fn polyline(rect: Rect, path: &[DVec2], points: &mut Vec<DVec2>, ends: &mut Vec<u32>) {
    if let &[dot] = path {
        if is_usable(dot) && outcode(rect, dot) == 0 {
            points.push(dot);
            end_subpath(points, ends);
        }
        return;
    }
    let seen = |p: DVec2| if is_usable(p) { outcode(rect, p) } else { u8::MAX };
    let Some(&first) = path.first() else { return };
    let (mut last, mut last_code) = (first, seen(first));
    let mut drawing = false;
    for &p in &path[1..] {
        let code = seen(p);
        if last_code | code == 0 {
            if !drawing {
                points.push(last);
            }
            points.push(p);
            drawing = true;
        } else {
            let cut = if last_code & code == 0 { liang_barsky(rect, last, p) } else { None };
            if let Some((start, end)) = cut.filter(|(start, end)| start != end) {
                if !drawing {
                    points.push(start);
                }
                points.push(end);
                drawing = true;
            }
            if drawing && code != 0 {
                end_subpath(points, ends);
                drawing = false;
            }
        }
        (last, last_code) = (p, code);
    }
    if drawing {
        end_subpath(points, ends);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::subpaths;
    use crate::xorshift::Xorshift;

    const RECT: Rect = (DVec2::ZERO, DVec2::new(10.0, 10.0));

    fn clipped(path: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
        let path: Vec<DVec2> = path.iter().map(|&p| p.into()).collect();
        let (mut points, mut ends) = (vec![], vec![]);
        polyline(RECT, &path, &mut points, &mut ends);
        assert_eq!(ends.last().copied().unwrap_or(0) as usize, points.len());
        subpaths(&points, &ends).map(|piece| piece.iter().map(|&p| p.into()).collect()).collect()
    }

    #[test]
    fn one_piece_while_inside() {
        let line = [(1.0, 1.0), (2.0, 5.0), (2.0, 5.0), (9.0, 9.0)];
        assert_eq!(clipped(&line), [line]);
    }

    #[test]
    fn leaving_and_coming_back_makes_two_pieces() {
        let pieces = clipped(&[(5.0, 5.0), (15.0, 5.0), (15.0, 7.0), (5.0, 7.0), (-5.0, 7.0)]);
        assert_eq!(pieces, [vec![(5.0, 5.0), (10.0, 5.0)], vec![(10.0, 7.0), (5.0, 7.0), (0.0, 7.0)]]);
    }

    #[test]
    fn a_vertex_on_the_edge_joins_but_does_not_double() {
        assert_eq!(clipped(&[(-5.0, 5.0), (0.0, 5.0), (5.0, 5.0)]), [[(0.0, 5.0), (5.0, 5.0)]]);
        assert_eq!(clipped(&[(5.0, 5.0), (10.0, 5.0), (5.0, 6.0)]), [[(5.0, 5.0), (10.0, 5.0), (5.0, 6.0)]]);
        assert_eq!(clipped(&[(5.0, 5.0), (10.0, 5.0), (20.0, 5.0)]), [[(5.0, 5.0), (10.0, 5.0)]]);
        assert_eq!(clipped(&[(-5.0, 5.0), (0.0, 5.0), (-5.0, 6.0)]), [[(0.0, 0.0); 0]; 0]);
        assert_eq!(clipped(&[(-5.0, 5.0), (5.0, -5.0)]), [[(0.0, 0.0); 0]; 0]);
    }

    #[test]
    fn a_bad_vertex_breaks_the_line() {
        let pieces = clipped(&[(1.0, 1.0), (2.0, 2.0), (f64::NAN, 3.0), (4.0, 4.0), (5.0, 5.0)]);
        assert_eq!(pieces, [[(1.0, 1.0), (2.0, 2.0)], [(4.0, 4.0), (5.0, 5.0)]]);
        assert_eq!(clipped(&[(f64::INFINITY, 1.0), (2.0, 2.0)]), [[(0.0, 0.0); 0]; 0]);
    }

    #[test]
    fn dots_are_kept_inside_only() {
        assert_eq!(clipped(&[(3.0, 3.0)]), [[(3.0, 3.0)]]);
        assert_eq!(clipped(&[(3.0, 3.0), (3.0, 3.0)]), [[(3.0, 3.0), (3.0, 3.0)]]);
        assert!(clipped(&[(13.0, 3.0)]).is_empty());
        assert!(clipped(&[]).is_empty());
    }

    #[test]
    fn the_length_is_that_of_the_clipped_segments() {
        let mut random = Xorshift::new(5);
        for _ in 0..500 {
            let path: Vec<DVec2> = (0..20).map(|_| random.grid(-8, 18).as_dvec2()).collect();
            let (mut points, mut ends) = (vec![], vec![]);
            polyline(RECT, &path, &mut points, &mut ends);
            let length: f64 =
                subpaths(&points, &ends).flat_map(|p| p.windows(2)).map(|w| w[0].distance(w[1])).sum();
            let cuts = path.windows(2).filter_map(|w| liang_barsky(RECT, w[0], w[1]));
            let expected: f64 = cuts.map(|(a, b)| a.distance(b)).sum();
            assert!((length - expected).abs() < 1e-9);
            let gaps = subpaths(&points, &ends).map(|p| p[0]).skip(1);
            let stops = subpaths(&points, &ends).filter_map(|p| p.last().copied());
            for (stop, go) in stops.zip(gaps) {
                let side = |p: DVec2| p.x == 0.0 || p.y == 0.0 || p.x == 10.0 || p.y == 10.0;
                assert!(side(stop) && side(go));
            }
        }
    }
}
