//! G.-Z. Wang, "The subdivision method for finding the intersection between two Bezier curves or surfaces", Zhejiang
//! University Journal, 1984; R. N. Goldman, "Pyramid Algorithms", Morgan Kaufmann 2003, section 5.6.3: how many chords a
//! Bezier curve needs.

use crate::path::is_usable;
use crate::rect::Rect;
use glam::DVec2;

/// The most chords a curve is given, however small the tolerance.
const MOST_CHORDS: f64 = 16_384.0;

/// The most chords of a chain of curves, besides one for each.
const MOST_OF_A_CHAIN: f64 = 262_144.0;

/// The most chords of a piece of a curve that are made without asking which of them are seen.
const AT_ONCE: u32 = 32;
/// How often a curve is halved at most to find what of it is seen: a piece is as small then as the last digit of a coordinate.
const MOST_HALVINGS: u32 = 52;

/// Appends the points of a quadratic Bezier curve after its first, no chord farther from it than the tolerance.
///
/// The last point is the end as given. A curve with a control point that is not usable is taken as the straight line to
/// its end. There are at most 16384 chords.
pub fn quadratic(curve: [DVec2; 3], tolerance: f64, points: &mut Vec<DVec2>) {
    let [a, b, c] = curve;
    let chords = chords(quadratic_bulge(&curve), tolerance, &curve);
    for i in 1..chords {
        let t = f64::from(i) / f64::from(chords);
        let s = 1.0 - t;
        points.push(a * (s * s) + b * (2.0 * s * t) + c * (t * t));
    }
    points.push(c);
}

/// Appends the points of a cubic Bezier curve after its first; in all else as [`quadratic`].
pub fn cubic(curve: [DVec2; 4], tolerance: f64, points: &mut Vec<DVec2>) {
    let [a, b, c, d] = curve;
    let chords = chords(cubic_bulge(&curve), tolerance, &curve);
    for i in 1..chords {
        let t = f64::from(i) / f64::from(chords);
        let s = 1.0 - t;
        points.push(a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t));
    }
    points.push(d);
}

/// Appends the points of a quadratic Bezier curve after its first as far as they make a difference inside of a rectangle:
/// what lies beyond one of its sides is as good as straight.
pub fn quadratic_within(seen: Rect, curve: [DVec2; 3], tolerance: f64, points: &mut Vec<DVec2>) {
    let is_simple = |curve: &[DVec2; 3]| chords(quadratic_bulge(curve), tolerance, curve) <= AT_ONCE;
    seen_pieces(seen, curve, &is_simple, MOST_HALVINGS, &mut |piece| match piece {
        Piece::Seen(curve) => quadratic(curve, tolerance, points),
        Piece::Hidden(end) => points.push(end),
    });
}

/// Appends the points of a cubic Bezier curve after its first; in all else as [`quadratic_within`].
pub fn cubic_within(seen: Rect, curve: [DVec2; 4], tolerance: f64, points: &mut Vec<DVec2>) {
    let is_simple = |curve: &[DVec2; 4]| chords(cubic_bulge(curve), tolerance, curve) <= AT_ONCE;
    seen_pieces(seen, curve, &is_simple, MOST_HALVINGS, &mut |piece| match piece {
        Piece::Seen(curve) => cubic(curve, tolerance, points),
        Piece::Hidden(end) => points.push(end),
    });
}

/// A piece of a curve: its control points, or its end where it lies beyond a side of the rectangle that is seen.
enum Piece<const N: usize> {
    Seen([DVec2; N]),
    Hidden(DVec2),
}

/// Halves a curve by P. de Casteljau's construction until its pieces are simple or hidden.
fn seen_pieces<const N: usize>(
    seen: Rect,
    curve: [DVec2; N],
    is_simple: &impl Fn(&[DVec2; N]) -> bool,
    halvings: u32,
    give: &mut impl FnMut(Piece<N>),
) {
    let (low, high) = curve.iter().fold((curve[0], curve[0]), |(low, high), &p| (low.min(p), high.max(p)));
    // A curve stays inside of the bounds of its control points.
    if low.cmpgt(seen.1).any() || high.cmplt(seen.0).any() || halvings == 0 {
        return give(Piece::Hidden(curve[N - 1]));
    }
    if is_simple(&curve) {
        return give(Piece::Seen(curve));
    }
    let (mut first, mut second, mut between) = (curve, curve, curve);
    for i in 0..N {
        (first[i], second[N - 1 - i]) = (between[0], between[N - 1 - i]);
        for j in 0..N - 1 - i {
            between[j] = between[j].midpoint(between[j + 1]);
        }
    }
    seen_pieces(seen, first, is_simple, halvings - 1, give);
    seen_pieces(seen, second, is_simple, halvings - 1, give);
}

/// Appends the points of a chain of cubic Bezier pieces, the first included.
///
/// Control points too few to make a piece at the end are left out. A chain that would need more chords than 262144 and
/// one for each piece gets a greater tolerance.
pub fn chain(control: &[DVec2], tolerance: f64, points: &mut Vec<DVec2>) {
    let Some(&first) = control.first() else { return };
    points.push(first);
    let pieces = || {
        let starts = control.iter().step_by(3);
        starts.zip(control[1..].chunks_exact(3)).map(|(from, piece)| [*from, piece[0], piece[1], piece[2]])
    };
    let usable = |piece: &[DVec2; 4]| piece.iter().copied().all(is_usable);
    let roots: f64 = pieces().filter(usable).map(|piece| cubic_bulge(&piece).sqrt()).sum();
    let tolerance = tolerance.max((roots / MOST_OF_A_CHAIN).powi(2));
    pieces().for_each(|piece| cubic(piece, tolerance, points));
}

/// How far a single chord would stray from a quadratic curve at most.
fn quadratic_bulge([a, b, c]: &[DVec2; 3]) -> f64 {
    2.0 * (a - b - b + c).length() / 8.0
}

/// How far a single chord would stray from a cubic curve at most.
fn cubic_bulge([a, b, c, d]: &[DVec2; 4]) -> f64 {
    let bend = (a - b - b + c).length().max((b - c - c + d).length());
    6.0 * bend / 8.0
}

/// Wang's bound: n chords stray by no more than d (d - 1) / 8 of the greatest second difference, divided by n².
fn chords(bulge: f64, tolerance: f64, curve: &[DVec2]) -> u32 {
    if !curve.iter().copied().all(is_usable) || bulge == 0.0 {
        return 1;
    }
    (bulge / tolerance.max(0.0)).sqrt().ceil().clamp(1.0, MOST_CHORDS) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;

    fn strays(p: DVec2, line: &[DVec2]) -> f64 {
        let to = |w: &[DVec2]| {
            let u = w[1] - w[0];
            let t = ((p - w[0]).dot(u) / u.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            p.distance(w[0] + u * t)
        };
        line.windows(2).map(to).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn chords_stay_within_the_tolerance() {
        let mut random = Xorshift::new(14);
        for _ in 0..100 {
            let p: [DVec2; 4] = std::array::from_fn(|_| random.point(-50.0, 50.0));
            let tolerance = random.real(0.01, 2.0);
            let mut lines = [vec![p[0]], vec![p[0]]];
            quadratic([p[0], p[1], p[2]], tolerance, &mut lines[0]);
            cubic(p, tolerance, &mut lines[1]);
            assert_eq!((lines[0].last(), lines[1].last()), (Some(&p[2]), Some(&p[3])));
            for i in 0..=200 {
                let t = f64::from(i) / 200.0;
                // De Casteljau's construction, independent of the polynomials above.
                let q: [DVec2; 3] = std::array::from_fn(|i| p[i].lerp(p[i + 1], t));
                let r: [DVec2; 2] = std::array::from_fn(|i| q[i].lerp(q[i + 1], t));
                assert!(strays(r[0], &lines[0]) <= tolerance + 1e-9);
                assert!(strays(r[0].lerp(r[1], t), &lines[1]) <= tolerance + 1e-9);
            }
        }
    }

    #[test]
    fn the_number_of_chords_grows_with_the_root() {
        let curve = [DVec2::ZERO, DVec2::new(50.0, 100.0), DVec2::new(100.0, 0.0)];
        let count = |tolerance: f64| {
            let mut points = vec![];
            quadratic(curve, tolerance, &mut points);
            points.len()
        };
        assert_eq!((count(50.0), count(0.5), count(0.005)), (1, 10, 100));
        assert_eq!((count(0.0), count(f64::NAN), count(-1.0)), (16_384, 16_384, 16_384));
    }

    #[test]
    fn hidden_pieces_are_straight_and_the_others_as_close_as_ever() {
        let mut random = Xorshift::new(15);
        let seen = (DVec2::splat(-10.0), DVec2::splat(10.0));
        let inside = |p: &DVec2| p.abs().max_element() <= 10.0;
        for far in [20.0, 1e4, 1e8] {
            for _ in 0..50 {
                let p: [DVec2; 4] = std::array::from_fn(|_| random.point(-far, far));
                let (mut whole, mut part) = (vec![p[0]], vec![p[0]]);
                cubic(p, 0.1, &mut whole);
                cubic_within(seen, p, 0.1, &mut part);
                assert!(part.len() < 2000 && part.last() == Some(&p[3]), "{} points", part.len());
                if whole.len() < 16_000 {
                    assert!(whole.iter().filter(|p| inside(p)).all(|p| strays(*p, &part) < 0.11));
                }
                let (mut whole, mut part) = (vec![p[0]], vec![p[0]]);
                quadratic([p[0], p[1], p[2]], 0.1, &mut whole);
                quadratic_within(seen, [p[0], p[1], p[2]], 0.1, &mut part);
                assert!(part.len() < 2000 && part.last() == Some(&p[2]));
                if whole.len() < 16_000 {
                    assert!(whole.iter().filter(|p| inside(p)).all(|p| strays(*p, &part) < 0.11));
                }
            }
        }
        let mut points = vec![];
        cubic_within(seen, [DVec2::splat(-1e300), DVec2::NAN, DVec2::MAX, DVec2::ONE], 0.1, &mut points);
        quadratic_within(seen, [DVec2::ZERO, DVec2::splat(1e140), DVec2::ONE], 0.0, &mut points);
        assert!(points.len() < 5000 && points.last() == Some(&DVec2::ONE), "{}", points.len());
    }

    #[test]
    fn straight_and_bad_curves_are_one_chord() {
        let mut points = vec![];
        cubic([0.0, 1.0, 2.0, 3.0].map(DVec2::splat), 0.0, &mut points);
        quadratic([DVec2::ZERO, DVec2::NAN, DVec2::ONE], 0.1, &mut points);
        assert_eq!(points, [DVec2::splat(3.0), DVec2::ONE]);
    }

    #[test]
    fn a_chain_of_huge_pieces_gets_fewer_chords_for_each() {
        let piece = [DVec2::new(1e6, 1e6), DVec2::new(-1e6, 1e6), DVec2::ZERO];
        let control: Vec<DVec2> = std::iter::once(DVec2::ZERO).chain(piece.repeat(200)).collect();
        let count = |pieces: usize| {
            let mut points = Vec::new();
            chain(&control[..=3 * pieces], 1e-6, &mut points);
            points.len() - 1
        };
        assert_eq!(count(1), MOST_CHORDS as usize);
        let most = MOST_OF_A_CHAIN as usize;
        assert!((most - most / 100..=most + 200).contains(&count(200)), "{}", count(200));
    }

    #[test]
    fn a_chain_runs_on_and_drops_the_rest() {
        let control: Vec<DVec2> = (0..9).map(|i| DVec2::splat(f64::from(i))).collect();
        let mut points = vec![];
        chain(&control, 0.1, &mut points);
        chain(&[], 0.1, &mut points);
        assert_eq!(points, [0.0, 3.0, 6.0].map(DVec2::splat));
    }
}
