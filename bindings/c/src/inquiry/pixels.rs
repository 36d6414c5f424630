//! Inquiries of pixels: what a display surface shows.

use crate::argument::{In, Out, Part, inquire, integer};
use crate::types::{Gint, Gint_list, Gint_size, Gpoint, Grect};
use gks::Function;

/// INQUIRE PIXEL ARRAY DIMENSIONS.
#[unsafe(no_mangle)]
extern "C" fn ginq_pixel_array_dims(ws_id: Gint, rect: In<Grect>, err_ind: Out<Gint>, dims: Out<Gint_size>) {
    const F: Function = Function::InquirePixelArrayDimensions;
    inquire(F, err_ind, |gks| {
        let rect = rect.needed(F)?;
        let (columns, rows) = gks.inquire_pixel_array_dimensions(ws_id, rect.p, rect.q)?;
        dims.set(Gint_size { size_x: integer(columns), size_y: integer(rows) });
        Ok(())
    });
}

/// INQUIRE PIXEL ARRAY: the list is the array row by row.
#[unsafe(no_mangle)]
extern "C" fn ginq_pixel_array(
    ws_id: Gint,
    pixel_loc: In<Gpoint>,
    dims: In<Gint_size>,
    num_elems_appl_list: Gint,
    start_pos: Gint,
    err_ind: Out<Gint>,
    pres_inval: Out<Gint>,
    pixel_array: Out<Gint_list>,
    length_list: Out<Gint>,
) {
    const F: Function = Function::InquirePixelArray;
    let part = Part::of(num_elems_appl_list, start_pos, pixel_array, length_list);
    inquire(F, err_ind, |gks| {
        let dims = dims.needed(F)?;
        let [columns, rows] = [dims.size_x, dims.size_y].map(|n| usize::try_from(n).unwrap_or(0));
        let pixels = gks.inquire_pixel_array(ws_id, pixel_loc.needed(F)?, columns, rows)?;
        pres_inval.set(pixels.invalid.into());
        part.set(F, pixels.indices.iter().copied())
    });
}

/// INQUIRE PIXEL.
#[unsafe(no_mangle)]
extern "C" fn ginq_pixel(ws_id: Gint, pixel_loc: In<Gpoint>, err_ind: Out<Gint>, colr_ind: Out<Gint>) {
    const F: Function = Function::InquirePixel;
    inquire(F, err_ind, |gks| {
        colr_ind.set(gks.inquire_pixel(ws_id, pixel_loc.needed(F)?)?);
        Ok(())
    });
}
