//! Operands out of characters.

use super::RealCoding;

/// The operands of an element that are left: all characters up to the next opcode, strings included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Operands<'a> {
    rest: &'a [u8],
}

/// The bit that characters of operands have and opcodes do not.
pub(super) const OPERAND: u8 = 0x40;
const MORE: u8 = 0x20;
const NEGATIVE: u8 = 0x10;
const EXPONENT: u8 = 0x08;

/// The character that begins displacements in chain code.
const CHAIN: u8 = 0x50;

impl<'a> Operands<'a> {
    pub(super) fn new(characters: &'a [u8]) -> Operands<'a> {
        Operands { rest: characters }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The next character, if it belongs to a number.
    pub(super) fn character(&mut self) -> Option<u8> {
        let (&first, rest) = self.rest.split_first()?;
        if first & OPERAND == 0 {
            return None;
        }
        self.rest = rest;
        Some(first & 0x7f)
    }

    /// Magnitude, sign, and whether an exponent follows.
    fn number(&mut self, real: bool) -> Option<(i64, bool)> {
        let mut character = self.character()?;
        let negative = character & NEGATIVE != 0;
        let follows = real && character & EXPONENT != 0;
        let mut magnitude = i64::from(character & if real { 0x07 } else { 0x0f });
        while character & MORE != 0 {
            character = self.character()?;
            magnitude = magnitude.checked_mul(32)? | i64::from(character & 0x1f);
        }
        Some((if negative { -magnitude } else { magnitude }, follows))
    }

    /// How many characters are left.
    pub(super) fn len(&self) -> usize {
        self.rest.len()
    }

    pub(super) fn integer(&mut self) -> Option<i64> {
        self.number(false).map(|(number, _)| number)
    }

    /// A real number; its exponent is taken over to the next one if `last` is given.
    pub(super) fn real(&mut self, coding: RealCoding, last: Option<&mut i32>) -> Option<f64> {
        let (mantissa, follows) = self.number(coding.explicit)?;
        let mut exponent = last.as_ref().map_or(coding.exponent, |last| **last);
        if follows {
            exponent = self.integer()?.clamp(-2000, 2000) as i32;
        }
        if let Some(last) = last {
            *last = exponent;
        }
        Some(mantissa as f64 * f64::from(exponent).exp2())
    }

    /// Whether displacements in chain code follow.
    pub(super) fn is_chain(&self) -> bool {
        self.rest.first() == Some(&CHAIN)
    }

    /// Red, green and blue, two bits of each in a character.
    pub(super) fn components(&mut self, bits: u32) -> Option<[f64; 3]> {
        let mut components = [0u32; 3];
        for _ in 0..bits.div_ceil(2) {
            let character = u32::from(self.character()?);
            for (i, component) in components.iter_mut().enumerate() {
                let (high, low) = (character >> (5 - i) & 1, character >> (2 - i) & 1);
                *component = *component << 2 | high << 1 | low;
            }
        }
        // Of an odd number of bits the last one is not used.
        Some(components.map(|component| f64::from(component >> (bits % 2))))
    }

    /// The characters of a string.
    pub(super) fn string(&mut self) -> Option<Vec<u8>> {
        let (eight_bits, rest) = match self.rest {
            [0x98, rest @ ..] => (true, rest),
            [0x1b, b'X', rest @ ..] => (false, rest),
            _ => return None,
        };
        self.rest = rest;
        let mut text = Vec::new();
        loop {
            match self.rest {
                [0x9c, rest @ ..] if eight_bits => {
                    self.rest = rest;
                    return Some(text);
                }
                [0x1b, b'\\', rest @ ..] => {
                    self.rest = rest;
                    return Some(text);
                }
                [first, rest @ ..] => {
                    text.push(*first);
                    self.rest = rest;
                }
                [] => return Some(text),
            }
        }
    }
}

/// Bits out of characters, six of each.
pub(super) struct Bits<'o, 'a> {
    operands: &'o mut Operands<'a>,
    character: u8,
    left: u32,
}

impl<'o, 'a> Bits<'o, 'a> {
    pub(super) fn new(operands: &'o mut Operands<'a>) -> Self {
        Bits { operands, character: 0, left: 0 }
    }

    pub(super) fn next(&mut self, bits: u32) -> Option<u32> {
        let mut number = 0u32;
        for _ in 0..bits {
            if self.left == 0 {
                self.character = self.operands.character()?;
                self.left = 6;
            }
            self.left -= 1;
            number = number << 1 | u32::from(self.character >> self.left & 1);
        }
        Some(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_continue_from_character_to_character() {
        let mut operands = Operands::new(&[0x45, 0x55, 0x61, 0x42, 0x20]);
        assert_eq!(
            (operands.integer(), operands.integer(), operands.integer()),
            (Some(5), Some(-5), Some(34))
        );
        assert_eq!((operands.integer(), operands.is_empty()), (None, false));
        // The mantissa 3 and the exponent -1.
        let mut operands = Operands::new(&[0x4b, 0x51, 0x43]);
        let coding = RealCoding { exponent: 2, explicit: true };
        assert_eq!((operands.real(coding, None), operands.real(coding, None)), (Some(1.5), Some(12.0)));
    }

    #[test]
    fn colours_are_interleaved() {
        // Red 11, green 00, blue 01 in one character.
        assert_eq!(Operands::new(&[0x40 | 0b10_0101]).components(2), Some([3.0, 0.0, 1.0]));
        assert_eq!(Operands::new(&[]).components(2), None);
    }

    #[test]
    fn strings_end_with_their_terminator() {
        let mut operands = Operands::new(b"\x1bXab\x1b\\C");
        assert_eq!(operands.string().as_deref(), Some(&b"ab"[..]));
        assert_eq!(operands.integer(), Some(3));
    }
}
