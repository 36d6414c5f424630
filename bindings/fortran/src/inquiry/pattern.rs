//! Inquiries of patterns, whose cells go into an array of the program.

use crate::answer::{Clear, Output, TOO_SMALL, answer};
use crate::argument::Integer;
use gks::Function;
use gks_pipeline::item::Cells;
use gks_pipeline::tables::Pattern;
use std::ffi::c_int;

/// Where a pattern goes: its numbers of columns and rows, and an array of fixed numbers of them.
#[derive(Copy, Clone)]
struct Room {
    dx: Integer,
    dy: Integer,
    dimensions: [usize; 2],
    colia: Integer,
}

impl Clear for Room {
    fn clear(self) {
        self.dx.set(0);
        self.dy.set(0);
        self.colia.fill(self.dimensions[0].saturating_mul(self.dimensions[1]), 0);
    }
}

impl Output<Pattern> for Room {
    /// Where the array is too small, it takes the part that fits.
    fn put(self, value: Pattern) -> c_int {
        let [columns, rows] = self.dimensions;
        for (row, cells) in value.indices.chunks(value.columns).take(rows).enumerate() {
            self.colia.set_from(row * columns, cells.iter().copied().take(columns));
        }
        (self.dx, self.dy).put((value.columns, value.rows));
        if value.columns <= columns && value.rows <= rows { 0 } else { TOO_SMALL }
    }
}

fn owned(cells: &Cells<'_>) -> Pattern {
    let indices = (0..cells.rows).flat_map(|row| cells.row(row).iter().copied()).collect();
    Pattern { columns: cells.columns, rows: cells.rows, indices }
}

/// GQPAR: INQUIRE PATTERN REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gqpar_(
    wkid: Integer,
    pai: Integer,
    type_: Integer,
    dimx: Integer,
    dimy: Integer,
    errind: Integer,
    dx: Integer,
    dy: Integer,
    colia: Integer,
) {
    const F: Function = Function::InquirePatternRepresentation;
    let room = Room { dx, dy, dimensions: [dimx.count(), dimy.count()], colia };
    answer(F, errind, room, |gks| {
        let cells = gks.inquire_pattern_representation(wkid.get(), pai.get(), type_.choice(F)?)?;
        Ok(owned(&cells))
    });
}

/// GQPPAR: INQUIRE PREDEFINED PATTERN REPRESENTATION.
#[unsafe(no_mangle)]
extern "C" fn gqppar_(
    wtype: Integer,
    ppai: Integer,
    dimx: Integer,
    dimy: Integer,
    errind: Integer,
    dx: Integer,
    dy: Integer,
    colia: Integer,
) {
    const F: Function = Function::InquirePredefinedPatternRepresentation;
    let room = Room { dx, dy, dimensions: [dimx.count(), dimy.count()], colia };
    answer(F, errind, room, |gks| {
        Ok(owned(&gks.inquire_predefined_pattern_representation(wtype.get(), ppai.get())?))
    });
}
