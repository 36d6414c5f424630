//! Inquiries of pixels.

use crate::answer::{TOO_SMALL, answer, inquiries};
use crate::argument::{Integer, Real};
use gks::{Error, Function};

inquiries! {
    gqpxad_(wkid: Integer, px: Real, py: Real, qx: Real, qy: Real) -> (n: Integer, m: Integer)
        InquirePixelArrayDimensions => |gks| {
            let (p, q) = ((px.real(), py.real()), (qx.real(), qy.real()));
            gks.inquire_pixel_array_dimensions(wkid.get(), p, q)
        };
    gqpx_(wkid: Integer, px: Real, py: Real) -> (coli: Integer) InquirePixel
        => |gks| gks.inquire_pixel(wkid.get(), (px.real(), py.real()));
}

/// GQPXA: INQUIRE PIXEL ARRAY, into the part of an array that starts with the element (isc, isr). What lies
/// beside it is left alone.
#[unsafe(no_mangle)]
extern "C" fn gqpxa_(
    wkid: Integer,
    px: Real,
    py: Real,
    dimx: Integer,
    dimy: Integer,
    isc: Integer,
    isr: Integer,
    dx: Integer,
    dy: Integer,
    errind: Integer,
    invval: Integer,
    colia: Integer,
) {
    const F: Function = Function::InquirePixelArray;
    let (dimensions, start) = ([dimx, dimy].map(Integer::count), [isc, isr].map(Integer::count));
    let size = [dx, dy].map(Integer::count);
    let is_proper = dimensions.into_iter().chain(start).chain(size).all(|n| n > 0);
    let is_inside = is_proper && (0..2).all(|i| start[i] - 1 + size[i] <= dimensions[i]);
    answer(F, errind, invval, |gks| {
        let ([columns, rows], at) = (if is_inside { size } else { [0, 0] }, (px.real(), py.real()));
        let first = if is_inside { (start[1] - 1) * dimensions[0] + start[0] - 1 } else { 0 };
        let room = colia.slice_mut(first, rows.saturating_sub(1) * dimensions[0] + columns);
        let read = gks.inquire_pixel_array_into(wkid.get(), at, columns, rows, dimensions[0], room);
        read.map_err(|error| match error.number {
            91 if is_proper => Error::new(TOO_SMALL, F),
            _ => error,
        })
    });
}
