//! AWAIT EVENT, FLUSH DEVICE EVENTS, GET, and what is inquired of the queue.

use super::{set_choice, set_locator, set_pick, set_string, set_stroke, set_value};
use crate::argument::{Out, call, choice as enumeration, inquire};
use crate::types::{Gdouble, Gint, Gpick, Gpoint, Gpoint_list};
use gks::{Function, InputClass};
use std::ffi::c_char;

/// The number for no input class.
const NO_CLASS: Gint = 0;

/// AWAIT EVENT. A timeout without an event gives no input class.
#[unsafe(no_mangle)]
extern "C" fn gawait_event(timeout: Gdouble, ws_id: Out<Gint>, in_class: Out<Gint>, in_num: Out<Gint>) {
    in_class.set(NO_CLASS);
    call(Function::AwaitEvent, |gks| {
        if let Some((id, class, number)) = gks.await_event(timeout)? {
            ws_id.set(id);
            in_class.set(class as Gint);
            in_num.set(number);
        }
        Ok(())
    });
}

/// FLUSH DEVICE EVENTS.
#[unsafe(no_mangle)]
extern "C" fn gflush_events(ws_id: Gint, in_class: Gint, in_num: Gint) {
    const F: Function = Function::FlushDeviceEvents;
    call(F, |gks| {
        let class = enumeration(F, in_class, InputClass::from_number)?;
        gks.flush_device_events(ws_id, class, in_num)
    });
}

/// GET LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gget_loc(norm_tran_num: Out<Gint>, loc_pos: Out<Gpoint>) {
    call(Function::GetLocator, |gks| {
        set_locator(gks.get_locator()?, norm_tran_num, loc_pos);
        Ok(())
    });
}

/// GET STROKE. The program has room for as many points as the input buffer of the device holds.
#[unsafe(no_mangle)]
extern "C" fn gget_stroke(norm_tran_num: Out<Gint>, stroke: Out<Gpoint_list>) {
    call(Function::GetStroke, |gks| {
        set_stroke(&gks.get_stroke()?, norm_tran_num, stroke);
        Ok(())
    });
}

/// GET VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn gget_val(value: Out<Gdouble>) {
    call(Function::GetValuator, |gks| {
        set_value(gks.get_valuator()?, value);
        Ok(())
    });
}

/// GET CHOICE.
#[unsafe(no_mangle)]
extern "C" fn gget_choice(in_status: Out<Gint>, choice: Out<Gint>) {
    call(Function::GetChoice, |gks| {
        set_choice(gks.get_choice()?, in_status, choice);
        Ok(())
    });
}

/// GET PICK.
#[unsafe(no_mangle)]
extern "C" fn gget_pick(in_status: Out<Gint>, pick: Out<Gpick>) {
    call(Function::GetPick, |gks| {
        set_pick(gks.get_pick()?, in_status, pick);
        Ok(())
    });
}

/// GET STRING. The program has room for as many bytes as the input buffer of the device holds, and one more.
#[unsafe(no_mangle)]
extern "C" fn gget_string(string: Out<c_char>) {
    call(Function::GetString, |gks| {
        let value = gks.get_string()?;
        let (ws_id, _, string_num) = gks.current_event().unwrap_or((0, InputClass::String, 0));
        set_string(gks, (ws_id, string_num), &value, string);
        Ok(())
    });
}

/// SET PICK IDENTIFIER.
#[unsafe(no_mangle)]
extern "C" fn gset_pick_id(pick_id: Gint) {
    call(Function::SetPickIdentifier, |gks| gks.set_pick_identifier(pick_id));
}

/// INQUIRE CURRENT PICK IDENTIFIER VALUE.
#[unsafe(no_mangle)]
extern "C" fn ginq_cur_pick_id(err_ind: Out<Gint>, pick_id: Out<Gint>) {
    inquire(Function::InquireCurrentPickIdentifierValue, err_ind, |gks| {
        pick_id.set(gks.inquire_current_pick_identifier_value()?);
        Ok(())
    });
}

/// INQUIRE MORE SIMULTANEOUS EVENTS.
#[unsafe(no_mangle)]
extern "C" fn ginq_more_simult_events(err_ind: Out<Gint>, simult_events: Out<Gint>) {
    inquire(Function::InquireMoreSimultaneousEvents, err_ind, |gks| {
        simult_events.set(gks.inquire_more_simultaneous_events()?.into());
        Ok(())
    });
}

/// INQUIRE INPUT QUEUE OVERFLOW.
#[unsafe(no_mangle)]
extern "C" fn ginq_in_overf(err_ind: Out<Gint>, ws_id: Out<Gint>, in_class: Out<Gint>, in_num: Out<Gint>) {
    inquire(Function::InquireInputQueueOverflow, err_ind, |gks| {
        let (id, class, number) = gks.inquire_input_queue_overflow()?;
        ws_id.set(id);
        in_class.set(class as Gint);
        in_num.set(number);
        Ok(())
    });
}
