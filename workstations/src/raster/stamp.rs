//! Stamps: small shapes that are drawn many times, kept for every place of their origin among the samples of a pixel.

use super::bitmap::Bitmap;
use super::composite::{Ink, Pixel};
use super::stroke::settled;
use gks_algorithms::coverage::SampleMask;
use gks_algorithms::rect::IRect;
use glam::{DVec2, IVec2};

/// Places of an origin along one side of a pixel: as many as there are samples.
pub(super) const PLACES: i32 = 8;
/// A stamp reaches no farther than this from its origin, in pixels.
pub(super) const LARGEST: f64 = 256.0;

/// A shape at one place among the samples: the pixels that it touches, four at a time.
#[derive(Clone, Debug)]
pub(super) struct Stamp {
    fours: Vec<Four>,
    /// The first column and row, and the last ones.
    low: IVec2,
    high: IVec2,
}

/// Four pixels of a stamp side by side.
#[derive(Copy, Clone, Debug)]
struct Four {
    row: i16,
    /// The column of the first one.
    column: i16,
    /// How many samples of each are covered.
    samples: [u8; 4],
}

/// The stamps of one shape, made when they are first needed.
#[derive(Debug)]
pub(super) struct Stamps {
    places: Box<[Option<Stamp>; (PLACES * PLACES) as usize]>,
}

impl Stamps {
    /// The stamps of a shape none of which is made yet.
    pub(super) fn new() -> Self {
        Stamps { places: Box::new([const { None }; (PLACES * PLACES) as usize]) }
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
        let Some((pixel, place)) = place(at) else { return };
        let stamp = &mut self.places[place];
        let stamp = stamp.get_or_insert_with(|| Stamp::new(place, mask, reach, shape));
        stamp.put(bitmap, pixel, ink);
    }
}

/// The pixel in which a point lies, and the number of its place in that; none if it is far away.
#[inline]
pub(super) fn place(at: DVec2) -> Option<(IVec2, usize)> {
    let places = f64::from(PLACES);
    // Counted from farther out than a stamp reaches, so that all is positive.
    let near = (settled(at) + LARGEST) * places + 0.5;
    let most = f64::from(i32::MAX >> 1);
    if !(0.0..most).contains(&near.x) || !(0.0..most).contains(&near.y) {
        return None;
    }
    let near = near.as_ivec2() - (LARGEST * places) as i32;
    let (pixel, place) = (near >> PLACES.trailing_zeros(), near & (PLACES - 1));
    Some((pixel, (place.y * PLACES + place.x) as usize))
}

impl Stamp {
    /// The stamp for a place of the origin, of a shape as in [`Stamps::put`].
    pub(super) fn new(
        place: usize,
        mask: &mut SampleMask,
        reach: f64,
        shape: impl FnOnce(DVec2, &mut dyn FnMut(&[DVec2])),
    ) -> Self {
        let place = place as i32;
        let origin = IVec2::new(place % PLACES, place / PLACES).as_dvec2() / f64::from(PLACES);
        let reach = reach.min(LARGEST).ceil() as i32 + 1;
        mask.begin(IRect::new(IVec2::splat(-reach), IVec2::splat(reach + 1)));
        shape(origin, &mut |ring| mask.polygon(ring));
        let mut stamp = Stamp { fours: Vec::new(), low: IVec2::ZERO, high: IVec2::ZERO };
        mask.drain(|row, column, words| {
            let mut at = 0;
            while at < words.len() {
                if words[at] == 0 {
                    at += 1;
                    continue;
                }
                let first = column + at as i32;
                stamp.low = stamp.low.min(IVec2::new(first, row));
                stamp.high = stamp.high.max(IVec2::new(first + 3, row));
                let samples =
                    std::array::from_fn(|i| words.get(at + i).map_or(0, |word| word.count_ones() as u8));
                stamp.fours.push(Four { row: row as i16, column: first as i16, samples });
                at += 4;
            }
        });
        stamp
    }

    /// How many fours of pixels are kept.
    pub(super) fn size(&self) -> usize {
        self.fours.len()
    }

    /// The first column and row, and the last ones, with the origin in a pixel.
    pub(super) fn bounds(&self, at: IVec2) -> (IVec2, IVec2) {
        (at + self.low, at + self.high)
    }

    /// Four pixels side by side after the other: the column of the first one and the row, counted from the pixel of the
    /// origin, and how many samples of each are covered.
    #[inline]
    pub(super) fn fours(&self) -> impl Iterator<Item = (i32, i32, [u8; 4])> + '_ {
        self.fours.iter().map(|four| (four.column.into(), four.row.into(), four.samples))
    }

    /// Puts the stamp over a bitmap with its origin in a pixel.
    #[inline]
    pub(super) fn put(&self, bitmap: &mut Bitmap, at: IVec2, ink: &Ink) {
        let (width, height) = bitmap.size();
        let size = IVec2::new(width as i32, height as i32);
        let (low, high) = (at + self.low, at + self.high);
        let pixels = bitmap.pixels_mut();
        if low.min_element() >= 0 && high.x < size.x && high.y < size.y {
            let origin = at.y as isize * size.x as isize + at.x as isize;
            for four in &self.fours {
                let place = origin + four.row as isize * size.x as isize + four.column as isize;
                if let Some(below) = pixels.get_mut(place as usize..).and_then(|rest| rest.first_chunk_mut())
                {
                    ink.over_four(below, four.samples);
                }
            }
            return;
        }
        for four in &self.fours {
            for (column, samples) in (i32::from(four.column)..).zip(four.samples) {
                let at = at + IVec2::new(column, four.row.into());
                if at.min_element() >= 0 && at.x < size.x && at.y < size.y {
                    ink.over_samples(&mut pixels[at.y as usize * width as usize + at.x as usize], samples);
                }
            }
        }
    }
}

/// Puts a colour over the pixel that contains a point.
#[inline]
pub(super) fn dot(bitmap: &mut Bitmap, at: DVec2, ink: &Ink, above: Pixel) {
    let (width, height) = bitmap.size();
    let at = settled(at);
    if at.x >= 0.0 && at.y >= 0.0 && at.x <= f64::from(width) && at.y <= f64::from(height) {
        // The far edges of the display surface belong to the last pixels.
        let (column, row) = ((at.x as u32).min(width - 1), (at.y as u32).min(height - 1));
        let below = &mut bitmap.pixels_mut()[row as usize * width as usize + column as usize];
        if above[3] == 255 {
            *below = above;
        } else {
            ink.over_samples(below, u8::MAX);
        }
    }
}
