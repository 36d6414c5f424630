//! Tile arrays: rectangles of cells, tile by tile.

use super::Interpreter;
use crate::cgm::decoder::Decoder;
use crate::cgm::element::{Cells, Element, Ink, Inks, MOST_CELLS, repeat};
use crate::generated::elements::Kind;
use glam::DVec2;

/// A tile array whose tiles come one by one.
#[derive(Clone, Debug)]
pub(super) struct TileArray {
    corner: DVec2,
    /// From cell to cell in a row, and from row to row.
    path: DVec2,
    progression: DVec2,
    /// Tiles in a row.
    tiles: usize,
    /// Cells of a tile in both directions.
    cells: (usize, usize),
    /// Cells before the first one that is shown.
    offset: (usize, usize),
    /// Cells that are shown in both directions.
    shown: (usize, usize),
    next: usize,
}

impl TileArray {
    pub(super) fn new(e: &Element) -> Option<TileArray> {
        let quarter = |turns: i32| match turns {
            0 => DVec2::X,
            1 => DVec2::Y,
            2 => -DVec2::X,
            _ => -DVec2::Y,
        };
        let count = |place: usize| usize::try_from(e.integer(place)?).ok();
        let path = quarter(e.integer(1)?);
        let progression = if e.integer(2)? == 0 { path.perp() } else { -path.perp() };
        Some(TileArray {
            corner: e.point(0)?,
            path: path * e.real(7)?,
            progression: progression * e.real(8)?,
            tiles: count(3)?.max(1),
            cells: (count(5)?, count(6)?),
            offset: (count(9)?, count(10)?),
            shown: (count(11)?, count(12)?),
            next: 0,
        })
    }
}

impl<D: Decoder> Interpreter<D> {
    pub(super) fn tile(&mut self, e: &Element) -> bool {
        let bitonal = match e.kind {
            Kind::BitonalTile => true,
            Kind::Tile => false,
            _ => return false,
        };
        let Some(mut array) = self.tiles.clone() else { return false };
        let at = (array.next % array.tiles, array.next / array.tiles);
        array.next += 1;
        match decoded(e, bitonal, array.cells, self.context.modes.direct) {
            Some(cells) => self.place(&array, at, &cells),
            None => self.senseless(e),
        }
        self.tiles = Some(array);
        true
    }

    /// Draws what is shown of a tile.
    fn place(&mut self, array: &TileArray, at: (usize, usize), cells: &Cells) {
        let range = |at: usize, length: usize, offset: usize, shown: usize| {
            let first = at.saturating_mul(length);
            let from = first.max(offset);
            let to = first.saturating_add(length).min(offset.saturating_add(shown));
            (from < to).then(|| (from - first, to - first, from - offset))
        };
        let columns = range(at.0, array.cells.0, array.offset.0, array.shown.0);
        let rows = range(at.1, array.cells.1, array.offset.1, array.shown.1);
        let (Some((left, right, x)), Some((top, bottom, y))) = (columns, rows) else { return };
        let part = cut(cells, (left, right), (top, bottom));
        let corner = array.corner + array.path * x as f64 + array.progression * y as f64;
        let width = array.path * (right - left) as f64;
        self.cells(corner, width, array.progression * (bottom - top) as f64, &part);
    }
}

/// A part of an array of cells.
fn cut(cells: &Cells, columns: (usize, usize), rows: (usize, usize)) -> Cells {
    fn parts<T: Copy>(all: &[T], stride: usize, columns: (usize, usize), rows: (usize, usize)) -> Vec<T> {
        let row = |row: usize| &all[row * stride + columns.0..row * stride + columns.1];
        (rows.0..rows.1).flat_map(row).copied().collect()
    }
    let inks = match &cells.inks {
        Inks::Indices(indices) => Inks::Indices(parts(indices, cells.columns, columns, rows)),
        Inks::Direct(colours) => Inks::Direct(parts(colours, cells.columns, columns, rows)),
    };
    Cells { columns: columns.1 - columns.0, rows: rows.1 - rows.0, inks }
}

/// The cells of a tile; none if its compression is not known or there are too few of them.
fn decoded(e: &Element, bitonal: bool, (columns, rows): (usize, usize), direct: bool) -> Option<Cells> {
    columns.checked_mul(rows).filter(|count| (1..=MOST_CELLS).contains(count))?;
    let compression = e.integer(0)?;
    if !bitonal {
        return None;
    }
    let (back, fore) = (e.ink(2)?, e.ink(3)?);
    let bits = e.bytes(5).unwrap_or_default();
    let row_octets = match e.integer(1)? {
        padding @ 1.. => columns.div_ceil(8).next_multiple_of((padding as usize).div_ceil(8)),
        _ => columns.div_ceil(8),
    };
    let set = |row: usize, column: usize| match compression {
        0 => Some(false),
        1 => Some(true),
        5 => bits.get(row * row_octets + column / 8).map(|octet| octet >> (7 - column % 8) & 1 == 1),
        _ => None,
    };
    let pick = |on: bool| if on { fore } else { back };
    let mut inks = if direct { Inks::Direct(Vec::new()) } else { Inks::Indices(Vec::new()) };
    for row in 0..rows {
        for column in 0..columns {
            match (&mut inks, pick(set(row, column)?)) {
                (Inks::Indices(indices), Ink::Index(index)) => {
                    repeat(indices, index.min(i32::MAX as u32) as i32, 1, MOST_CELLS);
                }
                (Inks::Direct(colours), Ink::Direct(colour)) => {
                    let [red, green, blue, _] = colour.to_bytes();
                    repeat(colours, [red, green, blue], 1, MOST_CELLS);
                }
                _ => return None,
            }
        }
    }
    Some(Cells { columns, rows, inks })
}
