//! Projective maps between three-dimensional spaces.

use crate::{Point3, Space};
use glam::{DMat4, DVec4};
use std::marker::PhantomData;

/// A map from space `A` to space `B` by a homogeneous 4 x 4 matrix, which may be a perspective one.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Map3<A: Space, B: Space>(pub DMat4, PhantomData<(A, B)>);

impl<A: Space, B: Space> Map3<A, B> {
    /// The map that keeps coordinates as they are.
    pub const IDENTITY: Map3<A, B> = Map3(DMat4::IDENTITY, PhantomData);

    /// The map with the given matrix (column vectors: p' = M p).
    pub const fn from_matrix(matrix: DMat4) -> Self {
        Map3(matrix, PhantomData)
    }

    /// The image of a point in homogeneous coordinates, before the division by w.
    #[inline]
    pub fn homogeneous(&self, p: Point3<A>) -> DVec4 {
        self.0 * p.0.extend(1.0)
    }

    /// The map that goes on to space `C` after this one.
    pub fn then<C: Space>(&self, next: &Map3<B, C>) -> Map3<A, C> {
        Map3(next.0 * self.0, PhantomData)
    }
}
