//! Lines, markers, text, areas and cells.

use super::CgmRecorder;
use super::attributes::encoded;
use crate::cgm::MOST_LINES;
use crate::cgm::element::{self, Inks, Value};
use crate::generated::elements::Kind;
use gks_algorithms::clip;
use gks_geometry::{Ndc, Paths, Point};
use gks_pipeline::generated::numbers::escape;
use gks_pipeline::item::{Cells, Parallelogram};
use gks_pipeline::look::Look;
use glam::DVec2;
use std::borrow::Cow;

impl CgmRecorder {
    /// The rectangle in NDC whose coordinates can be written.
    fn reach(&self) -> (DVec2, DVec2) {
        let most = DVec2::splat(self.grid.most / self.scale);
        (self.origin - most, self.origin + most)
    }

    fn points(&self, points: &[DVec2]) -> Vec<DVec2> {
        points.iter().map(|&p| self.coordinates(p)).collect()
    }

    pub(super) fn lines(&mut self, paths: Paths<'_, Ndc>, look: &Look) {
        self.set_line(look);
        let (least, most) = self.reach();
        if paths.points.iter().all(|p| p.cmpge(least).all() && p.cmple(most).all()) {
            return self.polylines(paths);
        }
        // What is far away would not keep its direction.
        let (mut points, mut ends) = (Vec::new(), Vec::new());
        for path in paths.iter() {
            clip::polyline((least, most), path, &mut points, &mut ends);
        }
        self.polylines(Paths::new(&points, &ends));
    }

    /// Lines that are drawn as one: an escape says how many, for readers to whom that matters where they overlap.
    fn polylines(&mut self, paths: Paths<'_, Ndc>) {
        let count = paths.iter().count();
        if (2..=MOST_LINES).contains(&count) && !self.settings.plain {
            let data = count.to_string().into_bytes();
            self.put(Kind::Escape, [Value::Integer(escape::COMPOUND_PRIMITIVE), Value::Data(data)]);
        }
        paths.iter().for_each(|path| self.polyline(path));
    }

    fn polyline(&mut self, path: &[DVec2]) {
        let points = self.points(path);
        self.put(Kind::Polyline, [Value::Points(points)]);
    }

    pub(super) fn markers(&mut self, points: &[DVec2], look: &Look) {
        self.set_marker(look);
        let points = self.points(points);
        self.put(Kind::Polymarker, [Value::Points(points)]);
    }

    pub(super) fn text(&mut self, at: Point<Ndc>, text: &str, look: &Look) {
        self.set_text(look);
        let at = Value::Point(self.coordinates(at.0));
        let octets = Value::Text(encoded(text).into_owned());
        self.put(Kind::Text, [at, Value::Integer(1), octets]);
    }

    pub(super) fn area(&mut self, rings: Paths<'_, Ndc>, look: &Look) {
        self.set_fill(look);
        let reach = self.reach();
        let mut all: Vec<Cow<'_, [DVec2]>> = Vec::new();
        for ring in rings.iter() {
            if ring.iter().all(|p| p.cmpge(reach.0).all() && p.cmple(reach.1).all()) {
                all.push(Cow::Borrowed(ring));
            } else {
                let (mut inside, mut ends) = (Vec::new(), Vec::new());
                clip::sutherland_hodgman(reach, ring, &mut inside, &mut ends);
                all.push(Cow::Owned(inside));
            }
        }
        match &all[..] {
            [ring] => {
                let points = self.points(ring);
                self.put(Kind::Polygon, [Value::Points(points)]);
            }
            // One ring that goes to each of the others and back, along lines without width.
            [first, others @ ..] if self.settings.plain => {
                let mut points = self.points(first);
                let start = points.first().copied();
                for ring in others {
                    let ring = self.points(ring);
                    points.extend(start);
                    points.extend(ring.iter().chain(ring.first()));
                }
                points.extend(start);
                self.put(Kind::Polygon, [Value::Points(points)]);
            }
            rings => {
                let mut values = Vec::new();
                for ring in rings {
                    for (i, &p) in ring.iter().enumerate() {
                        let flag = if i + 1 == ring.len() { 3 } else { 1 };
                        values.extend([Value::Point(self.coordinates(p)), Value::Integer(flag)]);
                    }
                }
                self.put(Kind::PolygonSet, values);
            }
        }
    }

    pub(super) fn cells(&mut self, place: &Parallelogram<Ndc>, cells: &Cells<'_>) {
        let mut indices = Vec::with_capacity(cells.columns * cells.rows);
        // Neighbours are often alike, and the index of a colour takes some looking.
        let mut last = None;
        for row in 0..cells.rows {
            for &index in cells.row(row) {
                let written = match last {
                    Some((same, written)) if same == index => written,
                    _ => self.cell(index),
                };
                last = Some((index, written));
                indices.push(written);
            }
        }
        let [p, r, q, _] = place.corners().map(|corner| Value::Point(self.coordinates(corner.0)));
        let (columns, rows) = (cells.columns, cells.rows);
        let cells = element::Cells { columns, rows, inks: Inks::Indices(indices) };
        self.put(Kind::CellArray, [p, q, r, Value::Cells(cells)]);
    }
}
