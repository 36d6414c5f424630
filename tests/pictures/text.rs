//! Text attributes.

use gks::{Gks, Result};
use gks_pipeline::look::{Horizontal, Precision, TextPath, Vertical};
use std::f64::consts::TAU;

const HORIZONTAL: [Horizontal; 4] =
    [Horizontal::Normal, Horizontal::Left, Horizontal::Centre, Horizontal::Right];
const VERTICAL: [Vertical; 6] =
    [Vertical::Normal, Vertical::Top, Vertical::Cap, Vertical::Half, Vertical::Base, Vertical::Bottom];
const PATHS: [TextPath; 4] = [TextPath::Right, TextPath::Left, TextPath::Up, TextPath::Down];

/// Text with a small marker at its position.
fn placed(gks: &mut Gks, at: (f64, f64), text: &str) -> Result<()> {
    gks.set_marker_type(2)?;
    gks.set_polymarker_colour_index(2)?;
    gks.polymarker(&[at])?;
    gks.text(at, text)
}

/// The three precisions in a stroke font and an outline font, in several heights.
pub fn precisions(gks: &mut Gks, _ws: i32) -> Result<()> {
    let precisions = [Precision::String, Precision::Char, Precision::Stroke];
    for (i, precision) in precisions.into_iter().enumerate() {
        for (j, font) in [1, -21].into_iter().enumerate() {
            gks.set_text_font_and_precision(font, precision)?;
            for (k, height) in [0.012, 0.02, 0.035, 0.06].into_iter().enumerate() {
                gks.set_character_height(height)?;
                gks.set_text_colour_index(k as i32 + 1)?;
                let at = (0.04 + 0.5 * j as f64, 0.93 - 0.32 * i as f64 - 0.075 * k as f64);
                gks.text(at, "Graphic, yes")?;
            }
        }
    }
    Ok(())
}

/// The four paths with their natural alignment.
pub fn paths(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_character_height(0.035)?;
    for (j, font) in [-4, -25].into_iter().enumerate() {
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        for (i, path) in PATHS.into_iter().enumerate() {
            gks.set_text_path(path)?;
            let (dx, dy) = [(0.04, 0.0), (-0.04, 0.0), (0.0, 0.04), (0.0, -0.04)][i];
            placed(gks, (0.25 + 0.48 * j as f64 + dx, 0.7 + dy), "Path")?;
            gks.set_character_spacing(0.4)?;
            placed(gks, (0.25 + 0.48 * j as f64 + dx, 0.25 + dy), "Wij")?;
            gks.set_character_spacing(0.0)?;
        }
    }
    Ok(())
}

/// Every horizontal with every vertical alignment, path RIGHT.
pub fn alignments(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_character_height(0.03)?;
    for (i, vertical) in VERTICAL.into_iter().enumerate() {
        for (j, horizontal) in HORIZONTAL.into_iter().enumerate() {
            gks.set_text_font_and_precision(if (i + j) % 2 == 0 { -21 } else { -7 }, Precision::Stroke)?;
            gks.set_text_alignment(horizontal, vertical)?;
            placed(gks, (0.08 + 0.28 * j as f64, 0.92 - 0.165 * i as f64), "Align")?;
        }
    }
    Ok(())
}

/// Alignments with the other paths and with slanting text.
pub fn path_alignments(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_character_height(0.022)?;
    gks.set_text_font_and_precision(-22, Precision::Stroke)?;
    for (k, path) in [TextPath::Left, TextPath::Up, TextPath::Down].into_iter().enumerate() {
        gks.set_text_path(path)?;
        for (i, vertical) in VERTICAL.into_iter().enumerate() {
            for (j, horizontal) in HORIZONTAL.into_iter().enumerate() {
                gks.set_text_alignment(horizontal, vertical)?;
                let at = (0.09 + 0.16 * i as f64, 0.93 - 0.33 * k as f64 - 0.08 * j as f64);
                placed(gks, at, "Ag")?;
            }
        }
    }
    gks.set_text_path(TextPath::Right)?;
    Ok(())
}

/// Character up vectors all around.
pub fn up_vectors(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_character_height(0.028)?;
    gks.set_text_alignment(Horizontal::Left, Vertical::Half)?;
    for (j, font) in [-12, -21].into_iter().enumerate() {
        let (x, y) = (0.27 + 0.46 * j as f64, 0.72 - 0.44 * j as f64);
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        for i in 0..12 {
            let t = TAU * f64::from(i) / 12.0;
            gks.set_character_up_vector((-3.0 * t.sin(), 3.0 * t.cos()))?;
            gks.text((x + 0.05 * t.cos(), y + 0.05 * t.sin()), "rotated")?;
        }
    }
    gks.set_character_up_vector((0.3, 1.0))?;
    placed(gks, (0.55, 0.85), "slanting line")
}

/// Character expansion factors and spacings.
pub fn widths(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_character_height(0.03)?;
    for (j, font) in [-4, -25].into_iter().enumerate() {
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        for (i, (expansion, spacing)) in
            [(1.0, 0.0), (0.5, 0.0), (2.0, 0.0), (1.0, 0.5), (1.0, -0.25), (0.7, 1.0), (1.8, -0.2)]
                .into_iter()
                .enumerate()
        {
            gks.set_character_expansion_factor(expansion)?;
            gks.set_character_spacing(spacing)?;
            placed(gks, (0.03 + 0.5 * j as f64, 0.9 - 0.13 * i as f64), "Width fi")?;
        }
    }
    gks.set_character_expansion_factor(1.0)?;
    gks.set_character_spacing(0.0)
}

/// Text under a transformation that stretches and so skews it.
pub fn stretched(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_window(1, (0.0, 3.0, 0.0, 1.0))?;
    gks.select_normalization_transformation(1)?;
    gks.set_character_height(0.05)?;
    gks.set_text_alignment(Horizontal::Centre, Vertical::Half)?;
    for (j, font) in [-21, -4].into_iter().enumerate() {
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        for i in 0..8 {
            let t = TAU * f64::from(i) / 8.0;
            gks.set_character_up_vector((-t.sin(), t.cos()))?;
            let (x, y) = (0.8 + 1.4 * j as f64, 0.5);
            gks.text((x + 0.35 * t.cos(), y + 0.35 * t.sin()), "Skew")?;
        }
    }
    gks.set_character_up_vector((0.0, 1.0))
}

/// Text that crosses the edges of a viewport and of the surface.
pub fn clipped(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_text_font_and_precision(-22, Precision::Stroke)?;
    gks.set_character_height(0.05)?;
    gks.text((0.85, 0.93), "surface")?;
    gks.polyline(&[(0.195, 0.195), (0.805, 0.195), (0.805, 0.805), (0.195, 0.805), (0.195, 0.195)])?;
    gks.set_viewport(1, (0.2, 0.8, 0.2, 0.8))?;
    gks.set_window(1, (0.2, 0.8, 0.2, 0.8))?;
    gks.select_normalization_transformation(1)?;
    for (i, font) in [-22, -4, -25].into_iter().enumerate() {
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        gks.text((0.05, 0.3 + 0.15 * i as f64), "clipped at both ends of the line")?;
    }
    gks.set_character_up_vector((-1.0, 1.0))?;
    gks.text((0.6, 0.12), "slanting")?;
    gks.set_character_up_vector((0.0, 1.0))?;
    gks.set_character_height(0.09)?;
    gks.text((0.25, 0.765), "half")
}
