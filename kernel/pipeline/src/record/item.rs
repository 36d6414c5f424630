//! The items of a GKS metafile: which item stands for a record, and which fields its data have (ISO 7942,
//! annex E).
//!
//! How fields are coded is left to [`Put`] and [`Get`]. The coding of the kernel's own, [`Binary`] and
//! [`Bytes`], is what READ ITEM gives to programs and INTERPRET ITEM takes: integers of 4 and reals of 8
//! bytes, the least significant byte first.
//!
//! Some of what this library draws has no item in the standard. It becomes an ESCAPE item, which other
//! readers skip: line ends and corners, opacity, and that several primitives are one.

mod decode;
mod encode;
mod generalized;

pub use decode::{Convention, Decoder, Field};
pub use encode::encode;

/// Item types.
pub mod kind {
    macro_rules! kinds {
        ($($name:ident = $number:literal, $text:literal;)+) => {
            $(#[doc = $text] pub const $name: i32 = $number;)+

            /// The name that the standard has for the item of a type.
            pub const fn name(kind: i32) -> &'static str {
                match kind { $($number => $text,)+ _ => "USER ITEM" }
            }

            /// Whether the standard has an item of a type.
            pub const fn is_standard(kind: i32) -> bool {
                matches!(kind, $($number)|+)
            }
        };
    }

    kinds! {
        END = 0, "END ITEM";
        CLEAR = 1, "CLEAR WORKSTATION";
        REDRAW_ALL_SEGMENTS = 2, "REDRAW ALL SEGMENTS ON WORKSTATION";
        UPDATE = 3, "UPDATE WORKSTATION";
        DEFERRAL = 4, "DEFERRAL STATE";
        MESSAGE = 5, "MESSAGE";
        ESCAPE = 6, "ESCAPE";
        POLYLINE = 11, "POLYLINE";
        POLYMARKER = 12, "POLYMARKER";
        TEXT = 13, "TEXT";
        FILL_AREA = 14, "FILL AREA";
        CELL_ARRAY = 15, "CELL ARRAY";
        GENERALIZED = 16, "GENERALIZED DRAWING PRIMITIVE";
        LINE_INDEX = 21, "POLYLINE INDEX";
        LINETYPE = 22, "LINETYPE";
        LINE_WIDTH = 23, "LINEWIDTH SCALE FACTOR";
        LINE_COLOUR = 24, "POLYLINE COLOUR INDEX";
        MARKER_INDEX = 25, "POLYMARKER INDEX";
        MARKER_TYPE = 26, "MARKER TYPE";
        MARKER_SIZE = 27, "MARKER SIZE SCALE FACTOR";
        MARKER_COLOUR = 28, "POLYMARKER COLOUR INDEX";
        TEXT_INDEX = 29, "TEXT INDEX";
        TEXT_FONT = 30, "TEXT FONT AND PRECISION";
        CHARACTER_EXPANSION = 31, "CHARACTER EXPANSION FACTOR";
        CHARACTER_SPACING = 32, "CHARACTER SPACING";
        TEXT_COLOUR = 33, "TEXT COLOUR INDEX";
        CHARACTER_VECTORS = 34, "CHARACTER VECTORS";
        TEXT_PATH = 35, "TEXT PATH";
        TEXT_ALIGNMENT = 36, "TEXT ALIGNMENT";
        FILL_INDEX = 37, "FILL AREA INDEX";
        INTERIOR_STYLE = 38, "FILL AREA INTERIOR STYLE";
        FILL_STYLE = 39, "FILL AREA STYLE INDEX";
        FILL_COLOUR = 40, "FILL AREA COLOUR INDEX";
        PATTERN_SIZE = 41, "PATTERN SIZE";
        PATTERN_REFERENCE = 42, "PATTERN REFERENCE POINT";
        ASPECT_SOURCE_FLAGS = 43, "ASPECT SOURCE FLAGS";
        PICK_IDENTIFIER = 44, "PICK IDENTIFIER";
        LINE_REPRESENTATION = 51, "POLYLINE REPRESENTATION";
        MARKER_REPRESENTATION = 52, "POLYMARKER REPRESENTATION";
        TEXT_REPRESENTATION = 53, "TEXT REPRESENTATION";
        FILL_REPRESENTATION = 54, "FILL AREA REPRESENTATION";
        PATTERN_REPRESENTATION = 55, "PATTERN REPRESENTATION";
        COLOUR_REPRESENTATION = 56, "COLOUR REPRESENTATION";
        CLIPPING_RECTANGLE = 61, "CLIPPING RECTANGLE";
        WORKSTATION_WINDOW = 71, "WORKSTATION WINDOW";
        WORKSTATION_VIEWPORT = 72, "WORKSTATION VIEWPORT";
        CREATE_SEGMENT = 81, "CREATE SEGMENT";
        CLOSE_SEGMENT = 82, "CLOSE SEGMENT";
        RENAME_SEGMENT = 83, "RENAME SEGMENT";
        DELETE_SEGMENT = 84, "DELETE SEGMENT";
        SEGMENT_TRANSFORMATION = 91, "SET SEGMENT TRANSFORMATION";
        VISIBILITY = 92, "SET VISIBILITY";
        HIGHLIGHTING = 93, "SET HIGHLIGHTING";
        SEGMENT_PRIORITY = 94, "SET SEGMENT PRIORITY";
        DETECTABILITY = 95, "SET DETECTABILITY";
    }

    /// The last type that belongs to the standard; those above it are the applications'.
    pub const LAST: i32 = 100;
}

/// Where the fields of items go.
pub trait Put {
    /// Begins an item of a type.
    fn begin(&mut self, kind: i32);
    /// Adds an integer.
    fn integer(&mut self, value: i32);
    /// Adds a real.
    fn real(&mut self, value: f64);
    /// Adds characters.
    fn characters(&mut self, bytes: &[u8]);
    /// Ends the item.
    fn end(&mut self);
}

/// Where the fields of an item come from.
pub trait Get {
    /// The next integer.
    fn integer(&mut self) -> Result<i32, Unreadable>;
    /// The next real, which is finite.
    fn real(&mut self) -> Result<f64, Unreadable>;
    /// The next `count` characters.
    fn characters(&mut self, count: usize) -> Result<&[u8], Unreadable>;
    /// The characters that are left.
    fn rest(&mut self) -> &[u8];
    /// How many more fields there can be at most. A count is not believed beyond it.
    fn left(&self) -> usize;
}

/// Why the data of an item cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unreadable {
    /// The data end too early.
    #[error("the data are too short")]
    Short,
    /// A field is no number, or no value of its kind.
    #[error("{0}")]
    Value(String),
    /// There is no item of the type in the standard.
    #[error("there is no item type {0}")]
    Kind(i32),
}

impl Unreadable {
    /// A field with a value that makes no sense.
    pub fn value(what: &str, value: impl std::fmt::Display) -> Self {
        Unreadable::Value(format!("{what} {value}"))
    }
}

/// Items in the kernel's own coding.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Binary {
    /// Types and data, in order.
    pub items: Vec<(i32, Vec<u8>)>,
}

impl Binary {
    fn data(&mut self, bytes: &[u8]) {
        if let Some((_, data)) = self.items.last_mut() {
            data.extend_from_slice(bytes);
        }
    }
}

impl Put for Binary {
    fn begin(&mut self, kind: i32) {
        self.items.push((kind, Vec::new()));
    }

    fn integer(&mut self, value: i32) {
        self.data(&value.to_le_bytes());
    }

    fn real(&mut self, value: f64) {
        self.data(&value.to_le_bytes());
    }

    fn characters(&mut self, bytes: &[u8]) {
        self.data(bytes);
    }

    fn end(&mut self) {}
}

/// The data of an item in the kernel's own coding.
#[derive(Clone, Debug)]
pub struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    /// The fields in these bytes.
    pub fn new(bytes: &'a [u8]) -> Self {
        Bytes(bytes)
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], Unreadable> {
        let (first, rest) = self.0.split_first_chunk().ok_or(Unreadable::Short)?;
        self.0 = rest;
        Ok(*first)
    }
}

impl Get for Bytes<'_> {
    fn integer(&mut self) -> Result<i32, Unreadable> {
        Ok(i32::from_le_bytes(self.take()?))
    }

    fn real(&mut self) -> Result<f64, Unreadable> {
        finite(f64::from_le_bytes(self.take()?))
    }

    fn characters(&mut self, count: usize) -> Result<&[u8], Unreadable> {
        let (first, rest) = self.0.split_at_checked(count).ok_or(Unreadable::Short)?;
        self.0 = rest;
        Ok(first)
    }

    fn rest(&mut self) -> &[u8] {
        std::mem::take(&mut self.0)
    }

    fn left(&self) -> usize {
        self.0.len() / 4
    }
}

/// A real that is a number.
pub fn finite(value: f64) -> Result<f64, Unreadable> {
    if value.is_finite() { Ok(value) } else { Err(Unreadable::value("not a finite number:", value)) }
}

#[cfg(test)]
mod tests;
