//! A transparent sheet to draw prompts and echoes on, with the painter that draws pictures.

use crate::options::Options;
use crate::raster::TrueColour;
use gks_geometry::{Dc, Map, Ndc, Paths, Point, Rect, Vector};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::{Device, DeviceError, Page, Surface};
use gks_pipeline::item::{Closure, Curve, Ellipse, Item, Role, Shape};
use gks_pipeline::look::{Cap, Horizontal, InteriorStyle, Join, Look, Precision, Vertical};
use gks_pipeline::painter::{Canvas, Painter};
use gks_pipeline::tables::Tables;
use gks_pipeline::trace::Trace;
use glam::{DAffine2, DMat2, DVec2};

/// The colours of prompts and echoes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Ink {
    /// What lies under the text of panels.
    Panel,
    /// The edge of panels and what is not in use.
    Faint,
    /// Text on panels.
    Text,
    /// Text of what is not offered.
    Dim,
    /// What the operator moves.
    Accent,
    /// What is marked.
    Marked,
    /// Lines over the picture.
    Line,
    /// What sets lines off from a dark picture.
    Halo,
    /// The background of pictures on panels: that of the picture below.
    Paper,
}

const INKS: [(Ink, [u8; 4]); 9] = [
    (Ink::Panel, [27, 31, 39, 232]),
    (Ink::Faint, [88, 98, 116, 255]),
    (Ink::Text, [240, 243, 248, 255]),
    (Ink::Dim, [128, 137, 153, 255]),
    (Ink::Accent, [77, 163, 255, 255]),
    (Ink::Marked, [38, 92, 168, 255]),
    (Ink::Line, [16, 20, 28, 255]),
    (Ink::Halo, [255, 255, 255, 190]),
    (Ink::Paper, [255; 4]),
];

/// The sheet. Positions and lengths are metres on the display surface.
pub(super) struct Sketch {
    sheet: TrueColour,
    surface: Surface,
    tables: Tables,
    painter: Painter,
    look: Look,
    map: Map<Ndc, gks_geometry::Du>,
    whole: Rect<Ndc>,
    /// Side of a pixel in metres.
    pub(super) pixel: f64,
}

/// A font of the outline fonts: sans serif.
const SANS: i32 = -21;

impl Sketch {
    /// A sheet as large as a display surface of whole pixels.
    pub(super) fn new(surface: &Surface) -> Result<Sketch, String> {
        let size = Some((surface.width, surface.height));
        let options = Options { size, transparent: true, ..Options::default() };
        let sheet = TrueColour::new(&options, None).map_err(|error| error.to_string())?;
        let mut tables = Tables::predefined();
        for (ink, [red, green, blue, alpha]) in INKS {
            let [red, green, blue, alpha] = [red, green, blue, alpha].map(|v| f32::from(v) / 255.0);
            tables.colours.set(ink as u32, Colour { red, green, blue, alpha });
        }
        let mut look = Look { cap: Cap::Round, join: Join::Round, ..Look::default() };
        look.fill.interior = InteriorStyle::Solid;
        (look.text.font, look.text.precision) = (SANS, Precision::Stroke);
        look.text_geometry.vertical = Vertical::Half;
        let scale = DMat2::from_diagonal(DVec2::new(1.0, -1.0) / surface.unit);
        let map = Map::from_affine(DAffine2::from_mat2_translation(scale, DVec2::new(0.0, surface.height)));
        let (width, height) = (surface.width * surface.unit, surface.height * surface.unit);
        Ok(Sketch {
            sheet,
            surface: surface.clone(),
            tables,
            painter: Painter::default(),
            look,
            map,
            whole: Rect::new(0.0, width, 0.0, height),
            pixel: surface.unit,
        })
    }

    /// Changes the background of pictures on panels.
    pub(super) fn set_paper(&mut self, colour: Colour) {
        self.tables.colours.set(Ink::Paper as u32, Colour { alpha: 1.0, ..colour });
    }

    /// Starts with nothing.
    pub(super) fn begin(&mut self) -> Result<(), DeviceError> {
        self.sheet.begin(&Page { number: 1, background: Colour::WHITE, colours: Vec::new() })
    }

    /// What has been drawn: red, green, blue and opacity of each pixel, premultiplied.
    pub(super) fn pixels(&self) -> Vec<u8> {
        self.sheet.shared().read(<[u8]>::to_vec)
    }

    fn paint(&mut self, shape: Shape<'_>) -> Result<(), DeviceError> {
        let item = Item { shape, look: &self.look, clip: self.whole, pick: 0 };
        let mut canvas = Canvas {
            device: &mut self.sheet,
            surface: &self.surface,
            tables: &self.tables,
            map: self.map,
            clip_map: self.map,
            glow: false,
            window: self.whole,
        };
        self.painter.paint(&item, &mut canvas)
    }

    /// Draws what the kernel wants to be shown as it is.
    pub(super) fn trace(&mut self, trace: &Trace) -> Result<(), DeviceError> {
        trace.draw(&mut self.sheet)
    }

    /// Draws a line, `pixels` wide.
    pub(super) fn line(&mut self, points: &[Point<Dc>], pixels: f64, ink: Ink) -> Result<(), DeviceError> {
        self.look.line.width = pixels / self.surface.nominal_linewidth();
        self.look.line.colour = ink as u32;
        let points = Point::as_vecs(points);
        self.paint(Shape::Polyline(Paths::new(&points, &[points.len() as u32])))
    }

    /// Draws a dark line with a light edge, which is seen on every picture.
    pub(super) fn visible_line(&mut self, points: &[Point<Dc>]) -> Result<(), DeviceError> {
        self.line(points, 3.5, Ink::Halo)?;
        self.line(points, 1.25, Ink::Line)
    }

    /// Fills an area.
    pub(super) fn area(&mut self, points: &[Point<Dc>], ink: Ink) -> Result<(), DeviceError> {
        self.look.fill.colour = ink as u32;
        let points = Point::as_vecs(points);
        self.paint(Shape::FillArea(Paths::new(&points, &[points.len() as u32])))
    }

    /// Fills a rectangle with round corners.
    pub(super) fn rounded(&mut self, of: &Rect<Dc>, radius: f64, ink: Ink) -> Result<(), DeviceError> {
        let radius = radius.min(of.width() / 2.0).min(of.height() / 2.0);
        let inner = of.grown(-radius);
        // Counterclockwise from the right edge, a quarter of a circle at each corner.
        let corners = [(1.0, 1.0), (0.0, 1.0), (0.0, 0.0), (1.0, 0.0)];
        let mut outline = Vec::with_capacity(36);
        for (quarter, (right, top)) in corners.into_iter().enumerate() {
            let x = inner.min.x() + inner.width() * right;
            let y = inner.min.y() + inner.height() * top;
            for step in 0..=8 {
                let angle = (quarter as f64 + f64::from(step) / 8.0) * std::f64::consts::FRAC_PI_2;
                outline.push(Point::new(x + radius * angle.cos(), y + radius * angle.sin()));
            }
        }
        self.area(&outline, ink)
    }

    /// Fills a disc.
    pub(super) fn disc(&mut self, centre: Point<Dc>, radius: f64, ink: Ink) -> Result<(), DeviceError> {
        self.look.fill.colour = ink as u32;
        let ellipse = Ellipse {
            centre: Point::from_vec(centre.0),
            a: Vector::new(radius, 0.0),
            b: Vector::new(0.0, radius),
            start: 0.0,
            sweep: std::f64::consts::TAU,
            closure: Closure::Full,
        };
        self.paint(Shape::Generalized(Curve::Ellipse(ellipse), Role::Area))
    }

    /// Writes text with capital letters of a height, at a position that is halfway up the letters.
    pub(super) fn text(
        &mut self,
        at: Point<Dc>,
        text: &str,
        height: f64,
        horizontal: Horizontal,
        ink: Ink,
    ) -> Result<(), DeviceError> {
        self.look.text.colour = ink as u32;
        self.look.text_geometry.height = Vector::new(0.0, height);
        self.look.text_geometry.width = Vector::new(height, 0.0);
        self.look.text_geometry.horizontal = horizontal;
        self.paint(Shape::Text(Point::from_vec(at.0), text))
    }
}
