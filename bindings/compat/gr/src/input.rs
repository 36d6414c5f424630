//! Input in mode REQUEST, and items of metafiles.

use crate::argument::{Address, call, inquire, integer, outcome};
use crate::classic::Gpoint;
use gks::{DataRecord, Function, Gks, InputStatus};
use std::ffi::{c_char, c_int};

/// INITIALISE LOCATOR, without a data record.
#[unsafe(no_mangle)]
extern "C" fn gks_initialize_locator(
    ws_id: c_int,
    device: c_int,
    transformation: c_int,
    x: f64,
    y: f64,
    prompt: c_int,
    xmin: f64,
    xmax: f64,
    ymin: f64,
    ymax: f64,
    _length: c_int,
    _record: *const c_char,
) {
    call(Function::InitialiseLocator, |gks| {
        let (area, none) = ((xmin, xmax, ymin, ymax), DataRecord::default());
        gks.initialise_locator(ws_id, device, transformation, (x, y), prompt, area, &none)
    });
}

/// Runs a REQUEST, which sets what it gives by `set`; the status is 0 where it gives nothing.
fn request<V>(
    function: Function,
    status: Address<c_int>,
    ask: impl FnOnce(&mut Gks) -> gks::Result<Option<V>>,
    set: impl FnOnce(V),
) {
    status.set(InputStatus::None as c_int);
    call(function, |gks| {
        if let Some(value) = ask(gks)? {
            status.set(InputStatus::Ok as c_int);
            set(value);
        }
        Ok(())
    });
}

/// REQUEST LOCATOR.
#[unsafe(no_mangle)]
extern "C" fn gks_request_locator(
    ws_id: c_int,
    device: c_int,
    status: Address<c_int>,
    transformation: Address<c_int>,
    x: Address<f64>,
    y: Address<f64>,
) {
    request(
        Function::RequestLocator,
        status,
        |gks| gks.request_locator(ws_id, device),
        |value| {
            transformation.set(value.transformation);
            x.set(value.position.x());
            y.set(value.position.y());
        },
    );
}

/// REQUEST STROKE, of at most a number of points.
#[unsafe(no_mangle)]
extern "C" fn gks_request_stroke(
    ws_id: c_int,
    device: c_int,
    room: c_int,
    status: Address<c_int>,
    transformation: Address<c_int>,
    count: Address<c_int>,
    x: Address<f64>,
    y: Address<f64>,
) {
    request(
        Function::RequestStroke,
        status,
        |gks| gks.request_stroke(ws_id, device),
        |value| {
            let points = value.points.get(..usize::try_from(room).unwrap_or(0)).unwrap_or(&value.points);
            transformation.set(value.transformation);
            count.set(integer(points.len()));
            x.set_all(points.iter().map(|p| p.x()));
            y.set_all(points.iter().map(|p| p.y()));
        },
    );
}

/// REQUEST CHOICE. The number is 0 where nothing is chosen.
#[unsafe(no_mangle)]
extern "C" fn gks_request_choice(
    ws_id: c_int,
    device: c_int,
    status: Address<c_int>,
    number: Address<c_int>,
) {
    request(
        Function::RequestChoice,
        status,
        |gks| gks.request_choice(ws_id, device),
        |value| {
            number.set(value.unwrap_or(0));
        },
    );
}

/// The bytes that programs have room for in a string, with the zero byte at its end.
const STRING: usize = 256;

fn set_string(value: &str, length: Address<c_int>, text: Address<c_char>) {
    let most = value.len().min(STRING - 1);
    let end = (0..=most).rev().find(|&end| value.is_char_boundary(end)).unwrap_or(0);
    length.set(integer(end));
    text.set_all(value.as_bytes()[..end].iter().map(|&byte| byte as c_char).chain([0]));
}

/// REQUEST STRING, and its length. The program has room for 256 bytes.
#[unsafe(no_mangle)]
extern "C" fn gks_request_string(
    ws_id: c_int,
    device: c_int,
    status: Address<c_int>,
    length: Address<c_int>,
    text: Address<c_char>,
) {
    request(
        Function::RequestString,
        status,
        |gks| gks.request_string(ws_id, device),
        |value| {
            set_string(&value, length, text);
        },
    );
}

/// `Gqloc`: a status, which is 0 for a value and 1 for none, and a position.
#[repr(C)]
#[derive(Copy, Clone, Debug)]
struct Gqloc {
    status: c_int,
    transform: c_int,
    position: Gpoint,
}

/// The status of the C names of 1988.
const OK: c_int = 0;
const NONE: c_int = 1;

/// REQUEST LOCATOR, by its C name of 1988.
#[unsafe(no_mangle)]
extern "C" fn greqloc(ws_id: c_int, device: c_int, response: Address<Gqloc>) -> c_int {
    outcome(|| {
        let (mut status, mut transform, mut x, mut y) = (0, 0, 0.0, 0.0);
        let (status_to, transform_to) = (Address::of(&mut status), Address::of(&mut transform));
        gks_request_locator(ws_id, device, status_to, transform_to, Address::of(&mut x), Address::of(&mut y));
        let status = if status == InputStatus::Ok as c_int { OK } else { NONE };
        response.set(Gqloc { status, transform, position: Gpoint { x, y } });
    })
}

/// `Gqstring`: a status, and where the text goes.
#[repr(C)]
#[derive(Copy, Clone, Debug)]
struct Gqstring {
    status: c_int,
    string: *mut c_char,
}

/// REQUEST STRING, by its C name of 1988.
#[unsafe(no_mangle)]
extern "C" fn greqstring(ws_id: c_int, device: c_int, response: Address<Gqstring>) -> c_int {
    outcome(|| {
        let Some(given) = response.slice(1).first().copied() else { return };
        let (mut status, mut length) = (0, 0);
        let (status_to, length_to) = (Address::of(&mut status), Address::of(&mut length));
        gks_request_string(ws_id, device, status_to, length_to, Address::at(given.string));
        let status = if status == InputStatus::Ok as c_int { OK } else { NONE };
        response.set(Gqstring { status, ..given });
    })
}

/// GET ITEM TYPE FROM GKSM.
#[unsafe(no_mangle)]
extern "C" fn gks_get_item(ws_id: c_int, kind: Address<c_int>, length: Address<c_int>) {
    call(Function::GetItemTypeFromGksm, |gks| {
        let (found, bytes) = gks.get_item_type_from_gksm(ws_id)?;
        kind.set(found);
        length.set(integer(bytes));
        Ok(())
    });
}

/// READ ITEM FROM GKSM, into room for a number of bytes.
#[unsafe(no_mangle)]
extern "C" fn gks_read_item(ws_id: c_int, length: c_int, room: c_int, to: Address<u8>) {
    call(Function::ReadItemFromGksm, |gks| {
        to.set_all(gks.read_item_from_gksm(ws_id, length.min(room))?);
        Ok(())
    });
}

/// INTERPRET ITEM.
#[unsafe(no_mangle)]
extern "C" fn gks_interpret_item(kind: c_int, length: c_int, room: c_int, from: Address<u8>) {
    call(Function::InterpretItem, |gks| gks.interpret_item_of(kind, length, from.array(room)));
}

/// INQUIRE SET OF SEGMENT NAMES ON WORKSTATION: how many there are, and the n-th one.
#[unsafe(no_mangle)]
extern "C" fn gks_inq_segn_ws(
    ws_id: c_int,
    n: c_int,
    error: Address<c_int>,
    length: Address<c_int>,
    name: Address<c_int>,
) {
    inquire(Function::InquireSetOfSegmentNamesOnWorkstation, error, |gks| {
        let names: Vec<c_int> = gks.inquire_set_of_segment_names_on_workstation(ws_id)?.collect();
        length.set(integer(names.len()));
        let found = usize::try_from(n - 1).ok().and_then(|at| names.get(at));
        name.set(found.copied().unwrap_or(0));
        Ok(())
    });
}
