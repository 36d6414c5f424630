//! Data records of input devices: the unions of `xgks.h`, of which the prompt and echo type says which member counts.
//!
//! The kernel takes a data record as integers, reals and strings. Attributes that a prompt could be drawn with are passed
//! on as the integers and the real that they are.

use super::super::argument::{Address, allocated, allocated_text, integer};
use super::super::types::{Gchar, Gfloat, Gint, Gpoint};
use gks::DataRecord;
use gks_instance::Controlled;
use std::ptr::null_mut;

/// Data of the implementation, which has none.
type Data = *mut Gchar;

/// The value of the flag for areas.
const FILL: Gint = 1;

/// Attributes behind the flag that says whether they are those of lines or of areas.
#[repr(C)]
#[derive(Copy, Clone)]
struct Chosen {
    line_or_fill: Gint,
    controlled: Controlled<Gfloat>,
}

/// A number as the structures of XGKS have it.
fn narrow(value: f64) -> Gfloat {
    value as Gfloat
}

/// What a prompt and echo type needs, and data of the implementation.
#[repr(C)]
#[derive(Copy, Clone)]
struct With<T> {
    needs: T,
    data: Data,
}

/// Adds data of the implementation, of which there are none.
fn with<T>(needs: T) -> With<T> {
    With { needs, data: null_mut() }
}

/// A data record of a locator.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) union Glocrec {
    none: Data,
    pet4: With<Controlled<Gfloat>>,
    pet5: With<Chosen>,
}

/// What all data records of stroke devices begin with.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) struct Buffer {
    pub(super) size: Gint,
    position: Gint,
    interval: Gpoint,
    time: Gfloat,
}

#[repr(C)]
#[derive(Copy, Clone)]
struct BufferAndAttributes {
    buffer: Buffer,
    controlled: Controlled<Gfloat>,
}

/// A data record of a stroke device.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) union Gstrokerec {
    buffer: With<Buffer>,
    /// Also of type 4.
    pet3: With<BufferAndAttributes>,
}

/// A number of values; of segments, their pick identifiers.
#[repr(C)]
#[derive(Copy, Clone)]
struct Many<T> {
    number: Gint,
    values: *mut T,
}

#[repr(C)]
#[derive(Copy, Clone)]
struct OfSegment {
    seg: Gint,
    number: Gint,
    identifiers: *mut Gint,
}

/// A data record of a choice device.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) union Gchoicerec {
    none: Data,
    pet2: With<Many<Gint>>,
    /// Also of type 4.
    pet3: With<Many<*mut Gchar>>,
    pet5: With<OfSegment>,
}

/// A data record of a valuator.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) struct Gvalrec {
    pub(super) low: Gfloat,
    pub(super) high: Gfloat,
    pub(super) data: Data,
}

/// A data record of a string device.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) struct Gstringrec {
    pub(super) bufsiz: Gint,
    pub(super) position: Gint,
    pub(super) data: Data,
}

/// A data record of a pick device.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) struct Gpickrec {
    pub(super) data: Data,
}

/// Nothing in the place of data of the implementation.
pub(super) const NO_DATA: Data = null_mut();

/// The data record of a locator; empty at a null pointer.
pub(super) fn locator(pet: Gint, data: Address<Glocrec>) -> DataRecord {
    let mut record = DataRecord::default();
    if let Some(data) = data.value() {
        match pet {
            // SAFETY: the member of the prompt and echo type, as the contract of the crate asks.
            4 => unsafe { data.pet4 }.needs.read(false, &mut record),
            5 => {
                // SAFETY: the same.
                let chosen = unsafe { data.pet5 }.needs;
                record.integers.push(chosen.line_or_fill);
                chosen.controlled.read(chosen.line_or_fill == FILL, &mut record);
            }
            _ => {}
        }
    }
    record
}

/// The data of a record of a locator.
pub(super) fn of_locator(pet: Gint, record: &DataRecord) -> Glocrec {
    match (pet, record.integers.as_slice()) {
        (4, integers) => Glocrec { pet4: with(Controlled::write(false, integers, &record.reals, narrow)) },
        (5, [line_or_fill, rest @ ..]) => {
            let controlled = Controlled::write(*line_or_fill == FILL, rest, &record.reals, narrow);
            Glocrec { pet5: with(Chosen { line_or_fill: *line_or_fill, controlled }) }
        }
        _ => Glocrec { none: NO_DATA },
    }
}

/// The data record of a stroke device, and the size of its buffer; none at a null pointer.
pub(super) fn stroke(pet: Gint, data: Address<Gstrokerec>) -> Option<(DataRecord, Gint)> {
    let data = data.value()?;
    let mut record = DataRecord::default();
    // SAFETY: all members begin with this.
    let buffer = unsafe { data.buffer }.needs;
    record.integers.push(buffer.position);
    record.reals.extend([buffer.interval.x, buffer.interval.y, buffer.time].map(f64::from));
    if matches!(pet, 3 | 4) {
        // SAFETY: the member of the prompt and echo type, as the contract of the crate asks.
        unsafe { data.pet3 }.needs.controlled.read(false, &mut record);
    }
    Some((record, buffer.size))
}

/// The data of a record of a stroke device with a buffer of a size.
pub(super) fn of_stroke(pet: Gint, size: Gint, record: &DataRecord) -> Gstrokerec {
    let real = |i: usize| record.reals.get(i).map_or(0.0, |&real| real as Gfloat);
    let position = record.integers.first().copied().unwrap_or(1);
    let buffer = Buffer { size, position, interval: Gpoint { x: real(0), y: real(1) }, time: real(2) };
    match (pet, record.integers.get(1..), record.reals.get(3..)) {
        (3 | 4, Some(integers), Some(reals)) => {
            let controlled = Controlled::write(false, integers, reals, narrow);
            Gstrokerec { pet3: with(BufferAndAttributes { buffer, controlled }) }
        }
        _ => Gstrokerec { buffer: with(buffer) },
    }
}

/// The data record of a choice device; empty at a null pointer.
pub(super) fn choice(pet: Gint, data: Address<Gchoicerec>) -> DataRecord {
    let mut record = DataRecord::default();
    let Some(data) = data.value() else { return record };
    match pet {
        2 => {
            // SAFETY: the member of the prompt and echo type, as the contract of the crate asks.
            let Many { number, values } = unsafe { data.pet2 }.needs;
            record.integers.extend_from_slice(Address::at(values).array(number));
        }
        3 | 4 => {
            // SAFETY: the same.
            let Many { number, values } = unsafe { data.pet3 }.needs;
            let texts = Address::at(values).array(number).iter();
            record.strings.extend(texts.map(|&text| Address::at(text).text().into_owned()));
        }
        5 => {
            // SAFETY: the same.
            let OfSegment { seg, number, identifiers } = unsafe { data.pet5 }.needs;
            record.integers.push(seg);
            record.integers.extend_from_slice(Address::at(identifiers).array(number));
        }
        _ => {}
    }
    record
}

/// The data of a record of a choice device, in memory that belongs to the program.
pub(super) fn of_choice(pet: Gint, record: &DataRecord) -> Gchoicerec {
    match (pet, record.integers.as_slice()) {
        (2, prompts) => {
            Gchoicerec { pet2: with(Many { number: integer(prompts.len()), values: allocated(prompts) }) }
        }
        (3 | 4, _) => {
            let strings: Vec<*mut Gchar> = record.strings.iter().map(|text| allocated_text(text)).collect();
            Gchoicerec { pet3: with(Many { number: integer(strings.len()), values: allocated(&strings) }) }
        }
        (5, [seg, identifiers @ ..]) => {
            let (number, identifiers) = (integer(identifiers.len()), allocated(identifiers));
            Gchoicerec { pet5: with(OfSegment { seg: *seg, number, identifiers }) }
        }
        _ => Gchoicerec { none: NO_DATA },
    }
}
