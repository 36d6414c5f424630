//! Normalization and workstation transformations.

use gks::{Gks, Result};
use gks_geometry::Rect;
use gks_pipeline::look::{Horizontal, InteriorStyle, Precision, Vertical};

/// A house with a door, a label, a marker and a hatched roof, in a window from -1 to 1.
fn house(gks: &mut Gks) -> Result<()> {
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    gks.set_fill_area_colour_index(7)?;
    gks.fill_area(&[(-0.7, -0.9), (0.7, -0.9), (0.7, 0.2), (-0.7, 0.2)])?;
    gks.set_fill_area_interior_style(InteriorStyle::Hatch)?;
    gks.set_fill_area_style_index(-4)?;
    gks.set_fill_area_colour_index(2)?;
    gks.fill_area(&[(-0.8, 0.2), (0.8, 0.2), (0.0, 0.9)])?;
    gks.polyline(&[(-0.7, -0.9), (-0.7, 0.2), (0.7, 0.2), (0.7, -0.9), (-0.7, -0.9)])?;
    gks.set_linetype(2)?;
    gks.polyline(&[(-0.8, 0.2), (0.0, 0.9), (0.8, 0.2)])?;
    gks.set_linetype(1)?;
    gks.set_text_font_and_precision(-22, Precision::Stroke)?;
    gks.set_character_height(0.25)?;
    gks.set_text_alignment(Horizontal::Centre, Vertical::Base)?;
    gks.text((0.0, -0.5), "GKS")?;
    gks.cell_array_of((0.3, -0.8), (0.6, -0.55), &[1, 4, 4, 1], 2, 2, 2)?;
    gks.set_fill_area_interior_style(InteriorStyle::Hollow)?;
    gks.circle((0.0, 0.45), (0.15, 0.45))?;
    gks.set_marker_type(3)?;
    gks.polymarker(&[(0.0, 0.0), (-0.5, 0.0), (0.5, 0.0), (0.0, 0.95)])
}

/// Viewports of several shapes, windows that show a part.
pub fn normalizations(gks: &mut Gks, _ws: i32) -> Result<()> {
    let places = [
        ([0.02, 0.48, 0.52, 0.98], [-1.0, 1.0, -1.0, 1.0]),
        ([0.52, 0.98, 0.75, 0.98], [-1.0, 1.0, -1.0, 1.0]),
        ([0.52, 0.98, 0.52, 0.72], [-0.3, 0.9, -0.7, 0.6]),
        ([0.02, 0.2, 0.02, 0.48], [-1.0, 1.0, -1.0, 1.0]),
        ([0.25, 0.98, 0.02, 0.48], [-3.0, 1.5, -1.2, 1.0]),
    ];
    for (i, (viewport, window)) in (1..).zip(places) {
        gks.set_viewport(i, viewport)?;
        gks.set_window(i, window)?;
        gks.select_normalization_transformation(i)?;
        house(gks)?;
    }
    Ok(())
}

/// A workstation window that shows a part of the unit square on the whole surface.
pub fn window(gks: &mut Gks, ws: i32) -> Result<()> {
    gks.set_workstation_window(ws, (0.25, 0.75, 0.3, 0.8))?;
    normalizations(gks, ws)
}

/// A workstation viewport that is a part of the surface, and a window of another shape.
pub fn viewport(gks: &mut Gks, ws: i32) -> Result<()> {
    let surface = gks.inquire_workstation_transformation(ws)?.current.viewport;
    let (width, height) = (surface.width(), surface.height());
    gks.set_workstation_window(ws, (0.1, 0.9, 0.4, 1.0))?;
    gks.set_workstation_viewport(ws, Rect::new(0.2 * width, 0.7 * width, 0.1 * height, 0.9 * height))?;
    normalizations(gks, ws)
}

/// The clipping indicator off: primitives leave their viewports.
pub fn unclipped(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_clipping_indicator(false)?;
    for (i, [x, y]) in (1..).zip([[0.1, 0.55], [0.5, 0.1]]) {
        gks.set_viewport(i, (x, x + 0.35, y, y + 0.35))?;
        gks.set_window(i, (-0.6, 0.6, -0.6, 0.6))?;
        gks.select_normalization_transformation(i)?;
        house(gks)?;
        gks.polyline(&[(-2.5, 0.0), (2.5, 0.3)])?;
    }
    Ok(())
}
