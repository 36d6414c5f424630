//! Fill areas.

use gks::{Gks, Result};
use gks_pipeline::generated::numbers::{HATCHES, PATTERNS};
use gks_pipeline::look::InteriorStyle;
use std::f64::consts::{PI, TAU};

const STYLES: [InteriorStyle; 4] =
    [InteriorStyle::Hollow, InteriorStyle::Solid, InteriorStyle::Pattern, InteriorStyle::Hatch];

/// A star with `n` points whose inner radius is `inner` times the outer one.
fn star(x: f64, y: f64, r: f64, n: u32, inner: f64) -> Vec<(f64, f64)> {
    let radius = |i: u32| if i.is_multiple_of(2) { r } else { r * inner };
    let at = |i: u32| (radius(i), PI / 2.0 + PI * f64::from(i) / f64::from(n));
    (0..2 * n).map(at).map(|(r, t)| (x + r * t.cos(), y + r * t.sin())).collect()
}

/// The polygon through every second corner of a regular one.
fn pentagram(x: f64, y: f64, r: f64) -> Vec<(f64, f64)> {
    let at = |i: i32| PI / 2.0 + TAU * f64::from(2 * i) / 5.0;
    (0..5).map(|i| (x + r * at(i).cos(), y + r * at(i).sin())).collect()
}

fn style_index(style: InteriorStyle) -> i32 {
    if style == InteriorStyle::Hatch { -5 } else { 1 }
}

/// The four interior styles in several colours and shapes.
pub fn interiors(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_pattern_size(0.05, 0.05)?;
    for (i, style) in STYLES.into_iter().enumerate() {
        gks.set_fill_area_interior_style(style)?;
        gks.set_fill_area_style_index(style_index(style))?;
        let y = 0.87 - 0.245 * i as f64;
        for j in 0..4 {
            let x = 0.14 + 0.24 * f64::from(j);
            gks.set_fill_area_colour_index(j + 1)?;
            gks.fill_area(&star(x, y, 0.11, 3 + j as u32, 1.0 - 0.15 * f64::from(j)))?;
        }
    }
    Ok(())
}

/// Every predefined pattern.
pub fn patterns(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_pattern_size(0.04, 0.04)?;
    gks.set_fill_area_interior_style(InteriorStyle::Pattern)?;
    for i in 0..PATTERNS.len() {
        let (x, y) = (0.04 + 0.24 * (i % 4) as f64, 0.7 - 0.32 * (i / 4) as f64);
        gks.set_fill_area_style_index(i as i32 + 1)?;
        gks.fill_area(&[(x, y), (x + 0.2, y), (x + 0.2, y + 0.2), (x + 0.1, y + 0.28), (x, y + 0.2)])?;
    }
    Ok(())
}

/// A pattern of one's own: placed, large, small, stretched, mirrored by the order of its cells.
pub fn placed_patterns(gks: &mut Gks, ws: i32) -> Result<()> {
    gks.set_pattern_representation_of(ws, 20, &[2, 3, 4, 15, 0, 6], 3, 2, 3)?;
    gks.set_fill_area_interior_style(InteriorStyle::Pattern)?;
    gks.set_fill_area_style_index(20)?;
    for (i, (width, height)) in [(0.12, 0.08), (0.03, 0.02), (0.3, 0.04), (0.51, 0.7)].into_iter().enumerate()
    {
        let (x, y) = (0.05 + 0.47 * (i % 2) as f64, 0.53 - 0.47 * (i / 2) as f64);
        gks.set_pattern_size(width, height)?;
        gks.set_pattern_reference_point((x + 0.013, y + 0.021))?;
        gks.fill_area(&star(x + 0.21, y + 0.2, 0.2, 6, 0.7))?;
    }
    Ok(())
}

/// Every hatch style, and neighbours whose hatches must meet.
pub fn hatches(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_fill_area_interior_style(InteriorStyle::Hatch)?;
    for (i, hatch) in HATCHES.iter().enumerate() {
        let (x, y) = (0.03 + 0.19 * (i % 5) as f64, 0.82 - 0.19 * (i / 5) as f64);
        gks.set_fill_area_style_index(hatch.number)?;
        gks.set_fill_area_colour_index(1 + i as i32 % 3)?;
        gks.fill_area(&[(x, y), (x + 0.16, y), (x + 0.16, y + 0.1), (x + 0.08, y + 0.16), (x, y + 0.1)])?;
    }
    gks.set_fill_area_style_index(-3)?;
    gks.fill_area(&[(0.4, 0.03), (0.6, 0.03), (0.6, 0.2), (0.4, 0.2)])?;
    gks.fill_area(&[(0.6, 0.03), (0.9, 0.03), (0.9, 0.2), (0.6, 0.2)])
}

/// Areas whose edges cross: the even-odd rule.
pub fn crossing_edges(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_pattern_size(0.04, 0.04)?;
    for (i, style) in STYLES.into_iter().enumerate() {
        let (x, y) = (0.26 + 0.48 * (i % 2) as f64, 0.75 - 0.48 * (i / 2) as f64);
        gks.set_fill_area_interior_style(style)?;
        gks.set_fill_area_style_index(style_index(style))?;
        gks.set_fill_area_colour_index(i as i32 + 1)?;
        gks.fill_area(&pentagram(x, y, 0.18))?;
        let (l, r, b) = (x - 0.2, x + 0.2, y - 0.2);
        gks.fill_area(&[(l, b), (r, b - 0.03), (r, b), (l, b - 0.03)])?;
    }
    Ok(())
}

/// Areas of all interior styles that cross the edges of a viewport, lie around it, and outside of it.
pub fn clipped(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, style) in STYLES.into_iter().enumerate() {
        let (x, y) = (0.05 + 0.48 * (i % 2) as f64, 0.53 - 0.48 * (i / 2) as f64);
        gks.select_normalization_transformation(0)?;
        gks.polyline(&[(x, y), (x + 0.4, y), (x + 0.4, y + 0.4), (x, y + 0.4), (x, y)])?;
        gks.set_viewport(1, (x, x + 0.4, y, y + 0.4))?;
        gks.set_window(1, (-1.0, 1.0, -1.0, 1.0))?;
        gks.select_normalization_transformation(1)?;
        gks.set_pattern_size(0.2, 0.2)?;
        gks.set_fill_area_interior_style(style)?;
        gks.set_fill_area_style_index(style_index(style))?;
        gks.set_fill_area_colour_index(i as i32 + 1)?;
        gks.fill_area(&star(-0.8, 0.6, 0.8, 7, 0.4))?;
        gks.fill_area(&star(0.9, -0.9, 0.7, 5, 0.5))?;
        gks.fill_area(&star(3.0, 3.0, 0.9, 5, 0.5))?;
        gks.fill_area(&[(0.3, 0.2), (5.0, 0.5), (0.4, 0.9)])?;
        // A ring through far corners, with an opening in the middle.
        gks.fill_area(&[(-4.0, -0.5), (0.0, -0.45), (4.0, -0.5), (4.0, -0.6), (0.0, -0.55), (-4.0, -0.6)])?;
    }
    Ok(())
}
