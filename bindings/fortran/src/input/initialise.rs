//! INITIALISE and SET MODE.

use super::characters;
use crate::argument::{Character, Integer, Real};
use crate::call::{call, subroutines};
use crate::data_record::lines;
use gks::{Function, Points};
use gks_instance::from_latin1;

/// The echo area of four limits.
fn area(xmin: Real, xmax: Real, ymin: Real, ymax: Real) -> (f64, f64, f64, f64) {
    (xmin.real(), xmax.real(), ymin.real(), ymax.real())
}

subroutines! {
    ginlc_(
        wkid: Integer, lcdnr: Integer, tnr: Integer, ipx: Real, ipy: Real, pet: Integer,
        xmin: Real, xmax: Real, ymin: Real, ymax: Real, ldr: Integer, datrec: Character, _length: usize,
    ) InitialiseLocator => |gks| {
        let (position, area) = ((ipx.real(), ipy.real()), area(xmin, xmax, ymin, ymax));
        let record = lines(ldr, datrec);
        gks.initialise_locator(wkid.get(), lcdnr.get(), tnr.get(), position, pet.get(), area, record)
    };
    ginsk_(
        wkid: Integer, skdnr: Integer, tnr: Integer, n: Integer, ipx: Real, ipy: Real, pet: Integer,
        xmin: Real, xmax: Real, ymin: Real, ymax: Real, buflen: Integer, ldr: Integer, datrec: Character,
        _length: usize,
    ) InitialiseStroke => |gks| {
        let points = Points::SplitSingles(ipx.slice(0, n.count()), ipy.slice(0, n.count()));
        let (id, number, area) = (wkid.get(), skdnr.get(), area(xmin, xmax, ymin, ymax));
        let record = lines(ldr, datrec);
        gks.initialise_stroke(id, number, tnr.get(), points, pet.get(), area, buflen.get(), record)
    };
    ginvl_(
        wkid: Integer, vldnr: Integer, ival: Real, pet: Integer,
        xmin: Real, xmax: Real, ymin: Real, ymax: Real, loval: Real, hival: Real,
        ldr: Integer, datrec: Character, _length: usize,
    ) InitialiseValuator => |gks| {
        let (id, number, area) = (wkid.get(), vldnr.get(), area(xmin, xmax, ymin, ymax));
        let (low, high) = (loval.real(), hival.real());
        gks.initialise_valuator(id, number, ival.real(), pet.get(), area, low, high, lines(ldr, datrec))
    };
    ginch_(
        wkid: Integer, chdnr: Integer, istat: Integer, ichnr: Integer, pet: Integer,
        xmin: Real, xmax: Real, ymin: Real, ymax: Real, ldr: Integer, datrec: Character, _length: usize,
    ) InitialiseChoice => |gks| {
        let (id, number, area) = (wkid.get(), chdnr.get(), area(xmin, xmax, ymin, ymax));
        let status = istat.choice(F)?;
        gks.initialise_choice(id, number, status, ichnr.get(), pet.get(), area, lines(ldr, datrec))
    };
    ginpk_(
        wkid: Integer, pkdnr: Integer, istat: Integer, isgna: Integer, ipkid: Integer, pet: Integer,
        xmin: Real, xmax: Real, ymin: Real, ymax: Real, ldr: Integer, datrec: Character, _length: usize,
    ) InitialisePick => |gks| {
        let (id, number, area) = (wkid.get(), pkdnr.get(), area(xmin, xmax, ymin, ymax));
        let status = istat.choice(F)?;
        gks.initialise_pick(id, number, status, isgna.get(), ipkid.get(), pet.get(), area, lines(ldr, datrec))
    };
    gslcm_(wkid: Integer, lcdnr: Integer, mode: Integer, esw: Integer) SetLocatorMode
        => |gks| gks.set_locator_mode(wkid.get(), lcdnr.get(), mode.choice(F)?, esw.choice(F)?);
    gsskm_(wkid: Integer, skdnr: Integer, mode: Integer, esw: Integer) SetStrokeMode
        => |gks| gks.set_stroke_mode(wkid.get(), skdnr.get(), mode.choice(F)?, esw.choice(F)?);
    gsvlm_(wkid: Integer, vldnr: Integer, mode: Integer, esw: Integer) SetValuatorMode
        => |gks| gks.set_valuator_mode(wkid.get(), vldnr.get(), mode.choice(F)?, esw.choice(F)?);
    gschm_(wkid: Integer, chdnr: Integer, mode: Integer, esw: Integer) SetChoiceMode
        => |gks| gks.set_choice_mode(wkid.get(), chdnr.get(), mode.choice(F)?, esw.choice(F)?);
    gspkm_(wkid: Integer, pkdnr: Integer, mode: Integer, esw: Integer) SetPickMode
        => |gks| gks.set_pick_mode(wkid.get(), pkdnr.get(), mode.choice(F)?, esw.choice(F)?);
    gsstm_(wkid: Integer, stdnr: Integer, mode: Integer, esw: Integer) SetStringMode
        => |gks| gks.set_string_mode(wkid.get(), stdnr.get(), mode.choice(F)?, esw.choice(F)?);
}

/// GINST: INITIALISE STRING.
#[unsafe(no_mangle)]
extern "C" fn ginst_(
    wkid: Integer,
    stdnr: Integer,
    lstr: Integer,
    istr: Character,
    pet: Integer,
    xmin: Real,
    xmax: Real,
    ymin: Real,
    ymax: Real,
    buflen: Integer,
    inipos: Integer,
    ldr: Integer,
    datrec: Character,
    istr_length: usize,
    _datrec_length: usize,
) {
    const F: Function = Function::InitialiseString;
    call(F, |gks| {
        let (id, number, area) = (wkid.get(), stdnr.get(), area(xmin, xmax, ymin, ymax));
        let string = from_latin1(characters(istr, lstr, istr_length));
        let record = lines(ldr, datrec);
        gks.initialise_string(id, number, &string, pet.get(), area, buflen.get(), inipos.get(), record)
    });
}

/// GINSTS: INITIALISE STRING, for a string of 80 characters.
#[unsafe(no_mangle)]
extern "C" fn ginsts_(
    wkid: Integer,
    stdnr: Integer,
    lstr: Integer,
    istr: Character,
    pet: Integer,
    xmin: Real,
    xmax: Real,
    ymin: Real,
    ymax: Real,
    buflen: Integer,
    inipos: Integer,
    ldr: Integer,
    datrec: Character,
    istr_length: usize,
    datrec_length: usize,
) {
    ginst_(
        wkid,
        stdnr,
        lstr,
        istr,
        pet,
        xmin,
        xmax,
        ymin,
        ymax,
        buflen,
        inipos,
        ldr,
        datrec,
        istr_length,
        datrec_length,
    );
}
