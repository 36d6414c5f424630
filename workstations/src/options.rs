//! What a user chooses for one workstation beside its type: size, resolution, orientation, background.

use gks_pipeline::colour::Colour;

/// The choices, each absent where the user leaves it to the driver.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Width and height of the display surface in the device's customary unit: pixels for raster, points
    /// (1/72 inch) for SVG, PDF and PostScript, millimetres for plotters.
    pub size: Option<(f64, f64)>,
    /// Pixels per inch of a raster device.
    pub dpi: Option<f64>,
    /// The wider side horizontally (`Some(true)`) or vertically.
    pub landscape: Option<bool>,
    /// The background instead of colour index 0.
    pub background: Option<Colour>,
    /// No background at all where the format can leave it out.
    pub transparent: bool,
    /// Antialiasing of a raster device.
    pub antialias: Option<bool>,
    /// Characters as outlines instead of text.
    pub outlines: bool,
    /// Quality of lossy formats from 1 to 100.
    pub quality: Option<u8>,
}
