//! Bundled attributes and colours.

use gks::{Gks, Result};
use gks_pipeline::colour::Colour;
use gks_pipeline::look::{AspectSourceFlags, InteriorStyle, Precision};

fn primitives(gks: &mut Gks, entries: i32) -> Result<()> {
    for i in 0..entries {
        let y = 0.88 - 0.15 * f64::from(i);
        gks.set_polyline_index(i + 1)?;
        gks.set_polymarker_index(i + 1)?;
        gks.set_text_index(i + 1)?;
        gks.set_fill_area_index(i + 1)?;
        gks.polyline(&[(0.04, y), (0.237, y), (0.237, y + 0.079)])?;
        gks.polymarker(&[(0.3, y), (0.34, y + 0.04), (0.38, y)])?;
        gks.text((0.43, y), "Bundle")?;
        gks.fill_area(&[(0.75, y), (0.95, y), (0.95, y + 0.08), (0.85, y + 0.1), (0.75, y + 0.08)])?;
    }
    Ok(())
}

/// The predefined bundles.
pub fn predefined(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_aspect_source_flags(AspectSourceFlags::BUNDLED)?;
    gks.set_character_height(0.03)?;
    gks.set_pattern_size(0.04, 0.04)?;
    primitives(gks, 6)
}

/// Bundles of one's own, an aspect of each primitive individual.
pub fn represented(gks: &mut Gks, ws: i32) -> Result<()> {
    for i in 1..=4 {
        gks.set_polyline_representation(ws, i, i, f64::from(i * 2), i + 1)?;
        gks.set_polymarker_representation(ws, i, -i, f64::from(i * 3), i + 2)?;
        gks.set_text_representation(ws, i, -20 - i, Precision::Stroke, 1.5 - 0.2 * f64::from(i), 0.1, i)?;
    }
    gks.set_fill_area_representation(ws, 1, InteriorStyle::Solid, 1, 15)?;
    gks.set_fill_area_representation(ws, 2, InteriorStyle::Pattern, 9, 1)?;
    gks.set_fill_area_representation(ws, 3, InteriorStyle::Hatch, -11, 2)?;
    gks.set_fill_area_representation(ws, 4, InteriorStyle::Hollow, 1, 4)?;
    let mut flags = [false; 13];
    for individual in [2, 4, 7, 12] {
        flags[individual] = true;
    }
    gks.set_aspect_source_flags(AspectSourceFlags::from_array(flags))?;
    gks.set_polyline_colour_index(12)?;
    gks.set_marker_size_scale_factor(5.0)?;
    gks.set_character_expansion_factor(0.8)?;
    gks.set_fill_area_colour_index(13)?;
    gks.set_character_height(0.03)?;
    gks.set_pattern_size(0.04, 0.04)?;
    primitives(gks, 4)
}

/// The named predefined colours, colours of one's own, and an index without a representation.
pub fn colours(gks: &mut Gks, ws: i32) -> Result<()> {
    gks.set_colour_representation(ws, 200, Colour::rgb(0.2, 0.7, 0.9))?;
    gks.set_colour_representation(ws, 201, Colour::rgb(0.99, 0.01, 0.5))?;
    gks.set_colour_representation(ws, 5, Colour::rgb(0.3, 0.3, 0.1))?;
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    for (i, index) in (0..18).chain([100, 200, 201, 5, 4000]).enumerate() {
        let (x, y) = (0.04 + 0.19 * (i % 5) as f64, 0.82 - 0.18 * (i / 5) as f64);
        gks.set_fill_area_colour_index(index)?;
        gks.fill_area(&[(x, y), (x + 0.15, y), (x + 0.15, y + 0.1), (x, y + 0.1)])?;
        gks.set_polyline_colour_index(index)?;
        gks.set_linewidth_scale_factor(6.0)?;
        gks.polyline(&[(x, y + 0.13), (x + 0.15, y + 0.13)])?;
    }
    Ok(())
}
