//! Opacity of colours.

use gks::{Gks, Result};
use gks_pipeline::look::{Horizontal, InteriorStyle, Precision, Vertical};
use std::f64::consts::TAU;

fn glass(gks: &mut Gks, ws: i32) -> Result<()> {
    for (index, alpha) in [(2, 0.5), (3, 0.5), (4, 0.5), (1, 0.3)] {
        gks.set_colour_alpha(ws, index, alpha)?;
    }
    Ok(())
}

/// Discs that overlap one another, a pattern and a cell array.
pub fn overlapping(gks: &mut Gks, ws: i32) -> Result<()> {
    glass(gks, ws)?;
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    gks.set_fill_area_colour_index(7)?;
    gks.fill_area(&[(0.1, 0.45), (0.9, 0.45), (0.9, 0.55), (0.1, 0.55)])?;
    for i in 0..3 {
        let t = TAU * (f64::from(i) / 3.0 + 0.25);
        gks.set_fill_area_colour_index(i + 2)?;
        gks.circle(
            (0.4 + 0.15 * t.cos(), 0.6 + 0.15 * t.sin()),
            (0.62 + 0.15 * t.cos(), 0.6 + 0.15 * t.sin()),
        )?;
    }
    gks.cell_array_of((0.55, 0.05), (0.95, 0.4), &[2, 0, 3, 15, 4, 1], 3, 2, 3)?;
    gks.set_fill_area_interior_style(InteriorStyle::Pattern)?;
    gks.set_fill_area_style_index(1)?;
    gks.set_pattern_size(0.1, 0.1)?;
    gks.fill_area(&[(0.05, 0.05), (0.7, 0.1), (0.3, 0.5)])
}

/// Lines that meet themselves, markers and text.
pub fn lines_and_text(gks: &mut Gks, ws: i32) -> Result<()> {
    glass(gks, ws)?;
    gks.set_linewidth_scale_factor(30.0)?;
    gks.set_polyline_colour_index(2)?;
    gks.polyline(&[(0.1, 0.6), (0.9, 0.9), (0.9, 0.6), (0.1, 0.9)])?;
    gks.set_linetype(2)?;
    gks.set_polyline_colour_index(4)?;
    gks.polyline(&[(0.1, 0.75), (0.9, 0.75)])?;
    gks.set_marker_type(-9)?;
    gks.set_marker_size_scale_factor(15.0)?;
    gks.set_polymarker_colour_index(3)?;
    gks.polymarker(&[(0.2, 0.5), (0.24, 0.5), (0.28, 0.5), (0.6, 0.62)])?;
    gks.set_text_colour_index(1)?;
    gks.set_character_height(0.12)?;
    gks.set_text_alignment(Horizontal::Centre, Vertical::Half)?;
    gks.set_text_font_and_precision(-22, Precision::Stroke)?;
    gks.text((0.5, 0.3), "GLASS")?;
    gks.set_text_font_and_precision(-4, Precision::Stroke)?;
    gks.set_text_colour_index(4)?;
    gks.text((0.5, 0.25), "GLASS")
}
