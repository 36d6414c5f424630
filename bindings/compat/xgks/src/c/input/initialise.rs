//! INITIALISE and SET MODE.

use super::super::argument::{Address, call, choice};
use super::super::types::{Gchar, Gchoice, Gint, Glimit, Gloc, Gpick, Gstroke, Promoted};
use super::record::{self, Gchoicerec, Glocrec, Gpickrec, Gstringrec, Gstrokerec, Gvalrec};
use super::{NOTHING, OK};
use gks::{DataRecord, Error, Function, Gks, InputStatus, OperatingMode};
use gks_geometry::{Dc, Rect};

/// An echo area. Programs may give it in the device coordinates of XGKS, which count up to a thousand and more: what ends
/// beyond the display surface is all of the surface.
fn echo_area(gks: &Gks, ws_id: Gint, area: Address<Glimit>, function: Function) -> gks::Result<Rect<Dc>> {
    let area: Rect<Dc> = area.get(function)?.into();
    let kind = gks.inquire_workstation_connection_and_type(ws_id).map(|(_, kind)| kind);
    let Ok(size) = kind.and_then(|kind| gks.inquire_display_space_size(kind)) else { return Ok(area) };
    let surface = Rect::new(0.0, size.metres.0, 0.0, size.metres.1);
    Ok(if area.is_proper() && area.meets(&surface) && !surface.contains_rect(&area) { surface } else { area })
}

/// The status that a choice or a pick is initialised with. Error: 152.
fn status(number: Gint, function: Function) -> gks::Result<InputStatus> {
    match number {
        OK => Ok(InputStatus::Ok),
        NOTHING => Ok(InputStatus::NoInput),
        _ => Err(Error::new(152, function).because(format!("status {number}"))),
    }
}

fn no_record(function: Function) -> Error {
    Error::new(146, function).because("no data record")
}

/// INITIALISE LOCATOR. A null pointer is an empty data record, here and for choice devices.
#[unsafe(no_mangle)]
extern "C" fn ginitloc(
    ws_id: Gint,
    dev: Gint,
    init: Address<Gloc>,
    pet: Gint,
    area: Address<Glimit>,
    data: Address<Glocrec>,
) -> Gint {
    const F: Function = Function::InitialiseLocator;
    call(F, |gks| {
        let Gloc { transform, position } = init.get(F)?;
        let area = echo_area(gks, ws_id, area, F)?;
        gks.initialise_locator(ws_id, dev, transform, position, pet, area, &record::locator(pet, data))
    })
}

/// INITIALISE STROKE. The data record says how large the buffer is.
#[unsafe(no_mangle)]
extern "C" fn ginitstroke(
    ws_id: Gint,
    dev: Gint,
    init: Address<Gstroke>,
    pet: Gint,
    area: Address<Glimit>,
    data: Address<Gstrokerec>,
) -> Gint {
    const F: Function = Function::InitialiseStroke;
    call(F, |gks| {
        let Gstroke { transform, n_points, points } = init.get(F)?;
        let points: Vec<(f64, f64)> = Address::at(points).array(n_points).iter().map(|&p| p.into()).collect();
        let area = echo_area(gks, ws_id, area, F)?;
        let (data, buffer) = record::stroke(pet, data).ok_or_else(|| no_record(F))?;
        gks.initialise_stroke(ws_id, dev, transform, &points, pet, area, buffer, &data)
    })
}

/// INITIALISE VALUATOR.
#[unsafe(no_mangle)]
extern "C" fn ginitval(
    ws_id: Gint,
    dev: Gint,
    init: Promoted,
    pet: Gint,
    area: Address<Glimit>,
    data: Address<Gvalrec>,
) -> Gint {
    const F: Function = Function::InitialiseValuator;
    call(F, |gks| {
        let area = echo_area(gks, ws_id, area, F)?;
        let Gvalrec { low, high, .. } = data.value().ok_or_else(|| no_record(F))?;
        let (low, high, none) = (low.into(), high.into(), DataRecord::default());
        gks.initialise_valuator(ws_id, dev, init, pet, area, low, high, &none)
    })
}

/// INITIALISE CHOICE.
#[unsafe(no_mangle)]
extern "C" fn ginitchoice(
    ws_id: Gint,
    dev: Gint,
    init: Address<Gchoice>,
    pet: Gint,
    area: Address<Glimit>,
    data: Address<Gchoicerec>,
) -> Gint {
    const F: Function = Function::InitialiseChoice;
    call(F, |gks| {
        let init = init.get(F)?;
        let area = echo_area(gks, ws_id, area, F)?;
        let data = record::choice(pet, data);
        gks.initialise_choice(ws_id, dev, status(init.status, F)?, init.choice, pet, area, &data)
    })
}

/// INITIALISE PICK.
#[unsafe(no_mangle)]
extern "C" fn ginitpick(
    ws_id: Gint,
    dev: Gint,
    init: Address<Gpick>,
    pet: Gint,
    area: Address<Glimit>,
    _data: Address<Gpickrec>,
) -> Gint {
    const F: Function = Function::InitialisePick;
    call(F, |gks| {
        let init = init.get(F)?;
        let (area, none) = (echo_area(gks, ws_id, area, F)?, DataRecord::default());
        gks.initialise_pick(ws_id, dev, status(init.status, F)?, init.seg, init.pickid, pet, area, &none)
    })
}

/// INITIALISE STRING. The data record says how large the buffer is, and where the cursor is.
#[unsafe(no_mangle)]
extern "C" fn ginitstring(
    ws_id: Gint,
    dev: Gint,
    init: Address<Gchar>,
    pet: Gint,
    area: Address<Glimit>,
    data: Address<Gstringrec>,
) -> Gint {
    const F: Function = Function::InitialiseString;
    call(F, |gks| {
        let area = echo_area(gks, ws_id, area, F)?;
        let Gstringrec { bufsiz, position, .. } = data.value().ok_or_else(|| no_record(F))?;
        // The kernel does not read it; that there is one tells this device from one that was not initialised.
        let given = DataRecord { integers: vec![bufsiz, position], ..DataRecord::default() };
        gks.initialise_string(ws_id, dev, &init.text(), pet, area, bufsiz, position, &given)
    })
}

macro_rules! modes {
    ($($name:ident $function:ident $method:ident)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`, where 0 is to echo.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_id: Gint, dev: Gint, mode: Gint, echo: Gint) -> Gint {
            const F: Function = Function::$function;
            call(F, |gks| {
                let mode = choice(OperatingMode::from_number(mode), F)?;
                gks.$method(ws_id, dev, mode, choice((0..=1).contains(&echo).then_some(echo == 0), F)?)
            })
        }
    )+ };
}

modes! {
    gsetlocmode SetLocatorMode set_locator_mode
    gsetstrokemode SetStrokeMode set_stroke_mode
    gsetvalmode SetValuatorMode set_valuator_mode
    gsetchoicemode SetChoiceMode set_choice_mode
    gsetpickmode SetPickMode set_pick_mode
    gsetstringmode SetStringMode set_string_mode
}
