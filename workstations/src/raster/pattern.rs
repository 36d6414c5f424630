//! Areas filled with a pattern: the area decides how much of a pixel is covered, its centre which cell it shows.

use super::cells::CellMap;
use super::clip::Window;
use super::composite::{over, pixel, times};
use super::curve::Outline;
use gks_algorithms::clip::sutherland_hodgman;
use gks_geometry::{Du, PathBuf, Paths};
use gks_pipeline::device::Grid;
use gks_pipeline::item::Parallelogram;
use glam::DVec2;
use tiny_skia::{FillRule, Mask, Pixmap, Transform};

/// Fills rings with a pattern as far as a window leaves them.
pub(super) fn fill(
    canvas: &mut Pixmap,
    (rings, rule): (Paths<'_, Du>, FillRule),
    window: &Window,
    antialias: bool,
    (frame, grid): (&Parallelogram<Du>, &Grid<'_>),
) {
    let Some(map) = CellMap::new(frame, grid) else { return };
    let Some(bounds) = rings.bounds() else { return };
    let (columns, rows) = window.touched_by(&bounds);
    let corner = |column: u32, row: u32| DVec2::new(f64::from(column), f64::from(row));
    let (first, last) = (corner(columns.start, rows.start), corner(columns.end, rows.end));
    // Far points would lose their place in the single precision of the scan converter.
    let mut near = PathBuf::<Du>::new();
    for ring in rings.iter() {
        sutherland_hodgman((first - 1.0, last + 1.0), ring, &mut near.points, &mut near.ends);
    }
    let Some(mut covered) = Mask::new(columns.len() as u32, rows.len() as u32) else { return };
    let mut outline = Outline::new(first);
    outline.rings(near.as_paths());
    let Some(outline) = outline.finish() else { return };
    covered.fill_path(&outline, rule, antialias, Transform::identity());
    let width = canvas.width() as usize;
    let colours: Vec<_> = grid.paints.iter().map(|paint| pixel(paint.colour)).collect();
    for (row, parts) in rows.zip(covered.data().chunks_exact(columns.len())) {
        let line = &mut canvas.pixels_mut()[row as usize * width..][..width];
        for (column, &part) in columns.clone().zip(parts) {
            if part > 0 {
                let part = times(part, window.coverage(column, row));
                over(&mut line[column as usize], colours[map.tiled(column, row)], part);
            }
        }
    }
}
