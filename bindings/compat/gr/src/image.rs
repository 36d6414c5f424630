//! DRAW IMAGE: pixels with colours of their own, by way of the colour table.

use crate::argument::{Address, call};
use gks::{Function, Gks};
use std::collections::BTreeMap;
use std::ffi::c_int;

/// The colour index from which on the colours of images lie.
const FIRST: c_int = 4096;
/// How many colours an image may have; one with more is drawn in the nearest of fewer.
const MOST: usize = 4096;

/// The colours of an image and the index of each of its pixels.
struct Palette {
    colours: Vec<u32>,
    cells: Vec<c_int>,
}

/// The colours of pixels, of which each has 8 bits of red, green and blue from the lowest on, taken as exactly as the
/// number of colours allows.
fn palette(pixels: &[c_int]) -> Palette {
    let mut bits = 8;
    loop {
        let mask = (0xff << (8 - bits)) & 0xff;
        let mask = mask | mask << 8 | mask << 16;
        let mut known: BTreeMap<u32, c_int> = BTreeMap::new();
        let mut colours = Vec::new();
        let mut cells = Vec::with_capacity(pixels.len());
        for &pixel in pixels {
            let next = known.len() as c_int;
            let index = *known.entry(pixel as u32 & mask).or_insert_with(|| {
                colours.push(pixel as u32);
                next
            });
            cells.push(FIRST + index);
        }
        if colours.len() <= MOST {
            return Palette { colours, cells };
        }
        bits -= 1;
    }
}

/// Gives the colours of pixels to colour indices of all active workstations, and says which index each pixel has.
pub(crate) fn indices(gks: &mut Gks, pixels: &[c_int]) -> gks::Result<Vec<c_int>> {
    let Palette { colours, cells } = palette(pixels);
    let active: Vec<c_int> = gks.inquire_set_of_active_workstations()?.collect();
    for &id in &active {
        for (&colour, index) in colours.iter().zip(FIRST..) {
            let part = |shift: u32| f64::from(colour >> shift & 0xff) / 255.0;
            gks.set_colour_representation(id, index, (part(0), part(8), part(16)))?;
        }
    }
    Ok(cells)
}

fn draw(
    gks: &mut Gks,
    corner: (f64, f64),
    scale: (f64, f64),
    size: (usize, usize),
    pixels: &[c_int],
) -> gks::Result<()> {
    let cells = indices(gks, pixels)?;
    let (width, height) = (scale.0 * size.0 as f64, scale.1 * size.1 as f64);
    // The first row is at the top.
    let (p, q) = ((corner.0, corner.1 + height), (corner.0 + width, corner.1));
    gks.cell_array_of(p, q, &cells, size.0, size.1, size.0)
}

/// Draws an image whose lower left corner lies at a position, in world coordinates, with the size of a pixel in
/// them. The opacity of pixels is not used.
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
        let size = [width, height].map(|n| usize::try_from(n).unwrap_or(0));
        let pixels = pixels.slice(size[0].saturating_mul(size[1]));
        draw(gks, (x, y), (scale_x, scale_y), (size[0], size[1]), pixels)
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_exact_until_there_are_too_many() {
        let few = palette(&[0x00_00ff, 0x12_3456, 0x00_00ff]);
        assert_eq!(few.colours, [0x00_00ff, 0x12_3456]);
        assert_eq!(few.cells, [FIRST, FIRST + 1, FIRST]);
        let many: Vec<c_int> = (0..20_000).map(|i| (i * 7919) & 0xff_ffff).collect();
        let palette = palette(&many);
        assert!(palette.colours.len() <= MOST && palette.colours.len() > MOST / 16);
        assert_eq!(palette.cells.len(), many.len());
    }
}
