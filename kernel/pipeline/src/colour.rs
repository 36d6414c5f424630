//! Colours as colour representations give them.

/// A colour: red, green and blue intensities and opacity, each from 0 to 1, not premultiplied (sRGB).
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Colour {
    /// Intensity of red.
    pub red: f32,
    /// Intensity of green.
    pub green: f32,
    /// Intensity of blue.
    pub blue: f32,
    /// Opacity: 1 covers, 0 leaves what is below. Beyond the standard.
    pub alpha: f32,
}

impl Colour {
    /// Black, opaque.
    pub const BLACK: Colour = Colour::rgb(0.0, 0.0, 0.0);
    /// White, opaque.
    pub const WHITE: Colour = Colour::rgb(1.0, 1.0, 1.0);

    /// The opaque colour with these intensities.
    pub const fn rgb(red: f32, green: f32, blue: f32) -> Self {
        Colour { red, green, blue, alpha: 1.0 }
    }

    /// The colour that a packed colour index holds in itself, if it is one.
    ///
    /// Bit 30 marks it, bit 31 is clear; below are 6 bits of opacity and 8 bits each of red, green and blue. Programs
    /// of NCAR Graphics have more colours in this way than a table has.
    #[inline]
    pub fn of_packed_index(index: u32) -> Option<Self> {
        const MARK: u32 = 1 << 30;
        let bits = |shift: u32, most: u32| (index >> shift & most) as f32 / most as f32;
        let colour =
            || Colour { red: bits(16, 255), green: bits(8, 255), blue: bits(0, 255), alpha: bits(24, 63) };
        (index & 3 << 30 == MARK).then(colour)
    }

    /// The opaque colour of red, green and blue of 8 bits each, as in 0xff8000 for orange.
    pub fn from_packed(rgb: u32) -> Self {
        let [_, red, green, blue] = rgb.to_be_bytes().map(|byte| f32::from(byte) / 255.0);
        Colour::rgb(red, green, blue)
    }

    /// The four components as bytes, rounded to nearest.
    #[inline]
    pub fn to_bytes(self) -> [u8; 4] {
        [self.red, self.green, self.blue, self.alpha].map(|c| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8)
    }

    /// Whether the three intensities are components in the range of the standard, 0 to 1.
    pub fn is_valid(&self) -> bool {
        [self.red, self.green, self.blue, self.alpha].iter().all(|c| (0.0..=1.0).contains(c))
    }
}

impl From<(f64, f64, f64)> for Colour {
    /// The opaque colour with the intensities (red, green, blue).
    fn from((red, green, blue): (f64, f64, f64)) -> Self {
        Colour::rgb(red as f32, green as f32, blue as f32)
    }
}

/// A colour together with the colour index that led to it: a plotter picks its pen by the index, an
/// indexed frame buffer stores it, every other device uses the colour.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Paint {
    /// The colour of the index in the colour table of the workstation.
    pub colour: Colour,
    /// The colour index as the application gave it, or the index that replaced it if it is not in the table.
    pub index: u32,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packed_indices_hold_a_colour() {
        let half_blue = Colour { alpha: 21.0 / 63.0, ..Colour::rgb(0.0, 0.0, 1.0) };
        assert_eq!(Colour::of_packed_index(1 << 30 | 21 << 24 | 0xff), Some(half_blue));
        assert_eq!(Colour::of_packed_index(0x7fff_ffff), Some(Colour::WHITE));
        for index in [0, 65_535, (1 << 30) - 1, 1 << 31, u32::MAX] {
            assert_eq!(Colour::of_packed_index(index), None, "{index}");
        }
    }
}
