//! Blending of colours into pixels by T. Porter and T. Duff, "Compositing Digital Images", 1984: source over
//! destination, premultiplied by opacity.

use gks_pipeline::colour::Colour;
use tiny_skia::{Color, ColorU8, PremultipliedColorU8};

/// A pixel of the frame buffer.
pub(super) type Pixel = PremultipliedColorU8;

/// The pixel that shows a colour alone.
pub(super) fn pixel(colour: Colour) -> Pixel {
    let [r, g, b, a] = colour.to_bytes();
    ColorU8::from_rgba(r, g, b, a).premultiply()
}

/// The colour that a pixel shows.
pub(super) fn colour(pixel: Pixel) -> Colour {
    let c = pixel.demultiply();
    let [red, green, blue, alpha] = [c.red(), c.green(), c.blue(), c.alpha()].map(|v| f32::from(v) / 255.0);
    Colour { red, green, blue, alpha }
}

/// A colour as the scan converter takes it, rounded like [`pixel`].
pub(super) fn skia(colour: Colour) -> Color {
    let [r, g, b, a] = colour.to_bytes();
    Color::from_rgba8(r, g, b, a)
}

/// `a` times `b` for numbers that stand for 0 to 1 as 0 to 255, rounded to nearest.
#[inline]
pub(super) fn times(a: u8, b: u8) -> u8 {
    let p = u32::from(a) * u32::from(b) + 128;
    ((p + (p >> 8)) >> 8) as u8
}

/// Puts a colour over a pixel of which `coverage` of 255 parts are covered.
#[inline]
pub(super) fn over(below: &mut Pixel, above: Pixel, coverage: u8) {
    if coverage == 255 && above.alpha() == 255 {
        *below = above;
        return;
    }
    if coverage == 0 {
        return;
    }
    let rest = 255 - times(above.alpha(), coverage);
    let mix = |a: u8, b: u8| times(a, coverage).saturating_add(times(b, rest));
    let alpha = mix(above.alpha(), below.alpha());
    let channel = |a: u8, b: u8| mix(a, b).min(alpha);
    if let Some(mixed) = Pixel::from_rgba(
        channel(above.red(), below.red()),
        channel(above.green(), below.green()),
        channel(above.blue(), below.blue()),
        alpha,
    ) {
        *below = mixed;
    }
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
    }

    #[test]
    fn opaque_stays_opaque() {
        for coverage in 0..=255 {
            for alpha in [0.0, 0.3, 0.99, 1.0] {
                let mut p = pixel(Colour::rgb(0.2, 0.4, 0.6));
                over(&mut p, pixel(Colour { red: 1.0, green: 0.9, blue: 0.1, alpha }), coverage);
                assert_eq!(p.alpha(), 255);
            }
        }
    }
}
