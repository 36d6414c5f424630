//! Lines: pixels of segments; dashing and reducing polylines.
//!
//! [`bresenham`] and [`dda`] do the same job with the same signature: they give the pixels of the segment between two
//! pixels, both included, one for each step along the longer axis, leaving out those outside the rectangle. Clipping
//! moves no pixel, the same pixels come out from either end, and a segment costs as many steps as it has pixels in the
//! columns (or rows) of the rectangle, however long it is.

mod bresenham;
mod dash;
mod dda;
mod octant;

pub use bresenham::bresenham;
pub use dash::dash;
pub use dda::dda;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Plotter, around, check_clipping, picture, pixels};
    use crate::rect::IRect;
    use crate::xorshift::Xorshift;
    use glam::IVec2;

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
}
