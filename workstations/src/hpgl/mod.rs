//! Pen plotters that read HP-GL: only straight solid lines, each with one of a few pens.
//!
//! The instructions are those that every plotter since the HP 7470A and every reader of HP-GL knows: IN, IP, SP,
//! PU and PD with absolute positions in plotter units of 0.025 mm. The origin is the lower left corner; a
//! plotter whose origin is the middle of the sheet must be told to move it. A surface that is higher than
//! wide is for a plotter whose sheet lies so; others rotate it on their panel.

mod plot;

use crate::options::Options;
use gks_pipeline::description::{
    Category, Classification, DeferralMode, Description, DynamicModifications, RegenerationMode,
    SegmentModifications,
};
use gks_pipeline::device::{Device, DeviceError, Drawn, Form, Mark, Page, Sink, Surface};
use plot::Plot;

/// Plotter units in a millimetre.
const UNITS: f64 = 40.0;

/// What a driver must know about a plotter.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Profile {
    /// Width and height of the area that pens reach, in millimetres.
    pub area: (f64, f64),
    /// Number of pens.
    pub pens: u32,
    /// Width of the lines that a pen draws, in millimetres.
    pub tip: f64,
}

impl Profile {
    /// A4 paper on any plotter with up to eight pens: the 7470A reaches 10900 x 7650 plotter units of the
    /// sheet, the 7475A 11040 x 7721, the 7550A 10870 x 7600, and this is the least of them.
    pub const A4: Profile = Profile { area: (10870.0 / UNITS, 7600.0 / UNITS), pens: 8, tip: 0.3 };

    /// The pen for a colour index: none for 0, which is the paper; the first pen for 1, and so on, over and
    /// over again.
    pub fn pen(&self, index: u32) -> Option<u32> {
        index.checked_sub(1).map(|i| i % self.pens.max(1) + 1)
    }

    /// The display surface, with the size and orientation that the options ask for.
    fn surface(&self, options: &Options) -> Surface {
        let (width, height) = options.size_or(self.area);
        Surface {
            width: (width * UNITS).round().max(1.0),
            height: (height * UNITS).round().max(1.0),
            unit: 0.001 / UNITS,
            y_down: false,
            resolution: 1.0,
            pen: Some(self.tip * UNITS),
        }
    }
}

/// A plotter, which draws each page on a sheet of its own: one document for each page.
pub struct Hpgl {
    profile: Profile,
    surface: Surface,
    sink: Box<dyn Sink>,
    plot: Plot,
}

impl Hpgl {
    /// A plotter for A4 paper. Of the options it heeds size, in millimetres, and landscape.
    pub fn new(sink: Box<dyn Sink>, options: &Options) -> Hpgl {
        Hpgl::with_profile(sink, options, Profile::A4)
    }

    /// A plotter of another make.
    pub fn with_profile(sink: Box<dyn Sink>, options: &Options, profile: Profile) -> Hpgl {
        Hpgl { profile, surface: profile.surface(options), sink, plot: Plot::default() }
    }
}

/// The description of the workstation type with this number and name when it is opened with these options.
pub fn describe(number: i32, name: &'static str, options: &Options) -> Description {
    let surface = Profile::A4.surface(options);
    Description {
        number,
        name,
        category: Category::Output,
        classification: Classification::Vector,
        raster: (surface.width as u32, surface.height as u32),
        surface,
        // Every index may be set; which pen draws it is a matter of the profile.
        colours: 0,
        dynamic: DynamicModifications::REDRAWN,
        deferral: DeferralMode::Asti,
        regeneration: RegenerationMode::Suppressed,
        segments: SegmentModifications::REDRAWN,
        input: [0; 6],
    }
}

impl Device for Hpgl {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, _page: &Page) -> Result<(), DeviceError> {
        self.sink.open()?;
        self.plot.start(self.surface.width, self.surface.height);
        Ok(())
    }

    fn erase(&mut self, _page: &Page) -> Result<Drawn, DeviceError> {
        if !self.sink.restart()? {
            return Ok(Drawn::No);
        }
        self.plot.start(self.surface.width, self.surface.height);
        Ok(Drawn::Yes)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let (Form::Lines(paths, pen), None) = (&mark.form, &mark.clip) else { return Ok(Drawn::No) };
        if !pen.dash.is_empty() {
            return Ok(Drawn::No);
        }
        let visible = pen.paint.colour.alpha > 0.0;
        if let Some(number) = self.profile.pen(pen.paint.index).filter(|_| visible) {
            self.plot.select(number);
            for path in paths.iter() {
                self.plot.line(path);
                self.plot.drain(&mut *self.sink, false)?;
            }
        }
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.plot.finish();
        self.plot.drain(&mut *self.sink, true)?;
        self.sink.finish()?;
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests;
