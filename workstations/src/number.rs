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

    /// The nearest number of steps, halves away from zero; 0 for what is not a number.
    #[inline]
    pub fn steps(self, value: f64) -> i64 {
        let scaled = value.clamp(-LARGEST, LARGEST) * self.scale();
        (scaled + 0.5_f64.copysign(scaled)) as i64
    }

    /// Writes a number.
    #[inline]
    pub fn write(self, out: &mut Vec<u8>, value: f64) {
        self.write_steps(out, self.steps(value));
    }

    /// Writes a number given in steps.
    pub fn write_steps(self, out: &mut Vec<u8>, steps: i64) {
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
