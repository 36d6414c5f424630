//! Inquiries of the operating state, the GKS description table and the GKS state list.

use crate::answer::{Array, inquiries, lists};
use crate::argument::{Integer, Real};

/// GQOPS: INQUIRE OPERATING STATE VALUE.
#[unsafe(no_mangle)]
extern "C" fn gqops_(opsta: Integer) {
    opsta.set(gks_instance::with(|instance| instance.gks.inquire_operating_state_value()) as i32);
}

lists! {
    gqewk_() InquireListOfAvailableWorkstationTypes
        => |gks| gks.inquire_list_of_available_workstation_types();
    gqopwk_() InquireSetOfOpenWorkstations => |gks| gks.inquire_set_of_open_workstations();
    gqacwk_() InquireSetOfActiveWorkstations => |gks| gks.inquire_set_of_active_workstations();
    gqentn_() InquireListOfNormalizationTransformationNumbers => |gks| {
        gks.inquire_list_of_normalization_transformation_numbers().map(|list| list.iter().copied())
    };
}

inquiries! {
    gqlvks_() -> (level: Integer) InquireLevelOfGks => |gks| Ok(gks.inquire_level_of_gks()? as i32);
    gqwkm_() -> (mxopwk: Integer, mxacwk: Integer, mxwkas: Integer) InquireWorkstationMaximumNumbers
        => |gks| {
            let most = gks.inquire_workstation_maximum_numbers()?;
            Ok((most.open, most.active, most.of_a_segment))
        };
    gqmntn_() -> (maxtnr: Integer) InquireMaximumNormalizationTransformationNumber
        => |gks| gks.inquire_maximum_normalization_transformation_number();

    gqpli_() -> (pli: Integer) InquirePolylineIndex => |gks| gks.inquire_polyline_index();
    gqpmi_() -> (pmi: Integer) InquirePolymarkerIndex => |gks| gks.inquire_polymarker_index();
    gqtxi_() -> (txi: Integer) InquireTextIndex => |gks| gks.inquire_text_index();
    gqchh_() -> (chh: Real) InquireCharacterHeight => |gks| gks.inquire_character_height();
    gqchup_() -> (chux: Real, chuy: Real) InquireCharacterUpVector
        => |gks| gks.inquire_character_up_vector();
    gqchw_() -> (chw: Real) InquireCharacterWidth => |gks| gks.inquire_character_width();
    gqchb_() -> (chbx: Real, chby: Real) InquireCharacterBaseVector
        => |gks| gks.inquire_character_base_vector();
    gqtxp_() -> (txp: Integer) InquireTextPath => |gks| gks.inquire_text_path();
    gqtxal_() -> (txalh: Integer, txalv: Integer) InquireTextAlignment
        => |gks| gks.inquire_text_alignment();
    gqfai_() -> (fai: Integer) InquireFillAreaIndex => |gks| gks.inquire_fill_area_index();
    gqparf_() -> (rfx: Real, rfy: Real) InquirePatternReferencePoint
        => |gks| gks.inquire_pattern_reference_point();

    gqln_() -> (ltype: Integer) InquireLinetype => |gks| gks.inquire_linetype();
    gqlwsc_() -> (lwidth: Real) InquireLinewidthScaleFactor => |gks| gks.inquire_linewidth_scale_factor();
    gqplci_() -> (coli: Integer) InquirePolylineColourIndex => |gks| gks.inquire_polyline_colour_index();
    gqmk_() -> (mtype: Integer) InquireMarkerType => |gks| gks.inquire_marker_type();
    gqmksc_() -> (mszsf: Real) InquireMarkerSizeScaleFactor
        => |gks| gks.inquire_marker_size_scale_factor();
    gqpmci_() -> (coli: Integer) InquirePolymarkerColourIndex
        => |gks| gks.inquire_polymarker_colour_index();
    gqtxfp_() -> (font: Integer, prec: Integer) InquireTextFontAndPrecision
        => |gks| gks.inquire_text_font_and_precision();
    gqchxp_() -> (chxp: Real) InquireCharacterExpansionFactor
        => |gks| gks.inquire_character_expansion_factor();
    gqchsp_() -> (chsp: Real) InquireCharacterSpacing => |gks| gks.inquire_character_spacing();
    gqtxci_() -> (coli: Integer) InquireTextColourIndex => |gks| gks.inquire_text_colour_index();
    gqfais_() -> (ints: Integer) InquireFillAreaInteriorStyle
        => |gks| gks.inquire_fill_area_interior_style();
    gqfasi_() -> (styli: Integer) InquireFillAreaStyleIndex => |gks| gks.inquire_fill_area_style_index();
    gqfaci_() -> (coli: Integer) InquireFillAreaColourIndex => |gks| gks.inquire_fill_area_colour_index();
    gqasf_() -> (lasf: Array<i32, 13>) InquireAspectSourceFlags
        => |gks| Ok(gks.inquire_aspect_source_flags()?.to_array());

    gqcntn_() -> (ctnr: Integer) InquireCurrentNormalizationTransformationNumber
        => |gks| gks.inquire_current_normalization_transformation_number();
    gqnt_(ntnr: Integer) -> (window: Array<f32, 4>, viewpt: Array<f32, 4>) InquireNormalizationTransformation
        => |gks| {
            let transformation = gks.inquire_normalization_transformation(ntnr.get())?;
            Ok((transformation.window, transformation.viewport))
        };
    gqclip_() -> (clsw: Integer, clrect: Array<f32, 4>) InquireClipping => |gks| gks.inquire_clipping();
}

/// GQPA: INQUIRE PATTERN WIDTH VECTOR and INQUIRE PATTERN HEIGHT VECTOR.
#[unsafe(no_mangle)]
extern "C" fn gqpa_(errind: Integer, pwx: Real, pwy: Real, phx: Real, phy: Real) {
    const F: gks::Function = gks::Function::InquirePatternWidthVector;
    crate::answer::answer(F, errind, ((pwx, pwy), (phx, phy)), |gks| {
        Ok((gks.inquire_pattern_width_vector()?, gks.inquire_pattern_height_vector()?))
    });
}
