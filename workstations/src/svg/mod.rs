//! Scalable Vector Graphics: one document of SVG 1.1 for each page.
//!
//! Marks stay what they are: lines are paths with native dashes, circles are circles, text is text, clipping
//! is clipping. The document is written while it is drawn, however long it gets; successive marks that look
//! alike share a group, so that attributes are not repeated. The same marks give the same bytes.
//!
//! One user unit is 0.2 mm, so that the default surface of 200 mm x 200 mm has 1000 x 1000 of them, and the
//! nominal linewidth is 1. Numbers have two decimal places. Source: Scalable Vector Graphics (SVG) 1.1
//! (Second Edition), W3C Recommendation 16 August 2011.

mod base64;
mod cells;
mod curve;
mod document;
mod line;
mod path;
mod subset;
mod text;

use crate::number::Decimal;
use crate::options::Options;
use crate::route::Route;
use document::Document;
use gks_geometry::Du;
use gks_pipeline::colour::Colour;
use gks_pipeline::description::{
    Category, Classification, DeferralMode, Description, DynamicModifications, RegenerationMode,
    SegmentModifications,
};
use gks_pipeline::device::{
    Device, DeviceError, Drawn, Fill, Form, Mark, MarkerStyle, Page, Pen, Sink, Surface,
};
use gks_pipeline::item::Ellipse;
use gks_pipeline::look::{Cap, Join};
use text::Fonts;

/// How coordinates are written.
const COORDINATE: Decimal = Decimal::new(2).bare();

/// How angles, sizes and coefficients of matrices are written, which multiply distances.
const FINE: Decimal = Decimal::new(5).bare();

/// The length of a user unit in metres.
const UNIT: f64 = 0.0002;

/// Points (1/72 inch) in a metre.
const POINTS: f64 = 72.0 / 0.0254;

/// The sides of the default surface in user units.
const SIDE: f64 = 1000.0;

/// The marker types that are drawn as circles and discs.
const CIRCLE: i32 = 4;
const DISC: i32 = -9;

/// A workstation that writes SVG.
pub struct Svg {
    surface: Surface,
    document: Document,
    background: Option<Colour>,
    transparent: bool,
    outlines: bool,
    fonts: Fonts,
    route: Route,
}

impl Svg {
    /// A workstation that opens a document in `sink` for each page. Of the options it heeds size, landscape,
    /// background, transparent, outlines and reduce.
    pub fn new(sink: Box<dyn Sink>, options: &Options) -> Self {
        Svg {
            surface: surface(options),
            document: Document::new(sink),
            background: options.background,
            transparent: options.transparent,
            outlines: options.outlines,
            fonts: Fonts::default(),
            route: Route::new(COORDINATE, options.tolerance(&surface(options))),
        }
    }
}

/// The description of the workstation type with this number and name when it is opened with these options.
pub fn describe(number: i32, name: &'static str, options: &Options) -> Description {
    let surface = surface(options);
    Description {
        number,
        name,
        category: Category::Output,
        classification: Classification::Vector,
        raster: (surface.width.round() as u32, surface.height.round() as u32),
        surface,
        colours: 0,
        dynamic: DynamicModifications::REDRAWN,
        deferral: DeferralMode::Asti,
        regeneration: RegenerationMode::Suppressed,
        segments: SegmentModifications::REDRAWN,
        input: [0; 6],
    }
}

/// The surface that the options ask for; a size that is none (not positive, not finite, beyond a kilometre)
/// is replaced by the default.
fn surface(options: &Options) -> Surface {
    let side = |points: f64| Some(points / POINTS / UNIT).filter(|side| *side > 0.1 && *side < 5e6);
    let asked = options.size.and_then(|(width, height)| Some((side(width)?, side(height)?)));
    let (mut width, mut height) = asked.unwrap_or((SIDE, SIDE));
    if options.landscape.is_some_and(|landscape| landscape != (width >= height)) {
        std::mem::swap(&mut width, &mut height);
    }
    Surface { width, height, unit: UNIT, y_down: true, resolution: 0.01, pen: None }
}

impl Svg {
    /// Writes the beginning of a page.
    fn head(&mut self, page: &Page) {
        let Surface { width, height, unit, .. } = self.surface;
        let document = &mut self.document;
        self.fonts.clear();
        document
            .raw("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" ");
        document.raw("xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" width=\"");
        document.number(width * unit * 1000.0);
        document.raw("mm\" height=\"");
        document.number(height * unit * 1000.0);
        document.raw("mm\" viewBox=\"0 0 ");
        document.number(width);
        document.raw(" ");
        document.number(height);
        document.raw("\" fill=\"none\" fill-rule=\"evenodd\" stroke-miterlimit=\"10\"");
        // Else browsers move the edges of characters to pixels.
        document.raw(" text-rendering=\"geometricPrecision\">\n");
        document.raw(&format!("<title>Page {}</title>\n", page.number));
        if !self.transparent {
            document.raw("<rect");
            document.attribute("width", width);
            document.attribute("height", height);
            document::paint(&mut document.out, "fill", self.background.unwrap_or(page.background));
            document.raw("/>\n");
        }
    }

    /// Writes a mark where it is clipped already, or refuses it.
    fn mark(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let Svg { document, route, .. } = self;
        let clip = mark.clip.as_ref();
        match &mark.form {
            Form::Lines(paths, pen) => line::lines(document, route, clip, paths, pen)?,
            Form::LongLine(line, pen) => line::lines(document, route, clip, line, pen)?,
            Form::Area(rings, rule, Fill::Solid(paint)) => {
                line::area(document, route, clip, *rings, *rule, paint)?;
            }
            Form::Markers(positions, style @ MarkerStyle { kind: CIRCLE | DISC, .. }) => {
                let pen = Pen {
                    paint: style.paint,
                    width: style.width,
                    dash: &[],
                    cap: Cap::Butt,
                    join: Join::Miter,
                };
                curve::circles(document, clip, positions, style.size / 2.0, &pen, style.kind == DISC)?;
            }
            Form::Stroke(shape, pen) => curve::stroked(document, clip, shape, pen)?,
            Form::Filled(shape, paint) => curve::filled(document, clip, shape, paint)?,
            Form::Text(run) if !self.outlines => {
                if !self.fonts.draw(document, clip, run)? {
                    return Ok(Drawn::No);
                }
            }
            Form::Cells(place, grid) => cells::cells(document, clip, place, grid)?,
            Form::Area(_, _, Fill::Pattern(..))
            | Form::Markers(..)
            | Form::Text(_)
            | Form::StrokeText(_)
            | Form::IndexedCells(..) => return Ok(Drawn::No),
        }
        document.spill()?;
        Ok(Drawn::Yes)
    }
}

impl Device for Svg {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.document.open()?;
        self.head(page);
        Ok(())
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        if !self.document.restart()? {
            return Ok(Drawn::No);
        }
        self.head(page);
        Ok(Drawn::Yes)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        self.document.set_region(None, curve::region)?;
        self.mark(mark)
    }

    fn draw_within(&mut self, mark: &Mark<'_>, region: &Ellipse<Du>) -> Result<Drawn, DeviceError> {
        self.document.set_region(Some(region), curve::region)?;
        self.mark(mark)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.document.set_region(None, curve::region)?;
        self.document.close_groups();
        self.fonts.write(&mut self.document)?;
        self.document.raw("</svg>\n");
        Ok(self.document.finish()?)
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests;
