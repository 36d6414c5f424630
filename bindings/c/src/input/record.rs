//! Data records of input devices, by prompt and echo type.
//!
//! The kernel takes a data record as integers, reals and strings; here are the structures of `gks.h` that hold
//! them. Attributes that a prompt could be drawn with are passed on as the integers and the real that they are.
#![allow(non_camel_case_types, reason = "the names of the binding")]

use crate::argument::{In, array};
use crate::types::{Gdata, Gdouble, Gfloat, Gint};
use gks::DataRecord;
use gks_instance::{Controlled, PromptAttributes};
use std::ffi::{CStr, c_char};

/// Attributes behind the flag that says whether they are those of lines or of areas.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) struct Chosen {
    line_or_fill: Gint,
    flag: Gint,
    attributes: PromptAttributes<Gdouble>,
}

/// The value of the flag for areas.
const FILL: Gint = 1;

/// The union in `Gloc_data`.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) union Gloc_data {
    none: Gdata,
    pet_r4: Controlled<Gdouble>,
    pet_r5: Chosen,
}

/// `Gstroke_data`.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) struct Gstroke_data {
    init_pos: Gint,
    x_interval: Gfloat,
    y_interval: Gfloat,
    time_interval: Gfloat,
    pets: Stroke,
}

#[repr(C)]
#[derive(Copy, Clone)]
union Stroke {
    none: Gdata,
    /// Of `pet_r3` and `pet_r4`.
    controlled: Controlled<Gdouble>,
}

/// A number of strings.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) struct Strings {
    count: Gint,
    strings: *mut *mut c_char,
}

/// A number of prompt switches.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) struct Prompts {
    count: Gint,
    prompts: *mut Gint,
}

/// The pick identifiers of a segment.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) struct Identifiers {
    segment: Gint,
    count: Gint,
    identifiers: *mut Gint,
}

/// The union in `Gchoice_data`.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) union Gchoice_data {
    none: Gdata,
    pet_r2: Prompts,
    /// Also `pet_r4`.
    pet_r3: Strings,
    pet_r5: Identifiers,
}

/// `Gval_data`, `Gpick_data` and `Gstring_data`, which hold nothing that means anything.
pub(crate) type Nothing = Gdata;

/// No data.
pub(crate) const NONE: Gdata = Gdata { size: 0, data: std::ptr::null_mut() };

/// The data record of a locator; empty at a null pointer.
pub(crate) fn locator(pet: Gint, data: In<Gloc_data>) -> DataRecord {
    let mut record = DataRecord::default();
    if let Some(data) = data.get() {
        match pet {
            // SAFETY: the member of the prompt and echo type, as the contract of the crate asks.
            4 => unsafe { data.pet_r4 }.read(false, &mut record),
            5 => {
                // SAFETY: the same.
                let chosen = unsafe { data.pet_r5 };
                record.integers.push(chosen.line_or_fill);
                let controlled = Controlled { flag: chosen.flag, attributes: chosen.attributes };
                controlled.read(chosen.line_or_fill == FILL, &mut record);
            }
            _ => {}
        }
    }
    record
}

/// The data of a record of a locator.
pub(crate) fn of_locator(pet: Gint, record: &DataRecord) -> Gloc_data {
    match (pet, record.integers.as_slice()) {
        (4, integers) => {
            Gloc_data { pet_r4: Controlled::write(false, integers, &record.reals, Gdouble::from) }
        }
        (5, [line_or_fill, rest @ ..]) => {
            let Controlled { flag, attributes } =
                Controlled::write(*line_or_fill == FILL, rest, &record.reals, Gdouble::from);
            Gloc_data { pet_r5: Chosen { line_or_fill: *line_or_fill, flag, attributes } }
        }
        _ => Gloc_data { none: NONE },
    }
}

/// The data record of a stroke device; empty at a null pointer.
pub(crate) fn stroke(pet: Gint, data: In<Gstroke_data>) -> DataRecord {
    let mut record = DataRecord::default();
    if let Some(data) = data.get() {
        record.integers.push(data.init_pos);
        record.reals.extend([data.x_interval, data.y_interval, data.time_interval].map(f64::from));
        if matches!(pet, 3 | 4) {
            // SAFETY: the member of the prompt and echo type, as the contract of the crate asks.
            unsafe { data.pets.controlled }.read(false, &mut record);
        }
    }
    record
}

/// The data of a record of a stroke device.
pub(crate) fn of_stroke(pet: Gint, record: &DataRecord) -> Gstroke_data {
    let real = |i: usize| record.reals.get(i).map_or(0.0, |&real| real as Gfloat);
    let pets = match (pet, record.integers.get(1..), record.reals.get(3..)) {
        (3 | 4, Some(integers), Some(reals)) => {
            Stroke { controlled: Controlled::write(false, integers, reals, Gdouble::from) }
        }
        _ => Stroke { none: NONE },
    };
    Gstroke_data {
        init_pos: record.integers.first().copied().unwrap_or(1),
        x_interval: real(0),
        y_interval: real(1),
        time_interval: real(2),
        pets,
    }
}

/// The data record of a choice device; empty at a null pointer.
pub(crate) fn choice(pet: Gint, data: In<Gchoice_data>) -> DataRecord {
    let mut record = DataRecord::default();
    let Some(data) = data.get() else { return record };
    match pet {
        2 => {
            // SAFETY: the member of the prompt and echo type, as the contract of the crate asks.
            let Prompts { count, prompts } = unsafe { data.pet_r2 };
            record.integers.extend_from_slice(array(prompts, count));
        }
        3 | 4 => {
            // SAFETY: the same.
            let Strings { count, strings } = unsafe { data.pet_r3 };
            let texts = array(strings, count).iter().filter(|string| !string.is_null());
            // SAFETY: strings end with a zero byte, as the contract of the crate asks.
            let texts = texts.map(|&string| unsafe { CStr::from_ptr(string) }.to_bytes());
            record.strings.extend(texts.map(|text| gks_instance::from_utf8_or_latin1(text).into_owned()));
        }
        5 => {
            // SAFETY: the same.
            let Identifiers { segment, count, identifiers } = unsafe { data.pet_r5 };
            record.integers.push(segment);
            record.integers.extend_from_slice(array(identifiers, count));
        }
        _ => {}
    }
    record
}

/// The data of a record of a choice device, which lie in memory that lives as long as they are used: the
/// integers of the record, and the addresses of its strings.
pub(crate) fn of_choice(pet: Gint, integers: &mut [Gint], strings: &mut [*mut c_char]) -> Gchoice_data {
    let count = |length: usize| Gint::try_from(length).unwrap_or(Gint::MAX);
    match (pet, integers) {
        (2, prompts) => {
            Gchoice_data { pet_r2: Prompts { count: count(prompts.len()), prompts: prompts.as_mut_ptr() } }
        }
        (3 | 4, _) => {
            Gchoice_data { pet_r3: Strings { count: count(strings.len()), strings: strings.as_mut_ptr() } }
        }
        (5, [segment, identifiers @ ..]) => Gchoice_data {
            pet_r5: Identifiers {
                segment: *segment,
                count: count(identifiers.len()),
                identifiers: identifiers.as_mut_ptr(),
            },
        },
        _ => Gchoice_data { none: NONE },
    }
}
