//! Antialiased lines: the union of their samples, put over the picture once.
//!
//! A line that meets itself is no darker there, translucent ones included, and a million points on a thousand columns
//! cost what can be seen of them: vertices are left out that make no difference before anything is drawn. Large pictures are
//! drawn in bands of rows, by several threads; every pixel is the same wherever a band ends.

use super::bitmap::Bitmap;
use super::composite::{Ink, Pixel, over, pixel};
use super::dense::Dense;
use super::lone::Lone;
use super::stroke::{Stroke, settled};
use gks_algorithms::coverage::{Brush, SampleMask};
use gks_algorithms::line::{M4, Upright, klee, m4};
use gks_algorithms::rect::IRect;
use gks_geometry::{Du, LongLine, PathBuf, Paths, Rect};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::Pen;
use gks_pipeline::look::Join;
use gks_pipeline::lower::dashed::{dashes, is_solid};
use glam::{DVec2, IVec2};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::convert::Infallible;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

/// How far vertices that are left out may be from the line drawn, in pixels: the distance of samples.
const TOLERANCE: f64 = 0.125;
/// Vertices are left out of paths that have more points than this for each column of pixels: four for each column that
/// samples are in. Paths of fewer points would hardly become shorter, and keep their corners as they are.
const DENSE: usize = 32;
/// The largest radius of a brush, in pixels: it has a table of all distances.
const WIDEST_BRUSH: f64 = 64.0;
/// The bounds of paths of no more points than this are looked for.
const SHORT: usize = 4096;
/// The most pixels for which samples are kept at a time: 16 MiB of them.
const BAND: usize = 1 << 21;
/// The most threads that draw one line: each of them follows it as often as one would alone.
const THREADS: usize = 8;

/// The number of a process and the threads of all its devices, if there can be any.
///
/// No one else's: a program that waits for a device in all threads of its own pool would wait for ever if the device waited
/// for one of them.
static POOL: Mutex<Option<(u32, Option<Arc<ThreadPool>>)>> = Mutex::new(None);

/// The threads of all devices of this process, or none where there can be none.
fn common_pool() -> Option<Arc<ThreadPool>> {
    let mut common = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    if let Some((owner, pool)) = &*common
        && *owner == process
    {
        return pool.clone();
    }
    let build = || ThreadPoolBuilder::new().thread_name(|i| format!("raster {i}")).build();
    let pool = build().map(Arc::new).ok();
    // The threads of a process that has forked are not in its child, which would wait for them when it gives up their pool.
    std::mem::forget(common.replace((process, pool.clone())));
    pool
}

/// How a line is drawn: as wide as a pixel at least, and fainter if it is meant to be thinner than half of that, so that it
/// looks alike at any place.
#[derive(Copy, Clone)]
struct Visible {
    /// What the pen has.
    asked: (Colour, f64),
    width: f64,
    ink: Ink,
}

impl Visible {
    fn new(colour: Colour, asked: f64) -> Self {
        let width = if (0.5..1.0).contains(&asked) { 1.0 } else { asked.max(0.0) };
        let width = settled(DVec2::splat(width)).x;
        let strength = if width > 0.0 { (width.min(1.0) * 255.0).round() as u8 } else { 255 };
        Visible { asked: (colour, asked), width: width.max(1.0), ink: Ink::new(pixel(colour), strength) }
    }
}

/// Draws antialiased lines; owns the storage for that.
pub(super) struct Lines {
    lone: Lone,
    /// How the last line was drawn: the next one mostly looks the same.
    visible: Visible,
    nib: Nib,
    /// Those of further threads.
    nibs: Vec<Nib>,
    /// The threads, if they are not those of all devices.
    pool: Option<Arc<ThreadPool>>,
}

/// What one thread draws with.
struct Nib {
    mask: SampleMask,
    stroke: Stroke,
    /// What dense paths are drawn with if the pen is round.
    brush: Option<Brush>,
    /// Short upright paths, of which many lie one upon the other.
    uprights: Vec<Upright>,
    /// Some of the dashes of a long line.
    dashes: PathBuf<Du>,
}

impl Lines {
    pub(super) fn new() -> Self {
        let visible = Visible::new(Colour::BLACK, 1.0);
        Lines { lone: Lone::new(), visible, nib: Nib::new(), nibs: Vec::new(), pool: None }
    }

    /// The width and the ink of a line.
    fn visible(&mut self, pen: &Pen<'_>) -> (f64, Ink) {
        if self.visible.asked != (pen.paint.colour, pen.width) {
            self.visible = Visible::new(pen.paint.colour, pen.width);
        }
        (self.visible.width, self.visible.ink)
    }

    /// Draws paths with a pen.
    pub(super) fn draw(&mut self, bitmap: &mut Bitmap, paths: &Paths<'_, Du>, pen: &Pen<'_>) {
        let (width, ink) = self.visible(pen);
        let (columns, rows) = bitmap.size();
        let raster = IRect::of_size(columns as i32, rows as i32);
        if let (&[a, b], &[_]) = (paths.points, paths.ends)
            && self.lone.draw(bitmap, (settled(a), settled(b)), width, pen.cap, &ink)
        {
            return;
        }
        self.nib.stroke.begin(width, pen.cap, pen.join);
        let window = self.window(*paths, raster);
        self.fill(bitmap, window, &ink, |nib, rows| {
            nib.stroke.begin(width, pen.cap, pen.join);
            nib.stroke.keep_to(rows);
            nib.follow(*paths, columns, paths.points.len());
        });
    }

    /// Draws a line with a pen, without holding its points.
    pub(super) fn draw_long(&mut self, bitmap: &mut Bitmap, line: &LongLine<'_, Du>, pen: &Pen<'_>) {
        let (width, ink) = self.visible(pen);
        let (columns, rows) = bitmap.size();
        self.nib.stroke.begin(width, pen.cap, pen.join);
        let reach = self.nib.stroke.reach() + 1.0;
        let near = |rows: Range<f64>| Rect::new(0.0, columns.into(), rows.start, rows.end).grown(reach);
        let (raster, all) = (IRect::of_size(columns as i32, rows as i32), near(0.0..rows.into()));
        let pattern = Some(pen.dash).filter(|dash| !dash.is_empty() && !is_solid(line, dash, &all));
        if pattern.is_none() && (!line.is_whole() || line.len() <= SHORT) {
            let mut paths = PathBuf::new();
            paths.add_pieces(line);
            return self.draw(bitmap, &paths.as_paths(), pen);
        }
        let is_dense = pattern.is_none() && line.len_near(&all) > DENSE * columns as usize;
        self.fill(bitmap, raster, &ink, |nib, rows| {
            nib.stroke.begin(width, pen.cap, pen.join);
            nib.stroke.keep_to(rows);
            match pattern {
                // Not only those near these rows: a part of a dash does not always look like a part of the whole one.
                Some(pattern) => nib.follow_dashes(line, pattern, &all, columns),
                None => nib.follow_long(line, is_dense, &near(rows.start as f64..rows.end as f64)),
            }
        });
    }

    /// Puts ink over the samples that `follow` adds in some rows. Threads share the storage that one would have.
    fn fill(
        &mut self,
        bitmap: &mut Bitmap,
        window: IRect,
        ink: &Ink,
        follow: impl Fn(&mut Nib, &Range<usize>) + Sync,
    ) {
        if window.is_empty() {
            return;
        }
        let columns = window.min.x.abs_diff(window.max.x) as usize;
        let rows = window.min.y as usize..window.max.y as usize;
        let pool = if columns * rows.len() > BAND { self.pool() } else { None };
        let threads = pool.as_ref().map_or(1, |pool| pool.current_num_threads().min(THREADS));
        let height = (BAND / threads / columns).max(1);
        let bands = Mutex::new(bitmap.bands(rows, height));
        let next = || bands.lock().unwrap_or_else(PoisonError::into_inner).next();
        let corner = |x: i32, row: usize| IVec2::new(x, row as i32);
        let draw = |nib: &mut Nib| {
            while let Some(mut band) = next() {
                let rows = band.rows();
                nib.mask.begin(IRect::new(corner(window.min.x, rows.start), corner(window.max.x, rows.end)));
                follow(nib, &rows);
                nib.mask.drain(|row, column, words| {
                    let columns = column as usize..column as usize + words.len();
                    ink.over_all(band.span(row as usize, columns), words);
                });
            }
        };
        let Some(pool) = pool.filter(|_| threads > 1) else { return draw(&mut self.nib) };
        if self.nibs.len() < threads - 1 {
            self.nibs.resize_with(threads - 1, Nib::new);
        }
        let draw = &draw;
        pool.in_place_scope(|scope| {
            for nib in &mut self.nibs[..threads - 1] {
                scope.spawn(move |_| draw(nib));
            }
            draw(&mut self.nib);
        });
    }

    /// The threads that draw, or none where the caller should be alone: a thread of a program's own pool would take up other
    /// work of the program while it waits, and perhaps come back here.
    fn pool(&self) -> Option<Arc<ThreadPool>> {
        if rayon::current_thread_index().is_some() {
            return None;
        }
        self.pool.clone().or_else(common_pool)
    }

    /// A place for pixels that are to be drawn once, however often they are named.
    pub(super) fn once(&mut self, raster: IRect) -> Once<'_> {
        self.nib.mask.begin(raster);
        Once(&mut self.nib.mask)
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
        let bounds = bounds.grown(self.nib.stroke.reach() + 1.0);
        let inside = |p: DVec2| p.max(raster.min.as_dvec2()).min(raster.max.as_dvec2()).as_ivec2();
        IRect::new(inside(bounds.min.0), inside(bounds.max.0 + 1.0))
    }
}

impl Nib {
    fn new() -> Self {
        Nib {
            mask: SampleMask::new(),
            stroke: Stroke::new(),
            brush: None,
            uprights: Vec::new(),
            dashes: PathBuf::new(),
        }
    }

    /// The brush that does what the pen does on a dense path, if there is one.
    fn prepare_brush(&mut self) -> bool {
        let radius = self.stroke.radius().filter(|&radius| radius <= WIDEST_BRUSH);
        let known = |brush: &Brush| Some(brush.radius()) == radius;
        self.brush = self.brush.take().filter(known).or_else(|| radius.map(Brush::new));
        self.brush.is_some()
    }

    /// Adds the samples of paths on a raster of so many columns. They may be some of paths that have more `points` together.
    fn follow(&mut self, paths: Paths<'_, Du>, columns: u32, points: usize) {
        let dense = DENSE * columns as usize;
        let is_brush = paths.points.len() > dense && self.prepare_brush();
        let Nib { mask, stroke, brush, uprights, .. } = self;
        if let Some(brush) = brush.as_ref().filter(|_| is_brush) {
            for path in paths.iter().filter(|path| path.len() > dense) {
                let mut line = Dense::new(mask, brush);
                line.follow(path);
                line.end();
            }
        }
        let mut polygon = |ring: &[DVec2]| mask.polygon(ring);
        let are_dense = points > dense;
        uprights.clear();
        for path in paths.iter().filter(|path| !is_brush || path.len() <= dense) {
            if let Some(upright) = are_dense.then(|| upright(path, stroke)).flatten() {
                uprights.push(upright);
            } else if path.len() > dense {
                let join = stroke.replace_join(without_needles);
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
        klee(uprights, |line| {
            let x = (line.column as f64 + 0.5) * TOLERANCE;
            stroke.to(DVec2::new(x, line.low), &mut polygon);
            stroke.to(DVec2::new(x, line.high), &mut polygon);
            stroke.end(&mut polygon);
        });
    }

    /// Adds the samples of the dashes of a line, as far as they are near a rectangle, on a raster of so many columns.
    fn follow_dashes(&mut self, line: &LongLine<'_, Du>, pattern: &[f64], near: &Rect<Du>, columns: u32) {
        let mut held = std::mem::take(&mut self.dashes);
        dashes(line, pattern, near, &mut held, |paths| self.follow(paths, columns, line.len()));
        self.dashes = held;
    }

    /// Adds the samples of a line that is one path, as far as they are near a rectangle.
    fn follow_long(&mut self, line: &LongLine<'_, Du>, is_dense: bool, near: &Rect<Du>) {
        if is_dense && self.prepare_brush() {
            let Nib { mask, brush: Some(brush), .. } = self else { return };
            let mut dense = Dense::new(mask, brush);
            let done = line.pieces_near::<Infallible>(near, |piece| {
                dense.follow(piece.points);
                Ok(())
            });
            let Ok(()) = done;
            return dense.end();
        }
        let Nib { mask, stroke, .. } = self;
        let mut polygon = |ring: &[DVec2]| mask.polygon(ring);
        let join = stroke.replace_join(|join| if is_dense { without_needles(join) } else { join });
        let mut m4 = M4::new(TOLERANCE);
        let done = line.pieces_near::<Infallible>(near, |piece| {
            if is_dense {
                m4.all(piece.points, &mut |p| stroke.to(p, &mut polygon));
            } else {
                piece.points.iter().for_each(|&p| stroke.to(p, &mut polygon));
            }
            Ok(())
        });
        let Ok(()) = done;
        if is_dense {
            m4.end(&mut |p| stroke.to(p, &mut polygon));
        }
        stroke.end(&mut polygon);
        stroke.replace_join(|_| join);
    }
}

/// The upright line that stands for a path no wider than the column that samples are in, if its corners look like its ends.
fn upright(path: &[DVec2], stroke: &Stroke) -> Option<Upright> {
    if !stroke.has_ends_like_corners() {
        return None;
    }
    let (mut low, mut high) = (*path.first()?, *path.first()?);
    for &p in path {
        (low, high) = (low.min(p), high.max(p));
    }
    let side = high - low;
    let is_upright = side.x <= TOLERANCE && side.y >= 4.0 * side.x && side.y > 0.0;
    let x = (low.x + high.x) * (0.5 / TOLERANCE);
    let column = x.floor() as i64;
    (is_upright && path.iter().all(|p| p.is_finite())).then_some(Upright { column, low: low.y, high: high.y })
}

/// How corners of a line are joined from which vertices are left out: of the needles that miters make of one that goes to and
/// fro most would be left out.
fn without_needles(join: Join) -> Join {
    if join == Join::Miter { Join::Bevel } else { join }
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

#[cfg(test)]
mod tests;
