//! Inquiries of the workstation description table: what a type of workstation is.

use crate::answer::{Array, answer, element, inquiries};
use crate::argument::{Integer, Real};
use gks::Function;

/// The number of DEVICE COORDINATE UNITS METRES, which all workstations have.
const METRES: i32 = 0;

inquiries! {
    gqwkca_(wtype: Integer) -> (wkcat: Integer) InquireWorkstationCategory
        => |gks| gks.inquire_workstation_category(wtype.get());
    gqwkcl_(wtype: Integer) -> (vrtype: Integer) InquireWorkstationClassification
        => |gks| gks.inquire_workstation_classification(wtype.get());
    gqdsp_(wtype: Integer) -> (dcunit: Integer, rx: Real, ry: Real, lx: Integer, ly: Integer)
        InquireDisplaySpaceSize => |gks| {
            let size = gks.inquire_display_space_size(wtype.get())?;
            Ok((METRES, size.metres.0, size.metres.1, size.raster.0, size.raster.1))
        };
    gqdwka_(wtype: Integer) -> (
        plbun: Integer, pmbun: Integer, txbun: Integer, fabun: Integer, parep: Integer, colrep: Integer,
        wktr: Integer
    ) InquireDynamicModificationOfWorkstationAttributes => |gks| {
        let is = gks.inquire_dynamic_modification_of_workstation_attributes(wtype.get())?;
        let bundles = (is.line_bundles, is.marker_bundles, is.text_bundles, is.fill_bundles);
        Ok((bundles.0, bundles.1, bundles.2, bundles.3, is.patterns, is.colours, is.transformation))
    };
    gqdds_(wtype: Integer) -> (defmod: Integer, regmod: Integer) InquireDefaultDeferralStateValues
        => |gks| gks.inquire_default_deferral_state_values(wtype.get());
    gqgdp_(wtype: Integer, gdp: Integer) -> (nbnd: Integer, bndl: Array<i32, 4>)
        InquireGeneralizedDrawingPrimitive => |gks| {
            let groups = gks.inquire_generalized_drawing_primitive(wtype.get(), gdp.get())?;
            Ok(groups.iter().map(|&group| group as i32).collect::<Vec<_>>())
        };
    gqlwk_(wtype: Integer) -> (
        mplbte: Integer, mpmbte: Integer, mtxbte: Integer, mfabte: Integer, mpai: Integer, mcoli: Integer
    ) InquireMaximumLengthOfWorkstationStateTables => |gks| {
        let most = gks.inquire_maximum_length_of_workstation_state_tables(wtype.get())?;
        let bundles = (most.polylines, most.polymarkers, most.texts, most.fill_areas);
        Ok((bundles.0, bundles.1, bundles.2, bundles.3, most.patterns, most.colours))
    };
}

/// GQEGDP: INQUIRE LIST OF AVAILABLE GENERALIZED DRAWING PRIMITIVES.
#[unsafe(no_mangle)]
extern "C" fn gqegdp_(wtype: Integer, n: Integer, errind: Integer, ngdp: Integer, gdpl: Integer) {
    const F: Function = Function::InquireListOfAvailableGeneralizedDrawingPrimitives;
    answer(F, errind, (ngdp, gdpl), |gks| {
        let list = gks.inquire_list_of_available_generalized_drawing_primitives(wtype.get())?;
        Ok(element(list.iter().map(|gdp| gdp.number), n))
    });
}
