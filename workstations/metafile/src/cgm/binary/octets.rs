//! Numbers, strings and bits out of the octets of an element (ISO/IEC 8632-3, 6).

use super::precision::RealFormat;

/// What is left of the octets of an element.
#[derive(Clone, Copy, Debug)]
pub struct Octets<'a> {
    rest: &'a [u8],
}

impl<'a> Octets<'a> {
    /// All of some octets.
    pub fn new(octets: &'a [u8]) -> Octets<'a> {
        Octets { rest: octets }
    }

    /// How many are left.
    pub fn len(&self) -> usize {
        self.rest.len()
    }

    /// Whether none is left.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The next `count` octets.
    pub fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(taken)
    }

    /// All that is left.
    pub fn take_all(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.rest)
    }

    /// An unsigned number of 8, 16, 24 or 32 bits.
    pub fn unsigned(&mut self, bits: u32) -> Option<u32> {
        let octets = self.take(bits as usize / 8)?;
        Some(octets.iter().fold(0, |number, &octet| number << 8 | u32::from(octet)))
    }

    /// A signed number of 8, 16, 24 or 32 bits.
    pub fn signed(&mut self, bits: u32) -> Option<i32> {
        let number = self.unsigned(bits)?;
        let unused = 32 - bits;
        Some((number << unused) as i32 >> unused)
    }

    /// A real number.
    pub fn real(&mut self, format: RealFormat) -> Option<f64> {
        Some(match format {
            RealFormat::Fixed32 => {
                let whole = self.signed(16)?;
                f64::from(whole) + f64::from(self.unsigned(16)?) / 65536.0
            }
            RealFormat::Fixed64 => {
                let whole = self.signed(32)?;
                f64::from(whole) + f64::from(self.unsigned(32)?) / 4_294_967_296.0
            }
            RealFormat::Float32 => f64::from(f32::from_bits(self.unsigned(32)?)),
            RealFormat::Float64 => {
                let high = u64::from(self.unsigned(32)?);
                f64::from_bits(high << 32 | u64::from(self.unsigned(32)?))
            }
        })
    }

    /// A string: a count and octets, or parts of up to 32767 octets each. What is there of one that is cut off.
    pub fn string(&mut self) -> Option<Vec<u8>> {
        let count = self.unsigned(8)? as usize;
        if count < 255 {
            return Some(self.up_to(count).to_vec());
        }
        let mut whole = Vec::new();
        loop {
            let word = self.unsigned(16)? as usize;
            whole.extend_from_slice(self.up_to(word & 0x7fff));
            if word & 0x8000 == 0 {
                return Some(whole);
            }
        }
    }

    fn up_to(&mut self, count: usize) -> &'a [u8] {
        self.take(count.min(self.rest.len())).unwrap_or_default()
    }
}

/// Unsigned numbers of 1 to 32 bits in a row.
#[derive(Clone, Copy, Debug)]
pub struct Bits<'a> {
    octets: &'a [u8],
    /// The next bit.
    at: usize,
}

impl<'a> Bits<'a> {
    /// The bits of octets, highest first.
    pub fn new(octets: &'a [u8]) -> Bits<'a> {
        Bits { octets, at: 0 }
    }

    /// The next number.
    pub fn next(&mut self, bits: u32) -> Option<u32> {
        let mut number = 0u32;
        for _ in 0..bits {
            let octet = *self.octets.get(self.at / 8)?;
            number = number << 1 | u32::from(octet >> (7 - self.at % 8) & 1);
            self.at += 1;
        }
        Some(number)
    }

    /// Goes on at the next multiple of some bits.
    pub fn align(&mut self, bits: usize) {
        self.at = self.at.next_multiple_of(bits);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_precision() {
        let octets = [0xff, 0xff, 0xfe, 0xff, 0xfe, 0x80, 0x00];
        let mut all = Octets::new(&octets);
        assert_eq!(all.signed(8), Some(-1));
        assert_eq!(all.signed(16), Some(-2));
        assert_eq!(all.real(RealFormat::Fixed32), Some(-1.5));
        assert_eq!((all.is_empty(), all.signed(16)), (true, None));
        let mut all = Octets::new(&[0x3f, 0xc0, 0, 0, 0xff, 0x12, 0x34]);
        assert_eq!(all.real(RealFormat::Float32), Some(1.5));
        assert_eq!(all.unsigned(24), Some(0xff_1234));
    }

    #[test]
    fn long_strings_come_in_parts() {
        let mut octets = vec![255, 0x80, 2, b'a', b'b', 0, 1, b'c', 9];
        assert_eq!(Octets::new(&octets).string().as_deref(), Some(&b"abc"[..]));
        octets.truncate(4);
        assert_eq!(Octets::new(&octets).string(), None);
        assert_eq!(Octets::new(b"\x05ab").string().as_deref(), Some(&b"ab"[..]));
    }

    #[test]
    fn bits_are_read_from_the_highest() {
        let mut bits = Bits::new(&[0b1010_0110, 0, 0xff]);
        assert_eq!((bits.next(1), bits.next(2), bits.next(4)), (Some(1), Some(1), Some(3)));
        bits.align(16);
        assert_eq!((bits.next(8), bits.next(1)), (Some(255), None));
    }
}
