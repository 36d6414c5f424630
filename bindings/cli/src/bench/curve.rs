//! Long polylines: a noisy curve, a smooth one, one with dashes, and one that is mostly outside of the window.

use super::random::Random;
use super::scene::{Data, Figures, Scene, StrokePen};
use gks::Gks;
use gks_pipeline::look::{Cap, Join};
use std::f64::consts::TAU;

/// Five periods of a sine with uniform noise.
pub struct Curve {
    points: Vec<(f64, f64)>,
    /// The part of x that is shown over the whole width.
    window: (f64, f64),
    width: f64,
    dashed: bool,
    antialias: bool,
}

/// The lengths of dashes and gaps of linetype 2 in pixels for a line of this width.
fn dashes(width: f64) -> Vec<f64> {
    let linetype = gks_pipeline::generated::numbers::LINETYPES.iter().find(|l| l.number == 2);
    let unit = (width * 0.5).max(1.0);
    linetype.map_or(Vec::new(), |l| l.dashes.iter().map(|d| d * unit).collect())
}

impl Curve {
    fn new(count: usize, noise: f64, seed: u64) -> Curve {
        let mut random = Random::new(seed);
        let mut at = |i: usize| {
            let t = i as f64 / (count - 1) as f64;
            (t, 0.5 + 0.3 * (5.0 * TAU * t).sin() + noise * 2.0 * (random.unit() - 0.5))
        };
        let mut points = Vec::with_capacity(count);
        points.extend((0..count).map(&mut at));
        Curve { points, window: (0.0, 1.0), width: 1.0, dashed: false, antialias: true }
    }

    /// W1: noise of 50 pixels to both sides.
    pub fn noisy(count: usize) -> Box<dyn Scene> {
        Box::new(Curve::new(count, 0.05, 1))
    }

    /// W1 without antialiasing.
    pub fn aliased(count: usize) -> Box<dyn Scene> {
        Box::new(Curve { antialias: false, ..Curve::new(count, 0.05, 1) })
    }

    /// W1s: noise of half a pixel, so that most segments are shorter than a pixel.
    pub fn smooth(count: usize) -> Box<dyn Scene> {
        Box::new(Curve::new(count, 0.0005, 2))
    }

    /// W7: dashes, three pixels wide.
    pub fn dashed(count: usize) -> Box<dyn Scene> {
        Box::new(Curve { width: 3.0, dashed: true, ..Curve::new(count, 0.02, 3) })
    }

    /// W8: W1 with nine tenths of it outside of the window.
    pub fn clipped(count: usize) -> Box<dyn Scene> {
        Box::new(Curve { window: (0.45, 0.55), ..Curve::new(count, 0.05, 1) })
    }
}

impl Scene for Curve {
    fn draw(&self, gks: &mut Gks) -> gks::Result<()> {
        let (left, right) = self.window;
        gks.set_window(1, (left, right, 0.0, 1.0))?;
        gks.select_normalization_transformation(1)?;
        gks.set_linewidth_scale_factor(self.width)?;
        gks.set_linetype(if self.dashed { 2 } else { 1 })?;
        gks.set_line_cap(Cap::Round)?;
        gks.set_line_join(Join::Round)?;
        gks.polyline(&self.points)
    }

    fn data(&self) -> Data<'_> {
        Data::Parts(&self.points, &[])
    }

    fn figures(&self) -> Option<Figures<'_>> {
        let dashes = if self.dashed { dashes(self.width) } else { Vec::new() };
        let pen = StrokePen { width: self.width, dashes, antialias: self.antialias, window: self.window };
        Some(Box::new(move |canvas| canvas.stroke(&self.points, &pen)))
    }
}
