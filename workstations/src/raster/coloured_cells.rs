//! Cells in a true-colour frame buffer.

use super::bitmap::Bitmap;
use super::cells::{self, Extent};
use super::clip::Window;
use super::composite::{Pixel, over, pixel};
use gks_geometry::Du;
use gks_pipeline::device::{Grid, Palette};
use gks_pipeline::item::{Cells, Parallelogram};

/// Draws cells of paints.
pub(super) fn draw(bitmap: &mut Bitmap, frame: &Parallelogram<Du>, grid: &Grid<'_>, window: &Window) {
    if grid.columns.checked_mul(grid.rows).is_none_or(|count| count > grid.paints.len()) {
        return;
    }
    let opaque = grid.paints.iter().all(|paint| paint.colour.to_bytes()[3] == 255);
    let mut held = (usize::MAX, [0; 4]);
    let mut colour = |place: usize| {
        if place != held.0 {
            held = (place, pixel(grid.paints[place].colour));
        }
        held.1
    };
    let width = bitmap.size().0 as usize;
    let extent = Extent { columns: grid.columns, rows: grid.rows, stride: grid.columns };
    cells::lines(window.centred(), frame, extent, |line| {
        let pixels = line.pixels(width);
        if line.again && opaque {
            return bitmap.repeat_above(pixels);
        }
        let below = &mut bitmap.pixels_mut()[pixels];
        below.iter_mut().zip(line.places()).for_each(|(below, place)| over(below, colour(place), 255));
    });
}

/// Draws cells of colour indices. Those from 0 to 255 are looked up in a table of pixels.
pub(super) fn draw_indexed(
    bitmap: &mut Bitmap,
    frame: &Parallelogram<Du>,
    cells: &Cells<'_>,
    palette: &Palette<'_>,
    window: &Window,
) {
    let shown = |index: i32| pixel(palette.paint(index).colour);
    let table: [Pixel; 256] = std::array::from_fn(|index| shown(index as i32));
    let opaque = table.iter().all(|pixel| pixel[3] == 255);
    let (indices, stride) = cells.indices();
    let mut plain = false;
    let width = bitmap.size().0 as usize;
    let extent = Extent { columns: cells.columns, rows: cells.rows, stride };
    cells::lines(window.centred(), frame, extent, |line| {
        let pixels = line.pixels(width);
        if line.again && plain {
            return bitmap.repeat_above(pixels);
        }
        let below = &mut bitmap.pixels_mut()[pixels];
        let row = &indices[line.base..];
        let is_known = |index: i32| index & 255 == index;
        if opaque && line.consecutive && !below.is_empty() {
            let row = &row[line.offsets[0]..][..below.len()];
            plain = is_known(row.iter().fold(0, |bits, index| bits | index));
            if plain {
                let pairs = below.iter_mut().zip(row);
                return pairs.for_each(|(below, &index)| *below = table[usize::from(index as u8)]);
            }
        }
        plain = opaque;
        for (below, &offset) in below.iter_mut().zip(line.offsets) {
            let index = row[offset];
            if is_known(index) {
                over(below, table[usize::from(index as u8)], 255);
            } else {
                plain = false;
                over(below, shown(index), 255);
            }
        }
    });
}
