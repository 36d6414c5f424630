//! Solid lines: outlines of pieces of bounded length, and dots.
//!
//! The scan converter needs more than linear time for the outline of a long line, so a wide line is drawn in
//! pieces. A piece after the first starts a little before its first corner, so that no corner lacks its
//! join. A line no wider than a pixel is drawn segment by segment. Of long lines, vertices are left out that
//! make no difference to be seen.

use super::composite::{Pixel, over, pixel};
use super::curve::Outline;
use gks_algorithms::line::m4;
use gks_geometry::{Du, Paths};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::Pen;
use gks_pipeline::item::Curve;
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;
use tiny_skia::{FillRule, LineCap, LineJoin, Paint, Pixmap, Stroke, Transform};

/// The most points of an outline.
const PIECE: usize = 512;
/// How far vertices that are left out may be from the line drawn, in pixels.
const TOLERANCE: f64 = 0.125;
/// A dot up to this width in pixels is a square.
const WIDEST_SQUARE: f64 = 2.0;

/// The width that a line is drawn with: a pixel at least, unless it is meant to be fainter.
pub(super) fn visible_width(width: f64) -> f64 {
    if (0.5..1.0).contains(&width) { 1.0 } else { width.max(0.0) }
}

/// Where lines are drawn and how.
pub(super) struct Stroker<'a> {
    canvas: &'a mut Pixmap,
    /// The point of the raster in the corner of the canvas.
    corner: DVec2,
    paint: Paint<'static>,
    colour: Pixel,
    stroke: Stroke,
    cap: Cap,
    width: f64,
    piece: usize,
}

impl<'a> Stroker<'a> {
    /// A stroker that draws with the width and ends of a pen and an opaque colour.
    pub(super) fn new(
        canvas: &'a mut Pixmap,
        corner: DVec2,
        colour: Colour,
        pen: &Pen<'_>,
        antialias: bool,
    ) -> Self {
        let width = visible_width(pen.width);
        let thin = width <= 1.0;
        let mut paint = Paint { anti_alias: antialias, ..Paint::default() };
        paint.set_color(super::composite::skia(colour));
        let stroke = Stroke {
            // Without antialiasing, width 0 is the line of single pixels.
            width: if thin && !antialias { 0.0 } else { width as f32 },
            miter_limit: 10.0,
            line_cap: match pen.cap {
                Cap::Butt => LineCap::Butt,
                Cap::Round => LineCap::Round,
                Cap::Projecting => LineCap::Square,
            },
            line_join: match pen.join {
                Join::Miter => LineJoin::Miter,
                Join::Round => LineJoin::Round,
                Join::Bevel => LineJoin::Bevel,
            },
            dash: None,
        };
        let piece = if thin { usize::MAX } else { PIECE };
        Stroker { canvas, corner, paint, colour: pixel(colour), stroke, cap: pen.cap, width, piece }
    }

    /// Draws paths.
    pub(super) fn lines(&mut self, paths: Paths<'_, Du>) {
        let mut outline = Outline::new(self.corner);
        let mut discs = Outline::new(self.corner);
        let mut points = 0;
        let mut distinct = Vec::new();
        for path in paths.iter() {
            distinct.clear();
            let finite = path.iter().copied().filter(|p| p.is_finite());
            if path.len() > PIECE {
                m4(finite, TOLERANCE, |p| distinct.push(p));
            } else {
                distinct.extend(finite);
            }
            distinct.dedup();
            match *distinct {
                [] => continue,
                [dot] if self.width <= WIDEST_SQUARE || self.cap != Cap::Round => self.square(dot),
                [dot] => discs.disc(dot, self.width * 0.5),
                _ if distinct.len() > self.piece => self.long(&distinct),
                _ => {
                    points += distinct.len();
                    add(&mut outline, &distinct);
                }
            }
            if points > PIECE {
                self.draw(std::mem::replace(&mut outline, Outline::new(self.corner)));
                points = 0;
            }
        }
        self.draw(outline);
        if let Some(path) = discs.finish() {
            self.canvas.fill_path(&path, &self.paint, FillRule::Winding, Transform::identity(), None);
        }
    }

    /// Draws a curve.
    pub(super) fn curve(&mut self, curve: &Curve<'_, Du>) {
        let mut outline = Outline::new(self.corner);
        outline.curve(curve);
        self.draw(outline);
    }

    fn draw(&mut self, outline: Outline) {
        if let Some(path) = outline.finish() {
            self.canvas.stroke_path(&path, &self.paint, &self.stroke, Transform::identity(), None);
        }
    }

    /// Draws a line of many points in pieces.
    fn long(&mut self, path: &[DVec2]) {
        let last = path.len() - 1;
        let cap = std::mem::replace(&mut self.stroke.line_cap, LineCap::Butt);
        let beside = |end: DVec2, inner: DVec2, reach: f64| end + (inner - end).normalize() * reach;
        let closed = path[0] == path[last];
        let reach = if self.cap == Cap::Projecting && !closed { -0.5 * self.width } else { 0.0 };
        for from in (0..last).step_by(self.piece) {
            let to = (from + self.piece).min(last);
            let mut outline = Outline::new(self.corner);
            if from == 0 {
                outline.move_to(beside(path[0], path[1], reach));
            } else {
                outline.move_to(beside(path[from], path[from - 1], self.width));
                outline.line_to(path[from]);
            }
            for &p in &path[from + 1..to] {
                outline.line_to(p);
            }
            if to < last {
                outline.line_to(path[to]);
            } else if closed {
                outline.line_to(path[0]);
                outline.line_to(beside(path[0], path[1], self.width));
            } else {
                outline.line_to(beside(path[last], path[last - 1], reach));
            }
            self.draw(outline);
        }
        self.stroke.line_cap = cap;
        if self.cap == Cap::Round && !closed {
            let ends = [path[0], path[last]];
            let mut discs = Outline::new(self.corner);
            for end in ends {
                discs.disc(end, self.width * 0.5);
            }
            if let Some(path) = discs.finish() {
                self.canvas.fill_path(&path, &self.paint, FillRule::Winding, Transform::identity(), None);
            }
        }
    }

    /// Draws a square as wide as the pen.
    fn square(&mut self, centre: DVec2) {
        let (columns, rows) = (self.canvas.width(), self.canvas.height());
        let centre = centre - self.corner;
        let half = self.width.max(1.0) * 0.5;
        let (mut low, mut high) = (centre - half, centre + half);
        if !self.paint.anti_alias {
            let side = (half * 2.0).round();
            low = (low + 0.5).floor();
            high = low + side;
        }
        let span = |low: f64, high: f64, size: u32| {
            let start = low.floor().clamp(0.0, f64::from(size)) as u32;
            start..(high.ceil().clamp(0.0, f64::from(size)) as u32).max(start)
        };
        let part = |at: u32, low: f64, high: f64| {
            ((f64::from(at) + 1.0).min(high) - f64::from(at).max(low)).clamp(0.0, 1.0)
        };
        let faint = if self.width > 0.0 { self.width.min(1.0) } else { 1.0 };
        for row in span(low.y, high.y, rows) {
            let of_row = part(row, low.y, high.y) * faint;
            for column in span(low.x, high.x, columns) {
                let covered = of_row * part(column, low.x, high.x);
                let below = &mut self.canvas.pixels_mut()[(row * columns + column) as usize];
                over(below, self.colour, (covered * 255.0).round() as u8);
            }
        }
    }
}

/// Adds a path of distinct points, closed where it ends at its start.
fn add(outline: &mut Outline, path: &[DVec2]) {
    let closed = path.len() > 3 && path[0] == path[path.len() - 1];
    let open = if closed { &path[..path.len() - 1] } else { path };
    outline.move_to(open[0]);
    for &p in &open[1..] {
        outline.line_to(p);
    }
    if closed {
        outline.close();
    }
}
