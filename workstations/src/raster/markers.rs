//! Markers: stamped, and dots put into the picture pixel by pixel.

use super::bitmap::Bitmap;
use super::composite::{Ink, Pixel, pixel};
use super::stamp::{LARGEST, Stamps};
use super::stroke::{GRID_PLACES, Stroke, grid_steps};
use gks_algorithms::coverage::SampleMask;
use gks_algorithms::ellipse::flatten;
use gks_pipeline::device::MarkerStyle;
use gks_pipeline::look::{Cap, Join};
use gks_pipeline::lower::marker::{MarkerShape, shape};
use glam::DVec2;
use std::f64::consts::TAU;

/// A dot up to this width in pixels is one pixel.
const WIDEST_DOT: f64 = 1.5;
/// The most sets of stamps that are kept.
const MOST_SETS: usize = 16;
/// Places of the origin of a marker along one side of a pixel: as many as there are samples.
const PLACES: i32 = 8;
/// Rows of a band.
const BAND: u32 = 32;
/// Markers fewer than this are not sorted.
const FEW: usize = 4096;
/// How many markers are sorted by bands at a time.
const CHUNK: usize = 1 << 17;
/// The largest deviation of the polygon that stands for a circle, in pixels.
const TOLERANCE: f64 = 0.05;

/// Draws markers; owns the stamps of those drawn before.
pub(super) struct Markers {
    mask: SampleMask,
    stroke: Stroke,
    sets: Vec<Set>,
    bands: Bands,
}

/// The order of positions by bands of rows, so that markers that lie near are drawn one after the other.
///
/// Markers at random places of a large picture each wait for its memory; a band stays in the cache.
#[derive(Default)]
struct Bands {
    starts: Vec<u32>,
    order: Vec<u32>,
}

impl Bands {
    /// Sorts positions by counting.
    fn sort(&mut self, positions: &[DVec2], height: u32) -> impl Iterator<Item = DVec2> {
        let last = height / BAND;
        let band = |p: &DVec2| (p.y.max(0.0) as u32 / BAND).min(last) as usize;
        self.starts.clear();
        self.starts.resize(last as usize + 2, 0);
        for p in positions {
            self.starts[band(p) + 1] += 1;
        }
        for i in 1..self.starts.len() {
            self.starts[i] += self.starts[i - 1];
        }
        self.order.resize(positions.len(), 0);
        for (i, p) in (0..).zip(positions) {
            let place = &mut self.starts[band(p)];
            self.order[*place as usize] = i;
            *place += 1;
        }
        self.order.iter().map(|&i| positions[i as usize])
    }
}

/// The stamps of a marker of one type, size and width.
struct Set {
    kind: i32,
    size: f64,
    width: f64,
    shape: Vec<Vec<DVec2>>,
    filled: bool,
    stamps: Stamps<PLACES>,
}

impl Set {
    fn new(style: &MarkerStyle, width: f64) -> Self {
        // Rows count downwards.
        let scale = DVec2::new(style.size, -style.size);
        let scaled = |path: Vec<DVec2>| path.iter().map(|&p| p * scale).collect::<Vec<_>>();
        let circle = || {
            let (r, mut ring) = (style.size * 0.5, Vec::new());
            let (a, b) = (DVec2::new(r, 0.0), DVec2::new(0.0, r));
            flatten(DVec2::ZERO, a, b, 0.0, TAU, TOLERANCE, &mut ring);
            ring
        };
        let (shape, filled) = match shape(style.kind) {
            MarkerShape::Dot => (vec![vec![DVec2::ZERO]], false),
            MarkerShape::Lines(paths) => (paths.into_iter().map(scaled).collect(), false),
            MarkerShape::Circle => (vec![circle()], false),
            MarkerShape::Disc => (vec![circle()], true),
            MarkerShape::Area(ring) => (vec![scaled(ring)], true),
        };
        Set { kind: style.kind, size: style.size, width, shape, filled, stamps: Stamps::new() }
    }
}

impl Markers {
    pub(super) fn new() -> Self {
        Markers { mask: SampleMask::new(), stroke: Stroke::new(), sets: Vec::new(), bands: Bands::default() }
    }

    /// Whether markers of a style are stamped.
    pub(super) fn can(style: &MarkerStyle) -> bool {
        style.size + style.width < LARGEST
    }

    /// Draws the markers of a style at positions.
    pub(super) fn draw(&mut self, bitmap: &mut Bitmap, positions: &[DVec2], style: &MarkerStyle) {
        let (_, height) = bitmap.size();
        let above = pixel(style.paint.colour);
        let width = style.width.max(1.0);
        let strength = (style.width.clamp(0.0, 1.0) * 255.0).round() as u8;
        let strength = if style.width >= 0.5 { 255 } else { strength };
        let ink = Ink::new(above, strength);
        if style.kind == 1 && style.width < WIDEST_DOT {
            return dots(bitmap, positions, &ink);
        }
        let known = |set: &Set| set.kind == style.kind && set.size == style.size && set.width == width;
        let index = self.sets.iter().position(known).unwrap_or_else(|| {
            if self.sets.len() == MOST_SETS {
                self.sets.clear();
            }
            self.sets.push(Set::new(style, width));
            self.sets.len() - 1
        });
        let Markers { mask, stroke, sets, bands } = self;
        let Set { shape, filled, stamps, .. } = &mut sets[index];
        stroke.begin(width, Cap::Round, Join::Round);
        let reach = style.size * 0.5 + width;
        let mut put = |at: DVec2| {
            stamps.put(bitmap, at, &ink, mask, reach, |origin, mut polygon| {
                for path in shape.iter() {
                    if *filled {
                        // All areas are seen whole from their middle.
                        let next = path.iter().cycle().skip(1);
                        path.iter().zip(next).for_each(|(&a, &b)| polygon(&[origin, origin + a, origin + b]));
                    } else {
                        path.iter().for_each(|&p| stroke.to(origin + p, &mut polygon));
                        stroke.end(&mut polygon);
                    }
                }
            });
        };
        let (few, many) = positions.split_at(if positions.len() < FEW { positions.len() } else { 0 });
        few.iter().for_each(|&at| put(at));
        for chunk in many.chunks(CHUNK) {
            bands.sort(chunk, height).for_each(&mut put);
        }
    }
}

/// Puts ink over the pixels that contain points.
fn dots(bitmap: &mut Bitmap, positions: &[DVec2], ink: &Ink) {
    let whole = ink.whole();
    // Apart, so that a pixel is stored as a whole.
    if ink.is_opaque() {
        each_pixel(bitmap, positions, |pixel| *pixel = whole);
    } else {
        each_pixel(bitmap, positions, |pixel| ink.over_samples(pixel, u8::MAX));
    }
}

#[inline(always)]
fn each_pixel(bitmap: &mut Bitmap, positions: &[DVec2], mut put: impl FnMut(&mut Pixel)) {
    let (width, height) = bitmap.size();
    let (last, beyond) =
        ((width - 1, height - 1), (u64::from(width) << GRID_PLACES, u64::from(height) << GRID_PLACES));
    let pixels = bitmap.pixels_mut();
    for at in positions {
        let (x, y) = (grid_steps(at.x), grid_steps(at.y));
        if x <= beyond.0 && y <= beyond.1 {
            // The far edges of the display surface belong to the last pixels.
            let (column, row) =
                (((x >> GRID_PLACES) as u32).min(last.0), ((y >> GRID_PLACES) as u32).min(last.1));
            if let Some(pixel) = pixels.get_mut(row as usize * width as usize + column as usize) {
                put(pixel);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::colour::{Colour, Paint};

    fn style(kind: i32, size: f64, width: f64, alpha: f32) -> MarkerStyle {
        let paint = Paint { colour: Colour { alpha, ..Colour::BLACK }, index: 1 };
        MarkerStyle { kind, size, width, paint }
    }

    fn drawn(markers: &mut Markers, positions: &[DVec2], style: &MarkerStyle) -> Vec<u8> {
        let mut bitmap = Bitmap::new(60, 60);
        bitmap.fill([255; 4]);
        markers.draw(&mut bitmap, positions, style);
        bitmap.pixels().iter().map(|p| p[1]).collect()
    }

    fn ink(pixels: &[u8]) -> f64 {
        pixels.iter().map(|&v| 1.0 - f64::from(v) / 255.0).sum()
    }

    #[test]
    fn a_marker_has_the_same_ink_wherever_it_is() {
        let mut markers = Markers::new();
        for (kind, expected) in
            [(2, 2.0 * 12.0 - 1.0), (4, std::f64::consts::PI * 12.0), (-9, std::f64::consts::PI * 36.0)]
        {
            for place in 0..40 {
                let at = DVec2::new(20.0 + f64::from(place) * 0.37, 30.0 - f64::from(place) * 0.21);
                let found = ink(&drawn(&mut markers, &[at], &style(kind, 12.0, 1.0, 1.0)));
                assert!((found / expected - 1.0).abs() < 0.09, "{kind} {at}: {found} {expected}");
            }
        }
    }

    #[test]
    fn markers_are_cut_at_the_edge_of_the_picture() {
        let mut markers = Markers::new();
        let whole = ink(&drawn(&mut markers, &[DVec2::splat(30.0)], &style(-2, 16.0, 1.0, 1.0)));
        for (at, part) in [((0.0, 30.0), 0.5), ((60.0, 60.0), 0.25), ((30.0, -9.0), 0.0), ((1e300, 3.0), 0.0)]
        {
            let found = ink(&drawn(&mut markers, &[at.into()], &style(-2, 16.0, 1.0, 1.0)));
            assert!((found - whole * part).abs() < 1.0, "{at:?}: {found} of {whole}");
        }
    }

    #[test]
    fn a_dot_is_one_pixel() {
        let mut markers = Markers::new();
        let dots = [(3.9, 4.1), (60.0, 0.0), (60.5, 9.0), (-0.1, 9.0)].map(DVec2::from);
        let pixels = drawn(&mut markers, &dots, &style(1, 1.0, 1.0, 1.0));
        let dark: Vec<usize> = (0..pixels.len()).filter(|&i| pixels[i] < 255).collect();
        assert_eq!(dark, [59, 4 * 60 + 3]);
        assert_eq!(drawn(&mut markers, &dots, &style(1, 1.0, 1.0, 0.5))[59], 127);
    }

    #[test]
    fn many_markers_look_like_few() {
        let position = |i: u32| {
            let i = f64::from(i % 977);
            DVec2::new(i * 7.31 % 60.0, i * 3.17 % 60.0)
        };
        let many: Vec<DVec2> = (0..40_000).map(position).collect();
        let mut markers = Markers::new();
        let style = style(5, 5.0, 1.0, 1.0);
        let sorted = drawn(&mut markers, &many, &style);
        let mut bitmap = Bitmap::new(60, 60);
        bitmap.fill([255; 4]);
        many.chunks(1000).for_each(|few| markers.draw(&mut bitmap, few, &style));
        let apart = sorted.iter().zip(bitmap.pixels()).map(|(v, p)| v.abs_diff(p[1])).max();
        assert!(apart.is_some_and(|apart| apart <= 2), "{apart:?}");
    }
}
