//! Output functions.

use super::argument::{Address, call};
use super::types::{Gchar, Gint, Gipoint, Gpoint, Grect};
use gks::{DataRecord, Function, Points};
use std::ffi::c_void;

fn points<'a>(count: Gint, points: Address<Gpoint>) -> Points<'a> {
    let array = points.array(count);
    // SAFETY: a structure of two numbers is laid out as an array of two.
    Points::Singles(unsafe { std::slice::from_raw_parts(array.as_ptr().cast::<[f32; 2]>(), array.len()) })
}

/// POLYLINE.
#[unsafe(no_mangle)]
extern "C" fn gpolyline(count: Gint, array: Address<Gpoint>) -> Gint {
    call(Function::Polyline, |gks| gks.polyline(points(count, array)))
}

/// POLYMARKER.
#[unsafe(no_mangle)]
extern "C" fn gpolymarker(count: Gint, array: Address<Gpoint>) -> Gint {
    call(Function::Polymarker, |gks| gks.polymarker(points(count, array)))
}

/// TEXT.
#[unsafe(no_mangle)]
extern "C" fn gtext(at: Address<Gpoint>, text: Address<Gchar>) -> Gint {
    const F: Function = Function::Text;
    call(F, |gks| gks.text(at.get(F)?, &text.text()))
}

/// FILL AREA.
#[unsafe(no_mangle)]
extern "C" fn gfillarea(count: Gint, array: Address<Gpoint>) -> Gint {
    call(Function::FillArea, |gks| gks.fill_area(points(count, array)))
}

/// CELL ARRAY: `row` is the distance from one row of the array to the next; the first row is at the top, which is
/// where the second corner of the rectangle is.
#[unsafe(no_mangle)]
extern "C" fn gcellarray(
    rect: Address<Grect>,
    size: Address<Gipoint>,
    row: Gint,
    colours: Address<Gint>,
) -> Gint {
    const F: Function = Function::CellArray;
    call(F, |gks| {
        let (Grect { ll, ur }, size) = (rect.get(F)?, size.get(F)?);
        let [columns, rows, stride] = [size.x, size.y, row].map(|n| usize::try_from(n).unwrap_or(0));
        let count = (rows.saturating_sub(1)).saturating_mul(stride).saturating_add(columns);
        let cells = colours.array(Gint::try_from(count).unwrap_or(0));
        let (p, q) = (Gpoint { x: ll.x, y: ur.y }, Gpoint { x: ur.x, y: ll.y });
        gks.cell_array_of(p, q, cells, columns, rows, stride)
    })
}

/// GENERALIZED DRAWING PRIMITIVE. No primitive reads the data record.
#[unsafe(no_mangle)]
extern "C" fn ggdp(count: Gint, array: Address<Gpoint>, gdp: Gint, _record: *const c_void) -> Gint {
    call(Function::GeneralizedDrawingPrimitive, |gks| {
        gks.generalized_drawing_primitive(points(count, array), gdp, &DataRecord::default())
    })
}
