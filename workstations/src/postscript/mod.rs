//! PostScript: documents of any number of pages for printers, and encapsulated pictures of one page.
//!
//! Both follow the Document Structuring Conventions 3.0. Pages are written as they are drawn; at most
//! [`HELD`] bytes of a page description are held back, for the sake of its fonts and its bounding box. Lines, dashes,
//! areas, curves, cell arrays and clipping rectangles become what PostScript calls so, and text stays text in
//! embedded Type 42 fonts; markers and patterns are left to the pipeline. Images are deflated, which
//! takes language level 3.
//!
//! PostScript has no opacity: what is not fully transparent is drawn opaque.

mod ascii85;
mod bounds;
mod document;
mod font;
mod image;
mod prolog;

use crate::deflate::Deflate;
use crate::options::Options;
use crate::paper;
use crate::pdf::content::{Content, Language, STEPS};
use crate::pdf::image::{Opacity, Samples};
use crate::route::Route;
use document::{Document, Kind};
use gks_geometry::{Du, Rect, Vector};
use gks_pipeline::description::Description;
use gks_pipeline::device::{Device, DeviceError, Drawn, Fill, Form, Grid, Mark, Page, Sink, Surface};
use gks_pipeline::item::{Ellipse, Parallelogram};

/// How many bytes of a page description are held back at most, but for the text of one mark.
pub const HELD: usize = 1 << 20;

/// A PostScript document, or a sequence of encapsulated pictures.
pub struct PostScript {
    surface: Surface,
    options: Options,
    kind: Kind,
    content: Content,
    route: Route,
    document: Document,
    deflate: Deflate,
}

/// The description of a workstation that writes PostScript, encapsulated or not.
pub fn describe(number: i32, name: &'static str, options: &Options) -> Description {
    paper::description(number, name, options)
}

impl PostScript {
    /// A document of all pages for printers, that goes to `sink`; nothing is written before the first page.
    pub fn new(sink: Box<dyn Sink>, options: &Options) -> Self {
        PostScript::of_kind(sink, options, Kind::Printed)
    }

    /// Encapsulated PostScript, a document for each page.
    pub fn encapsulated(sink: Box<dyn Sink>, options: &Options) -> Self {
        PostScript::of_kind(sink, options, Kind::Encapsulated)
    }

    fn of_kind(sink: Box<dyn Sink>, options: &Options, kind: Kind) -> Self {
        let surface = paper::surface(options);
        let size = (surface.width, surface.height);
        let route = Route::new(STEPS, options.tolerance(&surface));
        PostScript {
            surface,
            options: options.clone(),
            kind,
            content: Content::new(Language::PostScript, HELD),
            route,
            document: Document::new(sink, kind, size),
            deflate: Deflate::new(options.small),
        }
    }

    fn cells(
        &mut self,
        mark: &Mark<'_>,
        seen: Option<Rect<Du>>,
        place: &Parallelogram<Du>,
        grid: Grid<'_>,
    ) -> Result<Drawn, DeviceError> {
        let PostScript { content, document, deflate, .. } = self;
        let mut samples = Samples::new(grid);
        match samples.opacity() {
            Opacity::Even(0) => return Ok(Drawn::Yes),
            // Holes cannot be seen through in an image, so the cells must be drawn one by one.
            Opacity::Varied(true) => return Ok(Drawn::No),
            Opacity::Even(_) | Opacity::Varied(false) => {}
        }
        document.bounds.ink(&mark.form, seen.as_ref());
        content.clip(mark.clip.as_ref());
        image::draw(place, &mut samples, content, document, deflate)?;
        content.relieve(document)?;
        Ok(Drawn::Yes)
    }

    /// Writes a mark where it is clipped already, or refuses it; its ink is seen inside of a rectangle.
    fn mark(&mut self, mark: &Mark<'_>, seen: Option<Rect<Du>>) -> Result<Drawn, DeviceError> {
        let colour = match &mark.form {
            Form::Markers(..)
            | Form::Area(_, _, Fill::Pattern(..))
            | Form::StrokeText(_)
            | Form::IndexedCells(..) => return Ok(Drawn::No),
            Form::Text(run) if self.options.outlines || run.face.glyphs() == 0 => return Ok(Drawn::No),
            Form::Cells(place, grid) => return self.cells(mark, seen, place, *grid),
            Form::Lines(_, pen) | Form::LongLine(_, pen) | Form::Stroke(_, pen) => pen.paint.colour,
            Form::Area(_, _, Fill::Solid(paint)) | Form::Filled(_, paint) => paint.colour,
            Form::Text(run) => run.paint.colour,
        };
        if colour.to_bytes()[3] == 0 {
            return Ok(Drawn::Yes);
        }
        let PostScript { content, document, route, .. } = self;
        document.bounds.ink(&mark.form, seen.as_ref());
        content.clip(mark.clip.as_ref());
        match &mark.form {
            Form::Lines(paths, pen) => content.lines(paths, pen, route, document)?,
            Form::LongLine(line, pen) => content.lines(line, pen, route, document)?,
            Form::Stroke(curve, pen) => content.stroke(curve, pen, document)?,
            Form::Filled(curve, _) => content.filled(curve, colour, document)?,
            Form::Area(rings, rule, _) => content.area(*rings, *rule, colour, route, document)?,
            Form::Text(run) => document.fonts.draw(run, content),
            Form::Cells(..) | Form::Markers(..) | Form::StrokeText(_) | Form::IndexedCells(..) => {
                return Ok(Drawn::No);
            }
        }
        content.relieve(document)?;
        Ok(Drawn::Yes)
    }

    /// Starts the description of a page.
    fn start(&mut self, page: &Page) {
        self.content.begin();
        if let Some(colour) = paper::background(&self.options, page) {
            let extent = self.surface.extent();
            self.content.fill_rectangle(&extent, colour);
            self.document.bounds.rect(&extent);
        }
    }
}

impl Device for PostScript {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.document.begin_page()?;
        self.start(page);
        Ok(())
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        if !self.document.restart_page() {
            return Ok(Drawn::No);
        }
        self.start(page);
        Ok(Drawn::Yes)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        self.content.region(None, &mut self.document)?;
        self.mark(mark, mark.clip)
    }

    fn draw_within(&mut self, mark: &Mark<'_>, region: &Ellipse<Du>) -> Result<Drawn, DeviceError> {
        self.content.region(Some(region), &mut self.document)?;
        let reach = Vector::from_vec(region.a.0.abs() + region.b.0.abs());
        let around = Rect::around([region.centre - reach, region.centre + reach]);
        let seen =
            around.and_then(|around| mark.clip.map_or(Some(around), |clip| clip.intersection(&around)));
        // What lies beside the ellipse has no ink that a bounding box would hold.
        if seen.is_none() {
            return Ok(Drawn::Yes);
        }
        self.mark(mark, seen)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.content.region(None, &mut self.document)?;
        self.content.clip(None);
        self.document.end_page(self.content.text())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        if self.kind == Kind::Encapsulated { Ok(()) } else { self.document.close() }
    }
}
