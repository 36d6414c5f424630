//! The picture that a window shows, at the size of the window.

use gks_workstations::interactive::frame::Area;
use gks_workstations::interactive::scale::{Scaler, fit};

/// A picture of opaque pixels, `0x00RRGGBB` each, row by row from the top.
pub(super) struct Picture {
    width: u32,
    height: u32,
    pixels: Vec<u32>,
}

/// Where in a window a picture appears: as large as fits with its proportions, in the middle.
pub(super) struct Placement {
    /// The left column and the upper row.
    corner: (u32, u32),
    /// Number of columns and rows.
    size: (u32, u32),
    /// Size of a pixel of the picture in the window.
    scale: (f64, f64),
    scaler: Scaler,
}

/// What surrounds a picture in a window of other proportions.
const SURROUNDINGS: u32 = 0x0030_343a;

fn channels(pixel: u32) -> [u8; 3] {
    let [_, red, green, blue] = pixel.to_be_bytes();
    [red, green, blue]
}

fn pixel([red, green, blue]: [u8; 3]) -> u32 {
    u32::from_be_bytes([0, red, green, blue])
}

impl Picture {
    /// A white picture.
    pub(super) fn new(width: u32, height: u32) -> Picture {
        Picture { width, height, pixels: vec![0x00ff_ffff; width as usize * height as usize] }
    }

    /// Number of columns and rows.
    pub(super) fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Replaces an area, which lies inside, by red, green and blue of each pixel.
    pub(super) fn paint(&mut self, area: Area, rgb: &[u8]) {
        let rows = self.pixels.chunks_exact_mut(self.width as usize).skip(area.y as usize);
        for (row, new) in rows.zip(rgb.chunks_exact((area.width as usize * 3).max(1))) {
            for (old, new) in row.iter_mut().skip(area.x as usize).zip(new.chunks_exact(3)) {
                *old = pixel([new[0], new[1], new[2]]);
            }
        }
    }

    /// Where the picture appears in a window.
    pub(super) fn place(&self, width: u32, height: u32) -> Placement {
        let size = fit(self.size(), (width, height));
        let scale = (f64::from(size.0) / f64::from(self.width), f64::from(size.1) / f64::from(self.height));
        let corner = (width.max(1).saturating_sub(size.0) / 2, height.max(1).saturating_sub(size.1) / 2);
        Placement { corner, size, scale, scaler: Scaler::new(self.size(), size) }
    }

    /// Draws the whole window, `width` pixels wide.
    pub(super) fn draw(&self, placement: &Placement, width: u32, window: &mut [u32]) {
        let (x, y) = (placement.corner.0 as usize, placement.corner.1 as usize);
        let (columns, rows) = (placement.size.0 as usize, placement.size.1 as usize);
        let stride = self.width as usize;
        for (at, line) in window.chunks_exact_mut(width.max(1) as usize).enumerate() {
            let Some(row) = at.checked_sub(y).filter(|&row| row < rows) else {
                line.fill(SURROUNDINGS);
                continue;
            };
            let end = (x + columns).min(line.len());
            let start = x.min(end);
            line[..start].fill(SURROUNDINGS);
            line[end..].fill(SURROUNDINGS);
            if placement.size == self.size() {
                line[start..end].copy_from_slice(&self.pixels[row * stride..][..end - start]);
                continue;
            }
            for (column, shown) in line[start..end].iter_mut().enumerate() {
                let old = |column: usize, row: usize| channels(self.pixels[row * stride + column]);
                *shown = pixel(placement.scaler.pixel(column, row, old));
            }
        }
    }
}

impl Placement {
    /// The position in the picture that a position in the window shows.
    pub(super) fn to_picture(&self, x: f64, y: f64) -> (f64, f64) {
        ((x - f64::from(self.corner.0)) / self.scale.0, (y - f64::from(self.corner.1)) / self.scale.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gradient() -> Picture {
        let mut picture = Picture::new(4, 2);
        let rgb: Vec<u8> = (0..8).flat_map(|i| [i * 10, 100, 200]).collect();
        picture.paint(Area { x: 0, y: 0, width: 4, height: 2 }, &rgb);
        picture
    }

    fn drawn(picture: &Picture, width: u32, height: u32) -> Vec<u32> {
        let mut window = vec![1; (width * height) as usize];
        picture.draw(&picture.place(width, height), width, &mut window);
        window
    }

    #[test]
    fn a_window_of_the_same_size_shows_the_pixels() {
        let picture = gradient();
        assert_eq!(drawn(&picture, 4, 2), picture.pixels);
        assert_eq!(picture.pixels[5], 0x0032_64c8);
    }

    #[test]
    fn the_picture_keeps_its_proportions_in_the_middle() {
        let picture = gradient();
        let tall = drawn(&picture, 4, 6);
        assert_eq!(tall[..8], [SURROUNDINGS; 8]);
        assert_eq!(tall[8..16], picture.pixels[..]);
        assert_eq!(tall[16..], [SURROUNDINGS; 8]);
        let wide = drawn(&picture, 8, 2);
        assert_eq!((wide[1], wide[2], wide[6]), (SURROUNDINGS, picture.pixels[0], SURROUNDINGS));
    }

    #[test]
    fn smaller_windows_show_means() {
        // (0 + 10 + 40 + 50) / 4 and (20 + 30 + 60 + 70) / 4
        assert_eq!(drawn(&gradient(), 2, 1), [0x0019_64c8, 0x002d_64c8]);
    }

    #[test]
    fn positions_are_taken_back() {
        let picture = gradient();
        for (width, height) in [(4, 2), (9, 2), (3, 17), (400, 300), (1, 1)] {
            let placement = picture.place(width, height);
            let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 1e-9 && (a.1 - b.1).abs() < 1e-9;
            let (x, y) = (f64::from(placement.corner.0), f64::from(placement.corner.1));
            assert!(near(placement.to_picture(x, y), (0.0, 0.0)));
            let (right, lower) = (x + f64::from(placement.size.0), y + f64::from(placement.size.1));
            assert!(near(placement.to_picture(right, lower), (4.0, 2.0)));
        }
    }

    #[test]
    fn windows_without_size_and_large_ones_do_no_harm() {
        let picture = gradient();
        for (width, height) in [(0, 0), (0, 5), (5, 0), (1, 1), (333, 77)] {
            drawn(&picture, width, height);
        }
        let white = Picture::new(7, 5);
        assert!(drawn(&white, 333, 238).iter().filter(|&&p| p != SURROUNDINGS).all(|&p| p == 0x00ff_ffff));
    }
}
