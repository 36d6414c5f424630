//! Escapes.

use crate::argument::{In, Out, array, call, integer};
use crate::store::{self, Gstore};
use crate::types::{Gfloat, Gint};
use gks::{DataRecord, Function};
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

/// ESCAPE. Output data lie in the store; the pointer to them is null where there are none.
#[unsafe(no_mangle)]
extern "C" fn gescape(func_id: Gint, in_data: In<Gint>, store_data: In<Gstore>, out_data: Out<*const Gint>) {
    const F: Function = Function::Escape;
    out_data.set(std::ptr::null());
    call(F, |gks| {
        let output = gks.escape(func_id, &data_record(func_id, in_data)?)?;
        if !output.is_empty() {
            out_data.set(store::record(F, store_data, &output)?);
        }
        Ok(())
    });
}
