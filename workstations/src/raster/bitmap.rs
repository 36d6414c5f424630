//! The store of a true-colour frame buffer: pixels, row by row from the top.

use super::composite::{Pixel, demultiplied};
use std::ops::Range;

/// Pixels in rows.
#[derive(Debug)]
pub(super) struct Bitmap {
    width: usize,
    pixels: Vec<Pixel>,
}

impl Bitmap {
    /// A bitmap of transparent pixels.
    pub(super) fn new(width: u32, height: u32) -> Self {
        let (width, height) = (width as usize, height as usize);
        Bitmap { width, pixels: vec![[0; 4]; width * height] }
    }

    /// Number of columns and rows.
    pub(super) fn size(&self) -> (u32, u32) {
        (self.width as u32, (self.pixels.len() / self.width.max(1)) as u32)
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

    /// Reads something of every 64 bytes of the pixels in a window, with nothing in between: that brings them from
    /// memory all at once, where one row after the other would have to be waited for. Large windows pay for themselves.
    pub(super) fn touch(&self, columns: Range<u32>, rows: Range<u32>) {
        const LINE: usize = 16;
        const LARGE: usize = 128;
        let [columns, rows] = [columns, rows].map(|range| range.start as usize..range.end as usize);
        if columns.len() > LARGE || rows.len() > LARGE {
            return;
        }
        let mut read = 0;
        for row in rows {
            for column in columns.clone().step_by(LINE) {
                let place = row * self.width + column;
                read ^= self.pixels.get(place).map_or(0, |pixel| u32::from_ne_bytes(*pixel));
            }
        }
        std::hint::black_box(read);
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
