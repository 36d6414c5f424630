//! Points and vectors of the plane.

use crate::Space;
use glam::DVec2;
use std::marker::PhantomData;
use std::ops::{Add, Mul, Neg, Sub};

/// A position in the plane of space `S`.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(transparent)]
pub struct Point<S: Space>(pub DVec2, PhantomData<S>);

/// A displacement in the plane of space `S`: what is left of a map when its translation is ignored.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[repr(transparent)]
pub struct Vector<S: Space>(pub DVec2, PhantomData<S>);

impl<S: Space> Point<S> {
    /// The point (x, y).
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Point(DVec2::new(x, y), PhantomData)
    }

    /// The point whose coordinates are the components of `v`.
    #[inline]
    pub const fn from_vec(v: DVec2) -> Self {
        Point(v, PhantomData)
    }

    /// The abscissa.
    #[inline]
    pub const fn x(self) -> f64 {
        self.0.x
    }

    /// The ordinate.
    #[inline]
    pub const fn y(self) -> f64 {
        self.0.y
    }

    /// Whether both coordinates are finite numbers.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    /// Views a slice of points as plain vectors, for algorithms that know no spaces.
    #[inline]
    pub fn as_vecs(points: &[Self]) -> Vec<DVec2> {
        points.iter().map(|p| p.0).collect()
    }
}

impl<S: Space> Vector<S> {
    /// The vector (x, y).
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Vector(DVec2::new(x, y), PhantomData)
    }

    /// The vector with the components of `v`.
    #[inline]
    pub const fn from_vec(v: DVec2) -> Self {
        Vector(v, PhantomData)
    }

    /// The horizontal component.
    #[inline]
    pub const fn x(self) -> f64 {
        self.0.x
    }

    /// The vertical component.
    #[inline]
    pub const fn y(self) -> f64 {
        self.0.y
    }

    /// The Euclidean length.
    #[inline]
    pub fn length(self) -> f64 {
        self.0.length()
    }
}

impl<S: Space> From<(f64, f64)> for Point<S> {
    fn from((x, y): (f64, f64)) -> Self {
        Point::new(x, y)
    }
}

impl<S: Space> From<[f64; 2]> for Point<S> {
    fn from([x, y]: [f64; 2]) -> Self {
        Point::new(x, y)
    }
}

impl<S: Space> From<(f64, f64)> for Vector<S> {
    fn from((x, y): (f64, f64)) -> Self {
        Vector::new(x, y)
    }
}

impl<S: Space> Add<Vector<S>> for Point<S> {
    type Output = Point<S>;
    #[inline]
    fn add(self, v: Vector<S>) -> Point<S> {
        Point::from_vec(self.0 + v.0)
    }
}

impl<S: Space> Sub<Vector<S>> for Point<S> {
    type Output = Point<S>;
    #[inline]
    fn sub(self, v: Vector<S>) -> Point<S> {
        Point::from_vec(self.0 - v.0)
    }
}

impl<S: Space> Sub for Point<S> {
    type Output = Vector<S>;
    #[inline]
    fn sub(self, from: Point<S>) -> Vector<S> {
        Vector::from_vec(self.0 - from.0)
    }
}

impl<S: Space> Add for Vector<S> {
    type Output = Vector<S>;
    #[inline]
    fn add(self, v: Vector<S>) -> Vector<S> {
        Vector::from_vec(self.0 + v.0)
    }
}

impl<S: Space> Sub for Vector<S> {
    type Output = Vector<S>;
    #[inline]
    fn sub(self, v: Vector<S>) -> Vector<S> {
        Vector::from_vec(self.0 - v.0)
    }
}

impl<S: Space> Neg for Vector<S> {
    type Output = Vector<S>;
    #[inline]
    fn neg(self) -> Vector<S> {
        Vector::from_vec(-self.0)
    }
}

impl<S: Space> Mul<f64> for Vector<S> {
    type Output = Vector<S>;
    #[inline]
    fn mul(self, factor: f64) -> Vector<S> {
        Vector::from_vec(self.0 * factor)
    }
}
