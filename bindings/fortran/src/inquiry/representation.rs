//! Inquiries of the workstation state list: bundle and colour tables, lists of indices.

use crate::answer::{inquiries, lists};
use crate::argument::{Integer, Real};

lists! {
    gqepli_(wkid: Integer) InquireListOfPolylineIndices
        => |gks| gks.inquire_list_of_polyline_indices(wkid.get());
    gqepmi_(wkid: Integer) InquireListOfPolymarkerIndices
        => |gks| gks.inquire_list_of_polymarker_indices(wkid.get());
    gqetxi_(wkid: Integer) InquireListOfTextIndices => |gks| gks.inquire_list_of_text_indices(wkid.get());
    gqefai_(wkid: Integer) InquireListOfFillAreaIndices
        => |gks| gks.inquire_list_of_fill_area_indices(wkid.get());
    gqepai_(wkid: Integer) InquireListOfPatternIndices
        => |gks| gks.inquire_list_of_pattern_indices(wkid.get());
    gqeci_(wkid: Integer) InquireListOfColourIndices
        => |gks| gks.inquire_list_of_colour_indices(wkid.get());
}

inquiries! {
    gqplr_(wkid: Integer, pli: Integer, type_: Integer) -> (ltype: Integer, lwidth: Real, coli: Integer)
        InquirePolylineRepresentation => |gks| {
            let bundle = gks.inquire_polyline_representation(wkid.get(), pli.get(), type_.choice(F)?)?;
            Ok((bundle.linetype, bundle.width, bundle.colour))
        };
    gqpmr_(wkid: Integer, pmi: Integer, type_: Integer) -> (mtype: Integer, mszsf: Real, coli: Integer)
        InquirePolymarkerRepresentation => |gks| {
            let bundle = gks.inquire_polymarker_representation(wkid.get(), pmi.get(), type_.choice(F)?)?;
            Ok((bundle.kind, bundle.size, bundle.colour))
        };
    gqtxr_(wkid: Integer, txi: Integer, type_: Integer)
        -> (font: Integer, prec: Integer, chxp: Real, chsp: Real, coli: Integer)
        InquireTextRepresentation => |gks| {
            let bundle = gks.inquire_text_representation(wkid.get(), txi.get(), type_.choice(F)?)?;
            Ok((bundle.font, bundle.precision, bundle.expansion, bundle.spacing, bundle.colour))
        };
    gqfar_(wkid: Integer, fai: Integer, type_: Integer) -> (ints: Integer, styli: Integer, coli: Integer)
        InquireFillAreaRepresentation => |gks| {
            let bundle = gks.inquire_fill_area_representation(wkid.get(), fai.get(), type_.choice(F)?)?;
            Ok((bundle.interior, bundle.style, bundle.colour))
        };
    gqcr_(wkid: Integer, coli: Integer, type_: Integer) -> (cr: Real, cg: Real, cb: Real)
        InquireColourRepresentation => |gks| {
            let colour = gks.inquire_colour_representation(wkid.get(), coli.get(), type_.choice(F)?)?;
            Ok((colour.red, colour.green, colour.blue))
        };
}
