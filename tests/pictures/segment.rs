//! Segments: transformations, priorities, visibility, highlighting, and segments of segment storage.

use gks::{Gks, Highlighting, Result, Visibility};
use gks_pipeline::generated::numbers::workstation_type;
use gks_pipeline::look::{Horizontal, InteriorStyle, Precision, Vertical};

/// The workstation of segment storage.
const STORAGE: i32 = 2;

type Matrix = [[f64; 3]; 2];

/// A primitive of every kind around the origin of a window from -1 to 1, in a viewport.
fn card(gks: &mut Gks, viewport: [f64; 4]) -> Result<()> {
    gks.set_viewport(1, viewport)?;
    gks.set_window(1, (-1.0, 1.0, -1.0, 1.0))?;
    gks.select_normalization_transformation(1)?;
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    gks.set_fill_area_colour_index(7)?;
    gks.fill_area(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.5), (-0.9, 0.5)])?;
    gks.set_fill_area_interior_style(InteriorStyle::Hollow)?;
    gks.set_fill_area_colour_index(1)?;
    gks.fill_area(&[(-0.9, 0.5), (0.9, 0.5), (0.0, 0.95)])?;
    gks.set_linewidth_scale_factor(3.0)?;
    gks.set_linetype(2)?;
    gks.set_polyline_colour_index(2)?;
    gks.polyline(&[(-0.8, -0.8), (-0.8, 0.4), (0.8, 0.4)])?;
    gks.set_linetype(1)?;
    gks.set_linewidth_scale_factor(1.0)?;
    gks.set_marker_type(2)?;
    gks.set_marker_size_scale_factor(3.0)?;
    gks.set_polymarker_colour_index(4)?;
    gks.polymarker(&[(-0.5, 0.2), (0.0, 0.2), (0.5, 0.2)])?;
    gks.set_text_font_and_precision(-22, Precision::Stroke)?;
    gks.set_character_height(0.3)?;
    gks.set_text_alignment(Horizontal::Centre, Vertical::Base)?;
    gks.text((0.0, -0.3), "GKS")?;
    gks.cell_array_of((0.3, -0.8), (0.7, -0.5), &[1, 3, 3, 1], 2, 2, 2)?;
    gks.circle((-0.3, -0.65), (-0.15, -0.65))
}

/// A segment of [`card`] in a viewport.
fn segment(gks: &mut Gks, name: i32, viewport: [f64; 4]) -> Result<()> {
    gks.create_segment(name)?;
    card(gks, viewport)?;
    gks.close_segment()
}

/// A turn about a point, by an angle in degrees, with a scale.
fn turn((x, y): (f64, f64), degrees: f64, (sx, sy): (f64, f64)) -> Matrix {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let (a, b, c, d) = (cos * sx, -sin * sy, sin * sx, cos * sy);
    [[a, b, x - a * x - b * y], [c, d, y - c * x - d * y]]
}

/// Segments that are turned, scaled, sheared and mirrored; the clipping indicator is off.
pub fn transformed(gks: &mut Gks, ws: i32) -> Result<()> {
    gks.set_clipping_indicator(false)?;
    let places = [
        [0.05, 0.45, 0.55, 0.95],
        [0.55, 0.95, 0.55, 0.95],
        [0.05, 0.45, 0.05, 0.45],
        [0.55, 0.95, 0.05, 0.45],
    ];
    for (name, viewport) in (1..).zip(places) {
        segment(gks, name, viewport)?;
    }
    gks.set_segment_transformation(1, turn((0.25, 0.75), 30.0, (0.8, 0.8)))?;
    gks.set_segment_transformation(2, turn((0.75, 0.75), 0.0, (-1.0, 0.5)))?;
    gks.set_segment_transformation(3, [[0.8, 0.3, 0.0], [0.0, 0.8, 0.05]])?;
    gks.set_segment_transformation(4, turn((0.75, 0.25), -70.0, (1.1, 0.7)))?;
    gks.redraw_all_segments_on_workstation(ws)
}

/// Clipping rectangles stay where they are while segments move.
pub fn clipped(gks: &mut Gks, ws: i32) -> Result<()> {
    for (name, x) in [(1, 0.1), (2, 0.5)] {
        segment(gks, name, [x, x + 0.4, 0.3, 0.7])?;
    }
    gks.set_segment_transformation(1, [[1.0, 0.0, 0.15], [0.0, 1.0, 0.1]])?;
    gks.set_segment_transformation(2, turn((0.7, 0.5), 25.0, (1.2, 1.2)))?;
    gks.redraw_all_segments_on_workstation(ws)
}

/// Areas that overlap in the order of priorities and not of creation; one of them is invisible, one deleted.
pub fn priorities(gks: &mut Gks, ws: i32) -> Result<()> {
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    for (name, priority) in (1..=7).zip([0.5, 0.9, 0.1, 0.5, 0.0, 1.0, 0.7]) {
        let at = 0.04 + 0.09 * f64::from(name);
        gks.create_segment(name)?;
        gks.set_fill_area_colour_index(name + 1)?;
        gks.fill_area(&[(at, at), (at + 0.3, at), (at + 0.3, at + 0.2), (at, at + 0.2)])?;
        gks.polyline(&[(at, at), (at + 0.3, at + 0.2)])?;
        gks.close_segment()?;
        gks.set_segment_priority(name, priority)?;
    }
    gks.set_visibility(4, Visibility::Invisible)?;
    gks.delete_segment(6)?;
    gks.update_workstation(ws, true)
}

/// Highlighted segments beside normal ones, and one that is filled while it is highlighted.
pub fn highlighted(gks: &mut Gks, ws: i32) -> Result<()> {
    let places = [[0.05, 0.45, 0.55, 0.95], [0.55, 0.95, 0.55, 0.95], [0.05, 0.45, 0.05, 0.45]];
    for (name, viewport) in (1..).zip(places) {
        segment(gks, name, viewport)?;
    }
    gks.set_highlighting(2, Highlighting::Highlighted)?;
    gks.set_highlighting(3, Highlighting::Highlighted)?;
    gks.set_segment_transformation(3, turn((0.25, 0.25), 20.0, (0.7, 0.7)))?;
    gks.create_segment(4)?;
    gks.set_highlighting(4, Highlighting::Highlighted)?;
    gks.select_normalization_transformation(0)?;
    gks.set_text_font_and_precision(1, Precision::Stroke)?;
    gks.set_character_height(0.06)?;
    gks.text((0.75, 0.3), "Strokes")?;
    gks.set_marker_type(-9)?;
    gks.set_marker_size_scale_factor(6.0)?;
    gks.polymarker(&[(0.65, 0.15), (0.75, 0.15), (0.85, 0.15)])?;
    gks.close_segment()?;
    gks.redraw_all_segments_on_workstation(ws)
}

/// A segment of segment storage: copied, associated, and inserted into another one.
pub fn storage(gks: &mut Gks, ws: i32) -> Result<()> {
    gks.open_workstation(STORAGE, "", workstation_type::WISS)?;
    gks.deactivate_workstation(ws)?;
    gks.activate_workstation(STORAGE)?;
    segment(gks, 1, [0.05, 0.35, 0.65, 0.95])?;
    gks.deactivate_workstation(STORAGE)?;
    gks.activate_workstation(ws)?;
    gks.select_normalization_transformation(0)?;
    gks.associate_segment_with_workstation(ws, 1)?;
    gks.create_segment(2)?;
    for i in 0..4 {
        let i = f64::from(i);
        gks.insert_segment(1, [[0.7, 0.0, 0.0 + 0.24 * i], [0.0, 0.7, -0.42]])?;
    }
    gks.close_segment()?;
    gks.set_segment_transformation(2, [[0.9, 0.0, 0.0], [0.2, 0.9, 0.1]])?;
    gks.redraw_all_segments_on_workstation(ws)?;
    gks.set_segment_transformation(1, turn((0.2, 0.8), 0.0, (1.0, 0.7)))?;
    gks.copy_segment_to_workstation(ws, 1)?;
    gks.close_workstation(STORAGE)
}
