//! Inquiries of input devices: their state, and what the workstation description table says about them.

use super::{Points, Record, Text};
use crate::answer::{Array, Element, answer, element, inquiries};
use crate::argument::{Character, Integer, Real};
use gks::{DefaultDevice, Detail, Function};
use gks_geometry::{Dc, Rect};
use std::ffi::c_int;

/// Where a data record of at most `mldr` lines goes.
fn record(mldr: Integer, ldr: Integer, datrec: Character) -> Record {
    Record { room: mldr.count(), count: ldr, lines: datrec }
}

/// What is said of every device of a workstation type: prompt and echo type `n`, and the echo area.
fn prompting<V>(device: &DefaultDevice<V>, n: Integer) -> (Element<c_int>, Rect<Dc>) {
    (element(device.prompts.iter().copied(), n), device.area)
}

/// The buffer size that a data record says.
fn buffer(detail: &Detail) -> usize {
    match detail {
        Detail::Stroke { buffer, .. } | Detail::String { buffer, .. } => *buffer,
        _ => 0,
    }
}

/// The limits that a data record says.
fn limits(detail: &Detail) -> (f64, f64) {
    match detail {
        Detail::Valuator { low, high } => (*low, *high),
        _ => (0.0, 0.0),
    }
}

/// The number of alternatives that a data record says.
fn alternatives(detail: &Detail) -> c_int {
    match detail {
        Detail::Choice { alternatives, .. } => *alternatives,
        _ => 0,
    }
}

/// The position of the cursor that a data record says.
fn cursor(detail: &Detail) -> usize {
    match detail {
        Detail::String { cursor, .. } => *cursor,
        _ => 0,
    }
}

inquiries! {
    gqli_(wtype: Integer) -> (
        nlcd: Integer, nskd: Integer, nvld: Integer, nchd: Integer, npcd: Integer, nstd: Integer
    ) InquireNumberOfAvailableLogicalInputDevices => |gks| {
        let counts = gks.inquire_number_of_available_logical_input_devices(wtype.get())?;
        let [locators, strokes, valuators, choices, picks, strings] = counts;
        Ok((locators, strokes, valuators, choices, picks, strings))
    };
}

/// GQLCS: INQUIRE LOCATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqlcs_(
    wkid: Integer,
    lcdnr: Integer,
    type_: Integer,
    mldr: Integer,
    errind: Integer,
    mode: Integer,
    esw: Integer,
    tnr: Integer,
    ipx: Real,
    ipy: Real,
    pet: Integer,
    earea: Array<f32, 4>,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireLocatorDeviceState;
    let outputs = ((mode, esw), (tnr, (ipx, ipy)), (pet, earea), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let state = gks.inquire_locator_device_state(wkid.get(), lcdnr.get(), type_.choice(F)?)?;
        Ok(((state.mode, state.echo), state.initial, (state.prompt, state.area), state.record))
    });
}

/// GQSKS: INQUIRE STROKE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqsks_(
    wkid: Integer,
    skdnr: Integer,
    type_: Integer,
    n: Integer,
    mldr: Integer,
    errind: Integer,
    mode: Integer,
    esw: Integer,
    itnr: Integer,
    np: Integer,
    pxa: Real,
    pya: Real,
    pet: Integer,
    earea: Array<f32, 4>,
    buflen: Integer,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireStrokeDeviceState;
    let points = Points { transformation: itnr, room: n.count(), count: np, x: pxa, y: pya };
    let outputs = ((mode, esw), points, (pet, earea), buflen, record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let state = gks.inquire_stroke_device_state(wkid.get(), skdnr.get(), type_.choice(F)?)?;
        let size = buffer(&state.detail);
        Ok(((state.mode, state.echo), state.initial, (state.prompt, state.area), size, state.record))
    });
}

/// GQVLS: INQUIRE VALUATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqvls_(
    wkid: Integer,
    vldnr: Integer,
    mldr: Integer,
    errind: Integer,
    mode: Integer,
    esw: Integer,
    ival: Real,
    pet: Integer,
    earea: Array<f32, 4>,
    loval: Real,
    hival: Real,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireValuatorDeviceState;
    let outputs = ((mode, esw), ival, (pet, earea), (loval, hival), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let state = gks.inquire_valuator_device_state(wkid.get(), vldnr.get())?;
        let limits = limits(&state.detail);
        Ok(((state.mode, state.echo), state.initial, (state.prompt, state.area), limits, state.record))
    });
}

/// GQCHS: INQUIRE CHOICE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqchs_(
    wkid: Integer,
    chdnr: Integer,
    mldr: Integer,
    errind: Integer,
    mode: Integer,
    esw: Integer,
    istat: Integer,
    ichnr: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireChoiceDeviceState;
    let outputs = ((mode, esw), (istat, ichnr), (pet, earea), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let state = gks.inquire_choice_device_state(wkid.get(), chdnr.get())?;
        Ok(((state.mode, state.echo), state.initial, (state.prompt, state.area), state.record))
    });
}

/// GQPKS: INQUIRE PICK DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqpks_(
    wkid: Integer,
    pkdnr: Integer,
    type_: Integer,
    mldr: Integer,
    errind: Integer,
    mode: Integer,
    esw: Integer,
    istat: Integer,
    isgna: Integer,
    ipkid: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquirePickDeviceState;
    let outputs = ((mode, esw), (istat, isgna, ipkid), (pet, earea), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let state = gks.inquire_pick_device_state(wkid.get(), pkdnr.get(), type_.choice(F)?)?;
        Ok(((state.mode, state.echo), state.initial, (state.prompt, state.area), state.record))
    });
}

/// GQSTS: INQUIRE STRING DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqsts_(
    wkid: Integer,
    stdnr: Integer,
    mldr: Integer,
    errind: Integer,
    mode: Integer,
    esw: Integer,
    lostr: Integer,
    istr: Character,
    pet: Integer,
    earea: Array<f32, 4>,
    buflen: Integer,
    inipos: Integer,
    ldr: Integer,
    datrec: Character,
    istr_length: usize,
    _datrec_length: usize,
) {
    const F: Function = Function::InquireStringDeviceState;
    let text = Text { count: lostr, room: istr_length, text: istr };
    let outputs = ((mode, esw), text, (pet, earea), (buflen, inipos), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let state = gks.inquire_string_device_state(wkid.get(), stdnr.get())?;
        let sizes = (buffer(&state.detail), cursor(&state.detail));
        Ok(((state.mode, state.echo), state.initial, (state.prompt, state.area), sizes, state.record))
    });
}

/// GQSTSS: INQUIRE STRING DEVICE STATE, for a string of 80 characters.
#[unsafe(no_mangle)]
extern "C" fn gqstss_(
    wkid: Integer,
    stdnr: Integer,
    mldr: Integer,
    errind: Integer,
    mode: Integer,
    esw: Integer,
    lostr: Integer,
    istr: Character,
    pet: Integer,
    earea: Array<f32, 4>,
    buflen: Integer,
    inipos: Integer,
    ldr: Integer,
    datrec: Character,
    istr_length: usize,
    datrec_length: usize,
) {
    gqsts_(
        wkid,
        stdnr,
        mldr,
        errind,
        mode,
        esw,
        lostr,
        istr,
        pet,
        earea,
        buflen,
        inipos,
        ldr,
        datrec,
        istr_length,
        datrec_length,
    );
}

/// GQDLC: INQUIRE DEFAULT LOCATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdlc_(
    wtype: Integer,
    devno: Integer,
    n: Integer,
    mldr: Integer,
    errind: Integer,
    dpx: Real,
    dpy: Real,
    ol: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireDefaultLocatorDeviceData;
    let outputs = ((dpx, dpy), ((ol, pet), earea), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let device = gks.inquire_default_locator_device_data(wtype.get(), devno.get())?;
        Ok((device.initial.position, prompting(&device, n), device.record))
    });
}

/// GQDSK: INQUIRE DEFAULT STROKE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdsk_(
    wtype: Integer,
    devno: Integer,
    n: Integer,
    mldr: Integer,
    errind: Integer,
    dbufsk: Integer,
    ol: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    buflen: Integer,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireDefaultStrokeDeviceData;
    let outputs = (dbufsk, ((ol, pet), earea), buflen, record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let device = gks.inquire_default_stroke_device_data(wtype.get(), devno.get())?;
        let size = buffer(&device.detail);
        Ok((device.greatest_buffer, prompting(&device, n), size, device.record))
    });
}

/// GQDVL: INQUIRE DEFAULT VALUATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdvl_(
    wtype: Integer,
    devno: Integer,
    n: Integer,
    mldr: Integer,
    errind: Integer,
    dval: Real,
    ol: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    loval: Real,
    hival: Real,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireDefaultValuatorDeviceData;
    let outputs = (dval, ((ol, pet), earea), (loval, hival), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let device = gks.inquire_default_valuator_device_data(wtype.get(), devno.get())?;
        Ok((device.initial, prompting(&device, n), limits(&device.detail), device.record))
    });
}

/// GQDCH: INQUIRE DEFAULT CHOICE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdch_(
    wtype: Integer,
    devno: Integer,
    n: Integer,
    mldr: Integer,
    errind: Integer,
    malt: Integer,
    ol: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireDefaultChoiceDeviceData;
    let outputs = (malt, ((ol, pet), earea), record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let device = gks.inquire_default_choice_device_data(wtype.get(), devno.get())?;
        Ok((alternatives(&device.detail), prompting(&device, n), device.record))
    });
}

/// GQDPK: INQUIRE DEFAULT PICK DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdpk_(
    wtype: Integer,
    devno: Integer,
    n: Integer,
    mldr: Integer,
    errind: Integer,
    ol: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireDefaultPickDeviceData;
    answer(F, errind, (((ol, pet), earea), record(mldr, ldr, datrec)), |gks| {
        let device = gks.inquire_default_pick_device_data(wtype.get(), devno.get())?;
        Ok((prompting(&device, n), device.record))
    });
}

/// GQDST: INQUIRE DEFAULT STRING DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdst_(
    wtype: Integer,
    devno: Integer,
    n: Integer,
    mldr: Integer,
    errind: Integer,
    mbuff: Integer,
    ol: Integer,
    pet: Integer,
    earea: Array<f32, 4>,
    buflen: Integer,
    ldr: Integer,
    datrec: Character,
    _length: usize,
) {
    const F: Function = Function::InquireDefaultStringDeviceData;
    let outputs = (mbuff, ((ol, pet), earea), buflen, record(mldr, ldr, datrec));
    answer(F, errind, outputs, |gks| {
        let device = gks.inquire_default_string_device_data(wtype.get(), devno.get())?;
        let size = buffer(&device.detail);
        Ok((device.greatest_buffer, prompting(&device, n), size, device.record))
    });
}
