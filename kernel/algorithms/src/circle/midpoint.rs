//! J. E. Bresenham, "A linear algorithm for incremental digital display of circular arcs", Communications of the ACM
//! 20(2), 1977; J. R. Van Aken and M. Novak, "Curve-drawing algorithms for raster displays", ACM Transactions on Graphics
//! 4(2), 1985: the outline of a circle by testing midpoints.

use crate::rect::IRect;
use glam::IVec2;

/// Gives the pixels of a circle's outline inside the rectangle, each once, octant by octant.
///
/// Radius zero is a pixel, a negative one nothing. Each octant costs as many steps as the rectangle has columns or rows
/// that it crosses, however large the circle is.
pub fn midpoint(center: IVec2, radius: i32, clip: IRect, mut plot: impl FnMut(i32, i32)) {
    if radius < 0 || clip.is_empty() {
        return;
    }
    let radius = i64::from(radius);
    let diagonal = diagonal(radius);
    let on_diagonal = height(radius, diagonal) == diagonal;
    for steep in [false, true] {
        let along = |p: IVec2| if steep { (p.y, p.x) } else { (p.x, p.y) };
        let (c, min, max) = (along(center), along(clip.min), along(clip.max));
        let far = if steep && on_diagonal { diagonal - 1 } else { diagonal };
        for sign in [1, -1] {
            // Distances from the centre along the octant that lie in the rectangle; zero belongs to the positive side.
            let (low, high) = span(c.0, sign, min.0, max.0);
            let (first, last) = (low.max(i64::from(sign < 0)), high.min(far));
            if first > last {
                continue;
            }
            for sign_y in if radius == 0 { &[1][..] } else { &[1, -1] } {
                let (low_y, high_y) = span(c.1, *sign_y, min.1, max.1);
                let mut y = height(radius, first);
                if y < low_y || height(radius, last) > high_y {
                    continue;
                }
                let mut outside = first * first - radius * radius + y * y - y;
                for x in first..=last {
                    // The midpoint below the pixel, at y - 1/2, lies outside the circle.
                    if outside >= 0 && y > 0 {
                        outside -= 2 * (y - 1);
                        y -= 1;
                    }
                    if low_y <= y && y <= high_y {
                        let at = |c: i32, sign: i32, by: i64| (i64::from(c) + i64::from(sign) * by) as i32;
                        let (u, v) = (at(c.0, sign, x), at(c.1, *sign_y, y));
                        if steep { plot(v, u) } else { plot(u, v) }
                    }
                    outside += 2 * x + 1;
                }
            }
        }
    }
}

/// The distances from the centre, in the direction of the sign, between which the pixels lie in the rectangle.
fn span(center: i32, sign: i32, min: i32, max: i32) -> (i64, i64) {
    let (low, high) = (i64::from(min) - i64::from(center), i64::from(max) - 1 - i64::from(center));
    if sign < 0 { (-high, -low) } else { (low, high) }
}

/// The square root of r² - x², rounded: where the incremental test stands after x steps.
fn height(radius: i64, x: i64) -> i64 {
    let square = (radius * radius - x * x).max(0).unsigned_abs();
    let root = square.isqrt();
    (if square > root * (root + 1) { root + 1 } else { root }).cast_signed()
}

/// The greatest x that is not beyond the diagonal.
fn diagonal(radius: i64) -> i64 {
    let mut x = (radius * radius / 2).unsigned_abs().isqrt().cast_signed();
    while x < height(radius, x + 1) {
        x += 1;
    }
    while x > height(radius, x) {
        x -= 1;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{around, check_clipping, is_connected, picture, pixels};
    use crate::xorshift::Xorshift;

    fn circle(center: IVec2, radius: i32) -> impl Fn(IRect, &mut dyn FnMut(i32, i32)) {
        move |clip, plot| midpoint(center, radius, clip, plot)
    }

    #[test]
    fn pictures() {
        assert_eq!(picture(around(1), &circle(IVec2::ZERO, 0)), ["...", ".#.", "..."]);
        assert_eq!(picture(around(1), &circle(IVec2::ZERO, 1)), [".#.", "#.#", ".#."]);
        assert_eq!(
            picture(around(2), &circle(IVec2::ZERO, 2)),
            [".###.", "#...#", "#...#", "#...#", ".###."]
        );
        let four = [
            "...###...",
            ".##...##.",
            ".#.....#.",
            "#.......#",
            "#.......#",
            "#.......#",
            ".#.....#.",
            ".##...##.",
            "...###...",
        ];
        assert_eq!(picture(around(4), &circle(IVec2::ZERO, 4)), four);
    }

    #[test]
    fn round_closed_and_symmetric() {
        for radius in 0..150 {
            let set = pixels(around(150), &circle(IVec2::ZERO, radius));
            assert!(is_connected(&set), "{radius}");
            for &(x, y) in &set {
                let off = f64::hypot(x.into(), y.into()) - f64::from(radius);
                assert!(off.abs() < 0.71, "{radius}: {x} {y}");
                assert!(set.contains(&(-x, y)) && set.contains(&(y, x)), "{radius}: {x} {y}");
            }
            let around_the_axes = [(radius, 0), (-radius, 0), (0, radius), (0, -radius)];
            assert!(around_the_axes.iter().all(|pixel| set.contains(pixel)));
        }
    }

    #[test]
    fn clipping_moves_no_pixel() {
        let mut random = Xorshift::new(22);
        for _ in 0..200 {
            let plotter = circle(random.grid(-40, 40), random.int(0, 60));
            check_clipping(&mut random, around(110), &plotter);
        }
    }

    #[test]
    fn circles_as_large_as_the_numbers_reach() {
        let radius = i32::MAX;
        let set = pixels(around(30), &circle(IVec2::new(radius, 0), radius));
        assert_eq!(set, (-30..=30).map(|y| (0, y)).collect());
        let set = pixels(around(30), &circle(IVec2::new(-1_000_000_000, -1_000_000_000), 1_414_213_562));
        assert!(set.len() > 40 && is_connected(&set));
        assert!(pixels(around(30), &circle(IVec2::MIN, i32::MAX)).len() < 200);
        assert!(pixels(around(30), &circle(IVec2::ZERO, i32::MAX)).is_empty());
        assert!(pixels(around(30), &circle(IVec2::ZERO, -1)).is_empty());
        assert!(pixels(IRect::new(IVec2::MAX, IVec2::MIN), &circle(IVec2::ZERO, 5)).is_empty());
    }
}
