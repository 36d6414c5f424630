//! What the ends of a lone line leave of pixels.

use glam::DVec2;

/// The ends of a line: how far the middle of the first pixel of the first step lies behind the beginning and before the end, and
/// half a pixel more; and by how much the next step and the next pixel are further on.
pub(super) struct Ends {
    begun: i64,
    left: i64,
    step: i64,
    pixel: i64,
}

impl Ends {
    /// Distances are counted in this part of a pixel, of which 64 are told apart in the end.
    const UNIT: f64 = (1u32 << (6 + Ends::FINER)) as f64;
    const FINER: u32 = 14;

    /// The ends of a line from a point in a direction, which caps make longer at both ends.
    #[inline]
    pub(super) fn new(from: DVec2, direction: DVec2, length: f64, longer: f64) -> Self {
        let begun = (0.5 - from).dot(direction) + longer + 0.5;
        let left = length + 2.0 * longer + 1.0 - begun;
        let fixed = |distance: f64| (distance * Ends::UNIT) as i64;
        Ends { begun: fixed(begun), left: fixed(left), step: fixed(direction.x), pixel: fixed(direction.y) }
    }

    /// Leaves of the four pixels of a step what lies between the ends; `step` and `first` are their numbers along and across
    /// the line.
    #[inline(always)]
    pub(super) fn leave(&self, step: i32, first: i32, samples: [u8; 4]) -> [u8; 4] {
        /// More than four pixels have.
        const FAR: i64 = 1024;
        let on = i64::from(step) * self.step + i64::from(first) * self.pixel;
        let parts = |distance: i64| (distance >> Ends::FINER).clamp(-FAR, FAR) as i16;
        let (begun, left, next) = (parts(self.begun + on), parts(self.left - on), parts(self.pixel));
        #[cfg(target_arch = "x86_64")]
        return wide::between(begun, left, next, samples);
        #[cfg(not(target_arch = "x86_64"))]
        return each::between(begun, left, next, samples);
    }
}

/// Parts of a pixel.
const ONE: i16 = 64;

/// One pixel after the other.
#[cfg(any(test, not(target_arch = "x86_64")))]
mod each {
    use super::ONE;

    /// What is left of samples of four pixels that lie so many parts of a pixel behind the beginning and before the end, the next
    /// one by `next` more.
    pub(super) fn between(begun: i16, left: i16, next: i16, samples: [u8; 4]) -> [u8; 4] {
        std::array::from_fn(|i| {
            let further = next * i as i16;
            let kept = (begun + further).clamp(0, ONE) + (left - further).clamp(0, ONE) - ONE;
            ((kept.max(0) * i16::from(samples[i]) + ONE / 2) >> ONE.trailing_zeros()) as u8
        })
    }
}

/// The same by the registers of eight numbers that every processor of this kind has: no branch that it could not foretell.
#[cfg(target_arch = "x86_64")]
mod wide {
    use super::ONE;
    use safe_arch::{
        add_i16_m128i, get_i32_from_m128i_s, m128i, max_i16_m128i, min_i16_m128i, mul_i16_keep_low_m128i,
        pack_i16_to_u8_m128i, set_i32_m128i_s, set_splat_i16_m128i, shr_imm_u16_m128i,
        shuffle_ai_f32_all_m128i, sub_saturating_u16_m128i, unpack_low_i8_m128i, unpack_low_i64_m128i,
        zeroed_m128i,
    };

    #[inline(always)]
    pub(super) fn between(begun: i16, left: i16, next: i16, samples: [u8; 4]) -> [u8; 4] {
        let zero = zeroed_m128i();
        // The four pixels twice: what of them the beginning and what the end leaves.
        let at = unpack_low_i64_m128i(set_splat_i16_m128i(begun), set_splat_i16_m128i(left));
        let further =
            mul_i16_keep_low_m128i(set_splat_i16_m128i(next), m128i::from([0i16, 1, 2, 3, 0, -1, -2, -3]));
        let kept = max_i16_m128i(min_i16_m128i(add_i16_m128i(at, further), set_splat_i16_m128i(ONE)), zero);
        let both = add_i16_m128i(kept, shuffle_ai_f32_all_m128i::<0b11_10_11_10>(kept));
        let kept = sub_saturating_u16_m128i(both, set_splat_i16_m128i(ONE));
        let samples = unpack_low_i8_m128i(set_i32_m128i_s(i32::from_le_bytes(samples)), zero);
        let product = add_i16_m128i(mul_i16_keep_low_m128i(kept, samples), set_splat_i16_m128i(ONE / 2));
        let counts = shr_imm_u16_m128i::<{ ONE.trailing_zeros() as i32 }>(product);
        get_i32_from_m128i_s(pack_i16_to_u8_m128i(counts, counts)).to_le_bytes()
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    #[test]
    fn every_way_leaves_the_same() {
        for begun in (-1024..=1024).step_by(23) {
            for left in (-1024..=1024).step_by(29) {
                for next in [-64, -45, -1, 0, 3, 20, 64] {
                    for samples in [[0, 1, 32, 64], [64, 64, 63, 2]] {
                        let expected = each::between(begun, left, next, samples);
                        assert_eq!(wide::between(begun, left, next, samples), expected);
                    }
                }
            }
        }
    }
}
