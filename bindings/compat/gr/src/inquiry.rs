//! Inquiries.

use crate::argument::{Address, inquire, integer};
use crate::slant::slanted;
use gks::{Function, Gks};
use std::ffi::{c_char, c_int};

/// The error of a list element that is not there.
const NO_SUCH_ELEMENT: c_int = 2002;
/// Metres, the only unit of device coordinates.
const METRES: c_int = 0;

/// INQUIRE OPERATING STATE VALUE.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_operating_state(state: Address<c_int>) {
    state.set(gks_instance::with(|instance| instance.gks.inquire_operating_state_value()) as c_int);
}

/// Inquiries of one value of the state list.
macro_rules! inquiries {
    ($($name:ident($type:ty) $function:ident => $value:expr;)+) => { $(
        #[doc = concat!("Inquires by `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name(error: Address<c_int>, out: Address<$type>) {
            let value: fn(&Gks) -> gks::Result<$type> = $value;
            inquire(Function::$function, error, |gks| {
                out.set(value(gks)?);
                Ok(())
            });
        }
    )+ };
}

inquiries! {
    gks_inq_level(c_int) InquireLevelOfGks => |gks| gks.inquire_level_of_gks().map(|level| level as c_int);
    gks_inq_max_xform(c_int) InquireMaximumNormalizationTransformationNumber
        => Gks::inquire_maximum_normalization_transformation_number;
    gks_inq_pline_linetype(c_int) InquireLinetype => Gks::inquire_linetype;
    gks_inq_pline_linewidth(f64) InquireLinewidthScaleFactor => Gks::inquire_linewidth_scale_factor;
    gks_inq_pline_color_index(c_int) InquirePolylineColourIndex => Gks::inquire_polyline_colour_index;
    gks_inq_pmark_type(c_int) InquireMarkerType => Gks::inquire_marker_type;
    gks_inq_pmark_size(f64) InquireMarkerSizeScaleFactor => Gks::inquire_marker_size_scale_factor;
    gks_inq_pmark_color_index(c_int) InquirePolymarkerColourIndex => Gks::inquire_polymarker_colour_index;
    gks_inq_text_expfac(f64) InquireCharacterExpansionFactor => Gks::inquire_character_expansion_factor;
    gks_inq_text_spacing(f64) InquireCharacterSpacing => Gks::inquire_character_spacing;
    gks_inq_text_color_index(c_int) InquireTextColourIndex => Gks::inquire_text_colour_index;
    gks_inq_text_height(f64) InquireCharacterHeight => Gks::inquire_character_height;
    gks_inq_text_path(c_int) InquireTextPath => |gks| gks.inquire_text_path().map(|path| path as c_int);
    gks_inq_fill_style_index(c_int) InquireFillAreaStyleIndex => Gks::inquire_fill_area_style_index;
    gks_inq_fill_color_index(c_int) InquireFillAreaColourIndex => Gks::inquire_fill_area_colour_index;
    gks_inq_fill_int_style(c_int) InquireFillAreaInteriorStyle => |gks| {
        let style = gks.inquire_fill_area_interior_style()? as c_int;
        let bordered = crate::extension::with(|state| state.bordered);
        Ok(if bordered { crate::extension::SOLID_WITH_BORDER } else { style })
    };
    gks_inq_current_xformno(c_int) InquireCurrentNormalizationTransformationNumber
        => Gks::inquire_current_normalization_transformation_number;
}

/// INQUIRE TEXT FONT AND PRECISION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_text_fontprec(
    error: Address<c_int>,
    font: Address<c_int>,
    precision: Address<c_int>,
) {
    inquire(Function::InquireTextFontAndPrecision, error, |gks| {
        let (number, kind) = gks.inquire_text_font_and_precision()?;
        font.set(number);
        precision.set(kind as c_int);
        Ok(())
    });
}

/// INQUIRE CHARACTER UP VECTOR.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_text_upvec(error: Address<c_int>, x: Address<f64>, y: Address<f64>) {
    inquire(Function::InquireCharacterUpVector, error, |gks| {
        let up = gks.inquire_character_up_vector()?;
        x.set(up.x());
        y.set(up.y());
        Ok(())
    });
}

/// INQUIRE TEXT ALIGNMENT.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_text_align(
    error: Address<c_int>,
    horizontal: Address<c_int>,
    vertical: Address<c_int>,
) {
    inquire(Function::InquireTextAlignment, error, |gks| {
        let (across, up) = gks.inquire_text_alignment()?;
        horizontal.set(across as c_int);
        vertical.set(up as c_int);
        Ok(())
    });
}

/// Inquiries of an element of a list, counted from 1, and the length of the list; 0 asks for the length alone.
macro_rules! elements {
    ($($name:ident $function:ident => |$gks:ident| $list:expr;)+) => { $(
        #[doc = concat!("Inquires by `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name(n: c_int, error: Address<c_int>, length: Address<c_int>, element: Address<c_int>) {
            const F: Function = Function::$function;
            inquire(F, error, |$gks| {
                let list: Vec<c_int> = $list.collect();
                length.set(integer(list.len()));
                if n == 0 {
                    return Ok(());
                }
                let found = usize::try_from(n - 1).ok().and_then(|at| list.get(at));
                element.set(*found.ok_or_else(|| gks::Error::new(NO_SUCH_ELEMENT, F))?);
                Ok(())
            });
        }
    )+ };
}

elements! {
    gks_inq_open_ws InquireSetOfOpenWorkstations => |gks| gks.inquire_set_of_open_workstations()?;
    gks_inq_active_ws InquireSetOfActiveWorkstations => |gks| gks.inquire_set_of_active_workstations()?;
    gks_inq_wstype InquireListOfAvailableWorkstationTypes
        => |gks| gks.inquire_list_of_available_workstation_types()?.into_iter();
}

/// INQUIRE NORMALIZATION TRANSFORMATION: window and viewport, four limits each.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_xform(
    number: c_int,
    error: Address<c_int>,
    window: Address<f64>,
    viewport: Address<f64>,
) {
    inquire(Function::InquireNormalizationTransformation, error, |gks| {
        let found = gks.inquire_normalization_transformation(number)?;
        window.set_all(found.window.limits());
        viewport.set_all(found.viewport.limits());
        Ok(())
    });
}

/// INQUIRE CLIPPING: the indicator and the rectangle, four limits.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_clip(
    error: Address<c_int>,
    indicator: Address<c_int>,
    rectangle: Address<f64>,
) {
    inquire(Function::InquireClipping, error, |gks| {
        let (clip, found) = gks.inquire_clipping()?;
        indicator.set(clip.into());
        rectangle.set_all(found.limits());
        Ok(())
    });
}

/// INQUIRE WORKSTATION CONNECTION AND TYPE. A connection that is no number is 0.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_ws_conntype(
    ws_id: c_int,
    error: Address<c_int>,
    connection: Address<c_int>,
    kind: Address<c_int>,
) {
    inquire(Function::InquireWorkstationConnectionAndType, error, |gks| {
        let (name, number) = gks.inquire_workstation_connection_and_type(ws_id)?;
        connection.set(name.parse().unwrap_or(0));
        kind.set(number);
        Ok(())
    });
}

/// INQUIRE WORKSTATION CATEGORY, of a workstation type.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_ws_category(kind: c_int, error: Address<c_int>, category: Address<c_int>) {
    inquire(Function::InquireWorkstationCategory, error, |gks| {
        category.set(gks.inquire_workstation_category(kind)? as c_int);
        Ok(())
    });
}

/// INQUIRE COLOUR REPRESENTATION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_color_rep(
    ws_id: c_int,
    index: c_int,
    _kind: c_int,
    error: Address<c_int>,
    red: Address<f64>,
    green: Address<f64>,
    blue: Address<f64>,
) {
    inquire(Function::InquireColourRepresentation, error, |gks| {
        let colour = gks.inquire_colour_representation(ws_id, index, gks::ValueType::Set)?;
        red.set(colour.red.into());
        green.set(colour.green.into());
        blue.set(colour.blue.into());
        Ok(())
    });
}

/// INQUIRE TEXT EXTENT: the concatenation point and the four corners.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_text_extent(
    ws_id: c_int,
    x: f64,
    y: f64,
    text: Address<c_char>,
    error: Address<c_int>,
    next_x: Address<f64>,
    next_y: Address<f64>,
    corners_x: Address<f64>,
    corners_y: Address<f64>,
) {
    inquire(Function::InquireTextExtent, error, |gks| {
        let room = slanted(gks, |gks| gks.inquire_text_extent(ws_id, (x, y), &text.text()))?;
        next_x.set(room.concatenation.x());
        next_y.set(room.concatenation.y());
        corners_x.set_all(room.corners.map(gks_geometry::Point::x));
        corners_y.set_all(room.corners.map(gks_geometry::Point::y));
        Ok(())
    });
}

/// INQUIRE DISPLAY SPACE SIZE, of a workstation type.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_max_ds_size(
    kind: c_int,
    error: Address<c_int>,
    unit: Address<c_int>,
    width: Address<f64>,
    height: Address<f64>,
    columns: Address<c_int>,
    rows: Address<c_int>,
) {
    inquire(Function::InquireDisplaySpaceSize, error, |gks| {
        let size = gks.inquire_display_space_size(kind)?;
        unit.set(METRES);
        width.set(size.metres.0);
        height.set(size.metres.1);
        columns.set(integer(size.raster.0));
        rows.set(integer(size.raster.1));
        Ok(())
    });
}

/// Inquires the size of the display surface of a workstation in pixels, and how many device pixels one of them is.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_inq_vp_size(
    ws_id: c_int,
    error: Address<c_int>,
    width: Address<c_int>,
    height: Address<c_int>,
    ratio: Address<f64>,
) {
    inquire(Function::InquireDisplaySpaceSize, error, |gks| {
        let (_, kind) = gks.inquire_workstation_connection_and_type(ws_id)?;
        let size = gks.inquire_display_space_size(kind)?;
        width.set(integer(size.raster.0));
        height.set(integer(size.raster.1));
        ratio.set(1.0);
        Ok(())
    });
}
