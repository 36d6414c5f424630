//! Clipping: what of a segment, a polyline or a ring lies inside a rectangle, a convex polygon or a sector of an ellipse.
//!
//! [`cohen_sutherland`], [`liang_barsky`] and [`nicholl_lee_nicholl`] do the same job with the same signature. For all
//! of them the boundary is inside, points that are inside come back bit for bit, cut points lie exactly on the side that
//! cut them, and a segment with a point that is not usable (see [`crate::path::is_usable`]) is not visible.

mod cohen_sutherland;
mod cyrus_beck;
mod elliptic_sector;
mod liang_barsky;
mod nicholl_lee_nicholl;
mod polyline;
mod sutherland_hodgman;

pub use cohen_sutherland::cohen_sutherland;
pub use cyrus_beck::cyrus_beck;
pub use elliptic_sector::EllipticSector;
pub use liang_barsky::liang_barsky;
pub use nicholl_lee_nicholl::nicholl_lee_nicholl;
pub use polyline::polyline;
pub use sutherland_hodgman::{sutherland_hodgman, sutherland_hodgman_convex};

use crate::rect::Rect;
use glam::DVec2;

/// Where segment a-b, which has ends on both sides of the vertical `x`, meets it.
///
/// The same point comes out for b-a, so that neighbours with a common edge are cut at the same place.
fn meet_vertical(a: DVec2, b: DVec2, x: f64) -> DVec2 {
    let (a, b) = if a.x <= b.x { (a, b) } else { (b, a) };
    let y = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
    DVec2::new(x, y.max(a.y.min(b.y)).min(a.y.max(b.y)))
}

/// Where segment a-b, which has ends on both sides of the horizontal `y`, meets it.
fn meet_horizontal(a: DVec2, b: DVec2, y: f64) -> DVec2 {
    let met = meet_vertical(DVec2::new(a.y, a.x), DVec2::new(b.y, b.x), y);
    DVec2::new(met.y, met.x)
}

/// The point of the rectangle next to `p`.
fn hold((min, max): Rect, p: DVec2) -> DVec2 {
    DVec2::new(p.x.max(min.x).min(max.x), p.y.max(min.y).min(max.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;

    type Clipper = fn(Rect, DVec2, DVec2) -> Option<(DVec2, DVec2)>;

    const CLIPPERS: [(&str, Clipper); 3] = [
        ("cohen_sutherland", cohen_sutherland),
        ("liang_barsky", liang_barsky),
        ("nicholl_lee_nicholl", nicholl_lee_nicholl),
    ];

    const RECT: Rect = (DVec2::new(-3.0, -2.0), DVec2::new(4.0, 3.0));

    fn inside((min, max): Rect, p: DVec2) -> bool {
        min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y
    }

    fn corners((min, max): Rect) -> [DVec2; 4] {
        [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)]
    }

    #[test]
    fn all_agree_on_a_grid() {
        let mut random = Xorshift::new(1);
        let (mut visible, mut hidden) = (0, 0);
        for _ in 0..50_000 {
            let (a, b) = (random.grid(-8, 8).as_dvec2(), random.grid(-8, 8).as_dvec2());
            let expected = cohen_sutherland(RECT, a, b);
            for (name, clip) in CLIPPERS {
                assert_eq!(clip(RECT, a, b), expected, "{name} {a} {b}");
            }
            if expected.is_some() { visible += 1 } else { hidden += 1 }
        }
        assert!(visible > 10_000 && hidden > 10_000);
    }

    #[test]
    fn cuts_lie_on_segment_and_rectangle() {
        let mut random = Xorshift::new(2);
        for _ in 0..50_000 {
            let (a, b) = (random.point(-9.0, 9.0), random.point(-9.0, 9.0));
            for (name, clip) in CLIPPERS {
                let Some((p, q)) = clip(RECT, a, b) else { continue };
                assert!(inside(RECT, p) && inside(RECT, q), "{name} {a} {b}");
                for r in [p, q] {
                    let off = (b - a).perp_dot(r - a) / (b - a).length();
                    assert!(off.abs() < 1e-9, "{name} {a} {b} off by {off}");
                }
                assert!((q - p).dot(b - a) >= 0.0, "{name} turned {a} {b} round");
                assert!(!inside(RECT, a) || p == a);
                assert!(!inside(RECT, b) || q == b);
            }
        }
    }

    #[test]
    fn sampling_finds_no_visible_point_left_out() {
        let mut random = Xorshift::new(3);
        for _ in 0..2_000 {
            let (a, b) = (random.point(-9.0, 9.0), random.point(-9.0, 9.0));
            let within = (RECT.0 + 1e-6, RECT.1 - 1e-6);
            for (name, clip) in CLIPPERS {
                let cut = clip(RECT, a, b);
                for i in 0..=100 {
                    let p = a.lerp(b, f64::from(i) / 100.0);
                    if inside(within, p) {
                        let (s, e) = cut.unwrap_or((DVec2::NAN, DVec2::NAN));
                        assert!(
                            (p - s).dot(b - a) >= -1e-9 && (e - p).dot(b - a) >= -1e-9,
                            "{name} {a} {b} {p}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn huge_bad_and_degenerate_input() {
        let open = (DVec2::NEG_INFINITY, DVec2::INFINITY);
        let empty = (DVec2::ONE, DVec2::ZERO);
        let numbers =
            [0.0, -0.0, 1.0, 0.5, -1e150, 1e150, 1e308, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 5e-324];
        for (name, clip) in CLIPPERS {
            for a in numbers.iter().flat_map(|&x| numbers.map(|y| DVec2::new(x, y))) {
                for b in numbers.iter().flat_map(|&x| numbers.map(|y| DVec2::new(x, y))) {
                    for rect in [RECT, open, (a, b), (DVec2::NAN, DVec2::NAN)] {
                        let _ = clip(rect, a, b);
                    }
                    assert_eq!(clip(empty, a, b), None, "{name} {a} {b}");
                    if crate::path::is_usable(a) && crate::path::is_usable(b) {
                        assert_eq!(clip(open, a, b), Some((a, b)), "{name} {a} {b}");
                    } else {
                        assert_eq!(clip(RECT, a, b), None, "{name} {a} {b}");
                    }
                }
            }
            let far = DVec2::new(1e150, 0.0);
            assert_eq!(clip(RECT, -far, far), Some((DVec2::new(-3.0, 0.0), DVec2::new(4.0, 0.0))), "{name}");
        }
    }

    #[test]
    fn ends_beyond_a_side_are_cut_however_far_the_other_one_is() {
        for far in [1e17_f64, 1e55, 1e150, -1e17, -1e55, -1e150] {
            let near = -9.0 * far.signum();
            let upright = (DVec2::new(1.0, far), DVec2::new(1.0, near));
            let level = (DVec2::new(far, 1.0), DVec2::new(near, 1.0));
            for (name, clip) in CLIPPERS {
                for (a, b) in [upright, level, (upright.1, upright.0), (level.1, level.0)] {
                    let (p, q) = clip(RECT, a, b).expect("it crosses the rectangle");
                    assert!(inside(RECT, p) && inside(RECT, q) && p != q, "{name} {a} {b}: {p} {q}");
                }
            }
        }
    }

    #[test]
    fn nothing_is_left_outside_whatever_the_magnitudes() {
        let mut random = Xorshift::new(8);
        let mut number = || {
            let sign = if random.int(0, 1) == 0 { 1.0 } else { -1.0 };
            let most = if random.int(0, 2) == 0 { 150.0 } else { 2.0 };
            sign * 10f64.powf(random.real(-3.0, most))
        };
        let mut visible = 0;
        for _ in 0..100_000 {
            let (a, b) = (DVec2::new(number(), number()), DVec2::new(number(), number()));
            for (name, clip) in CLIPPERS {
                if let Some((p, q)) = clip(RECT, a, b) {
                    assert!(inside(RECT, p) && inside(RECT, q), "{name} {a} {b}: {p} {q}");
                    visible += 1;
                }
            }
        }
        assert!(visible > 30_000);
    }

    #[test]
    fn cyrus_beck_agrees_on_rectangles_either_way_round() {
        let mut random = Xorshift::new(4);
        let ring = corners(RECT);
        let mut turned = ring;
        turned.reverse();
        for _ in 0..20_000 {
            let (a, b) = (random.point(-9.0, 9.0), random.point(-9.0, 9.0));
            let expected = liang_barsky(RECT, a, b);
            for polygon in [&ring, &turned] {
                match (cyrus_beck(polygon, a, b), expected) {
                    (Some((p, q)), Some((r, s))) => {
                        assert!(p.distance(r) < 1e-9 && q.distance(s) < 1e-9, "{a} {b}: {p} {q} / {r} {s}");
                    }
                    (None, None) => {}
                    (Some((p, q)), None) | (None, Some((p, q))) => assert!(p.distance(q) < 1e-9, "{a} {b}"),
                }
            }
        }
    }
}
