//! Markers: stamped, and dots put into the picture pixel by pixel.

use super::bitmap::Bitmap;
use super::composite::{Ink, pixel};
use super::stamp::{LARGEST, Stamps, dot};
use super::stroke::Stroke;
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
/// The largest deviation of the polygon that stands for a circle, in pixels.
const TOLERANCE: f64 = 0.05;

/// Draws markers; owns the stamps of those drawn before.
pub(super) struct Markers {
    mask: SampleMask,
    stroke: Stroke,
    sets: Vec<Set>,
}

/// The stamps of a marker of one type, size and width.
struct Set {
    kind: i32,
    size: f64,
    width: f64,
    shape: Vec<Vec<DVec2>>,
    filled: bool,
    stamps: Stamps,
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
        Markers { mask: SampleMask::new(), stroke: Stroke::new(), sets: Vec::new() }
    }

    /// Whether markers of a style are stamped.
    pub(super) fn can(style: &MarkerStyle) -> bool {
        style.size + style.width < LARGEST
    }

    /// Draws the markers of a style at positions.
    pub(super) fn draw(&mut self, bitmap: &mut Bitmap, positions: &[DVec2], style: &MarkerStyle) {
        let above = pixel(style.paint.colour);
        let width = style.width.max(1.0);
        let strength = (style.width.clamp(0.0, 1.0) * 255.0).round() as u8;
        let strength = if style.width >= 0.5 { 255 } else { strength };
        let ink = Ink::new(above, strength);
        if style.kind == 1 && style.width < WIDEST_DOT {
            positions.iter().for_each(|&at| dot(bitmap, at, &ink, ink.whole()));
            return;
        }
        let known = |set: &Set| set.kind == style.kind && set.size == style.size && set.width == width;
        let index = self.sets.iter().position(known).unwrap_or_else(|| {
            if self.sets.len() == MOST_SETS {
                self.sets.clear();
            }
            self.sets.push(Set::new(style, width));
            self.sets.len() - 1
        });
        let Markers { mask, stroke, sets } = self;
        let Set { shape, filled, stamps, .. } = &mut sets[index];
        stroke.begin(width, Cap::Round, Join::Round);
        let reach = style.size * 0.5 + width;
        for &at in positions {
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
        }
    }
}
