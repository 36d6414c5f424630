//! Items of metafiles as structures of XGKS, which its programs look into: a few numbers of four bytes, behind them in
//! some the address of an array, which lies in the same memory.
//!
//! The kernel has the data of an item as a sequence of integers of four and reals of eight bytes, least significant byte
//! first (`gks_pipeline::record::item`). The numbers are the same here and there, but for switches that XGKS counts the
//! other way round, and a few in another order.

use super::argument::{Address, integer};
use super::types::{Gfloat, Gint, Gpoint};
use gks_pipeline::record::item::{Bytes, Get, Unreadable, kind};

/// A number of a structure.
#[derive(Copy, Clone, Debug, PartialEq)]
enum Number {
    Integer,
    Real,
    /// An integer 0 or 1 that is the other one in the kernel.
    Inverted,
}

use Number::{Integer, Inverted, Real};

/// The array behind the numbers. How many elements it has says the last number, of cells the product of the last two.
#[derive(Copy, Clone, Debug, PartialEq)]
enum Array {
    Points,
    Cells,
    Characters,
}

/// The structure for the items of a type.
#[derive(Clone, Debug, PartialEq)]
struct Structure {
    numbers: Vec<Number>,
    /// For each number of the structure, which one of the kernel it is; empty if all are where they are in the kernel.
    order: &'static [usize],
    array: Option<Array>,
}

/// The structure for a type of items; none for those that stay bytes: ESCAPE and the generalized drawing primitive, which
/// XGKS does not have, and items of programs.
fn structure(item: i32) -> Option<Structure> {
    let plain = |numbers: &[Number]| Some(Structure { numbers: numbers.to_vec(), order: &[], array: None });
    let ordered =
        |numbers: &[Number], order| Some(Structure { numbers: numbers.to_vec(), order, array: None });
    let before = |numbers: &[Number], array| {
        Some(Structure { numbers: numbers.to_vec(), order: &[], array: Some(array) })
    };
    match item {
        kind::END | kind::REDRAW_ALL_SEGMENTS | kind::CLOSE_SEGMENT => plain(&[]),
        kind::UPDATE => plain(&[Inverted]),
        kind::VISIBILITY => plain(&[Integer, Inverted]),
        kind::DEFERRAL
        | kind::TEXT_FONT
        | kind::TEXT_ALIGNMENT
        | kind::RENAME_SEGMENT
        | kind::HIGHLIGHTING
        | kind::DETECTABILITY => plain(&[Integer, Integer]),
        kind::LINE_WIDTH | kind::MARKER_SIZE | kind::CHARACTER_EXPANSION | kind::CHARACTER_SPACING => {
            plain(&[Real])
        }
        kind::CHARACTER_VECTORS
        | kind::PATTERN_SIZE
        | kind::CLIPPING_RECTANGLE
        | kind::WORKSTATION_WINDOW
        | kind::WORKSTATION_VIEWPORT => plain(&[Real; 4]),
        kind::PATTERN_REFERENCE => plain(&[Real; 2]),
        kind::ASPECT_SOURCE_FLAGS => plain(&[Integer; 13]),
        kind::LINE_REPRESENTATION | kind::MARKER_REPRESENTATION => {
            ordered(&[Integer, Integer, Integer, Real], &[0, 1, 3, 2])
        }
        kind::TEXT_REPRESENTATION => {
            ordered(&[Integer, Integer, Integer, Integer, Real, Real], &[0, 1, 2, 5, 3, 4])
        }
        kind::FILL_REPRESENTATION => plain(&[Integer; 4]),
        kind::COLOUR_REPRESENTATION => plain(&[Integer, Real, Real, Real]),
        kind::SEGMENT_TRANSFORMATION => plain(&[Integer, Real, Real, Real, Real, Real, Real]),
        kind::SEGMENT_PRIORITY => plain(&[Integer, Real]),
        kind::MESSAGE => before(&[Integer], Array::Characters),
        kind::POLYLINE | kind::POLYMARKER | kind::FILL_AREA => before(&[Integer], Array::Points),
        kind::TEXT => before(&[Real, Real, Integer], Array::Characters),
        kind::CELL_ARRAY => before(&[Real, Real, Real, Real, Real, Real, Integer, Integer], Array::Cells),
        kind::PATTERN_REPRESENTATION => before(&[Integer; 3], Array::Cells),
        _ if kind::is_standard(item) && item != kind::ESCAPE && item != kind::GENERALIZED => {
            plain(&[Integer])
        }
        _ => None,
    }
}

/// Bytes of a number of a structure.
type Cell = [u8; 4];

/// The bytes of an address.
const ADDRESS: usize = size_of::<usize>();

impl Structure {
    /// Where the address of the array is.
    fn address(&self) -> usize {
        (4 * self.numbers.len()).next_multiple_of(ADDRESS)
    }

    /// Where the array is, or the end.
    fn end(&self) -> usize {
        if self.array.is_some() { self.address() + ADDRESS } else { 4 * self.numbers.len() }
    }

    /// The numbers in the order of the kernel: for each one its place in the structure, and what it is.
    fn in_kernel_order(&self) -> impl Iterator<Item = (usize, Number)> {
        let place = |from| match self.order {
            [] => from,
            order => order.iter().position(|&of| of == from).unwrap_or(from),
        };
        (0..self.numbers.len()).map(move |from| (place(from), self.numbers[place(from)]))
    }

    /// How many elements the array has.
    fn count(&self, cells: &[Cell]) -> Gint {
        let number = |back: usize| {
            let at = cells.len().checked_sub(back);
            at.and_then(|at| cells.get(at)).map_or(0, |&cell| Gint::from_ne_bytes(cell))
        };
        match self.array {
            None => 0,
            Some(Array::Cells) => number(1).saturating_mul(number(2)),
            Some(Array::Points | Array::Characters) => number(1),
        }
    }
}

/// How many bytes of a program an item takes that has so many bytes in the kernel.
pub(super) fn length(item: i32, kernel: usize) -> usize {
    let Some(structure) = structure(item) else { return kernel };
    let numbers = structure.numbers.iter().map(|&number| if number == Real { 8 } else { 4 }).sum();
    let rest = kernel.saturating_sub(numbers);
    structure.end()
        + match structure.array {
            None => 0,
            Some(Array::Characters) => rest + 1,
            Some(Array::Cells) => rest,
            Some(Array::Points) => rest / 2,
        }
}

/// The data of an item of the kernel as a structure at an address of the program.
pub(super) fn structured(item: i32, data: &[u8], to: Address<u8>) -> Result<Vec<u8>, Unreadable> {
    let Some(structure) = structure(item) else { return Ok(data.to_vec()) };
    let mut get = Bytes::new(data);
    let mut cells = vec![Cell::default(); structure.numbers.len()];
    for (at, number) in structure.in_kernel_order() {
        cells[at] = match number {
            Integer => get.integer()?.to_ne_bytes(),
            Inverted => Gint::from(get.integer()? == 0).to_ne_bytes(),
            Real => (get.real()? as Gfloat).to_ne_bytes(),
        };
    }
    let mut bytes = cells.concat();
    let Some(array) = structure.array else { return Ok(bytes) };
    bytes.resize(structure.address(), 0);
    bytes.extend(to.after(structure.end()).to_ne_bytes());
    match array {
        Array::Characters => {
            bytes.extend(get.rest());
            bytes.push(0);
        }
        Array::Cells => {
            while get.left() > 0 {
                bytes.extend(get.integer()?.to_ne_bytes());
            }
        }
        Array::Points => {
            while get.left() > 0 {
                bytes.extend((get.real()? as Gfloat).to_ne_bytes());
            }
        }
    }
    Ok(bytes)
}

/// The data that the kernel has for an item whose structure the program has at an address, or whose bytes if it is of a
/// type that has none.
pub(super) fn kernel_data(item: i32, length: Gint, from: Address<u8>) -> Vec<u8> {
    let Some(structure) = structure(item) else { return from.array(length).to_vec() };
    let room = if structure.numbers.is_empty() { 0 } else { structure.end() };
    let bytes = from.array(integer(room));
    let cells: Vec<Cell> = bytes.as_chunks().0.iter().take(structure.numbers.len()).copied().collect();
    let mut data = Vec::new();
    for (at, number) in structure.in_kernel_order() {
        let Some(&cell) = cells.get(at) else { return data };
        match number {
            Integer => data.extend(Gint::from_ne_bytes(cell).to_le_bytes()),
            Inverted => data.extend(Gint::from(Gint::from_ne_bytes(cell) == 0).to_le_bytes()),
            Real => data.extend(f64::from(Gfloat::from_ne_bytes(cell)).to_le_bytes()),
        }
    }
    let Some(array) = structure.array else { return data };
    let address = bytes.get(structure.address()..).and_then(|bytes| bytes.first_chunk());
    let address = address.map_or(0, |&bytes| usize::from_ne_bytes(bytes));
    let count = structure.count(&cells);
    match array {
        Array::Characters => data.extend(Address::<u8>::to(address).array(count)),
        Array::Cells => {
            let cells = Address::<Gint>::to(address).array(count);
            data.extend(cells.iter().flat_map(|cell| cell.to_le_bytes()));
        }
        Array::Points => {
            let points = Address::<Gpoint>::to(address).array(count);
            let numbers = points.iter().flat_map(|p| [p.x, p.y]).map(f64::from);
            data.extend(numbers.flat_map(f64::to_le_bytes));
        }
    }
    data
}
