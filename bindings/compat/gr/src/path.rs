//! Paths as GR describes them: a code for each step, and points.

use gks_algorithms::curve;
use glam::DVec2;
use std::f64::consts::PI;
use std::ffi::c_int;

/// The angle between neighbouring points of an arc.
const STEP: f64 = PI / 90.0;

/// What is done with the part of a path that ends.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct Paint {
    /// Whether its inside is filled.
    pub(crate) fill: bool,
    /// Whether its edge is drawn.
    pub(crate) stroke: bool,
}

/// A part of a path: lines of points in world coordinates, and what is done with them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) lines: Vec<Vec<DVec2>>,
    pub(crate) paint: Paint,
}

/// The parts of a path. Codes are letters: M and L go to a point, Q and C along Bezier curves, A along an arc of an ellipse
/// (half axes, then angles), small letters are relative to where the path is; Z closes. S and s draw the edge, f and g fill, F
/// and G do both; all of these but S close. Other codes, and those whose points are missing, are passed over.
pub(crate) fn parts(codes: &[c_int], points: &[DVec2]) -> Vec<Part> {
    let extent = points.iter().fold(0.0_f64, |most, p| most.max(p.abs().max_element()));
    let mut pen = Pen { tolerance: extent * 1e-4, ..Pen::default() };
    let mut parts = Vec::new();
    let mut rest = points;
    for &code in codes {
        let Ok(code) = u8::try_from(code) else { continue };
        let needed = match code.to_ascii_uppercase() {
            b'M' | b'L' => 1,
            b'Q' => 2,
            b'C' | b'A' => 3,
            _ => 0,
        };
        let Some((given, after)) = rest.split_at_checked(needed) else { continue };
        rest = after;
        match (code, given) {
            (b'A' | b'a', &[axes, angles, _]) => pen.arc(axes.abs(), angles.x, angles.y),
            (_, [_, ..]) => pen.step(code.to_ascii_uppercase(), given, code.is_ascii_lowercase()),
            (b'Z', _) => pen.close(),
            _ => {
                let Some(paint) = paint(code) else { continue };
                if code != b'S' {
                    pen.close();
                }
                parts.push(Part { lines: pen.take(), paint });
            }
        }
    }
    parts
}

fn paint(code: u8) -> Option<Paint> {
    let (fill, stroke) = match code {
        b'S' | b's' => (false, true),
        b'f' | b'g' => (true, false),
        b'F' | b'G' => (true, true),
        _ => return None,
    };
    Some(Paint { fill, stroke })
}

/// Where a path is.
#[derive(Default)]
struct Pen {
    lines: Vec<Vec<DVec2>>,
    at: DVec2,
    start: DVec2,
    tolerance: f64,
}

impl Pen {
    /// The line that is being drawn.
    fn line(&mut self) -> &mut Vec<DVec2> {
        if self.lines.is_empty() {
            self.lines.push(vec![self.at]);
        }
        let last = self.lines.len() - 1;
        &mut self.lines[last]
    }

    fn step(&mut self, code: u8, given: &[DVec2], relative: bool) {
        let origin = if relative { self.at } else { DVec2::ZERO };
        let (from, tolerance) = (self.at, self.tolerance);
        let to: Vec<DVec2> = given.iter().map(|&p| origin + p).collect();
        match (code, to.as_slice()) {
            (b'M', &[p]) => {
                self.lines.push(vec![p]);
                self.start = p;
            }
            (_, &[p]) => self.line().push(p),
            (_, &[a, p]) => curve::quadratic([from, a, p], tolerance, self.line()),
            (_, &[a, b, p]) => curve::cubic([from, a, b, p], tolerance, self.line()),
            _ => {}
        }
        self.at = to.last().copied().unwrap_or(self.at);
    }

    /// Goes along an ellipse, from one angle to another.
    fn arc(&mut self, axes: DVec2, from: f64, to: f64) {
        if !(from.is_finite() && to.is_finite()) || (to - from).abs() > 100.0 * PI {
            return;
        }
        let centre = self.at - axes * DVec2::from_angle(from);
        let steps = ((to - from).abs() / STEP).ceil().max(1.0);
        for step in 1..=steps as u32 {
            let angle = from + (to - from) * f64::from(step) / steps;
            let p = centre + axes * DVec2::from_angle(angle);
            self.line().push(p);
            self.at = p;
        }
    }

    fn close(&mut self) {
        let start = self.start;
        if let Some(line) = self.lines.last_mut().filter(|line| line.len() > 1) {
            line.push(start);
        }
        self.at = start;
    }

    /// The lines up to here; what follows begins anew.
    fn take(&mut self) -> Vec<Vec<DVec2>> {
        let lines = std::mem::take(&mut self.lines);
        lines.into_iter().filter(|line| line.len() > 1).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(codes: &str, points: &[(f64, f64)]) -> Vec<Part> {
        let codes: Vec<c_int> = codes.bytes().map(c_int::from).collect();
        let points: Vec<DVec2> = points.iter().map(|&p| p.into()).collect();
        parts(&codes, &points)
    }

    #[test]
    fn lines_are_closed_and_filled() {
        let found = path("MllF", &[(1.0, 1.0), (2.0, 0.0), (0.0, 2.0)]);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].paint, Paint { fill: true, stroke: true });
        let corners = [(1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 1.0)].map(DVec2::from);
        assert_eq!(found[0].lines, [corners]);
    }

    #[test]
    fn an_open_line_stays_open_and_a_path_may_have_holes() {
        let found = path("MLS", &[(0.0, 0.0), (1.0, 0.0)]);
        assert_eq!(found[0].lines[0].len(), 2);
        let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (1.0, 1.0), (2.0, 1.0), (2.0, 2.0)];
        let found = path("MLLZMLLf", &square);
        assert_eq!(found[0].lines.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
    }

    #[test]
    fn arcs_begin_where_the_path_is() {
        let found = path("MAS", &[(2.0, 1.0), (1.0, 1.0), (0.0, PI), (0.0, 0.0)]);
        let line = &found[0].lines[0];
        assert!((line[line.len() - 1] - DVec2::new(0.0, 1.0)).length() < 1e-12);
        assert!(line.iter().all(|p| ((*p - DVec2::new(1.0, 1.0)).length() - 1.0).abs() < 1e-12));
    }

    #[test]
    fn curves_end_at_their_last_point() {
        let found = path("MQCS", &[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (3.0, 1.0), (4.0, 1.0), (5.0, 0.0)]);
        let line = &found[0].lines[0];
        assert!(line.len() > 8 && line[line.len() - 1] == DVec2::new(5.0, 0.0), "{line:?}");
    }

    #[test]
    fn what_is_missing_or_unknown_is_passed_over() {
        assert!(path("MLLS", &[(0.0, 0.0)]).iter().all(|part| part.lines.is_empty()));
        assert!(path("?", &[]).is_empty());
        assert_eq!(path("MAS", &[(0.0, 0.0), (1.0, 1.0), (0.0, f64::NAN), (0.0, 0.0)])[0].lines.len(), 0);
    }
}
