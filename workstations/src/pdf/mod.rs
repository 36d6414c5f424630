//! PDF documents of any number of pages.
//!
//! Pages are written as they are drawn: what is kept in memory is a piece of the page description, the offset of
//! each object in the file, and which characters of which fonts were used. Lines, dashes, areas, curves,
//! cell arrays and clipping rectangles become what PDF calls so, text stays text in embedded fonts;
//! markers and patterns are left to the pipeline.

pub(crate) mod content;
mod document;
mod font;
mod hint;
pub(crate) mod image;
pub(crate) mod run;
pub(crate) mod sfnt;
mod state;

use crate::options::Options;
use crate::paper;
use crate::route::Route;
use content::{Content, Language};
use document::Document;
use font::Fonts;
use gks_geometry::Du;
use gks_pipeline::description::Description;
use gks_pipeline::device::{Device, DeviceError, Drawn, Fill, Form, Mark, Page, Sink, Surface};
use gks_pipeline::item::Ellipse;
use pdf_writer::{Name, Ref, TextStr};
use std::collections::BTreeSet;

/// How many bytes of a page description are deflated at a time.
const PIECE: usize = 1 << 16;

/// A PDF document.
pub struct Pdf {
    surface: Surface,
    options: Options,
    content: Content,
    route: Route,
    document: Document,
    catalog: Option<(Ref, Ref)>,
    pages: Vec<Ref>,
    images: Vec<Ref>,
    fonts: Fonts,
    /// The fonts of the page, by their position among all.
    used: BTreeSet<usize>,
}

/// The description of a PDF workstation.
pub fn describe(number: i32, name: &'static str, options: &Options) -> Description {
    paper::description(number, name, options)
}

impl Pdf {
    /// A document that goes to `sink`; nothing is written before the first page.
    pub fn new(sink: Box<dyn Sink>, options: &Options) -> Self {
        Pdf {
            surface: paper::surface(options),
            options: options.clone(),
            content: Content::new(Language::Pdf, PIECE),
            route: Route::new(content::STEPS, options.tolerance(&paper::surface(options))),
            document: Document::new(sink, options.small),
            catalog: None,
            pages: Vec::new(),
            images: Vec::new(),
            fonts: Fonts::default(),
            used: BTreeSet::new(),
        }
    }

    /// Starts the description of a page.
    fn start(&mut self, page: &Page) {
        self.content.begin();
        self.images.clear();
        self.used.clear();
        if let Some(colour) = paper::background(&self.options, page) {
            self.content.fill_rectangle(&self.surface.extent(), colour);
        }
    }

    /// Writes a mark where it is clipped already, or refuses it.
    fn mark(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let Pdf { content, document, route, .. } = self;
        match &mark.form {
            Form::Markers(..)
            | Form::Area(_, _, Fill::Pattern(..))
            | Form::StrokeText(_)
            | Form::IndexedCells(..) => return Ok(Drawn::No),
            Form::Text(run) if self.options.outlines || run.face.glyphs() == 0 => return Ok(Drawn::No),
            _ => content.clip(mark.clip.as_ref()),
        }
        match &mark.form {
            Form::Lines(paths, pen) => content.lines(paths, pen, route, document)?,
            Form::LongLine(line, pen) => content.lines(line, pen, route, document)?,
            Form::Stroke(curve, pen) => content.stroke(curve, pen, document)?,
            Form::Filled(curve, paint) => content.filled(curve, paint.colour, document)?,
            Form::Area(rings, rule, Fill::Solid(paint)) => {
                content.area(*rings, *rule, paint.colour, route, document)?;
            }
            Form::Cells(place, grid) => image::draw(place, *grid, content, document, &mut self.images)?,
            Form::Text(run) => {
                self.used.insert(self.fonts.draw(run, content, document)?);
            }
            Form::Markers(..) | Form::Area(..) | Form::StrokeText(_) | Form::IndexedCells(..) => {
                return Ok(Drawn::No);
            }
        }
        self.content.relieve(&mut self.document)?;
        Ok(Drawn::Yes)
    }
}

impl Device for Pdf {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        if self.catalog.is_none() {
            self.document.open()?;
            self.catalog = Some((self.document.reserve()?, self.document.reserve()?));
        }
        self.start(page);
        Ok(())
    }

    /// What is in the file of the old description belongs to no page then.
    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.document.end_contents()?;
        self.start(page);
        Ok(Drawn::Yes)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        self.content.region(None, &mut self.document)?;
        self.mark(mark)
    }

    fn draw_within(&mut self, mark: &Mark<'_>, region: &Ellipse<Du>) -> Result<Drawn, DeviceError> {
        self.content.region(Some(region), &mut self.document)?;
        self.mark(mark)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        let Some((_, tree)) = self.catalog else { return Ok(()) };
        self.content.end(&mut self.document)?;
        let contents = self.document.end_contents()?;
        let id = self.document.reserve()?;
        let (width, height) = (self.surface.width as f32, self.surface.height as f32);
        let (images, opacities) = (&self.images, self.content.opacities());
        let fonts: Vec<(String, Ref)> =
            self.used.iter().filter_map(|&index| self.fonts.resource(index)).collect();
        self.document.object(id, |chunk| {
            let mut page = chunk.page(id);
            page.parent(tree).media_box(pdf_writer::Rect::new(0.0, 0.0, width, height));
            match contents[..] {
                [] => {}
                [only] => {
                    page.contents(only);
                }
                _ => {
                    page.contents_array(contents);
                }
            }
            let mut resources = page.resources();
            if !images.is_empty() {
                let mut named = resources.x_objects();
                for image in images {
                    named.pair(Name(format!("I{}", image.get()).as_bytes()), *image);
                }
            }
            if !fonts.is_empty() {
                let mut named = resources.fonts();
                for (name, id) in &fonts {
                    named.pair(Name(name.as_bytes()), *id);
                }
            }
            if !opacities.is_empty() {
                let mut named = resources.ext_g_states();
                for opacity in opacities {
                    let share = f32::from(*opacity) / 255.0;
                    let name = format!("A{opacity}");
                    let mut state = named.insert(Name(name.as_bytes())).dict();
                    state.pair(Name(b"CA"), share).pair(Name(b"ca"), share);
                }
            }
        })?;
        self.pages.push(id);
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        let Some((catalog, tree)) = self.catalog.take() else { return Ok(()) };
        let pages = std::mem::take(&mut self.pages);
        let document = &mut self.document;
        self.fonts.write(document)?;
        let count = i32::try_from(pages.len()).unwrap_or(i32::MAX);
        document.object(tree, |chunk| {
            chunk.pages(tree).kids(pages).count(count);
        })?;
        document.object(catalog, |chunk| {
            let mut root = chunk.indirect(catalog).start::<pdf_writer::writers::Catalog<'_>>();
            root.pages(tree);
        })?;
        let info = document.reserve()?;
        document.object(info, |chunk| {
            let mut entries = chunk.indirect(info).start::<pdf_writer::writers::DocumentInfo<'_>>();
            entries.producer(TextStr("GKS"));
        })?;
        document.finish(catalog, info)
    }
}
