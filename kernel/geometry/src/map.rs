//! Affine maps between spaces of the plane.

use crate::{Point, Rect, Space, Vector};
use glam::{DAffine2, DMat2, DVec2};
use std::marker::PhantomData;

/// An affine map from space `A` to space `B`.
///
/// The normalization transformation (WC to NDC), the segment transformation (NDC to NDC) and the
/// workstation transformation (NDC to DC) are all such maps; [`Map::then`] fuses them, so that points
/// are walked once.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Map<A: Space, B: Space>(pub DAffine2, PhantomData<(A, B)>);

impl<A: Space, B: Space> Map<A, B> {
    /// The map that keeps coordinates as they are.
    pub const IDENTITY: Map<A, B> = Map(DAffine2::IDENTITY, PhantomData);

    /// The map with the given affine transformation.
    pub const fn from_affine(affine: DAffine2) -> Self {
        Map(affine, PhantomData)
    }

    /// The map x' = m11 x + m12 y + m13, y' = m21 x + m22 y + m23, given as rows (m11, m12, m13), (m21, m22, m23).
    pub fn from_rows(m: [[f64; 3]; 2]) -> Self {
        Map(
            DAffine2::from_mat2_translation(
                DMat2::from_cols(DVec2::new(m[0][0], m[1][0]), DVec2::new(m[0][1], m[1][1])),
                DVec2::new(m[0][2], m[1][2]),
            ),
            PhantomData,
        )
    }

    /// The coefficients as rows (m11, m12, m13), (m21, m22, m23).
    pub fn rows(&self) -> [[f64; 3]; 2] {
        let (m, t) = (self.0.matrix2, self.0.translation);
        [[m.x_axis.x, m.y_axis.x, t.x], [m.x_axis.y, m.y_axis.y, t.y]]
    }

    /// The map of `window` onto the whole of `viewport`, with a scale of its own in each direction
    /// (the normalization transformation of GKS).
    pub fn window_to_viewport(window: &Rect<A>, viewport: &Rect<B>) -> Self {
        let scale = DVec2::new(viewport.width() / window.width(), viewport.height() / window.height());
        Self::scaled(window, viewport, scale)
    }

    /// The map of `window` into `viewport` with one scale for both directions, the largest at which the
    /// window fits, lower left corner onto lower left corner (the workstation transformation of GKS).
    pub fn window_into_viewport(window: &Rect<A>, viewport: &Rect<B>) -> Self {
        let s = (viewport.width() / window.width()).min(viewport.height() / window.height());
        Self::scaled(window, viewport, DVec2::splat(s))
    }

    fn scaled(window: &Rect<A>, viewport: &Rect<B>, scale: DVec2) -> Self {
        Map(
            DAffine2::from_mat2_translation(
                DMat2::from_diagonal(scale),
                viewport.min.0 - scale * window.min.0,
            ),
            PhantomData,
        )
    }

    /// The image of a point.
    #[inline]
    pub fn point(&self, p: Point<A>) -> Point<B> {
        Point::from_vec(self.0.transform_point2(p.0))
    }

    /// The image of a vector: the linear part alone.
    #[inline]
    pub fn vector(&self, v: Vector<A>) -> Vector<B> {
        Vector::from_vec(self.0.transform_vector2(v.0))
    }

    /// The smallest rectangle around the image of a rectangle; exact where the map has no rotation.
    #[inline]
    pub fn rect(&self, r: &Rect<A>) -> Rect<B> {
        let m = &self.0.matrix2;
        if m.x_axis.y == 0.0 && m.y_axis.x == 0.0 {
            let (a, b) = (self.point(r.min).0, self.point(r.max).0);
            return Rect { min: Point::from_vec(a.min(b)), max: Point::from_vec(a.max(b)) };
        }
        self.turned_rect(r)
    }

    #[inline(never)]
    fn turned_rect(&self, r: &Rect<A>) -> Rect<B> {
        let [a, b, c, d] = r.corners().map(|p| self.point(p).0);
        Rect { min: Point::from_vec(a.min(b).min(c).min(d)), max: Point::from_vec(a.max(b).max(c).max(d)) }
    }

    /// The map that goes on to space `C` after this one.
    pub fn then<C: Space>(&self, next: &Map<B, C>) -> Map<A, C> {
        Map(next.0 * self.0, PhantomData)
    }

    /// The way back, or none where the map flattens the plane.
    pub fn inverse(&self) -> Option<Map<B, A>> {
        let det = self.0.matrix2.determinant();
        (det != 0.0 && det.is_finite()).then(|| Map(self.0.inverse(), PhantomData))
    }

    /// The scale by which areas grow, as a length ratio (the square root of the determinant's magnitude).
    pub fn mean_scale(&self) -> f64 {
        self.0.matrix2.determinant().abs().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Dc, Ndc, Wc};

    #[test]
    fn workstation_transformation_keeps_the_aspect_and_the_lower_left_corner() {
        let m = Map::<Ndc, Dc>::window_into_viewport(
            &Rect::new(0.0, 1.0, 0.0, 0.5),
            &Rect::new(10.0, 110.0, 20.0, 220.0),
        );
        assert_eq!(m.point(Point::new(0.0, 0.0)), Point::new(10.0, 20.0));
        assert_eq!(m.point(Point::new(1.0, 0.5)), Point::new(110.0, 70.0));
    }

    #[test]
    fn fused_maps_equal_maps_in_turn_and_inverse_undoes() {
        let n = Map::<Wc, Ndc>::window_to_viewport(
            &Rect::new(-5.0, 5.0, 0.0, 100.0),
            &Rect::new(0.1, 0.9, 0.2, 0.4),
        );
        let w = Map::<Ndc, Dc>::from_rows([[3.0, 1.0, 7.0], [0.5, 2.0, -1.0]]);
        let both = n.then(&w);
        let p = Point::new(1.25, 33.0);
        assert!((both.point(p).0 - w.point(n.point(p)).0).length() < 1e-12);
        assert!((both.inverse().unwrap().point(both.point(p)).0 - p.0).length() < 1e-10);
    }

    #[test]
    fn the_image_of_a_rectangle_is_a_rectangle_around_all_corners() {
        let unit = Rect::<Ndc>::UNIT;
        let flipped = Map::<Ndc, Dc>::from_rows([[2.0, 0.0, 1.0], [0.0, -3.0, 1.0]]);
        assert_eq!(flipped.rect(&unit), Rect::new(1.0, 3.0, -2.0, 1.0));
        let turned = Map::<Ndc, Dc>::from_rows([[1.0, -1.0, 0.0], [1.0, 1.0, 0.0]]);
        assert_eq!(turned.rect(&unit), Rect::new(-1.0, 1.0, 0.0, 2.0));
    }

    #[test]
    fn flat_map_has_no_inverse() {
        assert!(Map::<Wc, Ndc>::from_rows([[1.0, 1.0, 0.0], [1.0, 1.0, 0.0]]).inverse().is_none());
    }
}
