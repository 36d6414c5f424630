//! The escape by which HLU, the library below NCL, speaks to the drivers of NCAR Graphics.
//!
//! Its record is a structure of HLU that says what is wanted and of which workstation. Opacity and antialiasing
//! have their meaning here; sizes, windows and georeferences are without effect.

use crate::argument::{In, Out, array, call, integer};
use crate::types::{Gfloat, Gint};
use gks::{Function, Gks};
use gks_pipeline::tables::Primitives;

/// The identifier of the escape.
pub(crate) const NATIVE: Gint = -1450;

/// An input data record of an escape function of NCAR Graphics.
#[repr(C)]
#[derive(Copy, Clone)]
pub(crate) struct Gdata<T> {
    size: usize,
    data: T,
}

impl Gdata<In<u8>> {
    /// The bytes of the record.
    pub(crate) fn bytes<'a>(self) -> &'a [u8] {
        array(self.data.address(), integer(self.size))
    }
}

/// The structure for opacity; that for antialiasing is the same without its last member.
#[repr(C)]
struct Alpha {
    kind: Gint,
    workstation: Gint,
    of: Gint,
    alpha: Gfloat,
}

const SET_ALPHA: Gint = 7;
const GET_ALPHA: Gint = 8;
const ANTIALIASING: Gint = 9;

/// What an opacity of HLU is for: lines, areas, markers, text, and the background, which is no primitive.
fn primitives(of: Gint) -> Option<Primitives> {
    match of {
        0 => Some(Primitives::Lines),
        1 => Some(Primitives::Areas),
        2 => Some(Primitives::Markers),
        3 => Some(Primitives::Text),
        _ => None,
    }
}

/// The colour index of the background, whose opacity is that of its colour.
const BACKGROUND: (Gint, Gint) = (4, 0);

/// Does what a record of the escape asks for. Workstations that are not open, and those that draw nothing, are
/// left alone: HLU asks all of them.
pub(crate) fn native(in_data: In<Gint>) {
    let Some(record) = in_data.cast::<Gdata<In<u8>>>().get() else { return };
    let (words, _) = record.bytes().as_chunks::<4>();
    let word = |i: usize| words.get(i).copied().map(Gint::from_ne_bytes);
    let (Some(kind), Some(workstation), Some(of)) = (word(0), word(1), word(2)) else { return };
    let alpha = words.get(3).copied().map(Gfloat::from_ne_bytes);
    call(Function::Escape, |gks| {
        match (kind, alpha) {
            (SET_ALPHA, Some(alpha)) => drop(set_alpha(gks, workstation, of, alpha.clamp(0.0, 1.0).into())),
            (GET_ALPHA, Some(_)) => {
                if let Some(alpha) = alpha_of(gks, workstation, of)
                    && let Some(record) = in_data.cast::<Gdata<Out<Alpha>>>().get()
                {
                    // SAFETY: the address of a member of a structure that is there.
                    record.data.member(|data| unsafe { &raw mut (*data).alpha }).set(alpha);
                }
            }
            (ANTIALIASING, _) => drop(gks.set_antialiasing(workstation, of != 0)),
            _ => {}
        }
        Ok(())
    });
}

fn set_alpha(gks: &mut Gks, workstation: Gint, of: Gint, alpha: f64) -> gks::Result<()> {
    match primitives(of) {
        Some(primitives) => gks.set_opacity(workstation, primitives, alpha),
        None if of == BACKGROUND.0 => gks.set_colour_alpha(workstation, BACKGROUND.1, alpha),
        None => Ok(()),
    }
}

fn alpha_of(gks: &Gks, workstation: Gint, of: Gint) -> Option<Gfloat> {
    let background = || {
        let set = gks::ValueType::Set;
        gks.inquire_colour_representation(workstation, BACKGROUND.1, set).ok().map(|colour| colour.alpha)
    };
    match primitives(of) {
        Some(primitives) => gks.opacity(workstation, primitives).ok().map(|opacity| opacity as Gfloat),
        None if of == BACKGROUND.0 => background(),
        None => None,
    }
}
