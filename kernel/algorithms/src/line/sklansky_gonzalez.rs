//! J. Sklansky and V. Gonzalez, "Fast polygonal approximation of digitized curves", Pattern Recognition 12(5), 1980; C. M.
//! Williams, "An efficient algorithm for the piecewise linear approximation of planar curves", Computer Graphics and Image
//! Processing 8(2), 1978: reducing a polyline by intersecting cones.

use crate::path::is_usable;
use glam::DVec2;

/// Gives vertices of a polyline such that all those left out lie within the tolerance of the line between the ones given.
///
/// Suits any line. Each chord is drawn as far as the cones allow in which it must run to pass the vertices so far.
pub fn sklansky_gonzalez(path: impl IntoIterator<Item = DVec2>, tolerance: f64, mut emit: impl FnMut(DVec2)) {
    // A vertex may lie this far beside the chord and this far beyond its end, which together is the tolerance.
    let slack = tolerance.max(0.0) * std::f64::consts::FRAC_1_SQRT_2;
    let mut chord: Option<Chord> = None;
    for p in path {
        if !is_usable(p) {
            if let Some(end) = chord.take().and_then(|chord| chord.end) {
                emit(end);
            }
            emit(p);
            continue;
        }
        let Some(current) = &mut chord else {
            emit(p);
            chord = Some(Chord::from(p));
            continue;
        };
        if !current.reaches(p, slack) {
            let end = current.end.unwrap_or(current.from);
            emit(end);
            *current = Chord::from(end);
            current.reaches(p, slack);
        }
    }
    if let Some(end) = chord.and_then(|chord| chord.end) {
        emit(end);
    }
}

/// A chord under construction.
struct Chord {
    from: DVec2,
    /// The last vertex at which the chord might end.
    end: Option<DVec2>,
    /// The right and the left side of the cone, as unit vectors, once a vertex restricts it.
    cone: Option<(DVec2, DVec2)>,
    /// The greatest distance of a vertex from the beginning.
    farthest: f64,
}

impl Chord {
    fn from(p: DVec2) -> Self {
        Self { from: p, end: None, cone: None, farthest: 0.0 }
    }

    /// Moves the end to `p` unless a vertex before it would then be too far away.
    fn reaches(&mut self, p: DVec2, slack: f64) -> bool {
        let d = p - self.from;
        let distance = d.length();
        if distance + slack < self.farthest {
            return false;
        }
        if let Some((right, left)) = self.cone {
            // Without the last test a cone without width would be open backwards as well.
            if right.perp_dot(d) < 0.0 || d.perp_dot(left) < 0.0 || (right + left).dot(d) <= 0.0 {
                return false;
            }
        }
        if distance > slack {
            // The tangents from the beginning to the circle round the vertex.
            let ahead = d * ((distance - slack) * (distance + slack)).sqrt();
            let aside = d.perp() * slack;
            let square = distance * distance;
            let (mut right, mut left) = ((ahead - aside) / square, (ahead + aside) / square);
            if let Some(cone) = self.cone {
                right = if cone.0.perp_dot(right) > 0.0 { right } else { cone.0 };
                left = if left.perp_dot(cone.1) > 0.0 { left } else { cone.1 };
            }
            self.cone = Some((right, left));
        }
        self.farthest = self.farthest.max(distance);
        self.end = Some(p);
        true
    }
}
