//! What programs in C ask about Fortran: the file of a unit, and a data record as Fortran has it.

use super::argument::{Address, integer};
use super::types::{Gchar, Gfloat, Gint};
use gks::DataRecord;
use std::ffi::CString;
use std::sync::{LazyLock, Mutex, PoisonError};

/// The name of the file that is connected to a unit, empty for none. It is good until the next call.
#[unsafe(no_mangle)]
extern "C" fn getlunname(unit: Gint) -> *const Gchar {
    static NAME: LazyLock<Mutex<CString>> = LazyLock::new(Mutex::default);
    let mut name = NAME.lock().unwrap_or_else(PoisonError::into_inner);
    *name = CString::new(gks_instance::file_of_unit(unit).unwrap_or_default()).unwrap_or_default();
    name.as_ptr()
}

/// PACK DATA RECORD. The strings have their lengths from the list.
#[unsafe(no_mangle)]
extern "C" fn gprecc(
    integers: Gint,
    integer_list: Address<Gint>,
    reals: Gint,
    real_list: Address<Gfloat>,
    strings: Gint,
    lengths: Address<Gint>,
    string_list: Address<*mut u8>,
    room: Gint,
    error: Address<Gint>,
    used: Address<Gint>,
    record: Address<u8>,
) -> Gint {
    let strings = string_list.array(strings).iter().zip(lengths.array(strings)).map(|(&string, &length)| {
        // One character for each byte, whatever the character set, so that the same bytes come out again.
        Address::at(string).array(length).iter().map(|&byte| char::from(byte)).collect()
    });
    let data = DataRecord {
        integers: integer_list.array(integers).to_vec(),
        reals: real_list.array(reals).iter().map(|&real| real.into()).collect(),
        strings: strings.collect(),
    };
    match data.pack(usize::try_from(room).unwrap_or(0)) {
        Ok(lines) => {
            used.set(integer(lines.len()));
            record.set_all(lines.as_flattened().iter().copied());
            error.set(0);
            0
        }
        Err(found) => {
            used.set(0);
            error.set(found.number);
            found.number
        }
    }
}
