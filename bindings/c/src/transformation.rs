//! Normalization and workstation transformations, clipping, and matrices for segments.

use crate::argument::{In, Out, call, choice, flag};
use crate::types::{Gdouble, Gfloat, Gint, Glimit, Gpoint, Gtran_matrix, Gvec};
use gks::{CoordinateSwitch, Function, RelativePriority};

/// SET WINDOW.
#[unsafe(no_mangle)]
extern "C" fn gset_win(tran_num: Gint, win_limits: In<Glimit>) {
    const F: Function = Function::SetWindow;
    call(F, |gks| gks.set_window(tran_num, win_limits.needed(F)?));
}

/// SET VIEWPORT.
#[unsafe(no_mangle)]
extern "C" fn gset_vp(tran_num: Gint, vp_limits: In<Glimit>) {
    const F: Function = Function::SetViewport;
    call(F, |gks| gks.set_viewport(tran_num, vp_limits.needed(F)?));
}

/// SET VIEWPORT INPUT PRIORITY.
#[unsafe(no_mangle)]
extern "C" fn gset_vp_in_pri(tran_num: Gint, ref_tran_num: Gint, rel_pri: Gint) {
    const F: Function = Function::SetViewportInputPriority;
    call(F, |gks| {
        let lower = flag(F, rel_pri)?;
        let priority = if lower { RelativePriority::Lower } else { RelativePriority::Higher };
        gks.set_viewport_input_priority(tran_num, ref_tran_num, priority)
    });
}

/// SELECT NORMALIZATION TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn gsel_norm_tran(tran_num: Gint) {
    const F: Function = Function::SelectNormalizationTransformation;
    call(F, |gks| gks.select_normalization_transformation(tran_num));
}

/// SET CLIPPING INDICATOR.
#[unsafe(no_mangle)]
extern "C" fn gset_clip_ind(clip_ind: Gint) {
    const F: Function = Function::SetClippingIndicator;
    call(F, |gks| gks.set_clipping_indicator(flag(F, clip_ind)?));
}

/// SET WORKSTATION WINDOW.
#[unsafe(no_mangle)]
extern "C" fn gset_ws_win(ws_id: Gint, ws_win_limits: In<Glimit>) {
    const F: Function = Function::SetWorkstationWindow;
    call(F, |gks| gks.set_workstation_window(ws_id, ws_win_limits.needed(F)?));
}

/// SET WORKSTATION VIEWPORT.
#[unsafe(no_mangle)]
extern "C" fn gset_ws_vp(ws_id: Gint, ws_vp_limits: In<Glimit>) {
    const F: Function = Function::SetWorkstationViewport;
    call(F, |gks| gks.set_workstation_viewport(ws_id, ws_vp_limits.needed(F)?));
}

/// EVALUATE TRANSFORMATION MATRIX.
#[unsafe(no_mangle)]
extern "C" fn geval_tran_matrix(
    point: In<Gpoint>,
    shift: In<Gvec>,
    angle: Gdouble,
    scale: In<Gvec>,
    coord_switch: Gint,
    tran_matrix: Out<Gtran_matrix>,
) {
    const F: Function = Function::EvaluateTransformationMatrix;
    call(F, |gks| {
        let (fixed, shift, scale) = (point.needed(F)?, shift.needed(F)?, scale.needed(F)?);
        let switch = choice(F, coord_switch, coordinates)?;
        let rows = gks.evaluate_transformation_matrix(fixed, shift, angle, scale, switch)?;
        tran_matrix.set(rows.map(|row| row.map(|v| v as Gfloat)));
        Ok(())
    });
}

/// ACCUMULATE TRANSFORMATION MATRIX.
#[unsafe(no_mangle)]
extern "C" fn gaccum_tran_matrix(
    matrix: In<Gtran_matrix>,
    point: In<Gpoint>,
    shift: In<Gvec>,
    angle: Gdouble,
    scale: In<Gvec>,
    coord_switch: Gint,
    tran_matrix: Out<Gtran_matrix>,
) {
    const F: Function = Function::AccumulateTransformationMatrix;
    call(F, |gks| {
        let matrix = matrix.needed(F)?.map(|row| row.map(f64::from));
        let (fixed, shift, scale) = (point.needed(F)?, shift.needed(F)?, scale.needed(F)?);
        let switch = choice(F, coord_switch, coordinates)?;
        let rows = gks.accumulate_transformation_matrix(matrix, fixed, shift, angle, scale, switch)?;
        tran_matrix.set(rows.map(|row| row.map(|v| v as Gfloat)));
        Ok(())
    });
}

/// The coordinates that a switch stands for.
fn coordinates(switch: Gint) -> Option<CoordinateSwitch> {
    match switch {
        0 => Some(CoordinateSwitch::Wc),
        1 => Some(CoordinateSwitch::Ndc),
        _ => None,
    }
}
