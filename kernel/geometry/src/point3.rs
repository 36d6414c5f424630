//! Points and vectors of three-dimensional spaces (PHIGS).

use crate::{Point, Space};
use glam::DVec3;
use std::marker::PhantomData;

/// A position in the three-dimensional space `S`.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(transparent)]
pub struct Point3<S: Space>(pub DVec3, PhantomData<S>);

/// A displacement in the three-dimensional space `S`.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(transparent)]
pub struct Vector3<S: Space>(pub DVec3, PhantomData<S>);

impl<S: Space> Point3<S> {
    /// The point (x, y, z).
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Point3(DVec3::new(x, y, z), PhantomData)
    }

    /// The point with the components of `v`.
    #[inline]
    pub const fn from_vec(v: DVec3) -> Self {
        Point3(v, PhantomData)
    }

    /// The point without its depth.
    #[inline]
    pub fn flat(self) -> Point<S> {
        Point::new(self.0.x, self.0.y)
    }
}

impl<S: Space> Vector3<S> {
    /// The vector (x, y, z).
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Vector3(DVec3::new(x, y, z), PhantomData)
    }

    /// The vector with the components of `v`.
    #[inline]
    pub const fn from_vec(v: DVec3) -> Self {
        Vector3(v, PhantomData)
    }
}

impl<S: Space> From<(f64, f64, f64)> for Point3<S> {
    fn from((x, y, z): (f64, f64, f64)) -> Self {
        Point3::new(x, y, z)
    }
}
