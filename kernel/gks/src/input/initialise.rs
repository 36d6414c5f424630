//! INITIALISE: the initial value, the prompt and the echo area of a device.

use super::device::{Device, default_detail, prompts};
use super::value::{InputStatus, InputValue, LocatorValue, OperatingMode, PickValue, StrokeValue};
use super::{logical, no_device, record};
use crate::workstation_transformation::on_display;
use crate::{DataRecord, Error, Function, GivenRecord, Gks, Points, Result};
use gks_geometry::{Dc, Point, Rect, Wc};
use gks_pipeline::input::{Detail, InputClass};

/// What all INITIALISE functions say about prompt and echo.
struct Prompting<'a> {
    number: i32,
    prompt: i32,
    area: Rect<Dc>,
    record: GivenRecord<'a>,
}

impl Gks {
    /// INITIALISE LOCATOR: the initial position, in the world coordinates of a normalization transformation.
    ///
    /// `number` is that of the device, `prompt` the prompt and echo type, `area` the echo area in metres on the
    /// display surface. Errors: 7, 20, 25, 38, 51 (echo area), 140 (no such device), 141 (not in mode REQUEST),
    /// 144 (prompt and echo type), 145 (echo area not on the display surface), 146 (data record), 152 (no such
    /// transformation, or a position outside of its window).
    #[allow(clippy::too_many_arguments, reason = "the function of the standard has as many")]
    pub fn initialise_locator<'a>(
        &mut self,
        id: i32,
        number: i32,
        transformation: i32,
        position: impl Into<Point<Wc>>,
        prompt: i32,
        area: impl Into<Rect<Dc>>,
        record: impl Into<GivenRecord<'a>>,
    ) -> Result<()> {
        const F: Function = Function::InitialiseLocator;
        let prompting = Prompting { number, prompt, area: area.into(), record: record.into() };
        let position = position.into();
        self.initialise(F, id, InputClass::Locator, &prompting, |gks, _, record| {
            let detail = record::locator(prompt, record).ok_or(146)?;
            gks.check_positions(transformation, &[position])?;
            Ok((InputValue::Locator(LocatorValue { transformation, position }), detail))
        })
    }

    /// INITIALISE STROKE: the initial points, in the world coordinates of a normalization transformation, and the
    /// number of points that the input buffer holds.
    ///
    /// Errors: as INITIALISE LOCATOR, 146 also for a buffer without room, 153 (more points than the buffer
    /// holds).
    #[allow(clippy::too_many_arguments, reason = "the function of the standard has as many")]
    pub fn initialise_stroke<'a>(
        &mut self,
        id: i32,
        number: i32,
        transformation: i32,
        points: impl Into<Points<'a>>,
        prompt: i32,
        area: impl Into<Rect<Dc>>,
        buffer: i32,
        record: impl Into<GivenRecord<'a>>,
    ) -> Result<()> {
        const F: Function = Function::InitialiseStroke;
        let prompting = Prompting { number, prompt, area: area.into(), record: record.into() };
        let given = points.into();
        self.initialise(F, id, InputClass::Stroke, &prompting, |gks, usual, record| {
            let open = gks.workstation(F, id).map_err(|error| error.number)?;
            let map = gks.normalization.to_ndc(transformation).then(&open.workstation.device_map());
            let detail = record::stroke(buffer, &map, &usual, record).ok_or(146)?;
            let mut points = Vec::new();
            given.for_each(|p| points.push(Point::from_vec(p)));
            gks.check_positions(transformation, &points)?;
            match detail {
                Detail::Stroke { buffer, .. } if points.len() > buffer => Err(153),
                _ => Ok((InputValue::Stroke(StrokeValue { transformation, points }), detail)),
            }
        })
    }

    /// INITIALISE VALUATOR: the initial value, and the lowest and the highest one.
    ///
    /// Errors: as INITIALISE LOCATOR; 146 also for limits out of order, 152 for a value that is not between them.
    #[allow(clippy::too_many_arguments, reason = "the function of the standard has as many")]
    pub fn initialise_valuator<'a>(
        &mut self,
        id: i32,
        number: i32,
        value: f64,
        prompt: i32,
        area: impl Into<Rect<Dc>>,
        low: f64,
        high: f64,
        record: impl Into<GivenRecord<'a>>,
    ) -> Result<()> {
        const F: Function = Function::InitialiseValuator;
        let prompting = Prompting { number, prompt, area: area.into(), record: record.into() };
        self.initialise(F, id, InputClass::Valuator, &prompting, |_, _, _| {
            let detail = record::valuator(low, high).ok_or(146)?;
            if (low..=high).contains(&value) { Ok((InputValue::Valuator(value), detail)) } else { Err(152) }
        })
    }

    /// INITIALISE CHOICE: the initial status, OK or NOCHOICE, and the number of the alternative for OK.
    ///
    /// Errors: as INITIALISE LOCATOR; 152 for another status or a number that is not one of an alternative.
    #[allow(clippy::too_many_arguments, reason = "the function of the standard has as many")]
    pub fn initialise_choice<'a>(
        &mut self,
        id: i32,
        number: i32,
        status: InputStatus,
        choice: i32,
        prompt: i32,
        area: impl Into<Rect<Dc>>,
        record: impl Into<GivenRecord<'a>>,
    ) -> Result<()> {
        const F: Function = Function::InitialiseChoice;
        let prompting = Prompting { number, prompt, area: area.into(), record: record.into() };
        self.initialise(F, id, InputClass::Choice, &prompting, |_, _, record| {
            let detail = record::choice(prompt, record).ok_or(146)?;
            let known = matches!(&detail, Detail::Choice { alternatives, .. } if (1..=*alternatives).contains(&choice));
            match status {
                InputStatus::NoInput => Ok((InputValue::Choice(None), detail)),
                InputStatus::Ok if known => Ok((InputValue::Choice(Some(choice)), detail)),
                _ => Err(152),
            }
        })
    }

    /// INITIALISE PICK: the initial status, OK or NOPICK, and the segment and the pick identifier for OK.
    ///
    /// Errors: as INITIALISE LOCATOR, with 37 in the place of 38; 152 for another status, a name that no segment
    /// can have or a negative pick identifier.
    #[allow(clippy::too_many_arguments, reason = "the function of the standard has as many")]
    pub fn initialise_pick<'a>(
        &mut self,
        id: i32,
        number: i32,
        status: InputStatus,
        segment: i32,
        identifier: i32,
        prompt: i32,
        area: impl Into<Rect<Dc>>,
        record: impl Into<GivenRecord<'a>>,
    ) -> Result<()> {
        const F: Function = Function::InitialisePick;
        let prompting = Prompting { number, prompt, area: area.into(), record: record.into() };
        self.initialise(F, id, InputClass::Pick, &prompting, |_, usual, record| {
            let detail = record::pick(&usual, record).ok_or(146)?;
            match status {
                InputStatus::NoInput => Ok((InputValue::Pick(None), detail)),
                InputStatus::Ok if segment > 0 && identifier >= 0 => {
                    Ok((InputValue::Pick(Some(PickValue { segment, identifier })), detail))
                }
                _ => Err(152),
            }
        })
    }

    /// INITIALISE STRING: the initial string, the number of characters that the input buffer holds, and the
    /// position of the cursor, from 1.
    ///
    /// Errors: as INITIALISE LOCATOR, 146 also for a buffer without room, 152 for a cursor that is neither in nor
    /// just behind the string, 154 (longer than the buffer).
    #[allow(clippy::too_many_arguments, reason = "the function of the standard has as many")]
    pub fn initialise_string<'a>(
        &mut self,
        id: i32,
        number: i32,
        string: &str,
        prompt: i32,
        area: impl Into<Rect<Dc>>,
        buffer: i32,
        cursor: i32,
        record: impl Into<GivenRecord<'a>>,
    ) -> Result<()> {
        const F: Function = Function::InitialiseString;
        let prompting = Prompting { number, prompt, area: area.into(), record: record.into() };
        self.initialise(F, id, InputClass::String, &prompting, |_, _, _| {
            let length = string.chars().count();
            let at = usize::try_from(cursor).unwrap_or(0);
            let detail = record::string(buffer, at).ok_or(146)?;
            if !(1..=length + 1).contains(&at) {
                return Err(152);
            }
            match detail {
                Detail::String { buffer, .. } if length > buffer => Err(154),
                _ => Ok((InputValue::String(string.to_owned()), detail)),
            }
        })
    }

    /// Sets a device. `prepare` is given what the data record of a device says that has none, and the data record, and
    /// gives the initial value and what the data record says, or the number of the error: 146, 152, 153 or 154.
    fn initialise(
        &mut self,
        function: Function,
        id: i32,
        class: InputClass,
        prompting: &Prompting<'_>,
        prepare: impl FnOnce(&Gks, Detail, &DataRecord) -> Result<(InputValue, Detail), i32>,
    ) -> Result<()> {
        self.check_state(function)?;
        self.check_input(function, id)?;
        let Prompting { number, prompt, area, record } = *prompting;
        let description = self.workstation(function, id)?.workstation.description();
        let limits = || format!("echo area {:?}", area.limits());
        let area = on_display(area, description);
        if !area.is_proper() {
            return Err(Error::new(51, function).because(limits()));
        }
        let device = logical(class, number);
        if self.input_device(function, id, device)?.mode != OperatingMode::Request {
            return Err(Error::new(141, function));
        }
        if !prompts(class).contains(&prompt) {
            return Err(Error::new(144, function).because(format!("prompt and echo type {prompt}")));
        }
        let (width, height) = description.size();
        if !Rect::new(0.0, width, 0.0, height).contains_rect(&area) {
            return Err(Error::new(145, function).because(limits()));
        }
        let usual = default_detail(class, description);
        let record = record.values().ok_or_else(|| Error::new(146, function))?;
        let (initial, detail) = prepare(self, usual, &record).map_err(|error| Error::new(error, function))?;
        let open = self.workstation_mut(function, id)?;
        let state = open.input.get_mut(device).ok_or_else(|| no_device(function, device))?;
        *state = Device { mode: state.mode, echo: state.echo, initial, prompt, area, detail, record };
        Ok(())
    }

    /// Checks that positions lie in the window of a normalization transformation. Error: 152.
    fn check_positions(&self, transformation: i32, positions: &[Point<Wc>]) -> Result<(), i32> {
        let found =
            usize::try_from(transformation).ok().and_then(|n| self.normalization.transformations.get(n));
        let window = found.ok_or(152)?.window;
        if positions.iter().all(|&p| window.contains(p)) { Ok(()) } else { Err(152) }
    }
}
