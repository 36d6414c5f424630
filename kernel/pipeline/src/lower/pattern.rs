//! Patterns: their place and paints, and clipped cells for devices without patterns.

use crate::colour::Paint;
use crate::device::{DeviceError, Grid, Palette, Rule};
use crate::item::Parallelogram;
use crate::look::Look;
use crate::lower;
use crate::painter::{Canvas, Painter};
use gks_algorithms::clip::sutherland_hodgman_convex;
use gks_geometry::{Du, PathBuf, Paths, Point, Rect};
use glam::{DMat2, DVec2};
use std::collections::BTreeMap;

/// Where one copy of a pattern lies and how many cells it has.
pub(crate) struct Place {
    place: Parallelogram<Du>,
    columns: usize,
    rows: usize,
}

impl Place {
    /// The place with its cells.
    pub(crate) fn with<'p>(&self, paints: &'p [Paint]) -> (Parallelogram<Du>, Grid<'p>) {
        (self.place, Grid { paints, columns: self.columns, rows: self.rows })
    }
}

/// Finds the pattern of a pattern index, or pattern 1 in its place, and puts its paints into `paints`.
///
/// The reference point is the lower left corner of the pattern box and element (1, 1) lies at the upper
/// left (ISO 7942, pattern attributes), so as a cell array the pattern starts at the upper left corner and
/// its rows go down.
pub(crate) fn place(look: &Look, index: i32, canvas: &Canvas<'_>, paints: &mut Vec<Paint>) -> Option<Place> {
    let table = &canvas.tables.patterns;
    let pattern = u32::try_from(index).ok().and_then(|i| table.get(&i)).or_else(|| table.get(&1))?;
    let geometry = &look.pattern;
    let width = canvas.map.vector(geometry.width);
    let height = canvas.map.vector(geometry.height);
    let area = width.0.perp_dot(height.0).abs();
    if area == 0.0 || !area.is_finite() {
        return None;
    }
    paints.clear();
    let palette = Palette::new(canvas.tables);
    paints.extend(pattern.indices.iter().map(|&index| palette.paint(index)));
    let origin = canvas.map.point(geometry.reference) + height;
    Some(Place {
        place: Parallelogram { origin, columns: width, rows: -height },
        columns: pattern.columns,
        rows: pattern.rows,
    })
}

/// How many copies of a pattern are drawn at most; a finer pattern is drawn in its first colour.
const MAX_COPIES: f64 = 250_000.0;

/// Draws an area with a pattern as areas of one colour each: the cells, clipped against the area by
/// clipping the area against every cell.
pub(crate) fn draw(
    painter: &mut Painter,
    rings: Paths<'_, Du>,
    place: &Parallelogram<Du>,
    grid: &Grid<'_>,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let Some(bounds) = rings.bounds().and_then(|b| b.intersection(clip)) else { return Ok(()) };
    let frame = DMat2::from_cols(place.columns.0, place.rows.0).inverse();
    let corners = bounds.corners().map(|c| frame * (c - place.origin).0);
    let low = corners.iter().fold(DVec2::INFINITY, |a, &b| a.min(b)).floor();
    let high = corners.iter().fold(DVec2::NEG_INFINITY, |a, &b| a.max(b)).ceil();
    let copies = (high - low).x * (high - low).y;
    if !copies.is_finite() || copies * grid.paints.len() as f64 > MAX_COPIES {
        return painter.solid(rings, Rule::EvenOdd, grid.paints[0], clip, canvas);
    }
    let mut areas: BTreeMap<u32, (Paint, PathBuf<Du>)> = BTreeMap::new();
    let column = place.columns * (1.0 / grid.columns as f64);
    let row_edge = place.rows * (1.0 / grid.rows as f64);
    let mut scratch = Vec::new();
    for v in low.y as i64..high.y as i64 {
        for u in low.x as i64..high.x as i64 {
            let origin = place.origin + place.columns * u as f64 + place.rows * v as f64;
            for (y, row) in grid.paints.chunks_exact(grid.columns).enumerate() {
                let mut x = 0;
                while x < row.len() {
                    let run = row[x..].iter().take_while(|p| **p == row[x]).count();
                    let a = origin + row_edge * y as f64 + column * x as f64;
                    let b = a + column * run as f64;
                    let cell = [a.0, b.0, (b + row_edge).0, (a + row_edge).0];
                    if Rect::<Du>::around(cell.map(Point::from_vec)).is_some_and(|r| r.meets(&bounds)) {
                        let (_, area) = areas.entry(row[x].index).or_insert_with(|| (row[x], PathBuf::new()));
                        for ring in rings.iter() {
                            let (points, ends) = (&mut area.points, &mut area.ends);
                            sutherland_hodgman_convex(&cell, ring, &mut scratch, points, ends);
                        }
                    }
                    x += run;
                }
            }
        }
    }
    for (paint, area) in areas.values() {
        if canvas.surface.pen.is_some() {
            lower::hatch::interior(painter, area.as_paths(), *paint, clip, canvas)?;
        } else {
            painter.solid(area.as_paths(), Rule::EvenOdd, *paint, clip, canvas)?;
        }
    }
    Ok(())
}
