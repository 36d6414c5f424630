//! Output attributes and colours.

use crate::argument::{Address, call, choice};
use crate::extension::{self, SOLID_WITH_BORDER};
use gks::Function;
use gks_pipeline::look::{AspectSourceFlags, Horizontal, InteriorStyle, Precision, TextPath, Vertical};
use std::ffi::c_int;

/// Functions that set one attribute to a number.
macro_rules! setters {
    ($($name:ident($type:ty) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name(value: $type) {
            call(Function::$function, |gks| gks.$method(value));
        }
    )+ };
}

setters! {
    gks_set_pline_index(c_int) SetPolylineIndex => set_polyline_index;
    gks_set_pline_linetype(c_int) SetLinetype => set_linetype;
    gks_set_pline_linewidth(f64) SetLinewidthScaleFactor => set_linewidth_scale_factor;
    gks_set_pline_color_index(c_int) SetPolylineColourIndex => set_polyline_colour_index;
    gks_set_pmark_index(c_int) SetPolymarkerIndex => set_polymarker_index;
    gks_set_pmark_type(c_int) SetMarkerType => set_marker_type;
    gks_set_pmark_size(f64) SetMarkerSizeScaleFactor => set_marker_size_scale_factor;
    gks_set_pmark_color_index(c_int) SetPolymarkerColourIndex => set_polymarker_colour_index;
    gks_set_text_index(c_int) SetTextIndex => set_text_index;
    gks_set_text_expfac(f64) SetCharacterExpansionFactor => set_character_expansion_factor;
    gks_set_text_spacing(f64) SetCharacterSpacing => set_character_spacing;
    gks_set_text_color_index(c_int) SetTextColourIndex => set_text_colour_index;
    gks_set_text_height(f64) SetCharacterHeight => set_character_height;
    gks_set_fill_index(c_int) SetFillAreaIndex => set_fill_area_index;
    gks_set_fill_style_index(c_int) SetFillAreaStyleIndex => set_fill_area_style_index;
    gks_set_fill_color_index(c_int) SetFillAreaColourIndex => set_fill_area_colour_index;
}

/// SET TEXT FONT AND PRECISION. The precision that GR has for its outline fonts (3) is STROKE.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_text_fontprec(font: c_int, precision: c_int) {
    const F: Function = Function::SetTextFontAndPrecision;
    call(F, |gks| {
        let precision = choice(Precision::from_number(precision.min(Precision::Stroke as c_int)), F)?;
        gks.set_text_font_and_precision(font, precision)
    });
}

/// SET CHARACTER UP VECTOR.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_text_upvec(x: f64, y: f64) {
    call(Function::SetCharacterUpVector, |gks| gks.set_character_up_vector((x, y)));
}

/// SET TEXT PATH.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_text_path(path: c_int) {
    const F: Function = Function::SetTextPath;
    call(F, |gks| gks.set_text_path(choice(TextPath::from_number(path), F)?));
}

/// SET TEXT ALIGNMENT.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_text_align(horizontal: c_int, vertical: c_int) {
    const F: Function = Function::SetTextAlignment;
    call(F, |gks| {
        let horizontal = choice(Horizontal::from_number(horizontal), F)?;
        gks.set_text_alignment(horizontal, choice(Vertical::from_number(vertical), F)?)
    });
}

/// SET FILL AREA INTERIOR STYLE. GR has a style more: solid with a border.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_fill_int_style(style: c_int) {
    const F: Function = Function::SetFillAreaInteriorStyle;
    call(F, |gks| {
        let bordered = style == SOLID_WITH_BORDER;
        let number = if bordered { InteriorStyle::Solid as c_int } else { style };
        gks.set_fill_area_interior_style(choice(InteriorStyle::from_number(number), F)?)?;
        extension::with(|state| state.bordered = bordered);
        Ok(())
    });
}

/// SET ASPECT SOURCE FLAGS.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_asf(flags: Address<c_int>) {
    const F: Function = Function::SetAspectSourceFlags;
    call(F, |gks| {
        let flags: Option<[c_int; 13]> = flags.array(13).try_into().ok();
        let flags = choice(flags, F)?.map(|flag| flag != 0);
        gks.set_aspect_source_flags(AspectSourceFlags::from_array(flags))
    });
}

/// SET COLOUR REPRESENTATION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_color_rep(ws_id: c_int, index: c_int, red: f64, green: f64, blue: f64) {
    call(Function::SetColourRepresentation, |gks| {
        gks.set_colour_representation(ws_id, index, (red, green, blue))
    });
}
