//! Tile arrays: rectangles of cells, tile by tile.

use super::Interpreter;
use crate::cgm::decoder::Decoder;
use crate::cgm::element::{Cells, Element, Inks, Value};
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
        if !matches!(e.kind, Kind::Tile | Kind::BitonalTile) {
            return false;
        }
        let Some(mut array) = self.tiles.clone() else { return false };
        let at = (array.next % array.tiles, array.next / array.tiles);
        array.next += 1;
        let cells =
            e.values.last().and_then(|last| if let Value::Cells(cells) = last { Some(cells) } else { None });
        match (cells, e.integer(0)) {
            (Some(cells), _) if (cells.columns, cells.rows) == array.cells => self.place(&array, at, cells),
            // Nothing but background, which is there already.
            (None, Some(0)) if e.kind == Kind::Tile => {}
            (None, Some(compression)) if !matches!(compression, 5 | 6) => {
                let name = e.kind.row().name;
                self.skipped.add(&format!("{name}, {}", compression_name(compression)));
            }
            _ => self.senseless(e),
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

/// A way of compression that is not read.
fn compression_name(number: i32) -> String {
    match number {
        1 => "null foreground".to_owned(),
        2 => "compressed by T.6".to_owned(),
        3 => "compressed by T.4 in one dimension".to_owned(),
        4 => "compressed by T.4 in two dimensions".to_owned(),
        7 => "compressed by JPEG".to_owned(),
        8 => "compressed by LZW".to_owned(),
        9 => "compressed by PNG".to_owned(),
        _ => format!("compression type {number}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cgm::binary::decoder::BinaryDecoder;
    use crate::cgm::binary::encoder::BinaryEncoder;
    use crate::cgm::element::Ink;
    use crate::cgm::encoder::{Coordinates, Encoder};
    use gks_pipeline::item::Shape;
    use gks_pipeline::record::{Record, Source};

    /// What a tile array of 3 columns and 2 rows with one tile draws, cell by cell, and what is skipped of it.
    fn drawn(direct: bool, tile: Element) -> (Vec<Vec<i32>>, Vec<String>) {
        let integers = |numbers: &[i32]| numbers.iter().copied().map(Value::Integer).collect::<Vec<_>>();
        let mut array = vec![Value::Point(DVec2::ZERO)];
        array.extend(integers(&[0, 0, 1, 1, 3, 2]));
        array.extend([Value::Real(100.0), Value::Real(100.0)]);
        array.extend(integers(&[0, 0, 3, 2]));
        let elements = [
            Element::new(Kind::BeginMetafile, [Value::Text(Vec::new())]),
            Element::new(Kind::BeginPicture, [Value::Text(Vec::new())]),
            Element::new(Kind::ColourSelectionMode, [Value::Integer(i32::from(direct))]),
            Element::new(Kind::BeginPictureBody, []),
            Element::new(Kind::BeginTileArray, array),
            tile,
            Element::new(Kind::EndTileArray, []),
            Element::new(Kind::EndPicture, []),
            Element::new(Kind::EndMetafile, []),
        ];
        let (mut encoder, mut octets) = (BinaryEncoder::new(Coordinates::Integer16, 8), Vec::new());
        elements.iter().for_each(|element| encoder.encode(element, &mut octets));
        let mut source = Interpreter::new(BinaryDecoder::new(std::io::Cursor::new(octets)));
        let mut rows = Vec::new();
        while let Some(record) = source.next().unwrap() {
            if let Record::Primitive(Shape::CellArray(_, cells)) = record {
                rows.extend((0..cells.rows).map(|row| cells.row(row).to_vec()));
            }
        }
        let skipped = source.skipped().iter().map(|(name, _)| name.to_owned()).collect();
        (rows, skipped)
    }

    /// A tile of indices with a way of compression, a row padding, a precision, and its bits.
    fn colours(compression: i32, padding: i32, precision: i32, record: &[u8], bits: &[u8]) -> Element {
        let numbers = [compression, padding, precision].map(Value::Integer);
        let data = [Value::Data(record.to_vec()), Value::Data(bits.to_vec())];
        Element::new(Kind::Tile, [&numbers[..], &data[..]].concat())
    }

    fn bitonal(compression: i32, padding: i32, record: &[u8], bits: &[u8]) -> Element {
        let inks = [Value::Ink(Ink::Index(4)), Value::Ink(Ink::Index(5))];
        let numbers = [compression, padding].map(Value::Integer);
        let data = [Value::Data(record.to_vec()), Value::Data(bits.to_vec())];
        Element::new(Kind::BitonalTile, [&numbers[..], &inks[..], &data[..]].concat())
    }

    /// A structured data record with one integer.
    const EIGHT: [u8; 6] = [0, 6, 0, 1, 0, 8];

    #[test]
    fn tiles_of_colours_come_cell_by_cell_and_in_runs() {
        let expected = [vec![1, 2, 3], vec![4, 5, 6]];
        assert_eq!(drawn(false, colours(5, 0, 0, &[], &[1, 2, 3, 4, 5, 6])).0, expected);
        assert_eq!(drawn(false, colours(5, 16, 4, &[], &[0x12, 0x30, 0x45, 0x60])).0, expected);
        let runs = [2, 1, 1, 2, 9, 3];
        assert_eq!(drawn(false, colours(6, 8, 0, &EIGHT, &runs)).0, [vec![1, 1, 2], vec![3, 3, 3]]);
        let (rows, skipped) = drawn(true, colours(5, 0, 8, &[], &[255, 0, 0].repeat(6)));
        assert!(rows.len() == 2 && rows.concat().iter().all(|index| *index == rows[0][0]), "{rows:?}");
        assert!(skipped.is_empty(), "{skipped:?}");
    }

    #[test]
    fn tiles_of_two_colours_come_bit_by_bit_and_in_runs() {
        assert_eq!(drawn(false, bitonal(5, 8, &[], &[0b1010_0000, 0b0110_0000])).0, [[5, 4, 5], [4, 5, 5]]);
        assert_eq!(drawn(false, bitonal(5, 0, &[], &[0b1010_1100])).0, [[5, 4, 5], [4, 5, 5]]);
        assert_eq!(drawn(false, bitonal(0, 0, &[], &[])).0, [[4; 3]; 2]);
        assert_eq!(drawn(false, bitonal(1, 0, &[], &[])).0, [[5; 3]; 2]);
        // Two of the foreground, one of the background; three of the foreground.
        let runs = [0b0000_0010, 0b1000_0000, 0b1000_0000, 0b0000_0011, 0b1000_0000];
        assert_eq!(drawn(false, bitonal(6, 8, &EIGHT, &runs)).0, [[5, 5, 4], [5, 5, 5]]);
    }

    #[test]
    fn what_is_compressed_in_other_ways_is_told() {
        let told = |tile: Element| drawn(false, tile).1;
        assert_eq!(told(colours(7, 0, 0, &[], &[1])), ["TILE, compressed by JPEG"]);
        assert_eq!(told(bitonal(2, 0, &[], &[1])), ["BITONAL TILE, compressed by T.6"]);
        assert_eq!(told(colours(5, 0, 0, &[], &[1])), ["TILE with senseless parameters"]);
        assert_eq!(told(colours(6, 0, 0, &[], &[1])), ["TILE with senseless parameters"]);
        assert!(told(colours(0, 0, 0, &[], &[])).is_empty());
    }
}
