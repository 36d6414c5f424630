//! Lines, areas and patterns without antialiasing: whole pixels, by the classical algorithms.

use super::stroke::Stroke;
use gks_algorithms::clip::polyline;
use gks_algorithms::fill::EdgeTable;
use gks_algorithms::line::{M4, bresenham, m4};
use gks_algorithms::path;
use gks_algorithms::rect::IRect;
use gks_geometry::{Du, LongLine, PathBuf, Paths, Pieces, Point, Rect};
use gks_pipeline::device::{Pen, Rule};
use gks_pipeline::look::Cap;
use gks_pipeline::lower::dashed::{dashes, is_solid};
use glam::{DVec2, IVec2};
use std::convert::Infallible;

/// The width in pixels from which lines are drawn as polygons.
pub(super) const WIDE: f64 = 1.5;
/// How far vertices of wide lines that are left out may be from the line drawn, in pixels.
const TOLERANCE: f64 = 0.125;

/// The rule of an area as the algorithms know it.
pub(super) fn rule(rule: Rule) -> path::Rule {
    match rule {
        Rule::EvenOdd => path::Rule::EvenOdd,
        Rule::NonZero => path::Rule::NonZero,
    }
}

/// Finds the pixels of lines and areas; owns the storage for that.
pub(super) struct Aliased {
    edges: EdgeTable,
    stroke: Stroke,
    cut: PathBuf<Du>,
    /// Some of the dashes of a long line.
    dashes: PathBuf<Du>,
}

impl Aliased {
    pub(super) fn new() -> Self {
        Aliased {
            edges: EdgeTable::new(),
            stroke: Stroke::new(),
            cut: PathBuf::new(),
            dashes: PathBuf::new(),
        }
    }

    /// Gives the spans of pixels (row, first column, one past the last one) of lines on a display surface. Spans may
    /// overlap.
    pub(super) fn lines(
        &mut self,
        paths: Paths<'_, Du>,
        pen: &Pen<'_>,
        surface: &Rect<Du>,
        mut span: impl FnMut(i32, i32, i32),
    ) {
        let mut cut = std::mem::take(&mut self.cut);
        let paths = if paths.points.iter().all(|&p| surface.contains(Point::from_vec(p))) {
            paths
        } else {
            cut.clear();
            for path in paths.iter() {
                polyline((surface.min.0, surface.max.0), path, &mut cut.points, &mut cut.ends);
            }
            cut.as_paths()
        };
        let raster = IRect::new(IVec2::ZERO, surface.max.0.as_ivec2());
        if pen.width < WIDE {
            for path in paths.iter() {
                thin(path, pen.cap, raster, |x, y| span(y, x, x + 1));
            }
        } else {
            let Aliased { edges, stroke, .. } = self;
            let mut polygon = |ring: &[DVec2]| {
                edges.spans(ring, &[ring.len() as u32], path::Rule::NonZero, raster, &mut span);
            };
            stroke.begin(pen.width, pen.cap, pen.join);
            for path in paths.iter() {
                m4(path.iter().copied(), TOLERANCE, |p| stroke.to(p, &mut polygon));
                stroke.end(&mut polygon);
            }
        }
        self.cut = cut;
    }

    /// Gives the spans of pixels of a line whose points are not held, as [`Aliased::lines`] does.
    pub(super) fn long_line(
        &mut self,
        line: &LongLine<'_, Du>,
        pen: &Pen<'_>,
        surface: &Rect<Du>,
        mut span: impl FnMut(i32, i32, i32),
    ) {
        let around = surface.grown(pen.width);
        if !pen.dash.is_empty() && !is_solid(line, pen.dash, &around) {
            let (mut held, solid) = (std::mem::take(&mut self.dashes), Pen { dash: &[], ..*pen });
            dashes(line, pen.dash, &around, &mut held, |paths| self.lines(paths, &solid, surface, &mut span));
            self.dashes = held;
            return;
        }
        let is_inside = line.bounds().is_some_and(|bounds| surface.contains_rect(&bounds));
        if !(line.is_whole() && is_inside && pen.width < WIDE && line.len() > 3) {
            let mut paths = PathBuf::new();
            paths.add_pieces(line);
            return self.lines(paths.as_paths(), pen, surface, span);
        }
        let raster = IRect::new(IVec2::ZERO, surface.max.0.as_ivec2());
        let last = line.len() - 1;
        let vertex = |index: usize| line.point(index).unwrap_or_default();
        let cut = pen.cap == Cap::Butt && line.point(0) != line.point(last);
        let end = |at: usize, before: usize| if cut { inset(vertex(at), vertex(before)) } else { vertex(at) };
        let mut thin = Thin::new(raster);
        let mut plot = |x, y| span(y, x, x + 1);
        let done = line.pieces::<Infallible>(|piece| {
            let inner = usize::from(piece.starts)..piece.points.len() - usize::from(piece.ends);
            if piece.starts {
                thin.to(end(0, 1), &mut plot);
            }
            thin.all(piece.points.get(inner).unwrap_or(&[]), &mut plot);
            if piece.ends {
                thin.to(end(last, last - 1), &mut plot);
            }
            Ok(())
        });
        let Ok(()) = done;
        thin.end(&mut plot);
    }

    /// Gives the spans of pixels of an area.
    pub(super) fn area(
        &mut self,
        rings: Paths<'_, Du>,
        rule: path::Rule,
        window: IRect,
        span: impl FnMut(i32, i32, i32),
    ) {
        self.edges.spans(rings.points, rings.ends, rule, window, span);
    }
}

/// Gives the pixels of a line one pixel wide inside of a raster.
fn thin(path: &[DVec2], cap: Cap, raster: IRect, mut plot: impl FnMut(i32, i32)) {
    let last = path.len().saturating_sub(1);
    let cut = cap == Cap::Butt && path.first() != path.last();
    let [start, end] = match path {
        [a, b, .., c, d] if cut => [inset(*a, *b), inset(*d, *c)],
        [a, b, c] if cut => [inset(*a, *b), inset(*c, *b)],
        [a, b] if cut => [inset(*a, *b), inset(*b, *a)],
        [a, .., b] => [*a, *b],
        [a] => [*a, *a],
        [] => return,
    };
    let mut thin = Thin::new(raster);
    thin.to(start, &mut plot);
    thin.all(path.get(1..last).unwrap_or(&[]), &mut plot);
    if last > 0 {
        thin.to(end, &mut plot);
    }
    thin.end(&mut plot);
}

/// A line one pixel wide on its way.
struct Thin {
    /// Within one column of pixels the lowest and the highest vertex make all the difference.
    m4: M4,
    pixels: Pixels,
}

/// The pixels of a line on its way.
struct Pixels {
    raster: IRect,
    last_pixel: DVec2,
    from: Option<IVec2>,
}

impl Pixels {
    fn to(&mut self, p: DVec2, plot: &mut impl FnMut(i32, i32)) {
        // The far edges of the display surface belong to the last pixels.
        let to = p.max(DVec2::ZERO).min(self.last_pixel).as_ivec2();
        if self.from != Some(to) {
            bresenham(self.from.unwrap_or(to), to, self.raster, plot);
        }
        self.from = Some(to);
    }
}

impl Thin {
    fn new(raster: IRect) -> Self {
        let pixels = Pixels { raster, last_pixel: raster.max.as_dvec2() - 1.0, from: None };
        Thin { m4: M4::new(1.0), pixels }
    }

    #[inline]
    fn to(&mut self, p: DVec2, plot: &mut impl FnMut(i32, i32)) {
        let Thin { m4, pixels } = self;
        m4.to(p, &mut |p| pixels.to(p, plot));
    }

    fn all(&mut self, path: &[DVec2], plot: &mut impl FnMut(i32, i32)) {
        let Thin { m4, pixels } = self;
        m4.all(path, &mut |p| pixels.to(p, plot));
    }

    fn end(self, plot: &mut impl FnMut(i32, i32)) {
        let Thin { m4, mut pixels } = self;
        m4.end(&mut |p| pixels.to(p, plot));
    }
}

/// The middle of the last pixel of a line that is cut off at its end: a dash of three pixels shall not take four.
fn inset(end: DVec2, before: DVec2) -> DVec2 {
    let back = before - end;
    let length = back.abs().max_element();
    // A little less than half a pixel, so that the line between the middles of two pixels takes both.
    if length > 0.0 { end + back * (0.499 / length).min(0.5) } else { end }
}
