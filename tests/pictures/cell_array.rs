//! Cell arrays.

use gks::{Gks, Result};
use gks_pipeline::item::Cells;

/// A letter F and four corners of different colours: no symmetry maps it to itself.
const LETTER: [i32; 30] = [
    2, 0, 0, 0, 3, //
    0, 8, 0, 0, 0, //
    0, 8, 8, 0, 0, //
    0, 8, 0, 0, 0, //
    0, 8, 8, 8, 0, //
    4, 0, 0, 0, 15,
];

/// The predefined colours from 0 to 255 in a square.
pub fn colours(gks: &mut Gks, _ws: i32) -> Result<()> {
    let indices: Vec<i32> = (0..256).collect();
    gks.cell_array_of((0.06, 0.06), (0.94, 0.94), &indices, 16, 16, 16)
}

/// The same cells between corners in four orders, level and stretched.
pub fn mirrored(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, (p, q)) in [
        ((0.0, 0.0), (1.0, 1.0)),
        ((1.0, 0.0), (0.0, 1.0)),
        ((0.0, 1.0), (1.0, 0.0)),
        ((1.0, 1.0), (0.0, 0.0)),
    ]
    .into_iter()
    .enumerate()
    {
        let (x, y) = (0.05 + 0.48 * (i % 2) as f64, 0.53 - 0.48 * (i / 2) as f64);
        gks.set_viewport(1, (x, x + 0.3 + 0.03 * i as f64, y, y + 0.4))?;
        gks.select_normalization_transformation(1)?;
        gks.cell_array_of(p, q, &LETTER, 5, 6, 5)?;
    }
    Ok(())
}

/// Parts of a wider array.
pub fn partial(gks: &mut Gks, _ws: i32) -> Result<()> {
    let parts = [(0, 2, 6), (1, 3, 5), (6, 1, 4), (8, 2, 1)];
    for (i, (start, columns, rows)) in parts.into_iter().enumerate() {
        let (x, y) = (0.06 + 0.48 * (i % 2) as f64, 0.53 - 0.48 * (i / 2) as f64);
        if let Some(cells) = Cells::new(&LETTER[start..], columns, rows, 5) {
            gks.cell_array((x, y + 0.41), (x + 0.37, y), &cells)?;
        }
    }
    Ok(())
}

/// A cell array that crosses the edges of a viewport, and one at the edge of the surface.
pub fn clipped(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.polyline(&[(0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8), (0.2, 0.2)])?;
    gks.cell_array_of((0.85, -0.1), (1.15, 0.3), &LETTER, 5, 6, 5)?;
    gks.set_viewport(1, (0.2, 0.8, 0.2, 0.8))?;
    gks.set_window(1, (0.0, 10.0, 0.0, 10.0))?;
    gks.select_normalization_transformation(1)?;
    gks.cell_array_of((-2.3, 12.1), (7.7, 2.7), &LETTER, 5, 6, 5)?;
    gks.cell_array_of((8.3, 5.1), (11.2, -1.0), &LETTER, 5, 6, 5)
}

/// An array of many cells: a smooth surface.
pub fn fine(gks: &mut Gks, _ws: i32) -> Result<()> {
    let (columns, rows) = (200, 150);
    let indices: Vec<i32> = (0..columns * rows)
        .map(|i| ((i % columns) as f64 / columns as f64, (i / columns) as f64 / rows as f64))
        .map(|(x, y)| 0.5 + 0.25 * ((7.0 * x).sin() + (5.0 * y * y + 3.0 * x).cos()))
        .map(|v| 232 + (v * 23.99) as i32)
        .collect();
    gks.cell_array_of((0.05, 0.95), (0.95, 0.05), &indices, columns, rows, columns)
}
