//! REQUEST and SAMPLE.

use super::{Points, Requested, Text, give};
use crate::argument::{Character, Integer, Real};
use gks::Function;

/// GRQLC: REQUEST LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn grqlc_(wkid: Integer, lcdnr: Integer, stat: Integer, tnr: Integer, px: Real, py: Real) {
    let outputs = Requested { status: stat, value: (tnr, (px, py)) };
    let (id, number) = (wkid.get(), lcdnr.get());
    give(Function::RequestLocator, outputs, |gks| gks.request_locator(id, number));
}

/// GRQSK: REQUEST STROKE.
#[unsafe(no_mangle)]
extern "C" fn grqsk_(
    wkid: Integer,
    skdnr: Integer,
    n: Integer,
    stat: Integer,
    tnr: Integer,
    np: Integer,
    pxa: Real,
    pya: Real,
) {
    let points = Points { transformation: tnr, room: n.count(), count: np, x: pxa, y: pya };
    let (id, number) = (wkid.get(), skdnr.get());
    give(Function::RequestStroke, Requested { status: stat, value: points }, |gks| {
        gks.request_stroke(id, number)
    });
}

/// GRQVL: REQUEST VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn grqvl_(wkid: Integer, vldnr: Integer, stat: Integer, val: Real) {
    let (id, number) = (wkid.get(), vldnr.get());
    give(Function::RequestValuator, Requested { status: stat, value: val }, |gks| {
        gks.request_valuator(id, number)
    });
}

/// GRQCH: REQUEST CHOICE.
#[unsafe(no_mangle)]
extern "C" fn grqch_(wkid: Integer, chdnr: Integer, stat: Integer, chnr: Integer) {
    let (id, number) = (wkid.get(), chdnr.get());
    give(Function::RequestChoice, Requested { status: stat, value: (stat, chnr) }, |gks| {
        gks.request_choice(id, number)
    });
}

/// GRQPK: REQUEST PICK.
#[unsafe(no_mangle)]
extern "C" fn grqpk_(wkid: Integer, pkdnr: Integer, stat: Integer, sgna: Integer, pkid: Integer) {
    let (id, number) = (wkid.get(), pkdnr.get());
    give(Function::RequestPick, Requested { status: stat, value: (stat, sgna, pkid) }, |gks| {
        gks.request_pick(id, number)
    });
}

/// GRQST: REQUEST STRING.
#[unsafe(no_mangle)]
extern "C" fn grqst_(
    wkid: Integer,
    stdnr: Integer,
    stat: Integer,
    lostr: Integer,
    str: Character,
    length: usize,
) {
    let text = Text { count: lostr, room: length, text: str };
    let (id, number) = (wkid.get(), stdnr.get());
    give(Function::RequestString, Requested { status: stat, value: text }, |gks| {
        gks.request_string(id, number)
    });
}

/// GRQSTS: REQUEST STRING, for a string of 80 characters.
#[unsafe(no_mangle)]
extern "C" fn grqsts_(
    wkid: Integer,
    stdnr: Integer,
    stat: Integer,
    lostr: Integer,
    str: Character,
    length: usize,
) {
    grqst_(wkid, stdnr, stat, lostr, str, length);
}

/// GSMLC: SAMPLE LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gsmlc_(wkid: Integer, lcdnr: Integer, tnr: Integer, lpx: Real, lpy: Real) {
    let (id, number) = (wkid.get(), lcdnr.get());
    give(Function::SampleLocator, (tnr, (lpx, lpy)), |gks| gks.sample_locator(id, number));
}

/// GSMSK: SAMPLE STROKE.
#[unsafe(no_mangle)]
extern "C" fn gsmsk_(
    wkid: Integer,
    skdnr: Integer,
    n: Integer,
    tnr: Integer,
    np: Integer,
    pxa: Real,
    pya: Real,
) {
    let points = Points { transformation: tnr, room: n.count(), count: np, x: pxa, y: pya };
    let (id, number) = (wkid.get(), skdnr.get());
    give(Function::SampleStroke, points, |gks| gks.sample_stroke(id, number));
}

/// GSMVL: SAMPLE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn gsmvl_(wkid: Integer, vldnr: Integer, val: Real) {
    let (id, number) = (wkid.get(), vldnr.get());
    give(Function::SampleValuator, val, |gks| gks.sample_valuator(id, number));
}

/// GSMCH: SAMPLE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn gsmch_(wkid: Integer, chdnr: Integer, stat: Integer, chnr: Integer) {
    let (id, number) = (wkid.get(), chdnr.get());
    give(Function::SampleChoice, (stat, chnr), |gks| gks.sample_choice(id, number));
}

/// GSMPK: SAMPLE PICK.
#[unsafe(no_mangle)]
extern "C" fn gsmpk_(wkid: Integer, pkdnr: Integer, stat: Integer, sgna: Integer, pkid: Integer) {
    let (id, number) = (wkid.get(), pkdnr.get());
    give(Function::SamplePick, (stat, sgna, pkid), |gks| gks.sample_pick(id, number));
}

/// GSMST: SAMPLE STRING.
#[unsafe(no_mangle)]
extern "C" fn gsmst_(wkid: Integer, stdnr: Integer, lostr: Integer, str: Character, length: usize) {
    let (id, number) = (wkid.get(), stdnr.get());
    let text = Text { count: lostr, room: length, text: str };
    give(Function::SampleString, text, |gks| gks.sample_string(id, number));
}

/// GSMSTS: SAMPLE STRING, for a string of 80 characters.
#[unsafe(no_mangle)]
extern "C" fn gsmsts_(wkid: Integer, stdnr: Integer, lostr: Integer, str: Character, length: usize) {
    gsmst_(wkid, stdnr, lostr, str, length);
}
