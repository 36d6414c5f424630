//! Antialiased lines: the union of their samples, put over the picture once.
//!
//! A line that meets itself is no darker there, translucent ones included, and a million points on a thousand columns
//! cost what can be seen of them: vertices are left out that make no difference before anything is drawn.

use super::bitmap::Bitmap;
use super::composite::{Ink, Pixel, over, pixel};
use super::lone::Lone;
use super::stroke::{Stroke, settled};
use gks_algorithms::coverage::SampleMask;
use gks_algorithms::line::{M4, Upright, klee, m4};
use gks_algorithms::rect::IRect;
use gks_geometry::{Du, LongLine, PathBuf, Paths, Pieces};
use gks_pipeline::device::Pen;
use gks_pipeline::look::Join;
use glam::{DVec2, IVec2};
use std::convert::Infallible;

/// How far vertices that are left out may be from the line drawn, in pixels: the distance of samples.
const TOLERANCE: f64 = 0.125;
/// Vertices are left out of paths that have more points than this for each column of pixels: four for each column that
/// samples are in. Paths of fewer points would hardly become shorter, and keep their corners as they are.
const DENSE: usize = 32;
/// The bounds of paths of no more points than this are looked for.
const SHORT: usize = 4096;
/// The most pixels for which samples are kept at a time: 16 MiB of them.
const BAND: usize = 1 << 21;

/// The width and the ink that a line is drawn with: as wide as a pixel at least, and fainter if it is meant to be thinner
/// than half of that, so that it looks alike at any place.
fn visible(pen: &Pen<'_>) -> (f64, Ink) {
    let width = if (0.5..1.0).contains(&pen.width) { 1.0 } else { pen.width.max(0.0) };
    let width = settled(DVec2::splat(width)).x;
    let strength = if width > 0.0 { (width.min(1.0) * 255.0).round() as u8 } else { 255 };
    (width.max(1.0), Ink::new(pixel(pen.paint.colour), strength))
}

/// Draws antialiased lines; owns the storage for that.
pub(super) struct Lines {
    mask: SampleMask,
    stroke: Stroke,
    lone: Lone,
    /// Short upright paths, of which many lie one upon the other.
    uprights: Vec<Upright>,
}

impl Lines {
    pub(super) fn new() -> Self {
        Lines { mask: SampleMask::new(), stroke: Stroke::new(), lone: Lone::new(), uprights: Vec::new() }
    }

    /// Draws paths with a pen.
    pub(super) fn draw(&mut self, bitmap: &mut Bitmap, paths: Paths<'_, Du>, pen: &Pen<'_>) {
        let (width, ink) = visible(pen);
        let (columns, rows) = bitmap.size();
        let raster = IRect::of_size(columns as i32, rows as i32);
        if let (&[a, b], &[_]) = (paths.points, paths.ends)
            && self.lone.draw(bitmap, (settled(a), settled(b)), width, pen.cap, &ink)
        {
            return;
        }
        self.stroke.begin(width, pen.cap, pen.join);
        let window = self.window(paths, raster);
        self.fill(bitmap, window, &ink, |lines| lines.follow(paths, columns));
    }

    /// Draws a line with a pen, without holding its points.
    pub(super) fn draw_long(&mut self, bitmap: &mut Bitmap, line: &LongLine<'_, Du>, pen: &Pen<'_>) {
        if !line.is_whole() || line.len() <= SHORT {
            let mut paths = PathBuf::new();
            paths.add_pieces(line);
            return self.draw(bitmap, paths.as_paths(), pen);
        }
        let (width, ink) = visible(pen);
        let (columns, rows) = bitmap.size();
        self.stroke.begin(width, pen.cap, pen.join);
        self.fill(bitmap, IRect::of_size(columns as i32, rows as i32), &ink, |lines| {
            lines.follow_long(line, columns);
        });
    }

    /// Puts ink over the samples that `follow` adds.
    fn fill(&mut self, bitmap: &mut Bitmap, window: IRect, ink: &Ink, mut follow: impl FnMut(&mut Self)) {
        if window.is_empty() {
            return;
        }
        let side = window.max - window.min;
        let band = (BAND / side.x as usize).max(1) as i32;
        for top in (window.min.y..window.max.y).step_by(band as usize) {
            let bottom = window.max.y.min(top.saturating_add(band));
            self.mask.begin(IRect::new(IVec2::new(window.min.x, top), IVec2::new(window.max.x, bottom)));
            follow(self);
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

    /// Adds the samples of paths on a raster of so many columns.
    fn follow(&mut self, paths: Paths<'_, Du>, columns: u32) {
        let dense = DENSE * columns as usize;
        let Lines { mask, stroke, uprights, .. } = self;
        let mut polygon = |ring: &[DVec2]| mask.polygon(ring);
        let are_dense = paths.points.len() > dense;
        uprights.clear();
        for path in paths.iter() {
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

    /// Adds the samples of a line that is one path.
    fn follow_long(&mut self, line: &LongLine<'_, Du>, columns: u32) {
        let is_dense = line.len() > DENSE * columns as usize;
        let Lines { mask, stroke, .. } = self;
        let mut polygon = |ring: &[DVec2]| mask.polygon(ring);
        let join = stroke.replace_join(|join| if is_dense { without_needles(join) } else { join });
        let mut m4 = M4::new(TOLERANCE);
        let done = line.pieces::<Infallible>(|piece| {
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
mod tests {
    use super::*;
    use gks_pipeline::colour::{Colour, Paint};
    use gks_pipeline::look::Cap;

    const BLACK: Paint = Paint { colour: Colour::BLACK, index: 1 };

    fn drawn(path: &[DVec2], paint: Paint, width: f64, cap: Cap, join: Join) -> Vec<f64> {
        let mut bitmap = Bitmap::new(100, 100);
        bitmap.fill([255; 4]);
        let pen = Pen { paint, width, dash: &[], cap, join };
        Lines::new().draw(&mut bitmap, Paths::new(path, &[path.len() as u32]), &pen);
        bitmap.pixels().iter().map(|p| 1.0 - f64::from(p[1]) / 255.0).collect()
    }

    fn ink(path: &[DVec2], width: f64, cap: Cap) -> f64 {
        drawn(path, BLACK, width, cap, Join::Miter).iter().sum()
    }

    #[test]
    fn a_line_keeps_its_weight_where_it_slants() {
        let middle = DVec2::splat(50.3);
        for degrees in 0..180 {
            let reach = DVec2::from_angle(f64::from(degrees).to_radians()) * 30.0;
            let (a, b) = (middle - reach, middle + reach);
            for (path, width, cap) in [
                (vec![a, b], 1.0, Cap::Butt),
                (vec![a, middle, b], 1.0, Cap::Butt),
                (vec![a, b], 1.7, Cap::Projecting),
                (vec![a, b], 3.0, Cap::Butt),
            ] {
                let longer = if cap == Cap::Projecting { width } else { 0.0 };
                let expected = (60.0 + longer) * width;
                let found = ink(&path, width, cap);
                assert!((found / expected - 1.0).abs() < 0.04, "{degrees} {width}: {found} {expected}");
            }
        }
    }

    #[test]
    fn a_lone_segment_looks_like_one_of_many() {
        for end in [(80.2, 31.7), (40.9, 88.8), (20.3, 60.1), (71.4, 20.2), (23.1, 22.9), (13.3, 14.2)] {
            for (cap, width) in
                [(Cap::Butt, 1.0), (Cap::Round, 1.0), (Cap::Projecting, 1.0), (Cap::Round, 1.9)]
            {
                let (a, b) = (DVec2::new(20.3, 20.8), DVec2::from(end));
                let lone = drawn(&[a, b], BLACK, width, cap, Join::Bevel);
                let many = drawn(&[a, a.lerp(b, 0.4), b], BLACK, width, cap, Join::Bevel);
                let far = lone.iter().zip(&many).map(|(p, q)| (p - q).abs()).fold(0.0, f64::max);
                assert!(far < 0.15, "{b} {cap:?} {width}: {far}");
            }
        }
    }

    #[test]
    fn a_dense_curve_is_as_dark_as_its_outline_and_no_darker() {
        // To and fro in a band of 5 by 50 pixels, in steps far smaller than a pixel.
        let band: Vec<DVec2> = (0..60_000u32)
            .map(|i| {
                let y = 40.0 + f64::from(i * 7919 % 1009) / 1009.0 * 5.0;
                DVec2::new(20.0 + 50.0 * f64::from(i) / 60_000.0, y)
            })
            .collect();
        let found = ink(&band, 1.0, Cap::Butt);
        assert!((found - 51.0 * 5.0).abs() < 6.0, "{found}");
    }

    #[test]
    fn many_upright_dashes_look_like_each_of_them() {
        for (cap, join) in [(Cap::Round, Join::Round), (Cap::Butt, Join::Miter)] {
            let dashes: Vec<[DVec2; 2]> = (0..2000u32)
                .map(|i| {
                    let i = f64::from(i);
                    let at = DVec2::new(10.0 + i * 0.03, 20.0 + 60.0 * (i * 0.37).sin().abs());
                    [at, at + DVec2::new(0.02, 5.0)]
                })
                .collect();
            let pen = Pen { paint: BLACK, width: 3.0, dash: &[], cap, join };
            let ends: Vec<u32> = (1..=2000).map(|i| 2 * i).collect();
            let mut pictures = [100, 6400].map(|columns| {
                let mut bitmap = Bitmap::new(columns, 100);
                bitmap.fill([255; 4]);
                Lines::new().draw(&mut bitmap, Paths::new(dashes.as_flattened(), &ends), &pen);
                let rows = bitmap.pixels().chunks(columns as usize).flat_map(|row| &row[..100]);
                rows.map(|p| f64::from(p[1])).collect::<Vec<_>>()
            });
            let [reduced, all] = &mut pictures;
            assert!(reduced != all, "the path of 4000 points should be dense on 100 columns");
            let error: f64 = reduced.iter().zip(all.iter()).map(|(a, b)| (a - b).powi(2)).sum();
            let psnr = 10.0 * (255.0 * 255.0 * reduced.len() as f64 / error).log10();
            assert!(psnr > 34.0, "{cap:?} {psnr}");
        }
    }

    #[test]
    fn faint_and_translucent_lines_have_one_opacity() {
        let half = Paint { colour: Colour { alpha: 0.5, ..Colour::BLACK }, index: 2 };
        let zigzag: Vec<DVec2> =
            [(20.0, 20.0), (70.0, 80.0), (70.0, 20.0), (20.0, 80.0), (20.0, 20.0)].map(DVec2::from).to_vec();
        for (paint, width, darkest) in [(half, 5.0, 0.5), (BLACK, 0.3, 0.3), (half, 0.4, 0.2)] {
            let pixels = drawn(&zigzag, paint, width, Cap::Round, Join::Round);
            let most = pixels.iter().copied().fold(0.0, f64::max);
            assert!(most < darkest + 0.01 && most > darkest * 0.85, "{most} {darkest}");
        }
    }
}
