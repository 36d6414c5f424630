//! The null workstation: accepts everything and draws nothing, to see what drawing costs without a device.

use crate::options::Options;
use crate::raster::{Layout, SizeError};
use gks_pipeline::device::{Device, DeviceError, Drawn, Mark, Page, Surface};

/// A workstation that draws nothing, with the display surface of a raster.
#[derive(Debug)]
pub struct Null {
    surface: Surface,
}

impl Null {
    /// A workstation with the surface that a raster would have with these options.
    pub fn new(options: &Options) -> Result<Null, SizeError> {
        Ok(Null { surface: Layout::new(options)?.surface() })
    }
}

impl Device for Null {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.begin(page)?;
        Ok(Drawn::Yes)
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

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::{Du, PathBuf};
    use gks_pipeline::colour::{Colour, Paint};
    use gks_pipeline::device::{Fill, Form, Rule};

    #[test]
    fn everything_is_accepted() {
        let mut null = Null::new(&Options { size: Some((30.0, 20.0)), ..Options::default() }).unwrap();
        assert_eq!((null.surface().width, null.surface().height), (30.0, 20.0));
        let page = Page { number: 1, background: Colour::WHITE, colours: Vec::new() };
        null.begin(&page).unwrap();
        let paths = PathBuf::<Du>::new();
        let fill = Fill::Solid(Paint { colour: Colour::BLACK, index: 1 });
        let form = Form::Area(paths.as_paths(), Rule::EvenOdd, fill);
        let mark = Mark { form, clip: Some(null.surface().extent()) };
        assert_eq!(null.draw(&mark).unwrap(), Drawn::Yes);
        null.end().unwrap();
        null.close().unwrap();
        assert!(Null::new(&Options { size: Some((0.0, 20.0)), ..Options::default() }).is_err());
    }
}
