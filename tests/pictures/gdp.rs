//! Generalized drawing primitives.

use gks::{DataRecord, Gks, Result};
use gks_pipeline::generated::numbers::gdp;
use gks_pipeline::look::InteriorStyle;
use std::f64::consts::TAU;

const AREAS: [InteriorStyle; 4] =
    [InteriorStyle::Hollow, InteriorStyle::Solid, InteriorStyle::Pattern, InteriorStyle::Hatch];

fn style(gks: &mut Gks, interior: InteriorStyle, colour: i32) -> Result<()> {
    gks.set_fill_area_interior_style(interior)?;
    gks.set_fill_area_style_index(if interior == InteriorStyle::Hatch { -6 } else { 3 })?;
    gks.set_fill_area_colour_index(colour)
}

/// Circles, arcs, chords and pies, in both directions and more than half way around.
pub fn circles(gks: &mut Gks, _ws: i32) -> Result<()> {
    for i in 0..4 {
        let x = 0.13 + 0.24 * f64::from(i);
        let at = |y: f64, r: f64, t: f64| (x + r * (TAU * t).cos(), y + r * (TAU * t).sin());
        let sweep = [0.2, 0.45, 0.7, -0.9][i as usize];
        gks.set_linewidth_scale_factor(f64::from(i) + 1.0)?;
        gks.set_linetype(i + 1)?;
        gks.arc(at(0.87, 0.09, 0.1), at(0.87, 0.09, 0.1 + sweep / 2.0), at(0.87, 0.09, 0.1 + sweep))?;
        style(gks, InteriorStyle::Solid, i + 1)?;
        gks.chord(at(0.63, 0.09, 0.3), at(0.63, 0.09, 0.3 + sweep / 3.0), at(0.63, 0.09, 0.3 + sweep))?;
        gks.pie(at(0.38, 0.1, 0.6), at(0.38, 0.1, 0.6 + sweep / 2.0), at(0.38, 0.1, 0.6 + sweep))?;
        style(gks, AREAS[i as usize], i + 1)?;
        gks.circle((x, 0.14), (x, 0.14 - 0.02 * f64::from(i) - 0.03))?;
    }
    Ok(())
}

/// Ellipses and their parts, with conjugate half axes that are no axes.
pub fn ellipses(gks: &mut Gks, _ws: i32) -> Result<()> {
    let record = DataRecord::default();
    for (i, id) in
        [gdp::ELLIPSE, gdp::ELLIPTIC_ARC, gdp::ELLIPTIC_CHORD, gdp::ELLIPTIC_PIE].into_iter().enumerate()
    {
        for j in 0..4 {
            let (x, y) = (0.14 + 0.24 * i as f64, 0.86 - 0.24 * j as f64);
            let slant = 0.02 * j as f64;
            let points = [
                (x, y),
                (x + 0.1, y + slant),
                (x - slant, y + 0.05),
                (x + 0.1, y + 0.01 * j as f64),
                (x - 0.05, y - 0.08),
            ];
            style(gks, AREAS[(j + 1) % 4], j as i32 + 1)?;
            gks.set_polyline_colour_index(j as i32 + 1)?;
            gks.set_linewidth_scale_factor(1.0 + 2.0 * j as f64)?;
            let count = if id == gdp::ELLIPSE { 3 } else { 5 };
            gks.generalized_drawing_primitive(&points[..count], id, &record)?;
        }
    }
    Ok(())
}

/// Bezier chains, splines, closed splines; loops and dashes.
pub fn curves(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.bezier(&[(0.05, 0.7), (0.2, 1.1), (0.3, 0.5), (0.45, 0.95), (0.6, 1.4), (0.1, 0.5), (0.45, 0.6)])?;
    gks.set_linetype(2)?;
    gks.set_linewidth_scale_factor(4.0)?;
    gks.bezier(&[(0.55, 0.65), (1.2, 0.95), (0.4, 0.95), (0.95, 0.65)])?;
    gks.set_linetype(1)?;
    gks.set_linewidth_scale_factor(2.0)?;
    let through = [(0.05, 0.35), (0.15, 0.55), (0.25, 0.3), (0.35, 0.5), (0.4, 0.35), (0.48, 0.5)];
    gks.spline(&through, false)?;
    gks.spline(&[(0.55, 0.35), (0.9, 0.55)], false)?;
    for (i, interior) in AREAS.into_iter().enumerate() {
        let x = 0.14 + 0.24 * i as f64;
        let at = |k: i32| (TAU * f64::from(k) / 6.0, 0.05 + 0.05 * f64::from(k % 2));
        let ring: Vec<(f64, f64)> =
            (0..6).map(at).map(|(t, r)| (x + r * t.cos(), 0.13 + r * t.sin())).collect();
        style(gks, interior, i as i32 + 1)?;
        gks.spline(&ring, true)?;
    }
    Ok(())
}

/// All shapes under a transformation that stretches.
pub fn stretched(gks: &mut Gks, ws: i32) -> Result<()> {
    gks.set_viewport(1, (0.0, 1.0, 0.5, 1.0))?;
    gks.select_normalization_transformation(1)?;
    circles(gks, ws)?;
    gks.set_viewport(1, (0.0, 0.4, 0.0, 0.5))?;
    ellipses(gks, ws)?;
    gks.set_viewport(1, (0.45, 1.0, 0.0, 0.45))?;
    curves(gks, ws)
}

/// Shapes that cross the edges of a viewport.
pub fn clipped(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, interior) in AREAS.into_iter().enumerate() {
        let (x, y) = (0.05 + 0.48 * (i % 2) as f64, 0.53 - 0.48 * (i / 2) as f64);
        gks.select_normalization_transformation(0)?;
        gks.polyline(&[(x, y), (x + 0.4, y), (x + 0.4, y + 0.4), (x, y + 0.4), (x, y)])?;
        gks.set_viewport(1, (x, x + 0.4, y, y + 0.4))?;
        gks.set_window(1, (-1.0, 1.0, -1.0, 1.0))?;
        gks.select_normalization_transformation(1)?;
        style(gks, interior, i as i32 + 1)?;
        gks.set_pattern_size(0.2, 0.2)?;
        gks.circle((-0.9, 0.8), (-0.3, 0.8))?;
        gks.ellipse((0.9, -0.2), (1.6, 0.1), (0.8, -0.7))?;
        gks.spline(&[(-0.5, -0.6), (0.0, -1.5), (0.4, -0.5), (0.0, -0.9)], true)?;
        gks.set_linewidth_scale_factor(5.0)?;
        gks.arc((-1.2, -0.9), (0.0, 0.2), (1.2, -0.9))?;
        gks.set_linetype(2)?;
        gks.bezier(&[(-1.5, 0.0), (-0.5, 2.5), (0.5, -1.5), (1.5, 1.3)])?;
        gks.set_linetype(1)?;
        gks.set_linewidth_scale_factor(1.0)?;
    }
    Ok(())
}

/// A large and a tiny circle in every interior style.
pub fn interiors(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_pattern_size(0.08, 0.08)?;
    for (i, interior) in AREAS.into_iter().enumerate() {
        let (x, y) = (0.26 + 0.48 * (i % 2) as f64, 0.75 - 0.48 * (i / 2) as f64);
        style(gks, interior, i as i32 + 1)?;
        gks.circle((x, y), (x + 0.2, y))?;
        gks.circle((x - 0.2, y + 0.19), (x - 0.2 + 0.004, y + 0.19))?;
        gks.circle((x + 0.2, y + 0.19), (x + 0.21, y + 0.2))?;
    }
    Ok(())
}
