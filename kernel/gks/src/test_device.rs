//! Devices for tests: they draw nothing and record what they are asked to draw.

use crate::{Gks, Result};
use gks_geometry::{Du, PathBuf, Paths, Rect};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::description::{
    Catalogue, Category, Classification, DeferralMode, Description, DynamicModification,
    DynamicModifications, OpenError, RegenerationMode, SegmentModifications,
};
use gks_pipeline::device::{
    Device, DeviceError, Drawn, Fill, Form, FrameBuffer, Grid, Mark, MarkerStyle, Page, Pen, Rule, Surface,
};
use gks_pipeline::item::{Curve, Ellipse, Parallelogram};
use gks_pipeline::look::{Cap, Join};
use gks_pipeline::workstation::Backend;
use glam::DVec2;
use std::io;
use std::sync::{Arc, Mutex};

/// The type that accepts every mark: 1000 x 1000 units of 0.2 mm, ordinates upwards, any number of colours.
pub(crate) const PLAIN: i32 = 900;
/// An indexed frame buffer of 1000 x 500 pixels of 0.2 mm, ordinates downwards, 256 colours.
pub(crate) const INDEXED: i32 = 901;
/// As [`INDEXED`], but with colours in the pixels, and antialiasing.
pub(crate) const TRUE_COLOUR: i32 = 902;
/// As [`PLAIN`], but every mark fails to be written.
pub(crate) const BROKEN: i32 = 903;
/// The type of a category is this number plus the category; otherwise as [`PLAIN`].
pub(crate) const CATEGORIES: i32 = 1000;

/// What a device was asked to do.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Event {
    Begin(Page),
    Erase(Page),
    Draw(Drawing, Option<Rect<Du>>),
    End,
    Close,
}

/// The form of a mark, kept.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Drawing {
    Lines(Vec<Vec<DVec2>>, Stroke),
    LongLine(Vec<Vec<DVec2>>, Stroke),
    Area(Vec<Vec<DVec2>>, Rule, Paint),
    Patterned(Vec<Vec<DVec2>>, Parallelogram<Du>, Table),
    Markers(Vec<DVec2>, MarkerStyle),
    Text(String, Paint),
    Cells(Parallelogram<Du>, Table),
    EllipticArc(Ellipse<Du>, Stroke),
    FilledEllipse(Ellipse<Du>, Paint),
    Bezier(Vec<DVec2>, Stroke),
    FilledBezier(Vec<DVec2>, Paint),
}

/// A pen, kept.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) paint: Paint,
    pub(crate) width: f64,
    pub(crate) dash: Vec<f64>,
    pub(crate) cap: Cap,
    pub(crate) join: Join,
}

/// A grid of paints, kept.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Table {
    pub(crate) columns: usize,
    pub(crate) indices: Vec<u32>,
}

/// What all devices of one catalogue were asked to do, in order.
#[derive(Clone, Default)]
pub(crate) struct Log(Arc<Mutex<Vec<Event>>>);

impl Log {
    fn push(&self, event: Event) {
        self.0.lock().expect("no test thread panics while it holds the log").push(event);
    }

    /// All events so far; the log is empty afterwards.
    pub(crate) fn take(&self) -> Vec<Event> {
        std::mem::take(&mut self.0.lock().expect("no test thread panics while it holds the log"))
    }

    /// The marks among all events so far, with their clipping rectangles; the log is empty afterwards.
    pub(crate) fn marks(&self) -> Vec<(Drawing, Option<Rect<Du>>)> {
        let drawn = |event| if let Event::Draw(drawing, clip) = event { Some((drawing, clip)) } else { None };
        self.take().into_iter().filter_map(drawn).collect()
    }

    /// The only mark among all events so far; the log is empty afterwards.
    pub(crate) fn mark(&self) -> (Drawing, Option<Rect<Du>>) {
        let marks = self.marks();
        assert_eq!(marks.len(), 1, "{marks:?}");
        marks.into_iter().next().expect("one mark")
    }
}

/// An open kernel with the workstations 1, 2, ... of the given types, all active, and the log of its devices.
pub(crate) fn active(types: &[i32]) -> (Gks, Log) {
    let (mut gks, log) = open(types);
    for id in (1..).take(types.len()) {
        gks.activate_workstation(id).expect("the workstation has just been opened");
    }
    (gks, log)
}

/// As [`active`], with no workstation active.
pub(crate) fn open(types: &[i32]) -> (Gks, Log) {
    let log = Log::default();
    let mut gks = Gks::open(Box::new(TestCatalogue { log: log.clone() }));
    for (id, &kind) in (1..).zip(types) {
        gks.open_workstation(id, "", kind).expect("a type of the test catalogue");
    }
    (gks, log)
}

/// A kernel that is not open.
pub(crate) fn closed() -> Gks {
    Gks::new(Box::new(TestCatalogue { log: Log::default() }))
}

/// The number of the error that a function met.
pub(crate) fn number<T: std::fmt::Debug>(result: Result<T>) -> i32 {
    result.expect_err("the function should have met an error").number
}

struct TestCatalogue {
    log: Log,
}

impl Catalogue for TestCatalogue {
    fn types(&self) -> Vec<i32> {
        vec![PLAIN, INDEXED, TRUE_COLOUR, BROKEN]
    }

    fn describe(&self, number: i32) -> Option<Description> {
        let category = Category::from_number(number - CATEGORIES);
        let raster = matches!(number, INDEXED | TRUE_COLOUR);
        if !(raster || matches!(number, PLAIN | BROKEN) || category.is_some()) {
            return None;
        }
        let height = if raster { 500 } else { 1000 };
        let imm = DynamicModification::Imm;
        Some(Description {
            number,
            name: "test",
            category: category.unwrap_or(Category::Output),
            classification: if raster { Classification::Raster } else { Classification::Vector },
            surface: Surface {
                width: 1000.0,
                height: f64::from(height),
                unit: 0.0002,
                y_down: raster,
                resolution: 1.0,
                pen: None,
            },
            raster: (1000, height),
            colours: if number == INDEXED { 256 } else { 0 },
            dynamic: DynamicModifications {
                line_bundles: imm,
                marker_bundles: imm,
                text_bundles: imm,
                fill_bundles: imm,
                patterns: imm,
                colours: imm,
                transformation: DynamicModification::Irg,
            },
            deferral: DeferralMode::Asti,
            regeneration: RegenerationMode::Suppressed,
            segments: SegmentModifications::REDRAWN,
            input: [0; 6],
        })
    }

    /// The connections "nonsense" and "unwritable" fail.
    fn open(&mut self, number: i32, connection: &str) -> Result<(Backend, Description), OpenError> {
        match connection {
            "nonsense" => return Err(OpenError::Connection(connection.into(), "has no meaning".into())),
            "unwritable" => return Err(OpenError::CannotOpen("no such directory".into())),
            _ => {}
        }
        let description = self.describe(number).ok_or(OpenError::NoSuchType(number))?;
        if description.category == Category::Wiss {
            return Ok((Backend::Storage, description));
        }
        let device = TestDevice {
            surface: description.surface.clone(),
            pixels: description.surface.y_down.then_some(Pixels { indexed: number == INDEXED, smooth: true }),
            broken: number == BROKEN,
            log: self.log.clone(),
        };
        Ok((Backend::Device(Box::new(device)), description))
    }
}

struct TestDevice {
    surface: Surface,
    pixels: Option<Pixels>,
    broken: bool,
    log: Log,
}

impl Device for TestDevice {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.log.push(Event::Begin(page.clone()));
        Ok(())
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        if self.pixels.is_none() {
            return Ok(Drawn::No);
        }
        self.log.push(Event::Erase(page.clone()));
        Ok(Drawn::Yes)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        if self.broken {
            return Err(io::Error::other("the device is broken").into());
        }
        if matches!(mark.form, Form::LongLine(..)) && self.pixels.is_some() {
            return Ok(Drawn::No);
        }
        let Some(drawing) = keep(&mark.form) else { return Ok(Drawn::No) };
        self.log.push(Event::Draw(drawing, mark.clip));
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.log.push(Event::End);
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        self.log.push(Event::Close);
        Ok(())
    }

    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        self.pixels.as_mut().map(|pixels| pixels as &mut dyn FrameBuffer)
    }
}

/// What is kept of a form; none of one that comes again as another one.
fn keep(form: &Form<'_>) -> Option<Drawing> {
    let paths = |p: &Paths<'_, Du>| p.iter().map(<[DVec2]>::to_vec).collect::<Vec<_>>();
    let stroke = |p: &Pen<'_>| Stroke {
        paint: p.paint,
        width: p.width,
        dash: p.dash.to_vec(),
        cap: p.cap,
        join: p.join,
    };
    let table = |g: &Grid<'_>| Table {
        columns: g.columns,
        indices: g.paints.iter().map(|paint| paint.index).collect(),
    };
    Some(match form {
        Form::LongLine(line, pen) => {
            let mut whole = PathBuf::new();
            whole.add_pieces(line);
            Drawing::LongLine(paths(&whole.as_paths()), stroke(pen))
        }
        Form::Lines(p, pen) => Drawing::Lines(paths(p), stroke(pen)),
        Form::Area(p, rule, Fill::Solid(paint)) => Drawing::Area(paths(p), *rule, *paint),
        Form::Area(p, _, Fill::Pattern(place, grid)) => Drawing::Patterned(paths(p), *place, table(grid)),
        Form::Markers(positions, style) => Drawing::Markers(positions.to_vec(), *style),
        Form::Text(run) => Drawing::Text(run.text.to_owned(), run.paint),
        Form::Cells(place, grid) => Drawing::Cells(*place, table(grid)),
        Form::Stroke(Curve::Ellipse(e), pen) => Drawing::EllipticArc(*e, stroke(pen)),
        Form::Stroke(Curve::Bezier(p), pen) => Drawing::Bezier(p.to_vec(), stroke(pen)),
        Form::Filled(Curve::Ellipse(e), paint) => Drawing::FilledEllipse(*e, *paint),
        Form::Filled(Curve::Bezier(p), paint) => Drawing::FilledBezier(p.to_vec(), *paint),
        Form::StrokeText(_) | Form::IndexedCells(..) => return None,
    })
}

/// A frame buffer of 1000 x 500 pixels that numbers them row by row, modulo 256.
struct Pixels {
    indexed: bool,
    smooth: bool,
}

impl FrameBuffer for Pixels {
    fn size(&self) -> (u32, u32) {
        (1000, 500)
    }

    fn colour(&self, column: u32, row: u32) -> Option<Colour> {
        let inside = column < 1000 && row < 500;
        let grey = ((row * 1000 + column) % 256) as f32 / 255.0;
        inside.then_some(Colour::rgb(grey, grey, grey))
    }

    fn index(&self, column: u32, row: u32) -> Option<u32> {
        let inside = self.indexed && column < 1000 && row < 500;
        inside.then_some((row * 1000 + column) % 256)
    }

    fn set_colour(&mut self, _index: u32, _colour: Colour) -> bool {
        self.indexed
    }

    fn set_antialiasing(&mut self, on: bool) -> bool {
        if !self.indexed {
            self.smooth = on;
        }
        !self.indexed
    }

    fn antialiasing(&self) -> bool {
        !self.indexed && self.smooth
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn a_line_arrives_as_it_was_mapped() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.polyline(&[(0.0, 0.5), (1.0, 0.5)]).unwrap();
        let (Drawing::Lines(paths, pen), None) = log.mark() else { panic!("not a line") };
        assert_eq!(paths, [[dvec2(0.0, 500.0), dvec2(1000.0, 500.0)]]);
        assert_eq!((pen.paint.index, pen.width, pen.cap, pen.join), (1, 1.0, Cap::Butt, Join::Miter));
        assert!(pen.dash.is_empty());
    }

    #[test]
    fn a_broken_device_is_reported_and_the_others_draw() {
        let (mut gks, log) = active(&[BROKEN, PLAIN]);
        assert_eq!(number(gks.polyline(&[(0.0, 0.5), (1.0, 0.5)])), 303);
        assert_eq!(log.marks().len(), 1);
    }
}
