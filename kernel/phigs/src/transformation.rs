//! Modelling transformation utilities; angles in radians, anticlockwise when looked at against the axis.

use gks_geometry::Map3;
use gks_geometry::Mc;
use glam::{DMat4, DVec3};

/// ROTATE X: a rotation about the x axis.
pub fn rotate_x(angle: f64) -> Map3<Mc, Mc> {
    Map3::from_matrix(DMat4::from_rotation_x(angle))
}

/// ROTATE Y: a rotation about the y axis.
pub fn rotate_y(angle: f64) -> Map3<Mc, Mc> {
    Map3::from_matrix(DMat4::from_rotation_y(angle))
}

/// ROTATE Z: a rotation about the z axis.
pub fn rotate_z(angle: f64) -> Map3<Mc, Mc> {
    Map3::from_matrix(DMat4::from_rotation_z(angle))
}

/// SCALE 3: a scaling about the origin.
pub fn scale3(x: f64, y: f64, z: f64) -> Map3<Mc, Mc> {
    Map3::from_matrix(DMat4::from_scale(DVec3::new(x, y, z)))
}

/// TRANSLATE 3: a shift.
pub fn translate3(x: f64, y: f64, z: f64) -> Map3<Mc, Mc> {
    Map3::from_matrix(DMat4::from_translation(DVec3::new(x, y, z)))
}
