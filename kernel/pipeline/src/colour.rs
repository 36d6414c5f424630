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

    /// The opaque colour of red, green and blue of 8 bits each, as in 0xff8000 for orange.
    pub fn from_packed(rgb: u32) -> Self {
        let [_, red, green, blue] = rgb.to_be_bytes().map(|byte| f32::from(byte) / 255.0);
        Colour::rgb(red, green, blue)
    }

    /// The four components as bytes, rounded to nearest.
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
