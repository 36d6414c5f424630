//! Output attributes, of all workstations and of one.

use crate::argument::{In, call, choice, flag};
use crate::types::{
    Gasfs, Gdouble, Gfill_bundle, Gint, Gline_bundle, Gmarker_bundle, Gpat_rep, Gpoint, Grgb, Gtext_align,
    Gtext_bundle, Gtext_font_prec, Gvec,
};
use gks::Function;
use gks_pipeline::look::{AspectSourceFlags, Horizontal, InteriorStyle, Precision, TextPath, Vertical};

/// Functions that set one attribute to a number.
macro_rules! setters {
    ($($name:ident($type:ty) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(value: $type) {
            call(Function::$function, |gks| gks.$method(value));
        }
    )+ };
}

setters! {
    gset_line_ind(Gint) SetPolylineIndex => set_polyline_index;
    gset_linetype(Gint) SetLinetype => set_linetype;
    gset_linewidth(Gdouble) SetLinewidthScaleFactor => set_linewidth_scale_factor;
    gset_line_colr_ind(Gint) SetPolylineColourIndex => set_polyline_colour_index;
    gset_marker_ind(Gint) SetPolymarkerIndex => set_polymarker_index;
    gset_marker_type(Gint) SetMarkerType => set_marker_type;
    gset_marker_size(Gdouble) SetMarkerSizeScaleFactor => set_marker_size_scale_factor;
    gset_marker_colr_ind(Gint) SetPolymarkerColourIndex => set_polymarker_colour_index;
    gset_text_ind(Gint) SetTextIndex => set_text_index;
    gset_char_expan(Gdouble) SetCharacterExpansionFactor => set_character_expansion_factor;
    gset_char_space(Gdouble) SetCharacterSpacing => set_character_spacing;
    gset_text_colr_ind(Gint) SetTextColourIndex => set_text_colour_index;
    gset_char_ht(Gdouble) SetCharacterHeight => set_character_height;
    gset_fill_ind(Gint) SetFillAreaIndex => set_fill_area_index;
    gset_fill_style_ind(Gint) SetFillAreaStyleIndex => set_fill_area_style_index;
    gset_fill_colr_ind(Gint) SetFillAreaColourIndex => set_fill_area_colour_index;
}

/// SET TEXT FONT AND PRECISION.
#[unsafe(no_mangle)]
extern "C" fn gset_text_font_prec(text_font_prec: In<Gtext_font_prec>) {
    const F: Function = Function::SetTextFontAndPrecision;
    call(F, |gks| {
        let value = text_font_prec.needed(F)?;
        gks.set_text_font_and_precision(value.font, choice(F, value.prec, Precision::from_number)?)
    });
}

/// SET CHARACTER UP VECTOR.
#[unsafe(no_mangle)]
extern "C" fn gset_char_up_vec(char_up_vec: In<Gvec>) {
    const F: Function = Function::SetCharacterUpVector;
    call(F, |gks| gks.set_character_up_vector(char_up_vec.needed(F)?));
}

/// SET TEXT PATH.
#[unsafe(no_mangle)]
extern "C" fn gset_text_path(text_path: Gint) {
    const F: Function = Function::SetTextPath;
    call(F, |gks| gks.set_text_path(choice(F, text_path, TextPath::from_number)?));
}

/// SET TEXT ALIGNMENT.
#[unsafe(no_mangle)]
extern "C" fn gset_text_align(text_align: In<Gtext_align>) {
    const F: Function = Function::SetTextAlignment;
    call(F, |gks| {
        let value = text_align.needed(F)?;
        let horizontal = choice(F, value.hor, Horizontal::from_number)?;
        gks.set_text_alignment(horizontal, choice(F, value.vert, Vertical::from_number)?)
    });
}

/// SET FILL AREA INTERIOR STYLE.
#[unsafe(no_mangle)]
extern "C" fn gset_fill_int_style(fill_int_style: Gint) {
    const F: Function = Function::SetFillAreaInteriorStyle;
    let style = gks_instance::interior_style(fill_int_style);
    call(F, |gks| gks.set_fill_area_interior_style(choice(F, style, InteriorStyle::from_number)?));
}

/// SET PATTERN SIZE.
#[unsafe(no_mangle)]
extern "C" fn gset_pat_size(x_size: Gdouble, y_size: Gdouble) {
    call(Function::SetPatternSize, |gks| gks.set_pattern_size(x_size, y_size));
}

/// SET PATTERN REFERENCE POINT.
#[unsafe(no_mangle)]
extern "C" fn gset_pat_ref_point(pat_ref_point: In<Gpoint>) {
    const F: Function = Function::SetPatternReferencePoint;
    call(F, |gks| gks.set_pattern_reference_point(pat_ref_point.needed(F)?));
}

/// SET ASPECT SOURCE FLAGS.
#[unsafe(no_mangle)]
extern "C" fn gset_asfs(list_asf: In<Gasfs>) {
    const F: Function = Function::SetAspectSourceFlags;
    call(F, |gks| {
        let mut flags = [false; 13];
        for (value, number) in flags.iter_mut().zip(list_asf.needed(F)?) {
            *value = flag(F, number)?;
        }
        gks.set_aspect_source_flags(AspectSourceFlags::from_array(flags))
    });
}

/// SET POLYLINE REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gset_line_rep(ws_id: Gint, line_ind: Gint, line_rep: In<Gline_bundle>) {
    const F: Function = Function::SetPolylineRepresentation;
    call(F, |gks| {
        let rep = line_rep.needed(F)?;
        gks.set_polyline_representation(ws_id, line_ind, rep.r#type, rep.width, rep.colr_ind)
    });
}

/// SET POLYMARKER REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gset_marker_rep(ws_id: Gint, marker_ind: Gint, marker_rep: In<Gmarker_bundle>) {
    const F: Function = Function::SetPolymarkerRepresentation;
    call(F, |gks| {
        let rep = marker_rep.needed(F)?;
        gks.set_polymarker_representation(ws_id, marker_ind, rep.r#type, rep.size, rep.colr_ind)
    });
}

/// SET TEXT REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gset_text_rep(ws_id: Gint, text_ind: Gint, text_rep: In<Gtext_bundle>) {
    const F: Function = Function::SetTextRepresentation;
    call(F, |gks| {
        let rep = text_rep.needed(F)?;
        let precision = choice(F, rep.text_font_prec.prec, Precision::from_number)?;
        gks.set_text_representation(
            ws_id,
            text_ind,
            rep.text_font_prec.font,
            precision,
            rep.char_expan,
            rep.char_space,
            rep.colr_ind,
        )
    });
}

/// SET FILL AREA REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gset_fill_rep(ws_id: Gint, fill_ind: Gint, fill_rep: In<Gfill_bundle>) {
    const F: Function = Function::SetFillAreaRepresentation;
    call(F, |gks| {
        let rep = fill_rep.needed(F)?;
        let style = choice(F, rep.int_style, InteriorStyle::from_number)?;
        gks.set_fill_area_representation(ws_id, fill_ind, style, rep.style_ind, rep.colr_ind)
    });
}

/// SET PATTERN REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gset_pat_rep(ws_id: Gint, pat_ind: Gint, pat_rep: In<Gpat_rep>) {
    const F: Function = Function::SetPatternRepresentation;
    call(F, |gks| {
        let rep = pat_rep.needed(F)?;
        let (indices, columns, rows) = rep.cells();
        gks.set_pattern_representation_of(ws_id, pat_ind, indices, columns, rows, columns)
    });
}

/// SET COLOUR REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gset_colr_rep(ws_id: Gint, colr_ind: Gint, colr_rep: In<Grgb>) {
    const F: Function = Function::SetColourRepresentation;
    call(F, |gks| {
        let rgb = colr_rep.needed(F)?;
        gks.set_colour_representation(ws_id, colr_ind, (rgb.red.into(), rgb.green.into(), rgb.blue.into()))
    });
}
