//! The attributes that a prompt of an input device could be drawn with, as the structures of the bindings to C hold them.
//!
//! Both bindings to C lay them out alike, but for the type of a real number. The kernel takes them as the integers and the real
//! that they are.

use gks::DataRecord;
use std::ffi::c_int;

/// Attributes of lines or markers: aspect source flags and an index, then a bundle.
#[repr(C)]
#[derive(Copy, Clone)]
struct Line<R> {
    flags_and_index: [c_int; 4],
    kind: c_int,
    width: R,
    colour: c_int,
}

/// Attributes of areas.
#[repr(C)]
#[derive(Copy, Clone)]
struct Fill {
    flags_and_index: [c_int; 4],
    interior: c_int,
    style: c_int,
    colour: c_int,
}

/// Attributes of lines, markers or areas.
#[repr(C)]
#[derive(Copy, Clone)]
pub union PromptAttributes<R: Copy> {
    line: Line<R>,
    fill: Fill,
}

/// Attributes behind an attribute control flag.
#[repr(C)]
#[derive(Copy, Clone)]
pub struct Controlled<R: Copy> {
    /// The flag: 1 if attributes are specified, 0 if they are the current ones.
    pub flag: c_int,
    /// The attributes, which are there if they are specified.
    pub attributes: PromptAttributes<R>,
}

/// The value of the flag for attributes that are specified.
const SPECIFIED: c_int = 1;

impl<R: Copy + Into<f64>> Controlled<R> {
    /// Adds the flag and the attributes to a data record, unless they are the current ones and need not be there.
    pub fn read(&self, of_areas: bool, record: &mut DataRecord) {
        record.integers.push(self.flag);
        if self.flag != SPECIFIED {
            return;
        }
        if of_areas {
            // SAFETY: specified attributes of areas.
            let Fill { flags_and_index, interior, style, colour } = unsafe { self.attributes.fill };
            record.integers.extend(flags_and_index);
            record.integers.extend([interior, style, colour]);
        } else {
            // SAFETY: specified attributes of lines or markers.
            let Line { flags_and_index, kind, width, colour } = unsafe { self.attributes.line };
            record.integers.extend(flags_and_index);
            record.integers.extend([kind, colour]);
            record.reals.push(width.into());
        }
    }

    /// The attributes of a data record; `real` makes a number of the binding.
    pub fn write(of_areas: bool, integers: &[c_int], reals: &[f64], real: impl FnOnce(f64) -> R) -> Self {
        let at = |i: usize| integers.get(i).copied().unwrap_or(0);
        let flags_and_index = [at(1), at(2), at(3), at(4)];
        let attributes = if of_areas {
            let fill = Fill { flags_and_index, interior: at(5), style: at(6), colour: at(7) };
            PromptAttributes { fill }
        } else {
            let width = real(reals.first().copied().unwrap_or(0.0));
            PromptAttributes { line: Line { flags_and_index, kind: at(5), width, colour: at(6) } }
        };
        Controlled { flag: at(0), attributes }
    }
}
