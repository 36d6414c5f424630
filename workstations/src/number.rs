//! Decimal numbers as text: rounded, exact and as short as possible, for formats that are made of numbers.
//!
//! Coordinates are rounded to integers first, counts of the smallest step that the format writes, and only
//! these integers become text. A driver that writes differences takes them between such integers, so that
//! rounding errors never add up.

/// The largest magnitude that is written; numbers beyond it are cut off at it.
pub const LARGEST: f64 = 1e9;

/// How numbers are written: with how many decimal places, and whether with a zero before the point.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Decimal {
    places: u32,
    bare: bool,
}

const POWERS: [f64; 10] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

impl Decimal {
    /// Numbers with at most `places` decimal places, of which no more than 9 are written.
    pub const fn new(places: u32) -> Self {
        Decimal { places: if places < 9 { places } else { 9 }, bare: false }
    }

    /// The same without the zero before the point: `.5` instead of `0.5`.
    pub const fn bare(self) -> Self {
        Decimal { bare: true, ..self }
    }

    /// How many steps make 1.
    pub const fn scale(self) -> f64 {
        POWERS[self.places as usize]
    }

    /// How many steps make 1, as a count.
    #[inline]
    pub const fn count(self) -> i64 {
        self.scale() as i64
    }

    /// The nearest number of steps, halves away from zero; 0 for what is not a number.
    #[inline]
    pub fn steps(self, value: f64) -> i64 {
        nearest(value, self.scale())
    }

    /// Writes a number.
    #[inline]
    pub fn write(self, out: &mut Vec<u8>, value: f64) {
        self.write_steps(out, self.steps(value));
    }

    /// Writes a number given in steps.
    #[inline]
    pub fn write_steps(self, out: &mut Vec<u8>, steps: i64) {
        match Word::EMPTY.number(self, steps) {
            Some(word) => word.write(out),
            None => self.write_long(out, steps),
        }
    }

    /// Writes a number digit by digit, however long it is.
    #[cold]
    fn write_long(self, out: &mut Vec<u8>, steps: i64) {
        let mut text = [0; 24];
        let mut at = text.len();
        let mut rest = steps.unsigned_abs();
        let mut places = self.places;
        while places > 0 && rest.is_multiple_of(10) {
            rest /= 10;
            places -= 1;
        }
        let mut put = |byte| {
            at -= 1;
            text[at] = byte;
        };
        if places > 0 {
            for _ in 0..places {
                put(b'0' + (rest % 10) as u8);
                rest /= 10;
            }
            put(b'.');
        }
        if rest > 0 || places == 0 || !self.bare {
            loop {
                put(b'0' + (rest % 10) as u8);
                rest /= 10;
                if rest == 0 {
                    break;
                }
            }
        }
        if steps < 0 {
            put(b'-');
        }
        out.extend_from_slice(&text[at..]);
    }
}

/// The whole number nearest to `value` times `scale`, halves away from zero; 0 for what is not a number.
#[inline]
pub(crate) fn nearest(value: f64, scale: f64) -> i64 {
    let scaled = value.clamp(-LARGEST, LARGEST) * scale;
    (scaled + 0.5_f64.copysign(scaled)) as i64
}

/// Up to 16 characters in a register: a number of at most 8 digits with what stands before and after it.
///
/// Copying a fixed number of bytes and cutting off what is too much is several times as fast as copying as
/// many as there are.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The characters, the first one in the lowest byte; zeros after the last one.
    bytes: u128,
    /// How many bits the characters take.
    bits: u32,
    /// Whether the last number has a fraction.
    fraction: bool,
}

/// The number of digits that a [`Word`] has room for.
const DIGITS: u32 = 8;

/// The character 0.
const ZERO: u32 = 0x30;

/// Eight times the character 0.
const ZEROS: u64 = 0x3030_3030_3030_3030;

impl Word {
    /// No character.
    pub const EMPTY: Word = Word { bytes: 0, bits: 0, fraction: false };

    /// With one more character.
    #[inline]
    #[must_use]
    pub const fn then(self, character: u8) -> Word {
        Word { bytes: self.bytes | (character as u128) << self.bits, bits: self.bits + 8, ..self }
    }

    /// With one more character on a condition.
    #[inline]
    #[must_use]
    pub const fn then_if(self, condition: bool, character: u8) -> Word {
        let character = character as u128 * condition as u128;
        Word { bytes: self.bytes | character << self.bits, bits: self.bits + 8 * condition as u32, ..self }
    }

    /// At most one character and a number of less than 1000 with 0 or 2 places, which fit into 8 bytes.
    #[inline(always)]
    pub(crate) fn short(decimal: Decimal, before: Option<u8>, steps: i64) -> Word {
        let count = steps.unsigned_abs();
        debug_assert!(matches!(decimal.places, 0 | 2) && count < 1000 * decimal.count() as u64);
        let negative = u32::from(steps < 0);
        let (before, mut bits) = before.map_or((0, 0), |character| (u64::from(character), 8));
        let mut text = before | u64::from(u32::from(b'-') * negative) << bits;
        bits += 8 * negative;
        let (integer, fraction) = match decimal.places {
            0 => (INTEGERS[count as usize % 10_000], 0),
            _ => (INTEGERS[count as usize / 100 % 10_000], FRACTIONS[count as usize % 100]),
        };
        let kept = u32::from(!decimal.bare | (fraction == 0) | (integer != ZERO));
        text |= u64::from(integer * kept) << bits;
        bits += length(integer) * kept;
        text |= u64::from(fraction) << (bits & 63);
        bits += length(fraction);
        Word { bytes: text.into(), bits, fraction: fraction != 0 }
    }

    /// With another word of at most 8 characters behind it.
    #[inline(always)]
    #[must_use]
    pub(crate) const fn followed_by(self, next: Word) -> Word {
        Word { bytes: self.bytes | next.bytes << self.bits, bits: self.bits + next.bits, ..next }
    }

    /// With a number given in steps; none if it has more than 8 digits.
    #[inline(always)]
    #[must_use]
    pub fn number(self, decimal: Decimal, steps: i64) -> Option<Word> {
        let count = steps.unsigned_abs();
        match decimal.places {
            0 if count < 10_000 => Some(self.signed(
                steps,
                INTEGERS[count as usize].into(),
                length(INTEGERS[count as usize]),
                false,
            )),
            2 if count < 1_000_000 => {
                let fraction = FRACTIONS[(count % 100) as usize];
                let integer = INTEGERS[(count / 100) as usize];
                let has_fraction = fraction != 0;
                let kept = u32::from(!decimal.bare | !has_fraction | (count >= 100));
                let (integer, bits) = (integer * kept, length(integer) * kept);
                let characters = u64::from(integer) | u64::from(fraction) << bits;
                Some(self.signed(steps, characters, bits + length(fraction), has_fraction))
            }
            _ => self.long_number(decimal, steps),
        }
    }

    /// With at most 7 characters of a number and its sign. Without branches, which nobody can predict here.
    #[inline]
    const fn signed(self, steps: i64, characters: u64, bits: u32, fraction: bool) -> Word {
        Word { fraction, ..self.then_if(steps < 0, b'-').join(characters, bits) }
    }

    /// [`Word::number`] for any number of places and digits.
    #[inline(never)]
    fn long_number(self, decimal: Decimal, steps: i64) -> Option<Word> {
        let count = u32::try_from(steps.unsigned_abs()).ok().filter(|count| *count < 100_000_000)?;
        if decimal.places >= DIGITS {
            return None;
        }
        let mut word = if steps < 0 { self.then(b'-') } else { self };
        let digits = digits(count);
        if decimal.places == 0 {
            let leading = if count == 0 { 8 * (DIGITS - 1) } else { digits.trailing_zeros() & !7 };
            word.fraction = false;
            return Some(word.join((digits | ZEROS) >> leading, 8 * DIGITS - leading));
        }
        // The integer part is in the lower bytes, the fraction in the upper ones.
        let point = 8 * (DIGITS - decimal.places);
        let integer = digits & ((1 << point) - 1);
        let fraction = digits >> point;
        let least = if decimal.bare && fraction != 0 { point } else { point - 8 };
        let leading = (integer.trailing_zeros() & !7).min(least);
        let integer = ((integer | ZEROS) & ((1 << point) - 1)) >> leading;
        word = word.join(integer, point - leading);
        word.fraction = fraction != 0;
        if !word.fraction {
            return Some(word);
        }
        let bits = (64 - fraction.leading_zeros()).next_multiple_of(8);
        let fraction = (fraction | ZEROS) << (64 - bits) >> (64 - bits);
        Some(word.then(b'.').join(fraction, bits))
    }

    /// Whether all characters have room.
    #[inline]
    pub const fn fits(self) -> bool {
        self.bits <= 128
    }

    /// Whether the last number has a fraction.
    #[inline]
    pub const fn has_fraction(self) -> bool {
        self.fraction
    }

    #[inline]
    const fn join(self, characters: u64, bits: u32) -> Word {
        Word { bytes: self.bytes | (characters as u128) << self.bits, bits: self.bits + bits, ..self }
    }

    /// Appends the characters to a text.
    #[inline]
    pub fn write(self, out: &mut Vec<u8>) {
        debug_assert!(self.fits(), "{self:?} is too long");
        let end = out.len() + (self.bits / 8) as usize;
        out.extend_from_slice(&self.bytes.to_le_bytes());
        out.truncate(end);
    }
}

/// The characters of the whole numbers below 10,000, the first one in the lowest byte.
static INTEGERS: [u32; 10_000] = {
    let mut all = [0; 10_000];
    let mut number = 0;
    while number < all.len() {
        let mut rest = number as u32;
        let mut characters = b'0' as u32 + rest % 10;
        while rest >= 10 {
            rest /= 10;
            characters = characters << 8 | (b'0' as u32 + rest % 10);
        }
        all[number] = characters;
        number += 1;
    }
    all
};

/// The characters of hundredths, from the point to the last digit that is not 0.
static FRACTIONS: [u32; 100] = {
    let mut all = [0; 100];
    let mut number = 1;
    while number < all.len() {
        let (tenths, hundredths) = (b'0' as u32 + number as u32 / 10, b'0' as u32 + number as u32 % 10);
        let last = if number % 10 == 0 { 0 } else { hundredths << 16 };
        all[number] = b'.' as u32 | tenths << 8 | last;
        number += 1;
    }
    all
};

/// How many bits characters take.
#[inline]
const fn length(characters: u32) -> u32 {
    (39 - characters.leading_zeros()) & !7
}

/// The digits of a number below 10^8, as numbers from 0 to 9, the first one in the lowest byte.
///
/// D. Khuong, "How to print integers really fast", 2017: numbers of 4, then 2 digits lie side by side in one
/// register and are divided at once, by multiplication.
#[inline]
const fn digits(count: u32) -> u64 {
    let fours = (count / 10_000) as u64 | ((count % 10_000) as u64) << 32;
    let hundreds = ((fours * 10_486) >> 20) & 0x0000_007f_0000_007f;
    let twos = hundreds | (fours - 100 * hundreds) << 16;
    let tens = ((twos * 103) >> 10) & 0x000f_000f_000f_000f;
    tens | (twos - 10 * tens) << 8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(format: Decimal, value: f64) -> String {
        let mut out = Vec::new();
        format.write(&mut out, value);
        String::from_utf8(out).unwrap()
    }

    /// What the formatter of the standard library says, without zeros at the end.
    fn reference(places: usize, value: f64) -> String {
        let long = format!("{value:.places$}");
        let short = if places > 0 { long.trim_end_matches('0').trim_end_matches('.') } else { &long };
        if short == "-0" { "0".to_owned() } else { short.to_owned() }
    }

    /// Pseudo-random numbers of all magnitudes that occur, the same on every run.
    fn values() -> impl Iterator<Item = f64> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        (0..200_000).map(move |i| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let unit = (state >> 11) as f64 / (1_u64 << 53) as f64;
            (unit - 0.5) * 10_f64.powi(i % 14 - 5)
        })
    }

    #[test]
    fn agrees_with_the_standard_library() {
        for places in 0..=9 {
            let format = Decimal::new(places);
            for value in values() {
                let (ours, theirs) = (text(format, value), reference(places as usize, value));
                if ours != theirs {
                    let beside_half = ((value * format.scale()).fract().abs() - 0.5).abs();
                    assert!(beside_half < 1e-6 * value.abs().max(1.0), "{value}: {ours}, not {theirs}");
                }
            }
        }
    }

    #[test]
    fn short_forms() {
        let two = Decimal::new(2);
        let cases = [
            (0.0, "0", "0"),
            (-0.0, "0", "0"),
            (-0.004, "0", "0"),
            (0.5, "0.5", ".5"),
            (-0.25, "-0.25", "-.25"),
            (0.005, "0.01", ".01"),
            (10.0, "10", "10"),
            (100.1, "100.1", "100.1"),
            (-1.999, "-2", "-2"),
            (0.05, "0.05", ".05"),
        ];
        for (value, long, short) in cases {
            assert_eq!(text(two, value), long);
            assert_eq!(text(two.bare(), value), short);
        }
        assert_eq!(text(Decimal::new(0), 2.5), "3");
    }

    #[test]
    fn words_are_what_is_written_digit_by_digit() {
        let mut counts: Vec<i64> = (0..20_000).chain(99_999_980..100_000_020).collect();
        counts.extend((0..100_000_000).step_by(9973));
        counts.extend([i64::MIN, i64::MAX, 4_294_967_296, 12_345_678_901]);
        for places in [0, 1, 2, 3, 5, 7, 8, 9] {
            for format in [Decimal::new(places), Decimal::new(places).bare()] {
                for steps in counts.iter().flat_map(|&count| [count, count.wrapping_neg()]) {
                    let (mut fast, mut slow) = (Vec::new(), Vec::new());
                    format.write_steps(&mut fast, steps);
                    format.write_long(&mut slow, steps);
                    assert_eq!(fast, slow, "{steps} {format:?}");
                }
            }
        }
        for format in [Decimal::new(0), Decimal::new(2), Decimal::new(2).bare()] {
            let shortest = 1000 * format.count();
            for steps in (1 - shortest)..shortest {
                for before in [None, Some(b' ')] {
                    let start = before.map_or(Word::EMPTY, |before| Word::EMPTY.then(before));
                    assert_eq!(
                        Some(Word::short(format, before, steps)),
                        start.number(format, steps),
                        "{steps}"
                    );
                }
            }
        }
        let word = Word::EMPTY.then(b'l').number(Decimal::new(2), -1_234_567).unwrap().then(b' ');
        let mut out = b"<".to_vec();
        word.write(&mut out);
        assert_eq!(out, b"<l-12345.67 ");
    }

    #[test]
    fn never_anything_but_digits() {
        for places in [0, 2, 9, 20] {
            let format = Decimal::new(places);
            assert_eq!(text(format, f64::NAN), "0");
            assert_eq!(text(format, f64::INFINITY), "1000000000");
            assert_eq!(text(format, f64::NEG_INFINITY), "-1000000000");
            assert_eq!(text(format, -1e300), "-1000000000");
            assert_eq!(text(format, 1e-300), "0");
        }
    }
}
