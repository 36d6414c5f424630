//! Blending of colours into pixels by T. Porter and T. Duff, "Compositing Digital Images", 1984: source over
//! destination, premultiplied by opacity.

use super::four;
use gks_algorithms::coverage::{Cover, SAMPLES};
use gks_pipeline::colour::Colour;

/// A pixel of the frame buffer: red, green, blue and opacity, the colours premultiplied by the opacity.
pub(super) type Pixel = [u8; 4];

/// The pixel that shows a colour alone.
pub(super) fn pixel(colour: Colour) -> Pixel {
    let [r, g, b, a] = colour.to_bytes();
    [times(r, a), times(g, a), times(b, a), a]
}

/// The bytes of the colour that a pixel shows, no longer premultiplied.
pub(super) fn demultiplied([r, g, b, a]: Pixel) -> [u8; 4] {
    let part = |c: u8| match a {
        0 => 0,
        255 => c,
        _ => ((u32::from(c) * 255 + u32::from(a) / 2) / u32::from(a)).min(255) as u8,
    };
    [part(r), part(g), part(b), a]
}

/// The colour that a pixel shows.
pub(super) fn colour(pixel: Pixel) -> Colour {
    let [red, green, blue, alpha] = demultiplied(pixel).map(|c| f32::from(c) / 255.0);
    Colour { red, green, blue, alpha }
}

/// `a` times `b` for numbers that stand for 0 to 1 as 0 to 255, rounded to nearest.
#[inline]
pub(super) fn times(a: u8, b: u8) -> u8 {
    let p = u32::from(a) * u32::from(b) + 128;
    ((p + (p >> 8)) >> 8) as u8
}

/// Four bytes times `b` as in [`times`].
#[inline]
fn all_times(four: u32, b: u32) -> u32 {
    let pair = |two: u32| {
        let p = two * b + 0x0080_0080;
        p + ((p >> 8) & 0x00FF_00FF)
    };
    (pair(four & 0x00FF_00FF) >> 8) & 0x00FF_00FF | pair((four >> 8) & 0x00FF_00FF) & 0xFF00_FF00
}

/// A part of a colour: what it adds to a pixel, and how much of the pixel it leaves.
#[derive(Copy, Clone, Debug)]
struct Layer {
    add: u32,
    keep: u32,
}

impl Layer {
    #[inline]
    fn new(above: Pixel, coverage: u8) -> Self {
        let add = all_times(u32::from_le_bytes(above), u32::from(coverage));
        Layer { add, keep: 255 - (add >> 24) }
    }

    #[inline]
    fn put(self, below: &mut Pixel) {
        let kept = all_times(u32::from_le_bytes(*below), self.keep);
        // No component of either is larger than its opacity, and the opacities add up to 255 at most.
        *below = (self.add + kept).to_le_bytes();
    }
}

/// Puts a colour over a pixel of which `coverage` of 255 parts are covered.
#[inline]
pub(super) fn over(below: &mut Pixel, above: Pixel, coverage: u8) {
    if above[3] < 255 {
        return Layer::new(above, coverage).put(below);
    }
    let (part, rest) = (u32::from(coverage), 255 - u32::from(coverage));
    let (a, b) = (u32::from_le_bytes(above), u32::from_le_bytes(*below));
    let pair = |a: u32, b: u32| {
        let p = (a & 0x00FF_00FF) * part + (b & 0x00FF_00FF) * rest + 0x0080_0080;
        p + ((p >> 8) & 0x00FF_00FF)
    };
    let mixed = (pair(a, b) >> 8) & 0x00FF_00FF | pair(a >> 8, b >> 8) & 0xFF00_FF00;
    *below = mixed.to_le_bytes();
}

/// Puts a colour over neighbouring pixels of which `coverage` of 255 parts are covered.
#[inline(always)]
pub(super) fn over_run(run: &mut [Pixel], above: Pixel, coverage: u8) {
    match run {
        // Most runs are a pixel of a boundary.
        [below] => over(below, above, coverage),
        _ if coverage == 255 && above[3] == 255 => run.fill(above),
        _ => run.iter_mut().for_each(|below| over(below, above, coverage)),
    }
}

/// A colour ready to be put over many pixels of which parts of 255 are covered.
pub(super) struct Coat {
    above: Pixel,
    opaque: bool,
    /// The bytes of two pixels of the colour.
    two: [u16; 8],
}

impl Coat {
    pub(super) fn new(above: Pixel) -> Self {
        Coat { above, opaque: above[3] == 255, two: std::array::from_fn(|i| u16::from(above[i % 4])) }
    }

    /// Puts the colour over what is covered of the first pixels of a row.
    #[inline(always)]
    pub(super) fn over_cover(&self, row: &mut [Pixel], cover: Cover<'_>) {
        match cover {
            Cover::Each(parts) => match (row.first_chunk_mut(), parts.try_into()) {
                (Some(eight), Ok(parts)) if self.opaque => self.over_eight(eight, parts),
                _ => self.over_each(&mut row[..parts.len()], parts),
            },
            Cover::Alike(count, 255) if self.opaque => row[..count].fill(self.above),
            Cover::Alike(1, coverage) if self.opaque => over(&mut row[0], self.above, coverage),
            Cover::Alike(count, coverage) => self.over_alike(&mut row[..count], coverage),
        }
    }

    /// Puts the opaque colour over eight pixels.
    #[inline(always)]
    fn over_eight(&self, below: &mut [Pixel; 8], parts: &[u8; 8]) {
        for (below, parts) in below.as_chunks_mut::<4>().0.iter_mut().zip(parts.as_chunks::<4>().0) {
            // Two loops that compilers turn into a few instructions for all 16 bytes.
            let mut shares = [0; 16];
            for (share, i) in shares.iter_mut().zip(0..) {
                *share = u16::from(parts[i / 4]);
            }
            for (below, i) in below.as_flattened_mut().iter_mut().zip(0..) {
                let sum = self.two[i % 8] * shares[i] + u16::from(*below) * (255 - shares[i]) + 128;
                // What the sum and its part of 256 have of 256.
                *below = ((u32::from(sum) * 257) >> 16) as u8;
            }
        }
    }

    #[inline(never)]
    fn over_each(&self, run: &mut [Pixel], parts: &[u8]) {
        run.iter_mut().zip(parts).for_each(|(below, &part)| over(below, self.above, part));
    }

    #[inline(never)]
    fn over_alike(&self, run: &mut [Pixel], coverage: u8) {
        run.iter_mut().for_each(|below| over(below, self.above, coverage));
    }
}

/// A colour ready to be put over many pixels, covered by a number of samples.
#[derive(Copy, Clone, Debug)]
pub(super) struct Ink {
    whole: Pixel,
    opaque: bool,
}

impl Ink {
    /// The ink of a colour of which `strength` of 255 parts are used.
    pub(super) fn new(above: Pixel, strength: u8) -> Self {
        let whole = all_times(u32::from_le_bytes(above), u32::from(strength)).to_le_bytes();
        Ink { whole, opaque: whole[3] == 255 }
    }

    /// Whether the ink covers what is below where it covers all samples.
    pub(super) fn is_opaque(&self) -> bool {
        self.opaque
    }

    /// Puts the ink over pixels whose samples in `words` are covered.
    pub(super) fn over_all(&self, pixels: &mut [Pixel], words: &[u64]) {
        // Neighbours are mostly alike, so it pays to look at several of them first.
        for (pixels, words) in pixels.chunks_mut(8).zip(words.chunks(8)) {
            let (or, and) = words.iter().fold((0, u64::MAX), |(or, and), word| (or | word, and & word));
            if or == 0 {
                continue;
            }
            if and == u64::MAX && self.is_opaque() {
                pixels.fill(self.whole);
                continue;
            }
            let ((fours, pixels), (words, rest)) = (pixels.as_chunks_mut(), words.as_chunks());
            for (four, words) in fours.iter_mut().zip(words) {
                *four = self.over_four(*four, words.map(|word| word.count_ones() as u8));
            }
            for (below, word) in pixels.iter_mut().zip(rest) {
                self.over_samples(below, word.count_ones() as u8);
            }
        }
    }

    /// Four pixels with the ink over them, of which numbers of samples are covered.
    #[inline(always)]
    pub(super) fn over_four(&self, below: [Pixel; 4], samples: [u8; 4]) -> [Pixel; 4] {
        if self.is_opaque() {
            four::mixed(self.whole, below, samples)
        } else {
            self.over_translucently(below, samples)
        }
    }

    #[inline(never)]
    fn over_translucently(&self, mut below: [Pixel; 4], samples: [u8; 4]) -> [Pixel; 4] {
        below.iter_mut().zip(samples).for_each(|(below, samples)| self.over_samples(below, samples));
        below
    }

    /// Puts the ink over a pixel of which a number of samples is covered.
    #[inline]
    pub(super) fn over_samples(&self, below: &mut Pixel, samples: u8) {
        let samples = u32::from(samples).min(SAMPLES);
        if self.is_opaque() {
            let (a, b) = (u32::from_le_bytes(self.whole), u32::from_le_bytes(*below));
            let pair = |a: u32, b: u32| {
                (a & 0x00FF_00FF) * samples + (b & 0x00FF_00FF) * (SAMPLES - samples) + 0x0020_0020
            };
            // Two bytes at a time; none of the sums reaches the next one.
            let mixed = pair(a, b) >> 6 & 0x00FF_00FF | pair(a >> 8, b >> 8) << 2 & 0xFF00_FF00;
            *below = mixed.to_le_bytes();
            return;
        }
        let part = (samples * 255 + SAMPLES / 2) / SAMPLES;
        Layer::new(self.whole, part as u8).put(below);
    }

    /// What the ink puts over a pixel that it covers.
    pub(super) fn whole(&self) -> Pixel {
        self.whole
    }
}

/// An opaque ink that is put over many pairs of pixels.
pub(super) struct Brush {
    above: [i16; 8],
}

impl Brush {
    pub(super) fn new(ink: &Ink) -> Self {
        Brush { above: std::array::from_fn(|i| i16::from(ink.whole[i % 4])) }
    }

    /// Puts the ink over two pixels of which numbers of samples are covered.
    #[inline]
    pub(super) fn over_two(&self, below: &mut [Pixel; 2], samples: &[u8; 2]) {
        // Two loops that compilers turn into a few instructions for all 8 bytes.
        let mut counts = [0; 8];
        for (count, i) in counts.iter_mut().zip(0..) {
            *count = i16::from(samples[i / 4]);
        }
        for (below, i) in below.as_flattened_mut().iter_mut().zip(0..) {
            *below = mixed(*below, self.above[i], counts[i]);
        }
    }
}

/// A byte on the way to another one, as far as a number of samples says.
#[inline]
fn mixed(below: u8, above: i16, samples: i16) -> u8 {
    let below = i16::from(below);
    (below + (((above - below) * samples + SAMPLES as i16 / 2) >> SAMPLES.trailing_zeros())) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_bytes_are_rounded() {
        for a in 0..=255u8 {
            for b in 0..=255u8 {
                let exact = (f64::from(a) * f64::from(b) / 255.0).round() as u8;
                assert_eq!(times(a, b), exact, "{a} {b}");
                let four = all_times(u32::from_le_bytes([a, 255 - a, 255, a]), b.into()).to_le_bytes();
                assert_eq!(four, [exact, times(255 - a, b), b, exact], "{a} {b}");
            }
        }
    }

    #[test]
    fn half_a_cover_and_half_an_opacity_are_the_same() {
        let red = Colour::rgb(1.0, 0.0, 0.0);
        let (mut covered, mut translucent) = (pixel(Colour::WHITE), pixel(Colour::WHITE));
        over(&mut covered, pixel(red), 128);
        over(&mut translucent, pixel(Colour { alpha: 128.0 / 255.0, ..red }), 255);
        assert_eq!(covered, translucent);
        assert_eq!(colour(covered).to_bytes(), [255, 127, 127, 255]);
        let mut sampled = pixel(Colour::WHITE);
        Ink::new(pixel(red), 255).over_samples(&mut sampled, 32);
        assert_eq!(sampled, [255, 128, 128, 255]);
        let words = [0, u64::MAX, 0xF0F0_F0F0_F0F0_F0F0, 1, u64::MAX];
        let mut five = [pixel(Colour::WHITE); 5];
        Ink::new(pixel(red), 255).over_all(&mut five, &words);
        assert_eq!(five, [pixel(Colour::WHITE), pixel(red), sampled, [255, 251, 251, 255], pixel(red)]);
    }

    #[test]
    fn samples_of_an_opaque_ink_are_shares_of_the_pixel() {
        for below in 0..=255u8 {
            for above in 0..=255u8 {
                for samples in 0..=64u8 {
                    let share = f64::from(samples) / 64.0;
                    let exact = (f64::from(below) * (1.0 - share) + f64::from(above) * share + 0.5).floor();
                    let mut pixel = [below, below, above, 255];
                    Ink::new([above, above, above, 255], 255).over_samples(&mut pixel, samples);
                    assert_eq!(pixel, [exact as u8, exact as u8, above, 255], "{below} {above} {samples}");
                }
            }
        }
    }

    #[test]
    fn pixels_covered_by_parts_are_like_each_of_them() {
        let below: [Pixel; 9] = std::array::from_fn(|i| [i as u8 * 31, 255 - i as u8 * 9, 128, 255]);
        for alpha in [255, 100] {
            let above = [times(200, alpha), times(3, alpha), times(90, alpha), alpha];
            for first in 0..=247 {
                let parts: [u8; 9] = std::array::from_fn(|i| first + i as u8);
                for count in [3, 8, 9] {
                    let (mut together, mut single) = (below, below);
                    Coat::new(above).over_cover(&mut together, Cover::Each(&parts[..count]));
                    single.iter_mut().zip(&parts[..count]).for_each(|(p, &part)| over(p, above, part));
                    assert_eq!(together, single, "{first} {count}");
                }
            }
        }
        let mut row = below;
        Coat::new([1, 2, 3, 255]).over_cover(&mut row, Cover::Alike(4, 255));
        assert_eq!((row[3], row[4]), ([1, 2, 3, 255], below[4]));
    }

    #[test]
    fn opaque_stays_opaque_and_nothing_leaves_its_range() {
        for coverage in 0..=255 {
            for alpha in [0.0, 0.3, 0.99, 1.0] {
                let above = pixel(Colour { red: 1.0, green: 0.9, blue: 0.1, alpha });
                let mut p = pixel(Colour::rgb(0.2, 0.4, 0.6));
                over(&mut p, above, coverage);
                Ink::new(above, coverage).over_samples(&mut p, coverage / 4);
                assert_eq!(p[3], 255);
                let mut q = pixel(Colour { alpha: 0.5, ..Colour::WHITE });
                over(&mut q, above, coverage);
                assert!(q[..3].iter().all(|&c| c <= q[3]), "{q:?}");
            }
        }
    }

    #[test]
    fn colours_survive_being_multiplied() {
        for alpha in 1..=255u8 {
            let bytes = [alpha, alpha / 2, 0, alpha];
            let [r, g, b, a] = demultiplied(bytes);
            assert_eq!([times(r, a), times(g, a), times(b, a), a], bytes);
        }
        assert_eq!(demultiplied([0; 4]), [0; 4]);
    }
}
