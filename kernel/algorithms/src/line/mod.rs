//! Lines: pixels of segments; dashing and reducing polylines.
//!
//! [`bresenham`] and [`dda`] do the same job with the same signature: they give the pixels of the segment between two
//! pixels, both included, one for each step along the longer axis, leaving out those outside the rectangle. Clipping
//! moves no pixel, the same pixels come out from either end, and a segment costs as many steps as it has pixels in the
//! columns (or rows) of the rectangle, however long it is.
//!
//! [`m4`] and [`sklansky_gonzalez`] reduce a polyline as it passes: they give some of its vertices, in order and bit for bit,
//! always the first and the last, such that none left out is farther from the reduced line than the tolerance. They hold
//! a few points at a time. A vertex that is not usable is passed on as it is, and what comes before and after it is
//! reduced separately; with no tolerance hardly anything is left out.

mod bresenham;
mod column;
mod dash;
mod dda;
mod klee;
mod m4;
mod octant;
mod sklansky_gonzalez;

pub use bresenham::bresenham;
pub use column::{Stay, stay};
pub use dash::{Dashes, dash};
pub use dda::dda;
pub use klee::{Upright, klee};
pub use m4::{M4, m4};
pub use sklansky_gonzalez::sklansky_gonzalez;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Plotter, around, check_clipping, picture, pixels};
    use crate::rect::IRect;
    use crate::xorshift::Xorshift;
    use glam::{DVec2, IVec2};

    type Line = fn(IVec2, IVec2, IRect, &mut dyn FnMut(i32, i32));

    const LINES: [(&str, Line); 2] = [
        ("bresenham", |from, to, clip, plot| bresenham(from, to, clip, plot)),
        ("dda", |from, to, clip, plot| dda(from, to, clip, plot)),
    ];

    fn draw(line: Line, a: IVec2, b: IVec2) -> impl Fn(IRect, &mut dyn FnMut(i32, i32)) {
        move |clip, plot| line(a, b, clip, plot)
    }

    #[test]
    fn pictures() {
        for (name, line) in LINES {
            let flat = picture(IRect::of_size(9, 4), &draw(line, IVec2::new(0, 0), IVec2::new(8, 3)));
            assert_eq!(flat, ["##.......", "..##.....", "....###..", ".......##"], "{name}");
            let steep = picture(IRect::of_size(3, 5), &draw(line, IVec2::new(2, 0), IVec2::new(0, 4)));
            assert_eq!(steep, ["..#", "..#", ".#.", ".#.", "#.."], "{name}");
        }
    }

    #[test]
    fn one_pixel_a_step_next_to_the_true_line() {
        let mut random = Xorshift::new(20);
        for _ in 0..500 {
            let (a, b) = (random.grid(-60, 60), random.grid(-60, 60));
            let d = b - a;
            let steps = d.abs().max_element();
            for (name, line) in LINES {
                let set = pixels(around(60), &draw(line, a, b));
                assert_eq!(set.len() as i32, steps + 1, "{name} {a} {b}");
                assert!(set.contains(&a.into()) && set.contains(&b.into()), "{name} {a} {b}");
                assert_eq!(set, pixels(around(60), &draw(line, b, a)), "{name} {a} {b}");
                for &(x, y) in &set {
                    let off = (x - a.x) * d.y - (y - a.y) * d.x;
                    assert!(2 * off.abs() <= steps, "{name} {a} {b} {x} {y}");
                }
            }
        }
    }

    #[test]
    fn all_agree_also_where_a_row_lies_halfway() {
        let reach = 12;
        for x in -reach..=reach {
            for to in (-reach..=reach).map(|y| IVec2::new(x, y)) {
                let expected = pixels(around(reach), &draw(LINES[0].1, IVec2::ZERO, to));
                for (name, line) in LINES {
                    assert_eq!(pixels(around(reach), &draw(line, IVec2::ZERO, to)), expected, "{name} {to}");
                }
            }
        }
    }

    #[test]
    fn clipping_moves_no_pixel() {
        let mut random = Xorshift::new(21);
        for _ in 0..300 {
            let (a, b) = (random.grid(-80, 80), random.grid(-80, 80));
            for (_, line) in LINES {
                check_clipping(&mut random, around(80), &draw(line, a, b) as &Plotter<'_>);
            }
        }
    }

    #[test]
    fn lines_as_long_as_the_numbers_reach() {
        for (name, line) in LINES {
            let count = |from, to, clip| pixels(clip, &draw(line, from, to)).len();
            assert_eq!(count(IVec2::MIN, IVec2::MAX, around(50)), 101, "{name}");
            assert_eq!(count(IVec2::MAX, IVec2::MIN, around(50)), 101, "{name}");
            let (left, right) = (IVec2::new(i32::MIN, 7), IVec2::new(i32::MAX, -7));
            assert_eq!(count(left, right, around(50)), 101, "{name}");
            assert_eq!(count(left, IVec2::new(i32::MAX, 7), around(5)), 0, "{name}");
            assert_eq!(count(IVec2::MIN, IVec2::MIN, around(5)), 0, "{name}");
            let last = IRect::new(IVec2::MAX - 3, IVec2::MAX);
            assert_eq!(count(IVec2::MIN, IVec2::MAX, last), 3, "{name}");
            assert_eq!(count(IVec2::ZERO, IVec2::ONE, IRect::new(IVec2::ONE, IVec2::ZERO)), 0, "{name}");
        }
    }

    #[test]
    fn all_agree_on_long_lines() {
        let mut random = Xorshift::new(26);
        for _ in 0..2_000 {
            let (a, b) = (random.grid(i32::MIN, i32::MAX), random.grid(i32::MIN, i32::MAX));
            let middle = (a.as_dvec2() + b.as_dvec2()) / 2.0;
            let clip = IRect::new(middle.as_ivec2() - 20, middle.as_ivec2() + 20);
            let [one, other] = LINES.map(|(_, line)| pixels(clip, &draw(line, a, b)));
            assert!(one.len() >= 20, "{a} {b}");
            assert_eq!(one, other, "{a} {b}");
        }
    }

    #[test]
    fn a_clipped_line_across_the_world_passes_where_it_should() {
        // The line from (-2^30, -2^30 / 3) to (2^30, 2^30 / 3) nearly; computed here in wide integers.
        let (a, b) = (IVec2::new(-1 << 30, -357_913_941), IVec2::new(1 << 30, 357_913_942));
        let apart = |a: i32, b: i32| i128::from(b) - i128::from(a);
        let (run, rise) = (apart(a.x, b.x), apart(a.y, b.y));
        let set = pixels(around(40), &draw(LINES[0].1, a, b));
        for &(x, y) in &set {
            let off = apart(a.x, x) * rise - apart(a.y, y) * run;
            assert!(2 * off.abs() <= run);
        }
        assert_eq!(set.len(), 81);
    }

    type Reducer = fn(&[DVec2], f64, &mut dyn FnMut(DVec2));

    const REDUCERS: [(&str, Reducer); 2] = [
        ("m4", |path, tolerance, emit| m4(path.iter().copied(), tolerance, emit)),
        ("sklansky_gonzalez", |path, tolerance, emit| {
            sklansky_gonzalez(path.iter().copied(), tolerance, emit);
        }),
    ];

    fn reduced(reducer: Reducer, path: &[DVec2], tolerance: f64) -> Vec<DVec2> {
        let mut kept = vec![];
        reducer(path, tolerance, &mut |p| kept.push(p));
        kept
    }

    /// Lines smooth and rough, forward and to and fro, on a grid with many equal vertices and off it.
    fn paths() -> Vec<Vec<DVec2>> {
        let mut random = Xorshift::new(24);
        let mut paths = vec![];
        for round in 0..60 {
            let (count, step) = (random.int(1, 400), random.real(0.01, 3.0));
            let mut at = DVec2::ZERO;
            paths.push(
                (0..count)
                    .map(|i| {
                        let t = f64::from(i) * step;
                        match round % 5 {
                            0 => DVec2::new(t, 20.0 * (t / 10.0).sin() + random.real(-0.3, 0.3)),
                            1 => DVec2::new(t * 0.1, random.real(-50.0, 50.0)),
                            2 => DVec2::from_angle(t * 0.1) * t,
                            3 => {
                                at += random.point(-1.0, 1.0);
                                at
                            }
                            _ => {
                                at += random.grid(-1, 1).as_dvec2();
                                at
                            }
                        }
                    })
                    .collect(),
            );
        }
        paths
    }

    #[test]
    fn what_reducing_leaves_out_lies_within_the_tolerance() {
        for path in paths() {
            for tolerance in [0.0, 0.05, 0.5, 4.0] {
                for (name, reducer) in REDUCERS {
                    let kept = reduced(reducer, &path, tolerance);
                    assert_eq!((kept.first(), kept.last()), (path.first(), path.last()), "{name}");
                    // Those kept are found in the path one after the other.
                    let mut from = 0;
                    for chord in kept.windows(2) {
                        let to = from
                            + 1
                            + path[from + 1..].iter().position(|p| *p == chord[1]).expect("in order");
                        from = to;
                    }
                    for p in &path {
                        let off = kept.windows(2).map(|w| distance(*p, w[0], w[1])).fold(f64::MAX, f64::min);
                        assert!(kept.len() < 2 || off <= tolerance + 1e-9, "{name} {tolerance} {p} {off}");
                    }
                }
            }
        }
    }

    fn distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
        let t = ((p - a).dot(b - a) / (b - a).length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        p.distance(a + (b - a) * t)
    }

    #[test]
    fn reducing_pays() {
        let mut random = Xorshift::new(25);
        let smooth: Vec<DVec2> = (0..10_000)
            .map(|i| f64::from(i) * 0.01)
            .map(|x| DVec2::new(x, 20.0 * (x / 10.0).sin()))
            .collect();
        assert!(reduced(REDUCERS[1].1, &smooth, 0.1).len() < 60);
        let rough: Vec<DVec2> =
            (0..10_000).map(|i| DVec2::new(f64::from(i) * 0.01, random.real(0.0, 99.0))).collect();
        assert!((300..=400).contains(&reduced(REDUCERS[0].1, &rough, 1.0).len()));
    }

    #[test]
    fn reducing_passes_on_what_is_not_finite() {
        let line = |from: i32, to: i32| (from..to).map(|x| DVec2::new(f64::from(x) / 8.0, 1.0));
        let path: Vec<DVec2> = line(0, 8).chain([DVec2::NAN, DVec2::INFINITY]).chain(line(8, 16)).collect();
        for (name, reducer) in REDUCERS {
            let kept = reduced(reducer, &path, 1.0);
            let text = format!("{kept:?}");
            let expected = [path[0], path[7], DVec2::NAN, DVec2::INFINITY, path[10], path[17]];
            assert_eq!(text, format!("{expected:?}"), "{name}");
            assert!(reduced(reducer, &[], 1.0).is_empty());
            for tolerance in [f64::NAN, -1.0, 1e-320] {
                let all = reduced(reducer, &path, tolerance);
                assert!(all.len() <= path.len() && all.len() >= 6, "{name} {tolerance}");
            }
            for extreme in [1e150, -1e150] {
                let far = [DVec2::ZERO, DVec2::splat(extreme), DVec2::ONE];
                assert_eq!(reduced(reducer, &far, 0.1), far, "{name}");
            }
        }
    }
}
