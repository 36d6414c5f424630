//! Areas with their edges, and cell arrays.

use super::line::Outline;
use super::{Drawing, Entry, Interpreter};
use crate::cgm::decoder::Decoder;
use crate::cgm::element::{Cells, Element};
use crate::generated::elements::Kind;
use gks_geometry::{PathBuf, Point, Vector, Wc};
use gks_pipeline::item::{Ellipse, Parallelogram, Role};
use gks_pipeline::look::{InteriorStyle, Look};
use gks_pipeline::tables::Pattern;
use glam::DVec2;

impl<D: Decoder> Interpreter<D> {
    pub(super) fn area(&mut self, e: &Element) -> bool {
        match e.kind {
            Kind::Polygon => {
                if let Some(points) = e.points(0).filter(|points| points.len() > 2) {
                    self.polygon(points);
                }
            }
            Kind::Rectangle => {
                if let (Some(a), Some(b)) = (e.point(0), e.point(1)) {
                    self.polygon(&[a, DVec2::new(b.x, a.y), b, DVec2::new(a.x, b.y)]);
                }
            }
            Kind::PolygonSet => self.polygon_set(e),
            Kind::CellArray => {
                if let (Some(p), Some(q), Some(r), Some(cells)) =
                    (e.point(0), e.point(1), e.point(2), e.cells(3))
                {
                    self.cells(p, r - p, q - r, cells);
                } else {
                    self.senseless(e);
                }
            }
            _ => return false,
        }
        true
    }

    fn polygon(&mut self, points: &[DVec2]) {
        let mut ring = PathBuf::new();
        ring.add(points.iter().copied());
        let mut edges = PathBuf::new();
        edges.add(points.iter().chain(points.first()).copied());
        self.fill_polygon(ring, edges);
    }

    /// Polygons whose every edge says whether it is visible and whether it closes its polygon.
    fn polygon_set(&mut self, e: &Element) {
        let (mut rings, mut edges) = (PathBuf::new(), PathBuf::new());
        let mut ring: Vec<(DVec2, bool)> = Vec::new();
        for place in (0..e.values.len()).step_by(2) {
            let (Some(point), flag) = (e.point(place), e.integer(place + 1).unwrap_or(1)) else { continue };
            ring.push((point, flag & 1 == 1));
            if flag >= 2 {
                close(&mut ring, &mut rings, &mut edges);
            }
        }
        close(&mut ring, &mut rings, &mut edges);
        self.fill_polygon(rings, edges);
    }

    fn fill_polygon(&mut self, rings: PathBuf<Wc>, edges: PathBuf<Wc>) {
        if let Some(figure) = &mut self.figure {
            for (i, ring) in rings.as_paths().iter().enumerate() {
                let none = PathBuf::new();
                figure.add_region(ring, if i == 0 { &edges } else { &none });
            }
            return;
        }
        self.fill(Outline::Lines(rings));
        if self.context.edges {
            self.stroke_edge(Outline::Lines(edges));
        }
    }

    /// Fills what an outline encloses, without edges.
    pub(super) fn fill(&mut self, outline: Outline) {
        let Some(look) = self.fill_look() else { return };
        let hatch = (look.fill.interior == InteriorStyle::Hatch).then(|| self.context.fill().hatch);
        if hatch.is_some() && !self.context.transparent {
            let mut between = look.clone();
            between.fill.interior = InteriorStyle::Solid;
            between.fill.colour = self.index(self.context.auxiliary);
            self.draw_area(outline.clone(), between);
        }
        match hatch.and_then(|hatch| self.context.hatches.get(&hatch)).cloned() {
            Some(hatch) => self.hatch(outline, &hatch, look),
            None => self.draw_area(outline, look),
        }
    }

    fn draw_area(&mut self, outline: Outline, look: Look) {
        let mapping = self.mapping();
        self.draw(outline.drawing(Role::Area, &mapping), look);
    }

    /// Fills an ellipse or a closed part of one, and draws its edge.
    pub(super) fn fill_ellipse(&mut self, ellipse: &Ellipse<Wc>) {
        if self.figure.is_some() {
            let tolerance = self.tolerance();
            if let Some(figure) = &mut self.figure {
                let ring = figure.flattened(Outline::Ellipse(*ellipse), tolerance);
                figure.add_region(&ring.points, &ring);
            }
            return;
        }
        self.fill(Outline::Ellipse(*ellipse));
        if self.context.edges {
            self.stroke_edge(Outline::Ellipse(*ellipse));
        }
    }

    /// The look of areas; none if their interior is empty.
    fn fill_look(&mut self) -> Option<Look> {
        let mapping = self.mapping();
        let fill = self.context.fill();
        let mut look = self.queue.look().clone();
        look.fill.interior = match fill.style {
            1 | 6 => InteriorStyle::Solid,
            2 if self.context.patterns.contains_key(&fill.pattern) => InteriorStyle::Pattern,
            3 => InteriorStyle::Hatch,
            4 => return None,
            _ => InteriorStyle::Hollow,
        };
        look.fill.colour = self.index(fill.ink);
        match look.fill.interior {
            InteriorStyle::Hatch => look.fill.style = if fill.hatch == 0 { 1 } else { fill.hatch },
            InteriorStyle::Pattern => {
                look.fill.style = fill.pattern;
                self.tell_pattern(fill.pattern);
                let (first, second) = mapping.extent;
                let size = second - first;
                let whole = (DVec2::new(0.0, size.y), DVec2::new(size.x, 0.0));
                let (height, width) = self.context.pattern_size.unwrap_or(whole);
                look.pattern.height = mapping.vector(height);
                look.pattern.width = mapping.vector(width);
                let reference = mapping.point(self.context.reference.unwrap_or(first));
                look.pattern.reference = Point::from_vec(reference);
            }
            InteriorStyle::Hollow | InteriorStyle::Solid => {}
        }
        Some(look)
    }

    /// Makes the workstation have a pattern.
    fn tell_pattern(&mut self, number: i32) {
        let (Some(cells), Ok(index)) = (self.context.patterns.get(&number), u32::try_from(number)) else {
            return;
        };
        let indices = self.palette.cells(cells, &self.context.colours, &mut self.queue);
        if self.patterns.get(&index) != Some(&indices) {
            self.patterns.insert(index, indices.clone());
            let pattern = Pattern { columns: cells.columns, rows: cells.rows, indices };
            self.queue.push(Entry::Pattern(index, pattern));
        }
    }

    /// Draws cells from a corner on, columns and rows along two edges, in virtual device coordinates.
    pub(super) fn cells(&mut self, corner: DVec2, columns: DVec2, rows: DVec2, cells: &Cells) {
        let mapping = self.mapping();
        let indices = self.palette.cells(cells, &self.context.colours, &mut self.queue);
        let place = Parallelogram {
            origin: Point::from_vec(mapping.point(corner)),
            columns: Vector::from_vec(mapping.vector(columns).0),
            rows: Vector::from_vec(mapping.vector(rows).0),
        };
        let look = self.queue.look().clone();
        self.draw(Drawing::Cells(place, cells.columns, cells.rows, indices), look);
    }
}

/// Ends a ring: its points, and those of its edges that are visible, joined where they follow one another.
fn close(ring: &mut Vec<(DVec2, bool)>, rings: &mut PathBuf<Wc>, edges: &mut PathBuf<Wc>) {
    for (i, &(point, visible)) in ring.iter().enumerate() {
        if visible {
            if edges.points.len() == edges.start() {
                edges.push(point);
            }
            edges.push(ring[(i + 1) % ring.len()].0);
        } else {
            edges.end();
        }
    }
    edges.end();
    rings.add(ring.drain(..).map(|(point, _)| point));
}
