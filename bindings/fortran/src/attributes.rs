//! Output attributes that belong to no workstation.

use crate::argument::{Integer, Real, choice};
use crate::call::{call, subroutines};
use gks::Function;
use gks_pipeline::look::AspectSourceFlags;

subroutines! {
    gspli_(pli: Integer) SetPolylineIndex => |gks| gks.set_polyline_index(pli.get());
    gsln_(ltype: Integer) SetLinetype => |gks| gks.set_linetype(ltype.get());
    gslwsc_(lwidth: Real) SetLinewidthScaleFactor => |gks| gks.set_linewidth_scale_factor(lwidth.real());
    gsplci_(coli: Integer) SetPolylineColourIndex => |gks| gks.set_polyline_colour_index(coli.get());
    gspmi_(pmi: Integer) SetPolymarkerIndex => |gks| gks.set_polymarker_index(pmi.get());
    gsmk_(mtype: Integer) SetMarkerType => |gks| gks.set_marker_type(mtype.get());
    gsmksc_(mszsf: Real) SetMarkerSizeScaleFactor => |gks| gks.set_marker_size_scale_factor(mszsf.real());
    gspmci_(coli: Integer) SetPolymarkerColourIndex => |gks| gks.set_polymarker_colour_index(coli.get());
    gstxi_(txi: Integer) SetTextIndex => |gks| gks.set_text_index(txi.get());
    gstxfp_(font: Integer, prec: Integer) SetTextFontAndPrecision
        => |gks| gks.set_text_font_and_precision(font.get(), prec.choice(F)?);
    gschxp_(chxp: Real) SetCharacterExpansionFactor => |gks| gks.set_character_expansion_factor(chxp.real());
    gschsp_(chsp: Real) SetCharacterSpacing => |gks| gks.set_character_spacing(chsp.real());
    gstxci_(coli: Integer) SetTextColourIndex => |gks| gks.set_text_colour_index(coli.get());
    gschh_(chh: Real) SetCharacterHeight => |gks| gks.set_character_height(chh.real());
    gschup_(chux: Real, chuy: Real) SetCharacterUpVector
        => |gks| gks.set_character_up_vector((chux.real(), chuy.real()));
    gstxp_(txp: Integer) SetTextPath => |gks| gks.set_text_path(txp.choice(F)?);
    gstxal_(txalh: Integer, txalv: Integer) SetTextAlignment
        => |gks| gks.set_text_alignment(txalh.choice(F)?, txalv.choice(F)?);
    gsfai_(fai: Integer) SetFillAreaIndex => |gks| gks.set_fill_area_index(fai.get());
    gsfasi_(styli: Integer) SetFillAreaStyleIndex => |gks| gks.set_fill_area_style_index(styli.get());
    gsfaci_(coli: Integer) SetFillAreaColourIndex => |gks| gks.set_fill_area_colour_index(coli.get());
    gspa_(szx: Real, szy: Real) SetPatternSize => |gks| gks.set_pattern_size(szx.real(), szy.real());
    gsparf_(rfx: Real, rfy: Real) SetPatternReferencePoint
        => |gks| gks.set_pattern_reference_point((rfx.real(), rfy.real()));
    gsasf_(lasf: Integer) SetAspectSourceFlags => |gks| gks.set_aspect_source_flags(flags(F, lasf)?);
}

/// GSFAIS: SET FILL AREA INTERIOR STYLE.
#[unsafe(no_mangle)]
extern "C" fn gsfais_(ints: Integer) {
    const F: Function = Function::SetFillAreaInteriorStyle;
    let style = gks_instance::interior_style(ints.get());
    call(F, |gks| gks.set_fill_area_interior_style(choice(style, F)?));
}

/// The thirteen aspect source flags.
fn flags(function: Function, lasf: Integer) -> gks::Result<AspectSourceFlags> {
    let mut flags = [false; 13];
    for (flag, &number) in flags.iter_mut().zip(lasf.slice(0, 13)) {
        *flag = choice(number, function)?;
    }
    Ok(AspectSourceFlags::from_array(flags))
}
