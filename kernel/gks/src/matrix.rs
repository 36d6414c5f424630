//! Transformation matrices for segments.
//!
//! A matrix is given by its rows, ((M11, M12, M13), (M21, M22, M23)): x' = M11 x + M12 y + M13 and
//! y' = M21 x + M22 y + M23, both in NDC.

use crate::attributes::NOT_A_NUMBER;
use crate::{Error, Function, Gks, Result};
use gks_geometry::{Map, Ndc, Point, Vector, Wc};
use glam::{DAffine2, DMat2, DVec2};

/// The coordinates in which a fixed point and a shift vector are given.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum CoordinateSwitch {
    /// World coordinates, taken to NDC by the current normalization transformation.
    Wc = 0,
    /// Normalized device coordinates.
    Ndc = 1,
}

impl Gks {
    /// EVALUATE TRANSFORMATION MATRIX: the matrix that scales and then rotates about a fixed point and then
    /// shifts.
    ///
    /// The angle is in radians, anticlockwise. Scaling and rotation act in NDC, whatever the coordinates of
    /// fixed point and shift are. Errors: 8, 308 (a number is not finite).
    pub fn evaluate_transformation_matrix(
        &self,
        fixed: impl Into<(f64, f64)>,
        shift: impl Into<(f64, f64)>,
        angle: f64,
        scale: impl Into<(f64, f64)>,
        coordinates: CoordinateSwitch,
    ) -> Result<[[f64; 3]; 2]> {
        const F: Function = Function::EvaluateTransformationMatrix;
        self.check_state(F)?;
        let values = [fixed.into(), shift.into(), scale.into()].map(DVec2::from);
        rows(F, &self.transformation(values, angle, coordinates))
    }

    /// ACCUMULATE TRANSFORMATION MATRIX: the matrix that transforms by `matrix` first and then as
    /// [`Gks::evaluate_transformation_matrix`] does.
    ///
    /// Errors: 8, 308 (a number is not finite).
    pub fn accumulate_transformation_matrix(
        &self,
        matrix: [[f64; 3]; 2],
        fixed: impl Into<(f64, f64)>,
        shift: impl Into<(f64, f64)>,
        angle: f64,
        scale: impl Into<(f64, f64)>,
        coordinates: CoordinateSwitch,
    ) -> Result<[[f64; 3]; 2]> {
        const F: Function = Function::AccumulateTransformationMatrix;
        self.check_state(F)?;
        let values = [fixed.into(), shift.into(), scale.into()].map(DVec2::from);
        let next = self.transformation(values, angle, coordinates);
        rows(F, &Map::from_rows(matrix).then(&next))
    }

    fn transformation(
        &self,
        [fixed, shift, scale]: [DVec2; 3],
        angle: f64,
        coordinates: CoordinateSwitch,
    ) -> Map<Ndc, Ndc> {
        let (fixed, shift) = match coordinates {
            CoordinateSwitch::Ndc => (fixed, shift),
            CoordinateSwitch::Wc => {
                let map = &self.normalization.map;
                let (fixed, shift) = (Point::<Wc>::from_vec(fixed), Vector::<Wc>::from_vec(shift));
                (map.point(fixed).0, map.vector(shift).0)
            }
        };
        let linear = DMat2::from_angle(angle) * DMat2::from_diagonal(scale);
        Map::from_affine(DAffine2::from_mat2_translation(linear, fixed + shift - linear * fixed))
    }
}

fn rows(function: Function, map: &Map<Ndc, Ndc>) -> Result<[[f64; 3]; 2]> {
    let rows = map.rows();
    if rows.as_flattened().iter().all(|v| v.is_finite()) {
        Ok(rows)
    } else {
        Err(Error::new(NOT_A_NUMBER, function))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{closed, number, open};
    use std::f64::consts::FRAC_PI_2;

    type Matrix = [[f64; 3]; 2];

    const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    const ORIGIN: (f64, f64) = (0.0, 0.0);
    const ONE: (f64, f64) = (1.0, 1.0);
    const NDC: CoordinateSwitch = CoordinateSwitch::Ndc;
    const WC: CoordinateSwitch = CoordinateSwitch::Wc;

    #[track_caller]
    fn assert_near(found: Result<Matrix>, expected: Matrix) {
        let found = found.unwrap();
        let pairs = found.as_flattened().iter().zip(expected.as_flattened());
        assert!(pairs.clone().all(|(a, b)| (a - b).abs() < 1e-12), "{found:?} {expected:?}");
    }

    #[test]
    fn scales_then_rotates_about_the_fixed_point_then_shifts() {
        let (gks, _) = open(&[]);
        let evaluate =
            |fixed, shift, angle, scale| gks.evaluate_transformation_matrix(fixed, shift, angle, scale, NDC);
        assert_near(evaluate((0.3, 0.7), ORIGIN, 0.0, ONE), IDENTITY);
        assert_near(evaluate(ORIGIN, ORIGIN, FRAC_PI_2, (2.0, 3.0)), [[0.0, -3.0, 0.0], [2.0, 0.0, 0.0]]);
        assert_near(evaluate((0.5, 0.25), ORIGIN, 0.0, (2.0, 4.0)), [[2.0, 0.0, -0.5], [0.0, 4.0, -0.75]]);
        let all = evaluate((0.5, 0.5), (0.1, 0.2), FRAC_PI_2, (2.0, 3.0));
        assert_near(all, [[0.0, -3.0, 2.1], [2.0, 0.0, -0.3]]);
    }

    #[test]
    fn world_coordinates_are_taken_to_ndc_a_shift_as_a_vector() {
        let (mut gks, _) = open(&[]);
        gks.set_window(1, (0.0, 10.0, 0.0, 20.0)).unwrap();
        gks.set_viewport(1, (0.5, 1.0, 0.5, 1.0)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        let shifted = gks.evaluate_transformation_matrix(ORIGIN, (2.0, 4.0), 0.0, ONE, WC);
        assert_near(shifted, [[1.0, 0.0, 0.1], [0.0, 1.0, 0.1]]);
        let scaled = gks.evaluate_transformation_matrix((0.0, 10.0), ORIGIN, 0.0, (2.0, 2.0), WC);
        assert_near(scaled, [[2.0, 0.0, -0.5], [0.0, 2.0, -0.75]]);
    }

    #[test]
    fn an_accumulated_transformation_comes_after_the_matrix() {
        let (gks, _) = open(&[]);
        let shift = [[1.0, 0.0, 0.25], [0.0, 1.0, 0.0]];
        let accumulated = gks.accumulate_transformation_matrix(shift, ORIGIN, ORIGIN, FRAC_PI_2, ONE, NDC);
        assert_near(accumulated, [[0.0, -1.0, 0.0], [1.0, 0.0, 0.25]]);
        let alone =
            gks.accumulate_transformation_matrix(IDENTITY, (0.5, 0.5), (0.1, 0.2), 1.0, (2.0, 3.0), NDC);
        let evaluated = gks.evaluate_transformation_matrix((0.5, 0.5), (0.1, 0.2), 1.0, (2.0, 3.0), NDC);
        assert_near(alone, evaluated.unwrap());
    }

    #[test]
    fn needs_gks_open_and_finite_numbers() {
        let evaluate = |gks: &Gks, angle| gks.evaluate_transformation_matrix(ORIGIN, ORIGIN, angle, ONE, NDC);
        assert_eq!(number(evaluate(&closed(), f64::NAN)), 8);
        assert_eq!(number(evaluate(&open(&[]).0, f64::NAN)), 308);
        let bad = [[f64::INFINITY; 3]; 2];
        let accumulate = |gks: &Gks| gks.accumulate_transformation_matrix(bad, ORIGIN, ORIGIN, 0.0, ONE, NDC);
        assert_eq!(number(accumulate(&closed())), 8);
        assert_eq!(number(accumulate(&open(&[]).0)), 308);
    }
}
