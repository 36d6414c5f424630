//! Calls of input functions with one wrong argument, and the errors that they meet.

use crate::catalogue::DEVICES;
use crate::provocations::{Provocation, meets};
use crate::situation::WITH_OPERATOR;
use gks::Function::*;
use gks::{DataRecord, Gks, InputClass, InputStatus, Line, OperatingMode, Points, Result, ValueType};
use gks_pipeline::generated::numbers;

const AREA: (f64, f64, f64, f64) = (0.0, 0.1, 0.0, 0.1);
const FLAT: (f64, f64, f64, f64) = (0.0, 0.1, 0.1, 0.1);
const FAR: (f64, f64, f64, f64) = (0.0, 1.0, 0.0, 0.1);
const TWO_POINTS: Points<'static> = Points::Tuples(&[(0.5, 0.5), (0.7, 0.5)]);
const OUTSIDE: Points<'static> = Points::Tuples(&[(0.5, 0.5), (1.7, 0.5)]);
/// No device has this number.
const NONE: i32 = DEVICES as i32 + 1;
/// The device that is in mode SAMPLE.
const SAMPLED: i32 = 2;
/// What is no data record.
const GARBAGE: &[Line] = &[[b'x'; 80]];
/// No class has this prompt and echo type.
const STRANGE: i32 = 99;

type Limits = (f64, f64, f64, f64);

fn integers(integers: &[i32]) -> DataRecord {
    DataRecord::new(integers, &[], &[])
}

fn reals(reals: &[f64]) -> DataRecord {
    DataRecord::new(&[], reals, &[])
}

fn empty() -> DataRecord {
    DataRecord::default()
}

fn locator(g: &mut Gks, id: i32, number: i32, prompt: i32, area: Limits, record: &DataRecord) -> Result<()> {
    g.initialise_locator(id, number, 0, (0.5, 0.5), prompt, area, record)
}

fn stroke(g: &mut Gks, id: i32, number: i32, prompt: i32, area: Limits, record: &DataRecord) -> Result<()> {
    g.initialise_stroke(id, number, 0, TWO_POINTS, prompt, area, 2, record)
}

fn valuator(g: &mut Gks, id: i32, number: i32, prompt: i32, area: Limits, low: f64, high: f64) -> Result<()> {
    g.initialise_valuator(id, number, 0.5, prompt, area, low, high, &empty())
}

fn choice(g: &mut Gks, id: i32, number: i32, prompt: i32, area: Limits, record: &DataRecord) -> Result<()> {
    g.initialise_choice(id, number, InputStatus::Ok, 1, prompt, area, record)
}

fn pick(g: &mut Gks, id: i32, number: i32, prompt: i32, area: Limits, record: &DataRecord) -> Result<()> {
    g.initialise_pick(id, number, InputStatus::NoInput, 1, 1, prompt, area, record)
}

fn string(g: &mut Gks, id: i32, number: i32, prompt: i32, area: Limits, buffer: i32) -> Result<()> {
    g.initialise_string(id, number, "abc", prompt, area, buffer, 1, &empty())
}

/// Requests so often that the events of the devices in mode EVENT no longer fit into the queue.
fn overflow(g: &mut Gks) {
    for _ in 0..=numbers::MAX_QUEUED_EVENTS {
        g.request_choice(WITH_OPERATOR, 1).expect("the operator chooses");
    }
}

/// As [`overflow`], and the workstation is closed.
fn overflow_and_close(g: &mut Gks) {
    overflow(g);
    assert_eq!(g.close_workstation(WITH_OPERATOR).map_err(|error| error.number), Err(147));
    g.close_workstation(WITH_OPERATOR).expect("the overflow has been reported");
}

/// Wrong arguments of input functions.
pub(crate) static PROVOCATIONS: &[Provocation] = &[
    meets(97, SetPickIdentifier, |g, _| g.set_pick_identifier(-1)),
    // Initialising.
    meets(51, InitialiseLocator, |g, id| locator(g, id, 1, 1, FLAT, &empty())),
    meets(140, InitialiseLocator, |g, id| locator(g, id, NONE, 1, AREA, &empty())),
    meets(140, InitialiseLocator, |g, id| locator(g, id, 0, 1, AREA, &empty())),
    meets(140, InitialiseLocator, |g, id| locator(g, id, i32::MIN, 1, AREA, &empty())),
    meets(141, InitialiseLocator, |g, id| locator(g, id, SAMPLED, 1, AREA, &empty())),
    meets(144, InitialiseLocator, |g, id| locator(g, id, 1, STRANGE, AREA, &empty())),
    meets(145, InitialiseLocator, |g, id| locator(g, id, 1, 1, FAR, &empty())),
    meets(146, InitialiseLocator, |g, id| locator(g, id, 1, 4, AREA, &integers(&[2]))),
    meets(146, InitialiseLocator, |g, id| locator(g, id, 1, 5, AREA, &integers(&[0, -1]))),
    meets(146, InitialiseLocator, |g, id| g.initialise_locator(id, 1, 0, (0.5, 0.5), 1, AREA, GARBAGE)),
    meets(152, InitialiseLocator, |g, id| g.initialise_locator(id, 1, 0, (1.5, 0.5), 1, AREA, &empty())),
    meets(152, InitialiseLocator, |g, id| g.initialise_locator(id, 1, -1, (0.5, 0.5), 1, AREA, &empty())),
    meets(152, InitialiseLocator, |g, id| g.initialise_locator(id, 1, 0, (f64::NAN, 0.5), 1, AREA, &empty())),
    meets(51, InitialiseStroke, |g, id| stroke(g, id, 1, 1, FLAT, &empty())),
    meets(140, InitialiseStroke, |g, id| stroke(g, id, NONE, 1, AREA, &empty())),
    meets(141, InitialiseStroke, |g, id| stroke(g, id, SAMPLED, 1, AREA, &empty())),
    meets(144, InitialiseStroke, |g, id| stroke(g, id, 1, STRANGE, AREA, &empty())),
    meets(145, InitialiseStroke, |g, id| stroke(g, id, 1, 1, FAR, &empty())),
    meets(146, InitialiseStroke, |g, id| stroke(g, id, 1, 1, AREA, &reals(&[-1.0]))),
    meets(146, InitialiseStroke, |g, id| g.initialise_stroke(id, 1, 0, TWO_POINTS, 1, AREA, 0, &empty())),
    meets(152, InitialiseStroke, |g, id| g.initialise_stroke(id, 1, 0, OUTSIDE, 1, AREA, 2, &empty())),
    meets(152, InitialiseStroke, |g, id| g.initialise_stroke(id, 1, 999, TWO_POINTS, 1, AREA, 2, &empty())),
    meets(153, InitialiseStroke, |g, id| g.initialise_stroke(id, 1, 0, TWO_POINTS, 1, AREA, 1, &empty())),
    meets(51, InitialiseValuator, |g, id| valuator(g, id, 1, 1, FLAT, 0.0, 1.0)),
    meets(140, InitialiseValuator, |g, id| valuator(g, id, NONE, 1, AREA, 0.0, 1.0)),
    meets(141, InitialiseValuator, |g, id| valuator(g, id, SAMPLED, 1, AREA, 0.0, 1.0)),
    meets(144, InitialiseValuator, |g, id| valuator(g, id, 1, STRANGE, AREA, 0.0, 1.0)),
    meets(145, InitialiseValuator, |g, id| valuator(g, id, 1, 1, FAR, 0.0, 1.0)),
    meets(146, InitialiseValuator, |g, id| valuator(g, id, 1, 1, AREA, 1.0, 0.0)),
    meets(146, InitialiseValuator, |g, id| valuator(g, id, 1, 1, AREA, 0.0, f64::INFINITY)),
    meets(152, InitialiseValuator, |g, id| valuator(g, id, 1, 1, AREA, 0.6, 1.0)),
    meets(51, InitialiseChoice, |g, id| choice(g, id, 1, 1, FLAT, &empty())),
    meets(140, InitialiseChoice, |g, id| choice(g, id, NONE, 1, AREA, &empty())),
    meets(141, InitialiseChoice, |g, id| choice(g, id, SAMPLED, 1, AREA, &empty())),
    meets(144, InitialiseChoice, |g, id| choice(g, id, 1, STRANGE, AREA, &empty())),
    meets(145, InitialiseChoice, |g, id| choice(g, id, 1, 1, FAR, &empty())),
    meets(146, InitialiseChoice, |g, id| g.initialise_choice(id, 1, InputStatus::Ok, 1, 1, AREA, GARBAGE)),
    meets(146, InitialiseChoice, |g, id| choice(g, id, 1, 2, AREA, &empty())),
    meets(146, InitialiseChoice, |g, id| choice(g, id, 1, 3, AREA, &empty())),
    meets(146, InitialiseChoice, |g, id| choice(g, id, 1, 5, AREA, &integers(&[1]))),
    meets(152, InitialiseChoice, |g, id| {
        g.initialise_choice(id, 1, InputStatus::Ok, 3, 2, AREA, &integers(&[1, 1]))
    }),
    meets(152, InitialiseChoice, |g, id| g.initialise_choice(id, 1, InputStatus::Ok, 0, 1, AREA, &empty())),
    meets(152, InitialiseChoice, |g, id| g.initialise_choice(id, 1, InputStatus::None, 1, 1, AREA, &empty())),
    meets(51, InitialisePick, |g, id| pick(g, id, 1, 1, FLAT, &empty())),
    meets(140, InitialisePick, |g, id| pick(g, id, NONE, 1, AREA, &empty())),
    meets(141, InitialisePick, |g, id| pick(g, id, SAMPLED, 1, AREA, &empty())),
    meets(144, InitialisePick, |g, id| pick(g, id, 1, STRANGE, AREA, &empty())),
    meets(145, InitialisePick, |g, id| pick(g, id, 1, 1, FAR, &empty())),
    meets(146, InitialisePick, |g, id| pick(g, id, 1, 1, AREA, &reals(&[0.0]))),
    meets(152, InitialisePick, |g, id| g.initialise_pick(id, 1, InputStatus::Ok, 0, 1, 1, AREA, &empty())),
    meets(152, InitialisePick, |g, id| g.initialise_pick(id, 1, InputStatus::Ok, 1, -1, 1, AREA, &empty())),
    meets(152, InitialisePick, |g, id| g.initialise_pick(id, 1, InputStatus::None, 1, 1, 1, AREA, &empty())),
    meets(51, InitialiseString, |g, id| string(g, id, 1, 1, FLAT, 72)),
    meets(140, InitialiseString, |g, id| string(g, id, NONE, 1, AREA, 72)),
    meets(141, InitialiseString, |g, id| string(g, id, SAMPLED, 1, AREA, 72)),
    meets(144, InitialiseString, |g, id| string(g, id, 1, STRANGE, AREA, 72)),
    meets(145, InitialiseString, |g, id| string(g, id, 1, 1, FAR, 72)),
    meets(146, InitialiseString, |g, id| string(g, id, 1, 1, AREA, 0)),
    meets(152, InitialiseString, |g, id| g.initialise_string(id, 1, "abc", 1, AREA, 72, 0, &empty())),
    meets(152, InitialiseString, |g, id| g.initialise_string(id, 1, "abc", 1, AREA, 72, 5, &empty())),
    meets(154, InitialiseString, |g, id| string(g, id, 1, 1, AREA, 2)),
    // Modes.
    meets(140, SetLocatorMode, |g, id| g.set_locator_mode(id, NONE, OperatingMode::Request, true)),
    meets(140, SetStrokeMode, |g, id| g.set_stroke_mode(id, NONE, OperatingMode::Request, true)),
    meets(140, SetValuatorMode, |g, id| g.set_valuator_mode(id, NONE, OperatingMode::Request, true)),
    meets(140, SetChoiceMode, |g, id| g.set_choice_mode(id, NONE, OperatingMode::Request, true)),
    meets(140, SetPickMode, |g, id| g.set_pick_mode(id, NONE, OperatingMode::Request, true)),
    meets(140, SetStringMode, |g, id| g.set_string_mode(id, NONE, OperatingMode::Request, true)),
    // Requests and samples.
    meets(140, RequestLocator, |g, id| g.request_locator(id, NONE).map(drop)),
    meets(140, RequestStroke, |g, id| g.request_stroke(id, NONE).map(drop)),
    meets(140, RequestValuator, |g, id| g.request_valuator(id, NONE).map(drop)),
    meets(140, RequestChoice, |g, id| g.request_choice(id, NONE).map(drop)),
    meets(140, RequestPick, |g, id| g.request_pick(id, NONE).map(drop)),
    meets(140, RequestString, |g, id| g.request_string(id, NONE).map(drop)),
    meets(141, RequestLocator, |g, id| g.request_locator(id, SAMPLED).map(drop)),
    meets(141, RequestStroke, |g, id| g.request_stroke(id, SAMPLED).map(drop)),
    meets(141, RequestValuator, |g, id| g.request_valuator(id, SAMPLED).map(drop)),
    meets(141, RequestChoice, |g, id| g.request_choice(id, SAMPLED).map(drop)),
    meets(141, RequestPick, |g, id| g.request_pick(id, SAMPLED).map(drop)),
    meets(141, RequestString, |g, id| g.request_string(id, SAMPLED).map(drop)),
    meets(140, SampleLocator, |g, id| g.sample_locator(id, NONE).map(drop)),
    meets(140, SampleStroke, |g, id| g.sample_stroke(id, NONE).map(drop)),
    meets(140, SampleValuator, |g, id| g.sample_valuator(id, NONE).map(drop)),
    meets(140, SampleChoice, |g, id| g.sample_choice(id, NONE).map(drop)),
    meets(140, SamplePick, |g, id| g.sample_pick(id, NONE).map(drop)),
    meets(140, SampleString, |g, id| g.sample_string(id, NONE).map(drop)),
    meets(142, SampleLocator, |g, id| g.sample_locator(id, 1).map(drop)),
    meets(142, SampleStroke, |g, id| g.sample_stroke(id, 1).map(drop)),
    meets(142, SampleValuator, |g, id| g.sample_valuator(id, 1).map(drop)),
    meets(142, SampleChoice, |g, id| g.sample_choice(id, 1).map(drop)),
    meets(142, SamplePick, |g, id| g.sample_pick(id, 1).map(drop)),
    meets(142, SampleString, |g, id| g.sample_string(id, 1).map(drop)),
    // Events.
    meets(147, AwaitEvent, |g, _| g.await_event(-1.0).map(drop)).after(overflow),
    meets(151, AwaitEvent, |g, _| g.await_event(-1.0).map(drop)),
    meets(151, AwaitEvent, |g, _| g.await_event(f64::NAN).map(drop)),
    meets(140, FlushDeviceEvents, |g, id| g.flush_device_events(id, InputClass::Locator, NONE)),
    meets(147, FlushDeviceEvents, |g, id| g.flush_device_events(id, InputClass::Locator, 3)).after(overflow),
    meets(147, CloseWorkstation, Gks::close_workstation).after(overflow),
    meets(150, GetLocator, |g, _| g.get_locator().map(drop)),
    meets(150, GetStroke, |g, _| g.get_stroke().map(drop)),
    meets(150, GetValuator, |g, _| g.get_valuator().map(drop)),
    meets(150, GetChoice, |g, _| g.get_choice().map(drop)),
    meets(150, GetPick, |g, _| g.get_pick().map(drop)),
    meets(150, GetString, |g, _| g.get_string().map(drop)),
    meets(148, InquireInputQueueOverflow, |g, _| g.inquire_input_queue_overflow().map(drop)),
    meets(149, InquireInputQueueOverflow, |g, _| g.inquire_input_queue_overflow().map(drop))
        .after(overflow_and_close),
    // Inquiries.
    meets(140, InquireLocatorDeviceState, |g, id| {
        g.inquire_locator_device_state(id, NONE, ValueType::Set).map(drop)
    }),
    meets(140, InquireStrokeDeviceState, |g, id| {
        g.inquire_stroke_device_state(id, NONE, ValueType::Set).map(drop)
    }),
    meets(140, InquireValuatorDeviceState, |g, id| g.inquire_valuator_device_state(id, NONE).map(drop)),
    meets(140, InquireChoiceDeviceState, |g, id| g.inquire_choice_device_state(id, NONE).map(drop)),
    meets(140, InquirePickDeviceState, |g, id| {
        g.inquire_pick_device_state(id, NONE, ValueType::Set).map(drop)
    }),
    meets(140, InquireStringDeviceState, |g, id| g.inquire_string_device_state(id, NONE).map(drop)),
    meets(140, InquireDefaultLocatorDeviceData, |g, kind| {
        g.inquire_default_locator_device_data(kind, 99).map(drop)
    }),
    meets(140, InquireDefaultStrokeDeviceData, |g, kind| {
        g.inquire_default_stroke_device_data(kind, 0).map(drop)
    }),
    meets(140, InquireDefaultValuatorDeviceData, |g, kind| {
        g.inquire_default_valuator_device_data(kind, -1).map(drop)
    }),
    meets(140, InquireDefaultChoiceDeviceData, |g, kind| {
        g.inquire_default_choice_device_data(kind, 99).map(drop)
    }),
    meets(140, InquireDefaultPickDeviceData, |g, kind| {
        g.inquire_default_pick_device_data(kind, i32::MAX).map(drop)
    }),
    meets(140, InquireDefaultStringDeviceData, |g, kind| {
        g.inquire_default_string_device_data(kind, 99).map(drop)
    }),
];
