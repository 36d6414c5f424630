//! Inquiries of input devices: their state, and what the workstation description table says about them.
//!
//! Lists, points and strings are allocated and belong to the program.

use super::super::argument::{Address, allocated_text, choice, inquire, integer, list};
use super::super::control::kind;
use super::super::types::{
    Gchar, Gchoice, Gfloat, Gint, Gintlist, Glimit, Gloc, Gnumdev, Gpick, Gpoint, Gstroke,
};
use super::record::{self, Gchoicerec, Glocrec, Gpickrec, Gstringrec, Gstrokerec, Gvalrec, NO_DATA};
use super::{STRING_BUFFER, STROKE_BUFFER, allocated_stroke, buffer, real};
use gks::{DataRecord, DefaultDevice, Detail, DeviceState, Function, ValueType};

/// The state of a device, with an initial value and a data record as its class has them.
#[repr(C)]
#[derive(Copy, Clone)]
struct State<V, R> {
    mode: Gint,
    esw: Gint,
    initial: V,
    pet: Gint,
    e_area: Glimit,
    record: R,
}

impl<V, R> State<V, R> {
    fn new<K>(state: &DeviceState<K>, initial: V, record: R) -> Self {
        State {
            mode: state.mode as Gint,
            esw: (!state.echo).into(),
            initial,
            pet: state.prompt,
            e_area: state.area.into(),
            record,
        }
    }
}

/// What the workstation description table says about a device, with what comes first and a data record as its class has
/// them.
#[repr(C)]
#[derive(Copy, Clone)]
struct Usual<V, R> {
    first: V,
    pets: Gintlist,
    e_area: Glimit,
    record: R,
}

impl<V, R> Usual<V, R> {
    fn new<K>(device: &DefaultDevice<K>, first: V, record: R) -> Self {
        let pets = list(device.prompts.iter().copied());
        Usual { first, pets, e_area: device.area.into(), record }
    }
}

/// Pick devices have nothing before the list of prompt and echo types.
type Nothing = [Gint; 0];

/// The data record of a valuator.
fn limits(detail: &Detail) -> Gvalrec {
    let (low, high) = match detail {
        Detail::Valuator { low, high } => (*low, *high),
        _ => (0.0, 0.0),
    };
    Gvalrec { low: real(low), high: real(high), data: NO_DATA }
}

/// The data record of a string device.
fn cursor(detail: &Detail, bufsiz: Gint) -> Gstringrec {
    let position = match detail {
        Detail::String { cursor, .. } => integer(*cursor),
        _ => 1,
    };
    Gstringrec { bufsiz, position, data: NO_DATA }
}

/// Inquiries of states, which have a type of the values or not.
macro_rules! states {
    ($($name:ident($of:ident $value:ty, $record:ty) $function:ident => |$state:ident = $method:ident| $initial:expr, $data:expr;)+) => {
        $( states! { $of $name($value, $record) $function => |$state = $method| $initial, $data; } )+
    };
    (typed $name:ident($value:ty, $record:ty) $function:ident => |$state:ident = $method:ident| $initial:expr, $data:expr;) => {
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_id: Gint, dev: Gint, of: Gint, to: Address<State<$value, $record>>) -> Gint {
            const F: Function = Function::$function;
            inquire(F, |gks| {
                let $state = gks.$method(ws_id, dev, choice(ValueType::from_number(of), F)?)?;
                to.set(State::new(&$state, $initial, $data));
                Ok(())
            })
        }
    };
    (untyped $name:ident($value:ty, $record:ty) $function:ident => |$state:ident = $method:ident| $initial:expr, $data:expr;) => {
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_id: Gint, dev: Gint, to: Address<State<$value, $record>>) -> Gint {
            inquire(Function::$function, |gks| {
                let $state = gks.$method(ws_id, dev)?;
                to.set(State::new(&$state, $initial, $data));
                Ok(())
            })
        }
    };
}

states! {
    ginqlocst(typed Gloc, Glocrec) InquireLocatorDeviceState => |state = inquire_locator_device_state|
        state.initial.into(), record::of_locator(state.prompt, &state.record);
    ginqstrokest(typed Gstroke, Gstrokerec) InquireStrokeDeviceState => |state = inquire_stroke_device_state|
        allocated_stroke(&state.initial),
        record::of_stroke(state.prompt, buffer(&state, STROKE_BUFFER), &state.record);
    ginqvalst(untyped Gfloat, Gvalrec) InquireValuatorDeviceState => |state = inquire_valuator_device_state|
        real(state.initial), limits(&state.detail);
    ginqchoicest(untyped Gchoice, Gchoicerec) InquireChoiceDeviceState => |state = inquire_choice_device_state|
        state.initial.into(), record::of_choice(state.prompt, &state.record);
    ginqpickst(typed Gpick, Gpickrec) InquirePickDeviceState => |state = inquire_pick_device_state|
        state.initial.into(), Gpickrec { data: NO_DATA };
    ginqstringst(untyped *mut Gchar, Gstringrec) InquireStringDeviceState => |state = inquire_string_device_state|
        allocated_text(&state.initial), cursor(&state.detail, buffer(&state, STRING_BUFFER));
}

/// Inquiries of the workstation description table.
macro_rules! usual {
    ($($name:ident($first:ty, $record:ty) $function:ident => |$device:ident = $method:ident| $value:expr, $data:expr;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_type: Address<Gchar>, dev: Gint, to: Address<Usual<$first, $record>>) -> Gint {
            inquire(Function::$function, |gks| {
                let $device = gks.$method(kind(ws_type), dev)?;
                to.set(Usual::new(&$device, $value, $data));
                Ok(())
            })
        }
    )+ };
}

usual! {
    ginqdefloc(Gpoint, Glocrec) InquireDefaultLocatorDeviceData
        => |device = inquire_default_locator_device_data|
        device.initial.position.into(), record::of_locator(1, &device.record);
    ginqdefstroke(Gint, Gstrokerec) InquireDefaultStrokeDeviceData
        => |device = inquire_default_stroke_device_data|
        STROKE_BUFFER, record::of_stroke(1, STROKE_BUFFER, &device.record);
    ginqdefval(Gfloat, Gvalrec) InquireDefaultValuatorDeviceData
        => |device = inquire_default_valuator_device_data|
        real(device.initial), limits(&device.detail);
    ginqdefchoice(Gint, Gchoicerec) InquireDefaultChoiceDeviceData
        => |device = inquire_default_choice_device_data|
        alternatives(&device.detail), record::of_choice(1, &DataRecord::default());
    ginqdefpick(Nothing, Gpickrec) InquireDefaultPickDeviceData
        => |device = inquire_default_pick_device_data|
        [], Gpickrec { data: NO_DATA };
    ginqdefstring(Gint, Gstringrec) InquireDefaultStringDeviceData
        => |device = inquire_default_string_device_data|
        STRING_BUFFER, cursor(&device.detail, STRING_BUFFER);
}

/// How many alternatives a choice device has.
fn alternatives(detail: &Detail) -> Gint {
    match detail {
        Detail::Choice { alternatives, .. } => *alternatives,
        _ => 0,
    }
}

/// INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES.
#[unsafe(no_mangle)]
extern "C" fn ginqnumavailinput(ws_type: Address<Gchar>, number: Address<Gnumdev>) -> Gint {
    inquire(Function::InquireNumberOfAvailableLogicalInputDevices, |gks| {
        let counts = gks.inquire_number_of_available_logical_input_devices(kind(ws_type))?;
        let [locator, stroke, valuator, choice, pick, string] = counts.map(integer);
        number.set(Gnumdev { locator, stroke, valuator, choice, pick, string });
        Ok(())
    })
}
