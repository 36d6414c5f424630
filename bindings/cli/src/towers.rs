//! The demonstration picture of PHIGS: a small hierarchy in perspective.
//!
//! Cubes stand on a grid; each carries smaller ones that are instances of the same structure, turned and
//! shrunk by local modelling transformations.

use gks_geometry::{Mc, Point3, Rect, Vector3};
use gks_pipeline::colour::Colour;
use gks_pipeline::look::InteriorStyle;
use phigs::{
    Composition, Phigs, Projection, Result, ViewMapping, ViewRepresentation, scale3, translate3,
    view_mapping_matrix3, view_orientation_matrix3,
};
use std::f64::consts::TAU;

const CUBE: i32 = 1;
const TOWER: i32 = 2;
const GRID: i32 = 3;
const SCENE: i32 = 4;

/// The colours of the top, of the sides turned to and away from the light, and of the lines.
const COLOURS: [(u32, [f32; 3]); 5] = [
    (20, [0.98, 0.80, 0.45]),
    (21, [0.93, 0.60, 0.22]),
    (22, [0.72, 0.38, 0.10]),
    (23, [0.30, 0.17, 0.06]),
    (24, [0.70, 0.74, 0.80]),
];

/// Builds the structures, posts them to workstation `id` and updates it.
pub fn draw(phigs: &mut Phigs, id: i32) -> Result<()> {
    for (index, [red, green, blue]) in COLOURS {
        phigs.set_colour_representation(id, index, Colour::rgb(red, green, blue))?;
    }
    cube(phigs)?;
    tower(phigs)?;
    grid(phigs)?;
    scene(phigs)?;
    let eye = Point3::new(9.0, -14.0, 11.0);
    let orientation =
        view_orientation_matrix3(eye, Vector3::new(9.0, -14.0, 9.0), Vector3::new(0.0, 0.0, 1.0))?;
    let mapping = view_mapping_matrix3(&ViewMapping {
        window: Rect::new(-4.2, 4.2, -4.6, 3.8),
        viewport: Rect::UNIT,
        viewport_depth: (0.0, 1.0),
        projection: Projection::Perspective,
        reference: Point3::new(0.0, 0.0, 0.0),
        view_plane: -12.0,
        back_plane: -60.0,
        front_plane: -1.0,
    })?;
    let view = ViewRepresentation { orientation, mapping, ..ViewRepresentation::default() };
    phigs.set_view_representation3(id, 1, view)?;
    phigs.post_structure(id, SCENE, 1.0)?;
    phigs.update_workstation(id)
}

/// A unit cube on the origin, its visible faces back to front for an eye at positive x, negative y.
fn cube(phigs: &mut Phigs) -> Result<()> {
    let at = |x: f64, y: f64, z: f64| Point3::<Mc>::new(x - 0.5, y - 0.5, z);
    let faces = [
        (21, [at(1.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(1.0, 1.0, 1.0), at(1.0, 0.0, 1.0)]),
        (22, [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(1.0, 0.0, 1.0), at(0.0, 0.0, 1.0)]),
        (20, [at(0.0, 0.0, 1.0), at(1.0, 0.0, 1.0), at(1.0, 1.0, 1.0), at(0.0, 1.0, 1.0)]),
    ];
    phigs.open_structure(CUBE)?;
    phigs.set_interior_style(InteriorStyle::Solid)?;
    phigs.set_polyline_colour_index(23)?;
    for (colour, face) in faces {
        phigs.set_interior_colour_index(colour)?;
        phigs.fill_area3(&face)?;
        phigs.polyline3(&[face[0], face[1], face[2], face[3], face[0]])?;
    }
    phigs.close_structure()
}

/// Cubes on one another, each smaller.
fn tower(phigs: &mut Phigs) -> Result<()> {
    phigs.open_structure(TOWER)?;
    let mut height = 0.0;
    for level in 0..5 {
        let size = 1.6 * 0.72f64.powi(level);
        phigs.set_local_transformation3(scale3(size, size, size), Composition::Replace)?;
        phigs.set_local_transformation3(translate3(0.0, 0.0, height), Composition::Postconcatenate)?;
        phigs.execute_structure(CUBE)?;
        height += size;
    }
    phigs.close_structure()
}

fn grid(phigs: &mut Phigs) -> Result<()> {
    phigs.open_structure(GRID)?;
    phigs.set_polyline_colour_index(24)?;
    for i in -6..=6 {
        let t = f64::from(i);
        phigs.polyline3(&[Point3::new(t, -6.0, 0.0), Point3::new(t, 6.0, 0.0)])?;
        phigs.polyline3(&[Point3::new(-6.0, t, 0.0), Point3::new(6.0, t, 0.0)])?;
    }
    let ring: Vec<Point3<Mc>> = (0..=120)
        .map(|i| TAU * f64::from(i) / 120.0)
        .map(|t| Point3::new(4.2 * t.cos(), 4.2 * t.sin(), 0.0))
        .collect();
    phigs.set_linewidth_scale_factor(2.0)?;
    phigs.polyline3(&ring)?;
    phigs.close_structure()
}

/// A tower in the middle and seven around it, from the back to the front.
fn scene(phigs: &mut Phigs) -> Result<()> {
    let mut places: Vec<(f64, f64, f64)> = (0..7)
        .map(|i| TAU * (f64::from(i) + 0.25) / 7.0)
        .map(|t| (4.2 * t.cos(), 4.2 * t.sin(), 0.55))
        .collect();
    places.push((0.0, 0.0, 1.0));
    places.sort_by(|a, b| (b.1 * 14.0 - b.0 * 9.0).total_cmp(&(a.1 * 14.0 - a.0 * 9.0)));
    phigs.open_structure(SCENE)?;
    phigs.set_view_index(1)?;
    phigs.execute_structure(GRID)?;
    for (x, y, size) in places {
        phigs.set_local_transformation3(scale3(size, size, size), Composition::Replace)?;
        phigs.set_local_transformation3(translate3(x, y, 0.0), Composition::Postconcatenate)?;
        phigs.execute_structure(TOWER)?;
    }
    phigs.close_structure()
}
