//! Output primitives and ESCAPE.

use crate::argument::{Character, Integer, Real, integer};
use crate::call::{call, subroutines};
use crate::data_record::lines;
use crate::{ncar, xgks};
use gks::{DataRecord, Error, Function, Points};
use gks_instance::from_latin1;

subroutines! {
    gpl_(n: Integer, pxa: Real, pya: Real) Polyline => |gks| gks.polyline(points(n, pxa, pya));
    gpm_(n: Integer, pxa: Real, pya: Real) Polymarker => |gks| gks.polymarker(points(n, pxa, pya));
    gfa_(n: Integer, pxa: Real, pya: Real) FillArea => |gks| gks.fill_area(points(n, pxa, pya));
    gtx_(px: Real, py: Real, chars: Character, length: usize) Text
        => |gks| gks.text((px.real(), py.real()), &from_latin1(chars.slice(0, length)));
    gtxs_(px: Real, py: Real, lstr: Integer, chars: Character, length: usize) Text
        => |gks| gks.text((px.real(), py.real()), &from_latin1(chars.slice(0, length.min(lstr.count()))));
    ggdp_(n: Integer, pxa: Real, pya: Real, primid: Integer, ldr: Integer, datrec: Character, _length: usize)
        GeneralizedDrawingPrimitive => |gks| {
            // No primitive of this library takes a record; programs hand over what was never packed.
            let record = DataRecord::unpack(lines(ldr, datrec)).unwrap_or_default();
            gks.generalized_drawing_primitive(points(n, pxa, pya), primid.get(), &record)
        };
}

/// GCA: CELL ARRAY.
#[unsafe(no_mangle)]
extern "C" fn gca_(
    px: Real,
    py: Real,
    qx: Real,
    qy: Real,
    dimx: Integer,
    dimy: Integer,
    isc: Integer,
    isr: Integer,
    dx: Integer,
    dy: Integer,
    colia: Integer,
) {
    let part = Part::new([dimx, dimy], [isc, isr], [dx, dy]);
    let (p, q) = xgks::corners((px.real(), py.real()), (qx.real(), qy.real()));
    call(Function::CellArray, |gks| {
        gks.cell_array_of(p, q, part.cells(colia), part.columns, part.rows, part.stride)
    });
}

fn points<'a>(n: Integer, pxa: Real, pya: Real) -> Points<'a> {
    Points::SplitSingles(pxa.slice(0, n.count()), pya.slice(0, n.count()))
}

/// The part of a two-dimensional array that CELL ARRAY and SET PATTERN REPRESENTATION take.
pub(crate) struct Part {
    first: usize,
    pub(crate) columns: usize,
    pub(crate) rows: usize,
    pub(crate) stride: usize,
}

impl Part {
    /// The part of `size` cells from `start` on, counted from 1, of an array of `dimensions`; no cells at all
    /// if it is not inside. Columns come first everywhere.
    pub(crate) fn new(dimensions: [Integer; 2], start: [Integer; 2], size: [Integer; 2]) -> Self {
        let [dimensions, size] = [dimensions, size].map(|pair| pair.map(Integer::count));
        let start = start.map(|first| first.count().wrapping_sub(1));
        let is_inside =
            |i: usize| start[i] < dimensions[i] && (1..=dimensions[i] - start[i]).contains(&size[i]);
        if !(is_inside(0) && is_inside(1)) {
            return Part { first: 0, columns: 0, rows: 0, stride: 0 };
        }
        let first = start[1] * dimensions[0] + start[0];
        Part { first, columns: size[0], rows: size[1], stride: dimensions[0] }
    }

    /// The cells, from the first to the last one of the part.
    pub(crate) fn cells<'a>(&self, array: Integer) -> &'a [i32] {
        let whole_rows = self.rows.saturating_sub(1) * self.stride;
        array.slice(self.first, whole_rows + self.columns)
    }
}

/// GESC: ESCAPE. A record that GPREC has not packed counts as an empty one.
#[unsafe(no_mangle)]
extern "C" fn gesc_(
    fctid: Integer,
    lidr: Integer,
    idr: Character,
    mlodr: Integer,
    lodr: Integer,
    odr: Character,
    idr_length: usize,
    _odr_length: usize,
) {
    const F: Function = Function::Escape;
    let length = lidr.count().saturating_mul(idr_length);
    if ncar::escape(fctid.get(), (idr, length), mlodr, odr) {
        return;
    }
    let packed = call(F, |gks| {
        let record = DataRecord::unpack(lines(lidr, idr)).unwrap_or_default();
        let result = gks.escape(fctid.get(), &record)?;
        if result.is_empty() {
            return Ok(Vec::new());
        }
        result.pack(mlodr.count()).map_err(|error| Error { function: F, ..error })
    });
    if let Some(packed) = packed {
        lodr.set(integer(packed.len()));
        odr.set_from(0, packed.as_flattened().iter().copied());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(dimensions: [i32; 2], start: [i32; 2], size: [i32; 2]) -> (usize, usize, usize, usize) {
        let [mut dimensions, mut start, mut size] = [dimensions, start, size];
        let pair = |numbers: &mut [i32; 2]| {
            let (first, second) = numbers.split_at_mut(1);
            [Integer::of(first), Integer::of(second)]
        };
        let part = Part::new(pair(&mut dimensions), pair(&mut start), pair(&mut size));
        (part.first, part.columns, part.rows, part.stride)
    }

    #[test]
    fn parts_lie_inside_of_their_array() {
        assert_eq!(part([4, 3], [2, 2], [3, 2]), (5, 3, 2, 4));
        assert_eq!(part([4, 3], [4, 3], [1, 1]), (11, 1, 1, 4));
        let nothing = (0, 0, 0, 0);
        assert_eq!(part([4, 3], [2, 2], [4, 1]), nothing);
        assert_eq!(part([4, 3], [0, 1], [1, 1]), nothing);
        assert_eq!(part([4, 3], [1, 4], [1, 1]), nothing);
        assert_eq!(part([4, 3], [1, 1], [0, 1]), nothing);
        assert_eq!(part([-4, -3], [1, 1], [1, 1]), nothing);
        let most = i32::MAX;
        assert_eq!(part([most, most], [most, most], [most, most]), nothing);
    }

    #[test]
    fn cells_are_those_of_the_part() {
        let mut array: Vec<i32> = (0..12).collect();
        let part = Part { first: 5, columns: 2, rows: 2, stride: 4 };
        assert_eq!(part.cells(Integer::of(&mut array)), [5, 6, 7, 8, 9, 10]);
    }
}
