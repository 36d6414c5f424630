//! The null workstation: accepts everything and draws nothing, to see what drawing costs without a device.

use crate::options::Options;
use gks_pipeline::description::{
    Category, Classification, DeferralMode, Description, DynamicModification, DynamicModifications,
    RegenerationMode,
};
use gks_pipeline::device::{Device, DeviceError, Drawn, Mark, Page, Surface};

/// Width and height of the display surface in pixels unless options say otherwise.
const SIDE: f64 = 1000.0;
/// Pixels per inch unless options say otherwise.
const DPI: f64 = 127.0;

/// A workstation that draws nothing, with the display surface of a raster.
#[derive(Debug)]
pub struct Null {
    surface: Surface,
}

impl Null {
    /// A workstation with the surface that the options ask for. Of the options it heeds size, resolution and
    /// landscape.
    pub fn new(options: &Options) -> Null {
        Null { surface: surface(options) }
    }
}

/// The description of the workstation type with this number and name when it is opened with these options.
pub fn describe(number: i32, name: &'static str, options: &Options) -> Description {
    let surface = surface(options);
    Description {
        number,
        name,
        category: Category::Output,
        classification: Classification::Raster,
        raster: (surface.width as u32, surface.height as u32),
        surface,
        colours: 0,
        dynamic: DynamicModifications {
            line_bundles: DynamicModification::Imm,
            marker_bundles: DynamicModification::Imm,
            text_bundles: DynamicModification::Imm,
            fill_bundles: DynamicModification::Imm,
            patterns: DynamicModification::Imm,
            colours: DynamicModification::Imm,
            transformation: DynamicModification::Irg,
        },
        deferral: DeferralMode::Asti,
        regeneration: RegenerationMode::Suppressed,
    }
}

fn surface(options: &Options) -> Surface {
    let (width, height) = options.size_or((SIDE, SIDE));
    let unit = 0.0254 / options.dpi.unwrap_or(DPI);
    Surface { width, height, unit, y_down: true, resolution: 1.0, pen: None }
}

impl Device for Null {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, _page: &Page) -> Result<(), DeviceError> {
        Ok(())
    }

    fn draw(&mut self, _mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}
