//! Normalization and workstation transformations, clipping, and matrices for segments.

use crate::argument::{Address, call, choice};
use gks::{CoordinateSwitch, Function};
use gks_geometry::{Map, Ndc, Point, Wc};
use std::ffi::c_int;

/// SET WINDOW.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_window(number: c_int, xmin: f64, xmax: f64, ymin: f64, ymax: f64) {
    call(Function::SetWindow, |gks| gks.set_window(number, (xmin, xmax, ymin, ymax)));
}

/// SET VIEWPORT.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_viewport(number: c_int, xmin: f64, xmax: f64, ymin: f64, ymax: f64) {
    call(Function::SetViewport, |gks| gks.set_viewport(number, (xmin, xmax, ymin, ymax)));
}

/// SELECT NORMALIZATION TRANSFORMATION.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_select_xform(number: c_int) {
    call(Function::SelectNormalizationTransformation, |gks| gks.select_normalization_transformation(number));
}

/// SET CLIPPING INDICATOR: 0 do not clip, 1 clip.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_clipping(indicator: c_int) {
    call(Function::SetClippingIndicator, |gks| gks.set_clipping_indicator(indicator != 0));
}

/// SET WORKSTATION WINDOW.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_ws_window(ws_id: c_int, xmin: f64, xmax: f64, ymin: f64, ymax: f64) {
    call(Function::SetWorkstationWindow, |gks| gks.set_workstation_window(ws_id, (xmin, xmax, ymin, ymax)));
}

/// SET WORKSTATION VIEWPORT, in metres.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_set_ws_viewport(ws_id: c_int, xmin: f64, xmax: f64, ymin: f64, ymax: f64) {
    call(Function::SetWorkstationViewport, |gks| {
        gks.set_workstation_viewport(ws_id, (xmin, xmax, ymin, ymax))
    });
}

/// The coordinates that a switch means: world coordinates or NDC.
pub(crate) fn switch(number: c_int) -> Option<CoordinateSwitch> {
    [CoordinateSwitch::Wc, CoordinateSwitch::Ndc].get(usize::try_from(number).ok()?).copied()
}

/// EVALUATE TRANSFORMATION MATRIX. The matrix has three rows of two numbers: what x and y are multiplied with, and
/// the shift.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_eval_xform_matrix(
    x: f64,
    y: f64,
    shift_x: f64,
    shift_y: f64,
    angle: f64,
    scale_x: f64,
    scale_y: f64,
    coordinates: c_int,
    matrix: Address<f64>,
) {
    const F: Function = Function::EvaluateTransformationMatrix;
    call(F, |gks| {
        let switch = choice(switch(coordinates), F)?;
        let (fixed, shift, scale) = ((x, y), (shift_x, shift_y), (scale_x, scale_y));
        let [first, second] = gks.evaluate_transformation_matrix(fixed, shift, angle, scale, switch)?;
        matrix.set_all(first.into_iter().zip(second).flat_map(|(a, b)| [a, b]));
        Ok(())
    });
}

/// Converts a position from world coordinates to NDC by a normalization transformation.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn gks_WC_to_NDC(number: c_int, x: Address<f64>, y: Address<f64>) {
    let found = gks_instance::with(|instance| instance.gks.inquire_normalization_transformation(number));
    let (Ok(found), &[from_x], &[from_y]) = (found, x.slice(1), y.slice(1)) else { return };
    let map: Map<Wc, Ndc> = Map::window_to_viewport(&found.window, &found.viewport);
    let to = map.point(Point::new(from_x, from_y));
    x.set(to.x());
    y.set(to.y());
}
