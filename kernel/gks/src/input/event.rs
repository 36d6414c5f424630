//! EVENT: the operator makes events, which the application takes from the queue.

use super::measure;
use super::value::{InputValue, LocatorValue, OfClass, OperatingMode, PickValue, StrokeValue};
use super::{logical, pick};
use crate::gks::receiving_error;
use crate::{Error, Function, Gks, Result};
use gks_pipeline::input::{InputClass, LogicalDevice, Measure, Report};
use gks_pipeline::workstation::Workstation;
use std::time::{Duration, Instant};

/// How long one of several workstations is waited for before it is the turn of the next.
const SLICE: Duration = Duration::from_millis(10);

impl Gks {
    /// AWAIT EVENT: waits for an event at most `timeout` seconds and makes the oldest report the current one.
    ///
    /// Gives the workstation, the class and the number of the device; none if the time is over, and also as soon
    /// as nobody can make an event any more. Errors: 7, 147 (reports have been lost; nothing is done, and the
    /// next call will do it), 151 (timeout), 303, 305.
    pub fn await_event(&mut self, timeout: f64) -> Result<Option<(i32, InputClass, i32)>> {
        const F: Function = Function::AwaitEvent;
        self.check_state(F)?;
        self.check_overflow(F)?;
        if timeout.is_nan() || timeout < 0.0 {
            return Err(Error::new(151, F).because(format!("{timeout} seconds")));
        }
        if self.events.begin_again_if_empty() {
            // What is too long for the clock is as good as no limit.
            let until = Duration::try_from_secs_f64(timeout).ok().and_then(|t| Instant::now().checked_add(t));
            self.wait_for_event(F, until)?;
        }
        self.events.advance();
        Ok(self.current_event())
    }

    /// The workstation, the class and the number of the device of the current event report, if there is one.
    pub fn current_event(&self) -> Option<(i32, InputClass, i32)> {
        let event = self.events.current()?;
        Some((event.workstation, event.device.class, event.device.number))
    }

    /// Waits until there is a report in the queue, the time is over, or nobody can make one.
    fn wait_for_event(&mut self, function: Function, until: Option<Instant>) -> Result<()> {
        let makes_events =
            |(id, open): (&i32, &crate::gks::OpenWorkstation)| open.input.makes_events().then_some(*id);
        let mut ids: Vec<i32> = self.workstations.iter().filter_map(makes_events).collect();
        for &id in &ids {
            self.before_interaction(function, id)?;
        }
        while !ids.is_empty() {
            let slice = (ids.len() > 1).then_some(SLICE);
            let mut gone = Vec::new();
            for &id in &ids {
                let left = until.map(|until| until.saturating_duration_since(Instant::now()));
                let patience = [slice, left].into_iter().flatten().min();
                let Some(open) = self.workstations.get_mut(&id) else { continue };
                let report = match open.workstation.input() {
                    Some(operator) => operator.wait(patience).map_err(|e| receiving_error(function, &e))?,
                    None => Report::Gone,
                };
                match report {
                    Report::Trigger(measures) => self.queue_events(id, measures),
                    // There is nothing that an operator could refuse to answer.
                    Report::Break | Report::Nothing => {}
                    Report::Gone => gone.push(id),
                }
                if !self.events.is_empty() {
                    return Ok(());
                }
            }
            if until.is_some_and(|until| Instant::now() >= until) {
                return Ok(());
            }
            ids.retain(|id| !gone.contains(id));
        }
        Ok(())
    }

    /// FLUSH DEVICE EVENTS: removes the reports of a device from the queue.
    ///
    /// Errors: 7, 20, 25, 38, 140 (no such device), 147 (reports have been lost; nothing is done, and the next
    /// call will do it).
    pub fn flush_device_events(&mut self, id: i32, class: InputClass, number: i32) -> Result<()> {
        const F: Function = Function::FlushDeviceEvents;
        self.check_state(F)?;
        let device = logical(class, number);
        self.input_device(F, id, device)?;
        self.check_overflow(F)?;
        self.events.flush(id, device);
        Ok(())
    }

    /// INQUIRE MORE SIMULTANEOUS EVENTS: whether the trigger of the current report has made further ones.
    ///
    /// Error: 7.
    pub fn inquire_more_simultaneous_events(&self) -> Result<bool> {
        self.check_state(Function::InquireMoreSimultaneousEvents)?;
        Ok(self.events.more())
    }

    /// INQUIRE INPUT QUEUE OVERFLOW: the workstation, the class and the number of the device whose report did
    /// not fit, which is told once.
    ///
    /// Errors: 7, 148 (nothing lost), 149 (the workstation has been closed since).
    pub fn inquire_input_queue_overflow(&mut self) -> Result<(i32, InputClass, i32)> {
        const F: Function = Function::InquireInputQueueOverflow;
        self.check_state(F)?;
        let overflow = self.events.take_overflow().ok_or_else(|| Error::new(148, F))?;
        if overflow.closed {
            return Err(Error::new(149, F));
        }
        Ok((overflow.workstation, overflow.device.class, overflow.device.number))
    }

    /// Reports once that the queue has overflowed. Error: 147.
    pub(crate) fn check_overflow(&mut self, function: Function) -> Result<()> {
        if self.events.take_unreported() { Err(Error::new(147, function)) } else { Ok(()) }
    }

    /// Puts the measures of devices in mode EVENT into the queue, as the reports of one trigger.
    pub(super) fn queue_events(&mut self, id: i32, measures: Vec<(LogicalDevice, Measure)>) {
        let mut values = Vec::new();
        for (device, measure) in measures {
            let state = self.workstations.get(&id).and_then(|open| open.input.get(device));
            if state.is_some_and(|state| state.mode == OperatingMode::Event)
                && let Some(value) = self.input_value(id, device, measure)
            {
                values.push((device, value));
            }
        }
        self.events.push(id, values);
    }

    /// The logical input value of a measure; none if it is not one of the class of the device.
    pub(super) fn input_value(
        &mut self,
        id: i32,
        device: LogicalDevice,
        measure: Measure,
    ) -> Option<InputValue> {
        let Gks { workstations, normalization, segments, .. } = self;
        let open = workstations.get_mut(&id)?;
        let detail = open.input.get(device)?.detail.clone();
        let pick = |workstation: &mut Workstation, at, half| pick::at(segments, id, workstation, at, half);
        measure::value(normalization, open, pick, &detail, measure)
    }
}

macro_rules! gets {
    ($($(#[$doc:meta])* $name:ident, $function:ident -> $value:ty;)+) => {
        impl Gks { $(
            $(#[$doc])*
            pub fn $name(&self) -> Result<$value> {
                const F: Function = Function::$function;
                self.check_state(F)?;
                let value = self.events.current().and_then(|event| <$value>::of(event.value.clone()));
                value.ok_or_else(|| Error::new(150, F))
            }
        )+ }
    };
}

gets! {
    /// GET LOCATOR: the position of the current event report. Errors: 7, 150 (none of a locator).
    get_locator, GetLocator -> LocatorValue;
    /// GET STROKE: the points of the current event report. Errors: 7, 150 (none of a stroke device).
    get_stroke, GetStroke -> StrokeValue;
    /// GET VALUATOR: the number of the current event report. Errors: 7, 150 (none of a valuator).
    get_valuator, GetValuator -> f64;
    /// GET CHOICE: the alternative of the current event report, if one was chosen. Errors: 7, 150 (none of a
    /// choice device).
    get_choice, GetChoice -> Option<i32>;
    /// GET PICK: what was picked in the current event report, if anything. Errors: 7, 150 (none of a pick
    /// device).
    get_pick, GetPick -> Option<PickValue>;
    /// GET STRING: the text of the current event report. Errors: 7, 150 (none of a string device).
    get_string, GetString -> String;
}
