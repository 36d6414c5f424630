//! Stamps: small shapes that are drawn many times, kept for every place of their origin among the samples of a pixel.

use super::bitmap::Bitmap;
use super::composite::{Ink, Pixel};
use super::stroke::settled;
use gks_algorithms::coverage::SampleMask;
use gks_algorithms::rect::IRect;
use glam::{DVec2, IVec2};

/// Places of an origin along one side of a pixel: as many as there are samples.
const PLACES: i32 = 8;
/// A stamp reaches no farther than this from its origin, in pixels.
pub(super) const LARGEST: f64 = 256.0;

/// A shape at one place among the samples: the pixels that it touches.
#[derive(Clone, Debug)]
struct Stamp {
    pixels: Vec<Part>,
    /// The first column and row, and the last ones.
    low: IVec2,
    high: IVec2,
}

/// A pixel of a stamp.
#[derive(Copy, Clone, Debug)]
struct Part {
    row: i16,
    column: i16,
    /// How many samples of it are covered.
    samples: u8,
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
        let places = f64::from(PLACES);
        // Counted from farther out than a stamp reaches, so that all is positive.
        let near = (settled(at) + LARGEST) * places + 0.5;
        let most = f64::from(i32::MAX >> 1);
        if !(0.0..most).contains(&near.x) || !(0.0..most).contains(&near.y) {
            return;
        }
        let near = near.as_ivec2() - (LARGEST * places) as i32;
        let (pixel, place) = (near >> PLACES.trailing_zeros(), near & (PLACES - 1));
        let stamp = &mut self.places[(place.y * PLACES + place.x) as usize];
        let stamp = stamp.get_or_insert_with(|| Stamp::new(place.as_dvec2() / places, mask, reach, shape));
        stamp.put(bitmap, pixel, ink);
    }
}

impl Stamp {
    fn new(
        origin: DVec2,
        mask: &mut SampleMask,
        reach: f64,
        shape: impl FnOnce(DVec2, &mut dyn FnMut(&[DVec2])),
    ) -> Self {
        let reach = reach.min(LARGEST).ceil() as i32 + 1;
        mask.begin(IRect::new(IVec2::splat(-reach), IVec2::splat(reach + 1)));
        shape(origin, &mut |ring| mask.polygon(ring));
        let mut stamp = Stamp { pixels: Vec::new(), low: IVec2::ZERO, high: IVec2::ZERO };
        mask.drain(|row, column, words| {
            for (column, word) in (column..).zip(words).filter(|(_, word)| **word != 0) {
                let at = IVec2::new(column, row);
                (stamp.low, stamp.high) = (stamp.low.min(at), stamp.high.max(at));
                let samples = word.count_ones() as u8;
                stamp.pixels.push(Part { row: row as i16, column: column as i16, samples });
            }
        });
        stamp
    }

    #[inline]
    fn put(&self, bitmap: &mut Bitmap, at: IVec2, ink: &Ink) {
        let (width, height) = bitmap.size();
        let size = IVec2::new(width as i32, height as i32);
        let (low, high) = (at + self.low, at + self.high);
        let pixels = bitmap.pixels_mut();
        if low.min_element() >= 0 && high.x < size.x && high.y < size.y {
            let origin = at.y as isize * size.x as isize + at.x as isize;
            for part in &self.pixels {
                let place = origin + part.row as isize * size.x as isize + part.column as isize;
                ink.over_samples(&mut pixels[place as usize], part.samples);
            }
            return;
        }
        for part in &self.pixels {
            let at = at + IVec2::new(part.column.into(), part.row.into());
            if at.min_element() >= 0 && at.x < size.x && at.y < size.y {
                ink.over_samples(&mut pixels[at.y as usize * width as usize + at.x as usize], part.samples);
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
