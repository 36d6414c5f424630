//! Inquiries of the operating state, the GKS description table and the GKS state list.

use super::{asfs, length};
use crate::argument::{Out, Part, inquire, integer};
use crate::types::{
    Gasfs, Gclip, Gdouble, Gindiv_attrs, Gint, Gint_list, Gpoint, Gprim_attrs, Gtext_align, Gtext_font_prec,
    Gtran, Gvec, Gws_max_nums,
};
use gks::{Function, Gks};

/// INQUIRE OPERATING STATE VALUE.
#[unsafe(no_mangle)]
extern "C" fn ginq_op_st(op_st: Out<Gint>) {
    op_st.set(gks_instance::with(|instance| instance.gks.inquire_operating_state_value()) as Gint);
}

/// Inquiries of one value of the state list.
macro_rules! inquiries {
    ($($name:ident($type:ty) $function:ident => $value:expr;)+) => { $(
        #[doc = concat!("Inquires by `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(err_ind: Out<Gint>, out: Out<$type>) {
            let value: fn(&Gks) -> gks::Result<$type> = $value;
            inquire(Function::$function, err_ind, |gks| {
                out.set(value(gks)?);
                Ok(())
            });
        }
    )+ };
}

inquiries! {
    ginq_level_gks(Gint) InquireLevelOfGks => |gks| gks.inquire_level_of_gks().map(|level| level as Gint);
    ginq_ws_max_nums(Gws_max_nums) InquireWorkstationMaximumNumbers => |gks| {
        let numbers = gks.inquire_workstation_maximum_numbers()?;
        Ok(Gws_max_nums {
            simult_open: integer(numbers.open),
            simult_active: integer(numbers.active),
            assoc_seg: integer(numbers.of_a_segment),
        })
    };
    ginq_max_norm_tran_num(Gint) InquireMaximumNormalizationTransformationNumber
        => Gks::inquire_maximum_normalization_transformation_number;
    ginq_cur_prim_attrs(Gprim_attrs) InquireCurrentPrimitiveAttributeValues => |gks| {
        let attributes = gks.inquire_current_primitive_attribute_values()?;
        Ok(Gprim_attrs {
            line_ind: attributes.polyline_index,
            marker_ind: attributes.polymarker_index,
            text_ind: attributes.text_index,
            char_ht: attributes.character_height,
            char_up_vec: attributes.character_up.into(),
            char_width: attributes.character_width,
            char_base_vec: attributes.character_base.into(),
            text_path: attributes.text_path as Gint,
            text_align: attributes.text_alignment.into(),
            fill_ind: attributes.fill_area_index,
            pat_width_vec: attributes.pattern_width.into(),
            pat_ht_vec: attributes.pattern_height.into(),
            pat_ref_point: attributes.pattern_reference.into(),
        })
    };
    ginq_line_ind(Gint) InquirePolylineIndex => Gks::inquire_polyline_index;
    ginq_marker_ind(Gint) InquirePolymarkerIndex => Gks::inquire_polymarker_index;
    ginq_text_ind(Gint) InquireTextIndex => Gks::inquire_text_index;
    ginq_char_ht(Gdouble) InquireCharacterHeight => Gks::inquire_character_height;
    ginq_char_up_vec(Gvec) InquireCharacterUpVector => |gks| gks.inquire_character_up_vector().map(Gvec::from);
    ginq_char_width(Gdouble) InquireCharacterWidth => Gks::inquire_character_width;
    ginq_char_base_vec(Gvec) InquireCharacterBaseVector
        => |gks| gks.inquire_character_base_vector().map(Gvec::from);
    ginq_text_path(Gint) InquireTextPath => |gks| gks.inquire_text_path().map(|path| path as Gint);
    ginq_text_align(Gtext_align) InquireTextAlignment
        => |gks| gks.inquire_text_alignment().map(Gtext_align::from);
    ginq_fill_ind(Gint) InquireFillAreaIndex => Gks::inquire_fill_area_index;
    ginq_pat_width_vec(Gvec) InquirePatternWidthVector
        => |gks| gks.inquire_pattern_width_vector().map(Gvec::from);
    ginq_pat_ht_vec(Gvec) InquirePatternHeightVector
        => |gks| gks.inquire_pattern_height_vector().map(Gvec::from);
    ginq_pat_ref_point(Gpoint) InquirePatternReferencePoint
        => |gks| gks.inquire_pattern_reference_point().map(Gpoint::from);
    ginq_cur_indiv_attrs(Gindiv_attrs) InquireCurrentIndividualAttributeValues => |gks| {
        let attributes = gks.inquire_current_individual_attribute_values()?;
        let (line, marker) = (attributes.polyline, attributes.polymarker);
        let (text, fill) = (attributes.text, attributes.fill_area);
        Ok(Gindiv_attrs {
            linetype: line.linetype,
            linewidth: line.width,
            line_colr_ind: line.colour as Gint,
            marker_type: marker.kind,
            marker_size: marker.size,
            marker_colr_ind: marker.colour as Gint,
            text_font_prec: (text.font, text.precision).into(),
            char_expan: text.expansion,
            char_space: text.spacing,
            text_colr_ind: text.colour as Gint,
            fill_int_style: fill.interior as Gint,
            fill_style_ind: fill.style,
            fill_colr_ind: fill.colour as Gint,
            asfs: asfs(attributes.sources),
        })
    };
    ginq_linetype(Gint) InquireLinetype => Gks::inquire_linetype;
    ginq_linewidth(Gdouble) InquireLinewidthScaleFactor => Gks::inquire_linewidth_scale_factor;
    ginq_line_colr_ind(Gint) InquirePolylineColourIndex => Gks::inquire_polyline_colour_index;
    ginq_marker_type(Gint) InquireMarkerType => Gks::inquire_marker_type;
    ginq_marker_size(Gdouble) InquireMarkerSizeScaleFactor => Gks::inquire_marker_size_scale_factor;
    ginq_marker_colr_ind(Gint) InquirePolymarkerColourIndex => Gks::inquire_polymarker_colour_index;
    ginq_text_font_prec(Gtext_font_prec) InquireTextFontAndPrecision
        => |gks| gks.inquire_text_font_and_precision().map(Gtext_font_prec::from);
    ginq_char_expan(Gdouble) InquireCharacterExpansionFactor => Gks::inquire_character_expansion_factor;
    ginq_char_space(Gdouble) InquireCharacterSpacing => Gks::inquire_character_spacing;
    ginq_text_colr_ind(Gint) InquireTextColourIndex => Gks::inquire_text_colour_index;
    ginq_fill_int_style(Gint) InquireFillAreaInteriorStyle
        => |gks| gks.inquire_fill_area_interior_style().map(|style| style as Gint);
    ginq_fill_style_ind(Gint) InquireFillAreaStyleIndex => Gks::inquire_fill_area_style_index;
    ginq_fill_colr_ind(Gint) InquireFillAreaColourIndex => Gks::inquire_fill_area_colour_index;
    ginq_asfs(Gasfs) InquireAspectSourceFlags => |gks| gks.inquire_aspect_source_flags().map(asfs);
    ginq_cur_norm_tran_num(Gint) InquireCurrentNormalizationTransformationNumber
        => Gks::inquire_current_normalization_transformation_number;
    ginq_clip(Gclip) InquireClipping => |gks| {
        let (clip, rect) = gks.inquire_clipping()?;
        Ok(Gclip { clip_ind: clip.into(), clip_rect: rect.into() })
    };
}

/// INQUIRE PATTERN SIZE, which the standard gives as two vectors.
#[unsafe(no_mangle)]
extern "C" fn ginq_pat_size(err_ind: Out<Gint>, x_size: Out<Gdouble>, y_size: Out<Gdouble>) {
    inquire(Function::InquirePatternWidthVector, err_ind, |gks| {
        x_size.set(length(gks.inquire_pattern_width_vector()?));
        y_size.set(length(gks.inquire_pattern_height_vector()?));
        Ok(())
    });
}

/// INQUIRE NORMALIZATION TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn ginq_norm_tran(num: Gint, err_ind: Out<Gint>, norm_tran: Out<Gtran>) {
    inquire(Function::InquireNormalizationTransformation, err_ind, |gks| {
        let transformation = gks.inquire_normalization_transformation(num)?;
        norm_tran.set(Gtran { win: transformation.window.into(), vp: transformation.viewport.into() });
        Ok(())
    });
}

/// Inquiries of a list of integers of the state list.
macro_rules! list_inquiries {
    ($($name:ident $function:ident => |$gks:ident| $list:expr;)+) => { $(
        #[doc = concat!("Inquires by `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(
            num_elems_appl_list: Gint,
            start_pos: Gint,
            err_ind: Out<Gint>,
            list: Out<Gint_list>,
            length_list: Out<Gint>,
        ) {
            const F: Function = Function::$function;
            let part = Part::of(num_elems_appl_list, start_pos, list, length_list);
            inquire(F, err_ind, |$gks| part.set(F, $list));
        }
    )+ };
}

list_inquiries! {
    ginq_list_avail_ws_types InquireListOfAvailableWorkstationTypes
        => |gks| gks.inquire_list_of_available_workstation_types()?;
    ginq_set_open_wss InquireSetOfOpenWorkstations => |gks| gks.inquire_set_of_open_workstations()?;
    ginq_set_active_wss InquireSetOfActiveWorkstations => |gks| gks.inquire_set_of_active_workstations()?;
    ginq_list_norm_tran_nums InquireListOfNormalizationTransformationNumbers
        => |gks| gks.inquire_list_of_normalization_transformation_numbers()?.iter().copied();
    ginq_set_seg_names InquireSetOfSegmentNamesInUse => |gks| gks.inquire_set_of_segment_names_in_use()?;
}
