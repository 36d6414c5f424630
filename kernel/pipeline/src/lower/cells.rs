//! Cell arrays: paints for the cells, and areas for devices without cells.

use crate::colour::Paint;
use crate::device::{DeviceError, Grid, Palette, Rule};
use crate::item::{Cells, Parallelogram};
use crate::painter::{Canvas, Painter};
use gks_geometry::{Du, PathBuf, Rect};
use std::collections::BTreeMap;

/// Resolves the colour indices of cells.
pub(crate) fn paints(cells: &Cells<'_>, palette: &Palette<'_>, out: &mut Vec<Paint>) {
    out.clear();
    for row in 0..cells.rows {
        out.extend(cells.row(row).iter().map(|&index| palette.paint(index)));
    }
}

/// Draws cells as one area for each colour, runs of equal cells merged.
pub(crate) fn draw(
    painter: &mut Painter,
    place: &Parallelogram<Du>,
    grid: &Grid<'_>,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let mut areas: BTreeMap<u32, (Paint, PathBuf<Du>)> = BTreeMap::new();
    let column = place.columns * (1.0 / grid.columns as f64);
    let row_edge = place.rows * (1.0 / grid.rows as f64);
    for (y, row) in grid.paints.chunks_exact(grid.columns).enumerate() {
        let left = place.origin + row_edge * y as f64;
        let mut x = 0;
        while x < row.len() {
            let run = row[x..].iter().take_while(|p| **p == row[x]).count();
            let a = left + column * x as f64;
            let b = left + column * (x + run) as f64;
            let (_, area) = areas.entry(row[x].index).or_insert_with(|| (row[x], PathBuf::new()));
            area.add([a.0, b.0, (b + row_edge).0, (a + row_edge).0]);
            x += run;
        }
    }
    for (paint, area) in areas.values() {
        painter.solid(area.as_paths(), Rule::EvenOdd, *paint, clip, canvas)?;
    }
    Ok(())
}
