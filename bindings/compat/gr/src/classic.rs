//! The C names of the draft of 1988, which GR has with numbers in double precision: the functions `gks_*` by other names,
//! with structures, and with the number of the error as their value. Inquiries give it in their last argument.

use crate::argument::{Address, call, choice, outcome};
use crate::slant::slanted;
use crate::{absent, attribute, control, inquiry, output, transformation};
use gks::{Function, Points};
use gks_instance::ErrorFile;
use std::ffi::{c_char, c_int, c_long, c_uint, c_void};

macro_rules! structures {
    ($($name:ident { $($member:ident: $type:ty),+ $(,)? })+) => { $(
        #[doc = concat!("`", stringify!($name), "` of the header.")]
        #[repr(C)]
        #[derive(Copy, Clone, Debug)]
        pub(crate) struct $name { $(pub(crate) $member: $type),+ }
    )+ };
}

structures! {
    Gpoint { x: f64, y: f64 }
    Gipoint { x: c_int, y: c_int }
    Glimit { xmin: f64, xmax: f64, ymin: f64, ymax: f64 }
    Grect { ul: Gpoint, lr: Gpoint }
    Gidim { x_dim: c_uint, y_dim: c_uint }
    Gcobundl { red: f64, green: f64, blue: f64 }
    Gtxfp { font: c_int, prec: c_int }
    Gtxalign { hor: c_int, ver: c_int }
    Gcliprect { ind: c_int, rec: Glimit }
    Gdspsize { units: c_int, device: Gpoint, raster: Gipoint }
    Gextent { concat: Gpoint, corners: [Gpoint; 4] }
    Gscale { x_scale: f64, y_scale: f64 }
    Gtran { w: Glimit, v: Glimit }
}

/// A matrix of a segment transformation: two rows.
type Gmatrix = [[f64; 3]; 2];

fn points<'a>(count: c_int, points: Address<Gpoint>) -> Points<'a> {
    let array = points.array(count);
    // SAFETY: a structure of two numbers is laid out as an array of two.
    Points::Arrays(unsafe { std::slice::from_raw_parts(array.as_ptr().cast::<[f64; 2]>(), array.len()) })
}

/// Functions of numbers that another function does.
macro_rules! same {
    ($($name:ident($($argument:ident: $type:ty),*) => $module:ident::$function:ident;)+) => { $(
        #[doc = concat!("The same as `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name($($argument: $type),*) -> c_int {
            outcome(|| $module::$function($($argument),*))
        }
    )+ };
}

same! {
    gclosegks() => control::gks_close_gks;
    gemergencyclosegks() => control::gks_emergency_close;
    gclosews(ws_id: c_int) => control::gks_close_ws;
    gactivatews(ws_id: c_int) => control::gks_activate_ws;
    gdeactivatews(ws_id: c_int) => control::gks_deactivate_ws;
    gconfigurews(ws_id: c_int) => absent::gks_configure_ws;
    gclearws(ws_id: c_int, flag: c_int) => control::gks_clear_ws;
    gmessage(ws_id: c_int, text: Address<c_char>) => control::gks_message;
    gcreateseg(name: c_int) => control::gks_create_seg;
    gcopysegws(ws_id: c_int, name: c_int) => control::gks_copy_seg_to_ws;
    gredrawsegws(ws_id: c_int) => control::gks_redraw_seg_on_ws;
    gcloseseg() => control::gks_close_seg;
    gselntran(number: c_int) => transformation::gks_select_xform;
    gsetlineind(index: c_int) => attribute::gks_set_pline_index;
    gsetlinetype(kind: c_int) => attribute::gks_set_pline_linetype;
    gsetlinewidth(width: f64) => attribute::gks_set_pline_linewidth;
    gsetlinecolourind(index: c_int) => attribute::gks_set_pline_color_index;
    gsetmarkerind(index: c_int) => attribute::gks_set_pmark_index;
    gsetmarkertype(kind: c_int) => attribute::gks_set_pmark_type;
    gsetmarkersize(size: f64) => attribute::gks_set_pmark_size;
    gsetmarkercolourind(index: c_int) => attribute::gks_set_pmark_color_index;
    gsettextind(index: c_int) => attribute::gks_set_text_index;
    gsetcharexpan(factor: f64) => attribute::gks_set_text_expfac;
    gsetcharspace(spacing: f64) => attribute::gks_set_text_spacing;
    gsettextcolourind(index: c_int) => attribute::gks_set_text_color_index;
    gsetcharheight(height: f64) => attribute::gks_set_text_height;
    gsettextpath(path: c_int) => attribute::gks_set_text_path;
    gsetfillind(index: c_int) => attribute::gks_set_fill_index;
    gsetfillintstyle(style: c_int) => attribute::gks_set_fill_int_style;
    gsetfillstyle(index: c_int) => attribute::gks_set_fill_style_index;
    gsetfillcolourind(index: c_int) => attribute::gks_set_fill_color_index;
    gsetasf(flags: Address<c_int>) => attribute::gks_set_asf;
}

/// OPEN GKS, with the standard error output for errors. The memory needs no limit.
#[unsafe(no_mangle)]
extern "C" fn gopengks(_error_file: *const c_void, _memory: c_long) -> c_int {
    outcome(|| {
        crate::argument::call_instance(Function::OpenGks, |instance| instance.open_gks(ErrorFile::Stderr));
    })
}

/// OPEN WORKSTATION. The type is pointed to; a null pointer means the usual one.
#[unsafe(no_mangle)]
extern "C" fn gopenws(ws_id: c_int, connection: Address<c_char>, kind: Address<c_int>) -> c_int {
    let kind = kind.slice(1).first().copied().unwrap_or(0);
    outcome(|| control::gks_open_ws(ws_id, connection, kind))
}

/// UPDATE WORKSTATION: 0 perform, 1 postpone.
#[unsafe(no_mangle)]
extern "C" fn gupdatews(ws_id: c_int, regeneration: c_int) -> c_int {
    outcome(|| control::gks_update_ws(ws_id, (regeneration == 0).into()))
}

/// POLYLINE.
#[unsafe(no_mangle)]
extern "C" fn gpolyline(count: c_int, array: Address<Gpoint>) -> c_int {
    outcome(|| output::polyline(points(count, array)))
}

/// POLYMARKER.
#[unsafe(no_mangle)]
extern "C" fn gpolymarker(count: c_int, array: Address<Gpoint>) -> c_int {
    outcome(|| output::polymarker(points(count, array)))
}

/// FILL AREA.
#[unsafe(no_mangle)]
extern "C" fn gfillarea(count: c_int, array: Address<Gpoint>) -> c_int {
    outcome(|| output::fill_area(points(count, array)))
}

/// Runs a function with the value at an address. Error: 2000 (null pointer).
fn with<T: Copy>(function: Function, address: Address<T>, f: impl FnOnce(T)) -> c_int {
    outcome(|| {
        let mut value = None;
        call(function, |_| {
            value = Some(address.get(function)?);
            Ok(())
        });
        if let Some(value) = value {
            f(value);
        }
    })
}

/// TEXT.
#[unsafe(no_mangle)]
extern "C" fn gtext(at: Address<Gpoint>, text: Address<c_char>) -> c_int {
    with(Function::Text, at, |at| output::gks_text(at.x, at.y, text))
}

/// CELL ARRAY: from the upper left to the lower right corner, the first row at the top.
#[unsafe(no_mangle)]
extern "C" fn gcellarray(rect: Address<Grect>, size: Address<Gidim>, colours: Address<c_int>) -> c_int {
    with(Function::CellArray, rect, |Grect { ul, lr }| {
        let size = size.slice(1).first().copied().unwrap_or(Gidim { x_dim: 0, y_dim: 0 });
        let [columns, rows] = [size.x_dim, size.y_dim].map(|n| c_int::try_from(n).unwrap_or(c_int::MAX));
        output::gks_cellarray(ul.x, ul.y, lr.x, lr.y, columns, rows, 1, 1, columns, rows, colours);
    })
}

/// SET TEXT FONT AND PRECISION.
#[unsafe(no_mangle)]
extern "C" fn gsettextfontprec(value: Address<Gtxfp>) -> c_int {
    with(Function::SetTextFontAndPrecision, value, |v| attribute::gks_set_text_fontprec(v.font, v.prec))
}

/// SET CHARACTER UP VECTOR.
#[unsafe(no_mangle)]
extern "C" fn gsetcharup(up: Address<Gpoint>) -> c_int {
    with(Function::SetCharacterUpVector, up, |up| attribute::gks_set_text_upvec(up.x, up.y))
}

/// SET TEXT ALIGNMENT.
#[unsafe(no_mangle)]
extern "C" fn gsettextalign(value: Address<Gtxalign>) -> c_int {
    with(Function::SetTextAlignment, value, |v| attribute::gks_set_text_align(v.hor, v.ver))
}

/// SET COLOUR REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gsetcolourrep(ws_id: c_int, index: c_int, rep: Address<Gcobundl>) -> c_int {
    with(Function::SetColourRepresentation, rep, |c| {
        attribute::gks_set_color_rep(ws_id, index, c.red, c.green, c.blue);
    })
}

/// Functions of a number and limits.
macro_rules! limits {
    ($($name:ident $function:ident => $other:ident;)+) => { $(
        #[doc = concat!("The same as `", stringify!($other), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(number: c_int, limits: Address<Glimit>) -> c_int {
            with(Function::$function, limits, |l| {
                transformation::$other(number, l.xmin, l.xmax, l.ymin, l.ymax);
            })
        }
    )+ };
}

limits! {
    gsetwindow SetWindow => gks_set_window;
    gsetviewport SetViewport => gks_set_viewport;
    gsetwswindow SetWorkstationWindow => gks_set_ws_window;
    gsetwsviewport SetWorkstationViewport => gks_set_ws_viewport;
}

/// SET CLIPPING INDICATOR: 0 clip, 1 do not, as the header names them. GR itself takes them the other way round.
#[unsafe(no_mangle)]
extern "C" fn gsetclip(indicator: c_int) -> c_int {
    outcome(|| transformation::gks_set_clipping((indicator == 0).into()))
}

/// EVALUATE TRANSFORMATION MATRIX.
#[unsafe(no_mangle)]
extern "C" fn gevaltran(
    point: Address<Gpoint>,
    shift: Address<Gpoint>,
    angle: f64,
    scale: Address<Gscale>,
    coordinates: c_int,
    result: Address<Gmatrix>,
) -> c_int {
    const F: Function = Function::EvaluateTransformationMatrix;
    outcome(|| {
        call(F, |gks| {
            let (p, s, scale) = (point.get(F)?, shift.get(F)?, scale.get(F)?);
            let switch = choice(transformation::switch(coordinates), F)?;
            let scale = (scale.x_scale, scale.y_scale);
            result.set(gks.evaluate_transformation_matrix((p.x, p.y), (s.x, s.y), angle, scale, switch)?);
            Ok(())
        });
    })
}

/// SET SEGMENT TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn gsetsegtran(name: c_int, matrix: Address<Gmatrix>) -> c_int {
    const F: Function = Function::SetSegmentTransformation;
    outcome(|| call(F, |gks| gks.set_segment_transformation(name, matrix.get(F)?)))
}

/// INQUIRE OPERATING STATE VALUE.
#[unsafe(no_mangle)]
extern "C" fn ginqopst(state: Address<c_int>) -> c_int {
    inquiry::gks_inq_operating_state(state);
    0
}

/// Inquiries of one value.
macro_rules! inquiries {
    ($($name:ident($type:ty) => $other:ident;)+) => { $(
        #[doc = concat!("The same as `", stringify!($other), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(value: Address<$type>, error: Address<c_int>) -> c_int {
            inquiry::$other(error, value);
            0
        }
    )+ };
}

inquiries! {
    ginqlevelgks(c_int) => gks_inq_level;
    ginqmaxntrannum(c_int) => gks_inq_max_xform;
    ginqcharheight(f64) => gks_inq_text_height;
    ginqtextpath(c_int) => gks_inq_text_path;
    ginqlinetype(c_int) => gks_inq_pline_linetype;
    ginqlinewidth(f64) => gks_inq_pline_linewidth;
    ginqlinecolourind(c_int) => gks_inq_pline_color_index;
    ginqmarkertype(c_int) => gks_inq_pmark_type;
    ginqmarkersize(f64) => gks_inq_pmark_size;
    ginqmarkercolourind(c_int) => gks_inq_pmark_color_index;
    ginqcharexpan(f64) => gks_inq_text_expfac;
    ginqcharspace(f64) => gks_inq_text_spacing;
    ginqtextcolourind(c_int) => gks_inq_text_color_index;
    ginqfillintstyle(c_int) => gks_inq_fill_int_style;
    ginqfillstyle(c_int) => gks_inq_fill_style_index;
    ginqfillcolourind(c_int) => gks_inq_fill_color_index;
    ginqcurntrannum(c_int) => gks_inq_current_xformno;
}

/// INQUIRE NAME OF OPEN SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn ginqnameopenseg(name: Address<c_int>, error: Address<c_int>) -> c_int {
    control::gks_inq_open_segn(error, name);
    0
}

/// INQUIRE CHARACTER UP VECTOR.
#[unsafe(no_mangle)]
extern "C" fn ginqcharup(up: Address<Gpoint>, error: Address<c_int>) -> c_int {
    let (mut x, mut y) = (0.0, 0.0);
    inquiry::gks_inq_text_upvec(error, Address::of(&mut x), Address::of(&mut y));
    up.set(Gpoint { x, y });
    0
}

/// INQUIRE TEXT ALIGNMENT.
#[unsafe(no_mangle)]
extern "C" fn ginqtextalign(value: Address<Gtxalign>, error: Address<c_int>) -> c_int {
    let (mut hor, mut ver) = (0, 0);
    inquiry::gks_inq_text_align(error, Address::of(&mut hor), Address::of(&mut ver));
    value.set(Gtxalign { hor, ver });
    0
}

/// INQUIRE TEXT FONT AND PRECISION.
#[unsafe(no_mangle)]
extern "C" fn ginqtextfontprec(value: Address<Gtxfp>, error: Address<c_int>) -> c_int {
    let (mut font, mut prec) = (0, 0);
    inquiry::gks_inq_text_fontprec(error, Address::of(&mut font), Address::of(&mut prec));
    value.set(Gtxfp { font, prec });
    0
}

fn limits([xmin, xmax, ymin, ymax]: [f64; 4]) -> Glimit {
    Glimit { xmin, xmax, ymin, ymax }
}

/// INQUIRE NORMALIZATION TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn ginqntran(number: c_int, value: Address<Gtran>, error: Address<c_int>) -> c_int {
    crate::argument::inquire(Function::InquireNormalizationTransformation, error, |gks| {
        let found = gks.inquire_normalization_transformation(number)?;
        value.set(Gtran { w: limits(found.window.limits()), v: limits(found.viewport.limits()) });
        Ok(())
    });
    0
}

/// INQUIRE CLIPPING, with the indicator as in [`gsetclip`].
#[unsafe(no_mangle)]
extern "C" fn ginqclip(value: Address<Gcliprect>, error: Address<c_int>) -> c_int {
    crate::argument::inquire(Function::InquireClipping, error, |gks| {
        let (clip, rectangle) = gks.inquire_clipping()?;
        value.set(Gcliprect { ind: (!clip).into(), rec: limits(rectangle.limits()) });
        Ok(())
    });
    0
}

/// INQUIRE WORKSTATION CATEGORY.
#[unsafe(no_mangle)]
extern "C" fn ginqwscategory(kind: Address<c_int>, category: Address<c_int>, error: Address<c_int>) -> c_int {
    inquiry::gks_inq_ws_category(kind.slice(1).first().copied().unwrap_or(0), error, category);
    0
}

/// INQUIRE DISPLAY SPACE SIZE.
#[unsafe(no_mangle)]
extern "C" fn ginqdisplaysize(kind: Address<c_int>, size: Address<Gdspsize>, error: Address<c_int>) -> c_int {
    let kind = kind.slice(1).first().copied().unwrap_or(0);
    let (mut units, mut width, mut height, mut columns, mut rows) = (0, 0.0, 0.0, 0, 0);
    let [columns_to, rows_to] = [&mut columns, &mut rows].map(Address::of);
    let (width_to, height_to) = (Address::of(&mut width), Address::of(&mut height));
    inquiry::gks_inq_max_ds_size(
        kind,
        error,
        Address::of(&mut units),
        width_to,
        height_to,
        columns_to,
        rows_to,
    );
    let (device, raster) = (Gpoint { x: width, y: height }, Gipoint { x: columns, y: rows });
    size.set(Gdspsize { units, device, raster });
    0
}

/// INQUIRE TEXT EXTENT.
#[unsafe(no_mangle)]
extern "C" fn ginqtextextent(
    ws_id: c_int,
    position: Address<Gpoint>,
    text: Address<c_char>,
    extent: Address<Gextent>,
    error: Address<c_int>,
) -> c_int {
    const F: Function = Function::InquireTextExtent;
    crate::argument::inquire(F, error, |gks| {
        let at = position.get(F)?;
        let room = slanted(gks, |gks| gks.inquire_text_extent(ws_id, (at.x, at.y), &text.text()))?;
        let point = |p: gks_geometry::Point<gks_geometry::Wc>| Gpoint { x: p.x(), y: p.y() };
        extent.set(Gextent { concat: point(room.concatenation), corners: room.corners.map(point) });
        Ok(())
    });
    0
}
