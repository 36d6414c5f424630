//! Inquiries of the workstation state list: control, transformation and text extent.

use crate::answer::{Array, answer, inquiries};
use crate::argument::{Character, Integer, Real};
use gks::Function;
use gks_instance::from_latin1;

inquiries! {
    gqwkc_(wkid: Integer) -> (conid: Integer, wtype: Integer) InquireWorkstationConnectionAndType
        => |gks| {
            let (connection, wtype) = gks.inquire_workstation_connection_and_type(wkid.get())?;
            // A connection that is no number comes from another language.
            Ok((connection.parse().unwrap_or(0), wtype))
        };
    gqwks_(wkid: Integer) -> (state: Integer) InquireWorkstationState
        => |gks| gks.inquire_workstation_state(wkid.get());
    gqwkdu_(wkid: Integer) -> (defmod: Integer, regmod: Integer, dempty: Integer, nframe: Integer)
        InquireWorkstationDeferralAndUpdateStates => |gks| {
            let states = gks.inquire_workstation_deferral_and_update_states(wkid.get())?;
            Ok((states.deferral, states.regeneration, states.empty, states.new_frame_necessary))
        };
    gqwkt_(wkid: Integer) -> (
        tus: Integer, rwindo: Array<f32, 4>, cwindo: Array<f32, 4>, rviewp: Array<f32, 4>, cviewp: Array<f32, 4>
    ) InquireWorkstationTransformation => |gks| {
        let state = gks.inquire_workstation_transformation(wkid.get())?;
        let (requested, current) = (state.requested, state.current);
        Ok((state.pending, requested.window, current.window, requested.viewport, current.viewport))
    };
}

/// GQTXX: INQUIRE TEXT EXTENT.
#[unsafe(no_mangle)]
extern "C" fn gqtxx_(
    wkid: Integer,
    px: Real,
    py: Real,
    str: Character,
    errind: Integer,
    cpx: Real,
    cpy: Real,
    txexpx: Array<f32, 4>,
    txexpy: Array<f32, 4>,
    length: usize,
) {
    let text = str.slice(0, length);
    text_extent(wkid, (px, py), text, errind, (cpx, cpy), (txexpx, txexpy));
}

/// GQTXXS: INQUIRE TEXT EXTENT of the first `lstr` characters.
#[unsafe(no_mangle)]
extern "C" fn gqtxxs_(
    wkid: Integer,
    px: Real,
    py: Real,
    lstr: Integer,
    str: Character,
    errind: Integer,
    cpx: Real,
    cpy: Real,
    txexpx: Array<f32, 4>,
    txexpy: Array<f32, 4>,
    length: usize,
) {
    let text = str.slice(0, length.min(lstr.count()));
    text_extent(wkid, (px, py), text, errind, (cpx, cpy), (txexpx, txexpy));
}

fn text_extent(
    wkid: Integer,
    (px, py): (Real, Real),
    text: &[u8],
    errind: Integer,
    concatenation: (Real, Real),
    corners: (Array<f32, 4>, Array<f32, 4>),
) {
    answer(Function::InquireTextExtent, errind, (concatenation, corners), |gks| {
        let extent = gks.inquire_text_extent(wkid.get(), (px.real(), py.real()), &from_latin1(text))?;
        Ok((extent.concatenation, extent.corners))
    });
}
