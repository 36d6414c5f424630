//! Fill areas: many small ones, a large one, and interior styles that are dearer than SOLID.

use super::random::Random;
use super::scene::{Data, Figures, Scene};
use gks::Gks;
use gks_pipeline::look::InteriorStyle;
use std::f64::consts::TAU;

/// Polygons in the colours 1 to 8.
pub struct Areas {
    /// The points of all polygons.
    points: Vec<(f64, f64)>,
    /// The end of each polygon in the points.
    ends: Vec<usize>,
    interior: InteriorStyle,
    style: i32,
}

impl Areas {
    fn stars(count: usize) -> Areas {
        let mut random = Random::new(6);
        let (mut points, mut ends) = (Vec::with_capacity(count * 50), Vec::with_capacity(count));
        for _ in 0..count {
            let corners = 8 + random.below(43);
            let (x, y) = (random.unit(), random.unit());
            let radius = 0.005 + 0.03 * random.unit();
            points.extend((0..corners).map(|i| {
                let (turn, r) = (TAU * i as f64 / corners as f64, radius * (0.5 + 0.5 * random.unit()));
                (x + r * turn.cos(), y + r * turn.sin())
            }));
            ends.push(points.len());
        }
        points.shrink_to_fit();
        Areas { points, ends, interior: InteriorStyle::Solid, style: 1 }
    }

    /// W4a: stars of 8 to 50 corners with radii of 5 to 35 pixels.
    pub fn many(count: usize) -> Box<dyn Scene> {
        Box::new(Areas::stars(count))
    }

    /// W4b: one area with a ragged boundary of many corners.
    pub fn large(count: usize) -> Box<dyn Scene> {
        let mut random = Random::new(7);
        let waves: Vec<(f64, f64, f64)> = (0..24)
            .map(|k| {
                let (phase, size) = (TAU * random.unit(), (random.unit() - 0.5) * 2.0);
                (1.6_f64.powi(k).floor() + 1.0, size / 1.45_f64.powi(k), phase)
            })
            .collect();
        let mut at = |i: usize| {
            let turn = TAU * i as f64 / count as f64;
            let wave = |&(times, size, phase): &(f64, f64, f64)| 0.05 * size * (times * turn + phase).sin();
            let r = 0.33 + waves.iter().map(wave).sum::<f64>() + 0.002 * (random.unit() - 0.5);
            (0.5 + r * turn.cos(), 0.5 + r * turn.sin())
        };
        let mut points = Vec::with_capacity(count);
        points.extend((0..count).map(&mut at));
        Box::new(Areas { points, ends: vec![count], interior: InteriorStyle::Solid, style: 1 })
    }

    /// Stars with a pattern.
    pub fn patterned(count: usize) -> Box<dyn Scene> {
        Box::new(Areas { interior: InteriorStyle::Pattern, ..Areas::stars(count) })
    }

    /// Stars with a hatch of two directions.
    pub fn hatched(count: usize) -> Box<dyn Scene> {
        Box::new(Areas { interior: InteriorStyle::Hatch, style: -5, ..Areas::stars(count) })
    }

    /// The polygons, with their colours.
    fn polygons(&self) -> impl Iterator<Item = (&[(f64, f64)], i32)> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let parts = starts.zip(&self.ends).enumerate();
        parts.map(|(i, (start, &end))| (&self.points[start..end], 1 + i as i32 % 8))
    }
}

impl Scene for Areas {
    fn draw(&self, gks: &mut Gks) -> gks::Result<()> {
        gks.set_fill_area_interior_style(self.interior)?;
        gks.set_fill_area_style_index(self.style)?;
        if self.interior == InteriorStyle::Pattern {
            gks.set_pattern_size(0.02, 0.02)?;
        }
        self.polygons().try_for_each(|(polygon, colour)| {
            gks.set_fill_area_colour_index(colour)?;
            gks.fill_area(polygon)
        })
    }

    fn data(&self) -> Data<'_> {
        Data::Parts(&self.points, &self.ends)
    }

    fn figures(&self) -> Option<Figures<'_>> {
        if self.interior != InteriorStyle::Solid {
            return None;
        }
        Some(Box::new(|canvas| self.polygons().for_each(|(polygon, colour)| canvas.fill(polygon, colour))))
    }
}
