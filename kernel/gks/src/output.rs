//! Output primitives.

#![allow(clippy::redundant_closure, reason = "enum variants are no functions of all lifetimes")]

use crate::gks::{Target, device_error};
use crate::{Error, Function, Gks, Points, Result};
use gks_geometry::{LongLine, Ndc, Paths, Point, Wc};
use gks_pipeline::device::Drawn;
use gks_pipeline::item::{Cells, Item, Parallelogram, Shape};
use gks_pipeline::workstation::Workstation;

/// As many points are a long line, which devices may draw without holding it.
const LONG: usize = 1 << 16;

impl Gks {
    /// POLYLINE: lines from each point to the next.
    ///
    /// Points whose coordinates are not finite break the line. Errors: 5, 100 (fewer than two points).
    #[inline]
    pub fn polyline<'p>(&mut self, points: impl Into<Points<'p>>) -> Result<()> {
        self.polyline_through(&points.into())
    }

    fn polyline_through(&mut self, points: &Points<'_>) -> Result<()> {
        const F: Function = Function::Polyline;
        self.check_state(F)?;
        at_least(F, points, 2)?;
        if points.len() >= LONG && self.open_segment.is_none() && self.look.clip_sector.is_none() {
            return self.long_polyline(points);
        }
        self.normalize(points, 2, true);
        self.output_paths(F, |paths: Paths<'_, Ndc>| Shape::Polyline(paths))
    }

    /// Draws a polyline that is in no segment on every active workstation; its points are copied only if a
    /// workstation has to hold them.
    fn long_polyline(&mut self, points: &Points<'_>) -> Result<()> {
        let Gks { workstations, segments, look, normalization, pick, paths, parts, .. } = self;
        let line = LongLine::new(*points, normalization.map, parts);
        let clip = normalization.clip;
        paths.clear();
        let mut draw = |id, workstation: &mut Workstation| {
            if workstation.is_regeneration_due() {
                workstation.redraw(segments.on(id))?;
            }
            if workstation.draw_long_line(&line, look, &clip)? == Drawn::Yes {
                return Ok(());
            }
            if paths.ends.is_empty() {
                paths.add_pieces(&line);
            }
            let shape = Shape::Polyline(paths.as_paths());
            workstation.draw(&Item { shape, look, clip, pick: *pick })
        };
        let mut failure = Ok(());
        for (&id, open) in workstations.iter_mut().filter(|(_, open)| open.active) {
            let drawn = draw(id, &mut open.workstation);
            failure = failure.and(drawn.map_err(|error| device_error(Function::Polyline, &error)));
        }
        failure
    }

    /// POLYMARKER: a marker at each point.
    ///
    /// Points whose coordinates are not finite are left out. Errors: 5, 100 (no point).
    pub fn polymarker<'p>(&mut self, points: impl Into<Points<'p>>) -> Result<()> {
        const F: Function = Function::Polymarker;
        self.check_state(F)?;
        let points = points.into();
        at_least(F, &points, 1)?;
        // Markers have nothing to do with one another: a great many need not be held together, unless a segment does.
        let most = if self.open_segment.is_some() { points.len() } else { LONG };
        let mut done = Ok(());
        for from in (0..points.len()).step_by(most) {
            self.normalize(&points.part(from..from + most), 1, false);
            // What fails on one workstation goes on on the others.
            done = done.and(self.output_paths(F, |paths| Shape::Polymarker(paths.points)));
        }
        done
    }

    /// TEXT: a string of characters at a position in world coordinates.
    ///
    /// Control characters are not drawn; nothing is drawn for an empty string or at a position that is not
    /// finite. Error: 5.
    pub fn text(&mut self, position: impl Into<Point<Wc>>, text: &str) -> Result<()> {
        const F: Function = Function::Text;
        self.check_state(F)?;
        self.map_geometry();
        let position = self.normalization.map.point(position.into());
        if text.is_empty() || !position.is_finite() {
            return Ok(());
        }
        self.output(F, Shape::Text(position, text))
    }

    /// FILL AREA: the area inside the closed polygon through the points.
    ///
    /// Points whose coordinates are not finite are left out. Errors: 5, 100 (fewer than three points).
    pub fn fill_area<'p>(&mut self, points: impl Into<Points<'p>>) -> Result<()> {
        const F: Function = Function::FillArea;
        self.check_state(F)?;
        let points = points.into();
        at_least(F, &points, 3)?;
        self.map_geometry();
        self.normalize(&points, 3, false);
        self.output_paths(F, |paths: Paths<'_, Ndc>| Shape::FillArea(paths))
    }

    /// CELL ARRAY: a rectangle with opposite corners `p` and `q`, divided into cells of one colour each.
    ///
    /// Cell (1, 1) lies at `p`, columns advance in x and rows in y from there. Errors: 5, 91 (dimensions).
    pub fn cell_array(
        &mut self,
        p: impl Into<Point<Wc>>,
        q: impl Into<Point<Wc>>,
        cells: &Cells<'_>,
    ) -> Result<()> {
        const F: Function = Function::CellArray;
        self.check_state(F)?;
        let (p, q): (Point<Wc>, Point<Wc>) = (p.into(), q.into());
        let map = &self.normalization.map;
        let origin = map.point(p);
        let columns = map.point(Point::new(q.x(), p.y())) - origin;
        let rows = map.point(Point::new(p.x(), q.y())) - origin;
        if !(origin.is_finite() && columns.0.is_finite() && rows.0.is_finite()) {
            return Ok(());
        }
        self.output(F, Shape::CellArray(Parallelogram { origin, columns, rows }, *cells))
    }

    /// CELL ARRAY from an array as bindings have it: `columns` x `rows` cells, rows `stride` indices apart.
    ///
    /// Errors: 5, 91 (a dimension is not positive, or the array too small).
    pub fn cell_array_of(
        &mut self,
        p: impl Into<Point<Wc>>,
        q: impl Into<Point<Wc>>,
        indices: &[i32],
        columns: usize,
        rows: usize,
        stride: usize,
    ) -> Result<()> {
        const F: Function = Function::CellArray;
        self.check_state(F)?;
        let cells = Cells::new(indices, columns, rows, stride)
            .ok_or_else(|| Error::new(91, F).because(format!("{columns} x {rows} cells")))?;
        self.cell_array(p, q, &cells)
    }

    /// Takes points to NDC, into `self.paths`. A point that is not finite ends a path if `breaks`, and is
    /// left out otherwise; paths of fewer than `least` points are dropped.
    pub(crate) fn normalize(&mut self, points: &Points<'_>, least: usize, breaks: bool) {
        let map = self.normalization.map.0;
        let paths = &mut self.paths;
        paths.clear();
        if points.add_mapped(&map, &mut paths.points) {
            return paths.end_or_drop(least);
        }
        paths.clear();
        points.for_each(|p| {
            let p = map.transform_point2(p);
            if p.is_finite() {
                paths.push(p);
            } else if breaks {
                paths.end_or_drop(least);
            }
        });
        paths.end_or_drop(least);
    }

    /// Draws the paths in `self.paths`, if there are any.
    pub(crate) fn output_paths(
        &mut self,
        function: Function,
        shape: impl for<'s> FnOnce(Paths<'s, Ndc>) -> Shape<'s>,
    ) -> Result<()> {
        let Gks { paths, look, normalization, pick, workstations, segments, open_segment, .. } = self;
        if paths.ends.is_empty() {
            return Ok(());
        }
        let item = Item { shape: shape(paths.as_paths()), look, clip: normalization.clip, pick: *pick };
        Target { workstations, segments, open_segment: *open_segment }.draw(function, &item)
    }
}

#[inline]
fn at_least(function: Function, points: &Points<'_>, least: usize) -> Result<()> {
    if points.len() < least {
        return Err(too_few(function, points));
    }
    Ok(())
}

#[cold]
fn too_few(function: Function, points: &Points<'_>) -> Error {
    Error::new(100, function).because(format!("{} points", points.len()))
}

#[cfg(test)]
mod tests {
    use super::LONG;
    use crate::test_device::{Drawing, INDEXED, PLAIN, TRUE_COLOUR, active};

    #[test]
    fn many_markers_come_in_pieces_and_all_of_them_do() {
        let points: Vec<(f64, f64)> = (0..LONG + 5).map(|i| (i as f64 / (LONG + 5) as f64, 0.25)).collect();
        let (mut gks, log) = active(&[INDEXED]);
        gks.polymarker(&points).unwrap();
        let mut drawn: Vec<f64> = Vec::new();
        for (drawing, _) in log.marks() {
            let Drawing::Markers(positions, _) = drawing else { panic!("markers are whole") };
            assert!(positions.len() < LONG);
            drawn.extend(positions.iter().map(|p| p.x));
        }
        assert_eq!(drawn.len(), LONG + 5);
        assert!(drawn.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn long_polylines_are_held_only_by_those_who_want_to() {
        let points: Vec<(f64, f64)> = (0..LONG).map(|i| (i as f64 / LONG as f64, 0.25)).collect();
        let (mut gks, log) = active(&[INDEXED, PLAIN, TRUE_COLOUR]);
        gks.polyline(&points[1..]).unwrap();
        let held: Vec<_> = log.marks().into_iter().map(|(drawing, _)| drawing).collect();
        gks.polyline(&points).unwrap();
        let long: Vec<_> = log.marks().into_iter().map(|(drawing, _)| drawing).collect();
        assert_eq!((held.len(), long.len()), (3, 3));
        for (workstation, (held, long)) in held.iter().zip(&long).enumerate() {
            let Drawing::Lines(held, _) = held else { panic!("a short line should be held") };
            let ((1, Drawing::LongLine(long, _)) | (0 | 2, Drawing::Lines(long, _))) = (workstation, long)
            else {
                panic!("workstation {workstation} was not asked for what it can do")
            };
            assert_eq!((long.len(), long[0].len()), (1, LONG));
            assert_eq!(held[0], long[0][1..]);
        }
        gks.create_segment(1).unwrap();
        gks.polyline(&points).unwrap();
        assert!(log.marks().iter().all(|(drawing, _)| matches!(drawing, Drawing::Lines(..))));
        gks.close_segment().unwrap();
    }
}
