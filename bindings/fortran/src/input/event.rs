//! AWAIT EVENT, FLUSH DEVICE EVENTS, GET, and what is inquired of the queue.

use super::{NO_CLASS, Points, Text, give};
use crate::answer::inquiries;
use crate::argument::{Character, Integer, Real};
use crate::call::subroutines;
use gks::Function;
use std::ffi::c_int;

/// GWAIT: AWAIT EVENT. A timeout without an event gives no input class.
#[unsafe(no_mangle)]
extern "C" fn gwait_(tout: Real, wkid: Integer, icl: Integer, idnr: Integer) {
    let timeout = tout.real();
    give(Function::AwaitEvent, (wkid, icl, idnr), |gks| {
        let event = gks.await_event(timeout)?;
        Ok(event.map_or((0, NO_CLASS, 0), |(id, class, number)| (id, class as c_int, number)))
    });
}

subroutines! {
    gflush_(wkid: Integer, icl: Integer, idnr: Integer) FlushDeviceEvents
        => |gks| gks.flush_device_events(wkid.get(), icl.choice(F)?, idnr.get());
    gspkid_(pkid: Integer) SetPickIdentifier => |gks| gks.set_pick_identifier(pkid.get());
}

/// GGTLC: GET LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn ggtlc_(tnr: Integer, lpx: Real, lpy: Real) {
    give(Function::GetLocator, (tnr, (lpx, lpy)), |gks| gks.get_locator());
}

/// GGTSK: GET STROKE.
#[unsafe(no_mangle)]
extern "C" fn ggtsk_(n: Integer, tnr: Integer, np: Integer, pxa: Real, pya: Real) {
    let points = Points { transformation: tnr, room: n.count(), count: np, x: pxa, y: pya };
    give(Function::GetStroke, points, |gks| gks.get_stroke());
}

/// GGTVL: GET VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn ggtvl_(val: Real) {
    give(Function::GetValuator, val, |gks| gks.get_valuator());
}

/// GGTCH: GET CHOICE.
#[unsafe(no_mangle)]
extern "C" fn ggtch_(stat: Integer, chnr: Integer) {
    give(Function::GetChoice, (stat, chnr), |gks| gks.get_choice());
}

/// GGTPK: GET PICK.
#[unsafe(no_mangle)]
extern "C" fn ggtpk_(stat: Integer, sgna: Integer, pkid: Integer) {
    give(Function::GetPick, (stat, sgna, pkid), |gks| gks.get_pick());
}

/// GGTST: GET STRING.
#[unsafe(no_mangle)]
extern "C" fn ggtst_(lostr: Integer, str: Character, length: usize) {
    give(Function::GetString, Text { count: lostr, room: length, text: str }, |gks| gks.get_string());
}

/// GGTSTS: GET STRING, for a string of 80 characters.
#[unsafe(no_mangle)]
extern "C" fn ggtsts_(lostr: Integer, str: Character, length: usize) {
    ggtst_(lostr, str, length);
}

inquiries! {
    gqsim_() -> (flag: Integer) InquireMoreSimultaneousEvents
        => |gks| gks.inquire_more_simultaneous_events();
    gqiqov_() -> (wkid: Integer, icl: Integer, idn: Integer) InquireInputQueueOverflow
        => gks::Gks::inquire_input_queue_overflow;
    gqpkid_() -> (pkid: Integer) InquireCurrentPickIdentifierValue
        => |gks| gks.inquire_current_pick_identifier_value();
}
