//! The true-colour workstation: a frame buffer of colours, antialiased, and image files of it.

use super::aliased::{Aliased, rule};
use super::bitmap::{Ahead, Bitmap};
use super::clip::Window;
use super::coloured_cells;
use super::composite::{Coat, colour, over_run, pixel};
use super::describe::{Layout, SizeError};
use super::encode::{self, Care, Format, Samples};
use super::letters::Letters;
use super::lines::Lines;
use super::markers::Markers;
use super::pattern;
use crate::options::Options;
use gks_algorithms::coverage::{AreaMask, Gain};
use gks_algorithms::path;
use gks_algorithms::rect::IRect;
use gks_geometry::{Du, LongLine, Paths, Rect};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::device::{
    Device, DeviceError, Drawn, Fill, Form, FrameBuffer, Grid, Mark, Page, Pen, Rule, Sink, Surface,
};
use gks_pipeline::item::Parallelogram;
use glam::IVec2;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Areas of more points than this are looked for on the whole surface.
const LONG_BOUNDARY: usize = 1 << 14;
/// What the arithmetic of maps may lose, in pixels.
const LAST_DIGITS: f64 = 1e-6;

/// A frame buffer of colours, which may be written as an image file for each page.
///
/// It draws solid and long lines, markers, characters of stroke fonts, areas, patterns and cells; what is left to the pipeline
/// are other characters and dashes, curves, and the exact clipping of everything but cells and patterns.
pub struct TrueColour {
    layout: Layout,
    surface: Surface,
    canvas: Arc<Mutex<Bitmap>>,
    background: Option<Colour>,
    transparent: bool,
    /// Whether every pixel is opaque.
    opaque: bool,
    antialias: bool,
    care: Care,
    output: Option<(Box<dyn Sink>, Format)>,
    lines: Lines,
    markers: Markers,
    letters: Letters,
    areas: AreaMask,
    aliased: Aliased,
}

/// A handle to the pixels of a [`TrueColour`], by which a program reads what has been drawn so far, also
/// after the workstation is closed.
#[derive(Clone)]
pub struct SharedPixels {
    canvas: Arc<Mutex<Bitmap>>,
}

impl SharedPixels {
    /// Number of columns and rows.
    pub fn size(&self) -> (u32, u32) {
        lock(&self.canvas).size()
    }

    /// Calls `read` with the pixels: red, green, blue and opacity, one byte each, premultiplied by the opacity,
    /// row by row from the top. Nothing is drawn until it returns.
    pub fn read<R>(&self, read: impl FnOnce(&[u8]) -> R) -> R {
        read(lock(&self.canvas).bytes())
    }
}

/// Lines whose points are held, or a line whose points are not.
#[derive(Copy, Clone)]
enum Either<'a> {
    Held(&'a Paths<'a, Du>),
    Long(&'a LongLine<'a, Du>),
}

fn lock(canvas: &Mutex<Bitmap>) -> MutexGuard<'_, Bitmap> {
    canvas.lock().unwrap_or_else(PoisonError::into_inner)
}

impl TrueColour {
    /// A frame buffer of the size that options ask for, written to the sink at the end of each page if there
    /// is one.
    pub fn new(options: &Options, output: Option<(Box<dyn Sink>, Format)>) -> Result<Self, SizeError> {
        let longest = output.as_ref().map_or(u32::MAX, |(_, format)| format.longest_side());
        let layout = Layout::limited(options, longest)?;
        Ok(TrueColour {
            layout,
            surface: layout.surface(),
            canvas: Arc::new(Mutex::new(Bitmap::new(layout.width, layout.height))),
            background: options.background,
            transparent: options.transparent,
            opaque: false,
            antialias: options.antialias.unwrap_or(true),
            care: Care::of(options),
            output,
            lines: Lines::new(),
            markers: Markers::new(),
            letters: Letters::new(),
            areas: AreaMask::new(),
            aliased: Aliased::new(),
        })
    }

    /// A handle to the pixels.
    pub fn shared(&self) -> SharedPixels {
        SharedPixels { canvas: Arc::clone(&self.canvas) }
    }

    /// Writes the picture as it is now as an image file.
    pub fn write(&self, sink: &mut dyn Sink, format: Format) -> Result<(), DeviceError> {
        let canvas = lock(&self.canvas);
        let samples =
            if self.opaque { Samples::Opaque(canvas.bytes()) } else { Samples::Rgba(canvas.demultiplied()) };
        encode::write(samples, self.layout, format, self.care, sink)
    }

    fn raster(&self) -> IRect {
        IRect::of_size(self.layout.width as i32, self.layout.height as i32)
    }

    /// Whether a clipping rectangle takes nothing away of the frame buffer.
    fn leaves_all(&self, clip: Option<Rect<Du>>) -> bool {
        // The maps that lead to device units leave their last digits in its edges.
        clip.is_none_or(|clip| clip.grown(LAST_DIGITS).contains_rect(&self.surface.extent()))
    }

    fn lines(&mut self, lines: Either<'_>, pen: &Pen<'_>) {
        let mut canvas = lock(&self.canvas);
        if self.antialias {
            return match lines {
                Either::Held(paths) => self.lines.draw(&mut canvas, paths, pen),
                Either::Long(line) => self.lines.draw_long(&mut canvas, line, pen),
            };
        }
        let above = pixel(pen.paint.colour);
        let (raster, surface) = (self.raster(), self.surface.extent());
        let mut once = (above[3] < 255).then(|| self.lines.once(raster));
        let span = |row: i32, from: i32, to: i32| match &mut once {
            Some(once) => once.span(row, from, to),
            None => canvas.span(row as usize, from as usize..to as usize).fill(above),
        };
        match lines {
            Either::Held(paths) => self.aliased.lines(*paths, pen, &surface, span),
            Either::Long(line) => self.aliased.long_line(line, pen, &surface, span),
        }
        if let Some(once) = once {
            once.draw(&mut canvas, above);
        }
    }

    /// Fills rings with one colour.
    ///
    /// Where two areas share a pixel, each covers a part of it, and what is below shows through both. So a pixel of an
    /// opaque fill area counts as covered twice as much as it is: one of two neighbours covers at least half of it and
    /// takes it whole, and no seam is left. The boundary stays antialiased, over half a pixel.
    fn area(&mut self, rings: Paths<'_, Du>, by: Rule, paint: &Paint) {
        let mut canvas = lock(&self.canvas);
        let above = pixel(paint.colour);
        let raster = self.raster();
        if !self.antialias {
            return self.aliased.area(rings, rule(by), raster, |row, from, to| {
                over_run(canvas.span(row as usize, from as usize..to as usize), above, 255);
            });
        }
        // The bounds of a long boundary are not worth the time.
        let all = (rings.points.len() > LONG_BOUNDARY).then(|| self.surface.extent());
        let Some(bounds) = all.or_else(|| rings.bounds()) else { return };
        let (columns, rows) =
            Window::new(None, self.layout.width, self.layout.height, true).touched_by(&bounds);
        let corner = |column: u32, row: u32| IVec2::new(column as i32, row as i32);
        let window = IRect::new(corner(columns.start, rows.start), corner(columns.end, rows.end));
        let mut ahead = Ahead::new(&canvas, columns, rows);
        let coat = Coat::new(above);
        let gain = if by == Rule::EvenOdd && above[3] == 255 { Gain::Double } else { Gain::One };
        self.areas.cover(rings.points, rings.ends, (rule(by), gain), window, |row, from, cover| {
            ahead.reach(&canvas, row as u32);
            coat.over_cover(canvas.rest(row as usize, from as usize), cover);
        });
    }

    fn pattern(
        &mut self,
        (rings, rule): (Paths<'_, Du>, path::Rule),
        clip: Option<Rect<Du>>,
        (frame, grid): (&Parallelogram<Du>, &Grid<'_>),
    ) {
        let window = Window::new(clip, self.layout.width, self.layout.height, self.antialias);
        let mut canvas = lock(&self.canvas);
        if self.antialias {
            return pattern::fill(&mut canvas, &mut self.areas, (rings, rule), &window, (frame, grid));
        }
        pattern::fill_whole(&mut canvas, &mut self.aliased, (rings, rule), &window, (frame, grid));
    }
}

impl Device for TrueColour {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.begin(page)?;
        Ok(Drawn::Yes)
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        let background = match (self.transparent, self.background) {
            (true, _) => Colour { alpha: 0.0, ..Colour::BLACK },
            (false, Some(colour)) => colour,
            (false, None) => page.background,
        };
        self.opaque = background.to_bytes()[3] == 255;
        lock(&self.canvas).fill(pixel(background));
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let (width, height) = (self.layout.width, self.layout.height);
        match (&mark.form, mark.clip) {
            (Form::Lines(paths, pen), None) if pen.dash.is_empty() => self.lines(Either::Held(paths), pen),
            (Form::LongLine(line, pen), clip)
                if clip.is_none() || self.antialias && self.leaves_all(clip) =>
            {
                self.lines(Either::Long(line), pen);
            }
            (Form::Area(rings, by, Fill::Solid(paint)), None) => self.area(*rings, *by, paint),
            (Form::Area(rings, by, Fill::Pattern(frame, grid)), clip) => {
                self.pattern((*rings, rule(*by)), clip, (frame, grid));
            }
            (Form::Markers(positions, style), clip)
                if self.antialias && Markers::can(style) && self.leaves_all(clip) =>
            {
                self.markers.draw(&mut lock(&self.canvas), positions, style);
            }
            (Form::StrokeText(text), clip)
                if self.antialias && Letters::can(text) && self.leaves_all(clip) =>
            {
                self.letters.draw(&mut lock(&self.canvas), text);
            }
            (Form::Cells(frame, grid), clip) => {
                let window = Window::new(clip, width, height, self.antialias);
                coloured_cells::draw(&mut lock(&self.canvas), frame, grid, &window);
            }
            (Form::IndexedCells(frame, cells, palette), clip) => {
                let window = Window::new(clip, width, height, self.antialias);
                coloured_cells::draw_indexed(&mut lock(&self.canvas), frame, cells, palette, &window);
            }
            _ => return Ok(Drawn::No),
        }
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        let Some((mut sink, format)) = self.output.take() else { return Ok(()) };
        let written = self.write(sink.as_mut(), format);
        self.output = Some((sink, format));
        written
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        Some(self)
    }
}

impl FrameBuffer for TrueColour {
    fn size(&self) -> (u32, u32) {
        (self.layout.width, self.layout.height)
    }

    fn colour(&self, column: u32, row: u32) -> Option<Colour> {
        lock(&self.canvas).pixel(column, row).map(colour)
    }

    fn index(&self, _: u32, _: u32) -> Option<u32> {
        None
    }

    fn set_colour(&mut self, _: u32, _: Colour) -> bool {
        false
    }

    fn set_antialiasing(&mut self, on: bool) -> bool {
        self.antialias = on;
        true
    }

    fn antialiasing(&self) -> bool {
        self.antialias
    }
}

#[cfg(test)]
mod tests;
