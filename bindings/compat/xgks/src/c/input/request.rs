//! REQUEST and SAMPLE.

use super::super::argument::{Address, call};
use super::super::types::{Gchar, Gchoice, Gfloat, Gint, Gloc, Gpick, Gstroke};
use super::{NOTHING, OK, REFUSED, real, set_string, set_stroke, string_room, stroke_room};
use gks::{Function, Gks};

/// What a REQUEST of a locator, a stroke device, a valuator or a string device gives: a status, which is 0 for a value and 1
/// for none, and the value, or where it goes.
#[repr(C)]
#[derive(Copy, Clone)]
pub(super) struct Answer<V> {
    status: Gint,
    value: V,
}

impl<V> Address<Answer<V>> {
    /// Where the status goes.
    fn status(self) -> Address<Gint> {
        // SAFETY: the address of a member of a structure of the program.
        self.member(|answer| unsafe { &raw mut (*answer).status })
    }

    /// Where the value goes.
    fn of_value(self) -> Address<V> {
        // SAFETY: the same.
        self.member(|answer| unsafe { &raw mut (*answer).value })
    }
}

/// Runs a REQUEST, which sets what it gives by `set`.
fn request<T, V>(
    function: Function,
    response: Address<Answer<T>>,
    ask: impl FnOnce(&mut Gks) -> gks::Result<Option<V>>,
    set: impl FnOnce(&Gks, Address<T>, V),
) -> Gint {
    response.status().set(NOTHING);
    call(function, |gks| {
        if let Some(value) = ask(gks)? {
            response.status().set(OK);
            set(gks, response.of_value(), value);
        }
        Ok(())
    })
}

/// REQUEST LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn greqloc(ws_id: Gint, dev: Gint, response: Address<Answer<Gloc>>) -> Gint {
    let ask = |gks: &mut Gks| gks.request_locator(ws_id, dev);
    request(Function::RequestLocator, response, ask, |_, to, value| to.set(value.into()))
}

/// REQUEST STROKE. The points go where the structure points to.
#[unsafe(no_mangle)]
extern "C" fn greqstroke(ws_id: Gint, dev: Gint, response: Address<Answer<Gstroke>>) -> Gint {
    let ask = |gks: &mut Gks| gks.request_stroke(ws_id, dev);
    request(Function::RequestStroke, response, ask, |gks, to, value| {
        set_stroke(&value, stroke_room(gks, ws_id, dev), to);
    })
}

/// REQUEST VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn greqval(ws_id: Gint, dev: Gint, response: Address<Answer<Gfloat>>) -> Gint {
    let ask = |gks: &mut Gks| gks.request_valuator(ws_id, dev);
    request(Function::RequestValuator, response, ask, |_, to, value| to.set(real(value)))
}

/// REQUEST CHOICE.
#[unsafe(no_mangle)]
extern "C" fn greqchoice(ws_id: Gint, dev: Gint, response: Address<Gchoice>) -> Gint {
    call(Function::RequestChoice, |gks| {
        let answer = gks.request_choice(ws_id, dev)?;
        response.set(answer.map_or(Gchoice { status: REFUSED, choice: 0 }, Gchoice::from));
        Ok(())
    })
}

/// REQUEST PICK.
#[unsafe(no_mangle)]
extern "C" fn greqpick(ws_id: Gint, dev: Gint, response: Address<Gpick>) -> Gint {
    call(Function::RequestPick, |gks| {
        let answer = gks.request_pick(ws_id, dev)?;
        response.set(answer.map_or(Gpick { status: REFUSED, seg: 0, pickid: 0 }, Gpick::from));
        Ok(())
    })
}

/// REQUEST STRING. The bytes go where the structure points to.
#[unsafe(no_mangle)]
extern "C" fn greqstring(ws_id: Gint, dev: Gint, response: Address<Answer<*mut Gchar>>) -> Gint {
    let ask = |gks: &mut Gks| gks.request_string(ws_id, dev);
    request(Function::RequestString, response, ask, |gks, to, value| {
        if let Some(string) = to.value() {
            set_string(&value, string_room(gks, ws_id, dev), Address::at(string));
        }
    })
}

/// SAMPLE LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gsampleloc(ws_id: Gint, dev: Gint, response: Address<Gloc>) -> Gint {
    call(Function::SampleLocator, |gks| {
        response.set(gks.sample_locator(ws_id, dev)?.into());
        Ok(())
    })
}

/// SAMPLE STROKE. The points go where the structure points to.
#[unsafe(no_mangle)]
extern "C" fn gsamplestroke(ws_id: Gint, dev: Gint, response: Address<Gstroke>) -> Gint {
    call(Function::SampleStroke, |gks| {
        let value = gks.sample_stroke(ws_id, dev)?;
        set_stroke(&value, stroke_room(gks, ws_id, dev), response);
        Ok(())
    })
}

/// SAMPLE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn gsampleval(ws_id: Gint, dev: Gint, response: Address<Gfloat>) -> Gint {
    call(Function::SampleValuator, |gks| {
        response.set(real(gks.sample_valuator(ws_id, dev)?));
        Ok(())
    })
}

/// SAMPLE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn gsamplechoice(ws_id: Gint, dev: Gint, response: Address<Gchoice>) -> Gint {
    call(Function::SampleChoice, |gks| {
        response.set(gks.sample_choice(ws_id, dev)?.into());
        Ok(())
    })
}

/// SAMPLE PICK.
#[unsafe(no_mangle)]
extern "C" fn gsamplepick(ws_id: Gint, dev: Gint, response: Address<Gpick>) -> Gint {
    call(Function::SamplePick, |gks| {
        response.set(gks.sample_pick(ws_id, dev)?.into());
        Ok(())
    })
}

/// SAMPLE STRING.
#[unsafe(no_mangle)]
extern "C" fn gsamplestring(ws_id: Gint, dev: Gint, response: Address<Gchar>) -> Gint {
    call(Function::SampleString, |gks| {
        let value = gks.sample_string(ws_id, dev)?;
        set_string(&value, string_room(gks, ws_id, dev), response);
        Ok(())
    })
}
