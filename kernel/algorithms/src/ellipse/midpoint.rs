//! M. L. V. Pitteway, "Algorithm for drawing ellipses or hyperbolae with a digital plotter", The Computer Journal 10(3),
//! 1967; J. R. Van Aken, "An efficient ellipse-drawing algorithm", IEEE Computer Graphics and Applications 4(9), 1984: the
//! outline of an ellipse by testing midpoints.

use crate::line::bresenham;
use crate::rect::IRect;
use glam::IVec2;

/// Gives the pixels of the outline of an axis-parallel ellipse inside the rectangle, each once.
///
/// The radii are the half axes along x and y. If one is zero the ellipse is a line, if both are it is a pixel; a negative
/// one gives nothing. The ends of flat ellipses are drawn out to the axis. The steps are as many as the rectangle has
/// columns and rows that the outline crosses, however large the ellipse is.
pub fn midpoint(center: IVec2, radii: IVec2, clip: IRect, mut plot: impl FnMut(i32, i32)) {
    if radii.x < 0 || radii.y < 0 || clip.is_empty() {
        return;
    }
    if radii.x == 0 || radii.y == 0 {
        bresenham(center.saturating_sub(radii), center.saturating_add(radii), clip, plot);
        return;
    }
    let flat = Quarter { a: radii.x.into(), b: radii.y.into() };
    let steep = Quarter { a: flat.b, b: flat.a };
    // Where the slope is less than one there is a pixel for each column, beyond it one for each row.
    let turn = flat.turn();
    let level = flat.height(turn);
    let horizontal = [span(center.x, 1, clip.min.x, clip.max.x), span(center.x, -1, clip.min.x, clip.max.x)];
    let vertical = [span(center.y, 1, clip.min.y, clip.max.y), span(center.y, -1, clip.min.y, clip.max.y)];
    let at = |center: i32, side: usize, by: i64| {
        (if side == 0 { i64::from(center) + by } else { i64::from(center) - by }) as i32
    };
    for (right, &columns) in horizontal.iter().enumerate() {
        for (up, &rows) in vertical.iter().enumerate() {
            // What lies on an axis belongs to the positive side.
            let columns = (columns.0.max(right as i64), columns.1);
            let rows = (rows.0.max(up as i64), rows.1);
            let mut plot = |x: i64, y: i64| plot(at(center.x, right, x), at(center.y, up, y));
            flat.walk((columns.0, columns.1.min(turn)), rows, &mut plot);
            steep.walk((rows.0, rows.1.min(level - 1)), columns, |y, x| plot(x, y));
            // The row in which one gives way to the other may need a pixel more.
            steep.walk(
                (rows.0.max(level), rows.1.min(level)),
                (columns.0.max(turn + 1), columns.1),
                |y, x| {
                    plot(x, y);
                },
            );
        }
    }
}

/// The distances from the centre, to one side, between which the pixels lie in the rectangle.
fn span(center: i32, sign: i64, min: i32, max: i32) -> (i64, i64) {
    let (low, high) = (i64::from(min) - i64::from(center), i64::from(max) - 1 - i64::from(center));
    if sign < 0 { (-high, -low) } else { (low, high) }
}

/// A quarter of an ellipse, with half axis `a` in the direction in which it is walked and `b` across.
struct Quarter {
    a: i64,
    b: i64,
}

impl Quarter {
    /// Gives (x, y) for each x of the columns whose y is among the rows.
    fn walk(&self, columns: (i64, i64), rows: (i64, i64), mut pixel: impl FnMut(i64, i64)) {
        if columns.0 > columns.1 || rows.0 > rows.1 {
            return;
        }
        let mut y = self.height(columns.0);
        if y < rows.0 || self.height(columns.1) > rows.1 {
            return;
        }
        let (a2, b2) = (i128::from(self.a).pow(2), i128::from(self.b).pow(2));
        let mut outside = self.outside(columns.0, y);
        for x in columns.0..=columns.1 {
            while outside > 0 && y > 0 {
                y -= 1;
                outside -= 8 * a2 * i128::from(y);
            }
            if rows.0 <= y && y <= rows.1 {
                pixel(x, y);
            }
            outside += 4 * b2 * i128::from(2 * x + 1);
        }
    }

    /// More than zero when the midpoint below pixel (x, y), at y - 1/2, lies outside: 4 (b² x² + a² (y - 1/2)² - a² b²).
    fn outside(&self, x: i64, y: i64) -> i128 {
        let (a2, b2) = (i128::from(self.a).pow(2), i128::from(self.b).pow(2));
        4 * b2 * (i128::from(x).pow(2) - a2) + a2 * i128::from(2 * y - 1).pow(2)
    }

    /// The height above x, rounded: the greatest y whose midpoint does not lie outside, or 0.
    fn height(&self, x: i64) -> i64 {
        let ratio = x as f64 / self.a as f64;
        let mut y = (self.b as f64 * ((1.0 - ratio) * (1.0 + ratio)).max(0.0).sqrt()).round() as i64;
        // The root is good to many more than the 31 digits of a radius; this puts right what rounding did.
        while y < self.b && self.outside(x, y + 1) <= 0 {
            y += 1;
        }
        while y > 0 && self.outside(x, y) > 0 {
            y -= 1;
        }
        y
    }

    /// The last column before the slope exceeds one: a² / sqrt(a² + b²), rounded down.
    fn turn(&self) -> i64 {
        let (a, b) = (self.a as f64, self.b as f64);
        ((a * (a / a.hypot(b))) as i64).min(self.a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{around, check_clipping, is_connected, picture, pixels};
    use crate::xorshift::Xorshift;

    fn ellipse(center: IVec2, radii: IVec2) -> impl Fn(IRect, &mut dyn FnMut(i32, i32)) {
        move |clip, plot| midpoint(center, radii, clip, plot)
    }

    #[test]
    fn pictures() {
        let shape = |a: i32, b: i32| {
            picture(
                IRect::new(IVec2::new(-a, -b), IVec2::new(a + 1, b + 1)),
                &ellipse(IVec2::ZERO, IVec2::new(a, b)),
            )
        };
        assert_eq!(shape(0, 0), ["#"]);
        assert_eq!(shape(3, 0), ["#######"]);
        assert_eq!(shape(0, 1), ["#", "#", "#"]);
        assert_eq!(shape(6, 1), [".###########.", "#...........#", ".###########."]);
        let five = [
            "...#####...",
            ".##.....##.",
            "#.........#",
            "#.........#",
            "#.........#",
            ".##.....##.",
            "...#####...",
        ];
        assert_eq!(shape(5, 3), five);
    }

    #[test]
    fn closed_symmetric_and_near_the_curve() {
        for a in 1..40 {
            for b in 1..40 {
                let set = pixels(around(40), &ellipse(IVec2::ZERO, IVec2::new(a, b)));
                assert!(is_connected(&set), "{a} {b}");
                for tip in [(a, 0), (-a, 0), (0, b), (0, -b)] {
                    assert!(set.contains(&tip), "{a} {b}");
                }
                let (af, bf) = (f64::from(a), f64::from(b));
                for &(x, y) in &set {
                    assert!(set.contains(&(-x, y)) && set.contains(&(x, -y)), "{a} {b}: {x} {y}");
                    let (x, y) = (f64::from(x), f64::from(y));
                    let rise = (bf * (1.0 - (x / af).powi(2)).max(0.0).sqrt() - y.abs()).abs();
                    let run = (af * (1.0 - (y / bf).powi(2)).max(0.0).sqrt() - x.abs()).abs();
                    assert!(rise.min(run) <= 0.5 + 1e-9, "{a} {b}: {x} {y}");
                }
            }
        }
    }

    #[test]
    fn clipping_moves_no_pixel() {
        let mut random = Xorshift::new(23);
        for _ in 0..200 {
            let plotter = ellipse(random.grid(-40, 40), random.grid(0, 60));
            check_clipping(&mut random, around(110), &plotter);
        }
    }

    #[test]
    fn ellipses_as_large_as_the_numbers_reach() {
        let most = i32::MAX;
        let shape = |center, radii| pixels(around(30), &ellipse(center, radii));
        assert_eq!(shape(IVec2::new(most, 0), IVec2::MAX), (-30..=30).map(|y| (0, y)).collect());
        assert_eq!(shape(IVec2::new(0, most), IVec2::new(7, most)), (0..=30).map(|y| (0, y)).collect());
        let set = shape(IVec2::new(-1_000_000_000, -1_000_000_000), IVec2::splat(1_414_213_562));
        assert!(set.len() > 40 && is_connected(&set));
        assert!(shape(IVec2::MIN, IVec2::MAX).len() < 200);
        assert!(shape(IVec2::ZERO, IVec2::MAX).is_empty());
        assert!(shape(IVec2::ZERO, IVec2::new(-1, 4)).is_empty());
        assert!(!shape(IVec2::ZERO, IVec2::new(most, 0)).is_empty());
    }
}
