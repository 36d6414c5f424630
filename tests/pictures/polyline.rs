//! Polylines.

use gks::{Gks, Result};
use gks_pipeline::generated::numbers::LINETYPES;
use gks_pipeline::look::{Cap, Join};
use std::f64::consts::TAU;

/// Every linetype, level, slanting and around corners.
pub fn linetypes(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, linetype) in LINETYPES.iter().enumerate() {
        let y = 0.95 - i as f64 * 0.09;
        gks.set_linetype(linetype.number)?;
        gks.polyline(&[(0.05, y), (0.45, y)])?;
        gks.set_linewidth_scale_factor(3.0)?;
        gks.polyline(&[(0.5, y - 0.04), (0.7, y + 0.02)])?;
        gks.set_linewidth_scale_factor(1.0)?;
        gks.polyline(&[(0.75, y - 0.04), (0.78, y + 0.02), (0.83, y + 0.02), (0.83, y - 0.03), (0.95, y)])?;
    }
    Ok(())
}

/// Linewidths from the nominal one to sixty times it. (Thinner lines are as thin as each device can.)
pub fn widths(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, width) in [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 8.0, 13.0, 21.0, 34.0, 60.0].into_iter().enumerate() {
        let y = 0.96 - 0.07 * i as f64 - 0.0005 * width;
        gks.set_linewidth_scale_factor(width)?;
        gks.set_polyline_colour_index(1 + i as i32 % 4)?;
        gks.polyline(&[(0.05, y), (0.45, y)])?;
        gks.polyline(&[(0.55, y), (0.95, y - 0.03)])?;
    }
    Ok(())
}

/// Every line end with every corner, obtuse and acute beyond the limit of miters.
pub fn ends_and_corners(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, cap) in [Cap::Butt, Cap::Round, Cap::Projecting].into_iter().enumerate() {
        for (j, join) in [Join::Miter, Join::Round, Join::Bevel].into_iter().enumerate() {
            let (x, y) = (0.06 + 0.32 * i as f64, 0.7 - 0.32 * j as f64);
            gks.set_line_cap(cap)?;
            gks.set_line_join(join)?;
            gks.set_linewidth_scale_factor(20.0)?;
            gks.set_linetype(1)?;
            gks.polyline(&[(x, y), (x + 0.1, y + 0.2), (x + 0.15, y), (x + 0.165, y + 0.2), (x + 0.24, y)])?;
            gks.set_linewidth_scale_factor(8.0)?;
            gks.set_linetype(2)?;
            gks.polyline(&[(x, y - 0.03), (x + 0.25, y - 0.03)])?;
            gks.set_linetype(1)?;
            gks.polyline(&[(x + 0.02, y + 0.2), (x + 0.02, y + 0.2)])?;
        }
    }
    Ok(())
}

/// Wide and dashed lines that cross the edges and the corners of a viewport.
pub fn clipped(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.polyline(&[(0.195, 0.195), (0.805, 0.195), (0.805, 0.805), (0.195, 0.805), (0.195, 0.195)])?;
    gks.set_viewport(1, (0.2, 0.8, 0.2, 0.8))?;
    gks.set_window(1, (-1.0, 1.0, -1.0, 1.0))?;
    gks.select_normalization_transformation(1)?;
    for (i, linetype) in [1, 2, 3, 4].into_iter().enumerate() {
        let slope = 0.4 * i as f64;
        gks.set_linetype(linetype)?;
        gks.set_polyline_colour_index(i as i32 + 1)?;
        gks.set_linewidth_scale_factor(1.0 + 3.0 * i as f64)?;
        gks.polyline(&[(-3.0, -2.0 * slope), (0.3, 0.1 - slope * 0.3), (3.0, 2.0 - slope)])?;
        gks.polyline(&[(-1.2, 0.55 + 0.1 * i as f64), (-0.55 - 0.1 * i as f64, 1.2)])?;
    }
    gks.set_linewidth_scale_factor(6.0)?;
    gks.polyline(&[(-0.9, -1.5), (-0.9, 1.5), (-0.8, 1.5), (-0.8, -1.5), (-0.7, -0.5)])
}

/// Dashes along curves of many short edges, and around closed lines.
pub fn dashed_curves(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, linetype) in [2, 3, 4, -1, -6].into_iter().enumerate() {
        let r = 0.44 - 0.08 * i as f64;
        let at = |k: i32| TAU * f64::from(k) / 400.0;
        let ring: Vec<(f64, f64)> =
            (0..=400).map(|k| (0.5 + r * at(k).cos(), 0.5 + r * at(k).sin())).collect();
        gks.set_linetype(linetype)?;
        gks.set_linewidth_scale_factor(1.0 + i as f64)?;
        gks.polyline(&ring)?;
    }
    Ok(())
}

/// Lines without length, points that repeat, and lines that leave the surface by far.
pub fn degenerate(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_linewidth_scale_factor(10.0)?;
    gks.set_line_cap(Cap::Round)?;
    gks.polyline(&[(0.2, 0.8), (0.2, 0.8)])?;
    gks.polyline(&[(0.3, 0.8), (0.3, 0.8), (0.5, 0.9), (0.5, 0.9), (0.5, 0.9), (0.7, 0.8), (0.7, 0.8)])?;
    gks.set_line_cap(Cap::Projecting)?;
    gks.polyline(&[(0.2, 0.6), (0.2, 0.6)])?;
    gks.polyline(&[(0.3, 0.6), (0.7, 0.6), (0.3, 0.6)])?;
    gks.set_line_cap(Cap::Butt)?;
    gks.polyline(&[(-1e6, 0.3 - 1e5), (1e6, 0.3 + 1e5)])?;
    gks.set_linewidth_scale_factor(2.0)?;
    gks.set_linetype(2)?;
    gks.polyline(&[(-3.0, 0.1), (0.5, 0.2), (4.0, 0.1)])
}
