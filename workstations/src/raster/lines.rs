//! Antialiased lines: the union of their samples, put over the picture once.
//!
//! A line that meets itself is no darker there, translucent ones included, and a million points on a thousand columns
//! cost what can be seen of them: vertices are left out that make no difference before anything is drawn.

use super::bitmap::Bitmap;
use super::composite::{Ink, Pixel, over, pixel};
use super::stroke::Stroke;
use gks_algorithms::coverage::SampleMask;
use gks_algorithms::line::m4;
use gks_algorithms::rect::IRect;
use gks_geometry::{Du, Paths};
use gks_pipeline::device::Pen;
use gks_pipeline::look::{Cap, Join};
use glam::{DVec2, IVec2};

/// How far vertices that are left out may be from the line drawn, in pixels: the distance of samples.
const TOLERANCE: f64 = 0.125;
/// Vertices are left out of paths of more points than this.
const LONG: usize = 256;
/// The bounds of paths of no more points than this are looked for.
const SHORT: usize = 4096;
/// The most pixels for which samples are kept at a time: 16 MiB of them.
const BAND: usize = 1 << 21;

/// The width that a line is drawn with: a pixel at least, unless it is meant to be fainter.
fn visible_width(width: f64) -> f64 {
    if (0.5..1.0).contains(&width) { 1.0 } else { width.max(0.0) }
}

/// Draws antialiased lines; owns the storage for that.
pub(super) struct Lines {
    mask: SampleMask,
    stroke: Stroke,
}

impl Lines {
    pub(super) fn new() -> Self {
        Lines { mask: SampleMask::new(), stroke: Stroke::new() }
    }

    /// Draws paths with a pen.
    pub(super) fn draw(&mut self, bitmap: &mut Bitmap, paths: Paths<'_, Du>, pen: &Pen<'_>) {
        let width = visible_width(pen.width);
        // Lines fainter than a pixel are a pixel wide and translucent, so that they look alike at any place.
        let strength = if width > 0.0 { (width.min(1.0) * 255.0).round() as u8 } else { 255 };
        let (columns, rows) = bitmap.size();
        let raster = IRect::of_size(columns as i32, rows as i32);
        if let (&[a, b], &[_]) = (paths.points, paths.ends)
            && pen.cap != Cap::Round
            && lone(bitmap, (a, b), width.max(1.0), pen.cap, (pixel(pen.paint.colour), strength))
        {
            return;
        }
        let ink = Ink::new(pixel(pen.paint.colour), strength);
        self.stroke.begin(width.max(1.0), pen.cap, pen.join);
        let window = self.window(paths, raster);
        if window.is_empty() {
            return;
        }
        let side = window.max - window.min;
        let band = (BAND / side.x as usize).max(1) as i32;
        for top in (window.min.y..window.max.y).step_by(band as usize) {
            let bottom = window.max.y.min(top.saturating_add(band));
            self.mask.begin(IRect::new(IVec2::new(window.min.x, top), IVec2::new(window.max.x, bottom)));
            self.follow(paths);
            self.mask.drain(|row, column, words| {
                let columns = column as usize..column as usize + words.len();
                ink.over_all(bitmap.span(row as usize, columns), words);
            });
        }
    }

    /// A place for pixels that are to be drawn once, however often they are named.
    pub(super) fn once(&mut self, raster: IRect) -> Once<'_> {
        self.mask.begin(raster);
        Once(&mut self.mask)
    }

    /// The pixels that paths may touch.
    fn window(&self, paths: Paths<'_, Du>, raster: IRect) -> IRect {
        if paths.points.len() > SHORT {
            return raster;
        }
        let Some(bounds) = paths.bounds() else { return IRect::default() };
        if !(bounds.min.is_finite() && bounds.max.is_finite()) {
            return raster;
        }
        let bounds = bounds.grown(self.stroke.reach() + 1.0);
        let inside = |p: DVec2| p.max(raster.min.as_dvec2()).min(raster.max.as_dvec2()).as_ivec2();
        IRect::new(inside(bounds.min.0), inside(bounds.max.0 + 1.0))
    }

    /// Adds the samples of paths.
    fn follow(&mut self, paths: Paths<'_, Du>) {
        let Lines { mask, stroke } = self;
        let mut polygon = |ring: &[DVec2]| mask.polygon(ring);
        for path in paths.iter() {
            if path.len() > LONG {
                // Of the needles that miters make of a line that goes to and fro most would be left out.
                let join = stroke.replace_join(|join| if join == Join::Miter { Join::Bevel } else { join });
                m4(path.iter().copied(), TOLERANCE, |p| stroke.to(p, &mut polygon));
                stroke.end(&mut polygon);
                stroke.replace_join(|_| join);
            } else {
                for &p in path {
                    stroke.to(p, &mut polygon);
                }
            }
            stroke.end(&mut polygon);
        }
    }
}

/// Pixels to be drawn together.
pub(super) struct Once<'a>(&'a mut SampleMask);

impl Once<'_> {
    /// Adds pixels of a row.
    pub(super) fn span(&mut self, row: i32, from: i32, to: i32) {
        self.0.pixels(row, from, to);
    }

    /// Puts a colour over them.
    pub(super) fn draw(self, bitmap: &mut Bitmap, above: Pixel) {
        self.0.drain(|row, column, words| {
            let columns = column as usize..column as usize + words.len();
            for (below, &bits) in bitmap.span(row as usize, columns).iter_mut().zip(words) {
                if bits != 0 {
                    over(below, above, 255);
                }
            }
        });
    }
}

/// The widest line that is drawn by [`lone`], in pixels.
const WIDEST_LONE: f64 = 2.0;

/// Draws one segment that lies inside of the bitmap, by how much of each pixel the line covers across its main
/// direction; `false` if that is not the way to draw it.
fn lone(
    bitmap: &mut Bitmap,
    (a, b): (DVec2, DVec2),
    width: f64,
    cap: Cap,
    (above, strength): (Pixel, u8),
) -> bool {
    let along = b - a;
    let length = along.length();
    let (columns, rows) = bitmap.size();
    let (low, high) = (a.min(b) - 2.0 * width, a.max(b) + 2.0 * width);
    let inside = low.min_element() >= 0.0 && high.x < f64::from(columns) && high.y < f64::from(rows);
    if !(inside && width <= WIDEST_LONE && length >= 1.0) {
        return false;
    }
    let steep = along.y.abs() > along.x.abs();
    let turned = |p: DVec2| if steep { DVec2::new(p.y, p.x) } else { p };
    let (from, to) = (turned(a), turned(b));
    let (from, to) = if from.x <= to.x { (from, to) } else { (to, from) };
    let run = to.x - from.x;
    let slope = (to.y - from.y) / run;
    let longer = if cap == Cap::Projecting { 0.5 * width * run / length } else { 0.0 };
    let (start, end) = (from.x - longer, to.x + longer);
    let half = 0.5 * width * length / run;
    let (step, cross) = if steep { (columns as usize, 1) } else { (1, columns as usize) };
    let pixels = bitmap.pixels_mut();
    let weight = f64::from(strength);
    for main in start as usize..=end as usize {
        let (left, right) = (start.max(main as f64), end.min(main as f64 + 1.0));
        let middle = from.y + ((left + right) * 0.5 - from.x) * slope;
        let (top, bottom) = (middle - half, middle + half);
        let part = (right - left) * weight;
        let line = &mut pixels[main * step..];
        for at in top as usize..=bottom as usize {
            let covered = bottom.min(at as f64 + 1.0) - top.max(at as f64);
            over(&mut line[at * cross], above, (covered * part + 0.5) as u8);
        }
    }
    true
}
