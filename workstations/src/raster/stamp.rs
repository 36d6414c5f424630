//! Stamps: small shapes that are drawn many times, kept for every place of their origin among the samples of a pixel.

use super::bitmap::Bitmap;
use super::composite::{Brush, Ink, Pixel};
use super::stroke::settled;
use gks_algorithms::coverage::SampleMask;
use gks_algorithms::rect::IRect;
use glam::{DVec2, IVec2};
use prefetch_index::prefetch_index;

/// A stamp reaches no farther than this from its origin, in pixels.
pub(super) const LARGEST: f64 = 256.0;

/// A shape at one place among the samples: the pixels that it touches, two at a time.
#[derive(Clone, Debug)]
pub(super) struct Stamp {
    pairs: Vec<Pair>,
    /// The column and the row of the first pixel of each pair.
    places: Vec<[i16; 2]>,
    /// The first column and row, and the last ones.
    low: IVec2,
    high: IVec2,
}

/// Two pixels of a stamp side by side.
#[derive(Copy, Clone, Debug)]
struct Pair {
    /// How many pixels the first one comes after the origin in the bitmap.
    offset: i32,
    /// How many samples of each are covered.
    samples: [u8; 2],
}

/// The stamps of one shape, made when they are first needed, with `N` places of the origin along one side of a pixel.
#[derive(Debug)]
pub(super) struct Stamps<const N: i32> {
    places: Vec<Option<Stamp>>,
}

impl<const N: i32> Stamps<N> {
    /// The stamps of a shape none of which is made yet.
    pub(super) fn new() -> Self {
        Stamps { places: vec![None; (N * N) as usize] }
    }

    /// Puts the shape over a bitmap with its origin at a point. `shape` gives the convex polygons that make it up around
    /// an origin, and how far they reach from it.
    #[inline]
    pub(super) fn put(
        &mut self,
        bitmap: &mut Bitmap,
        at: DVec2,
        ink: &Ink,
        mask: &mut SampleMask,
        reach: f64,
        shape: impl FnOnce(DVec2, &mut dyn FnMut(&[DVec2])),
    ) {
        let Some((pixel, place)) = place::<N>(at) else { return };
        let Some(stamp) = self.places.get_mut(place) else { return };
        let width = bitmap.size().0 as i32;
        let stamp = stamp.get_or_insert_with(|| Stamp::new(origin_of::<N>(place), width, mask, reach, shape));
        stamp.put(bitmap, pixel, ink);
    }
}

/// The pixel in which a point lies, and the number of its place in that; none if it is far away.
#[inline]
pub(super) fn place<const N: i32>(at: DVec2) -> Option<(IVec2, usize)> {
    // Counted from farther out than a stamp reaches, so that all is positive.
    let near = (settled(at) + LARGEST) * f64::from(N) + 0.5;
    let most = f64::from(i32::MAX >> 1);
    if !(0.0..most).contains(&near.x) || !(0.0..most).contains(&near.y) {
        return None;
    }
    let near = near.as_ivec2() - LARGEST as i32 * N;
    let (pixel, place) = (near >> N.trailing_zeros(), near & (N - 1));
    Some((pixel, (place.y * N + place.x) as usize))
}

/// The origin that has a place in the pixel at the origin of the bitmap.
pub(super) fn origin_of<const N: i32>(place: usize) -> DVec2 {
    let place = place as i32;
    IVec2::new(place % N, place / N).as_dvec2() / f64::from(N)
}

impl Stamp {
    /// The stamp for an origin and bitmaps of a width, of a shape as in [`Stamps::put`].
    pub(super) fn new(
        origin: DVec2,
        width: i32,
        mask: &mut SampleMask,
        reach: f64,
        shape: impl FnOnce(DVec2, &mut dyn FnMut(&[DVec2])),
    ) -> Self {
        let reach = reach.min(LARGEST).ceil() as i32 + 1;
        mask.begin(IRect::new(IVec2::splat(-reach), IVec2::splat(reach + 1)));
        shape(origin, &mut |ring| mask.polygon(ring));
        let mut stamp = Stamp { pairs: Vec::new(), places: Vec::new(), low: IVec2::ZERO, high: IVec2::ZERO };
        mask.drain(|row, column, words| {
            let mut at = 0;
            while at < words.len() {
                if words[at] == 0 {
                    at += 1;
                    continue;
                }
                let first = column + at as i32;
                stamp.low = stamp.low.min(IVec2::new(first, row));
                stamp.high = stamp.high.max(IVec2::new(first + 1, row));
                let samples = [0, 1].map(|i| words.get(at + i).map_or(0, |word| word.count_ones() as u8));
                stamp.pairs.push(Pair { offset: row * width + first, samples });
                stamp.places.push([first as i16, row as i16]);
                at += 2;
            }
        });
        stamp
    }

    /// How many pairs of pixels are kept.
    pub(super) fn size(&self) -> usize {
        self.pairs.len()
    }

    /// Asks for each row that the stamp with its origin in a pixel will be put over, so that they come from memory meanwhile.
    #[inline]
    pub(super) fn fetch(&self, bitmap: &Bitmap, at: IVec2) {
        let (width, height) = bitmap.size();
        let (low, high) = (at + self.low, at + self.high);
        if high.min_element() < 0 || low.x >= width as i32 || low.y >= height as i32 {
            return;
        }
        let [left, right] = [low.x, high.x].map(|x| x.clamp(0, width as i32 - 1) as usize);
        let pixels = bitmap.pixels();
        for row in low.y.max(0)..=high.y {
            let row = row as usize * width as usize;
            for place in [row + left, row + right] {
                prefetch_index(pixels, place);
            }
        }
    }

    /// Puts the stamp over a bitmap with its origin in a pixel. Inlined its inner loop becomes many instructions for single bytes.
    #[inline(never)]
    pub(super) fn put(&self, bitmap: &mut Bitmap, at: IVec2, ink: &Ink) {
        let (width, height) = bitmap.size();
        let size = IVec2::new(width as i32, height as i32);
        let (low, high) = (at + self.low, at + self.high);
        if high.min_element() < 0 || low.x >= size.x || low.y >= size.y {
            return;
        }
        let pixels = bitmap.pixels_mut();
        if low.min_element() >= 0 && high.x < size.x && high.y < size.y && ink.is_opaque() {
            let origin = at.y * size.x + at.x;
            let brush = Brush::new(ink);
            for pair in &self.pairs {
                let place = (origin + pair.offset) as u32 as usize;
                if let Some(below) = pixels.get_mut(place..place + 2).and_then(<[Pixel]>::first_chunk_mut) {
                    brush.over_two(below, &pair.samples);
                }
            }
            return;
        }
        for (pair, &[column, row]) in self.pairs.iter().zip(&self.places) {
            for (column, samples) in (i32::from(column)..).zip(pair.samples) {
                let at = at + IVec2::new(column, row.into());
                if at.min_element() >= 0 && at.x < size.x && at.y < size.y {
                    ink.over_samples(&mut pixels[at.y as usize * width as usize + at.x as usize], samples);
                }
            }
        }
    }
}
