//! From virtual device coordinates to NDC: the extent of a picture fitted into the unit square.

use super::context::Context;
use crate::cgm::coding::SizeMode;
use gks_geometry::{Map, Ndc, Point, Rect, Vector, Wc};
use gks_pipeline::generated::numbers;
use glam::{DAffine2, DMat2, DVec2};

/// The side of a display surface that millimetres count on when a metafile does not say how large it is, in mm.
const SIDE: f64 = 200.0;

/// Where the extent of a picture lies in NDC. Virtual device coordinates take the place of world coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mapping {
    /// From virtual device coordinates to NDC.
    pub(super) map: Map<Wc, Ndc>,
    /// The image of the extent: as large as fits into the unit square, at its lower left corner.
    pub(super) window: Rect<Ndc>,
    /// The corners of the extent.
    pub(super) extent: (DVec2, DVec2),
    /// NDC for a unit of virtual device coordinates.
    pub(super) scale: f64,
}

impl Mapping {
    /// The mapping of a picture.
    pub(super) fn new(context: &Context) -> Mapping {
        let default = if context.modes.real_coordinates { DVec2::ONE } else { DVec2::splat(32767.0) };
        let usable = |&(first, second): &(DVec2, DVec2)| {
            let size = second - first;
            size.is_finite() && size.x != 0.0 && size.y != 0.0 && size.abs().max_element() > 1e-300
        };
        let extent = context.extent.filter(usable).unwrap_or((DVec2::ZERO, default));
        let (first, second) = extent;
        let size = second - first;
        let scale = 1.0 / size.abs().max_element();
        let factor = size.signum() * scale;
        let affine = DAffine2::from_mat2_translation(DMat2::from_diagonal(factor), -first * factor);
        let corner = (size.abs() * scale).max(DVec2::splat(1e-9));
        let window = Rect::new(0.0, corner.x, 0.0, corner.y);
        Mapping { map: Map::from_affine(affine), window, extent, scale }
    }

    /// The image of a point.
    pub(super) fn point(&self, p: DVec2) -> DVec2 {
        self.map.0.transform_point2(p)
    }

    /// The image of a vector.
    pub(super) fn vector(&self, v: DVec2) -> Vector<Ndc> {
        self.map.vector(Vector::from_vec(v))
    }

    /// The rectangle around the image of a rectangle given by two corners.
    pub(super) fn rect(&self, first: DVec2, second: DVec2) -> Rect<Ndc> {
        let others = [DVec2::new(first.x, second.y), DVec2::new(second.x, first.y)];
        let [a, b, c, d] = [first, second, others[0], others[1]].map(|corner| self.point(corner));
        let (least, most) = (a.min(b).min(c).min(d), a.max(b).max(c).max(d));
        Rect { min: Point::from_vec(least), max: Point::from_vec(most) }
    }

    /// The mapping of what is transformed first.
    pub(super) fn after(&self, transformation: DAffine2) -> Mapping {
        let map = Map::from_affine(transformation).then(&self.map);
        let scale = self.scale * transformation.matrix2.determinant().abs().sqrt();
        Mapping { map, scale, ..*self }
    }

    /// A size in NDC, given as a mode has it, with `nominal` for 1 and for none.
    fn size(&self, size: Option<f64>, mode: SizeMode, metric: Option<f64>, nominal: f64) -> f64 {
        match (size, mode) {
            // The default in coordinates is a thousandth or a hundredth of the extent: about the nominal size.
            // A width of nothing is that of the thinnest line.
            (None | Some(0.0), _) => nominal,
            (Some(size), SizeMode::Scaled) => size * nominal,
            (Some(size), SizeMode::Absolute) => size * self.scale,
            (Some(size), SizeMode::Fractional) => size,
            (Some(size), SizeMode::Millimetres) => match metric {
                Some(millimetres) => size / millimetres * self.scale,
                None => size / SIDE,
            },
        }
    }

    /// The line width scale factor of a line width.
    pub(super) fn line_width(&self, width: Option<f64>, mode: SizeMode, metric: Option<f64>) -> f64 {
        let nominal = numbers::NOMINAL_LINEWIDTH;
        finite(self.size(width, mode, metric, nominal) / nominal)
    }

    /// The marker size scale factor of a marker size.
    pub(super) fn marker_size(&self, size: Option<f64>, mode: SizeMode, metric: Option<f64>) -> f64 {
        let nominal = numbers::NOMINAL_MARKER_SIZE;
        finite(self.size(size, mode, metric, nominal) / nominal)
    }

    /// A length of a style in NDC.
    pub(super) fn style(&self, size: f64, mode: SizeMode, metric: Option<f64>) -> f64 {
        finite(self.size(Some(size), mode, metric, numbers::NOMINAL_LINEWIDTH))
    }
}

fn finite(value: f64) -> f64 {
    if value.is_finite() { value.max(0.0) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longer_side_fills_the_square_and_the_first_corner_is_lower_left() {
        let extent = Some((DVec2::new(0.0, 300.0), DVec2::new(200.0, -100.0)));
        let mapping = Mapping::new(&Context { extent, ..Context::default() });
        assert_eq!(mapping.window, Rect::new(0.0, 0.5, 0.0, 1.0));
        assert_eq!(mapping.point(DVec2::new(200.0, 300.0)), DVec2::new(0.5, 0.0));
        assert_eq!(mapping.point(DVec2::new(0.0, -100.0)), DVec2::new(0.0, 1.0));
        assert_eq!(mapping.line_width(Some(4.0), SizeMode::Absolute, None), 10.0);
        assert_eq!(mapping.line_width(None, SizeMode::Absolute, None), 1.0);
    }

    #[test]
    fn an_extent_without_area_is_replaced() {
        let extent = Some((DVec2::ZERO, DVec2::new(0.0, 5.0)));
        let mapping = Mapping::new(&Context { extent, ..Context::default() });
        assert_eq!(mapping.extent.1, DVec2::splat(32767.0));
    }
}
