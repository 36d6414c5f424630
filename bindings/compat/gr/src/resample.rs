//! The resampling of images: an image that is drawn larger or smaller than its pixels is brought to the pixels of the
//! workstation before it is drawn, where the program has asked for more than the colour of the nearest pixel.

use image::imageops::{self, FilterType};
use image::{Rgba, Rgba32FImage};
use std::env;
use std::ffi::c_uint;

/// The most columns and rows of an image that is made larger.
const MOST: usize = 4096;

/// How images are resampled: four methods of 8 bits, from the lowest on for making them larger vertically and horizontally
/// and for making them smaller vertically and horizontally.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Methods(pub(crate) c_uint);

impl Methods {
    /// The filter for an axis, 0 vertical and 1 horizontal, on which so many pixels become so many; none where each new
    /// pixel takes the colour of the nearest.
    fn filter(self, axis: usize, from: usize, to: usize) -> Option<FilterType> {
        let direction = if to > from { 0 } else { 2 };
        let method = match self.0.to_le_bytes()[axis + direction] {
            0 => by_default(),
            method => method,
        };
        let filter = match method {
            2 => Some(FilterType::Triangle),
            3 => Some(FilterType::Lanczos3),
            _ => None,
        };
        filter.filter(|_| from != to)
    }
}

/// The method of programs that do not ask for one, which the environment says.
fn by_default() -> u8 {
    match env::var("GKS_DEFAULT_RESAMPLE_METHOD") {
        Ok(name) if name.eq_ignore_ascii_case("linear") => 2,
        Ok(name) if name.eq_ignore_ascii_case("lanczos") => 3,
        _ => 1,
    }
}

/// The image with as many columns and rows as `target` says, as far as `methods` smooth; none where they do not. Pixels
/// have 8 bits of red, green, blue and opacity, from the lowest on.
pub(crate) fn resampled(
    pixels: &[i32],
    (columns, rows): (usize, usize),
    target: (usize, usize),
    methods: Methods,
) -> Option<(Vec<i32>, (usize, usize))> {
    if columns == 0 || rows == 0 || pixels.len() < columns.checked_mul(rows)? {
        return None;
    }
    let (wide, high) = (target.0.clamp(1, MOST.max(columns)), target.1.clamp(1, MOST.max(rows)));
    let (across, down) = (methods.filter(1, columns, wide), methods.filter(0, rows, high));
    if across.is_none() && down.is_none() {
        return None;
    }
    // Colours count as much as they cover: what is transparent has no colour to lend.
    let mut image = Rgba32FImage::from_fn(columns as u32, rows as u32, |x, y| {
        let [red, green, blue, opacity] =
            pixels[y as usize * columns + x as usize].to_le_bytes().map(|v| f32::from(v) / 255.0);
        Rgba([red * opacity, green * opacity, blue * opacity, opacity])
    });
    if let Some(filter) = across {
        image = imageops::resize(&image, wide as u32, image.height(), filter);
    }
    if let Some(filter) = down {
        image = imageops::resize(&image, image.width(), high as u32, filter);
    }
    let pixel = |&Rgba([red, green, blue, opacity]): &Rgba<f32>| {
        let byte = |v: f32| (v * 255.0).round() as u8;
        let part = |v: f32| if opacity > 0.0 { byte(v / opacity) } else { 0 };
        i32::from_le_bytes([part(red), part(green), part(blue), byte(opacity)])
    };
    Some((image.pixels().map(pixel).collect(), (image.width() as usize, image.height() as usize)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLACK: i32 = 0xff00_0000_u32 as i32;
    const WHITE: i32 = -1;

    fn reds(methods: c_uint, target: (usize, usize)) -> Option<Vec<u8>> {
        let (pixels, size) = resampled(&[BLACK, WHITE], (2, 1), target, Methods(methods))?;
        assert_eq!(pixels.len(), size.0 * size.1);
        Some(pixels.iter().map(|pixel| pixel.to_le_bytes()[0]).collect())
    }

    #[test]
    fn colours_pass_into_each_other() {
        let linear = reds(0x0202_0202, (8, 1)).unwrap();
        assert_eq!((linear.len(), linear[0], linear[7]), (8, 0, 255));
        assert!(linear.is_sorted() && linear[3] > 64 && linear[4] < 192, "{linear:?}");
        let lanczos = reds(0x0303_0303, (8, 1)).unwrap();
        assert_ne!(lanczos, linear);
        assert_eq!(reds(0x0202_0202, (1, 1)), Some(vec![128]));
    }

    #[test]
    fn each_axis_and_direction_has_its_method() {
        assert_eq!(reds(0x0101_0101, (8, 8)), None);
        assert_eq!(reds(0x0000_0200, (8, 8)).map(|reds| reds.len()), Some(8));
        assert_eq!(reds(0x0200_0000, (8, 1)), None);
        assert_eq!(reds(0x0200_0000, (1, 1)), Some(vec![128]));
        assert_eq!(reds(0x0202_0202, (2, 1)), None);
    }

    #[test]
    fn what_is_transparent_lends_no_colour() {
        let (pixels, _) = resampled(&[0x0000_ff00, WHITE], (2, 1), (8, 1), Methods(0x0202)).unwrap();
        assert!(
            pixels.iter().map(|pixel| pixel.to_le_bytes()).all(|p| p[3] == 0 || p[0] == 255),
            "{pixels:x?}"
        );
    }

    #[test]
    fn sizes_are_bounded_and_lies_refused() {
        let (_, size) = resampled(&[BLACK; 4], (2, 2), (1_000_000, 2), Methods(0x0202_0202)).unwrap();
        assert_eq!(size, (MOST, 2));
        assert!(resampled(&[BLACK], (2, 1), (8, 1), Methods(0x0202)).is_none());
        assert!(resampled(&[], (0, 1), (8, 1), Methods(0x0202)).is_none());
        assert!(resampled(&[], (usize::MAX, 2), (8, 1), Methods(0x0202)).is_none());
    }
}
