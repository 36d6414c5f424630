//! J. H. Ahlberg, E. N. Nilson and J. L. Walsh, "The Theory of Splines and Their Applications", Academic Press 1967,
//! chapter 2; L. H. Thomas's elimination, and for closed curves the formula of J. Sherman and W. J. Morrison, 1950: the
//! cubic spline through given points.

use crate::path::is_usable;
use glam::DVec2;

/// The interpolator: a value that keeps its storage from one curve to the next.
#[derive(Debug, Default)]
pub struct NaturalSpline {
    knots: Vec<DVec2>,
    chords: Vec<f64>,
    slopes: Vec<DVec2>,
    rows: Vec<Row>,
}

/// An equation between the slopes of three neighbours; `fix` is the right side of the second system of a closed curve.
#[derive(Debug, Default)]
struct Row {
    before: f64,
    own: f64,
    after: f64,
    fix: f64,
}

impl NaturalSpline {
    /// An interpolator without storage.
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends the chain of cubic Bezier pieces (see [`crate::curve`]) that runs smoothly through the points.
    ///
    /// Slope and curvature are continuous where the pieces meet; the parameter is the length of the chords. An open curve
    /// has no curvature at its ends, a closed one returns to its first point as smoothly as it passes the others. Points
    /// that are not usable and points equal to their predecessor are left out; two that are left give straight pieces,
    /// one gives itself alone. `knots - 1` pieces are appended for an open curve, `knots` for a closed one.
    pub fn pieces(&mut self, through: &[DVec2], closed: bool, control: &mut Vec<DVec2>) {
        self.take(through, closed);
        let Some(&first) = self.knots.first() else { return };
        control.push(first);
        let (count, pieces) = (self.knots.len(), self.chords.len());
        self.slopes.clear();
        match (count, closed) {
            (..=2, _) => {}
            (_, false) => self.solve_open(),
            (_, true) => self.solve_closed(),
        }
        for i in 0..pieces {
            let (from, to) = (self.knots[i], self.knots[(i + 1) % count]);
            let third = self.chords[i] / 3.0;
            let straight = (to - from) / 3.0;
            let leave = self.slopes.get(i).map_or(straight, |&slope| slope * third);
            let arrive = self.slopes.get((i + 1) % count).map_or(straight, |&slope| slope * third);
            control.extend([from + leave, to - arrive, to]);
        }
    }

    /// Takes the points that count and the lengths of the chords between them, in units of the mean chord.
    fn take(&mut self, through: &[DVec2], closed: bool) {
        let Self { knots, chords, .. } = self;
        knots.clear();
        knots.extend(through.iter().filter(|&&p| is_usable(p)));
        knots.dedup();
        while closed && knots.len() > 1 && knots.first() == knots.last() {
            knots.pop();
        }
        chords.clear();
        chords.extend(knots.windows(2).map(|w| f64::hypot(w[1].x - w[0].x, w[1].y - w[0].y)));
        if let (true, [first, .., last]) = (closed, knots.as_slice()) {
            chords.push(f64::hypot(first.x - last.x, first.y - last.y));
        }
        let mean = chords.iter().map(|chord| chord / chords.len() as f64).sum::<f64>();
        chords.iter_mut().for_each(|chord| *chord /= mean);
    }

    /// Sets the equation at knot `i` between two chords: the second derivative is the same on both sides.
    fn inner_row(&mut self, before: usize, i: usize, after: usize) {
        let (h, k) = (self.chords[before], self.chords[i]);
        let (rise_h, rise_k) =
            ((self.knots[i] - self.knots[before]) / h, (self.knots[after] - self.knots[i]) / k);
        // Divided by h + k, which keeps the numbers in bounds where a short chord meets a long one.
        let (p, q) = (k / (h + k), h / (h + k));
        self.rows.push(Row { before: p, own: 2.0, after: q, fix: 0.0 });
        self.slopes.push((rise_h * p + rise_k * q) * 3.0);
    }

    fn solve_open(&mut self) {
        let last = self.knots.len() - 1;
        let rise = |knots: &[DVec2], i: usize, chord: f64| (knots[i + 1] - knots[i]) * (3.0 / chord);
        self.rows.clear();
        self.rows.push(Row { before: 0.0, own: 2.0, after: 1.0, fix: 0.0 });
        self.slopes.push(rise(&self.knots, 0, self.chords[0]));
        for i in 1..last {
            self.inner_row(i - 1, i, i + 1);
        }
        self.rows.push(Row { before: 1.0, own: 2.0, after: 0.0, fix: 0.0 });
        self.slopes.push(rise(&self.knots, last - 1, self.chords[last - 1]));
        self.eliminate();
    }

    fn solve_closed(&mut self) {
        let count = self.knots.len();
        self.rows.clear();
        for i in 0..count {
            self.inner_row((i + count - 1) % count, i, (i + 1) % count);
        }
        // The matrix has two corners more than a band; they are a product of two vectors, taken out and put back.
        let (top, bottom) = (self.rows[0].before, self.rows[count - 1].after);
        let gamma = -self.rows[0].own;
        self.rows[0].own -= gamma;
        self.rows[0].fix = gamma;
        self.rows[count - 1].own -= top * bottom / gamma;
        self.rows[count - 1].fix = bottom;
        self.eliminate();
        let (first, last) = (&self.rows[0], &self.rows[count - 1]);
        let share = (self.slopes[0] + self.slopes[count - 1] * (top / gamma))
            / (1.0 + first.fix + last.fix * (top / gamma));
        for (slope, row) in self.slopes.iter_mut().zip(&self.rows) {
            *slope -= share * row.fix;
        }
    }

    /// Thomas's elimination; the solutions replace the right sides.
    fn eliminate(&mut self) {
        let (rows, slopes) = (&mut self.rows, &mut self.slopes);
        for i in 1..rows.len() {
            let factor = rows[i].before / rows[i - 1].own;
            rows[i].own -= factor * rows[i - 1].after;
            rows[i].fix -= factor * rows[i - 1].fix;
            slopes[i] = slopes[i] - slopes[i - 1] * factor;
        }
        for i in (0..rows.len()).rev() {
            let after = rows[i].after;
            let (slope, fix) = match rows.get(i + 1) {
                Some(row) => (slopes[i + 1], row.fix),
                None => (DVec2::ZERO, 0.0),
            };
            slopes[i] = (slopes[i] - slope * after) / rows[i].own;
            rows[i].fix = (rows[i].fix - fix * after) / rows[i].own;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;
    use std::f64::consts::TAU;

    fn spline(through: &[DVec2], closed: bool) -> Vec<DVec2> {
        let mut control = vec![];
        NaturalSpline::new().pieces(through, closed, &mut control);
        control
    }

    /// First and second derivatives by chord length at the beginning and the end of each piece.
    fn derivatives(control: &[DVec2]) -> Vec<[DVec2; 4]> {
        let piece = |i: usize| {
            let [a, b, c, d] = std::array::from_fn(|j| control[i + j]);
            let h = a.distance(d);
            [
                (b - a) * 3.0 / h,
                (d - c) * 3.0 / h,
                (a - b - b + c) * 6.0 / (h * h),
                (b - c - c + d) * 6.0 / (h * h),
            ]
        };
        (0..control.len() - 1).step_by(3).map(piece).collect()
    }

    #[test]
    fn passes_all_points_with_continuous_slope_and_curvature() {
        let mut random = Xorshift::new(15);
        for round in 0..200 {
            let through: Vec<DVec2> = (0..random.int(3, 12)).map(|_| random.point(-10.0, 10.0)).collect();
            let closed = round % 2 == 0;
            let control = spline(&through, closed);
            let met: Vec<DVec2> = control.iter().copied().step_by(3).collect();
            assert_eq!(met[..through.len()], through);
            assert_eq!(met.len(), through.len() + usize::from(closed));
            let pieces = derivatives(&control);
            let mut joints: Vec<_> = pieces.windows(2).map(|w| (w[0], w[1])).collect();
            let (first, last) = (pieces[0], pieces[pieces.len() - 1]);
            if closed {
                assert_eq!(met[0], met[through.len()]);
                joints.push((last, first));
            } else {
                assert!(first[2].length() < 1e-6 && last[3].length() < 1e-6);
            }
            for (before, after) in joints {
                let size = before[3].length().max(1.0);
                assert!(before[1].distance(after[0]) < 1e-6 * size, "slope {before:?} {after:?}");
                assert!(before[3].distance(after[2]) < 1e-6 * size, "curvature {before:?} {after:?}");
            }
        }
    }

    #[test]
    fn a_line_stays_straight_and_a_circle_round() {
        let line: Vec<DVec2> = [0.0, 1.0, 5.0, 6.0].map(|x| DVec2::new(x, 2.0 * x)).to_vec();
        for p in spline(&line, false) {
            assert!((p.y - 2.0 * p.x).abs() < 1e-12);
        }
        let circle: Vec<DVec2> = (0..16).map(|i| DVec2::from_angle(f64::from(i) * TAU / 16.0)).collect();
        let mut flat = vec![];
        crate::curve::chain(&spline(&circle, true), 1e-6, &mut flat);
        assert!(flat.len() > 100 && flat.iter().all(|p| (p.length() - 1.0).abs() < 1e-3));
    }

    #[test]
    fn few_equal_and_bad_points() {
        let (a, b) = (DVec2::ZERO, DVec2::new(3.0, 6.0));
        assert!(spline(&[], true).is_empty());
        assert!(spline(&[DVec2::NAN, DVec2::INFINITY], false).is_empty());
        for closed in [false, true] {
            assert_eq!(spline(&[a, a, DVec2::NAN, a], closed), [a]);
        }
        assert_eq!(spline(&[a, a, b], false), [a, DVec2::new(1.0, 2.0), DVec2::new(2.0, 4.0), b]);
        assert_eq!(spline(&[a, b, a], true).len(), 7);
    }

    #[test]
    fn numbers_stay_finite_between_short_and_long_chords() {
        let through = [0.0, 1e-150, 1.0, 1e150, -1e150, 3.0].map(|x| DVec2::new(x, 1.0));
        for closed in [false, true] {
            assert!(spline(&through, closed).iter().all(|p| p.is_finite()));
        }
    }
}
