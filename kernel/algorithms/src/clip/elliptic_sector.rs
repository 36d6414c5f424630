//! After the parametric lines of Cyrus and Beck (1978) and the polygons of Sutherland and Hodgman (1974): polylines and
//! rings against an ellipse or a sector of one.

use super::sutherland_hodgman_convex;
use crate::path::{end_subpath, is_usable};
use glam::{DAffine2, DMat2, DVec2};
use std::f64::consts::{PI, TAU};

/// The points `centre + a r cos t + b r sin t` with `r` from 0 to 1 and `t` from `start` to `start + sweep`.
#[derive(Copy, Clone, Debug)]
pub struct EllipticSector {
    /// Takes the ellipse to the unit circle.
    to_circle: DAffine2,
    from_circle: DAffine2,
    start: f64,
    /// More than 0, at most a full turn.
    sweep: f64,
    /// The longer one of the semi-diameters.
    radius: f64,
}

impl EllipticSector {
    /// The sector that `sweep` radians cover from `start` on, in the direction from `a` to `b`; the whole ellipse where they
    /// are a full turn or more. None where it has no area.
    pub fn new(centre: DVec2, a: DVec2, b: DVec2, start: f64, sweep: f64) -> Option<EllipticSector> {
        let from_circle = DAffine2::from_mat2_translation(DMat2::from_cols(a, b), centre);
        let determinant = a.perp_dot(b);
        let sweep = sweep.min(TAU);
        let usable = determinant.is_normal() && is_usable(centre) && start.is_finite() && sweep > 0.0;
        usable.then(|| EllipticSector {
            to_circle: from_circle.inverse(),
            from_circle,
            start,
            sweep,
            radius: a.length().max(b.length()),
        })
    }

    fn is_whole(&self) -> bool {
        self.sweep >= TAU
    }

    fn is_convex(&self) -> bool {
        self.is_whole() || self.sweep <= PI
    }

    /// Whether a point lies inside or on the boundary.
    pub fn contains(&self, p: DVec2) -> bool {
        self.holds(self.to_circle.transform_point2(p))
    }

    /// Whether a point of the plane of the circle lies inside.
    fn holds(&self, p: DVec2) -> bool {
        p.length_squared() <= 1.0
            && (self.is_whole() || (p.y.atan2(p.x) - self.start).rem_euclid(TAU) <= self.sweep)
    }

    /// Whether everything between some points lies inside, as far as can be told from the points.
    pub fn contains_all(&self, points: &[DVec2]) -> bool {
        self.is_convex() && points.iter().all(|&p| self.contains(p))
    }

    /// Appends the pieces of a polyline that lie inside.
    ///
    /// Vertices inside are kept bit for bit and in one piece as long as the line stays inside. A path of a single point is
    /// kept where that lies inside. The line is broken at a vertex that is not usable.
    pub fn polyline(&self, path: &[DVec2], points: &mut Vec<DVec2>, ends: &mut Vec<u32>) {
        if let &[dot] = path {
            if is_usable(dot) && self.contains(dot) {
                points.push(dot);
                end_subpath(points, ends);
            }
            return;
        }
        let mut drawing = false;
        for segment in path.windows(2) {
            let &[a, b] = segment else { continue };
            if !is_usable(a) || !is_usable(b) {
                finish(&mut drawing, points, ends);
                continue;
            }
            let (cuts, count) = self.cuts(a, b);
            let last = count - 2;
            let inside = |part: usize| self.contains(a.lerp(b, (cuts[part] + cuts[part + 1]) * 0.5));
            for part in 0..=last {
                if !inside(part) {
                    finish(&mut drawing, points, ends);
                    continue;
                }
                if !drawing {
                    points.push(at(a, b, cuts[part]));
                    drawing = true;
                }
                if part == last || !inside(part + 1) {
                    points.push(at(a, b, cuts[part + 1]));
                }
            }
        }
        finish(&mut drawing, points, ends);
    }

    /// Where segment a-b may cross the boundary, by rising parameter, 0 and 1 among them; and how many places these are.
    fn cuts(&self, a: DVec2, b: DVec2) -> ([f64; 6], usize) {
        let (p, q) = (self.to_circle.transform_point2(a), self.to_circle.transform_point2(b));
        let d = q - p;
        let mut cuts = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        let mut count = 2;
        let mut add = |t: f64| {
            if t > 0.0 && t < 1.0 {
                cuts[count] = t;
                count += 1;
            }
        };
        // |p + t d| = 1
        let (square, half, rest) = (d.length_squared(), p.dot(d), p.length_squared() - 1.0);
        let root = half * half - square * rest;
        if root > 0.0 && square > 0.0 {
            let root = root.sqrt();
            add((-half - root) / square);
            add((-half + root) / square);
        }
        if !self.is_whole() {
            for angle in [self.start, self.start + self.sweep] {
                let radius = DVec2::from_angle(angle);
                let slope = radius.perp_dot(d);
                let t = -radius.perp_dot(p) / slope;
                if slope != 0.0 && radius.dot(p + d * t) >= 0.0 {
                    add(t);
                }
            }
        }
        cuts[..count].sort_by(f64::total_cmp);
        (cuts, count)
    }

    /// The boundary as convex polygons that lie side by side, within a distance of it.
    pub fn convex_parts(&self, tolerance: f64) -> Vec<Vec<DVec2>> {
        let part = |start: f64, sweep: f64| -> Vec<DVec2> {
            // The sagitta of the arc of a chord is r (1 - cos(step / 2)).
            let step = 2.0 * (1.0 - tolerance / self.radius).clamp(-1.0, 1.0).acos();
            let count = (sweep / step.max(1e-3)).ceil().max(4.0) as usize;
            let whole = sweep >= TAU;
            let last = if whole { count - 1 } else { count };
            let arc = (0..=last).map(|i| DVec2::from_angle(start + sweep * i as f64 / count as f64));
            let centre = (!whole).then_some(DVec2::ZERO);
            arc.chain(centre).map(|p| self.from_circle.transform_point2(p)).collect()
        };
        if self.is_convex() {
            return vec![part(self.start, self.sweep)];
        }
        let half = self.sweep * 0.5;
        vec![part(self.start, half), part(self.start + half, half)]
    }

    /// Appends the part of a ring that lies inside, as a ring for each of the [`convex_parts`](Self::convex_parts).
    ///
    /// `scratch` is cleared and used. In all else as [`sutherland_hodgman_convex`].
    pub fn ring(
        &self,
        parts: &[Vec<DVec2>],
        ring: &[DVec2],
        scratch: &mut Vec<DVec2>,
        points: &mut Vec<DVec2>,
        ends: &mut Vec<u32>,
    ) {
        if ring.len() > 2 && ring.iter().all(|&p| is_usable(p)) && self.contains_all(ring) {
            points.extend_from_slice(ring);
            end_subpath(points, ends);
            return;
        }
        for part in parts {
            sutherland_hodgman_convex(part, ring, scratch, points, ends);
        }
    }
}

/// The point of segment a-b at a parameter, its ends bit for bit.
fn at(a: DVec2, b: DVec2, t: f64) -> DVec2 {
    match t {
        0.0 => a,
        1.0 => b,
        t => a.lerp(b, t),
    }
}

fn finish(drawing: &mut bool, points: &[DVec2], ends: &mut Vec<u32>) {
    if *drawing {
        end_subpath(points, ends);
        *drawing = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::{Rule, subpaths};
    use crate::polygon::{contains, ring_area};
    use crate::xorshift::Xorshift;

    /// A quarter, three quarters and the whole of an ellipse about (5, 5), 4 wide to each side and 3 high.
    fn sectors() -> [EllipticSector; 3] {
        [(0.0, 90.0), (45.0, 315.0), (0.0, 360.0)].map(|(start, end): (f64, f64)| {
            let (a, b) = (DVec2::new(4.0, 0.0), DVec2::new(0.0, 3.0));
            EllipticSector::new(DVec2::splat(5.0), a, b, start.to_radians(), (end - start).to_radians())
                .unwrap()
        })
    }

    fn pieces(sector: &EllipticSector, path: &[(f64, f64)]) -> Vec<Vec<DVec2>> {
        let path: Vec<DVec2> = path.iter().map(|&p| p.into()).collect();
        let (mut points, mut ends) = (vec![], vec![]);
        sector.polyline(&path, &mut points, &mut ends);
        assert_eq!(ends.last().copied().unwrap_or(0) as usize, points.len());
        subpaths(&points, &ends).map(<[DVec2]>::to_vec).collect()
    }

    fn near(found: &[Vec<DVec2>], expected: &[&[(f64, f64)]]) {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (a, b) in found.iter().zip(expected) {
            assert_eq!(a.len(), b.len(), "{found:?}");
            assert!(a.iter().zip(*b).all(|(&p, &q)| p.distance(q.into()) < 1e-9), "{found:?}");
        }
    }

    #[test]
    fn lines_are_cut_at_the_arc_and_at_the_radii() {
        let [quarter, most, whole] = sectors();
        let across = [(0.0, 5.0), (10.0, 5.0)];
        near(&pieces(&whole, &across), &[&[(1.0, 5.0), (9.0, 5.0)]]);
        near(&pieces(&most, &across), &[&[(1.0, 5.0), (5.0, 5.0)]]);
        let up = [(6.0, 0.0), (6.0, 5.5), (6.0, 6.0), (6.0, 10.0)];
        let top = 5.0 + 3.0 * (1.0 - 1.0 / 16.0_f64).sqrt();
        near(&pieces(&quarter, &up), &[&[(6.0, 5.0), (6.0, 5.5), (6.0, 6.0), (6.0, top)]]);
        // The open side lies between the radii at 45 and -45 degrees, which are (4, 3) and (4, -3) long.
        let bottom = 10.0 - top;
        near(&pieces(&most, &up), &[&[(6.0, bottom), (6.0, 4.25)], &[(6.0, 5.75), (6.0, 6.0), (6.0, top)]]);
    }

    #[test]
    fn what_is_inside_is_kept_and_what_is_bad_breaks_the_line() {
        let [_, _, whole] = sectors();
        let line = [(3.1, 4.7), (6.3, 5.9), (6.3, 5.9), (5.0, 3.3)];
        assert_eq!(pieces(&whole, &line), [line.map(DVec2::from).to_vec()]);
        let broken = [(5.0, 5.0), (6.0, 5.0), (f64::NAN, 5.0), (5.0, 5.0), (5.0, 6.0)];
        assert_eq!(pieces(&whole, &broken).len(), 2);
        assert_eq!(pieces(&whole, &[(5.0, 5.0)]).len(), 1);
        assert!(pieces(&whole, &[(1.0, 2.0)]).is_empty() && pieces(&whole, &[]).is_empty());
        for (a, b) in [(DVec2::ZERO, DVec2::Y), (DVec2::X, DVec2::X), (DVec2::NAN, DVec2::Y)] {
            assert!(EllipticSector::new(DVec2::ZERO, a, b, 0.0, 1.0).is_none());
        }
        assert!(EllipticSector::new(DVec2::ZERO, DVec2::X, DVec2::Y, 1.0, 0.0).is_none());
    }

    #[test]
    fn a_point_of_a_line_is_drawn_if_it_is_inside() {
        let mut random = Xorshift::new(21);
        for sector in sectors() {
            let mut judged = 0;
            for _ in 0..2_000 {
                let path = [random.point(0.0, 10.0), random.point(0.0, 10.0)];
                let (mut points, mut ends) = (vec![], vec![]);
                sector.polyline(&path, &mut points, &mut ends);
                for i in 0..=50 {
                    let p = path[0].lerp(path[1], f64::from(i) / 50.0);
                    let along = |q: DVec2| (q - path[0]).length();
                    let drawn =
                        subpaths(&points, &ends).any(|s| along(s[0]) <= along(p) && along(p) <= along(s[1]));
                    // On the boundary either is right.
                    let around = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y];
                    let expected = sector.contains(p);
                    if around.iter().all(|&d| sector.contains(p + d * 1e-6) == expected) {
                        assert_eq!(drawn, expected, "{path:?} {p}");
                        judged += 1;
                    }
                }
            }
            assert!(judged > 100_000);
        }
    }

    #[test]
    fn rings_are_cut_as_their_points_are() {
        let mut random = Xorshift::new(22);
        for sector in sectors() {
            let parts = sector.convex_parts(1e-4);
            for _ in 0..200 {
                let ring: Vec<DVec2> = (0..random.int(3, 9)).map(|_| random.point(-2.0, 12.0)).collect();
                let whole = [ring.len() as u32];
                let (mut points, mut ends) = (vec![], vec![]);
                sector.ring(&parts, &ring, &mut vec![], &mut points, &mut ends);
                for _ in 0..100 {
                    let p = random.point(-2.0, 12.0);
                    // Between the arc and its chords either is right.
                    let edge = (sector.to_circle.transform_point2(p).length() - 1.0).abs() < 1e-3;
                    if !edge {
                        let expected = sector.contains(p) && contains(&ring, &whole, Rule::EvenOdd, p);
                        assert_eq!(contains(&points, &ends, Rule::EvenOdd, p), expected, "{p}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_parts_have_the_area_of_the_sector() {
        for (sector, share) in sectors().into_iter().zip([0.25, 0.75, 1.0]) {
            let area: f64 = sector.convex_parts(1e-4).iter().map(|part| ring_area(part)).sum();
            assert!((area - PI * 12.0 * share).abs() < 1e-2, "{area}");
        }
    }
}
