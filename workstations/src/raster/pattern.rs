//! Areas filled with a pattern: the area decides how much of a pixel is covered, its centre which cell it shows.

use super::aliased::Aliased;
use super::bitmap::Bitmap;
use super::cells::CellMap;
use super::clip::Window;
use super::composite::{over, pixel, times};
use gks_algorithms::coverage::{AreaMask, Gain};
use gks_algorithms::path::Rule;
use gks_algorithms::rect::IRect;
use gks_geometry::{Du, Paths};
use gks_pipeline::device::Grid;
use gks_pipeline::item::Parallelogram;
use glam::IVec2;

/// Fills rings with a pattern as far as a window leaves them.
pub(super) fn fill(
    bitmap: &mut Bitmap,
    mask: &mut AreaMask,
    (rings, rule): (Paths<'_, Du>, Rule),
    window: &Window,
    (frame, grid): (&Parallelogram<Du>, &Grid<'_>),
) {
    let (Some(map), Some(bounds)) = (CellMap::new(frame, grid), rings.bounds()) else { return };
    let (columns, rows) = window.touched_by(&bounds);
    let corner = |column: u32, row: u32| IVec2::new(column as i32, row as i32);
    let pixels = IRect::new(corner(columns.start, rows.start), corner(columns.end, rows.end));
    let colours: Vec<_> = grid.paints.iter().map(|paint| pixel(paint.colour)).collect();
    mask.cover(rings.points, rings.ends, (rule, Gain::One), pixels, |row, from, cover| {
        let row = row as u32;
        let line = bitmap.rest(row as usize, from as usize);
        for ((column, below), part) in (from as u32..).zip(line).zip(cover.parts()) {
            over(below, colours[map.tiled(column, row)], times(part, window.coverage(column, row)));
        }
    });
}

/// Fills the pixels whose centre rings contain with a pattern.
pub(super) fn fill_whole(
    bitmap: &mut Bitmap,
    aliased: &mut Aliased,
    (rings, rule): (Paths<'_, Du>, Rule),
    window: &Window,
    (frame, grid): (&Parallelogram<Du>, &Grid<'_>),
) {
    let Some(map) = CellMap::new(frame, grid) else { return };
    let (columns, rows) = window.centred();
    let corner = |column: u32, row: u32| IVec2::new(column as i32, row as i32);
    let pixels = IRect::new(corner(columns.start, rows.start), corner(columns.end, rows.end));
    let colours: Vec<_> = grid.paints.iter().map(|paint| pixel(paint.colour)).collect();
    aliased.area(rings, rule, pixels, |row, from, to| {
        let line = bitmap.span(row as usize, from as usize..to as usize);
        for (column, below) in (from as u32..).zip(line) {
            over(below, colours[map.tiled(column, row as u32)], 255);
        }
    });
}
