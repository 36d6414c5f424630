//! The band of highlighting for metafiles: lines that come back as primitives.
//!
//! There is no second way to highlight: a [`Band`] is a device on which the ordinary painter paints the band of a
//! primitive; it takes the solid lines of which a band consists back to NDC.

use crate::device::{Device, DeviceError, Drawn, Form, Mark, Page, Pen, Surface};
use crate::item::{Item, Shape};
use crate::look::{AspectSourceFlags, Look};
use gks_geometry::{Du, Map, Ndc, PathBuf, Rect};

/// Lines of one pen in NDC.
pub(crate) struct Band {
    surface: Surface,
    back: Map<Du, Ndc>,
    lines: Vec<(PathBuf<Ndc>, Look)>,
}

impl Band {
    /// No lines yet, on a display surface to which `map` leads.
    pub(crate) fn new(surface: &Surface, map: &Map<Ndc, Du>) -> Band {
        let back = map.inverse().unwrap_or(Map::IDENTITY);
        Band { surface: surface.clone(), back, lines: Vec::new() }
    }

    /// The lines as primitives, clipped at a rectangle.
    pub(crate) fn items(&self, clip: Rect<Ndc>) -> impl Iterator<Item = Item<'_>> {
        self.lines.iter().map(move |(lines, look)| Item {
            shape: Shape::Polyline(lines.as_paths()),
            look,
            clip,
            pick: 0,
        })
    }

    /// The polyline attributes that mean a solid pen.
    fn look(&self, pen: &Pen<'_>) -> Look {
        let mut look =
            Look { sources: AspectSourceFlags::INDIVIDUAL, cap: pen.cap, join: pen.join, ..Look::default() };
        look.line.linetype = 1;
        look.line.width = pen.width / self.surface.nominal_linewidth();
        look.line.colour = pen.paint.index;
        look
    }
}

impl Device for Band {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, _page: &Page) -> Result<(), DeviceError> {
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let (Form::Lines(paths, pen), None) = (&mark.form, &mark.clip) else { return Ok(Drawn::No) };
        if !pen.dash.is_empty() {
            return Ok(Drawn::No);
        }
        let mut lines = PathBuf::new();
        lines.add_mapped(*paths, &self.back);
        self.lines.push((lines, self.look(pen)));
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}
