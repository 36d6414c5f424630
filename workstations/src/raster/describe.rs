//! The descriptions of raster workstations, and the display surface that options ask for.

use crate::options::Options;
use gks_pipeline::description::{
    Category, Classification, DeferralMode, Description, DynamicModification, DynamicModifications,
    RegenerationMode, SegmentModifications,
};
use gks_pipeline::device::Surface;

/// Width and height of the display surface in pixels unless options say otherwise.
const DEFAULT_SIDE: u32 = 1000;
/// Pixels per inch unless options say otherwise: 1000 pixels are 0.2 m.
const DEFAULT_DPI: f64 = 127.0;
/// The longest side of a display surface in pixels.
const LONGEST_SIDE: u32 = 32767;
/// The largest number of pixels of a display surface.
const MOST_PIXELS: u64 = 1 << 28;

/// Why no frame buffer can be made by some options.
#[derive(Copy, Clone, Debug, PartialEq, thiserror::Error)]
pub enum SizeError {
    /// The width or the height is out of range.
    #[error("{0} x {1} pixels: width and height must be 1 to {2} pixels")]
    Side(f64, f64, u32),
    /// The frame buffer would be too large.
    #[error("{0} x {1} pixels: no more than {MOST_PIXELS} pixels are possible")]
    Pixels(u32, u32),
    /// The resolution makes no sense.
    #[error("{0} pixels per inch: the resolution must be 1 to 100000")]
    Resolution(f64),
}

/// Size and resolution of a raster.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Layout {
    /// Number of columns.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// Side of a pixel in metres.
    pub pixel: f64,
}

impl Layout {
    /// The raster that options ask for, at most `longest` pixels wide and high.
    pub(super) fn limited(options: &Options, longest: u32) -> Result<Self, SizeError> {
        let longest = longest.min(LONGEST_SIDE);
        let default = f64::from(DEFAULT_SIDE);
        let (w, h) = options.size.unwrap_or((default, default));
        let fits = |side: f64| (0.5..f64::from(longest) + 0.5).contains(&side);
        if !fits(w) || !fits(h) {
            return Err(SizeError::Side(w, h, longest));
        }
        let (mut width, mut height) = (w.round() as u32, h.round() as u32);
        if options.landscape.is_some_and(|landscape| landscape != (width >= height) && width != height) {
            (width, height) = (height, width);
        }
        if u64::from(width) * u64::from(height) > MOST_PIXELS {
            return Err(SizeError::Pixels(width, height));
        }
        let dpi = options.dpi.unwrap_or(DEFAULT_DPI);
        if !(1.0..=100_000.0).contains(&dpi) {
            return Err(SizeError::Resolution(dpi));
        }
        Ok(Layout { width, height, pixel: 0.0254 / dpi })
    }

    /// The raster that options ask for: 1000 x 1000 pixels at 127 pixels per inch where they are silent.
    pub fn new(options: &Options) -> Result<Self, SizeError> {
        Self::limited(options, LONGEST_SIDE)
    }

    /// The raster as a display surface.
    pub fn surface(&self) -> Surface {
        Surface {
            width: f64::from(self.width),
            height: f64::from(self.height),
            unit: self.pixel,
            y_down: true,
            resolution: 1.0,
            pen: None,
        }
    }

    /// The number of pixels.
    pub(super) fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }
}

/// The description of a true-colour frame buffer or image file.
pub fn true_colour(number: i32, name: &'static str, options: &Options) -> Result<Description, SizeError> {
    Ok(description(number, name, Layout::new(options)?, 0))
}

/// The description of an indexed frame buffer or image file.
pub fn indexed(number: i32, name: &'static str, options: &Options) -> Result<Description, SizeError> {
    // The colour of an index is that of all its pixels.
    let dynamic = DynamicModifications { colours: DynamicModification::Imm, ..DynamicModifications::REDRAWN };
    Ok(Description { dynamic, ..description(number, name, Layout::new(options)?, 256) })
}

fn description(number: i32, name: &'static str, layout: Layout, colours: u32) -> Description {
    Description {
        number,
        name,
        category: Category::Output,
        classification: Classification::Raster,
        surface: layout.surface(),
        raster: (layout.width, layout.height),
        colours,
        dynamic: DynamicModifications::REDRAWN,
        deferral: DeferralMode::Asti,
        regeneration: RegenerationMode::Suppressed,
        segments: SegmentModifications::REDRAWN,
        input: [0; 6],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Indexed, TrueColour};
    use gks_pipeline::colour::Colour;
    use gks_pipeline::device::{Device, Page};

    fn sized(width: f64, height: f64) -> Options {
        Options { size: Some((width, height)), ..Options::default() }
    }

    #[test]
    fn the_default_surface_is_a_square_of_a_fifth_of_a_metre() {
        let d = true_colour(1, "x", &Options::default()).unwrap();
        assert_eq!((d.raster, d.colours), ((1000, 1000), 0));
        assert!((d.size().0 - 0.2).abs() < 1e-12 && (d.size().1 - 0.2).abs() < 1e-12);
        assert_eq!(d.surface.nominal_linewidth(), 1.0);
        assert_eq!(indexed(1, "x", &Options::default()).unwrap().colours, 256);
    }

    #[test]
    fn sizes_are_checked() {
        assert_eq!(Layout::new(&sized(639.6, 480.0)).unwrap().width, 640);
        assert!(Layout::new(&sized(32767.0, 8192.0)).is_ok());
        for (w, h) in [(0.0, 5.0), (5.0, -1.0), (f64::NAN, 5.0), (f64::INFINITY, 5.0), (32768.0, 1.0)] {
            assert!(matches!(Layout::new(&sized(w, h)), Err(SizeError::Side(..))), "{w} x {h}");
        }
        assert_eq!(Layout::new(&sized(32767.0, 32767.0)), Err(SizeError::Pixels(32767, 32767)));
        for dpi in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let options = Options { dpi: Some(dpi), ..Options::default() };
            assert!(matches!(Layout::new(&options), Err(SizeError::Resolution(_))), "{dpi}");
        }
    }

    #[test]
    fn landscape_turns_the_surface() {
        let turned = |landscape| {
            let layout = Layout::new(&Options { landscape, ..sized(300.0, 200.0) }).unwrap();
            (layout.width, layout.height)
        };
        assert_eq!(turned(None), (300, 200));
        assert_eq!(turned(Some(true)), (300, 200));
        assert_eq!(turned(Some(false)), (200, 300));
    }

    #[test]
    fn colours_that_change_at_once_are_described_so() {
        let options = sized(4.0, 4.0);
        let indexed: Box<dyn Device> = Box::new(Indexed::new(&options, None).unwrap());
        let true_colour: Box<dyn Device> = Box::new(TrueColour::new(&options, None).unwrap());
        for (mut device, described) in
            [(indexed, super::indexed(1, "x", &options)), (true_colour, super::true_colour(1, "x", &options))]
        {
            let colours = vec![(0, Colour::WHITE), (1, Colour::BLACK)];
            device.begin(&Page { number: 1, background: Colour::WHITE, colours }).unwrap();
            let buffer = device.frame_buffer().unwrap();
            let changed = buffer.set_colour(0, Colour::rgb(1.0, 0.0, 0.0));
            let shown = if changed { Colour::rgb(1.0, 0.0, 0.0) } else { Colour::WHITE };
            assert_eq!(buffer.colour(1, 1), Some(shown));
            assert_eq!(described.unwrap().dynamic.colours == DynamicModification::Imm, changed);
        }
    }
}
