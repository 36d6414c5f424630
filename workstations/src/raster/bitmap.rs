//! The store of a true-colour frame buffer: pixels, row by row from the top.

use super::composite::{Pixel, demultiplied};
use prefetch_index::prefetch_index;
use std::ops::Range;

/// Rows of a part of a bitmap that are asked for some time before they are drawn on, from the top.
pub(super) struct Ahead {
    columns: Range<u32>,
    /// Those not asked for yet.
    rows: Range<u32>,
}

impl Ahead {
    /// As many rows are on their way.
    const ROWS: u32 = 8;
    /// More columns than this come fast enough by themselves.
    const WIDEST: usize = 512;

    /// Asks for the first rows of a part of a bitmap.
    pub(super) fn new(bitmap: &Bitmap, columns: Range<u32>, mut rows: Range<u32>) -> Self {
        let first = rows.start;
        if columns.len() > Ahead::WIDEST {
            rows.start = rows.end;
        }
        let mut ahead = Ahead { columns, rows };
        ahead.reach(bitmap, first);
        ahead
    }

    /// Asks for further rows when one of them is drawn on.
    #[inline]
    pub(super) fn reach(&mut self, bitmap: &Bitmap, row: u32) {
        while self.rows.start < self.rows.end && self.rows.start < row + Ahead::ROWS {
            bitmap.fetch(self.rows.start, &self.columns);
            self.rows.start += 1;
        }
    }
}

/// Pixels in rows.
#[derive(Debug)]
pub(super) struct Bitmap {
    width: usize,
    height: usize,
    pixels: Vec<Pixel>,
}

impl Bitmap {
    /// A bitmap of transparent pixels.
    pub(super) fn new(width: u32, height: u32) -> Self {
        let (width, height) = (width as usize, height as usize);
        Bitmap { width, height, pixels: vec![[0; 4]; width * height] }
    }

    /// Number of columns and rows.
    pub(super) fn size(&self) -> (u32, u32) {
        (self.width as u32, self.height as u32)
    }

    /// Gives all pixels one value.
    pub(super) fn fill(&mut self, pixel: Pixel) {
        self.pixels.fill(pixel);
    }

    /// All pixels.
    pub(super) fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// All pixels, to be changed.
    pub(super) fn pixels_mut(&mut self) -> &mut [Pixel] {
        &mut self.pixels
    }

    /// Asks for a part of a row that is about to be drawn on, so that it comes from memory meanwhile.
    #[inline]
    fn fetch(&self, row: u32, columns: &Range<u32>) {
        /// The pixels that come together.
        const LINE: usize = 16;
        let start = row as usize * self.width;
        for column in columns.clone().step_by(LINE) {
            prefetch_index(&self.pixels, start + column as usize);
        }
    }

    /// Copies to some pixels of a row, which is not the first one, those above them.
    pub(super) fn repeat_above(&mut self, pixels: Range<usize>) {
        self.pixels.copy_within(pixels.start - self.width..pixels.end - self.width, pixels.start);
    }

    /// One pixel, or none outside of the bitmap.
    pub(super) fn pixel(&self, column: u32, row: u32) -> Option<Pixel> {
        let (column, row) = (column as usize, row as usize);
        (column < self.width).then(|| self.pixels.get(row * self.width + column).copied()).flatten()
    }

    /// The pixels of some columns of a row.
    #[inline]
    pub(super) fn span(&mut self, row: usize, columns: Range<usize>) -> &mut [Pixel] {
        debug_assert!(columns.end <= self.width);
        let start = row * self.width;
        &mut self.pixels[start + columns.start..start + columns.end]
    }

    /// The pixels of a row from a column on.
    #[inline]
    pub(super) fn rest(&mut self, row: usize, column: usize) -> &mut [Pixel] {
        let start = row * self.width;
        &mut self.pixels[start + column..start + self.width]
    }

    /// Some of the rows in bands of a height, from the top.
    pub(super) fn bands(&mut self, rows: Range<usize>, height: usize) -> impl Iterator<Item = Band<'_>> {
        let width = self.width;
        let tops = rows.clone().step_by(height);
        let bands = self.pixels[rows.start * width..rows.end * width].chunks_mut(height * width);
        tops.zip(bands).map(move |(top, pixels)| Band { top, width, pixels })
    }

    /// The bytes of all pixels.
    pub(super) fn bytes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// The bytes of all colours, not premultiplied by their opacity.
    pub(super) fn demultiplied(&self) -> Vec<u8> {
        self.pixels.iter().flat_map(|&pixel| demultiplied(pixel)).collect()
    }
}

/// Neighbouring rows of a bitmap.
pub(super) struct Band<'a> {
    top: usize,
    width: usize,
    pixels: &'a mut [Pixel],
}

impl Band<'_> {
    /// Its rows, as the bitmap counts them.
    pub(super) fn rows(&self) -> Range<usize> {
        self.top..self.top + self.pixels.len() / self.width
    }

    /// The pixels of some columns of a row.
    #[inline]
    pub(super) fn span(&mut self, row: usize, columns: Range<usize>) -> &mut [Pixel] {
        let start = (row - self.top) * self.width;
        &mut self.pixels[start + columns.start..start + columns.end]
    }
}
