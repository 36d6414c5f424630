//! Cells on a raster: every pixel takes the colour of the cell that contains its centre.

use gks_geometry::Du;
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
        let whole = grid.columns.checked_mul(grid.rows).is_some_and(|n| n <= grid.paints.len());
        if whole { CellMap::of_size(frame, grid.columns, grid.rows) } else { None }
    }

    fn of_size(frame: &Parallelogram<Du>, columns: usize, rows: usize) -> Option<Self> {
        let forth = DMat2::from_cols(frame.columns.0, frame.rows.0);
        let determinant = forth.determinant();
        let usable = determinant != 0.0 && determinant.is_finite() && frame.origin.is_finite();
        let count = DMat2::from_diagonal(DVec2::new(columns as f64, rows as f64));
        let inverse = count * forth.inverse();
        let usable = usable && inverse.is_finite() && columns > 0 && rows > 0;
        usable.then_some(CellMap { origin: frame.origin.0, inverse, columns, rows })
    }

    /// The position of the centre of a pixel, counted in columns and rows of cells. One on the edge of a cell, but for
    /// the last digits, is taken to be there, so that it does not matter how the cells came to their place.
    #[inline]
    fn position(&self, column: u32, row: u32) -> DVec2 {
        let centre = DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5);
        self.inverse * (centre - self.origin) + DVec2::splat(ROUNDING)
    }

    /// The column and the row of the cell that contains the centre of a pixel.
    #[inline]
    fn cell(&self, column: u32, row: u32) -> Option<(usize, usize)> {
        let p = self.position(column, row);
        Some((within(p.x, self.columns)?, within(p.y, self.rows)?))
    }

    /// The cell at the centre of a pixel in the plane tiled with copies of the grid.
    #[inline]
    pub(super) fn tiled(&self, column: u32, row: u32) -> usize {
        let p = self.position(column, row);
        let wrap = |at: f64, count: usize| (at.floor().rem_euclid(count as f64) as usize).min(count - 1);
        wrap(p.x, self.columns) + wrap(p.y, self.rows) * self.columns
    }

    /// Where the sides of the cells are parallel to the sides of the raster: what each pixel column and each
    /// pixel row adds to the place of the cell, with the first pixel that lies in any cell. Rows of cells are `stride`
    /// places apart.
    fn separate(&self, columns: &Range<u32>, rows: &Range<u32>, stride: usize) -> Option<[Steps; 2]> {
        let m = self.inverse;
        // x counts the columns of cells, or, where the array is turned, its rows.
        let (of_x, of_y) = if m.x_axis.y == 0.0 && m.y_axis.x == 0.0 {
            ((0, self.columns, 1), (1, self.rows, stride))
        } else if m.x_axis.x == 0.0 && m.y_axis.y == 0.0 {
            ((1, self.rows, stride), (0, self.columns, 1))
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

/// How many cells an array has, and how many places from one row to the next.
#[derive(Copy, Clone, Debug)]
pub(super) struct Extent {
    pub(super) columns: usize,
    pub(super) rows: usize,
    pub(super) stride: usize,
}

/// Pixels side by side in a row, each in a cell.
pub(super) struct Line<'a> {
    /// The row of pixels.
    pub(super) row: u32,
    /// The first pixel.
    pub(super) first: u32,
    /// The place of the cell of each pixel, counted from `base`.
    pub(super) offsets: &'a [usize],
    pub(super) base: usize,
    /// Whether each pixel has the next cell.
    pub(super) consecutive: bool,
    /// Whether the pixels above, which were given before, have the same cells.
    pub(super) again: bool,
}

impl Line<'_> {
    /// The pixels of a raster of `width` columns, as a range of all of them.
    pub(super) fn pixels(&self, width: usize) -> Range<usize> {
        let start = self.row as usize * width + self.first as usize;
        start..start + self.offsets.len()
    }

    /// The places of the cells of the pixels.
    pub(super) fn places(&self) -> impl Iterator<Item = usize> + '_ {
        self.offsets.iter().map(|offset| self.base + offset)
    }
}

/// Gives the pixels of a window whose centres lie in cells, line by line from the top.
pub(super) fn lines(
    (columns, rows): (Range<u32>, Range<u32>),
    frame: &Parallelogram<Du>,
    Extent { columns: count, rows: row_count, stride }: Extent,
    mut line: impl FnMut(&Line<'_>),
) {
    let Some(map) = CellMap::of_size(frame, count, row_count) else { return };
    let corners = frame.corners().map(|p| p.0);
    let (low, high) = corners.iter().fold((corners[0], corners[0]), |(l, h), &p| (l.min(p), h.max(p)));
    let (columns, rows) = (centres(columns, low.x, high.x), centres(rows, low.y, high.y));
    let Some([across, down]) = map.separate(&columns, &rows, stride) else {
        let mut offsets = Vec::new();
        for row in rows {
            let mut first = columns.end;
            offsets.clear();
            for column in columns.clone() {
                if let Some((cell, of_row)) = map.cell(column, row) {
                    first = first.min(column);
                    offsets.push(cell + of_row * stride);
                }
            }
            line(&Line { row, first, offsets: &offsets, base: 0, consecutive: false, again: false });
        }
        return;
    };
    let consecutive = across.offsets.windows(2).all(|pair| pair[1] == pair[0].wrapping_add(1));
    let (first, offsets) = (across.first, &across.offsets[..]);
    let mut before = None;
    for (row, &base) in (down.first..).zip(&down.offsets) {
        line(&Line { row, first, offsets, base, consecutive, again: before == Some(base) });
        before = Some(base);
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
    use gks_pipeline::colour::{Colour, Paint};

    fn picture(frame: Parallelogram<Du>, columns: usize, rows: usize) -> Vec<String> {
        let mut out = ['.'; 8 * 6];
        let extent = Extent { columns, rows, stride: columns + 3 };
        let letters: Vec<char> = (0..rows * extent.stride)
            .map(|i| (i % extent.stride, i / extent.stride))
            .map(|(x, y)| if x < columns { char::from(b'a' + (y * columns + x) as u8) } else { '?' })
            .collect();
        lines((0..8, 0..6), &frame, extent, |line| {
            let pixels = line.pixels(8);
            if line.again {
                assert!(
                    line.places()
                        .zip(&out[pixels.start - 8..])
                        .all(|(place, &above)| letters[place] == above)
                );
            }
            assert!(!line.consecutive || line.places().is_sorted_by(|a, b| b - a == 1));
            out[pixels].iter_mut().zip(line.places()).for_each(|(pixel, place)| *pixel = letters[place]);
        });
        out.chunks(8).map(|row| row.iter().collect()).collect()
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
