//! Cells of a row, eight at a time: their areas summed up, and what those cover of pixels.

use super::area_mask::{Gain, WHOLE};
use crate::path::Rule;

/// As many cells are summed up together.
pub(super) const GROUP: usize = 8;

/// How many of 255 parts of pixels are covered whose cells these are; `sum` is that of all cells before them, and of them too
/// afterwards.
#[inline(always)]
pub(super) fn covered(cells: [i32; GROUP], sum: &mut i32, look: (Rule, Gain)) -> [u8; GROUP] {
    #[cfg(target_arch = "x86_64")]
    return wide::covered(cells, sum, look);
    #[cfg(not(target_arch = "x86_64"))]
    return each::covered(cells, sum, look);
}

/// How many of 255 parts of pixels are covered where areas add up to `sums`.
#[inline(always)]
pub(super) fn parts<const N: usize>(sums: [i32; N], (rule, gain): (Rule, Gain)) -> [u8; N] {
    const {
        // Of 16 bits with a sign, which go from one whole pixel to the other.
        assert!(WHOLE >> 2 == 1 << 15);
    }
    sums.map(|sum| {
        let area = match rule {
            Rule::NonZero => (sum.unsigned_abs() >> 2).min(i16::MAX as u32) as i16,
            // What is more than one pixel turns around to less than none: of two pixels, all but what they have more.
            Rule::EvenOdd => ((sum.wrapping_abs() >> 2) as i16).saturating_abs(),
        };
        let area = if gain == Gain::Double { area.saturating_add(area) } else { area };
        // Rounded: 65 is a half of a part.
        ((u32::from(area as u16 + 65) * (2 * 255)) >> 16) as u8
    })
}

/// One cell after the other.
#[cfg(any(test, not(target_arch = "x86_64")))]
mod each {
    use super::{GROUP, Gain, Rule, parts};

    pub(super) fn covered(cells: [i32; GROUP], sum: &mut i32, look: (Rule, Gain)) -> [u8; GROUP] {
        let sums = cells.map(|cell| {
            *sum = sum.wrapping_add(cell);
            *sum
        });
        parts(sums, look)
    }
}

/// The same by the registers of four numbers that every processor of this kind has; compilers do not find the way to them.
#[cfg(target_arch = "x86_64")]
mod wide {
    use super::{GROUP, Gain, Rule};
    use safe_arch::{
        add_i16_m128i, add_i32_m128i, add_saturating_i16_m128i, bitxor_m128i, byte_shl_imm_u128_m128i,
        get_i32_from_m128i_s, get_i64_from_m128i_s, m128i, max_i16_m128i, mul_u16_keep_high_m128i,
        pack_i16_to_u8_m128i, pack_i32_to_i16_m128i, set_splat_i16_m128i, set_splat_i32_m128i,
        shl_imm_u32_m128i, shr_imm_i32_m128i, shr_imm_u32_m128i, shuffle_ai_f32_all_m128i, sub_i32_m128i,
        sub_saturating_i16_m128i, zeroed_m128i,
    };

    #[inline(always)]
    pub(super) fn covered(cells: [i32; GROUP], sum: &mut i32, (rule, gain): (Rule, Gain)) -> [u8; GROUP] {
        let [a, b, c, d, e, f, g, h] = cells;
        let low = add_i32_m128i(summed([a, b, c, d]), set_splat_i32_m128i(*sum));
        let high = add_i32_m128i(summed([e, f, g, h]), last(low));
        *sum = get_i32_from_m128i_s(last(high));
        let (low, high) = (absolute(low), absolute(high));
        let area = match rule {
            Rule::NonZero => pack_i32_to_i16_m128i(shr_imm_u32_m128i::<2>(low), shr_imm_u32_m128i::<2>(high)),
            Rule::EvenOdd => {
                let turned = |sums| shr_imm_i32_m128i::<16>(shl_imm_u32_m128i::<14>(sums));
                let area = pack_i32_to_i16_m128i(turned(low), turned(high));
                max_i16_m128i(area, sub_saturating_i16_m128i(zeroed_m128i(), area))
            }
        };
        let area = if gain == Gain::Double { add_saturating_i16_m128i(area, area) } else { area };
        let rounded = add_i16_m128i(area, set_splat_i16_m128i(65));
        let parts = mul_u16_keep_high_m128i(rounded, set_splat_i16_m128i(2 * 255));
        get_i64_from_m128i_s(pack_i16_to_u8_m128i(parts, parts)).to_le_bytes()
    }

    /// The sums of four numbers up to each of them.
    #[inline(always)]
    fn summed(numbers: [i32; 4]) -> m128i {
        let one = m128i::from(numbers);
        let two = add_i32_m128i(one, byte_shl_imm_u128_m128i::<4>(one));
        add_i32_m128i(two, byte_shl_imm_u128_m128i::<8>(two))
    }

    /// The last of four numbers four times.
    #[inline(always)]
    fn last(numbers: m128i) -> m128i {
        shuffle_ai_f32_all_m128i::<0xff>(numbers)
    }

    #[inline(always)]
    fn absolute(numbers: m128i) -> m128i {
        let sign = shr_imm_i32_m128i::<31>(numbers);
        sub_i32_m128i(bitxor_m128i(numbers, sign), sign)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xorshift::Xorshift;

    #[test]
    fn every_way_covers_alike() {
        let mut random = Xorshift::new(51);
        for most in [100, WHOLE, 5 * WHOLE, i32::MAX] {
            for _ in 0..2000 {
                let cells = std::array::from_fn(|_| random.int(-most, most));
                let start = random.int(-most, most);
                for rule in [Rule::EvenOdd, Rule::NonZero] {
                    for gain in [Gain::One, Gain::Double] {
                        let (mut one, mut other) = (start, start);
                        let expected = each::covered(cells, &mut one, (rule, gain));
                        assert_eq!(covered(cells, &mut other, (rule, gain)), expected, "{cells:?} {start}");
                        assert_eq!(one, other);
                    }
                }
            }
        }
        for sum in [i32::MIN, i32::MAX, 0, WHOLE, -WHOLE, 2 * WHOLE, WHOLE + 1] {
            let cells = [0; GROUP];
            for look in [(Rule::EvenOdd, Gain::One), (Rule::NonZero, Gain::Double)] {
                assert_eq!(covered(cells, &mut { sum }, look), parts([sum; GROUP], look), "{sum}");
            }
        }
    }

    #[test]
    fn parts_are_rounded_areas() {
        let part = |sum: i32, rule, gain| {
            let [part] = parts([sum], (rule, gain));
            part
        };
        for sum in (-3 * WHOLE..3 * WHOLE).step_by(7) {
            let whole = f64::from(WHOLE);
            let area = f64::from(sum).abs() / whole;
            let expected = |area: f64| area.min(1.0) * 255.0;
            let non_zero = part(sum, Rule::NonZero, Gain::One);
            let double = part(sum, Rule::NonZero, Gain::Double);
            let even_odd = part(sum, Rule::EvenOdd, Gain::One);
            let folded = (area % 2.0).min(2.0 - area % 2.0);
            for (found, area) in [(non_zero, area), (double, 2.0 * area), (even_odd, folded)] {
                assert!((f64::from(found) - expected(area)).abs() < 0.53, "{sum}: {found} {area}");
            }
        }
        for sum in [i32::MIN, i32::MAX] {
            assert_eq!(part(sum, Rule::NonZero, Gain::Double), 255);
        }
    }
}
