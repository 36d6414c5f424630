//! The precisions of the binary encoding (ISO/IEC 8632-3, 7).

use crate::cgm::element::{Element, Value};
use crate::generated::elements::Kind;

/// How real numbers are coded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RealFormat {
    /// 16 bits before and 16 bits after the binary point.
    Fixed32,
    /// 32 bits before and 32 bits after the binary point.
    Fixed64,
    /// Single precision of IEEE 754.
    Float32,
    /// Double precision of IEEE 754.
    Float64,
}

impl RealFormat {
    /// The format of the three parameters of a real precision.
    fn from_parameters(parameters: [i32; 3]) -> Option<RealFormat> {
        match parameters {
            [0, 9, 23] => Some(RealFormat::Float32),
            [0, 12, 52] => Some(RealFormat::Float64),
            [1, 16, 16] => Some(RealFormat::Fixed32),
            [1, 32, 32] => Some(RealFormat::Fixed64),
            _ => None,
        }
    }

    /// The three parameters of a real precision.
    pub fn parameters(self) -> [i32; 3] {
        match self {
            RealFormat::Float32 => [0, 9, 23],
            RealFormat::Float64 => [0, 12, 52],
            RealFormat::Fixed32 => [1, 16, 16],
            RealFormat::Fixed64 => [1, 32, 32],
        }
    }
}

/// The precisions in force: bits of integers, formats of reals.
#[derive(Clone, Debug, PartialEq)]
pub struct Precisions {
    /// Of integers.
    pub integer: u32,
    /// Of indices.
    pub index: u32,
    /// Of names.
    pub name: u32,
    /// Of components of direct colours.
    pub colour: u32,
    /// Of colour indices.
    pub colour_index: u32,
    /// Of real numbers.
    pub real: RealFormat,
    /// Of integer coordinates.
    pub vdc_integer: u32,
    /// Of real coordinates.
    pub vdc_real: RealFormat,
}

impl Default for Precisions {
    /// The defaults of the standard.
    fn default() -> Self {
        Precisions {
            integer: 16,
            index: 16,
            name: 16,
            colour: 8,
            colour_index: 8,
            real: RealFormat::Fixed32,
            vdc_integer: 16,
            vdc_real: RealFormat::Fixed32,
        }
    }
}

impl Precisions {
    /// Takes note of an element that sets a precision.
    pub fn observe(&mut self, element: &Element) {
        let bits = element.integer(0).and_then(|n| u32::try_from(n).ok());
        let whole = bits.filter(|bits| [8, 16, 24, 32].contains(bits));
        let real = || {
            let parameters = [element.integer(0)?, element.integer(1)?, element.integer(2)?];
            RealFormat::from_parameters(parameters)
        };
        match element.kind {
            Kind::IntegerPrecision => self.integer = whole.unwrap_or(self.integer),
            Kind::IndexPrecision => self.index = whole.unwrap_or(self.index),
            Kind::NamePrecision => self.name = whole.unwrap_or(self.name),
            Kind::ColourPrecision => self.colour = whole.unwrap_or(self.colour),
            Kind::ColourIndexPrecision => self.colour_index = whole.unwrap_or(self.colour_index),
            Kind::VdcIntegerPrecision => self.vdc_integer = whole.unwrap_or(self.vdc_integer),
            Kind::RealPrecision => self.real = real().unwrap_or(self.real),
            Kind::VdcRealPrecision => self.vdc_real = real().unwrap_or(self.vdc_real),
            _ => {}
        }
    }

    /// The element that sets a precision of whole bits.
    pub fn element(kind: Kind, bits: u32) -> Element {
        Element::new(kind, [Value::Integer(bits as i32)])
    }

    /// The element that sets a real precision.
    pub fn real_element(kind: Kind, format: RealFormat) -> Element {
        Element::new(kind, format.parameters().map(Value::Integer))
    }
}
