//! Lines as convex polygons: a rectangle for each segment, and what joins and ends them
//! (J. D. Foley, A. van Dam, S. K. Feiner and J. F. Hughes, "Computer Graphics: Principles and Practice", 2nd ed.,
//! 1990, section 3.9).

use gks_pipeline::look::{Cap, Join};
use glam::DVec2;
use std::f64::consts::TAU;
use std::ops::Range;

/// The largest deviation of the polygon that stands for a disc, in pixels.
const TOLERANCE: f64 = 0.05;
/// The width of the gap at a corner from which on it is joined, in pixels.
const SMALLEST_GAP: f64 = 0.02;
/// A miter is at most this many times as long as the line is wide.
const MITER_LIMIT: f64 = 10.0;

/// The binary places of a coordinate on the grid of [`settled`].
pub(super) const GRID_PLACES: u32 = 12;
/// Adding this leaves no room for anything finer than the grid: a rounding that costs two additions.
const GRID: f64 = (3u64 << 51) as f64 / (1u64 << GRID_PLACES) as f64;

/// A point on a grid so fine that nobody sees it, 4096 to the pixel. Points that differ by the rounding of their
/// arithmetic only, as the same point does before and after a metafile, meet there, and so have the same samples.
#[inline]
pub(super) fn settled(p: DVec2) -> DVec2 {
    let settled = (p + GRID) - GRID;
    if p.abs().max_element() < GRID * 0.25 { settled } else { p }
}

/// A coordinate on that grid in steps; beyond `u32` if it is negative, far away or no number.
#[inline]
pub(super) fn grid_steps(coordinate: f64) -> u64 {
    // The last bits of a sum without room for a fraction are a whole number.
    (coordinate + GRID).to_bits().wrapping_sub(GRID.to_bits())
}

/// Follows paths with a pen and gives the convex polygons that make up the line. They overlap.
///
/// Each point is looked at once, so that a path may be reduced on its way here.
#[derive(Debug)]
pub(super) struct Stroke {
    half: f64,
    cap: Cap,
    join: Join,
    /// The vertices of the polygon that stands for a disc around the origin.
    disc: Vec<DVec2>,
    /// The angle of an arc that its chord stands for, and its cosine.
    step: f64,
    step_cos: f64,
    /// The polygon under construction.
    ring: Vec<DVec2>,
    first: DVec2,
    first_along: DVec2,
    last: DVec2,
    along: DVec2,
    /// The number of points, neighbours that are equal counted once.
    count: usize,
    /// From where to where the polygons matter that points at such heights have.
    rows: (f64, f64),
    /// The point before the last one, if the segment between them was left out and its direction is not known.
    before: Option<DVec2>,
}

impl Stroke {
    /// A pen that has no width yet.
    pub(super) fn new() -> Self {
        let zero = DVec2::ZERO;
        Stroke {
            half: 0.0,
            cap: Cap::Butt,
            join: Join::Miter,
            disc: Vec::new(),
            step: 0.0,
            step_cos: 1.0,
            ring: Vec::new(),
            first: zero,
            first_along: zero,
            last: zero,
            along: zero,
            count: 0,
            rows: (f64::NEG_INFINITY, f64::INFINITY),
            before: None,
        }
    }

    /// Takes a pen of a width.
    pub(super) fn begin(&mut self, width: f64, cap: Cap, join: Join) {
        let half = settled(DVec2::splat(width * 0.5)).x;
        if half != self.half || self.disc.is_empty() {
            let step = 2.0 * (1.0 - (TOLERANCE / half).min(0.5)).acos();
            let corners = (TAU / step).ceil().clamp(8.0, 720.0);
            self.step = TAU / corners;
            self.step_cos = self.step.cos();
            self.disc.clear();
            self.disc
                .extend((0..corners as u32).map(|i| DVec2::from_angle(TAU * f64::from(i) / corners) * half));
        }
        (self.half, self.cap, self.join, self.count) = (half, cap, join, 0);
        self.rows = (f64::NEG_INFINITY, f64::INFINITY);
    }

    /// Leaves out most of what lies above or below some rows, and nothing within them.
    pub(super) fn keep_to(&mut self, rows: &Range<usize>) {
        let reach = self.reach() + 1.0;
        self.rows = (rows.start as f64 - reach, rows.end as f64 + reach);
    }

    /// Changes how corners are joined and gives what it was.
    pub(super) fn replace_join(&mut self, change: impl FnOnce(Join) -> Join) -> Join {
        let join = change(self.join);
        std::mem::replace(&mut self.join, join)
    }

    /// The radius of the pen if it is round: what a line covers is then what a disc covers on its way.
    pub(super) fn radius(&self) -> Option<f64> {
        (self.cap == Cap::Round && self.join == Join::Round).then_some(self.half)
    }

    /// Whether the corner of a line that turns back looks like the end of a line.
    pub(super) fn has_ends_like_corners(&self) -> bool {
        match self.join {
            Join::Round => self.cap == Cap::Round,
            Join::Miter | Join::Bevel => self.cap == Cap::Butt,
        }
    }

    /// How far the polygons of a pen reach from the points of a path.
    pub(super) fn reach(&self) -> f64 {
        self.half * if self.join == Join::Miter { MITER_LIMIT } else { 1.5 }
    }

    /// Goes on to the next point of a path. What is not a number is left out.
    #[inline]
    pub(super) fn to(&mut self, p: DVec2, polygon: &mut impl FnMut(&[DVec2])) {
        let p = settled(p);
        if !p.is_finite() || self.count > 0 && p == self.last {
            return;
        }
        if self.count == 0 {
            (self.first, self.last, self.count) = (p, p, 1);
            return;
        }
        if self.count > 1 && (p.y.max(self.last.y) < self.rows.0 || p.y.min(self.last.y) > self.rows.1) {
            (self.before, self.last) = (Some(self.last), p);
            self.count += 1;
            return;
        }
        self.know_direction();
        let along = (p - self.last).normalize_or_zero();
        let side = along.perp() * self.half;
        let mut from = self.last;
        if self.count == 1 {
            self.first_along = along;
        } else {
            let turn = self.along.perp_dot(along).abs() * self.half;
            if turn <= SMALLEST_GAP && self.along.dot(along) > 0.0 {
                // It is closed by as much of an overlap.
                from -= along * turn;
            } else {
                self.corner(self.last, self.along, along, polygon);
            }
        }
        polygon(&[from + side, p + side, p - side, from - side]);
        (self.last, self.along) = (p, along);
        self.count += 1;
    }

    /// Finds the direction of the last segment if it was left out.
    #[inline]
    fn know_direction(&mut self) {
        if let Some(before) = self.before.take() {
            self.along = (self.last - before).normalize_or_zero();
        }
    }

    /// Ends a path: a path of one point is a dot, and a path of three segments or more that comes back to its start is
    /// closed.
    pub(super) fn end(&mut self, polygon: &mut impl FnMut(&[DVec2])) {
        self.know_direction();
        let count = std::mem::take(&mut self.count);
        let half = DVec2::splat(self.half);
        match count {
            0 => {}
            1 if self.cap == Cap::Round => self.disc(self.last, polygon),
            1 => {
                let (low, high) = (self.last - half, self.last + half);
                polygon(&[low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)]);
            }
            4.. if self.first == self.last => self.corner(self.first, self.along, self.first_along, polygon),
            _ => {
                self.ending(self.first, -self.first_along, polygon);
                self.ending(self.last, self.along, polygon);
            }
        }
    }

    /// The end of a line that arrives from one direction.
    fn ending(&mut self, at: DVec2, along: DVec2, polygon: &mut impl FnMut(&[DVec2])) {
        match self.cap {
            Cap::Butt => {}
            Cap::Round => self.disc(at, polygon),
            Cap::Projecting => {
                let (side, ahead) = (along.perp() * self.half, along * self.half);
                polygon(&[at + side, at + side + ahead, at - side + ahead, at - side]);
            }
        }
    }

    fn disc(&mut self, at: DVec2, polygon: &mut impl FnMut(&[DVec2])) {
        self.ring.clear();
        self.ring.extend(self.disc.iter().map(|&p| p + at));
        polygon(&self.ring);
    }

    /// The corner at a point where the line turns from one direction to another, on the outer side.
    #[inline]
    fn corner(&mut self, at: DVec2, before: DVec2, after: DVec2, polygon: &mut impl FnMut(&[DVec2])) {
        let turn = before.perp_dot(after);
        let cos = before.dot(after);
        if turn == 0.0 && (cos > 0.0 || self.join != Join::Round) {
            return;
        }
        let outwards = -turn.signum() * self.half;
        let (a, b) = (before.perp() * outwards, after.perp() * outwards);
        match self.join {
            // The miter is 1 / cos of half the turning angle times as long as the line is wide.
            Join::Miter if (1.0 + cos) * 0.5 >= 1.0 / (MITER_LIMIT * MITER_LIMIT) => {
                polygon(&[at, at + a, at + (a + b) / (1.0 + cos), at + b]);
            }
            Join::Miter | Join::Bevel => polygon(&[at, at + a, at + b]),
            // The chord is as good as the arc.
            Join::Round if cos >= self.step_cos => polygon(&[at, at + a, at + b]),
            Join::Round => self.sector(at, (a, b), turn.atan2(cos), polygon),
        }
    }

    /// The sector of a disc from one point of its edge through an angle to another; the points are seen from the middle.
    fn sector(&mut self, at: DVec2, (a, b): (DVec2, DVec2), angle: f64, polygon: &mut impl FnMut(&[DVec2])) {
        let pieces = (angle.abs() / self.step).ceil().max(1.0);
        let turn = DVec2::from_angle(angle / pieces);
        self.ring.clear();
        self.ring.extend([at, at + a]);
        let mut v = a;
        for _ in 1..pieces as u32 {
            v = turn.rotate(v);
            self.ring.push(at + v);
        }
        self.ring.push(at + b);
        polygon(&self.ring);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_algorithms::coverage::{SAMPLES, SampleMask};
    use gks_algorithms::fill::EdgeTable;
    use gks_algorithms::path::Rule;
    use gks_algorithms::rect::IRect;
    use glam::IVec2;

    fn polygons(path: &[(f64, f64)], width: f64, cap: Cap, join: Join, mut polygon: impl FnMut(&[DVec2])) {
        let mut stroke = Stroke::new();
        stroke.begin(width, cap, join);
        for &p in path {
            stroke.to(p.into(), &mut polygon);
        }
        stroke.end(&mut polygon);
    }

    fn picture(path: &[(f64, f64)], width: f64, cap: Cap, join: Join) -> Vec<String> {
        let mut rows = vec![vec!['.'; 12]; 8];
        let mut table = EdgeTable::new();
        polygons(path, width, cap, join, |ring| {
            table.spans(ring, &[ring.len() as u32], Rule::NonZero, IRect::of_size(12, 8), |y, from, to| {
                rows[y as usize][from as usize..to as usize].fill('#');
            });
        });
        rows.into_iter().map(|row| row.into_iter().collect()).collect()
    }

    #[test]
    fn points_settle_on_a_fine_grid() {
        for x in [0.0, 100.0625, -3.5, 1e5] {
            for noise in [0.0, 1e-10, -1e-10] {
                assert_eq!(settled(DVec2::new(x + noise, 1.0)), DVec2::new(x, 1.0));
            }
        }
        assert!((settled(DVec2::splat(0.3)).x - 0.3).abs() <= 0.5 / 4096.0);
        let far = DVec2::new(1e300, 0.1);
        assert_eq!(settled(far), far);
    }

    #[test]
    fn nothing_is_left_out_of_the_rows_kept() {
        let point =
            |i: u32| DVec2::new(f64::from(i * 37 % 101) * 0.6, f64::from(i * 7919 % 127) * 2.3 - 120.0);
        let path: Vec<DVec2> =
            (0..400).map(point).chain((0..30).map(|i| DVec2::new(f64::from(i), 4.8))).collect();
        for (cap, join) in
            [(Cap::Round, Join::Round), (Cap::Projecting, Join::Miter), (Cap::Butt, Join::Bevel)]
        {
            let drawn = |rows: &Range<usize>, keep: bool| {
                let (mut stroke, mut mask, mut count) = (Stroke::new(), SampleMask::new(), 0);
                mask.begin(IRect::new(IVec2::new(0, rows.start as i32), IVec2::new(60, rows.end as i32)));
                stroke.begin(3.0, cap, join);
                if keep {
                    stroke.keep_to(rows);
                }
                let mut polygon = |ring: &[DVec2]| {
                    count += 1;
                    mask.polygon(ring);
                };
                path.iter().for_each(|&p| stroke.to(p, &mut polygon));
                stroke.end(&mut polygon);
                let mut words = Vec::new();
                mask.drain(|row, column, given| words.push((row, column, given.to_vec())));
                (words, count)
            };
            for rows in [0..4, 8..9, 40..60] {
                let ((all, many), (kept, few)) = (drawn(&rows, false), drawn(&rows, true));
                assert!(all == kept && few < many, "{rows:?} {cap:?}: {few} of {many} polygons");
            }
        }
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

    /// How much of a raster polygons cover, in pixels.
    fn covered(rings: &[Vec<DVec2>]) -> f64 {
        let mut mask = SampleMask::new();
        mask.begin(IRect::of_size(60, 60));
        rings.iter().for_each(|ring| mask.polygon(ring));
        let mut samples = 0;
        mask.drain(|_, _, words| samples += words.iter().map(|word| word.count_ones()).sum::<u32>());
        f64::from(samples) / f64::from(SAMPLES)
    }

    #[test]
    fn a_round_corner_covers_what_a_disc_covers_whatever_the_turn() {
        let middle = DVec2::new(30.3, 30.2);
        for (degrees, width) in (-180..=180).step_by(5).flat_map(|d| [(d, 1.0), (d, 12.0)]) {
            let after = middle + DVec2::from_angle(f64::from(degrees).to_radians()) * 20.0;
            let path = [(10.3, 30.2), middle.into(), after.into()];
            let rings = |join| {
                let mut rings = Vec::new();
                polygons(&path, width, Cap::Butt, join, |ring| rings.push(ring.to_vec()));
                rings
            };
            let mut with_disc = rings(Join::Bevel);
            polygons(&[middle.into()], width, Cap::Round, Join::Round, |ring| with_disc.push(ring.to_vec()));
            let (found, expected) = (covered(&rings(Join::Round)), covered(&with_disc));
            let arc = width * 0.5 * f64::from(degrees).to_radians().abs();
            assert!((found - expected).abs() <= 0.2 + 2.0 * TOLERANCE * arc, "{degrees}: {found} {expected}");
        }
    }

    #[test]
    fn a_closed_line_has_no_ends_and_a_sharp_corner_no_miter() {
        let ring = [(3.0, 2.0), (9.0, 2.0), (9.0, 6.0), (3.0, 6.0), (3.0, 2.0)];
        let closed = picture(&ring, 2.0, Cap::Butt, Join::Miter);
        assert_eq!(closed[1], "..########..");
        assert_eq!(closed[3], "..##....##..");
        let mut reach = 0.0f64;
        let sharp = [(0.0, 0.0), (100.0, 0.0), (0.0, 1.0)];
        polygons(&sharp, 2.0, Cap::Butt, Join::Miter, |ring| {
            reach = ring.iter().fold(reach, |far, p| far.max(p.x));
        });
        assert!(reach < 101.1, "{reach}");
    }

    #[test]
    fn a_line_that_turns_back_is_round_there_if_its_joins_are() {
        let back = [(3.0, 4.0), (7.0, 4.0), (3.0, 4.0)];
        let row = |join| picture(&back, 4.0, Cap::Butt, join)[3].clone();
        assert_eq!((&*row(Join::Round), &*row(Join::Miter)), ("...######...", "...####....."));
    }

    #[test]
    fn a_dot_is_square_or_round() {
        let square = picture(&[(4.0, 4.0)], 4.0, Cap::Butt, Join::Miter);
        assert_eq!(square[2], "..####......");
        let round = picture(&[(4.0, 4.0), (4.0, 4.0)], 4.0, Cap::Round, Join::Miter);
        assert_eq!((&*round[2], &*round[3]), ("...##.......", "..####......"));
        assert_eq!(picture(&[], 4.0, Cap::Round, Join::Miter), ["............"; 8]);
        assert_eq!(picture(&[(f64::NAN, 4.0)], 4.0, Cap::Round, Join::Miter), ["............"; 8]);
    }
}
