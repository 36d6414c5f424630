//! Output primitives, with the opacity and the border that GR has.

use crate::argument::{Address, call};
use crate::extension;
use crate::slant::slanted;
use gks::{Function, Gks, Points};
use gks_pipeline::colour::Colour;
use std::ffi::{c_char, c_int};

fn points<'a>(count: c_int, x: Address<f64>, y: Address<f64>) -> Points<'a> {
    Points::Split(x.array(count), y.array(count))
}

/// Draws with the current opacity: the colour index has it while the primitive is drawn, unless it holds a colour of its
/// own with an opacity.
pub(crate) fn translucent(
    gks: &mut Gks,
    index: Option<c_int>,
    draw: impl FnOnce(&mut Gks) -> gks::Result<()>,
) -> gks::Result<()> {
    let opacity = extension::with(|state| state.opacity);
    let in_table = |&index: &c_int| Colour::of_packed_index(index as u32).is_none();
    let Some(index) = index.filter(in_table) else { return draw(gks) };
    if opacity >= 1.0 {
        return draw(gks);
    }
    let active: Vec<c_int> = gks.inquire_set_of_active_workstations()?.collect();
    for &id in &active {
        gks.set_colour_alpha(id, index, opacity)?;
    }
    let drawn = draw(gks);
    for &id in &active {
        gks.set_colour_alpha(id, index, 1.0)?;
    }
    drawn
}

/// POLYLINE.
#[unsafe(no_mangle)]
extern "C" fn gks_polyline(count: c_int, x: Address<f64>, y: Address<f64>) {
    polyline(points(count, x, y));
}

/// POLYLINE, through points as they come.
pub(crate) fn polyline(points: Points<'_>) {
    call(Function::Polyline, |gks| {
        let index = gks.inquire_polyline_colour_index();
        translucent(gks, index.ok(), |gks| gks.polyline(points))
    });
}

/// POLYMARKER.
#[unsafe(no_mangle)]
extern "C" fn gks_polymarker(count: c_int, x: Address<f64>, y: Address<f64>) {
    polymarker(points(count, x, y));
}

/// POLYMARKER, at points as they come.
pub(crate) fn polymarker(points: Points<'_>) {
    call(Function::Polymarker, |gks| {
        let index = gks.inquire_polymarker_colour_index();
        translucent(gks, index.ok(), |gks| gks.polymarker(points))
    });
}

/// TEXT.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_text(x: f64, y: f64, text: Address<c_char>) {
    call(Function::Text, |gks| {
        let index = gks.inquire_text_colour_index();
        let draw = |gks: &mut Gks| slanted(gks, |gks| gks.text((x, y), &text.text()));
        translucent(gks, index.ok(), draw)
    });
}

/// FILL AREA, with the border that belongs to GR's interior style.
#[unsafe(no_mangle)]
extern "C" fn gks_fillarea(count: c_int, x: Address<f64>, y: Address<f64>) {
    fill_area(points(count, x, y));
}

/// FILL AREA, around points as they come.
pub(crate) fn fill_area(points: Points<'_>) {
    call(Function::FillArea, |gks| {
        let index = gks.inquire_fill_area_colour_index();
        translucent(gks, index.ok(), |gks| gks.fill_area(points))?;
        if extension::with(|state| state.bordered) {
            let mut outline = Vec::with_capacity(points.len() + 1);
            points.for_each(|p| outline.push((p.x, p.y)));
            outline.extend(outline.first().copied());
            border(gks, &outline)
        } else {
            Ok(())
        }
    });
}

/// Draws a line in the colour and the width of borders.
pub(crate) fn border(gks: &mut Gks, line: &[(f64, f64)]) -> gks::Result<()> {
    let (colour, width) = extension::with(|state| (state.border_colour, state.border_width));
    let old = (
        gks.inquire_polyline_colour_index()?,
        gks.inquire_linewidth_scale_factor()?,
        gks.inquire_linetype()?,
    );
    gks.set_polyline_colour_index(colour)?;
    gks.set_linewidth_scale_factor(width)?;
    gks.set_linetype(1)?;
    let drawn = translucent(gks, Some(colour), |gks| gks.polyline(Points::Tuples(line)));
    gks.set_polyline_colour_index(old.0)?;
    gks.set_linewidth_scale_factor(old.1)?;
    gks.set_linetype(old.2)?;
    drawn
}

/// CELL ARRAY: a part of an array, which starts at (column, row), counted from 1.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_cellarray(
    px: f64,
    py: f64,
    qx: f64,
    qy: f64,
    dim_x: c_int,
    dim_y: c_int,
    column: c_int,
    row: c_int,
    columns: c_int,
    rows: c_int,
    colours: Address<c_int>,
) {
    call(Function::CellArray, |gks| {
        let [dim_x, dim_y, column, row, columns, rows] =
            [dim_x, dim_y, column, row, columns, rows].map(|n| usize::try_from(n).unwrap_or(0));
        let all = colours.slice(dim_x.saturating_mul(dim_y));
        let first = row.saturating_sub(1).saturating_mul(dim_x).saturating_add(column.saturating_sub(1));
        let is_inside = column >= 1 && row >= 1 && column - 1 + columns <= dim_x && row - 1 + rows <= dim_y;
        let cells = all.get(first..).filter(|_| is_inside).unwrap_or(&[]);
        gks.cell_array_of((px, py), (qx, qy), cells, columns, rows, dim_x)
    });
}
