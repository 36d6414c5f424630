//! Closed figures: regions bounded by lines that elements between BEGIN FIGURE and END FIGURE draw.

use super::Interpreter;
use super::line::Outline;
use crate::cgm::decoder::Decoder;
use gks_geometry::{PathBuf, Wc};
use glam::DVec2;

/// The points that stand for curves in one figure, before they become fewer.
const MOST_CHORDS: usize = 1 << 18;

/// A figure under construction, in virtual device coordinates.
#[derive(Clone, Debug, Default)]
pub(super) struct Figure {
    regions: PathBuf<Wc>,
    /// The boundary that is being drawn.
    boundary: Vec<DVec2>,
    /// Whether an edge leads from where the boundary is to where it goes on.
    connected: bool,
    edges: PathBuf<Wc>,
    /// How many points stand for curves.
    chords: usize,
    /// The Bezier curves that are all there is so far.
    curves: Option<Vec<DVec2>>,
}

impl Figure {
    fn add_lines(&mut self, lines: &PathBuf<Wc>) {
        for path in lines.as_paths().iter() {
            self.connect(path.first());
            self.boundary.extend_from_slice(path);
            self.edges.add(path.iter().copied());
        }
    }

    /// Goes on with the boundary along an outline, in chords that are as near to it as a tolerance says.
    pub(super) fn add(&mut self, outline: Outline, tolerance: f64) {
        let is_first = self.boundary.is_empty() && self.regions.ends.is_empty();
        self.curves = match &outline {
            Outline::Bezier(points) if is_first => Some(points.clone()),
            _ => None,
        };
        let lines = self.flattened(outline, tolerance);
        self.add_lines(&lines);
    }

    /// An outline in chords; in few of them if there are very many already.
    pub(super) fn flattened(&mut self, outline: Outline, tolerance: f64) -> PathBuf<Wc> {
        let is_curve = !matches!(outline, Outline::Lines(_));
        let lines = outline.flattened(if self.chords < MOST_CHORDS { tolerance } else { f64::INFINITY });
        self.chords += if is_curve { lines.points.len() } else { 0 };
        lines
    }

    /// Adds the boundary of an area as a region of its own.
    pub(super) fn add_region(&mut self, ring: &[DVec2], edges: &PathBuf<Wc>) {
        self.curves = None;
        self.regions.add(ring.iter().copied());
        for path in edges.as_paths().iter() {
            self.edges.add(path.iter().copied());
        }
    }

    /// Makes the way to where the boundary goes on next an edge; without this it only bounds the region.
    pub(super) fn connecting_edge(&mut self) {
        self.connected = true;
    }

    fn connect(&mut self, next: Option<&DVec2>) {
        if std::mem::take(&mut self.connected)
            && let (Some(last), Some(next)) = (self.boundary.last(), next)
            && last != next
        {
            self.edges.add([*last, *next]);
        }
    }

    /// Closes the boundary that is being drawn.
    pub(super) fn end_region(&mut self) {
        let first = self.boundary.first().copied();
        self.connect(first.as_ref());
        self.regions.add(self.boundary.drain(..));
    }
}

impl<D: Decoder> Interpreter<D> {
    /// Draws the figure.
    pub(super) fn end_figure(&mut self) {
        let Some(mut figure) = self.figure.take() else { return };
        figure.end_region();
        match figure.curves {
            Some(curves) => self.fill(Outline::Bezier(curves)),
            None => self.fill(Outline::Lines(figure.regions)),
        }
        if self.context.edges {
            self.stroke_edge(Outline::Lines(figure.edges));
        }
    }
}
