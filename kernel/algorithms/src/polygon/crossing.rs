//! M. Shimrat, "Algorithm 112: Position of point relative to polygon", Communications of the ACM 5(8), 1962, as
//! corrected by R. Hacker: point in polygon by crossings.

use crate::path::{Rule, ring_edges};
use glam::DVec2;

/// Whether the point lies inside the rings by the rule.
///
/// Points on a left or lower edge are inside, those on a right or upper one outside (lower is towards smaller y), so
/// that of polygons which share an edge exactly one has each of its points.
pub fn contains(points: &[DVec2], ends: &[u32], rule: Rule, p: DVec2) -> bool {
    let mut winding = 0;
    ring_edges(points, ends, |a, b| {
        let (low, high, turn) = if a.y <= b.y { (a, b, 1) } else { (b, a, -1) };
        if low.y <= p.y && p.y < high.y && x_at(low, (high.x - low.x) / (high.y - low.y), high, p.y) <= p.x {
            winding += turn;
        }
    });
    rule.is_inside(winding)
}

/// The x of the edge from `low` to `high` at height y, never beyond its ends.
fn x_at(low: DVec2, slope: f64, high: DVec2, y: f64) -> f64 {
    (low.x + (y - low.y) * slope).max(low.x.min(high.x)).min(low.x.max(high.x))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pentagram in one stroke; its middle is turned round twice.
    fn star() -> Vec<DVec2> {
        (0..5).map(|i| DVec2::from_angle(f64::from(i) * 0.8 * std::f64::consts::PI) * 10.0).collect()
    }

    #[test]
    fn the_rules_differ_in_the_middle_of_a_star() {
        let star = star();
        assert!(!contains(&star, &[5], Rule::EvenOdd, DVec2::ZERO));
        assert!(contains(&star, &[5], Rule::NonZero, DVec2::ZERO));
        for rule in [Rule::EvenOdd, Rule::NonZero] {
            assert!(contains(&star, &[5], rule, DVec2::new(9.0, 0.1)));
            assert!(!contains(&star, &[5], rule, DVec2::new(-9.0, 0.1)));
        }
    }

    #[test]
    fn a_shared_edge_belongs_to_one_side() {
        let square = |x: f64, y: f64| {
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(u, v)| DVec2::new(x + u, y + v))
        };
        let corner = DVec2::ONE;
        let owners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)]
            .map(|(x, y)| contains(&square(x, y), &[4], Rule::EvenOdd, corner));
        assert_eq!(owners, [false, false, false, true]);
    }

    #[test]
    fn bad_input_is_outside() {
        assert!(!contains(&[], &[], Rule::EvenOdd, DVec2::ZERO));
        assert!(!contains(&star(), &[5], Rule::NonZero, DVec2::NAN));
        assert!(!contains(&[DVec2::NAN, DVec2::INFINITY], &[2], Rule::NonZero, DVec2::ZERO));
    }
}
