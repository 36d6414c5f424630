//! Inquiries of pixels: what a display surface shows.
//!
//! Pixels are counted from the left and from the top. Where they hold colours and not colour indices, the
//! index of a pixel is the least one whose colour is the same in 8 bits a component.

use crate::{Error, Function, Gks, Result};
use gks_geometry::{Point, Wc};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::FrameBuffer;
use gks_pipeline::tables::Tables;
use gks_pipeline::workstation::ReadBack;
use std::collections::HashMap;

/// The index of a pixel that lies outside of the display surface or whose colour no index has.
const INVALID: i32 = -1;

/// The most pixels that [`Gks::inquire_pixel_array`] makes room for.
const MOST_PIXELS: usize = 1 << 28;

/// Colour indices of a rectangle of pixels, row by row from the top, column fastest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PixelArray {
    /// Number of columns.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// The colour indices, -1 for pixels without one.
    pub indices: Vec<i32>,
    /// Whether there are pixels without a colour index.
    pub invalid: bool,
}

/// The pixels of a frame buffer as colour indices, for reading many of them.
struct Pixels<'a> {
    buffer: &'a dyn FrameBuffer,
    tables: &'a Tables,
    /// The least index of each colour of the colour table, made when it is needed.
    indices: Option<HashMap<[u8; 4], i32>>,
    /// The colour read last: neighbours are mostly alike.
    last: Option<([u8; 4], i32)>,
}

impl Pixels<'_> {
    fn index(&mut self, column: u32, row: u32) -> i32 {
        if let Some(index) = self.buffer.index(column, row) {
            return index as i32;
        }
        let Some(shown) = self.buffer.colour(column, row).map(bytes) else { return INVALID };
        if let Some((colour, index)) = self.last
            && colour == shown
        {
            return index;
        }
        let index = self.of_colour(shown);
        self.last = Some((shown, index));
        index
    }

    fn of_colour(&mut self, shown: [u8; 4]) -> i32 {
        let indices = self.indices.get_or_insert_with(|| {
            let mut indices = HashMap::new();
            for (index, colour) in self.tables.colours.iter() {
                indices.entry(bytes(colour)).or_insert(index as i32);
            }
            indices
        });
        indices.get(&shown).copied().unwrap_or(INVALID)
    }
}

/// A colour in 8 bits a component; all that are fully transparent are the same.
fn bytes(colour: Colour) -> [u8; 4] {
    match colour.to_bytes() {
        [_, _, _, 0] => [0; 4],
        bytes => bytes,
    }
}

/// Which of `count` pixels from pixel `start` on, a whole number, lie on a side of the display surface that
/// has `size` of them.
fn on_surface(start: f64, count: usize, size: u32) -> std::ops::Range<usize> {
    let first = (-start).max(0.0).min(count as f64);
    let end = (f64::from(size) - start).max(first).min(count as f64);
    // A start that is no number leaves an empty range.
    if start.is_finite() { first as usize..end as usize } else { 0..0 }
}

impl Gks {
    /// INQUIRE PIXEL ARRAY DIMENSIONS: the numbers of columns and rows of pixels from the one that contains
    /// `p` to the one that contains `q`, both included. Workstations without pixels count their addressable
    /// positions.
    ///
    /// Errors: 7, 20, 25, 39.
    pub fn inquire_pixel_array_dimensions(
        &self,
        id: i32,
        p: impl Into<Point<Wc>>,
        q: impl Into<Point<Wc>>,
    ) -> Result<(usize, usize)> {
        let workstation = &self.inquired(Function::InquirePixelArrayDimensions, id)?.workstation;
        let map = &self.normalization.map;
        let (px, py) = workstation.pixel_at(map.point(p.into()));
        let (qx, qy) = workstation.pixel_at(map.point(q.into()));
        Ok((((qx - px).abs() + 1.0) as usize, ((qy - py).abs() + 1.0) as usize))
    }

    /// INQUIRE PIXEL: the colour index of the pixel that contains a point; -1 outside of the display surface
    /// and for a colour that no index has.
    ///
    /// Errors: 7, 20, 25, 39, 40 (pixels cannot be read back).
    pub fn inquire_pixel(&mut self, id: i32, p: impl Into<Point<Wc>>) -> Result<i32> {
        let ((column, row), read) = self.readable(Function::InquirePixel, id, p.into())?;
        let size = read.size;
        if on_surface(column, 1, size.0).is_empty() || on_surface(row, 1, size.1).is_empty() {
            return Ok(INVALID);
        }
        let Some(buffer) = read.buffer else { return Ok(0) };
        let (column, row) = (column as u32, row as u32);
        if let Some(index) = buffer.index(column, row) {
            return Ok(index as i32);
        }
        let shown = buffer.colour(column, row).map(bytes);
        let found = read.tables.colours.iter().find(|&(_, colour)| Some(bytes(colour)) == shown);
        Ok(found.map_or(INVALID, |(index, _)| index as i32))
    }

    /// INQUIRE PIXEL ARRAY: the colour indices of a rectangle of pixels, the upper left of which contains `p`.
    ///
    /// Errors: 7, 20, 25, 39, 40 (pixels cannot be read back), 91 (a dimension is zero), 300 (too many
    /// pixels).
    pub fn inquire_pixel_array(
        &mut self,
        id: i32,
        p: impl Into<Point<Wc>>,
        columns: usize,
        rows: usize,
    ) -> Result<PixelArray> {
        const F: Function = Function::InquirePixelArray;
        let p = p.into();
        self.readable(F, id, p)?;
        let count = columns.saturating_mul(rows);
        if count > MOST_PIXELS {
            return Err(Error::new(300, F));
        }
        let mut indices = vec![INVALID; count];
        let invalid = self.inquire_pixel_array_into(id, p, columns, rows, columns, &mut indices)?;
        Ok(PixelArray { columns, rows, indices, invalid })
    }

    /// INQUIRE PIXEL ARRAY into an array as bindings have it: rows are `stride` indices apart, what lies
    /// between them is left alone. Returns whether there are pixels without a colour index; these are -1.
    ///
    /// Errors: 7, 20, 25, 39, 40 (pixels cannot be read back), 91 (a dimension is zero, or the array too
    /// small).
    pub fn inquire_pixel_array_into(
        &mut self,
        id: i32,
        p: impl Into<Point<Wc>>,
        columns: usize,
        rows: usize,
        stride: usize,
        indices: &mut [i32],
    ) -> Result<bool> {
        const F: Function = Function::InquirePixelArray;
        let ((left, top), read) = self.readable(F, id, p.into())?;
        let need =
            rows.checked_sub(1).and_then(|n| n.checked_mul(stride)).and_then(|n| n.checked_add(columns));
        if columns == 0 || stride < columns || need.is_none_or(|need| need > indices.len()) {
            return Err(Error::new(91, F));
        }
        let (across, down) = (on_surface(left, columns, read.size.0), on_surface(top, rows, read.size.1));
        let mut pixels =
            read.buffer.map(|buffer| Pixels { buffer, tables: read.tables, indices: None, last: None });
        let mut invalid = across.len() < columns || down.len() < rows;
        for (row, indices) in indices.chunks_mut(stride).take(rows).enumerate() {
            let indices = &mut indices[..columns];
            indices.fill(INVALID);
            if !down.contains(&row) {
                continue;
            }
            let inside = &mut indices[across.clone()];
            let Some(pixels) = &mut pixels else {
                inside.fill(0);
                continue;
            };
            let y = (top + row as f64) as u32;
            for (column, index) in across.clone().zip(inside) {
                *index = pixels.index((left + column as f64) as u32, y);
                invalid |= *index == INVALID;
            }
        }
        Ok(invalid)
    }

    /// The pixel that contains a point, and what it can be read from. Errors: those of the state and the
    /// workstation, 40.
    fn readable(&mut self, function: Function, id: i32, p: Point<Wc>) -> Result<((f64, f64), ReadBack<'_>)> {
        let at = self.inquired(function, id)?.workstation.pixel_at(self.normalization.map.point(p));
        Ok((at, self.read_back(function, id)?))
    }

    fn read_back(&mut self, function: Function, id: i32) -> Result<ReadBack<'_>> {
        self.inquired(function, id)?;
        let open = self.workstations.get_mut(&id);
        let read = open.and_then(|open| open.workstation.read_back());
        read.ok_or_else(|| Error::new(40, function))
    }

    /// The numbers of columns and rows of the pixels of a workstation, and their colours row by row from the
    /// top. Beyond the standard, for programs that show or keep pictures themselves.
    ///
    /// Errors: 7, 20, 25, 39, 40 (pixels cannot be read back).
    pub fn frame_buffer(&mut self, id: i32) -> Result<((u32, u32), impl Iterator<Item = Colour>)> {
        let ReadBack { buffer, tables, size } = self.read_back(Function::InquirePixelArray, id)?;
        let background = tables.colours.get(0).unwrap_or(Colour::WHITE);
        let colour = move |column, row| buffer.and_then(|b| b.colour(column, row)).unwrap_or(background);
        let row = move |row| (0..size.0).map(move |column| colour(column, row));
        Ok((size, (0..size.1).flat_map(row)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{CATEGORIES, INDEXED, PLAIN, TRUE_COLOUR, active, closed, number, open};
    use gks_pipeline::description::Category;

    /// A kernel with workstation 1 of a type that has pixels, something drawn, and a normalization
    /// transformation with one unit a pixel, ordinates counted from the bottom.
    fn drawn(kind: i32) -> Gks {
        let (mut gks, _) = active(&[kind]);
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        gks.clear_workstation(1, true).unwrap();
        gks.set_workstation_window(1, (0.0, 1.0, 0.0, 0.5)).unwrap();
        gks.set_window(1, (0.0, 1000.0, 0.0, 500.0)).unwrap();
        gks.set_viewport(1, (0.0, 1.0, 0.0, 0.5)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        gks
    }

    /// What the frame buffer of the tests holds.
    fn held(column: i32, row: i32) -> i32 {
        (row * 1000 + column) % 256
    }

    #[test]
    fn states_identifiers_and_categories_are_checked_in_this_order() {
        let all = |gks: &mut Gks, id| {
            [
                gks.inquire_pixel_array_dimensions(id, (0.0, 0.0), (1.0, 1.0)).map(drop),
                gks.inquire_pixel(id, (0.5, 0.5)).map(drop),
                gks.inquire_pixel_array(id, (0.5, 0.5), 0, 0).map(drop),
                gks.inquire_pixel_array_into(id, (0.5, 0.5), 0, 0, 0, &mut []).map(drop),
            ]
            .map(|result| result.map_or_else(|error| error.number, |()| 0))
        };
        assert_eq!(all(&mut closed(), -1), [7; 4]);
        assert_eq!(all(&mut open(&[]).0, -1), [7; 4]);
        let (mut gks, _) = open(&[CATEGORIES + Category::MetafileOutput as i32, PLAIN, INDEXED]);
        for (id, expected) in
            [(0, [20; 4]), (9, [25; 4]), (1, [39; 4]), (2, [0, 40, 40, 40]), (3, [0, 0, 91, 91])]
        {
            assert_eq!(all(&mut gks, id), expected);
        }
    }

    #[test]
    fn dimensions_count_the_pixels_of_both_corners() {
        let gks = drawn(INDEXED);
        let dimensions = |p: (f64, f64), q: (f64, f64)| gks.inquire_pixel_array_dimensions(1, p, q).unwrap();
        assert_eq!(dimensions((0.0, 0.0), (1000.0, 500.0)), (1000, 500));
        assert_eq!(dimensions((2.5, 7.5), (2.9, 7.1)), (1, 1));
        assert_eq!(dimensions((9.5, 0.5), (0.5, 2.5)), (10, 3));
        assert_eq!(dimensions((-9.5, 0.5), (0.5, 0.5)), (11, 1));
        // A workstation without pixels has 1000 x 1000 addressable positions.
        let (gks, _) = open(&[PLAIN]);
        assert_eq!(gks.inquire_pixel_array_dimensions(1, (0.0, 0.0), (0.5, 0.25)), Ok((501, 250)));
    }

    #[test]
    fn pixels_are_those_that_contain_the_point() {
        // 0 and 255 are greys of the colour table only as white and black are.
        let mut gks = drawn(INDEXED);
        for (x, y, row) in
            [(0.0, 500.0, 0), (0.5, 499.5, 0), (999.9, 0.1, 499), (7.0, 492.5, 7), (1000.0, 0.0, 499)]
        {
            let column = f64::min(x, 999.0) as i32;
            assert_eq!(gks.inquire_pixel(1, (x, y)), Ok(held(column, row)), "({x}, {y})");
        }
        for outside in
            [(-0.1, 5.0), (1000.1, 5.0), (5.0, -0.1), (5.0, 500.1), (f64::NAN, 5.0), (5.0, f64::INFINITY)]
        {
            assert_eq!(gks.inquire_pixel(1, outside), Ok(-1), "{outside:?}");
        }
    }

    #[test]
    fn colours_are_found_in_the_colour_table() {
        let mut gks = drawn(TRUE_COLOUR);
        let grey = |level: u8| {
            let level = f32::from(level) / 255.0;
            Colour::rgb(level, level, level)
        };
        gks.set_colour_representation(1, 300, grey(7)).unwrap();
        gks.set_colour_representation(1, 5000, grey(9)).unwrap();
        gks.set_colour_representation(1, 5001, grey(9)).unwrap();
        let row: Vec<i32> = (0..10).map(|x| gks.inquire_pixel(1, (f64::from(x), 499.5)).unwrap()).collect();
        // Index 1 is black. The predefined greys are lighter than these.
        assert_eq!(row, [1, -1, -1, -1, -1, -1, -1, 300, -1, 5000]);
        let array = gks.inquire_pixel_array(1, (0.5, 499.5), 10, 2).unwrap();
        assert_eq!((array.columns, array.rows, array.invalid), (10, 2, true));
        assert_eq!(array.indices[..10], row);
        let all = gks.inquire_pixel_array(1, (7.5, 499.5), 1, 1).unwrap();
        assert_eq!((all.indices, all.invalid), (vec![300], false));
    }

    #[test]
    fn the_frame_buffer_is_read_row_by_row() {
        let mut gks = drawn(TRUE_COLOUR);
        let (size, colours) = gks.frame_buffer(1).unwrap();
        let colours: Vec<Colour> = colours.collect();
        assert_eq!((size, colours.len()), ((1000, 500), 500_000));
        for (column, row) in [(0, 0), (999, 0), (0, 1), (200, 499)] {
            let level = held(column, row) as f32 / 255.0;
            assert_eq!(colours[(row * 1000 + column) as usize], Colour::rgb(level, level, level));
        }
        let (mut gks, _) = open(&[TRUE_COLOUR, PLAIN]);
        gks.set_colour_representation(1, 0, (0.0, 0.5, 1.0)).unwrap();
        assert!(gks.frame_buffer(1).unwrap().1.all(|colour| colour == Colour::rgb(0.0, 0.5, 1.0)));
        assert_eq!(gks.frame_buffer(2).map(|(size, _)| size).map_err(|e| e.number), Err(40));
        assert_eq!(closed().frame_buffer(1).map(|(size, _)| size).map_err(|e| e.number), Err(7));
    }

    #[test]
    fn arrays_go_right_and_down_and_are_invalid_beyond_the_surface() {
        let mut gks = drawn(INDEXED);
        let array = gks.inquire_pixel_array(1, (20.5, 399.5), 3, 2).unwrap();
        let expected: Vec<i32> = [(20, 100), (21, 100), (22, 100), (20, 101), (21, 101), (22, 101)]
            .map(|(column, row)| held(column, row))
            .to_vec();
        assert_eq!(array, PixelArray { columns: 3, rows: 2, indices: expected, invalid: false });
        let corner = gks.inquire_pixel_array(1, (-0.5, 500.5), 3, 2).unwrap();
        assert_eq!(corner.indices, [-1, -1, -1, -1, held(0, 0), held(1, 0)]);
        assert!(corner.invalid);
        let corner = gks.inquire_pixel_array(1, (998.5, 0.5), 3, 2).unwrap();
        assert_eq!(corner.indices, [held(998, 499), held(999, 499), -1, -1, -1, -1]);
        for far in [(1e300, 0.0), (-1e300, 0.0), (f64::NAN, 0.0), (0.0, f64::NEG_INFINITY)] {
            assert_eq!(gks.inquire_pixel_array(1, far, 2, 1).unwrap().indices, [-1, -1]);
        }
    }

    #[test]
    fn a_part_of_a_wider_array_is_filled() {
        let mut gks = drawn(INDEXED);
        let mut array = [77; 9];
        let fill = |gks: &mut Gks, array: &mut [i32], columns, rows, stride| {
            gks.inquire_pixel_array_into(1, (0.5, 499.5), columns, rows, stride, array)
        };
        assert_eq!(fill(&mut gks, &mut array[1..], 2, 2, 4), Ok(false));
        assert_eq!(array, [77, held(0, 0), held(1, 0), 77, 77, held(0, 1), held(1, 1), 77, 77]);
        for (columns, rows, stride) in [(0, 1, 1), (1, 0, 1), (2, 2, 1), (3, 3, 4), (10, 1, 10)] {
            assert_eq!(number(fill(&mut gks, &mut array, columns, rows, stride)), 91);
        }
        assert_eq!(number(fill(&mut gks, &mut array, 1, usize::MAX, usize::MAX)), 91);
        assert_eq!(number(gks.inquire_pixel_array(1, (0.0, 0.0), 1 << 20, 1 << 20)), 300);
        assert_eq!(number(gks.inquire_pixel_array(1, (0.0, 0.0), usize::MAX, 0)), 91);
    }

    #[test]
    fn an_empty_surface_shows_the_background_and_stays_empty() {
        for kind in [INDEXED, TRUE_COLOUR] {
            let (mut gks, log) = open(&[kind]);
            assert_eq!(gks.inquire_pixel(1, (0.1, 0.1)), Ok(0));
            let array = gks.inquire_pixel_array(1, (0.0, 1.0), 2, 1).unwrap();
            assert_eq!((array.indices, array.invalid), (vec![0, 0], false));
            assert!(log.take().is_empty());
        }
    }
}
