//! Output functions.

use crate::argument::{In, array, call};
use crate::types::{Gint, Gpat_rep, Gpoint, Gpoint_list, Grect};
use gks::{DataRecord, Function, Points};
use std::ffi::{c_char, c_void};

impl Gpoint_list {
    /// The points.
    fn points(&self) -> Points<'_> {
        // A structure of two numbers is laid out as an array of two.
        Points::Singles(array(self.points.cast::<[f32; 2]>(), self.num_points))
    }
}

impl Gpat_rep {
    /// The colour indices, row by row, with the numbers of columns and of rows: no indices if there cannot be
    /// as many as the numbers say.
    pub(crate) fn cells(&self) -> (&[Gint], usize, usize) {
        let [columns, rows] = [self.dims.size_x, self.dims.size_y].map(|n| usize::try_from(n).unwrap_or(0));
        let count = self.dims.size_x.checked_mul(self.dims.size_y).unwrap_or(0);
        (array(self.colr_array, count), columns, rows)
    }
}

/// The points of a list; none at a null pointer.
fn list(point_list: In<Gpoint_list>) -> Gpoint_list {
    point_list.get().unwrap_or(Gpoint_list { num_points: 0, points: std::ptr::null_mut() })
}

/// POLYLINE.
#[unsafe(no_mangle)]
extern "C" fn gpolyline(point_list: In<Gpoint_list>) {
    call(Function::Polyline, |gks| gks.polyline(list(point_list).points()));
}

/// POLYMARKER.
#[unsafe(no_mangle)]
extern "C" fn gpolymarker(point_list: In<Gpoint_list>) {
    call(Function::Polymarker, |gks| gks.polymarker(list(point_list).points()));
}

/// TEXT.
#[unsafe(no_mangle)]
extern "C" fn gtext(text_pos: In<Gpoint>, char_string: In<c_char>) {
    const F: Function = Function::Text;
    call(F, |gks| gks.text(text_pos.needed(F)?, &char_string.text()));
}

/// FILL AREA.
#[unsafe(no_mangle)]
extern "C" fn gfill_area(point_list: In<Gpoint_list>) {
    call(Function::FillArea, |gks| gks.fill_area(list(point_list).points()));
}

/// CELL ARRAY.
#[unsafe(no_mangle)]
extern "C" fn gcell_array(rect: In<Grect>, colr_array: In<Gpat_rep>) {
    const F: Function = Function::CellArray;
    call(F, |gks| {
        let (rect, cells) = (rect.needed(F)?, colr_array.needed(F)?);
        let (indices, columns, rows) = cells.cells();
        gks.cell_array_of(rect.p, rect.q, indices, columns, rows, columns)
    });
}

/// GENERALIZED DRAWING PRIMITIVE. No primitive reads the data record.
#[unsafe(no_mangle)]
extern "C" fn ggdp(point_list: In<Gpoint_list>, gdp_id: Gint, _gdp_data: In<c_void>) {
    call(Function::GeneralizedDrawingPrimitive, |gks| {
        gks.generalized_drawing_primitive(list(point_list).points(), gdp_id, &DataRecord::default())
    });
}
