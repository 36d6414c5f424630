//! Four pixels at a time on the way to an opaque colour.

use super::composite::Pixel;

/// Four pixels on the way to a colour, as far as numbers of samples say, of which a pixel has 64.
#[inline(always)]
pub(super) fn mixed(above: Pixel, below: [Pixel; 4], samples: [u8; 4]) -> [Pixel; 4] {
    #[cfg(target_arch = "x86_64")]
    return wide::mixed(above, below, samples);
    #[cfg(not(target_arch = "x86_64"))]
    return each::mixed(above, below, samples);
}

/// One byte after the other.
#[cfg(any(test, not(target_arch = "x86_64")))]
mod each {
    use super::Pixel;
    use gks_algorithms::coverage::SAMPLES;

    pub(super) fn mixed(above: Pixel, below: [Pixel; 4], samples: [u8; 4]) -> [Pixel; 4] {
        std::array::from_fn(|pixel| {
            std::array::from_fn(|byte| {
                let (above, below) = (i16::from(above[byte]), i16::from(below[pixel][byte]));
                let way = (above - below) * i16::from(samples[pixel]) + SAMPLES as i16 / 2;
                (below + (way >> SAMPLES.trailing_zeros())) as u8
            })
        })
    }
}

/// The same by the registers of sixteen bytes that every processor of this kind has; compilers put pixels that are not
/// neighbours into memory in between.
#[cfg(target_arch = "x86_64")]
mod wide {
    use super::Pixel;
    use gks_algorithms::coverage::SAMPLES;
    use safe_arch::{
        add_i16_m128i, m128i, mul_i16_keep_low_m128i, pack_i16_to_u8_m128i, set_i32_m128i_s,
        set_splat_i16_m128i, set_splat_i32_m128i, shr_imm_i16_m128i, sub_i16_m128i, unpack_high_i8_m128i,
        unpack_low_i8_m128i, unpack_low_i16_m128i, zeroed_m128i,
    };

    #[inline(always)]
    pub(super) fn mixed(above: Pixel, below: [Pixel; 4], samples: [u8; 4]) -> [Pixel; 4] {
        let zero = zeroed_m128i();
        let above = unpack_low_i8_m128i(set_splat_i32_m128i(i32::from_le_bytes(above)), zero);
        let below = m128i::from(below.map(i32::from_le_bytes));
        // Each number four times.
        let samples = set_i32_m128i_s(i32::from_le_bytes(samples));
        let samples = unpack_low_i8_m128i(samples, samples);
        let samples = unpack_low_i16_m128i(samples, samples);
        let two = |below: m128i, samples: m128i| {
            let way = mul_i16_keep_low_m128i(sub_i16_m128i(above, below), samples);
            let way = add_i16_m128i(way, set_splat_i16_m128i(SAMPLES as i16 / 2));
            add_i16_m128i(below, shr_imm_i16_m128i::<{ SAMPLES.trailing_zeros() as i32 }>(way))
        };
        let low = two(unpack_low_i8_m128i(below, zero), unpack_low_i8_m128i(samples, zero));
        let high = two(unpack_high_i8_m128i(below, zero), unpack_high_i8_m128i(samples, zero));
        <[i32; 4]>::from(pack_i16_to_u8_m128i(low, high)).map(i32::to_le_bytes)
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    #[test]
    fn every_way_mixes_alike() {
        for above in [[0, 255, 17, 200], [255, 0, 128, 255]] {
            for below in 0..=255u8 {
                let below = std::array::from_fn(|i| [below, 255 - below, below / 7 * i as u8, 255]);
                for samples in 0..=64u8 {
                    let samples = [samples, 64 - samples, samples / 2, 64];
                    assert_eq!(wide::mixed(above, below, samples), each::mixed(above, below, samples));
                }
            }
        }
    }
}
