//! G. Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003: the random numbers of the tests.

use glam::{DVec2, IVec2};

/// A 64-bit xorshift generator; the same seed gives the same numbers everywhere.
pub(crate) struct Xorshift(u64);

impl Xorshift {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A whole number from `low` to `high`, both included.
    pub(crate) fn int(&mut self, low: i32, high: i32) -> i32 {
        let count = (i64::from(high) - i64::from(low) + 1) as u64;
        (i64::from(low) + ((self.bits() >> 11) % count) as i64) as i32
    }

    /// A real number from `low` up to `high`.
    pub(crate) fn real(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// A point with real coordinates from `low` up to `high`.
    pub(crate) fn point(&mut self, low: f64, high: f64) -> DVec2 {
        DVec2::new(self.real(low, high), self.real(low, high))
    }

    /// A point with whole coordinates from `low` to `high`.
    pub(crate) fn grid(&mut self, low: i32, high: i32) -> IVec2 {
        IVec2::new(self.int(low, high), self.int(low, high))
    }
}
