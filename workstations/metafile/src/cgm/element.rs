//! Elements with their parameters, in no encoding.

use crate::generated::elements::{ELEMENTS, Kind, Row};
use gks_pipeline::colour::Colour;
use glam::DVec2;

/// An element: what an encoding codes and an interpreter acts on.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Which element.
    pub kind: Kind,
    /// Its parameters, of the types in the element's row. A decoder leaves out what the data lacks.
    pub values: Vec<Value>,
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// An integer, an index, a name or an enumeration.
    Integer(i32),
    /// A real number or a coordinate.
    Real(f64),
    /// A point in virtual device coordinates.
    Point(DVec2),
    /// A list of points.
    Points(Vec<DVec2>),
    /// The bytes of a string.
    Text(Vec<u8>),
    /// A data record, or what is not interpreted.
    Data(Vec<u8>),
    /// A colour.
    Ink(Ink),
    /// An array of colours.
    Cells(Cells),
}

/// A colour of either kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ink {
    /// An index into the colour table.
    Index(u32),
    /// A direct colour.
    Direct(Colour),
}

/// An array of colours, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// Number of columns.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// The colours: as many as columns times rows.
    pub inks: Inks,
}

/// The colours of an array.
#[derive(Clone, Debug, PartialEq)]
pub enum Inks {
    /// Colour indices.
    Indices(Vec<i32>),
    /// Direct colours.
    Direct(Vec<[u8; 3]>),
}

/// The most cells that a few octets may stand for: an array of 2048 by 2048. With their images as colour indices, twice
/// as many numbers are held.
pub const MOST_CELLS: usize = 1 << 22;

/// The most cells that so many octets may stand for in runs.
pub(super) fn most_cells(octets: usize) -> usize {
    MOST_CELLS.max(octets.saturating_mul(64))
}

/// Appends a value several times to a list for which storage of more than `most` values is not set aside unless there
/// are more.
pub(super) fn repeat<T: Clone>(list: &mut Vec<T>, value: T, count: usize, most: usize) {
    let length = list.len() + count;
    if length > list.capacity() {
        let capacity = length.max((2 * list.capacity()).min(most));
        list.reserve_exact(capacity - list.len());
    }
    list.resize(length, value);
}

impl Inks {
    /// The number of colours.
    pub fn len(&self) -> usize {
        match self {
            Inks::Indices(indices) => indices.len(),
            Inks::Direct(colours) => colours.len(),
        }
    }

    /// Whether there is no colour.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Element {
    /// The element with some parameters.
    pub fn new(kind: Kind, values: impl Into<Vec<Value>>) -> Element {
        Element { kind, values: values.into() }
    }

    /// The parameter at a place as an integer.
    pub fn integer(&self, place: usize) -> Option<i32> {
        match self.values.get(place)? {
            Value::Integer(value) => Some(*value),
            _ => None,
        }
    }

    /// The parameter at a place as a finite real number.
    pub fn real(&self, place: usize) -> Option<f64> {
        match self.values.get(place)? {
            Value::Real(value) => Some(*value).filter(|value| value.is_finite()),
            _ => None,
        }
    }

    /// The two parameters from a place on as a vector.
    pub fn vector(&self, place: usize) -> Option<DVec2> {
        Some(DVec2::new(self.real(place)?, self.real(place + 1)?))
    }

    /// The parameter at a place as a point with finite coordinates.
    pub fn point(&self, place: usize) -> Option<DVec2> {
        match self.values.get(place)? {
            Value::Point(point) => Some(*point).filter(|point| point.is_finite()),
            _ => None,
        }
    }

    /// The parameter at a place as a list of points.
    pub fn points(&self, place: usize) -> Option<&[DVec2]> {
        match self.values.get(place)? {
            Value::Points(points) => Some(points),
            _ => None,
        }
    }

    /// The parameter at a place as bytes.
    pub fn bytes(&self, place: usize) -> Option<&[u8]> {
        match self.values.get(place)? {
            Value::Text(bytes) | Value::Data(bytes) => Some(bytes),
            _ => None,
        }
    }

    /// The parameter at a place as a colour.
    pub fn ink(&self, place: usize) -> Option<Ink> {
        match self.values.get(place)? {
            Value::Ink(ink) => Some(*ink),
            _ => None,
        }
    }

    /// The parameter at a place as an array of colours.
    pub fn cells(&self, place: usize) -> Option<&Cells> {
        match self.values.get(place)? {
            Value::Cells(cells) => Some(cells),
            _ => None,
        }
    }
}

impl Kind {
    /// The row of the element.
    pub fn row(self) -> &'static Row {
        &ELEMENTS[self as usize]
    }
}

/// The row of a code of the binary encoding.
pub fn by_code(class: u8, id: u8) -> Option<&'static Row> {
    let place = ELEMENTS.binary_search_by_key(&(class, id), |row| (row.class, row.id)).ok()?;
    ELEMENTS.get(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_their_codes_and_kinds() {
        for row in &ELEMENTS {
            assert_eq!(row.kind.row(), row);
            assert_eq!(by_code(row.class, row.id), Some(row));
        }
        assert_eq!(by_code(4, 127), None);
    }
}
