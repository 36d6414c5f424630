//! Inquiries of the workstation state list: the bundle, pattern and colour tables.

use crate::argument::{In, Out, Part, choice, inquire};
use crate::store::{self, Gstore};
use crate::types::{
    Gfill_bundle, Gint, Gint_list, Gline_bundle, Gmarker_bundle, Gpat_rep, Grgb, Gtext_bundle,
};
use gks::{Function, ValueType};

/// Inquiries of the list of the indices of a table.
macro_rules! lists {
    ($($name:ident $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(
            ws_id: Gint,
            num_elems_appl_list: Gint,
            start_pos: Gint,
            err_ind: Out<Gint>,
            list: Out<Gint_list>,
            length_list: Out<Gint>,
        ) {
            const F: Function = Function::$function;
            let part = Part::of(num_elems_appl_list, start_pos, list, length_list);
            inquire(F, err_ind, |gks| part.set(F, gks.$method(ws_id)?));
        }
    )+ };
}

lists! {
    ginq_list_line_inds InquireListOfPolylineIndices => inquire_list_of_polyline_indices;
    ginq_list_marker_inds InquireListOfPolymarkerIndices => inquire_list_of_polymarker_indices;
    ginq_list_text_inds InquireListOfTextIndices => inquire_list_of_text_indices;
    ginq_list_fill_inds InquireListOfFillAreaIndices => inquire_list_of_fill_area_indices;
    ginq_list_pat_inds InquireListOfPatternIndices => inquire_list_of_pattern_indices;
    ginq_list_colr_inds InquireListOfColourIndices => inquire_list_of_colour_indices;
}

/// Inquiries of an entry of a table.
macro_rules! representations {
    ($($name:ident($type:ty) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_id: Gint, ind: Gint, r#type: Gint, err_ind: Out<Gint>, rep: Out<$type>) {
            const F: Function = Function::$function;
            inquire(F, err_ind, |gks| {
                rep.set(gks.$method(ws_id, ind, choice(F, r#type, ValueType::from_number)?)?.into());
                Ok(())
            });
        }
    )+ };
}

representations! {
    ginq_line_rep(Gline_bundle) InquirePolylineRepresentation => inquire_polyline_representation;
    ginq_marker_rep(Gmarker_bundle) InquirePolymarkerRepresentation => inquire_polymarker_representation;
    ginq_text_rep(Gtext_bundle) InquireTextRepresentation => inquire_text_representation;
    ginq_fill_rep(Gfill_bundle) InquireFillAreaRepresentation => inquire_fill_area_representation;
    ginq_colr_rep(Grgb) InquireColourRepresentation => inquire_colour_representation;
}

/// INQUIRE PATTERN REPRESENTATION. The pattern lies in the store.
#[unsafe(no_mangle)]
extern "C" fn ginq_pat_rep(
    ws_id: Gint,
    pat_ind: Gint,
    r#type: Gint,
    store: In<Gstore>,
    err_ind: Out<Gint>,
    pat_rep: Out<*const Gpat_rep>,
) {
    const F: Function = Function::InquirePatternRepresentation;
    pat_rep.set(std::ptr::null());
    inquire(F, err_ind, |gks| {
        let value = choice(F, r#type, ValueType::from_number)?;
        let cells = gks.inquire_pattern_representation(ws_id, pat_ind, value)?;
        pat_rep.set(store::pattern(F, store, &cells)?);
        Ok(())
    });
}
