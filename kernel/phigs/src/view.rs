//! Views: orientation, mapping, and the representation that a workstation keeps of them.

use crate::{Error, Result};
use gks_geometry::{Map3, Npc, Point3, Rect, Vector3, Vrc, Wc};
use glam::{DMat4, DVec4};

/// An entry of the view table of a workstation.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct ViewRepresentation {
    /// From world to view reference coordinates.
    pub orientation: Map3<Wc, Vrc>,
    /// From view reference to normalized projection coordinates.
    pub mapping: Map3<Vrc, Npc>,
    /// The view clipping limits in x and y.
    pub clip: Rect<Npc>,
    /// The view clipping limits in z, back then front; larger z is nearer to the viewer.
    pub depth: (f64, f64),
    /// Whether the limits in x and y clip.
    pub clip_xy: bool,
    /// Whether the back limit clips.
    pub clip_back: bool,
    /// Whether the front limit clips.
    pub clip_front: bool,
}

impl Default for ViewRepresentation {
    /// View 0: nothing is transformed and the unit cube clips.
    fn default() -> Self {
        ViewRepresentation {
            orientation: Map3::IDENTITY,
            mapping: Map3::IDENTITY,
            clip: Rect::UNIT,
            depth: (0.0, 1.0),
            clip_xy: true,
            clip_back: true,
            clip_front: true,
        }
    }
}

/// How projectors run.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Projection {
    /// All parallel to the line from the projection reference point to the centre of the window.
    Parallel,
    /// All through the projection reference point.
    Perspective,
}

/// What a view mapping is made of; distances run along the normal of the view plane.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct ViewMapping {
    /// The window on the view plane.
    pub window: Rect<Vrc>,
    /// The projection viewport in x and y.
    pub viewport: Rect<Npc>,
    /// The projection viewport in z, back then front.
    pub viewport_depth: (f64, f64),
    /// How projectors run.
    pub projection: Projection,
    /// The projection reference point.
    pub reference: Point3<Vrc>,
    /// Distance of the view plane.
    pub view_plane: f64,
    /// Distance of the back plane.
    pub back_plane: f64,
    /// Distance of the front plane.
    pub front_plane: f64,
}

/// EVALUATE VIEW ORIENTATION MATRIX 3: the view reference coordinate system with its origin at the view
/// reference point, its n axis along the view plane normal and its v axis up.
///
/// Errors: 159 (no normal), 160 (no up vector), 161 (both parallel).
pub fn view_orientation_matrix3(
    reference: Point3<Wc>,
    normal: Vector3<Wc>,
    up: Vector3<Wc>,
) -> Result<Map3<Wc, Vrc>> {
    const F: &str = "EVALUATE VIEW ORIENTATION MATRIX 3";
    let n =
        normal.0.try_normalize().ok_or_else(|| Error::new(159, F, "the view plane normal has no length"))?;
    up.0.try_normalize().ok_or_else(|| Error::new(160, F, "the view up vector has no length"))?;
    let u = up.0.cross(normal.0);
    let u = u.try_normalize().ok_or_else(|| Error::new(161, F, "view up vector and normal are parallel"))?;
    let v = n.cross(u);
    let row = |axis: glam::DVec3| axis.extend(-axis.dot(reference.0));
    let rows = DMat4::from_cols(row(u), row(v), row(n), DVec4::W);
    Ok(Map3::from_matrix(rows.transpose()))
}

/// EVALUATE VIEW MAPPING MATRIX 3: maps the view volume onto the projection viewport, projectors onto
/// parallels of the z axis.
///
/// Errors: 151 (window), 152 (viewport), 158 (planes coincide, viewport has depth), 162 (reference point
/// between the planes), 163 (reference point on the view plane), 164 (front plane behind back plane),
/// 155 (viewport not in the unit cube).
pub fn view_mapping_matrix3(mapping: &ViewMapping) -> Result<Map3<Vrc, Npc>> {
    const F: &str = "EVALUATE VIEW MAPPING MATRIX 3";
    let &ViewMapping { window, viewport, viewport_depth: (z0, z1), reference, .. } = mapping;
    let (plane, back, front) = (mapping.view_plane, mapping.back_plane, mapping.front_plane);
    let p = reference.0;
    let perspective = mapping.projection == Projection::Perspective;
    let fail = |number, detail: &str| Err(Error::new(number, F, detail));
    if !window.is_proper() {
        return fail(151, "window limits");
    }
    if !viewport.is_proper() || z0 > z1 {
        return fail(152, "projection viewport limits");
    }
    if front == back && z0 != z1 {
        return fail(158, "the planes coincide but the viewport has depth");
    }
    if perspective && back < p.z && p.z < front {
        return fail(162, "the projection reference point lies between back and front plane");
    }
    if p.z == plane {
        return fail(163, "the projection reference point lies on the view plane");
    }
    if front < back {
        return fail(164, "the front plane lies behind the back plane");
    }
    if !Rect::UNIT.contains_rect(&viewport) || z0 < 0.0 || z1 > 1.0 {
        return fail(155, "projection viewport");
    }
    let sx = viewport.width() / window.width();
    let sy = viewport.height() / window.height();
    let rows = if perspective {
        let d = p.z - plane;
        let k = 1.0 / (p.z - back);
        let ax = viewport.min.x() + sx * (p.x - window.min.x());
        let ay = viewport.min.y() + sy * (p.y - window.min.y());
        let z = if front == back {
            DVec4::new(0.0, 0.0, 0.0, k * p.z * z1)
        } else {
            let b = (z1 - z0) / (1.0 / (p.z - front) - k);
            let a = z0 - b * k;
            DVec4::new(0.0, 0.0, -k * a, k * (a * p.z + b))
        };
        [
            DVec4::new(sx * d * k, 0.0, -k * ax, k * (p.z * ax - sx * d * p.x)),
            DVec4::new(0.0, sy * d * k, -k * ay, k * (p.z * ay - sy * d * p.y)),
            z,
            DVec4::new(0.0, 0.0, -k, k * p.z),
        ]
    } else {
        let centre = window.centre();
        let hx = (p.x - centre.x()) / (plane - p.z);
        let hy = (p.y - centre.y()) / (plane - p.z);
        let kz = if front == back { 0.0 } else { (z1 - z0) / (front - back) };
        [
            DVec4::new(sx, 0.0, sx * hx, viewport.min.x() - sx * (hx * plane + window.min.x())),
            DVec4::new(0.0, sy, sy * hy, viewport.min.y() - sy * (hy * plane + window.min.y())),
            DVec4::new(0.0, 0.0, kz, z0 - kz * back),
            DVec4::W,
        ]
    };
    let [x, y, z, w] = rows;
    Ok(Map3::from_matrix(DMat4::from_cols(x, y, z, w).transpose()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A perspective view mapping off the axis of its window.
    fn example() -> ViewMapping {
        ViewMapping {
            window: Rect::new(-2.0, 3.0, -1.0, 4.0),
            viewport: Rect::new(0.1, 0.9, 0.2, 0.8),
            viewport_depth: (0.05, 0.95),
            projection: Projection::Perspective,
            reference: Point3::new(0.5, 0.25, 10.0),
            view_plane: 1.0,
            back_plane: -4.0,
            front_plane: 3.0,
        }
    }

    #[test]
    fn perspective_takes_the_window_to_the_viewport_and_the_planes_to_their_depths() {
        let m = view_mapping_matrix3(&example()).unwrap();
        let at = |x, y, z| {
            let h = m.homogeneous(Point3::new(x, y, z));
            h.truncate() / h.w
        };
        assert!((at(-2.0, -1.0, 1.0).truncate() - glam::DVec2::new(0.1, 0.2)).length() < 1e-12);
        assert!((at(3.0, 4.0, 1.0).truncate() - glam::DVec2::new(0.9, 0.8)).length() < 1e-12);
        assert!((at(0.0, 0.0, -4.0).z - 0.05).abs() < 1e-12);
        assert!((at(0.0, 0.0, 3.0).z - 0.95).abs() < 1e-12);
        assert!((m.0.row(0) - DVec4::new(0.1028571, 0.0, -0.0357143, 0.3057143)).length() < 1e-6);
    }

    #[test]
    fn parallel_projection_keeps_sizes_at_any_depth() {
        let m = view_mapping_matrix3(&ViewMapping { projection: Projection::Parallel, ..example() }).unwrap();
        let width = |z| (m.homogeneous(Point3::new(1.0, 0.0, z)) - m.homogeneous(Point3::new(0.0, 0.0, z))).x;
        assert!((width(-4.0) - width(3.0)).abs() < 1e-12);
    }

    #[test]
    fn orientation_is_a_rigid_motion_with_n_along_the_normal() {
        let m = view_orientation_matrix3(
            Point3::new(1.0, 2.0, 3.0),
            Vector3::new(1.0, 1.0, 1.0),
            Vector3::new(0.0, 0.0, 5.0),
        )
        .unwrap();
        assert!((m.0.determinant() - 1.0).abs() < 1e-12);
        let p = m.homogeneous(Point3::new(2.0, 3.0, 4.0));
        assert!((p.truncate() - glam::DVec3::new(0.0, 0.0, 3f64.sqrt())).length() < 1e-12);
    }

    #[test]
    fn wrong_views_are_named_by_number() {
        let number = |m: ViewMapping| view_mapping_matrix3(&m).unwrap_err().number;
        let good = example();
        assert_eq!(number(ViewMapping { window: Rect::new(1.0, 0.0, 0.0, 1.0), ..good }), 151);
        assert_eq!(number(ViewMapping { reference: Point3::new(0.0, 0.0, 0.0), ..good }), 162);
        assert_eq!(number(ViewMapping { view_plane: 10.0, ..good }), 163);
        assert_eq!(
            number(ViewMapping { front_plane: -5.0, reference: Point3::new(0.0, 0.0, 20.0), ..good }),
            164
        );
        assert_eq!(number(ViewMapping { viewport: Rect::new(0.0, 1.5, 0.0, 1.0), ..good }), 155);
        let zero = Vector3::new(0.0, 0.0, 0.0);
        let x = Vector3::new(1.0, 0.0, 0.0);
        let at = Point3::new(0.0, 0.0, 0.0);
        let orientation = |n, up| view_orientation_matrix3(at, n, up).unwrap_err().number;
        assert_eq!((orientation(zero, x), orientation(x, zero), orientation(x, x)), (159, 160, 161));
    }
}
