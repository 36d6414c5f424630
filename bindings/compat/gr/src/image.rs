//! Colours that are no entries of a table, and DRAW IMAGE.

use crate::argument::{Address, call};
use crate::extension;
use crate::resample::resampled;
use gks::{Function, Gks};
use gks_pipeline::description::Classification;
use std::ffi::c_int;

/// The colour index that holds a colour itself, for all workstations
/// ([`of_packed_index`](gks_pipeline::colour::Colour::of_packed_index)): 8 bits of red, green and blue from the lowest of
/// `colour` on, and an opacity from 0 to 1, of which 64 steps remain.
pub(crate) fn packed(colour: c_int, opacity: f64) -> c_int {
    let [red, green, blue, _] = colour.to_le_bytes().map(c_int::from);
    1 << 30 | ((opacity * 63.0).round() as c_int) << 24 | red << 16 | green << 8 | blue
}

/// Draws an image whose lower left corner lies at a position, in world coordinates, with the size of a pixel in them. A
/// pixel has 8 bits of red, green, blue and opacity, from the lowest on.
#[unsafe(no_mangle)]
extern "C" fn gks_draw_image(
    x: f64,
    y: f64,
    scale_x: f64,
    scale_y: f64,
    width: c_int,
    height: c_int,
    pixels: Address<c_int>,
) {
    call(Function::CellArray, |gks| {
        let [columns, rows] = [width, height].map(|n| usize::try_from(n).unwrap_or(0));
        let pixels = pixels.slice(columns.saturating_mul(rows));
        let (width, height) = (scale_x * columns as f64, scale_y * rows as f64);
        draw(gks, ((x, y), (x + width, y + height)), (columns, rows), pixels)
    });
}

/// Draws pixels between the lower left and the upper right corner; the first row is at the top.
fn draw(
    gks: &mut Gks,
    ((left, bottom), (right, top)): ((f64, f64), (f64, f64)),
    (columns, rows): (usize, usize),
    pixels: &[c_int],
) -> gks::Result<()> {
    let (opacity, methods) = extension::with(|state| (state.opacity, state.resample_methods()));
    let size = (columns, rows);
    let target = shown(gks, (left, bottom), (right, top), size);
    let smooth = target.and_then(|target| resampled(pixels, size, target, methods));
    let (pixels, (columns, rows)) = match &smooth {
        Some((pixels, size)) => (&pixels[..], *size),
        None => (pixels, (columns, rows)),
    };
    let cell = |&pixel: &c_int| packed(pixel, f64::from(pixel.to_le_bytes()[3]) / 255.0 * opacity);
    let cells: Vec<c_int> = pixels.iter().map(cell).collect();
    gks.cell_array_of((left, top), (right, bottom), &cells, columns, rows, columns)
}

/// On how many columns and rows of pixels a rectangle is shown on the active workstation where it takes the most of them,
/// on documents at `least` so many.
fn shown(gks: &Gks, p: (f64, f64), q: (f64, f64), least: (usize, usize)) -> Option<(usize, usize)> {
    let active: Vec<c_int> =
        gks.inquire_set_of_active_workstations().map(Iterator::collect).unwrap_or_default();
    // Metafiles and segment storage have no pixels.
    let pixels = |&id: &c_int| {
        let (columns, rows) = gks.inquire_pixel_array_dimensions(id, p, q).ok()?;
        // The pixels of both corners are counted, of which one lies outside.
        let size = ((columns - 1).max(1), (rows - 1).max(1));
        let kind = gks.inquire_workstation_connection_and_type(id).ok()?.1;
        match gks.inquire_workstation_classification(kind).ok()? {
            Classification::Raster => Some(size),
            // What is written in points is shown with more pixels than that.
            Classification::Vector | Classification::Other => {
                Some((size.0.max(least.0), size.1.max(least.1)))
            }
        }
    };
    let most = |a: (usize, usize), b: (usize, usize)| (a.0.max(b.0), a.1.max(b.1));
    active.iter().filter_map(pixels).reduce(most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::colour::Colour;

    #[test]
    fn an_index_holds_the_colour_and_the_opacity() {
        let found = |colour, opacity| Colour::of_packed_index(packed(colour, opacity) as u32).unwrap();
        assert_eq!(found(0x00_80_ff, 1.0).to_bytes(), [0xff, 0x80, 0x00, 0xff]);
        assert_eq!(found(-1, 0.0).to_bytes(), [0xff, 0xff, 0xff, 0x00]);
        assert_eq!(found(0, 1.0 / 3.0).to_bytes(), [0, 0, 0, 85]);
    }
}
