//! Lines and markers.

use super::context::Line;
use super::mapping::Mapping;
use super::{Drawing, Interpreter};
use crate::cgm::MOST_LINES;
use crate::cgm::coding::SizeMode;
use crate::cgm::decoder::Decoder;
use crate::cgm::element::Element;
use crate::generated::elements::Kind;
use gks_algorithms::line::dash;
use gks_algorithms::{curve, ellipse};
use gks_geometry::{Ndc, PathBuf, Paths, Point, Wc};
use gks_pipeline::generated::numbers;
use gks_pipeline::item::{Closure, Ellipse, Role};
use gks_pipeline::look::Look;
use glam::DVec2;

/// The most points that are kept of a primitive that comes in parts.
const MOST_POINTS: usize = 1 << 20;

/// How many dashes a line may fall into.
const MOST_DASHES: usize = 100_000;

/// What lines are drawn along, in virtual device coordinates.
#[derive(Clone)]
pub(super) enum Outline {
    /// Polylines.
    Lines(PathBuf<Wc>),
    /// An ellipse or a part of one.
    Ellipse(Ellipse<Wc>),
    /// Bezier curves, a start point and three points for each.
    Bezier(Vec<DVec2>),
}

/// Our linetype for a line type: those of the standard and of the register of ISO, and our own.
pub(super) fn linetype(kind: i32) -> i32 {
    match kind {
        1..=4 => kind,
        // Dash-dot-dot, phantom.
        5 | 13 => -1,
        // Single dot.
        7 => 3,
        // Stitch line, hidden.
        9 | 12 => 2,
        // Chain, centre.
        10 => 4,
        11 => -6,
        _ if numbers::LINETYPES.iter().any(|own| own.number == kind) => kind,
        _ => 1,
    }
}

impl Outline {
    /// A single polyline.
    pub(super) fn path(points: impl IntoIterator<Item = DVec2>) -> Outline {
        let mut paths = PathBuf::new();
        paths.add(points);
        Outline::Lines(paths)
    }

    /// What the outline is drawn as, in NDC.
    pub(super) fn drawing(self, role: Role, mapping: &Mapping) -> Drawing {
        match self {
            Outline::Lines(lines) => {
                let mut mapped = PathBuf::new();
                mapped.add_mapped(lines.as_paths(), &mapping.map);
                match role {
                    Role::Line => Drawing::Lines(mapped),
                    Role::Area => Drawing::Area(mapped),
                }
            }
            Outline::Ellipse(ellipse) => Drawing::Ellipse(ellipse.mapped(&mapping.map), role),
            Outline::Bezier(points) => {
                Drawing::Bezier(points.into_iter().map(|p| mapping.point(p)).collect(), role)
            }
        }
    }

    /// The outline as polylines.
    pub(super) fn flattened(self, tolerance: f64) -> PathBuf<Wc> {
        let mut paths = PathBuf::new();
        match self {
            Outline::Lines(lines) => return lines,
            Outline::Bezier(points) => curve::chain(&points, tolerance, &mut paths.points),
            Outline::Ellipse(e) => {
                ellipse::flatten(e.centre.0, e.a.0, e.b.0, e.start, e.sweep, tolerance, &mut paths.points);
                match e.closure {
                    Closure::Full | Closure::Open => {}
                    Closure::Chord => paths.push(e.at(e.start).0),
                    Closure::Pie => {
                        paths.push(e.centre.0);
                        paths.push(e.at(e.start).0);
                    }
                }
            }
        }
        paths.end();
        paths
    }
}

impl<D: Decoder> Interpreter<D> {
    pub(super) fn line(&mut self, e: &Element) -> bool {
        match e.kind {
            Kind::Polyline => {
                if let Some(points) = e.points(0).filter(|points| points.len() > 1) {
                    self.polyline(points);
                }
            }
            Kind::DisjointPolyline => {
                let mut lines = PathBuf::new();
                for pair in e.points(0).unwrap_or_default().chunks_exact(2) {
                    lines.add(pair.iter().copied());
                }
                self.stroke(Outline::Lines(lines));
            }
            Kind::Polymarker => self.markers(e.points(0).unwrap_or_default()),
            _ => return false,
        }
        true
    }

    /// Draws a polyline, or keeps it until those that belong to it have come.
    fn polyline(&mut self, points: &[DVec2]) {
        if self.compound.0 == 0 {
            return self.stroke(Outline::path(points.iter().copied()));
        }
        let (left, lines) = &mut self.compound;
        *left -= 1;
        lines.add(points.iter().copied());
        if *left == 0 || lines.points.len() > MOST_POINTS {
            self.end_compound();
        }
    }

    /// Says how many of the polylines that follow are one primitive.
    pub(super) fn begin_compound(&mut self, e: &Element) {
        let text = e.bytes(1).and_then(|data| std::str::from_utf8(data).ok());
        self.end_compound();
        self.compound.0 = text.and_then(|text| text.parse().ok()).filter(|n| *n <= MOST_LINES).unwrap_or(0);
    }

    /// Draws the polylines that have come of one primitive.
    pub(super) fn end_compound(&mut self) {
        let (_, lines) = std::mem::take(&mut self.compound);
        if !lines.ends.is_empty() {
            self.stroke(Outline::Lines(lines));
        }
    }

    fn markers(&mut self, points: &[DVec2]) {
        let mapping = self.mapping();
        let marker = self.context.marker();
        let mut look = self.queue.look().clone();
        look.marker.kind = match marker.kind {
            kind if numbers::MARKERS.iter().any(|own| own.number == kind) => kind,
            _ => 3,
        };
        look.marker.size =
            mapping.marker_size(marker.size, self.context.modes.marker_size, self.context.metric);
        look.marker.colour = self.index(marker.ink);
        let points = points.iter().map(|&p| mapping.point(p)).collect();
        self.draw(Drawing::Markers(points), look);
    }

    /// Draws lines with the attributes of lines, or adds them to the figure.
    pub(super) fn stroke(&mut self, outline: Outline) {
        if self.figure.is_some() {
            let tolerance = self.tolerance();
            if let Some(figure) = &mut self.figure {
                figure.add(outline, tolerance);
            }
            return;
        }
        let line = self.context.line();
        self.draw_outline(outline, &line, self.context.modes.line_width);
    }

    /// Draws the edge of something.
    pub(super) fn stroke_edge(&mut self, outline: Outline) {
        let line = self.context.edge();
        self.draw_outline(outline, &line, self.context.modes.edge_width);
    }

    /// How far chords may be from curves, in virtual device coordinates: what is not seen on any device.
    pub(super) fn tolerance(&mut self) -> f64 {
        1e-5 / self.mapping().scale
    }

    fn draw_outline(&mut self, outline: Outline, line: &Line, mode: SizeMode) {
        let mapping = self.mapping();
        let mut look = self.queue.look().clone();
        look.line.linetype = linetype(line.kind);
        look.line.width = mapping.line_width(line.width, mode, self.context.metric);
        (look.cap, look.join) = (line.cap, line.join);
        let pattern = self.dashes(line);
        if !self.context.transparent && (pattern.is_some() || look.line.linetype != 1) {
            let mut between = look.clone();
            between.line.linetype = 1;
            between.line.colour = self.index(self.context.auxiliary);
            self.draw_lines(outline.clone(), between);
        }
        look.line.colour = self.index(line.ink);
        match pattern {
            Some(pattern) => {
                look.line.linetype = 1;
                let lines = outline.flattened(self.tolerance());
                self.dashed(lines.as_paths(), &pattern, line, look);
            }
            None => self.draw_lines(outline, look),
        }
    }

    fn draw_lines(&mut self, outline: Outline, look: Look) {
        let mapping = self.mapping();
        self.draw(outline.drawing(Role::Line, &mapping), look);
    }

    /// Dashes and gaps in NDC, where a line is dashed in another way than our linetypes are.
    fn dashes(&mut self, line: &Line) -> Option<Vec<f64>> {
        let own = numbers::LINETYPES.iter().find(|own| own.number == linetype(line.kind));
        let own = own.map_or(&[][..], |own| own.dashes);
        let (mode, lengths) = match self.context.dashes.get(&line.kind) {
            Some((mode, lengths)) => (*mode, lengths.as_slice()),
            None => (SizeMode::Scaled, own),
        };
        let same = mode == SizeMode::Scaled
            && lengths.len() == own.len()
            && lengths.iter().zip(own).all(|(length, own)| (length - own).abs() < 1e-3);
        if same && (own.is_empty() || line.offset == 0.0 && !line.restarts) {
            return None;
        }
        let lengths = lengths.to_vec();
        let (mapping, metric) = (self.mapping(), self.context.metric);
        Some(lengths.into_iter().map(|length| mapping.style(length, mode, metric)).collect())
    }

    /// Lines with dashes of any kind.
    fn dashed(&mut self, lines: Paths<'_, Wc>, pattern: &[f64], line: &Line, look: Look) {
        let mapping = self.mapping();
        let window = mapping.window.grown(0.1);
        let area = (window.min.0, window.max.0);
        let mut mapped = PathBuf::<Ndc>::new();
        mapped.add_mapped(lines, &mapping.map);
        let phase = line.offset * pattern.iter().sum::<f64>();
        let mut pieces = PathBuf::<Ndc>::new();
        let mut cut = |path: &[DVec2]| {
            let limit = MOST_DASHES.saturating_sub(pieces.ends.len());
            dash(area, path, pattern, phase, limit, &mut pieces.points, &mut pieces.ends);
        };
        for path in mapped.as_paths().iter() {
            if line.restarts { path.windows(2).for_each(&mut cut) } else { cut(path) }
        }
        self.draw(Drawing::Lines(pieces), look);
    }
}

/// The ellipse with a centre, two conjugate half diameters, and a range of the parameter.
pub(super) fn ellipse(
    centre: DVec2,
    a: DVec2,
    b: DVec2,
    (start, sweep): (f64, f64),
    closure: Closure,
) -> Ellipse<Wc> {
    let (a, b) = (gks_geometry::Vector::from_vec(a), gks_geometry::Vector::from_vec(b));
    Ellipse { centre: Point::from_vec(centre), a, b, start, sweep, closure }
}
