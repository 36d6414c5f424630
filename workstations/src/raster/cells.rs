//! Cells on a raster: every pixel takes the colour of the cell that contains its centre.

use gks_geometry::Du;
use gks_pipeline::colour::Paint;
use gks_pipeline::device::Grid;
use gks_pipeline::item::Parallelogram;
use glam::{DMat2, DVec2};
use std::ops::Range;

/// What arithmetic and metafiles may lose of the position of a pixel, in cells.
const ROUNDING: f64 = 1e-6;

/// The way back from the raster to a parallelogram of cells.
pub(super) struct CellMap {
    /// The corner of cell (1, 1).
    origin: DVec2,
    /// Displacements on the raster to displacements counted in cells.
    inverse: DMat2,
    columns: usize,
    rows: usize,
}

impl CellMap {
    /// The map for a grid in a parallelogram, or none if the parallelogram has no area or the grid no cell.
    pub(super) fn new(frame: &Parallelogram<Du>, grid: &Grid<'_>) -> Option<Self> {
        let forth = DMat2::from_cols(frame.columns.0, frame.rows.0);
        let determinant = forth.determinant();
        let usable = determinant != 0.0 && determinant.is_finite() && frame.origin.is_finite();
        let whole = grid.columns.checked_mul(grid.rows).is_some_and(|n| n > 0 && n <= grid.paints.len());
        let count = DMat2::from_diagonal(DVec2::new(grid.columns as f64, grid.rows as f64));
        let inverse = count * forth.inverse();
        (usable && whole && inverse.is_finite()).then_some(CellMap {
            origin: frame.origin.0,
            inverse,
            columns: grid.columns,
            rows: grid.rows,
        })
    }

    /// The position of the centre of a pixel, counted in columns and rows of cells. One on the edge of a cell, but for
    /// the last digits, is taken to be there, so that it does not matter how the cells came to their place.
    #[inline]
    fn position(&self, column: u32, row: u32) -> DVec2 {
        let centre = DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5);
        self.inverse * (centre - self.origin) + DVec2::splat(ROUNDING)
    }

    /// The cell that contains the centre of a pixel as an index into the paints of the grid.
    #[inline]
    pub(super) fn cell(&self, column: u32, row: u32) -> Option<usize> {
        let p = self.position(column, row);
        Some(within(p.x, self.columns)? + within(p.y, self.rows)? * self.columns)
    }

    /// The cell at the centre of a pixel in the plane tiled with copies of the grid.
    #[inline]
    pub(super) fn tiled(&self, column: u32, row: u32) -> usize {
        let p = self.position(column, row);
        let wrap = |at: f64, count: usize| (at.floor().rem_euclid(count as f64) as usize).min(count - 1);
        wrap(p.x, self.columns) + wrap(p.y, self.rows) * self.columns
    }

    /// Where the sides of the cells are parallel to the sides of the raster: what each pixel column and each
    /// pixel row adds to the index of the cell, with the first pixel that lies in any cell.
    fn separate(&self, columns: &Range<u32>, rows: &Range<u32>) -> Option<[Steps; 2]> {
        let m = self.inverse;
        // x counts the columns of cells, or, where the array is turned, its rows.
        let (of_x, of_y) = if m.x_axis.y == 0.0 && m.y_axis.x == 0.0 {
            ((0, self.columns, 1), (1, self.rows, self.columns))
        } else if m.x_axis.x == 0.0 && m.y_axis.y == 0.0 {
            ((1, self.rows, self.columns), (0, self.columns, 1))
        } else {
            return None;
        };
        let steps = |pixels: &Range<u32>, (axis, count, factor): (usize, usize, usize), along_x: bool| {
            let mut first = pixels.end;
            let mut offsets = Vec::new();
            for at in pixels.clone() {
                let p = if along_x { self.position(at, 0) } else { self.position(0, at) };
                if let Some(cell) = within(p[axis], count) {
                    first = first.min(at);
                    offsets.push(cell * factor);
                }
            }
            Steps { first, offsets }
        };
        Some([steps(columns, of_x, true), steps(rows, of_y, false)])
    }
}

/// What the pixels along one direction add to the index of the cell.
struct Steps {
    first: u32,
    offsets: Vec<usize>,
}

#[inline]
fn within(at: f64, count: usize) -> Option<usize> {
    (at >= 0.0 && at < count as f64).then_some(at as usize)
}

/// Gives rows of pixels their cells. `paint` turns a paint into a pixel, `put` blends one pixel into the raster
/// and `repeat` copies the columns given from the row before, which it may decline to do.
pub(super) fn draw<P: Copy>(
    (columns, rows): (Range<u32>, Range<u32>),
    frame: &Parallelogram<Du>,
    grid: &Grid<'_>,
    paint: impl Fn(&Paint) -> P,
    mut put: impl FnMut(u32, u32, P),
    mut repeat: impl FnMut(Range<u32>, u32) -> bool,
) {
    let Some(map) = CellMap::new(frame, grid) else { return };
    let corners = frame.corners().map(|p| p.0);
    let (low, high) = corners.iter().fold((corners[0], corners[0]), |(l, h), &p| (l.min(p), h.max(p)));
    let (columns, rows) = (centres(columns, low.x, high.x), centres(rows, low.y, high.y));
    let mut held = (usize::MAX, paint(&grid.paints[0]));
    let mut colour = |cell: usize| {
        if cell != held.0 {
            held = (cell, paint(&grid.paints[cell]));
        }
        held.1
    };
    let Some([across, down]) = map.separate(&columns, &rows) else {
        for row in rows {
            for column in columns.clone() {
                if let Some(cell) = map.cell(column, row) {
                    put(column, row, colour(cell));
                }
            }
        }
        return;
    };
    let columns = across.first..across.first + across.offsets.len() as u32;
    let mut before = None;
    for (row, &step) in (down.first..).zip(&down.offsets) {
        if before == Some(step) && repeat(columns.clone(), row) {
            continue;
        }
        before = Some(step);
        for (column, &offset) in columns.clone().zip(&across.offsets) {
            put(column, row, colour(offset + step));
        }
    }
}

/// The pixels of a range whose centre may lie between two limits.
fn centres(range: Range<u32>, low: f64, high: f64) -> Range<u32> {
    let limit = |at: f64| at.clamp(0.0, f64::from(u32::MAX)) as u32;
    let start = range.start.max(limit(low - 1.0));
    start..range.end.min(limit(high + 1.0)).max(start)
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::{Point, Vector};
    use gks_pipeline::colour::Colour;

    fn picture(frame: Parallelogram<Du>, columns: usize, rows: usize) -> Vec<String> {
        let paints: Vec<Paint> =
            (0..columns * rows).map(|i| Paint { colour: Colour::BLACK, index: i as u32 }).collect();
        let grid = Grid { paints: &paints, columns, rows };
        let mut out = vec![vec!['.'; 8]; 6];
        let cell = |p: &Paint| char::from(b'a' + p.index as u8);
        draw((0..8, 0..6), &frame, &grid, cell, |c, r, p| out[r as usize][c as usize] = p, |_, _| false);
        out.into_iter().map(|row| row.into_iter().collect()).collect()
    }

    fn frame(origin: (f64, f64), columns: (f64, f64), rows: (f64, f64)) -> Parallelogram<Du> {
        Parallelogram { origin: origin.into(), columns: columns.into(), rows: rows.into() }
    }

    #[test]
    fn cells_upright_mirrored_and_turned() {
        let upright = picture(frame((1.0, 1.0), (6.0, 0.0), (0.0, 4.0)), 3, 2);
        assert_eq!(upright, ["........", ".aabbcc.", ".aabbcc.", ".ddeeff.", ".ddeeff.", "........"]);
        let mirrored = picture(frame((7.0, 5.0), (-6.0, 0.0), (0.0, -4.0)), 3, 2);
        assert_eq!(mirrored, ["........", ".ffeedd.", ".ffeedd.", ".ccbbaa.", ".ccbbaa.", "........"]);
        let turned = picture(frame((1.0, 5.0), (0.0, -4.0), (6.0, 0.0)), 2, 3);
        assert_eq!(turned, ["........", ".bbddff.", ".bbddff.", ".aaccee.", ".aaccee.", "........"]);
    }

    #[test]
    fn only_centres_decide() {
        let uneven = picture(frame((0.6, 0.4), (5.0, 0.0), (0.0, 2.0)), 2, 1);
        assert_eq!(uneven, [".aabbb..", ".aabbb..", "........", "........", "........", "........"]);
        let diamond = picture(frame((4.0, -0.1), (3.1, 3.1), (-3.1, 3.1)), 1, 1);
        assert_eq!(diamond, ["...aa...", "..aaaa..", ".aaaaaa.", ".aaaaaa.", "..aaaa..", "...aa..."]);
    }

    #[test]
    fn huge_and_flat_arrays_do_no_harm() {
        let big = picture(frame((-1e9, -1e9), (2e9, 0.0), (0.0, 2e9)), 2, 2);
        assert_eq!(big, ["dddddddd"; 6]);
        let skew = picture(frame((-1e9, -1e9), (2e9, 1.0), (1.0, 2e9)), 1, 1);
        assert_eq!(skew, ["aaaaaaaa"; 6]);
        for flat in [
            frame((1.0, 1.0), (6.0, 0.0), (3.0, 0.0)),
            frame((f64::NAN, 1.0), (6.0, 0.0), (0.0, 4.0)),
            frame((1.0, 1.0), (f64::INFINITY, 0.0), (0.0, 4.0)),
            frame((1.0, 1.0), (1e-320, 0.0), (0.0, 1e-320)),
        ] {
            assert_eq!(picture(flat, 3, 2), ["........"; 6]);
        }
    }

    #[test]
    fn a_grid_that_is_too_short_is_not_drawn() {
        let paints = [Paint { colour: Colour::BLACK, index: 1 }; 3];
        let grid = Grid { paints: &paints, columns: 2, rows: 2 };
        let whole = Parallelogram {
            origin: Point::new(0.0, 0.0),
            columns: Vector::new(4.0, 0.0),
            rows: Vector::new(0.0, 4.0),
        };
        assert!(CellMap::new(&whole, &grid).is_none());
        assert!(CellMap::new(&whole, &Grid { rows: usize::MAX, ..grid }).is_none());
        assert!(CellMap::new(&whole, &Grid { rows: 0, ..grid }).is_none());
    }
}
