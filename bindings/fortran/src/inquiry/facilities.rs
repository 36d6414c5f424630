//! Inquiries of the workstation description table: facilities for each primitive and predefined
//! representations.

use crate::answer::{answer, element, inquiries};
use crate::argument::{Integer, Real};
use gks::Function;

/// How many linewidths, marker sizes, character heights or expansion factors there are: any number of them.
const CONTINUOUS: i32 = 0;

inquiries! {
    gqpplr_(wtype: Integer, pli: Integer) -> (ltype: Integer, lwidth: Real, coli: Integer)
        InquirePredefinedPolylineRepresentation => |gks| {
            let bundle = gks.inquire_predefined_polyline_representation(wtype.get(), pli.get())?;
            Ok((bundle.linetype, bundle.width, bundle.colour))
        };
    gqppmr_(wtype: Integer, pmi: Integer) -> (mtype: Integer, mszsf: Real, coli: Integer)
        InquirePredefinedPolymarkerRepresentation => |gks| {
            let bundle = gks.inquire_predefined_polymarker_representation(wtype.get(), pmi.get())?;
            Ok((bundle.kind, bundle.size, bundle.colour))
        };
    gqptxr_(wtype: Integer, ptxi: Integer)
        -> (font: Integer, prec: Integer, chxp: Real, chsp: Real, coli: Integer)
        InquirePredefinedTextRepresentation => |gks| {
            let bundle = gks.inquire_predefined_text_representation(wtype.get(), ptxi.get())?;
            Ok((bundle.font, bundle.precision, bundle.expansion, bundle.spacing, bundle.colour))
        };
    gqpfar_(wtype: Integer, pfai: Integer) -> (ints: Integer, styli: Integer, coli: Integer)
        InquirePredefinedFillAreaRepresentation => |gks| {
            let bundle = gks.inquire_predefined_fill_area_representation(wtype.get(), pfai.get())?;
            Ok((bundle.interior, bundle.style, bundle.colour))
        };
    gqpaf_(wtype: Integer) -> (nppai: Integer) InquirePatternFacilities
        => |gks| gks.inquire_pattern_facilities(wtype.get());
    gqcf_(wtype: Integer) -> (ncoli: Integer, cola: Integer, npci: Integer) InquireColourFacilities
        => |gks| {
            let facilities = gks.inquire_colour_facilities(wtype.get())?;
            Ok((facilities.colours, facilities.coloured, facilities.predefined))
        };
    gqpcr_(wtype: Integer, pci: Integer) -> (red: Real, green: Real, blue: Real)
        InquirePredefinedColourRepresentation => |gks| {
            let colour = gks.inquire_predefined_colour_representation(wtype.get(), pci.get())?;
            Ok((colour.red, colour.green, colour.blue))
        };
}

/// GQPLF: INQUIRE POLYLINE FACILITIES.
#[unsafe(no_mangle)]
extern "C" fn gqplf_(
    wtype: Integer,
    n: Integer,
    errind: Integer,
    nlt: Integer,
    lt: Integer,
    nlw: Integer,
    nomlw: Real,
    rlwmin: Real,
    rlwmax: Real,
    nppli: Integer,
) {
    let outputs = ((nlt, lt), nlw, (nomlw, rlwmin, rlwmax), nppli);
    answer(Function::InquirePolylineFacilities, errind, outputs, |gks| {
        let facilities = gks.inquire_polyline_facilities(wtype.get())?;
        let linetype = element(facilities.linetypes.iter().map(|linetype| linetype.number), n);
        let widths = facilities.widths;
        let widths = (widths.nominal, widths.least, widths.greatest);
        Ok((linetype, CONTINUOUS, widths, facilities.predefined))
    });
}

/// GQPMF: INQUIRE POLYMARKER FACILITIES.
#[unsafe(no_mangle)]
extern "C" fn gqpmf_(
    wtype: Integer,
    n: Integer,
    errind: Integer,
    nmt: Integer,
    mt: Integer,
    nms: Integer,
    nomms: Real,
    rmsmin: Real,
    rmsmax: Real,
    nppmi: Integer,
) {
    let outputs = ((nmt, mt), nms, (nomms, rmsmin, rmsmax), nppmi);
    answer(Function::InquirePolymarkerFacilities, errind, outputs, |gks| {
        let facilities = gks.inquire_polymarker_facilities(wtype.get())?;
        let marker = element(facilities.markers.iter().map(|marker| marker.number), n);
        let sizes = facilities.sizes;
        let sizes = (sizes.nominal, sizes.least, sizes.greatest);
        Ok((marker, CONTINUOUS, sizes, facilities.predefined))
    });
}

/// GQTXF: INQUIRE TEXT FACILITIES.
#[unsafe(no_mangle)]
extern "C" fn gqtxf_(
    wtype: Integer,
    n: Integer,
    errind: Integer,
    nfpp: Integer,
    font: Integer,
    prec: Integer,
    nchh: Integer,
    minchh: Real,
    maxchh: Real,
    nchx: Integer,
    minchx: Real,
    maxchx: Real,
    nptxi: Integer,
) {
    let outputs = ((nfpp, (font, prec)), nchh, (minchh, maxchh), nchx, (minchx, maxchx), nptxi);
    answer(Function::InquireTextFacilities, errind, outputs, |gks| {
        let facilities = gks.inquire_text_facilities(wtype.get())?;
        let (heights, expansions) = (facilities.heights, facilities.expansions);
        let pair = element(facilities.pairs(), n);
        Ok((pair, CONTINUOUS, heights, CONTINUOUS, expansions, facilities.predefined))
    });
}

/// GQFAF: INQUIRE FILL AREA FACILITIES.
#[unsafe(no_mangle)]
extern "C" fn gqfaf_(
    wtype: Integer,
    ni: Integer,
    nh: Integer,
    errind: Integer,
    nis: Integer,
    is: Integer,
    nhs: Integer,
    hs: Integer,
    npfai: Integer,
) {
    let outputs = ((nis, is), (nhs, hs), npfai);
    answer(Function::InquireFillAreaFacilities, errind, outputs, |gks| {
        let facilities = gks.inquire_fill_area_facilities(wtype.get())?;
        let style = element(facilities.interior_styles, ni);
        let hatch = element(facilities.hatches.iter().map(|hatch| hatch.number), nh);
        Ok((style, hatch, facilities.predefined))
    });
}
