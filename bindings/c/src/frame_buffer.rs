//! The frame buffer of a workstation, beyond the standard: `gks_extra.h`.

use crate::argument::{BUFFER, Out, inquire, integer};
use crate::types::{Gint, Gint_size};
use gks::{Error, Function};

/// Copies the colours of all pixels, 4 bytes each, row by row from the top.
#[unsafe(no_mangle)]
extern "C" fn gks_frame_buffer(
    ws_id: Gint,
    rgba: Out<u8>,
    size: usize,
    err_ind: Out<Gint>,
    dims: Out<Gint_size>,
) {
    inquire(Function::InquirePixelArray, err_ind, |gks| {
        let ((columns, rows), colours) = gks.frame_buffer(ws_id)?;
        dims.set(Gint_size { size_x: integer(columns), size_y: integer(rows) });
        if rgba.is_wanted() {
            let need = u64::from(columns) * u64::from(rows) * 4;
            if need > size as u64 {
                return Err(Error::new(BUFFER, Function::InquirePixelArray));
            }
            rgba.set_all(colours.flat_map(gks_pipeline::colour::Colour::to_bytes));
        }
        Ok(())
    });
}
