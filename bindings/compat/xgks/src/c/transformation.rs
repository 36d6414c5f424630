//! Normalization and workstation transformations, clipping, and matrices for segments.

use super::argument::{Address, call, choice};
use super::types::{Gfloat, Gint, Glimit, Gmatrix, Gpoint, Promoted};
use gks::{CoordinateSwitch, Function, RelativePriority};

/// SET WINDOW.
#[unsafe(no_mangle)]
extern "C" fn gsetwindow(number: Gint, limits: Address<Glimit>) -> Gint {
    const F: Function = Function::SetWindow;
    call(F, |gks| gks.set_window(number, limits.get(F)?))
}

/// SET VIEWPORT.
#[unsafe(no_mangle)]
extern "C" fn gsetviewport(number: Gint, limits: Address<Glimit>) -> Gint {
    const F: Function = Function::SetViewport;
    call(F, |gks| gks.set_viewport(number, limits.get(F)?))
}

/// SET VIEWPORT INPUT PRIORITY: 0 higher, 1 lower.
#[unsafe(no_mangle)]
extern "C" fn gsetviewportinputpri(number: Gint, reference: Gint, priority: Gint) -> Gint {
    call(Function::SetViewportInputPriority, |gks| {
        let priority = if priority == 0 { RelativePriority::Higher } else { RelativePriority::Lower };
        gks.set_viewport_input_priority(number, reference, priority)
    })
}

/// SELECT NORMALIZATION TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn gselntran(number: Gint) -> Gint {
    call(Function::SelectNormalizationTransformation, |gks| gks.select_normalization_transformation(number))
}

/// SET CLIPPING INDICATOR: 0 clip, 1 do not.
#[unsafe(no_mangle)]
extern "C" fn gsetclip(indicator: Gint) -> Gint {
    call(Function::SetClippingIndicator, |gks| gks.set_clipping_indicator(indicator == 0))
}

/// SET WORKSTATION WINDOW.
#[unsafe(no_mangle)]
extern "C" fn gsetwswindow(ws_id: Gint, limits: Address<Glimit>) -> Gint {
    const F: Function = Function::SetWorkstationWindow;
    call(F, |gks| gks.set_workstation_window(ws_id, limits.get(F)?))
}

/// SET WORKSTATION VIEWPORT.
#[unsafe(no_mangle)]
extern "C" fn gsetwsviewport(ws_id: Gint, limits: Address<Glimit>) -> Gint {
    const F: Function = Function::SetWorkstationViewport;
    call(F, |gks| gks.set_workstation_viewport(ws_id, limits.get(F)?))
}

fn coordinates(switch: Gint) -> Option<CoordinateSwitch> {
    [CoordinateSwitch::Wc, CoordinateSwitch::Ndc].get(usize::try_from(switch).ok()?).copied()
}

/// EVALUATE TRANSFORMATION MATRIX.
#[unsafe(no_mangle)]
extern "C" fn gevaltran(
    point: Address<Gpoint>,
    shift: Address<Gpoint>,
    angle: Promoted,
    scale: Address<Gpoint>,
    coordinate_switch: Gint,
    result: Address<Gmatrix>,
) -> Gint {
    const F: Function = Function::EvaluateTransformationMatrix;
    call(F, |gks| {
        let (fixed, shift): (Gpoint, Gpoint) = (point.get(F)?, shift.get(F)?);
        let (scale, switch) = (scale.get(F)?, choice(coordinates(coordinate_switch), F)?);
        let rows = gks.evaluate_transformation_matrix(fixed, shift, angle, scale, switch)?;
        result.set(rows.map(|row| row.map(|v| v as Gfloat)));
        Ok(())
    })
}

/// ACCUMULATE TRANSFORMATION MATRIX.
#[unsafe(no_mangle)]
extern "C" fn gaccumtran(
    matrix: Address<Gmatrix>,
    point: Address<Gpoint>,
    shift: Address<Gpoint>,
    angle: Promoted,
    scale: Address<Gpoint>,
    coordinate_switch: Gint,
    result: Address<Gmatrix>,
) -> Gint {
    const F: Function = Function::AccumulateTransformationMatrix;
    call(F, |gks| {
        let matrix = matrix.get(F)?.map(|row| row.map(f64::from));
        let (fixed, shift): (Gpoint, Gpoint) = (point.get(F)?, shift.get(F)?);
        let (scale, switch) = (scale.get(F)?, choice(coordinates(coordinate_switch), F)?);
        let rows = gks.accumulate_transformation_matrix(matrix, fixed, shift, angle, scale, switch)?;
        result.set(rows.map(|row| row.map(|v| v as Gfloat)));
        Ok(())
    })
}
