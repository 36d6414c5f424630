//! How alike two pictures of the same program are, whoever drew them.
//!
//! Strays judge position and presence, tone judges colours and weight. Two border pixels are ignored, for the
//! pictures of other implementations are cut out of a page.

use image::{GrayImage, Luma, RgbImage};
use std::path::Path;

/// How alike two pictures are.
#[derive(Copy, Clone, Debug)]
pub struct Likeness {
    /// The share of the contours of either picture (for plots: of the ink) that has none of the other within
    /// `NEAR` pixels.
    pub stray: f64,
    /// The root mean square difference of colour after a blur over `BLUR` pixels, from 0 to 255.
    pub tone: f64,
}

const NEAR: u32 = 3;
const BLUR: f32 = 4.0;
/// How much neighbouring pixels must differ, summed over the components, to be on either side of a contour.
const CONTOUR: i32 = 60;
/// How far a pixel must be from the paper to count as ink, summed over the components: strong ink must be in
/// the other picture too, where even weak ink answers for it.
const STRONG: i32 = 150;
const WEAK: i32 = 12;

/// The size in which pictures are compared.
pub const SIZE: u32 = 800;

/// A picture in the size in which they are compared; nothing if the file cannot be read.
pub fn open(path: &Path) -> Option<RgbImage> {
    let picture = image::open(path).ok()?.to_rgb8();
    if picture.dimensions() == (SIZE, SIZE) {
        return Some(picture);
    }
    // The mean of the pixels that fall into one: pictures of vector devices come four times as large.
    Some(image::imageops::thumbnail(&picture, SIZE, SIZE))
}

fn difference(a: [u8; 3], b: [u8; 3]) -> i32 {
    (0..3).map(|i| (i32::from(a[i]) - i32::from(b[i])).abs()).sum()
}

fn inside(x: u32, y: u32) -> bool {
    x >= 2 && y >= 2 && x < SIZE - 3 && y < SIZE - 3
}

/// The pixels that differ from the one to the right or below.
fn contours(picture: &RgbImage) -> GrayImage {
    GrayImage::from_fn(SIZE, SIZE, |x, y| {
        let edge = inside(x, y) && {
            let here = picture.get_pixel(x, y).0;
            let beside = [picture.get_pixel(x + 1, y).0, picture.get_pixel(x, y + 1).0];
            beside.iter().any(|&other| difference(here, other) > CONTOUR)
        };
        Luma([if edge { 255 } else { 0 }])
    })
}

/// The paper: white or black, whichever is more frequent along the border.
fn paper(picture: &RgbImage) -> [u8; 3] {
    let border = picture.enumerate_pixels().filter(|(x, y, _)| x.min(y) < &8 || *x.max(y) >= SIZE - 8);
    let black = border.fold(0i32, |sum, (_, _, p)| match p.0 {
        [0, 0, 0] => sum + 1,
        [255, 255, 255] => sum - 1,
        _ => sum,
    });
    if black > 0 { [0; 3] } else { [255; 3] }
}

/// The pixels that differ from the paper by more than `least`.
fn ink(picture: &RgbImage, paper: [u8; 3], least: i32) -> GrayImage {
    GrayImage::from_fn(SIZE, SIZE, |x, y| {
        let far = inside(x, y) && difference(picture.get_pixel(x, y).0, paper) > least;
        Luma([if far { 255 } else { 0 }])
    })
}

/// Ink grown by `NEAR` pixels.
fn grown(ink: &GrayImage) -> GrayImage {
    let reach = i64::from(NEAR);
    let mut rows = GrayImage::new(SIZE, SIZE);
    for (x, y, p) in ink.enumerate_pixels() {
        if p.0[0] > 0 {
            for k in (i64::from(x) - reach).max(0)..=(i64::from(x) + reach).min(i64::from(SIZE) - 1) {
                rows.put_pixel(k as u32, y, Luma([255]));
            }
        }
    }
    let mut both = GrayImage::new(SIZE, SIZE);
    for (x, y, p) in rows.enumerate_pixels() {
        if p.0[0] > 0 {
            for k in (i64::from(y) - reach).max(0)..=(i64::from(y) + reach).min(i64::from(SIZE) - 1) {
                both.put_pixel(x, k as u32, Luma([255]));
            }
        }
    }
    both
}

fn stray(a: &GrayImage, b: &GrayImage) -> f64 {
    let near = grown(b);
    let (mut all, mut alone) = (0u32, 0u32);
    for (p, q) in a.pixels().zip(near.pixels()) {
        if p.0[0] > 0 {
            all += 1;
            alone += u32::from(q.0[0] == 0);
        }
    }
    if all == 0 { 0.0 } else { f64::from(alone) / f64::from(all) }
}

/// How alike two pictures of the size [`SIZE`] are.
pub fn likeness(a: &RgbImage, b: &RgbImage) -> Likeness {
    let (contours_a, contours_b) = (contours(a), contours(b));
    let stray = stray(&contours_a, &contours_b).max(stray(&contours_b, &contours_a));
    Likeness { stray, tone: tone(a, b) }
}

/// How alike a picture of ours and a pen plot on white paper are, background left out.
pub fn plot_likeness(ours: &RgbImage, plot: &RgbImage) -> Likeness {
    let paper = paper(ours);
    let white = [255; 3];
    let there = stray(&ink(ours, paper, STRONG), &ink(plot, white, WEAK));
    let back = stray(&ink(plot, white, STRONG), &ink(ours, paper, WEAK));
    Likeness { stray: there.max(back), tone: 0.0 }
}

fn tone(a: &RgbImage, b: &RgbImage) -> f64 {
    let blurred = |p: &RgbImage| image::imageops::fast_blur(p, BLUR);
    let (a, b) = (blurred(a), blurred(b));
    let mut sum = 0.0;
    let mut count = 0u32;
    for (x, y, p) in a.enumerate_pixels().filter(|(x, y, _)| inside(*x, *y)) {
        let q = b.get_pixel(x, y);
        sum += (0..3).map(|i| (f64::from(p.0[i]) - f64::from(q.0[i])).powi(2)).sum::<f64>();
        count += 3;
    }
    (sum / f64::from(count.max(1))).sqrt()
}

/// Whether nothing is drawn: all pixels inside of the border have one colour.
pub fn is_blank(picture: &RgbImage) -> bool {
    let first = picture.get_pixel(SIZE / 2, SIZE / 2);
    picture.enumerate_pixels().all(|(x, y, pixel)| pixel == first || !inside(x, y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_is_like_itself_and_not_like_a_moved_one() {
        let square = |at: u32| {
            RgbImage::from_fn(SIZE, SIZE, |x, y| {
                let ink = (at..at + 100).contains(&x) && (200..300).contains(&y);
                image::Rgb(if ink { [0, 0, 200] } else { [255; 3] })
            })
        };
        let same = likeness(&square(100), &square(101));
        assert!(same.stray == 0.0 && same.tone < 3.0, "{same:?}");
        let moved = likeness(&square(100), &square(120));
        assert!(moved.stray > 0.3 && moved.tone > 10.0, "{moved:?}");
        assert!(!is_blank(&square(100)));
        assert!(is_blank(&RgbImage::new(SIZE, SIZE)));
    }
}
