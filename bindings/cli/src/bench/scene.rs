//! What a benchmark draws: once through the kernel, and once by direct calls of another library.

use gks::Gks;
use gks_pipeline::colour::Colour;

/// The side of the canvas in pixels; nominal linewidth and marker size are 1 and 6 of them.
pub const SIDE: u32 = 1000;

/// A picture of a given number of primitives or points.
pub trait Scene {
    /// Draws the picture on the active workstations.
    fn draw(&self, gks: &mut Gks) -> gks::Result<()>;

    /// What is drawn, for programs in other languages.
    fn data(&self) -> Data<'_>;

    /// The same picture in the calls of a graphics library, one for each primitive, reading the same data; none
    /// where no such library has what is drawn.
    fn figures(&self) -> Option<Figures<'_>> {
        None
    }
}

/// The data of a scene, in the unit square, y up.
#[derive(Copy, Clone, Debug)]
pub enum Data<'a> {
    /// Points, and the end of each polygon in them; all in one if there is none.
    Parts(&'a [(f64, f64)], &'a [usize]),
    /// Two points for each line.
    Lines(&'a [[(f64, f64); 2]]),
    /// Colour indices, row by row from the top, and the number of columns.
    Cells(&'a [i32], usize),
    /// Strings with their positions.
    Strings(&'a [((f64, f64), String)]),
}

/// Draws a scene with a library that is no GKS.
pub type Figures<'a> = Box<dyn Fn(&mut dyn Canvas) + 'a>;

/// The calls of a graphics library on a canvas of [`SIDE`] x [`SIDE`] pixels that shows the unit square, y up.
pub trait Canvas {
    /// Strokes the path through points; only the part of x between `pen.window` is shown, over the whole width.
    fn stroke(&mut self, points: &[(f64, f64)], pen: &StrokePen);
    /// Fills a polygon by the even-odd rule.
    fn fill(&mut self, polygon: &[(f64, f64)], colour: i32);
    /// Fills the pixel that contains a point.
    fn dot(&mut self, at: (f64, f64));
    /// A circle one pixel wide, or a disc; the radius is in the unit of the points.
    fn circle(&mut self, centre: (f64, f64), radius: f64, filled: bool);
    /// Cells of colour indices, row by row from the top, over the whole canvas.
    fn cells(&mut self, indices: &[i32], columns: usize, rows: usize);
}

/// How a path is stroked: in black, with round caps and joins.
#[derive(Clone, Debug, PartialEq)]
pub struct StrokePen {
    /// The width in pixels.
    pub width: f64,
    /// Lengths of dashes and gaps in pixels; none for a solid line.
    pub dashes: Vec<f64>,
    /// Whether edges are antialiased; a line without is as thin as the library can draw.
    pub antialias: bool,
    /// The part of x that is shown.
    pub window: (f64, f64),
}

impl StrokePen {
    /// Solid, one pixel wide, antialiased, over the whole unit square.
    pub const THIN: StrokePen =
        StrokePen { width: 1.0, dashes: Vec::new(), antialias: true, window: (0.0, 1.0) };

    /// Where a point lies in pixels, y down.
    pub fn pixel(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let (left, right) = self.window;
        pixel(((x - left) / (right - left), y))
    }
}

/// Where a point of the unit square lies in pixels, y down.
pub fn pixel((x, y): (f64, f64)) -> (f64, f64) {
    let side = f64::from(SIDE);
    (x * side, side - y * side)
}

/// The colours of all benchmarks: 0 is white, 1 black, others differ from their neighbours.
pub fn colour(index: i32) -> Colour {
    let part = |factor: i32, start: i32| ((index * factor + start) & 255) as f32 / 255.0;
    match index {
        0 => Colour::WHITE,
        1 => Colour::BLACK,
        _ => Colour::rgb(part(37, 0), part(91, 60), part(151, 128)),
    }
}

/// The number of [`colour`]s.
pub const COLOURS: i32 = 256;
