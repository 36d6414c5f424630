//! Inquiries of the workstation description table.

use crate::argument::{In, Out, Part, inquire, integer};
use crate::store::{self, Gstore};
use crate::types::{
    Gcolr_facs, Gdisp_space_size, Gdyn_mod_seg_attrs, Gdyn_mod_ws_attrs, Gfill_bundle, Gfill_facs, Gfloat,
    Gfloat_size, Gint, Gint_list, Gint_size, Gline_bundle, Gline_facs, Gmarker_bundle, Gmarker_facs,
    Gmax_ws_st_tables, Gpat_rep, Grgb, Gtext_bundle, Gtext_facs, Gtext_font_prec,
};
use gks::Function;

/// Metres, the only unit of device coordinates.
const METRES: Gint = 0;
/// How many sizes there are in a continuous range.
const CONTINUOUS: Gint = 0;

/// Inquiries of one value that a workstation type alone decides.
macro_rules! inquiries {
    ($($name:ident($type:ty) $function:ident => $method:ident, $value:expr;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_type: Gint, err_ind: Out<Gint>, out: Out<$type>) {
            inquire(Function::$function, err_ind, |gks| {
                out.set(gks.$method(ws_type).map($value)?);
                Ok(())
            });
        }
    )+ };
}

inquiries! {
    ginq_ws_cat(Gint) InquireWorkstationCategory => inquire_workstation_category, |category| category as Gint;
    ginq_ws_class(Gint) InquireWorkstationClassification
        => inquire_workstation_classification, |class| class as Gint;
    ginq_disp_space_size(Gdisp_space_size) InquireDisplaySpaceSize => inquire_display_space_size, |size| {
        Gdisp_space_size {
            dc_units: METRES,
            size_dc: Gfloat_size { size_x: size.metres.0 as Gfloat, size_y: size.metres.1 as Gfloat },
            size_raster: Gint_size { size_x: integer(size.raster.0), size_y: integer(size.raster.1) },
        }
    };
    ginq_dyn_mod_ws_attrs(Gdyn_mod_ws_attrs) InquireDynamicModificationOfWorkstationAttributes
        => inquire_dynamic_modification_of_workstation_attributes, |dynamic| Gdyn_mod_ws_attrs {
            line_bundle: dynamic.line_bundles as Gint,
            marker_bundle: dynamic.marker_bundles as Gint,
            text_bundle: dynamic.text_bundles as Gint,
            fill_bundle: dynamic.fill_bundles as Gint,
            pat_rep: dynamic.patterns as Gint,
            colr_rep: dynamic.colours as Gint,
            ws_tran: dynamic.transformation as Gint,
        };
    ginq_num_seg_pris(Gint) InquireNumberOfSegmentPrioritiesSupported
        => inquire_number_of_segment_priorities_supported, integer;
    ginq_dyn_mod_seg_attrs(Gdyn_mod_seg_attrs) InquireDynamicModificationOfSegmentAttributes
        => inquire_dynamic_modification_of_segment_attributes, |dynamic| Gdyn_mod_seg_attrs {
            tran: dynamic.transformation as Gint,
            vis_invis: dynamic.disappearing as Gint,
            invis_vis: dynamic.appearing as Gint,
            highl: dynamic.highlighting as Gint,
            pri: dynamic.priority as Gint,
            add: dynamic.adding as Gint,
            del: dynamic.deletion as Gint,
        };
    ginq_pat_facs(Gint) InquirePatternFacilities => inquire_pattern_facilities, integer;
    ginq_colr_facs(Gcolr_facs) InquireColourFacilities => inquire_colour_facilities, |facilities| Gcolr_facs {
        num_colrs: integer(facilities.colours),
        colr_avail: facilities.coloured.into(),
        num_pred_inds: integer(facilities.predefined),
    };
    ginq_max_ws_st_tables(Gmax_ws_st_tables) InquireMaximumLengthOfWorkstationStateTables
        => inquire_maximum_length_of_workstation_state_tables, |lengths| Gmax_ws_st_tables {
            line_bundles: integer(lengths.polylines),
            marker_bundles: integer(lengths.polymarkers),
            text_bundles: integer(lengths.texts),
            fill_bundles: integer(lengths.fill_areas),
            pat_reps: integer(lengths.patterns),
            colr_reps: integer(lengths.colours),
        };
}

/// Inquiries of a predefined entry of a table.
macro_rules! predefined {
    ($($name:ident($type:ty) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_type: Gint, ind: Gint, err_ind: Out<Gint>, rep: Out<$type>) {
            inquire(Function::$function, err_ind, |gks| {
                rep.set(gks.$method(ws_type, ind)?.into());
                Ok(())
            });
        }
    )+ };
}

predefined! {
    ginq_pred_line_rep(Gline_bundle) InquirePredefinedPolylineRepresentation
        => inquire_predefined_polyline_representation;
    ginq_pred_marker_rep(Gmarker_bundle) InquirePredefinedPolymarkerRepresentation
        => inquire_predefined_polymarker_representation;
    ginq_pred_text_rep(Gtext_bundle) InquirePredefinedTextRepresentation
        => inquire_predefined_text_representation;
    ginq_pred_fill_rep(Gfill_bundle) InquirePredefinedFillAreaRepresentation
        => inquire_predefined_fill_area_representation;
    ginq_pred_colr_rep(Grgb) InquirePredefinedColourRepresentation => inquire_predefined_colour_representation;
}

/// INQUIRE PREDEFINED PATTERN REPRESENTATION. The pattern lies in the store.
#[unsafe(no_mangle)]
extern "C" fn ginq_pred_pat_rep(
    ws_type: Gint,
    ind: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    pat_rep: Out<*const Gpat_rep>,
) {
    const F: Function = Function::InquirePredefinedPatternRepresentation;
    pat_rep.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let cells = gks.inquire_predefined_pattern_representation(ws_type, ind)?;
        pat_rep.set(store::pattern(F, store, &cells)?);
        Ok(())
    });
}

/// INQUIRE DEFAULT DEFERRAL STATE VALUES.
#[unsafe(no_mangle)]
extern "C" fn ginq_def_defer_sts(
    ws_type: Gint,
    err_ind: Out<Gint>,
    defer_mode: Out<Gint>,
    irg_mode: Out<Gint>,
) {
    inquire(Function::InquireDefaultDeferralStateValues, err_ind, |gks| {
        let (deferral, regeneration) = gks.inquire_default_deferral_state_values(ws_type)?;
        defer_mode.set(deferral as Gint);
        irg_mode.set(regeneration as Gint);
        Ok(())
    });
}

/// INQUIRE POLYLINE FACILITIES. The list is that of the linetypes.
#[unsafe(no_mangle)]
extern "C" fn ginq_line_facs(
    ws_type: Gint,
    num_elems_appl_list: Gint,
    start_pos: Gint,
    err_ind: Out<Gint>,
    line_facs: Out<Gline_facs>,
    length_list: Out<Gint>,
) {
    const F: Function = Function::InquirePolylineFacilities;
    // SAFETY: the address of a member of a structure that is there.
    let types = line_facs.member(|facs| unsafe { &raw mut (*facs).types });
    let part = Part::of(num_elems_appl_list, start_pos, types, length_list);
    inquire(F, err_ind, |gks| {
        let facilities = gks.inquire_polyline_facilities(ws_type)?;
        let num_ints = part.set(F, facilities.linetypes.iter().map(|linetype| linetype.number))?;
        line_facs.set(Gline_facs {
            types: Gint_list { num_ints, ints: part.address() },
            num_widths: CONTINUOUS,
            nom_width: facilities.widths.nominal,
            min_width: facilities.widths.least,
            max_width: facilities.widths.greatest,
            num_pred_inds: integer(facilities.predefined),
        });
        Ok(())
    });
}

/// INQUIRE POLYMARKER FACILITIES. The list is that of the marker types.
#[unsafe(no_mangle)]
extern "C" fn ginq_marker_facs(
    ws_type: Gint,
    num_elems_appl_list: Gint,
    start_pos: Gint,
    err_ind: Out<Gint>,
    marker_facs: Out<Gmarker_facs>,
    length_list: Out<Gint>,
) {
    const F: Function = Function::InquirePolymarkerFacilities;
    // SAFETY: the address of a member of a structure that is there.
    let types = marker_facs.member(|facs| unsafe { &raw mut (*facs).types });
    let part = Part::of(num_elems_appl_list, start_pos, types, length_list);
    inquire(F, err_ind, |gks| {
        let facilities = gks.inquire_polymarker_facilities(ws_type)?;
        let num_ints = part.set(F, facilities.markers.iter().map(|marker| marker.number))?;
        marker_facs.set(Gmarker_facs {
            types: Gint_list { num_ints, ints: part.address() },
            num_sizes: CONTINUOUS,
            nom_size: facilities.sizes.nominal,
            min_size: facilities.sizes.least,
            max_size: facilities.sizes.greatest,
            num_pred_inds: integer(facilities.predefined),
        });
        Ok(())
    });
}

/// INQUIRE TEXT FACILITIES. The list is that of the pairs of font and precision.
#[unsafe(no_mangle)]
extern "C" fn ginq_text_facs(
    ws_type: Gint,
    num_elems_appl_list: Gint,
    start_pos: Gint,
    err_ind: Out<Gint>,
    text_facs: Out<Gtext_facs>,
    length_list: Out<Gint>,
) {
    const F: Function = Function::InquireTextFacilities;
    // SAFETY: the addresses of members of a structure that is there.
    let pairs = text_facs.member(|facs| unsafe { &raw mut (*facs).font_precs }).target();
    let count = text_facs.member(|facs| unsafe { &raw mut (*facs).num_font_precs });
    let part = Part::new((num_elems_appl_list, start_pos), pairs, count, length_list);
    inquire(F, err_ind, |gks| {
        let facilities = gks.inquire_text_facilities(ws_type)?;
        let num_font_precs = part.set(F, facilities.pairs().map(Gtext_font_prec::from))?;
        text_facs.set(Gtext_facs {
            num_font_precs,
            font_precs: part.address(),
            num_char_hts: CONTINUOUS,
            min_char_ht: facilities.heights.0,
            max_char_ht: facilities.heights.1,
            num_char_expans: CONTINUOUS,
            min_char_expan: facilities.expansions.0,
            max_char_expan: facilities.expansions.1,
            num_pred_inds: integer(facilities.predefined),
        });
        Ok(())
    });
}

/// INQUIRE FILL AREA FACILITIES. The list is that of the hatch styles.
#[unsafe(no_mangle)]
extern "C" fn ginq_fill_facs(
    ws_type: Gint,
    hatch_length: Gint,
    hatch_start_pos: Gint,
    err_ind: Out<Gint>,
    fill_facs: Out<Gfill_facs>,
    act_hatch_length: Out<Gint>,
) {
    const F: Function = Function::InquireFillAreaFacilities;
    // SAFETY: the address of a member of a structure that is there.
    let hatches = fill_facs.member(|facs| unsafe { &raw mut (*facs).hatch_styles });
    let part = Part::of(hatch_length, hatch_start_pos, hatches, act_hatch_length);
    inquire(F, err_ind, |gks| {
        let facilities = gks.inquire_fill_area_facilities(ws_type)?;
        let num_ints = part.set(F, facilities.hatches.iter().map(|hatch| hatch.number))?;
        fill_facs.set(Gfill_facs {
            num_int_styles: integer(facilities.interior_styles.len()),
            int_style: facilities.interior_styles.map(|style| style as Gint),
            hatch_styles: Gint_list { num_ints, ints: part.address() },
            num_pred_inds: integer(facilities.predefined),
        });
        Ok(())
    });
}

/// INQUIRE LIST OF AVAILABLE GENERALIZED DRAWING PRIMITIVES.
#[unsafe(no_mangle)]
extern "C" fn ginq_list_avail_gdps(
    ws_type: Gint,
    num_elems_appl_list: Gint,
    start_pos: Gint,
    err_ind: Out<Gint>,
    gdp: Out<Gint_list>,
    length_list: Out<Gint>,
) {
    const F: Function = Function::InquireListOfAvailableGeneralizedDrawingPrimitives;
    let part = Part::of(num_elems_appl_list, start_pos, gdp, length_list);
    inquire(F, err_ind, |gks| {
        let list = gks.inquire_list_of_available_generalized_drawing_primitives(ws_type)?;
        part.set(F, list.iter().map(|gdp| gdp.number))
    });
}

/// INQUIRE GENERALIZED DRAWING PRIMITIVE. There is room for four groups of attributes.
#[unsafe(no_mangle)]
extern "C" fn ginq_gdp(ws_type: Gint, gdp: Gint, err_ind: Out<Gint>, num_attr: Out<Gint>, attr: Out<Gint>) {
    inquire(Function::InquireGeneralizedDrawingPrimitive, err_ind, |gks| {
        let groups = gks.inquire_generalized_drawing_primitive(ws_type, gdp)?;
        num_attr.set(integer(groups.len()));
        attr.set_all(groups.iter().take(4).map(|&group| group as Gint));
        Ok(())
    });
}
