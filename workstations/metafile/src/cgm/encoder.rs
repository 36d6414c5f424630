//! What encoders of all encodings have in common.

use super::element::Element;

/// Writes elements.
pub trait Encoder: Send {
    /// Appends the code of an element.
    ///
    /// Parameters that do not fit into the row of the element are left out.
    fn encode(&mut self, element: &Element, out: &mut Vec<u8>);

    /// The precisions that the metafile descriptor states, in the order of the standard.
    fn precisions(&self) -> Vec<Element>;

    /// The precisions of coordinates that the metafile defaults replacement states.
    fn coordinate_precisions(&self) -> Vec<Element>;

    /// How coordinates are written.
    fn grid(&self) -> Grid;

    /// The largest colour index.
    fn most_colour(&self) -> u32;
}

/// How coordinates are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Whether they are real numbers.
    pub real: bool,
    /// How many units the longer side of a picture has, unless they are real and those of NDC.
    pub units: f64,
    /// The largest magnitude of a coordinate.
    pub most: f64,
}

/// How a writer codes coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinates {
    /// Integers of 16 bits, which every reader knows.
    Integer16,
    /// Integers of 32 bits.
    Integer32,
    /// Real numbers of double precision, which lose nothing.
    Real,
}

impl Coordinates {
    /// The grid of these coordinates.
    pub fn grid(self) -> Grid {
        match self {
            // Not negative in a picture, and with as much room around it as it takes itself.
            Coordinates::Integer16 => Grid { real: false, units: 16383.0, most: 32767.0 },
            // With three times as much room as the picture takes.
            Coordinates::Integer32 => Grid { real: false, units: f64::from(1 << 29), most: 2_147_483_647.0 },
            Coordinates::Real => Grid { real: true, units: 1.0, most: 1e6 },
        }
    }
}
