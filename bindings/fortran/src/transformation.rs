//! Normalization and workstation transformations, and the matrices of segment transformations.

use crate::argument::{Integer, Real};
use crate::call::{call, subroutines};
use gks::Function;

subroutines! {
    gswn_(tnr: Integer, xmin: Real, xmax: Real, ymin: Real, ymax: Real) SetWindow
        => |gks| gks.set_window(tnr.get(), limits(xmin, xmax, ymin, ymax));
    gsvp_(tnr: Integer, xmin: Real, xmax: Real, ymin: Real, ymax: Real) SetViewport
        => |gks| gks.set_viewport(tnr.get(), limits(xmin, xmax, ymin, ymax));
    gsvpip_(tnr: Integer, rtnr: Integer, relpri: Integer) SetViewportInputPriority
        => |gks| gks.set_viewport_input_priority(tnr.get(), rtnr.get(), relpri.choice(F)?);
    gselnt_(tnr: Integer) SelectNormalizationTransformation
        => |gks| gks.select_normalization_transformation(tnr.get());
    gsclip_(clsw: Integer) SetClippingIndicator => |gks| gks.set_clipping_indicator(clsw.choice(F)?);
    gswkwn_(wkid: Integer, xmin: Real, xmax: Real, ymin: Real, ymax: Real) SetWorkstationWindow
        => |gks| gks.set_workstation_window(wkid.get(), limits(xmin, xmax, ymin, ymax));
    gswkvp_(wkid: Integer, xmin: Real, xmax: Real, ymin: Real, ymax: Real) SetWorkstationViewport
        => |gks| gks.set_workstation_viewport(wkid.get(), limits(xmin, xmax, ymin, ymax));
}

fn limits(xmin: Real, xmax: Real, ymin: Real, ymax: Real) -> (f64, f64, f64, f64) {
    (xmin.real(), xmax.real(), ymin.real(), ymax.real())
}

fn pair(x: Real, y: Real) -> (f64, f64) {
    (x.real(), y.real())
}

/// GEVTM: EVALUATE TRANSFORMATION MATRIX.
#[unsafe(no_mangle)]
extern "C" fn gevtm_(
    x0: Real,
    y0: Real,
    dx: Real,
    dy: Real,
    phi: Real,
    fx: Real,
    fy: Real,
    sw: Integer,
    mout: Real,
) {
    const F: Function = Function::EvaluateTransformationMatrix;
    let matrix = call(F, |gks| {
        let sw = sw.choice(F)?;
        gks.evaluate_transformation_matrix(pair(x0, y0), pair(dx, dy), phi.real(), pair(fx, fy), sw)
    });
    matrix.into_iter().for_each(|matrix| set_matrix(mout, matrix));
}

/// GACTM: ACCUMULATE TRANSFORMATION MATRIX. The result may take the place of the given matrix.
#[unsafe(no_mangle)]
extern "C" fn gactm_(
    minp: Real,
    x0: Real,
    y0: Real,
    dx: Real,
    dy: Real,
    phi: Real,
    fx: Real,
    fy: Real,
    sw: Integer,
    mout: Real,
) {
    const F: Function = Function::AccumulateTransformationMatrix;
    let matrix = call(F, |gks| {
        let (given, sw) = (matrix(minp), sw.choice(F)?);
        let (fixed, shift, scale) = (pair(x0, y0), pair(dx, dy), pair(fx, fy));
        gks.accumulate_transformation_matrix(given, fixed, shift, phi.real(), scale, sw)
    });
    matrix.into_iter().for_each(|matrix| set_matrix(mout, matrix));
}

/// The rows of an array M(2,3), whose columns follow one another.
pub(crate) fn matrix(array: Real) -> [[f64; 3]; 2] {
    let elements = array.slice(0, 6);
    [0, 1].map(|row| [0, 1, 2].map(|column| elements[2 * column + row].into()))
}

fn set_matrix(array: Real, matrix: [[f64; 3]; 2]) {
    let [first, second] = matrix;
    array.set_from(0, first.into_iter().zip(second).flat_map(|(a, b)| [a as f32, b as f32]));
}
