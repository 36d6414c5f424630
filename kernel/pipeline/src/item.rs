//! The waist of the pipeline: one primitive with its look, in normalized device coordinates.
//!
//! Everything above makes items (GKS output functions, traversal of PHIGS structures, interpretation of
//! metafiles), everything below draws them. An item borrows its points; owned copies exist only in stores.

use crate::look::Look;
use gks_geometry::{Map, Ndc, Paths, Point, Rect, Space, Vector};
use glam::DVec2;

/// A primitive at the waist.
#[derive(Clone, Debug)]
pub struct Item<'a> {
    /// What is to be drawn.
    pub shape: Shape<'a>,
    /// How it looks, still unresolved.
    pub look: &'a Look,
    /// The clipping rectangle in force when the primitive was created; a segment transformation does not
    /// move it.
    pub clip: Rect<Ndc>,
    /// The pick identifier.
    pub pick: i32,
}

/// What an item draws.
#[derive(Copy, Clone, Debug)]
pub enum Shape<'a> {
    /// Lines through the points of each path.
    Polyline(Paths<'a, Ndc>),
    /// A marker centred at each position.
    Polymarker(&'a [DVec2]),
    /// A string of characters at a text position.
    Text(Point<Ndc>, &'a str),
    /// The area inside rings, by the even-odd rule.
    FillArea(Paths<'a, Ndc>),
    /// A parallelogram of coloured cells.
    CellArray(Parallelogram<Ndc>, Cells<'a>),
    /// A curved generalized drawing primitive.
    Generalized(Curve<'a, Ndc>, Role),
}

/// Which attributes a generalized drawing primitive uses.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// Polyline attributes: the curve itself.
    Line,
    /// Fill area attributes: the area the curve encloses.
    Area,
}

/// A parallelogram given by the corner `origin` and the two edges that leave it.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Parallelogram<S: Space> {
    /// The corner where cell (1, 1) lies, called P in CELL ARRAY.
    pub origin: Point<S>,
    /// The edge along which columns advance.
    pub columns: Vector<S>,
    /// The edge along which rows advance.
    pub rows: Vector<S>,
}

impl<S: Space> Parallelogram<S> {
    /// The image under an affine map, which is a parallelogram again.
    pub fn mapped<T: Space>(&self, map: &Map<S, T>) -> Parallelogram<T> {
        Parallelogram {
            origin: map.point(self.origin),
            columns: map.vector(self.columns),
            rows: map.vector(self.rows),
        }
    }

    /// The four corners in order around the parallelogram.
    pub fn corners(&self) -> [Point<S>; 4] {
        let Parallelogram { origin, columns, rows } = *self;
        [origin, origin + columns, origin + columns + rows, origin + rows]
    }
}

/// A rectangular array of colour indices, column fastest, as applications hand it over: possibly a part
/// of a wider array.
#[derive(Copy, Clone, Debug)]
pub struct Cells<'a> {
    /// The indices, from the first cell of the part on.
    indices: &'a [i32],
    /// Number of columns.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// Distance from one row to the next in `indices`.
    stride: usize,
}

impl<'a> Cells<'a> {
    /// The array of `columns` x `rows` cells whose rows are `stride` indices apart, or none if a dimension
    /// is zero or `indices` is too short.
    pub fn new(indices: &'a [i32], columns: usize, rows: usize, stride: usize) -> Option<Self> {
        let need = (rows.checked_sub(1)?).checked_mul(stride)?.checked_add(columns)?;
        (columns > 0 && stride >= columns && indices.len() >= need).then_some(Cells {
            indices,
            columns,
            rows,
            stride,
        })
    }

    /// All indices from the first cell on, and how far apart in them rows begin.
    pub fn indices(&self) -> (&'a [i32], usize) {
        (self.indices, self.stride)
    }

    /// The indices of one row.
    #[inline]
    pub fn row(&self, row: usize) -> &'a [i32] {
        &self.indices[row * self.stride..][..self.columns]
    }
}

/// A curve.
#[derive(Copy, Clone, Debug)]
pub enum Curve<'a, S: Space> {
    /// An ellipse or a part of one.
    Ellipse(Ellipse<S>),
    /// A chain of cubic Bezier curves: a start point, then three points for each piece.
    Bezier(&'a [DVec2]),
}

/// An elliptic arc `centre + a cos t + b sin t` for t from `start` to `start + sweep`, where a and b are
/// conjugate semi-diameters: an affine image of a circular arc.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Ellipse<S: Space> {
    /// The centre.
    pub centre: Point<S>,
    /// The semi-diameter at parameter 0.
    pub a: Vector<S>,
    /// The semi-diameter at parameter pi / 2.
    pub b: Vector<S>,
    /// Parameter of the first point, in radians.
    pub start: f64,
    /// Signed parameter range, at most a full turn.
    pub sweep: f64,
    /// How the arc is completed.
    pub closure: Closure,
}

/// How an elliptic arc is completed to a boundary.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Closure {
    /// A full ellipse.
    Full,
    /// An open arc.
    Open,
    /// The chord between the ends.
    Chord,
    /// The two radii to the ends.
    Pie,
}

impl<S: Space> Ellipse<S> {
    /// The image under an affine map, which is an elliptic arc again.
    pub fn mapped<T: Space>(&self, map: &Map<S, T>) -> Ellipse<T> {
        Ellipse {
            centre: map.point(self.centre),
            a: map.vector(self.a),
            b: map.vector(self.b),
            start: self.start,
            sweep: self.sweep,
            closure: self.closure,
        }
    }

    /// The point at parameter `t`.
    pub fn at(&self, t: f64) -> Point<S> {
        self.centre + self.a * t.cos() + self.b * t.sin()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_checked_before_they_are_read() {
        let indices: Vec<i32> = (0..12).collect();
        assert!(Cells::new(&indices, 4, 3, 4).is_some());
        assert!(Cells::new(&indices, 4, 4, 4).is_none());
        assert!(Cells::new(&indices, 0, 1, 4).is_none());
        assert!(Cells::new(&indices, 4, 0, 4).is_none());
        assert!(Cells::new(&indices, usize::MAX, usize::MAX, usize::MAX).is_none());
        let part = Cells::new(&indices[5..], 2, 2, 4).unwrap();
        assert_eq!(part.row(0), [5, 6]);
        assert_eq!(part.row(1), [9, 10]);
    }
}
