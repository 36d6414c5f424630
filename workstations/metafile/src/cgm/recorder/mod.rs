//! Metafile output: the records of GKS as elements.
//!
//! Attributes are resolved when something is drawn (bundles and aspect source flags, with the tables of the
//! workstation), and written where they differ from what was written before in the picture. The extent of a picture is
//! the whole display surface in NDC under the workstation transformation, so that a viewport keeps its place; what is
//! drawn is clipped to the workstation window. A new window or viewport takes effect with the next picture.
//!
//! Versions of CGM before the second have no segments, and later ones no metafile that lives on after its picture: what
//! is to be seen of segments is drawn. A picture that is drawn again takes the place of the old one, unless that has
//! become so long that a part of it is written already. A picture in which nothing is drawn is not written, unless it
//! would be the only one.

mod attributes;
mod curve;
mod descriptor;
mod primitive;

use super::element::{Element, Ink, Value};
use super::encoder::{Encoder, Grid};
use super::fonts::FontList;
use crate::generated::elements::{ELEMENTS, Kind};
use gks_geometry::{Ndc, Point, Rect};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::{DeviceError, Drawn, Sink};
use gks_pipeline::generated::numbers::escape;
use gks_pipeline::item::{Item, Shape};
use gks_pipeline::look::Look;
use gks_pipeline::record::{PictureRecorder, Record, Recorder};
use gks_pipeline::tables::{Pattern, Tables};
use gks_pipeline::workstation::WorkstationTransformation;
use glam::DVec2;
use std::collections::BTreeMap;

/// What a metafile is to hold.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The version: 1, or 3 for line ends and corners, the dashes of our own linetypes, and Bezier curves.
    pub version: u8,
    /// Width and height of the display surface, in metres.
    pub size: (f64, f64),
    /// Whether to write lines, markers, text, polygons and cells only, as NCAR's readers know them.
    pub plain: bool,
    /// The most entries of the colour table that are written; what is drawn in others gets the nearest colour.
    pub colours: Option<u32>,
}

/// The octets of a picture that are kept, so that it may be drawn again in its place.
const HELD: usize = 1 << 20;

impl Default for Settings {
    fn default() -> Self {
        Settings { version: 1, size: (1.0, 1.0), plain: false, colours: None }
    }
}

/// What a primitive was drawn as: which attributes were written for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    Line,
    Marker,
    Text,
    Area,
}

/// Writes a metafile.
pub struct CgmRecorder {
    sink: Box<dyn Sink>,
    encoder: Box<dyn Encoder>,
    settings: Settings,
    tables: Tables,
    requested: WorkstationTransformation,
    current: WorkstationTransformation,
    /// From NDC to virtual device coordinates.
    grid: Grid,
    origin: DVec2,
    scale: f64,
    fonts: FontList,
    /// The largest colour index that is written.
    most_colour: u32,
    /// Whether a sink is open.
    begun: bool,
    /// Whether the descriptor is written.
    described: bool,
    pictures: u32,
    /// Whether a picture is open.
    open: bool,
    /// Where the open picture begins in `out`, if all of it is there.
    start: Option<usize>,
    /// The parameters last written, by element.
    written: Vec<Option<Vec<Value>>>,
    /// The look for which attributes were last written, for each class.
    looks: [Option<Look>; 4],
    clip: Option<Rect<Ndc>>,
    patterns: BTreeMap<i32, Pattern>,
    /// Indices that stand for those the metafile has no room for.
    stand_ins: BTreeMap<u32, u32>,
    out: Vec<u8>,
}

impl CgmRecorder {
    /// A metafile with an encoding, which appears in a sink.
    pub fn new(sink: Box<dyn Sink>, encoder: Box<dyn Encoder>, settings: Settings) -> CgmRecorder {
        let (width, height) = settings.size;
        let whole =
            WorkstationTransformation { window: Rect::UNIT, viewport: Rect::new(0.0, width, 0.0, height) };
        let grid = encoder.grid();
        let wanted = settings.colours.map_or(u32::MAX, |colours| colours.max(2) - 1);
        let most_colour = encoder.most_colour().min(wanted);
        let fonts = if settings.plain { FontList::of_ncar() } else { FontList::new() };
        CgmRecorder {
            sink,
            encoder,
            settings,
            tables: Tables::predefined(),
            requested: whole,
            current: whole,
            grid,
            origin: DVec2::ZERO,
            scale: grid.units,
            fonts,
            most_colour,
            begun: false,
            described: false,
            pictures: 0,
            open: false,
            start: None,
            written: vec![None; ELEMENTS.len()],
            looks: Default::default(),
            clip: None,
            patterns: BTreeMap::new(),
            stand_ins: BTreeMap::new(),
            out: Vec::new(),
        }
    }

    /// Writes an element.
    fn put(&mut self, kind: Kind, values: impl Into<Vec<Value>>) {
        self.encoder.encode(&Element::new(kind, values), &mut self.out);
    }

    /// Writes an element unless it was the last of its kind.
    fn set(&mut self, kind: Kind, values: impl Into<Vec<Value>>) {
        let values = values.into();
        if self.written[kind as usize].as_ref() != Some(&values) {
            let element = Element::new(kind, values);
            self.encoder.encode(&element, &mut self.out);
            self.written[kind as usize] = Some(element.values);
        }
    }

    /// Hands what was written on to the sink when there is more of it than is kept.
    fn flush(&mut self, kept: usize) -> Result<(), DeviceError> {
        if self.out.len() <= kept {
            return Ok(());
        }
        if !std::mem::replace(&mut self.described, true) {
            self.settle();
            let descriptor = self.descriptor();
            self.sink.write(&descriptor)?;
        }
        let written = self.sink.write(&self.out);
        self.out.clear();
        self.start = None;
        Ok(written?)
    }

    fn begin_metafile(&mut self) -> Result<(), DeviceError> {
        if !std::mem::replace(&mut self.begun, true) {
            self.sink.open()?;
            // The encoder learns its precisions.
            self.descriptor();
        }
        Ok(())
    }

    fn begin_picture(&mut self) -> Result<(), DeviceError> {
        if self.open {
            return Ok(());
        }
        self.begin_metafile()?;
        (self.open, self.pictures) = (true, self.pictures + 1);
        self.start = Some(self.out.len());
        self.current = self.requested;
        self.written.fill(None);
        self.looks = Default::default();
        self.clip = None;
        self.patterns.clear();
        let surface = self.surface();
        let size = DVec2::new(surface.width(), surface.height());
        if !self.grid.real {
            self.scale = self.grid.units / size.max_element();
            self.origin = surface.min.0;
        }
        let name = format!("picture {}", self.pictures);
        self.put(Kind::BeginPicture, [Value::Text(name.into_bytes())]);
        self.put(Kind::ScalingMode, [Value::Integer(0), Value::Real(1.0)]);
        self.put(Kind::ColourSelectionMode, [Value::Integer(0)]);
        self.put(Kind::LineWidthSpecificationMode, [Value::Integer(1)]);
        self.put(Kind::MarkerSizeSpecificationMode, [Value::Integer(1)]);
        let (least, most) = (self.coordinates(surface.min.0), self.coordinates(surface.max.0));
        self.put(Kind::VdcExtent, [Value::Point(least), Value::Point(most)]);
        let background = Value::Ink(Ink::Direct(self.tables.background()));
        self.put(Kind::BackgroundColour, [background]);
        self.put(Kind::BeginPictureBody, []);
        self.put_colours();
        Ok(())
    }

    /// The colour table: runs of entries that follow one another.
    fn put_colours(&mut self) {
        let most = self.most_colour;
        let all: Vec<(u32, Colour)> =
            self.tables.colours.iter().filter(|(index, _)| *index <= most).collect();
        for run in all.chunk_by(|a, b| a.0 + 1 == b.0) {
            let start = Value::Ink(Ink::Index(run[0].0));
            let colours = run.iter().map(|(_, colour)| Value::Ink(Ink::Direct(*colour)));
            self.put(Kind::ColourTable, std::iter::once(start).chain(colours).collect::<Vec<_>>());
        }
        for (index, colour) in all {
            self.put_opacity(index, colour);
        }
    }

    /// An entry of the colour table.
    fn put_colour(&mut self, index: u32, colour: Colour) {
        self.put(Kind::ColourTable, [Value::Ink(Ink::Index(index)), Value::Ink(Ink::Direct(colour))]);
        self.put_opacity(index, colour);
    }

    /// The opacity of a colour, which the standard does not have: an escape with the index and the opacity as text.
    fn put_opacity(&mut self, index: u32, colour: Colour) {
        if colour.alpha != 1.0 {
            let data = format!("{index} {}", colour.alpha).into_bytes();
            self.put(Kind::Escape, [Value::Integer(escape::SET_COLOUR_ALPHA), Value::Data(data)]);
        }
    }

    fn end_picture(&mut self) -> Result<(), DeviceError> {
        if std::mem::take(&mut self.open) {
            self.put(Kind::EndPicture, []);
            // A complete picture outlives the program.
            self.flush(0)?;
            self.sink.flush()?;
        }
        Ok(())
    }

    /// Writes a primitive unless it is clipped away.
    fn write(&mut self, item: &Item<'_>) -> Result<(), DeviceError> {
        self.begin_picture()?;
        let Some(clip) = item.clip.intersection(&self.current.window).filter(Rect::is_proper) else {
            return Ok(());
        };
        self.set_clip(clip);
        match item.shape {
            Shape::Polyline(paths) => self.lines(paths, item.look),
            Shape::Polymarker(points) => self.markers(points, item.look),
            Shape::Text(at, text) => self.text(at, text, item.look),
            Shape::FillArea(rings) => self.area(rings, item.look),
            Shape::CellArray(place, cells) => self.cells(&place, &cells),
            Shape::Generalized(curve, role) => self.curve(&curve, role, item.look),
        }
        self.flush(HELD)
    }

    /// The display surface in NDC, under the transformation of the picture.
    fn surface(&self) -> Rect<Ndc> {
        let WorkstationTransformation { window, viewport } = self.current;
        let (wide, high) = (window.width() / viewport.width(), window.height() / viewport.height());
        // As a fraction, which is nothing but the window where the viewport is the whole surface.
        let (part, whole) = if wide > high {
            (window.width(), viewport.width())
        } else {
            (window.height(), viewport.height())
        };
        let ndc = |metres: f64| metres / whole * part;
        let (left, bottom) = (window.min.x() - ndc(viewport.min.x()), window.min.y() - ndc(viewport.min.y()));
        let (width, height) = self.settings.size;
        Rect::new(left, left + ndc(width), bottom, bottom + ndc(height))
    }

    /// The virtual device coordinates of a point of NDC.
    fn coordinates(&self, p: DVec2) -> DVec2 {
        self.rounded((p - self.origin) * self.scale)
    }

    /// Onto the grid of coordinates.
    fn rounded(&self, v: DVec2) -> DVec2 {
        let v = v.clamp(DVec2::splat(-self.grid.most), DVec2::splat(self.grid.most));
        if self.grid.real { v } else { v.round() }
    }

    /// The index under which a colour index is written.
    fn colour(&mut self, index: u32) -> u32 {
        let paint = self.tables.paint(index);
        let most = self.most_colour;
        if paint.index <= most {
            return paint.index;
        }
        if let Some(&stand_in) = self.stand_ins.get(&paint.index) {
            return stand_in;
        }
        let same = self.tables.colours.iter().find(|(at, colour)| *at <= most && *colour == paint.colour);
        let free = || (1..=most).rev().find(|at| self.tables.colours.get(*at).is_none());
        let index = match (same, free()) {
            (Some((at, _)), _) => at,
            (None, Some(at)) => {
                self.put_colour(at, paint.colour);
                // It is taken from now on.
                self.tables.colours.set(at, paint.colour);
                at
            }
            (None, None) => nearest(&self.tables, most, paint.colour),
        };
        self.stand_ins.insert(paint.index, index);
        index
    }

    fn set_colour(&mut self, index: u32, colour: Colour) {
        self.tables.colours.set(index, colour);
        self.stand_ins.remove(&index);
        self.looks = Default::default();
        if self.open && index <= self.most_colour {
            self.put_colour(index, colour);
        }
    }

    fn set_clip(&mut self, clip: Rect<Ndc>) {
        if self.clip == Some(clip) {
            return;
        }
        self.clip = Some(clip);
        let corners = [clip.min, clip.max].map(|corner: Point<Ndc>| self.coordinates(corner.0));
        self.set(Kind::ClipRectangle, corners.map(Value::Point));
        self.set(Kind::ClipIndicator, [Value::Integer(1)]);
    }
}

/// The index of the colour that is nearest to another one.
fn nearest(tables: &Tables, most: u32, colour: Colour) -> u32 {
    let distance = |other: Colour| {
        let parts = [other.red - colour.red, other.green - colour.green, other.blue - colour.blue];
        parts.iter().map(|part| part * part).sum::<f32>()
    };
    let entries = tables.colours.iter().filter(|(at, _)| *at <= most);
    let found = entries.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
    found.map_or(1, |(at, _)| at)
}

impl Recorder for CgmRecorder {
    fn draw(&mut self, item: &Item<'_>) -> Result<(), DeviceError> {
        self.write(item)
    }

    fn control(&mut self, record: &Record<'_>) -> Result<(), DeviceError> {
        match record {
            Record::Clear { .. } => {
                self.end_picture()?;
                self.current = self.requested;
            }
            Record::ColourRepresentation(index, colour) => self.set_colour(*index, *colour),
            Record::LineRepresentation(index, bundle) => {
                self.tables.lines.insert(*index, *bundle);
            }
            Record::MarkerRepresentation(index, bundle) => {
                self.tables.markers.insert(*index, *bundle);
            }
            Record::TextRepresentation(index, bundle) => {
                self.tables.texts.insert(*index, *bundle);
            }
            Record::FillRepresentation(index, bundle) => {
                self.tables.fills.insert(*index, *bundle);
            }
            Record::PatternRepresentation(index, pattern) => {
                self.tables.patterns.insert(*index, (*pattern).clone());
            }
            Record::WorkstationWindow(window) => self.requested.window = *window,
            Record::WorkstationViewport(viewport) => self.requested.viewport = *viewport,
            Record::Message(text) => {
                self.begin_metafile()?;
                self.put(
                    Kind::Message,
                    [Value::Integer(0), Value::Text(attributes::encoded(text).into_owned())],
                );
            }
            Record::User(kind, data) => {
                self.begin_metafile()?;
                self.put(Kind::ApplicationData, [Value::Integer(*kind), Value::Data(data.to_vec())]);
            }
            // What segments do is drawn.
            _ => {}
        }
        // Whatever a table says may change what attributes are resolved to.
        self.looks = Default::default();
        self.flush(HELD)
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        if self.pictures == 0 {
            self.begin_picture()?;
        }
        self.end_picture()?;
        self.put(Kind::EndMetafile, []);
        self.flush(0)?;
        self.sink.finish()?;
        Ok(())
    }
}

impl PictureRecorder for CgmRecorder {
    fn erase(&mut self) -> Result<Drawn, DeviceError> {
        match (self.open, self.start) {
            (false, _) => Ok(Drawn::Yes),
            (true, Some(start)) => {
                self.out.truncate(start);
                (self.open, self.start) = (false, None);
                self.pictures -= 1;
                Ok(Drawn::Yes)
            }
            (true, None) => Ok(Drawn::No),
        }
    }
}
