//! The subroutines of the levels of GKS that are not built yet.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

use crate::argument::{Character, Integer, Real};
use crate::data_record::LINE;
use crate::unbuilt::{refusal, refuse};
use gks::Function;

/// GSPKID: SET PICK IDENTIFIER.
#[unsafe(no_mangle)]
extern "C" fn gspkid_(_pkid: Integer) {
    refuse(Function::SetPickIdentifier);
}

/// GINLC: INITIALISE LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn ginlc_(_wkid: Integer, _lcdnr: Integer, _tnr: Integer, _ipx: Real, _ipy: Real, _pet: Integer, _xmin: Real, _xmax: Real, _ymin: Real, _ymax: Real, _ldr: Integer, _datrec: Character, _datrec_length: usize) {
    refuse(Function::InitialiseLocator);
}

/// GINSK: INITIALISE STROKE.
#[unsafe(no_mangle)]
extern "C" fn ginsk_(_wkid: Integer, _skdnr: Integer, _tnr: Integer, _n: Integer, _ipx: Real, _ipy: Real, _pet: Integer, _xmin: Real, _xmax: Real, _ymin: Real, _ymax: Real, _buflen: Integer, _ldr: Integer, _datrec: Character, _datrec_length: usize) {
    refuse(Function::InitialiseStroke);
}

/// GINVL: INITIALISE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn ginvl_(_wkid: Integer, _vldnr: Integer, _ival: Real, _pet: Integer, _xmin: Real, _xmax: Real, _ymin: Real, _ymax: Real, _loval: Real, _hival: Real, _ldr: Integer, _datrec: Character, _datrec_length: usize) {
    refuse(Function::InitialiseValuator);
}

/// GINCH: INITIALISE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn ginch_(_wkid: Integer, _chdnr: Integer, _istat: Integer, _ichnr: Integer, _pet: Integer, _xmin: Real, _xmax: Real, _ymin: Real, _ymax: Real, _ldr: Integer, _datrec: Character, _datrec_length: usize) {
    refuse(Function::InitialiseChoice);
}

/// GINPK: INITIALISE PICK.
#[unsafe(no_mangle)]
extern "C" fn ginpk_(_wkid: Integer, _pkdnr: Integer, _istat: Integer, _isgna: Integer, _ipkid: Integer, _pet: Integer, _xmin: Real, _xmax: Real, _ymin: Real, _ymax: Real, _ldr: Integer, _datrec: Character, _datrec_length: usize) {
    refuse(Function::InitialisePick);
}

/// GINST: INITIALISE STRING.
#[unsafe(no_mangle)]
extern "C" fn ginst_(_wkid: Integer, _stdnr: Integer, _lstr: Integer, _istr: Character, _pet: Integer, _xmin: Real, _xmax: Real, _ymin: Real, _ymax: Real, _buflen: Integer, _inipos: Integer, _ldr: Integer, _datrec: Character, _istr_length: usize, _datrec_length: usize) {
    refuse(Function::InitialiseString);
}

/// GINSTS: INITIALISE STRING.
#[unsafe(no_mangle)]
extern "C" fn ginsts_(_wkid: Integer, _stdnr: Integer, _lstr: Integer, _istr: Character, _pet: Integer, _xmin: Real, _xmax: Real, _ymin: Real, _ymax: Real, _buflen: Integer, _inipos: Integer, _ldr: Integer, _datrec: Character, _istr_length: usize, _datrec_length: usize) {
    refuse(Function::InitialiseString);
}

/// GSLCM: SET LOCATOR MODE.
#[unsafe(no_mangle)]
extern "C" fn gslcm_(_wkid: Integer, _lcdnr: Integer, _mode: Integer, _esw: Integer) {
    refuse(Function::SetLocatorMode);
}

/// GSSKM: SET STROKE MODE.
#[unsafe(no_mangle)]
extern "C" fn gsskm_(_wkid: Integer, _skdnr: Integer, _mode: Integer, _esw: Integer) {
    refuse(Function::SetStrokeMode);
}

/// GSVLM: SET VALUATOR MODE.
#[unsafe(no_mangle)]
extern "C" fn gsvlm_(_wkid: Integer, _vldnr: Integer, _mode: Integer, _esw: Integer) {
    refuse(Function::SetValuatorMode);
}

/// GSCHM: SET CHOICE MODE.
#[unsafe(no_mangle)]
extern "C" fn gschm_(_wkid: Integer, _chdnr: Integer, _mode: Integer, _esw: Integer) {
    refuse(Function::SetChoiceMode);
}

/// GSPKM: SET PICK MODE.
#[unsafe(no_mangle)]
extern "C" fn gspkm_(_wkid: Integer, _pkdnr: Integer, _mode: Integer, _esw: Integer) {
    refuse(Function::SetPickMode);
}

/// GSSTM: SET STRING MODE.
#[unsafe(no_mangle)]
extern "C" fn gsstm_(_wkid: Integer, _stdnr: Integer, _mode: Integer, _esw: Integer) {
    refuse(Function::SetStringMode);
}

/// GRQLC: REQUEST LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn grqlc_(_wkid: Integer, _lcdnr: Integer, stat: Integer, tnr: Integer, px: Real, py: Real) {
    stat.fill(1, 0);
    tnr.fill(1, 0);
    px.fill(1, 0.0);
    py.fill(1, 0.0);
    refuse(Function::RequestLocator);
}

/// GRQSK: REQUEST STROKE.
#[unsafe(no_mangle)]
extern "C" fn grqsk_(_wkid: Integer, _skdnr: Integer, n: Integer, stat: Integer, tnr: Integer, np: Integer, pxa: Real, pya: Real) {
    stat.fill(1, 0);
    tnr.fill(1, 0);
    np.fill(1, 0);
    pxa.fill(n.count(), 0.0);
    pya.fill(n.count(), 0.0);
    refuse(Function::RequestStroke);
}

/// GRQVL: REQUEST VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn grqvl_(_wkid: Integer, _vldnr: Integer, stat: Integer, val: Real) {
    stat.fill(1, 0);
    val.fill(1, 0.0);
    refuse(Function::RequestValuator);
}

/// GRQCH: REQUEST CHOICE.
#[unsafe(no_mangle)]
extern "C" fn grqch_(_wkid: Integer, _chdnr: Integer, stat: Integer, chnr: Integer) {
    stat.fill(1, 0);
    chnr.fill(1, 0);
    refuse(Function::RequestChoice);
}

/// GRQPK: REQUEST PICK.
#[unsafe(no_mangle)]
extern "C" fn grqpk_(_wkid: Integer, _pkdnr: Integer, stat: Integer, sgna: Integer, pkid: Integer) {
    stat.fill(1, 0);
    sgna.fill(1, 0);
    pkid.fill(1, 0);
    refuse(Function::RequestPick);
}

/// GRQST: REQUEST STRING.
#[unsafe(no_mangle)]
extern "C" fn grqst_(_wkid: Integer, _stdnr: Integer, stat: Integer, lostr: Integer, str: Character, str_length: usize) {
    stat.fill(1, 0);
    lostr.fill(1, 0);
    str.fill(str_length, b' ');
    refuse(Function::RequestString);
}

/// GRQSTS: REQUEST STRING.
#[unsafe(no_mangle)]
extern "C" fn grqsts_(_wkid: Integer, _stdnr: Integer, stat: Integer, lostr: Integer, str: Character, str_length: usize) {
    stat.fill(1, 0);
    lostr.fill(1, 0);
    str.fill(str_length, b' ');
    refuse(Function::RequestString);
}

/// GSMLC: SAMPLE LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gsmlc_(_wkid: Integer, _lcdnr: Integer, tnr: Integer, lpx: Real, lpy: Real) {
    tnr.fill(1, 0);
    lpx.fill(1, 0.0);
    lpy.fill(1, 0.0);
    refuse(Function::SampleLocator);
}

/// GSMSK: SAMPLE STROKE.
#[unsafe(no_mangle)]
extern "C" fn gsmsk_(_wkid: Integer, _skdnr: Integer, n: Integer, tnr: Integer, np: Integer, pxa: Real, pya: Real) {
    tnr.fill(1, 0);
    np.fill(1, 0);
    pxa.fill(n.count(), 0.0);
    pya.fill(n.count(), 0.0);
    refuse(Function::SampleStroke);
}

/// GSMVL: SAMPLE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn gsmvl_(_wkid: Integer, _vldnr: Integer, val: Real) {
    val.fill(1, 0.0);
    refuse(Function::SampleValuator);
}

/// GSMCH: SAMPLE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn gsmch_(_wkid: Integer, _chdnr: Integer, stat: Integer, chnr: Integer) {
    stat.fill(1, 0);
    chnr.fill(1, 0);
    refuse(Function::SampleChoice);
}

/// GSMPK: SAMPLE PICK.
#[unsafe(no_mangle)]
extern "C" fn gsmpk_(_wkid: Integer, _pkdnr: Integer, stat: Integer, sgna: Integer, pkid: Integer) {
    stat.fill(1, 0);
    sgna.fill(1, 0);
    pkid.fill(1, 0);
    refuse(Function::SamplePick);
}

/// GSMST: SAMPLE STRING.
#[unsafe(no_mangle)]
extern "C" fn gsmst_(_wkid: Integer, _stdnr: Integer, lostr: Integer, str: Character, str_length: usize) {
    lostr.fill(1, 0);
    str.fill(str_length, b' ');
    refuse(Function::SampleString);
}

/// GSMSTS: SAMPLE STRING.
#[unsafe(no_mangle)]
extern "C" fn gsmsts_(_wkid: Integer, _stdnr: Integer, lostr: Integer, str: Character, str_length: usize) {
    lostr.fill(1, 0);
    str.fill(str_length, b' ');
    refuse(Function::SampleString);
}

/// GWAIT: AWAIT EVENT.
#[unsafe(no_mangle)]
extern "C" fn gwait_(_tout: Real, wkid: Integer, icl: Integer, idnr: Integer) {
    wkid.fill(1, 0);
    icl.fill(1, 0);
    idnr.fill(1, 0);
    refuse(Function::AwaitEvent);
}

/// GFLUSH: FLUSH DEVICE EVENTS.
#[unsafe(no_mangle)]
extern "C" fn gflush_(_wkid: Integer, _icl: Integer, _idnr: Integer) {
    refuse(Function::FlushDeviceEvents);
}

/// GGTLC: GET LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn ggtlc_(tnr: Integer, lpx: Real, lpy: Real) {
    tnr.fill(1, 0);
    lpx.fill(1, 0.0);
    lpy.fill(1, 0.0);
    refuse(Function::GetLocator);
}

/// GGTSK: GET STROKE.
#[unsafe(no_mangle)]
extern "C" fn ggtsk_(n: Integer, tnr: Integer, np: Integer, pxa: Real, pya: Real) {
    tnr.fill(1, 0);
    np.fill(1, 0);
    pxa.fill(n.count(), 0.0);
    pya.fill(n.count(), 0.0);
    refuse(Function::GetStroke);
}

/// GGTVL: GET VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn ggtvl_(val: Real) {
    val.fill(1, 0.0);
    refuse(Function::GetValuator);
}

/// GGTCH: GET CHOICE.
#[unsafe(no_mangle)]
extern "C" fn ggtch_(stat: Integer, chnr: Integer) {
    stat.fill(1, 0);
    chnr.fill(1, 0);
    refuse(Function::GetChoice);
}

/// GGTPK: GET PICK.
#[unsafe(no_mangle)]
extern "C" fn ggtpk_(stat: Integer, sgna: Integer, pkid: Integer) {
    stat.fill(1, 0);
    sgna.fill(1, 0);
    pkid.fill(1, 0);
    refuse(Function::GetPick);
}

/// GGTST: GET STRING.
#[unsafe(no_mangle)]
extern "C" fn ggtst_(lostr: Integer, str: Character, str_length: usize) {
    lostr.fill(1, 0);
    str.fill(str_length, b' ');
    refuse(Function::GetString);
}

/// GGTSTS: GET STRING.
#[unsafe(no_mangle)]
extern "C" fn ggtsts_(lostr: Integer, str: Character, str_length: usize) {
    lostr.fill(1, 0);
    str.fill(str_length, b' ');
    refuse(Function::GetString);
}

/// GQPKID: INQUIRE CURRENT PICK IDENTIFIER VALUE.
#[unsafe(no_mangle)]
extern "C" fn gqpkid_(errind: Integer, pkid: Integer) {
    pkid.fill(1, 0);
    errind.set(refusal(Function::InquireCurrentPickIdentifierValue));
}

/// GQSIM: INQUIRE MORE SIMULTANEOUS EVENTS.
#[unsafe(no_mangle)]
extern "C" fn gqsim_(errind: Integer, flag: Integer) {
    flag.fill(1, 0);
    errind.set(refusal(Function::InquireMoreSimultaneousEvents));
}

/// GQLCS: INQUIRE LOCATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqlcs_(_wkid: Integer, _lcdnr: Integer, _type_: Integer, mldr: Integer, errind: Integer, mode: Integer, esw: Integer, tnr: Integer, ipx: Real, ipy: Real, pet: Integer, earea: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    mode.fill(1, 0);
    esw.fill(1, 0);
    tnr.fill(1, 0);
    ipx.fill(1, 0.0);
    ipy.fill(1, 0.0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireLocatorDeviceState));
}

/// GQSKS: INQUIRE STROKE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqsks_(_wkid: Integer, _skdnr: Integer, _type_: Integer, n: Integer, mldr: Integer, errind: Integer, mode: Integer, esw: Integer, itnr: Integer, np: Integer, pxa: Real, pya: Real, pet: Integer, earea: Real, buflen: Integer, ldr: Integer, datrec: Character, _datrec_length: usize) {
    mode.fill(1, 0);
    esw.fill(1, 0);
    itnr.fill(1, 0);
    np.fill(1, 0);
    pxa.fill(n.count(), 0.0);
    pya.fill(n.count(), 0.0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    buflen.fill(1, 0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireStrokeDeviceState));
}

/// GQVLS: INQUIRE VALUATOR DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqvls_(_wkid: Integer, _vldnr: Integer, mldr: Integer, errind: Integer, mode: Integer, esw: Integer, ival: Real, pet: Integer, earea: Real, loval: Real, hival: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    mode.fill(1, 0);
    esw.fill(1, 0);
    ival.fill(1, 0.0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    loval.fill(1, 0.0);
    hival.fill(1, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireValuatorDeviceState));
}

/// GQCHS: INQUIRE CHOICE DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqchs_(_wkid: Integer, _chdnr: Integer, mldr: Integer, errind: Integer, mode: Integer, esw: Integer, istat: Integer, ichnr: Integer, pet: Integer, earea: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    mode.fill(1, 0);
    esw.fill(1, 0);
    istat.fill(1, 0);
    ichnr.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireChoiceDeviceState));
}

/// GQPKS: INQUIRE PICK DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqpks_(_wkid: Integer, _pkdnr: Integer, _type_: Integer, mldr: Integer, errind: Integer, mode: Integer, esw: Integer, istat: Integer, isgna: Integer, ipkid: Integer, pet: Integer, earea: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    mode.fill(1, 0);
    esw.fill(1, 0);
    istat.fill(1, 0);
    isgna.fill(1, 0);
    ipkid.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquirePickDeviceState));
}

/// GQSTS: INQUIRE STRING DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqsts_(_wkid: Integer, _stdnr: Integer, mldr: Integer, errind: Integer, mode: Integer, esw: Integer, lostr: Integer, istr: Character, pet: Integer, earea: Real, buflen: Integer, inipos: Integer, ldr: Integer, datrec: Character, istr_length: usize, _datrec_length: usize) {
    mode.fill(1, 0);
    esw.fill(1, 0);
    lostr.fill(1, 0);
    istr.fill(istr_length, b' ');
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    buflen.fill(1, 0);
    inipos.fill(1, 0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireStringDeviceState));
}

/// GQSTSS: INQUIRE STRING DEVICE STATE.
#[unsafe(no_mangle)]
extern "C" fn gqstss_(_wkid: Integer, _stdnr: Integer, mldr: Integer, errind: Integer, mode: Integer, esw: Integer, lostr: Integer, istr: Character, pet: Integer, earea: Real, buflen: Integer, inipos: Integer, ldr: Integer, datrec: Character, istr_length: usize, _datrec_length: usize) {
    mode.fill(1, 0);
    esw.fill(1, 0);
    lostr.fill(1, 0);
    istr.fill(istr_length, b' ');
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    buflen.fill(1, 0);
    inipos.fill(1, 0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireStringDeviceState));
}

/// GQLI: INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES.
#[unsafe(no_mangle)]
extern "C" fn gqli_(_wtype: Integer, errind: Integer, nlcd: Integer, nskd: Integer, nvld: Integer, nchd: Integer, npcd: Integer, nstd: Integer) {
    nlcd.fill(1, 0);
    nskd.fill(1, 0);
    nvld.fill(1, 0);
    nchd.fill(1, 0);
    npcd.fill(1, 0);
    nstd.fill(1, 0);
    errind.set(refusal(Function::InquireNumberOfAvailableLogicalInputDevices));
}

/// GQDLC: INQUIRE DEFAULT LOCATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdlc_(_wtype: Integer, _devno: Integer, _n: Integer, mldr: Integer, errind: Integer, dpx: Real, dpy: Real, ol: Integer, pet: Integer, earea: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    dpx.fill(1, 0.0);
    dpy.fill(1, 0.0);
    ol.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireDefaultLocatorDeviceData));
}

/// GQDSK: INQUIRE DEFAULT STROKE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdsk_(_wtype: Integer, _devno: Integer, _n: Integer, mldr: Integer, errind: Integer, dbufsk: Integer, ol: Integer, pet: Integer, earea: Real, buflen: Integer, ldr: Integer, datrec: Character, _datrec_length: usize) {
    dbufsk.fill(1, 0);
    ol.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    buflen.fill(1, 0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireDefaultStrokeDeviceData));
}

/// GQDVL: INQUIRE DEFAULT VALUATOR DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdvl_(_wtype: Integer, _devno: Integer, _n: Integer, mldr: Integer, errind: Integer, dval: Real, ol: Integer, pet: Integer, earea: Real, loval: Real, hival: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    dval.fill(1, 0.0);
    ol.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    loval.fill(1, 0.0);
    hival.fill(1, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireDefaultValuatorDeviceData));
}

/// GQDCH: INQUIRE DEFAULT CHOICE DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdch_(_wtype: Integer, _devno: Integer, _n: Integer, mldr: Integer, errind: Integer, malt: Integer, ol: Integer, pet: Integer, earea: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    malt.fill(1, 0);
    ol.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireDefaultChoiceDeviceData));
}

/// GQDPK: INQUIRE DEFAULT PICK DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdpk_(_wtype: Integer, _devno: Integer, _n: Integer, mldr: Integer, errind: Integer, ol: Integer, pet: Integer, earea: Real, ldr: Integer, datrec: Character, _datrec_length: usize) {
    ol.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireDefaultPickDeviceData));
}

/// GQDST: INQUIRE DEFAULT STRING DEVICE DATA.
#[unsafe(no_mangle)]
extern "C" fn gqdst_(_wtype: Integer, _devno: Integer, _n: Integer, mldr: Integer, errind: Integer, mbuff: Integer, ol: Integer, pet: Integer, earea: Real, buflen: Integer, ldr: Integer, datrec: Character, _datrec_length: usize) {
    mbuff.fill(1, 0);
    ol.fill(1, 0);
    pet.fill(1, 0);
    earea.fill(4, 0.0);
    buflen.fill(1, 0);
    ldr.fill(1, 0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireDefaultStringDeviceData));
}

/// GQIQOV: INQUIRE INPUT QUEUE OVERFLOW.
#[unsafe(no_mangle)]
extern "C" fn gqiqov_(errind: Integer, wkid: Integer, icl: Integer, idn: Integer) {
    wkid.fill(1, 0);
    icl.fill(1, 0);
    idn.fill(1, 0);
    errind.set(refusal(Function::InquireInputQueueOverflow));
}
