//! Areas filled with a pattern: the area decides how much of a pixel is covered, its centre which cell it shows.

use super::cells::CellMap;
use super::clip::Window;
use super::composite::{Pixel, over, pixel, times};
use super::curve::Outline;
use gks_algorithms::clip::sutherland_hodgman;
use gks_geometry::{Du, PathBuf, Paths};
use gks_pipeline::device::Grid;
use gks_pipeline::item::Parallelogram;
use glam::DVec2;
use std::ops::Range;
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
    let Some((columns, rows, covered)) = coverage(rings, rule, window, antialias) else { return };
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

/// How much of every pixel rings cover: the columns and rows touched, and their coverage row by row.
fn coverage(
    rings: Paths<'_, Du>,
    rule: FillRule,
    window: &Window,
    antialias: bool,
) -> Option<(Range<u32>, Range<u32>, Mask)> {
    let bounds = rings.bounds()?;
    let (columns, rows) = window.touched_by(&bounds);
    let corner = |column: u32, row: u32| DVec2::new(f64::from(column), f64::from(row));
    let (first, last) = (corner(columns.start, rows.start), corner(columns.end, rows.end));
    // Far points would lose their place in the single precision of the scan converter.
    let mut near = PathBuf::<Du>::new();
    for ring in rings.iter() {
        sutherland_hodgman((first - 1.0, last + 1.0), ring, &mut near.points, &mut near.ends);
    }
    let mut covered = Mask::new(columns.len() as u32, rows.len() as u32)?;
    let mut outline = Outline::new(first);
    outline.rings(near.as_paths());
    let outline = outline.finish()?;
    covered.fill_path(&outline, rule, antialias, Transform::identity());
    Some((columns, rows, covered))
}

/// Fills rings with an opaque colour so that areas with a common boundary leave no seam.
///
/// Where two areas share a pixel, each covers a part of it, and what is below shows through both. So a pixel
/// counts as covered twice as much as it is: one of two neighbours covers at least half of it and so takes it
/// whole. The boundary stays antialiased, over half a pixel.
pub(super) fn fill_seamless(canvas: &mut Pixmap, rings: Paths<'_, Du>, window: &Window, colour: Pixel) {
    let Some((columns, rows, covered)) = coverage(rings, FillRule::EvenOdd, window, true) else { return };
    let width = canvas.width() as usize;
    for (row, parts) in rows.zip(covered.data().chunks_exact(columns.len())) {
        let line = &mut canvas.pixels_mut()[row as usize * width..][..width];
        for (pixel, &part) in line[columns.start as usize..].iter_mut().zip(parts) {
            over(pixel, colour, part.saturating_mul(2));
        }
    }
}
