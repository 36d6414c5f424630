//! Escapes.

use crate::argument::{In, Out, array, call, integer};
use crate::error::report;
use crate::hlu::{self, Gdata};
use crate::store::{self, Gstore};
use crate::types::{Gfloat, Gint};
use gks::{DataRecord, Function};
use gks_instance::Dialect;
use gks_pipeline::generated::numbers::ESCAPES;

/// The input data record of an escape function: in C, a structure of its integers and then its reals.
fn data_record(func_id: Gint, in_data: In<Gint>) -> gks::Result<DataRecord> {
    let Some(kind) = ESCAPES.iter().find(|kind| kind.number == func_id) else {
        return Ok(DataRecord::default());
    };
    in_data.needed(Function::Escape)?;
    let first = in_data.address();
    let integers = array(first, integer(kind.integers)).to_vec();
    let reals = array(first.wrapping_add(integers.len()).cast::<Gfloat>(), integer(kind.reals));
    let reals = reals.iter().copied().map(f64::from).collect();
    Ok(DataRecord { integers, reals, strings: Vec::new() })
}

/// ESCAPE with an identifier of NCAR Graphics in its dialect. Whether it was one.
fn ncar(func_id: Gint, in_data: In<Gint>) -> bool {
    const F: Function = Function::Escape;
    // Our own identifiers are none of its.
    if func_id >= 0 || gks_instance::with(|instance| instance.dialect) != Dialect::Ncar {
        return false;
    }
    if func_id == hlu::NATIVE {
        hlu::native(in_data);
        return true;
    }
    let known = gks_instance::call_instance(F, report, |instance| {
        gks_instance::check_state(&instance.gks, F)?;
        // The records of other identifiers have other types.
        let is_text = gks_instance::ncar_record_is_read(func_id);
        let record = if is_text { in_data.cast::<Gdata<In<u8>>>().get() } else { None };
        Ok(instance.ncar_escape(func_id, record.map_or(&[], Gdata::bytes)))
    });
    known.unwrap_or(true)
}

/// ESCAPE. Output data lie in the store; the pointer to them is null where there are none.
#[unsafe(no_mangle)]
extern "C" fn gescape(func_id: Gint, in_data: In<Gint>, store_data: In<Gstore>, out_data: Out<*const Gint>) {
    const F: Function = Function::Escape;
    out_data.set(std::ptr::null());
    if ncar(func_id, in_data) {
        return;
    }
    call(F, |gks| {
        let output = gks.escape(func_id, &data_record(func_id, in_data)?)?;
        if !output.is_empty() {
            out_data.set(store::record(F, store_data, &output)?);
        }
        Ok(())
    });
}
