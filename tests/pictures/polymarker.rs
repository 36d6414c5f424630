//! Polymarkers.

use gks::{Gks, Result};
use gks_pipeline::generated::numbers::MARKERS;

/// Every marker type in four sizes.
pub fn types(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, marker) in MARKERS.iter().enumerate() {
        gks.set_marker_type(marker.number)?;
        for (j, size) in [1.0, 2.0, 5.0, 9.0].into_iter().enumerate() {
            gks.set_marker_size_scale_factor(size)?;
            gks.set_polymarker_colour_index(1 + (i as i32 + j as i32) % 4)?;
            let (x, y) = (0.06 + 0.12 * (2 * (i % 4)) as f64, 0.95 - 0.19 * (i / 4) as f64);
            gks.polymarker(&[(x + 0.1 * (j % 2) as f64, y - 0.09 * (j / 2) as f64)])?;
        }
    }
    Ok(())
}

/// Many markers at once, in growing sizes.
pub fn sizes(gks: &mut Gks, _ws: i32) -> Result<()> {
    for (i, kind) in [2, 3, 4, 5, -9].into_iter().enumerate() {
        gks.set_marker_type(kind)?;
        for j in 0..10 {
            gks.set_marker_size_scale_factor(0.5 + f64::from(j) * 0.6)?;
            let y = 0.95 - 0.19 * i as f64;
            let row: Vec<(f64, f64)> =
                (0..4).map(|k| (0.05 + 0.1 * f64::from(j), y - 0.045 * f64::from(k))).collect();
            gks.polymarker(&row)?;
        }
    }
    Ok(())
}

/// Markers inside, outside and on the edge of a viewport, and at the edge of the surface.
pub fn clipped(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.polyline(&[(0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8), (0.2, 0.2)])?;
    gks.set_marker_size_scale_factor(10.0)?;
    gks.set_marker_type(-9)?;
    gks.polymarker(&[(0.0, 0.05), (0.5, 0.0), (0.999, 0.5)])?;
    gks.set_viewport(1, (0.2, 0.8, 0.2, 0.8))?;
    gks.set_window(1, (0.2, 0.8, 0.2, 0.8))?;
    gks.select_normalization_transformation(1)?;
    for (i, kind) in [2, 3, 4, 5, -1, -8].into_iter().enumerate() {
        let y = 0.1 + 0.15 * i as f64;
        let row: Vec<(f64, f64)> = (0..11).map(|k| (0.1 + 0.081 * f64::from(k), y)).collect();
        gks.set_marker_type(kind)?;
        gks.set_polymarker_colour_index(i as i32 % 4 + 1)?;
        gks.polymarker(&row)?;
    }
    Ok(())
}
