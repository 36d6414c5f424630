//! The yardstick: direct calls of tiny-skia.

use super::scene::{Canvas, SIDE, StrokePen, colour, pixel};
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, PixmapPaint, Rect, Stroke, StrokeDash,
    Transform,
};

/// A canvas of tiny-skia.
pub struct TinySkia {
    canvas: Pixmap,
}

impl TinySkia {
    /// A white canvas; none if there is no memory for it.
    pub fn new() -> Option<TinySkia> {
        let mut canvas = Pixmap::new(SIDE, SIDE)?;
        canvas.fill(Color::WHITE);
        Some(TinySkia { canvas })
    }

    /// The pixels, row by row from the top.
    pub fn pixels(&self) -> Vec<[u8; 3]> {
        self.canvas.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]).collect()
    }
}

fn color(index: i32) -> Color {
    let [red, green, blue, alpha] = colour(index).to_bytes();
    Color::from_rgba8(red, green, blue, alpha)
}

fn paint(index: i32, antialias: bool) -> Paint<'static> {
    let mut paint = Paint { anti_alias: antialias, ..Paint::default() };
    paint.set_color(color(index));
    paint
}

/// The path through points in pixels.
fn path(points: impl Iterator<Item = (f64, f64)>) -> PathBuilder {
    let mut path = PathBuilder::new();
    for (i, (x, y)) in points.enumerate() {
        if i == 0 { path.move_to(x as f32, y as f32) } else { path.line_to(x as f32, y as f32) }
    }
    path
}

impl Canvas for TinySkia {
    fn stroke(&mut self, points: &[(f64, f64)], pen: &StrokePen) {
        let dashes: Vec<f32> = pen.dashes.iter().map(|&d| d as f32).collect();
        let stroke = Stroke {
            // Width 0 is the line of single pixels.
            width: if pen.antialias { pen.width as f32 } else { 0.0 },
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(dashes, 0.0),
            ..Stroke::default()
        };
        if let Some(path) = path(points.iter().map(|&p| pen.pixel(p))).finish() {
            let paint = paint(1, pen.antialias);
            self.canvas.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
        }
    }

    fn fill(&mut self, polygon: &[(f64, f64)], colour: i32) {
        let mut path = path(polygon.iter().map(|&p| pixel(p)));
        path.close();
        if let Some(path) = path.finish() {
            let same = Transform::identity();
            self.canvas.fill_path(&path, &paint(colour, true), FillRule::EvenOdd, same, None);
        }
    }

    fn dot(&mut self, at: (f64, f64)) {
        let (x, y) = pixel(at);
        if let Some(square) = Rect::from_xywh(x.floor() as f32, y.floor() as f32, 1.0, 1.0) {
            self.canvas.fill_rect(square, &paint(1, true), Transform::identity(), None);
        }
    }

    fn circle(&mut self, centre: (f64, f64), radius: f64, filled: bool) {
        let ((x, y), radius) = (pixel(centre), radius * f64::from(SIDE));
        let Some(circle) = PathBuilder::from_circle(x as f32, y as f32, radius as f32) else { return };
        let (paint, same) = (paint(1, true), Transform::identity());
        if filled {
            self.canvas.fill_path(&circle, &paint, FillRule::Winding, same, None);
        } else {
            self.canvas.stroke_path(&circle, &paint, &Stroke::default(), same, None);
        }
    }

    fn cells(&mut self, indices: &[i32], columns: usize, rows: usize) {
        let Some(mut image) = Pixmap::new(columns as u32, rows as u32) else { return };
        for (pixel, &index) in image.pixels_mut().iter_mut().zip(indices) {
            *pixel = color(index).premultiply().to_color_u8();
        }
        let grown = Transform::from_scale(SIDE as f32 / columns as f32, SIDE as f32 / rows as f32);
        self.canvas.draw_pixmap(0, 0, image.as_ref(), &PixmapPaint::default(), grown, None);
    }
}
