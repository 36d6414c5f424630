//! Bundles, patterns and colours of one workstation: setting and inquiring.

use super::argument::{Address, allocated, call, choice, inquire, integer, list};
use super::control::kind;
use super::types::{
    Gchar, Gcobundl, Gflbundl, Gint, Gintlist, Gipoint, Glnbundl, Gmkbundl, Gptbundl, Gtxbundl,
};
use gks::{Function, ValueType};
use gks_pipeline::item::Cells;
use gks_pipeline::look::Precision;

/// SET POLYLINE REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gsetlinerep(ws_id: Gint, index: Gint, rep: Address<Glnbundl>) -> Gint {
    const F: Function = Function::SetPolylineRepresentation;
    call(F, |gks| {
        let Glnbundl { kind, width, colour } = rep.get(F)?;
        gks.set_polyline_representation(ws_id, index, kind, width.into(), colour)
    })
}

/// SET POLYMARKER REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gsetmarkerrep(ws_id: Gint, index: Gint, rep: Address<Gmkbundl>) -> Gint {
    const F: Function = Function::SetPolymarkerRepresentation;
    call(F, |gks| {
        let Gmkbundl { kind, size, colour } = rep.get(F)?;
        gks.set_polymarker_representation(ws_id, index, kind, size.into(), colour)
    })
}

/// SET TEXT REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gsettextrep(ws_id: Gint, index: Gint, rep: Address<Gtxbundl>) -> Gint {
    const F: Function = Function::SetTextRepresentation;
    call(F, |gks| {
        let Gtxbundl { fp, ch_exp, space, colour } = rep.get(F)?;
        let precision = choice(Precision::from_number(fp.prec), F)?;
        gks.set_text_representation(ws_id, index, fp.font, precision, ch_exp.into(), space.into(), colour)
    })
}

/// SET FILL AREA REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gsetfillrep(ws_id: Gint, index: Gint, rep: Address<Gflbundl>) -> Gint {
    const F: Function = Function::SetFillAreaRepresentation;
    call(F, |gks| {
        let rep = rep.get(F)?;
        gks.set_fill_area_representation(ws_id, index, choice(rep.interior(), F)?, rep.style, rep.colour)
    })
}

/// SET PATTERN REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gsetpatrep(ws_id: Gint, index: Gint, rep: Address<Gptbundl>) -> Gint {
    const F: Function = Function::SetPatternRepresentation;
    call(F, |gks| {
        let rep = rep.get(F)?;
        let [columns, rows] = [rep.size.x, rep.size.y].map(|n| usize::try_from(n).unwrap_or(0));
        let cells = rep.cells();
        gks.set_pattern_representation_of(ws_id, index, cells, columns, rows, columns)
    })
}

impl Gptbundl {
    fn cells<'a>(&self) -> &'a [Gint] {
        let count = self.size.x.checked_mul(self.size.y).filter(|&n| n > 0).unwrap_or(0);
        if self.array.is_null() || count == 0 {
            return &[];
        }
        // SAFETY: the contract of the crate.
        unsafe { std::slice::from_raw_parts(self.array, count as usize) }
    }

    fn of(cells: &Cells<'_>) -> Gptbundl {
        let indices: Vec<Gint> = (0..cells.rows).flat_map(|row| cells.row(row).iter().copied()).collect();
        let size = Gipoint { x: integer(cells.columns), y: integer(cells.rows) };
        Gptbundl { size, array: allocated(&indices) }
    }
}

/// SET COLOUR REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gsetcolourrep(ws_id: Gint, index: Gint, rep: Address<Gcobundl>) -> Gint {
    const F: Function = Function::SetColourRepresentation;
    call(F, |gks| {
        let Gcobundl { red, green, blue } = rep.get(F)?;
        gks.set_colour_representation(ws_id, index, (red.into(), green.into(), blue.into()))
    })
}

/// Inquiries of the list of the indices of a table.
macro_rules! lists {
    ($($name:ident $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_id: Gint, indices: Address<Gintlist>) -> Gint {
            inquire(Function::$function, |gks| {
                indices.set(list(gks.$method(ws_id)?));
                Ok(())
            })
        }
    )+ };
}

lists! {
    ginqlineindices InquireListOfPolylineIndices => inquire_list_of_polyline_indices;
    ginqmarkerindices InquireListOfPolymarkerIndices => inquire_list_of_polymarker_indices;
    ginqtextindices InquireListOfTextIndices => inquire_list_of_text_indices;
    ginqfillindices InquireListOfFillAreaIndices => inquire_list_of_fill_area_indices;
    ginqpatindices InquireListOfPatternIndices => inquire_list_of_pattern_indices;
    ginqcolourindices InquireListOfColourIndices => inquire_list_of_colour_indices;
}

/// Inquiries of an entry of a table, and of a predefined one.
macro_rules! representations {
    ($($name:ident($type:ty) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_id: Gint, index: Gint, value: Gint, rep: Address<$type>) -> Gint {
            const F: Function = Function::$function;
            inquire(F, |gks| {
                rep.set(gks.$method(ws_id, index, choice(ValueType::from_number(value), F)?)?.into());
                Ok(())
            })
        }
    )+ };
}

representations! {
    ginqlinerep(Glnbundl) InquirePolylineRepresentation => inquire_polyline_representation;
    ginqmarkerrep(Gmkbundl) InquirePolymarkerRepresentation => inquire_polymarker_representation;
    ginqtextrep(Gtxbundl) InquireTextRepresentation => inquire_text_representation;
    ginqfillrep(Gflbundl) InquireFillAreaRepresentation => inquire_fill_area_representation;
    ginqcolourrep(Gcobundl) InquireColourRepresentation => inquire_colour_representation;
}

/// Inquiries of a predefined entry of a table.
macro_rules! predefined {
    ($($name:ident($type:ty) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_type: Address<Gchar>, index: Gint, rep: Address<$type>) -> Gint {
            inquire(Function::$function, |gks| {
                rep.set(gks.$method(kind(ws_type), index)?.into());
                Ok(())
            })
        }
    )+ };
}

predefined! {
    ginqpredlinerep(Glnbundl) InquirePredefinedPolylineRepresentation
        => inquire_predefined_polyline_representation;
    ginqpredmarkerrep(Gmkbundl) InquirePredefinedPolymarkerRepresentation
        => inquire_predefined_polymarker_representation;
    ginqpredtextrep(Gtxbundl) InquirePredefinedTextRepresentation => inquire_predefined_text_representation;
    ginqpredfillrep(Gflbundl) InquirePredefinedFillAreaRepresentation
        => inquire_predefined_fill_area_representation;
    ginqpredcolourrep(Gcobundl) InquirePredefinedColourRepresentation => inquire_predefined_colour_representation;
}

/// INQUIRE PATTERN REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn ginqpatrep(ws_id: Gint, index: Gint, value: Gint, rep: Address<Gptbundl>) -> Gint {
    const F: Function = Function::InquirePatternRepresentation;
    inquire(F, |gks| {
        let value = choice(ValueType::from_number(value), F)?;
        rep.set(Gptbundl::of(&gks.inquire_pattern_representation(ws_id, index, value)?));
        Ok(())
    })
}

/// INQUIRE PREDEFINED PATTERN REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn ginqpredpatrep(ws_type: Address<Gchar>, index: Gint, rep: Address<Gptbundl>) -> Gint {
    inquire(Function::InquirePredefinedPatternRepresentation, |gks| {
        rep.set(Gptbundl::of(&gks.inquire_predefined_pattern_representation(kind(ws_type), index)?));
        Ok(())
    })
}
