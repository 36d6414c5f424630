//! The character encoding (ISO 8632-2 of 1987, since withdrawn), as its public implementations have it.
//!
//! Opcodes are characters of columns 2 and 3, operands characters of columns 4 to 7 with six bits of data. An integer
//! has a bit that says whether more follows, in its first character a sign, and five bits in each further character; a
//! real number is an integer with an exponent of 2. Points follow one another as displacements. Strings stand between
//! START OF STRING and STRING TERMINATOR.

pub mod decoder;
pub mod encoder;
mod operand;

/// How real numbers are coded: the exponents of 2 that they have.
#[derive(Clone, Copy, Debug, PartialEq)]
struct RealCoding {
    /// The exponent where none is written.
    exponent: i32,
    /// Whether an exponent may be written.
    explicit: bool,
}

impl RealCoding {
    /// Where no precision is stated: fractions of ten bits.
    const DEFAULT: RealCoding = RealCoding { exponent: -10, explicit: false };
}
