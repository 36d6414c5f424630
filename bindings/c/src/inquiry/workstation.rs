//! Inquiries of the workstation state list: control, transformation, text extent.

use crate::argument::{BUFFER, In, Out, inquire};
use crate::types::{Gint, Glimit, Gpoint, Gtext_extent};
use gks::{Error, Function};
use std::ffi::c_char;

/// INQUIRE WORKSTATION CONNECTION AND TYPE. Text that is too long for the string is cut off: error 2200.
#[unsafe(no_mangle)]
extern "C" fn ginq_ws_conn_type(
    ws_id: Gint,
    string_length: Gint,
    err_ind: Out<Gint>,
    conn_id: Out<c_char>,
    ws_type: Out<Gint>,
) {
    const F: Function = Function::InquireWorkstationConnectionAndType;
    inquire(F, err_ind, |gks| {
        let (connection, kind) = gks.inquire_workstation_connection_and_type(ws_id)?;
        ws_type.set(kind);
        if !conn_id.is_wanted() {
            return Ok(());
        }
        let room = usize::try_from(string_length).ok().and_then(|length| length.checked_sub(1));
        let room = room.ok_or_else(|| Error::new(BUFFER, F))?;
        let bytes = connection.bytes().take(room).chain([0]);
        conn_id.set_all(bytes.map(|byte| byte as c_char));
        if connection.len() <= room { Ok(()) } else { Err(Error::new(BUFFER, F)) }
    });
}

/// INQUIRE WORKSTATION STATE.
#[unsafe(no_mangle)]
extern "C" fn ginq_ws_st(ws_id: Gint, err_ind: Out<Gint>, ws_st: Out<Gint>) {
    inquire(Function::InquireWorkstationState, err_ind, |gks| {
        ws_st.set(gks.inquire_workstation_state(ws_id)?.into());
        Ok(())
    });
}

/// INQUIRE WORKSTATION DEFERRAL AND UPDATE STATES.
#[unsafe(no_mangle)]
extern "C" fn ginq_ws_defer_upd_sts(
    ws_id: Gint,
    err_ind: Out<Gint>,
    defer_mode: Out<Gint>,
    irg_mode: Out<Gint>,
    disp_empty: Out<Gint>,
    new_frame: Out<Gint>,
) {
    inquire(Function::InquireWorkstationDeferralAndUpdateStates, err_ind, |gks| {
        let states = gks.inquire_workstation_deferral_and_update_states(ws_id)?;
        defer_mode.set(states.deferral as Gint);
        irg_mode.set(states.regeneration as Gint);
        disp_empty.set(states.empty.into());
        new_frame.set(states.new_frame_necessary.into());
        Ok(())
    });
}

/// INQUIRE WORKSTATION TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn ginq_ws_tran(
    ws_id: Gint,
    err_ind: Out<Gint>,
    ws_tran_upd_st: Out<Gint>,
    req_ws_win: Out<Glimit>,
    cur_ws_win: Out<Glimit>,
    req_ws_vp: Out<Glimit>,
    cur_ws_vp: Out<Glimit>,
) {
    inquire(Function::InquireWorkstationTransformation, err_ind, |gks| {
        let state = gks.inquire_workstation_transformation(ws_id)?;
        ws_tran_upd_st.set(state.pending.into());
        req_ws_win.set(state.requested.window.into());
        cur_ws_win.set(state.current.window.into());
        req_ws_vp.set(state.requested.viewport.into());
        cur_ws_vp.set(state.current.viewport.into());
        Ok(())
    });
}

/// INQUIRE TEXT EXTENT.
#[unsafe(no_mangle)]
extern "C" fn ginq_text_extent(
    ws_id: Gint,
    pos: In<Gpoint>,
    str: In<c_char>,
    err_ind: Out<Gint>,
    extent: Out<Gtext_extent>,
) {
    const F: Function = Function::InquireTextExtent;
    inquire(F, err_ind, |gks| {
        let room = gks.inquire_text_extent(ws_id, pos.needed(F)?, &str.text())?;
        extent.set(Gtext_extent {
            concat_point: room.concatenation.into(),
            paral: room.corners.map(Gpoint::from),
        });
        Ok(())
    });
}
