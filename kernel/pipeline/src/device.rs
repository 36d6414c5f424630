//! The contract between the pipeline and a device driver: the driver manual.
//!
//! A driver turns [`Mark`]s into bytes or pixels. A mark is what remains of a primitive when the pipeline
//! has resolved its attributes, mapped it to the units of the device and clipped it: concrete colours,
//! widths and positions. A driver neither transforms nor clips.
//!
//! A driver may *refuse* a mark by answering [`Drawn::No`]; the pipeline then comes back with simpler marks
//! that give the same picture: text becomes outlines or strokes, markers lines, dashes pieces, areas
//! hatch lines, curves polygons. It may refuse by the kind and the look of a mark, never by its
//! coordinates. That a mark carries a clipping rectangle belongs to its look. Only one mark must be
//! accepted by every driver: [`Form::Lines`] with a solid pen and no clipping rectangle. So the smallest
//! driver draws solid lines and still shows every picture; here it is, complete:
//!
//! ```
//! use gks_geometry::{Du, Rect};
//! use gks_pipeline::device::*;
//!
//! /// Writes every line as text.
//! struct Lister { surface: Surface, out: Vec<u8> }
//!
//! impl Device for Lister {
//!     fn surface(&self) -> &Surface { &self.surface }
//!     fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
//!         self.out.extend(format!("page {}\n", page.number).bytes());
//!         Ok(())
//!     }
//!     fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
//!         let (Form::Lines(paths, pen), None) = (&mark.form, &mark.clip) else { return Ok(Drawn::No) };
//!         if !pen.dash.is_empty() { return Ok(Drawn::No) }
//!         for path in paths.iter() {
//!             let points: Vec<String> = path.iter().map(|p| format!("{:.0},{:.0}", p.x, p.y)).collect();
//!             self.out.extend(format!("{} colour {}\n", points.join(" "), pen.paint.index).bytes());
//!         }
//!         Ok(Drawn::Yes)
//!     }
//!     fn end(&mut self) -> Result<(), DeviceError> { Ok(()) }
//!     fn close(&mut self) -> Result<(), DeviceError> { Ok(()) }
//! }
//! ```

use crate::colour::{Colour, Paint};
use crate::font::{OutlineFace, StrokeGlyph};
use crate::input::Input;
use crate::item::{Cells, Curve, Ellipse, Parallelogram};
use crate::look::{Cap, Join};
use crate::tables::Tables;
use gks_geometry::{Du, LongLine, PathBuf, Paths, Point, Rect, Vector};
use glam::DVec2;
use std::io;

/// A drawing device: a file format, a frame buffer, a plotter.
///
/// The pipeline calls `begin`, any number of `draw`, `end` for each page, and `close` once after the last
/// page. At least one page is begun before `close`.
pub trait Device: Send {
    /// The display surface.
    fn surface(&self) -> &Surface;

    /// Starts a page with an empty display surface.
    fn begin(&mut self, page: &Page) -> Result<(), DeviceError>;

    /// Starts the page begun over, with an empty display surface, where nobody has received any of it yet;
    /// [`Drawn::No`] leaves it as it is. So a picture that is drawn again takes the place of the old one.
    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        let _ = page;
        Ok(Drawn::No)
    }

    /// Draws a mark over what is there, or refuses it untouched.
    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError>;

    /// Draws a mark inside of an ellipse or a sector of one, or refuses it untouched. Most devices refuse all of them; the
    /// pipeline then cuts what can be cut.
    fn draw_within(&mut self, mark: &Mark<'_>, region: &Ellipse<Du>) -> Result<Drawn, DeviceError> {
        let _ = (mark, region);
        Ok(Drawn::No)
    }

    /// Completes the page; a file that holds one page appears under its name now.
    fn end(&mut self) -> Result<(), DeviceError>;

    /// Completes the whole output after the last page.
    fn close(&mut self) -> Result<(), DeviceError>;

    /// The pixels of the page begun, where the device has any that can be read back.
    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        None
    }

    /// Makes visible what has been drawn on the page begun, where somebody looks at it while it grows.
    fn flush(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    /// What an operator acts on, where there is an operator.
    fn input(&mut self) -> Option<&mut dyn Input> {
        None
    }
}

/// The pixels of a raster device. Columns count from the left, rows from the top, both from 0.
pub trait FrameBuffer {
    /// Number of columns and rows.
    fn size(&self) -> (u32, u32);

    /// The colour that the pixel shows, or none outside of the frame buffer.
    fn colour(&self, column: u32, row: u32) -> Option<Colour>;

    /// The colour index stored in the pixel where the frame buffer stores indices.
    fn index(&self, column: u32, row: u32) -> Option<u32>;

    /// Changes what the pixels with a colour index show from now on; `false` where pixels hold colours and
    /// cannot change.
    fn set_colour(&mut self, index: u32, colour: Colour) -> bool;

    /// Turns antialiasing on or off for what is drawn from now on; `false` where there is no choice.
    fn set_antialiasing(&mut self, on: bool) -> bool;

    /// Whether what is drawn now is antialiased.
    fn antialiasing(&self) -> bool;
}

/// The display surface of a device.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Width in device units.
    pub width: f64,
    /// Height in device units.
    pub height: f64,
    /// Length of one device unit in metres.
    pub unit: f64,
    /// Whether ordinates count downwards from the upper left corner instead of upwards from the lower left.
    pub y_down: bool,
    /// The smallest distance the device can show, in device units: a pixel, a plotter step. Curves are
    /// flattened to within a fraction of it.
    pub resolution: f64,
    /// Width of the pen in device units where the device draws with pens: areas become hatches, text becomes
    /// strokes, and a line wider than the pen comes as several. None where areas can be filled.
    pub pen: Option<f64>,
}

impl Surface {
    /// The whole display surface in device units.
    pub fn extent(&self) -> Rect<Du> {
        Rect::new(0.0, self.width, 0.0, self.height)
    }

    /// The nominal linewidth in device units: 1/1000 of the shorter side on every device.
    pub fn nominal_linewidth(&self) -> f64 {
        self.width.min(self.height) / 1000.0
    }

    /// The nominal marker size in device units: 6/1000 of the shorter side on every device.
    pub fn nominal_marker_size(&self) -> f64 {
        self.nominal_linewidth() * 6.0
    }
}

/// What a page starts with.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Pages count from 1.
    pub number: u32,
    /// The colour of the empty display surface: colour index 0 of the workstation.
    pub background: Colour,
    /// The colour table when the page begins, for devices that store indices.
    pub colours: Vec<(u32, Colour)>,
}

/// A concrete mark on the display surface, in device units.
#[derive(Clone, Debug)]
pub struct Mark<'a> {
    /// What is drawn.
    pub form: Form<'a>,
    /// Nothing may appear outside of this rectangle; none where the mark lies inside anyway.
    pub clip: Option<Rect<Du>>,
}

/// What a mark draws.
#[derive(Clone, Debug)]
pub enum Form<'a> {
    /// Lines along paths; a path of one point is a dot as wide as the pen.
    Lines(Paths<'a, Du>, Pen<'a>),
    /// A line of so many points that they are not held: they come piece by piece. Refused, it comes as lines.
    LongLine(LongLine<'a, Du>, Pen<'a>),
    /// The area inside of rings.
    Area(Paths<'a, Du>, Rule, Fill<'a>),
    /// The same marker at many positions.
    Markers(&'a [DVec2], MarkerStyle),
    /// Characters of an outline font.
    Text(GlyphRun<'a>),
    /// Characters of stroke fonts, for devices that keep pictures of them. Refused, they come as lines.
    StrokeText(StrokeText<'a>),
    /// A parallelogram of cells, each filled with one colour; a pixel takes the colour of the cell that
    /// contains its centre. Row by row, column fastest.
    Cells(Parallelogram<Du>, Grid<'a>),
    /// Such cells as colour indices, for devices that look them up faster. Refused, they come as paints.
    IndexedCells(Parallelogram<Du>, Cells<'a>, Palette<'a>),
    /// A curve drawn with a pen.
    Stroke(Curve<'a, Du>, Pen<'a>),
    /// The area enclosed by a curve.
    Filled(Curve<'a, Du>, Paint),
}

/// Which points count as inside of overlapping rings.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Those that a ray leaves through an odd number of edges: fill areas.
    EvenOdd,
    /// Those around which the rings turn at all: character outlines.
    NonZero,
}

/// How lines are drawn.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Pen<'a> {
    /// The colour.
    pub paint: Paint,
    /// The linewidth in device units.
    pub width: f64,
    /// Lengths of dashes and gaps in turn, in device units, starting with a dash; empty for a solid line.
    pub dash: &'a [f64],
    /// The ends, of dashes too.
    pub cap: Cap,
    /// The corners.
    pub join: Join,
}

/// How an area is filled.
#[derive(Copy, Clone, Debug)]
pub enum Fill<'a> {
    /// With one colour.
    Solid(Paint),
    /// With copies of a pattern: `0` is one copy, whose cells lie as in a cell array; the plane is tiled
    /// with it along both edges.
    Pattern(Parallelogram<Du>, Grid<'a>),
}

/// A rectangular array of paints, row by row, column fastest.
#[derive(Copy, Clone, Debug)]
pub struct Grid<'a> {
    /// The paints, `columns` times `rows` of them.
    pub paints: &'a [Paint],
    /// Number of columns.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
}

/// What the colour indices of cells show.
#[derive(Copy, Clone, Debug)]
pub struct Palette<'a> {
    tables: &'a Tables,
}

impl<'a> Palette<'a> {
    /// The palette of a workstation with these tables.
    pub fn new(tables: &'a Tables) -> Self {
        Palette { tables }
    }

    /// The paint of an index; a negative one is drawn as index 1, like one without an entry.
    pub fn paint(&self, index: i32) -> Paint {
        self.tables.translucent(u32::try_from(index).unwrap_or(u32::MAX), self.tables.opacity.areas)
    }
}

/// How markers are drawn.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct MarkerStyle {
    /// The marker type of the standard (1 to 5) or a private one (negative).
    pub kind: i32,
    /// The width and height of the marker in device units.
    pub size: f64,
    /// The width of the marker's lines in device units.
    pub width: f64,
    /// The colour.
    pub paint: Paint,
}

/// Characters of one outline font, placed one by one.
#[derive(Clone, Debug)]
pub struct GlyphRun<'a> {
    /// The text that the run shows.
    pub text: &'a str,
    /// The font.
    pub face: &'static OutlineFace,
    /// The characters in the order of `text`.
    pub glyphs: &'a [Glyph],
    /// The image of the horizontal unit vector of the em square: for upright text (size, 0).
    pub x: Vector<Du>,
    /// The image of the vertical unit vector of the em square, which points up in the font.
    pub y: Vector<Du>,
    /// The colour.
    pub paint: Paint,
}

/// A character in a [`GlyphRun`].
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Glyph {
    /// The glyph number in the font.
    pub id: u16,
    /// The byte offset in the text of the run of the first character that this glyph shows.
    pub cluster: u32,
    /// The origin of the glyph: left edge of the body on the base line.
    pub origin: Point<Du>,
}

/// Characters of stroke fonts, placed one by one.
#[derive(Copy, Clone, Debug)]
pub struct StrokeText<'a> {
    /// The characters in the order in which they are drawn.
    pub characters: &'a [StrokeCharacter],
    /// The image of the horizontal vector as long as capital letters are high.
    pub x: Vector<Du>,
    /// The image of the vector from base line to cap line.
    pub y: Vector<Du>,
    /// How the strokes are drawn.
    pub pen: Pen<'a>,
}

/// A character in a [`StrokeText`].
#[derive(Copy, Clone, Debug)]
pub struct StrokeCharacter {
    /// The strokes.
    pub glyph: &'static StrokeGlyph,
    /// The origin of the glyph: left edge of the body on the base line.
    pub origin: Point<Du>,
}

impl StrokeText<'_> {
    /// Adds the strokes of all characters to paths.
    pub fn add_to(&self, paths: &mut PathBuf<Du>) {
        for StrokeCharacter { glyph, origin } in self.characters {
            for stroke in glyph.strokes() {
                paths.add(stroke.iter().map(|p| origin.0 + self.x.0 * p.x + self.y.0 * p.y));
            }
        }
    }
}

/// A driver's answer to a mark.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[must_use]
pub enum Drawn {
    /// The mark is drawn.
    Yes,
    /// The mark is refused and nothing of it is drawn.
    No,
}

/// Why a device failed.
#[derive(Debug, thiserror::Error)]
pub enum DeviceError {
    /// Bytes could not be written.
    #[error("writing the picture failed: {0}")]
    Io(#[from] io::Error),
    /// The picture could not be encoded.
    #[error("encoding the picture failed: {0}")]
    Encode(String),
}

/// Where a driver writes: documents one after the other, each of which appears only when it is complete.
///
/// A driver for a format that holds one page opens a document for each page, any other one for all.
pub trait Sink: Send {
    /// Starts the next document.
    fn open(&mut self) -> io::Result<()>;

    /// Appends bytes to the document.
    fn write(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// Takes back what was written to the document, which is empty then; `false` where bytes are gone.
    fn restart(&mut self) -> io::Result<bool> {
        Ok(false)
    }

    /// Hands what was written on to the operating system, so that it outlives the program.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }

    /// Completes the document and makes it appear under its final name.
    fn finish(&mut self) -> io::Result<()>;
}
