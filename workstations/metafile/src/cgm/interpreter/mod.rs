//! From elements to records: what a metafile draws, in the terms of GKS.
//!
//! The extent of a picture is fitted into the unit square of NDC and becomes the workstation window. Attributes are
//! resolved here (bundles, specification modes, direct colours), so that records carry individual attributes and
//! colour indices only. What GKS does not have is drawn with what it has: edges as lines, closed figures as areas,
//! restricted text as smaller text, splines as polylines. Segments are drawn where they are defined and copied.

mod arc;
mod area;
mod context;
mod figure;
mod hatch;
mod line;
mod mapping;
mod palette;
mod queue;
mod segment;
mod spline;
mod text;
mod tile;

use super::decoder::{Decoder, senseless};
use super::element::{Element, Ink};
use super::fonts;
use crate::generated::elements::Kind;
use context::Context;
use figure::Figure;
use gks_geometry::{Ndc, PathBuf, Rect, Wc};
use gks_pipeline::colour::Colour;
use gks_pipeline::generated::numbers::escape;
use gks_pipeline::look::Look;
use gks_pipeline::record::{Contents, Record, Skipped, Source, SourceError};
use mapping::Mapping;
use palette::Palette;
use queue::{Drawing, Entry, Queue};
use segment::Segments;
use std::collections::BTreeMap;
use text::PendingText;
use tile::TileArray;

/// Gives the records of a metafile whose elements a decoder gives.
pub struct Interpreter<D> {
    decoder: D,
    queue: Queue,
    /// The record given out last.
    given: Option<Entry>,
    context: Context,
    /// The context with which pictures begin: what the metafile descriptor has said.
    defaults: Option<Context>,
    /// Contexts saved by name.
    saved: BTreeMap<i32, Context>,
    palette: Palette,
    /// The patterns told, as indices.
    patterns: BTreeMap<u32, Vec<i32>>,
    /// The mapping of the picture; none outside of a picture body.
    mapping: Option<Mapping>,
    window: Option<Rect<Ndc>>,
    /// Whether entry 0 of a colour table is the background if nothing has been drawn yet, as with NCAR.
    zero_is_background: bool,
    drawn: bool,
    /// Our numbers of the fonts of the font list.
    fonts: Vec<i32>,
    /// How many elements of each kind there were, and the font list.
    contents: Contents,
    /// Whether the metafile is one of ours.
    own: bool,
    text: Option<PendingText>,
    /// How many polylines are still to come of one primitive, and those that have come.
    compound: (usize, PathBuf<Wc>),
    figure: Option<Figure>,
    tiles: Option<TileArray>,
    segments: Segments,
    skipped: Skipped,
}

impl<D: Decoder> Interpreter<D> {
    /// An interpreter of the elements of a decoder.
    pub fn new(decoder: D) -> Self {
        Interpreter {
            decoder,
            queue: Queue::default(),
            given: None,
            context: Context::default(),
            defaults: None,
            saved: BTreeMap::new(),
            palette: Palette::default(),
            patterns: BTreeMap::new(),
            mapping: None,
            window: None,
            zero_is_background: false,
            drawn: false,
            fonts: Vec::new(),
            contents: Contents::default(),
            own: false,
            text: None,
            compound: Default::default(),
            figure: None,
            tiles: None,
            segments: Segments::default(),
            skipped: Skipped::default(),
        }
    }

    /// Skips an element whose parameters make no sense.
    fn senseless(&mut self, element: &Element) {
        self.skipped.add(&senseless(element.kind.row()));
    }

    /// Acts on an element.
    fn interpret(&mut self, element: &Element) {
        if element.kind == Kind::SegmentTransformation {
            self.transform_segment(element);
            return;
        }
        if self.segments.collects(element) {
            // A segment outside of pictures is drawn only when it is copied.
            if self.mapping.is_none() {
                return;
            }
        }
        if self.compound.0 > 0 && element.kind != Kind::Polyline {
            self.end_compound();
        }
        if self.context.apply(element) {
            if element.kind == Kind::ColourTable
                && self.zero_is_background
                && self.mapping.is_some()
                && !self.drawn
                && let Some(&background) = self.context.colours.get(&0)
            {
                self.palette.set_background(background, &mut self.queue);
            }
            return;
        }
        let known = self.delimiter(element) || self.descriptor(element) || self.primitive(element);
        if !known {
            self.skipped.add(element.kind.row().name);
        }
    }

    fn delimiter(&mut self, element: &Element) -> bool {
        match element.kind {
            Kind::BeginMetafile => {
                (self.context, self.defaults) = (Context::default(), None);
                (self.mapping, self.fonts, self.own) = (None, Vec::new(), false);
                self.segments = Segments::default();
            }
            Kind::BeginPicture => {
                self.context = self.defaults.get_or_insert_with(|| self.context.clone()).clone();
                self.saved.clear();
                (self.mapping, self.drawn) = (None, false);
                self.queue.push(Entry::Clear);
            }
            Kind::BeginPictureBody => {
                self.mapping();
            }
            Kind::EndPicture | Kind::EndMetafile => {
                self.end_text();
                self.end_figure();
                (self.mapping, self.tiles) = (None, None);
            }
            Kind::BeginFigure => self.figure = Some(Figure::default()),
            Kind::EndFigure => self.end_figure(),
            Kind::NewRegion => {
                if let Some(figure) = &mut self.figure {
                    figure.end_region();
                }
            }
            Kind::ConnectingEdge => {
                if let Some(figure) = &mut self.figure {
                    figure.connecting_edge();
                }
            }
            Kind::BeginTileArray => self.tiles = TileArray::new(element),
            Kind::EndTileArray => self.tiles = None,
            Kind::SavePrimitiveContext => {
                // As many as a metafile may reasonably have; a context is not small.
                if let Some(name) = element.integer(0)
                    && self.saved.len() < 256
                {
                    self.saved.insert(name, self.context.clone());
                }
            }
            Kind::RestorePrimitiveContext => {
                if let Some(context) = element.integer(0).and_then(|name| self.saved.get(&name)) {
                    self.context = context.clone();
                }
            }
            Kind::BeginSegment => {
                self.end_segment();
                self.begin_segment();
            }
            Kind::EndSegment => self.end_segment(),
            Kind::CopySegment => self.copy_segment(element),
            _ => return false,
        }
        true
    }

    fn descriptor(&mut self, element: &Element) -> bool {
        match element.kind {
            Kind::FontList => {
                let names = (0..element.values.len()).filter_map(|place| element.bytes(place));
                self.fonts = names.clone().map(fonts::number).collect();
                self.contents.fonts = names.map(text::decoded).collect();
            }
            Kind::MetafileDescription => {
                let text = element.bytes(0).unwrap_or_default();
                self.zero_is_background = text.starts_with(b"NCAR");
                self.own = text == fonts::AUTHOR.as_bytes();
            }
            Kind::Message => {
                if let Some(bytes) = element.bytes(1) {
                    self.queue.push(Entry::Message(text::decoded(bytes)));
                }
            }
            Kind::ApplicationData => {
                if let (Some(kind @ 101..), Some(data)) = (element.integer(0), element.bytes(1)) {
                    self.queue.push(Entry::User(kind, data.to_vec()));
                }
            }
            Kind::Escape if element.integer(0) == Some(escape::COMPOUND_PRIMITIVE) => {
                self.begin_compound(element);
            }
            // What only says how elements are coded, or nothing about the picture.
            Kind::NoOp
            | Kind::MetafileVersion
            | Kind::MetafileElementList
            | Kind::BeginMetafileDefaultsReplacement
            | Kind::EndMetafileDefaultsReplacement
            | Kind::VdcType
            | Kind::IntegerPrecision
            | Kind::RealPrecision
            | Kind::IndexPrecision
            | Kind::ColourPrecision
            | Kind::ColourIndexPrecision
            | Kind::NamePrecision
            | Kind::VdcIntegerPrecision
            | Kind::VdcRealPrecision
            | Kind::MaximumColourIndex
            | Kind::ColourValueExtent
            | Kind::ColourModel
            | Kind::ColourSelectionMode
            | Kind::LineWidthSpecificationMode
            | Kind::MarkerSizeSpecificationMode
            | Kind::EdgeWidthSpecificationMode
            | Kind::InteriorStyleSpecificationMode
            | Kind::CharacterSetList
            | Kind::CharacterCodingAnnouncer
            | Kind::MaximumVdcExtent
            | Kind::SegmentPriorityExtent
            | Kind::PictureDirectory
            | Kind::ApplicationStructureDirectory
            | Kind::BeginApplicationStructure
            | Kind::BeginApplicationStructureBody
            | Kind::EndApplicationStructure
            | Kind::ApplicationStructureAttribute
            | Kind::BeginCompoundLine
            | Kind::EndCompoundLine
            | Kind::PickIdentifier => {}
            _ => return false,
        }
        true
    }

    fn primitive(&mut self, element: &Element) -> bool {
        self.line(element)
            || self.arc(element)
            || self.spline(element)
            || self.area(element)
            || self.string(element)
            || self.tile(element)
    }

    /// The mapping of the picture, whose body begins if it has not begun.
    fn mapping(&mut self) -> Mapping {
        if let Some(mapping) = self.mapping {
            return mapping;
        }
        let mapping = Mapping::new(&self.context);
        self.mapping = Some(mapping);
        if self.window != Some(mapping.window) {
            self.window = Some(mapping.window);
            self.queue.push(Entry::Window(mapping.window));
        }
        if let Some(background) = self.context.background {
            self.context.colours.entry(0).or_insert(background);
        }
        let background = self.context.colours.get(&0).copied().unwrap_or(Colour::WHITE);
        self.palette.begin_picture(background, &mut self.queue);
        mapping
    }

    /// The colour index of a colour.
    fn index(&mut self, ink: Ink) -> u32 {
        self.palette.index(ink, &self.context.colours, &mut self.queue)
    }

    /// Draws a primitive with a look.
    fn draw(&mut self, drawing: Drawing, look: Look) {
        // Nothing is to be seen where nothing is left.
        let Some(clip) = self.clip().filter(Rect::is_proper) else { return };
        self.drawn = true;
        self.queue.draw(drawing, look, clip);
    }

    /// What is drawn is clipped to, if anything is left of it.
    fn clip(&mut self) -> Option<Rect<Ndc>> {
        // A segment that is being defined is transformed, but not what it is clipped to.
        let mapping = self.mapping();
        let own = match self.context.clip {
            Some((first, second)) if self.context.clipping => {
                let place = self.segments.place().unwrap_or(mapping);
                place.rect(first, second).intersection(&mapping.window)?
            }
            _ => mapping.window,
        };
        match self.segments.clip() {
            Some(outer) if self.context.clipped_as_copied => Some(outer),
            Some(outer) => own.intersection(&outer),
            None => Some(own),
        }
    }

    /// The next element: of a segment that is being copied, else of the metafile.
    fn element(&mut self) -> Result<Option<Element>, SourceError> {
        if let Some(element) = self.copied_element() {
            return Ok(Some(element));
        }
        let element = self.decoder.next()?;
        if let Some(element) = &element {
            *self.contents.elements.entry(element.kind.row().name).or_default() += 1;
        }
        Ok(element)
    }
}

impl<D: Decoder> Source for Interpreter<D> {
    fn next(&mut self) -> Result<Option<Record<'_>>, SourceError> {
        loop {
            while self.queue.is_empty() {
                match self.element()? {
                    Some(element) => self.interpret(&element),
                    None => {
                        self.end_text();
                        self.end_compound();
                        self.end_figure();
                        if self.queue.is_empty() {
                            return Ok(None);
                        }
                    }
                }
            }
            self.given = self.queue.pop();
            if self.given.as_ref().and_then(Entry::record).is_some() {
                break;
            }
        }
        Ok(self.given.as_ref().and_then(Entry::record))
    }

    fn skipped(&self) -> Skipped {
        let mut skipped = self.decoder.skipped().clone();
        skipped.extend(&self.skipped);
        skipped
    }

    fn contents(&self) -> Contents {
        self.contents.clone()
    }
}

#[cfg(test)]
mod tests;
