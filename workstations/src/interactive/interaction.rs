//! One logical input device that is started: its measure, and what the operator's acts do to it.

use super::event::Key;
use super::panel::{Kind, Panel};
use gks_geometry::{Dc, Point, Rect};
use gks_pipeline::input::{Detail, InputClass, LogicalDevice, Measure, Setting};
use gks_pipeline::trace::Trace;

/// What an act does to a device.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    /// Nothing; another device may use it.
    None,
    /// The measure or its echo changed, or nothing did but the act was meant for this device.
    Taken,
    /// The trigger fired.
    Trigger,
}

/// A logical input device that is started.
#[derive(Clone, Debug)]
pub(super) struct Interaction {
    pub(super) device: LogicalDevice,
    pub(super) setting: Setting,
    pub(super) state: State,
    /// Where its prompt lies.
    pub(super) panel: Option<Panel>,
    /// What it would pick.
    pub(super) picked: Trace,
    /// The position that this is about.
    asked: Option<Point<Dc>>,
}

/// The measure and what else is remembered.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum State {
    /// The position; the initial one is what rubber bands are tied to.
    Locator { at: Point<Dc>, initial: Point<Dc> },
    /// The points, the position of the pointer, and whether the button is down.
    Stroke { points: Vec<Point<Dc>>, at: Option<Point<Dc>>, held: bool },
    /// The value, and whether the slider is held.
    Valuator { value: f64, held: bool },
    /// The alternative that is marked, what has been typed, and the position in a picture to choose from, which
    /// counts if there is one.
    Choice { marked: Option<i32>, typed: String, at: Option<Point<Dc>> },
    /// The position.
    Pick { at: Option<Point<Dc>> },
    /// The characters, and the position of the cursor among them from 0.
    String { text: Vec<char>, cursor: usize },
}

/// The nearest position inside of a rectangle.
fn inside(within: &Rect<Dc>, at: Point<Dc>) -> Point<Dc> {
    let (low, high) = (within.min.0.min(within.max.0), within.max.0.max(within.min.0));
    Point::from_vec(at.0.clamp(low, high))
}

impl State {
    fn new(setting: &Setting) -> State {
        match (&setting.detail, &setting.initial) {
            (Detail::Locator, &Measure::Locator(at)) => State::Locator { at, initial: at },
            (Detail::Locator, _) => {
                let at = setting.within.centre();
                State::Locator { at, initial: at }
            }
            (Detail::Stroke { buffer, .. }, initial) => {
                let mut points = match initial {
                    Measure::Stroke(points) => points.clone(),
                    _ => Vec::new(),
                };
                points.truncate(*buffer);
                State::Stroke { points, at: None, held: false }
            }
            (&Detail::Valuator { low, high }, initial) => {
                let value = if let Measure::Valuator(value) = initial { *value } else { low };
                State::Valuator { value: value.clamp(low.min(high), high.max(low)), held: false }
            }
            (Detail::Choice { .. }, initial) => {
                let marked = if let Measure::Choice(marked) = initial { *marked } else { None };
                State::Choice { marked, typed: String::new(), at: None }
            }
            (Detail::Pick { .. }, initial) => {
                State::Pick { at: if let Measure::Pick(at) = initial { *at } else { None } }
            }
            (&Detail::String { buffer, cursor }, initial) => {
                let text: Vec<char> = match initial {
                    Measure::String(text) => text.chars().take(buffer).collect(),
                    _ => Vec::new(),
                };
                let cursor = cursor.saturating_sub(1).min(text.len());
                State::String { text, cursor }
            }
        }
    }
}

impl Interaction {
    /// A device with its initial measure.
    pub(super) fn new(device: LogicalDevice, setting: &Setting) -> Interaction {
        let mut setting = setting.clone();
        if let Detail::Choice { alternatives, enabled, .. } = &mut setting.detail
            && !enabled.is_empty()
        {
            *alternatives = (*alternatives).min(i32::try_from(enabled.len()).unwrap_or(i32::MAX));
        }
        let state = State::new(&setting);
        Interaction { device, setting, state, panel: None, picked: Trace::default(), asked: None }
    }

    /// The measure.
    pub(super) fn measure(&self) -> Measure {
        match &self.state {
            State::Locator { at, .. } => Measure::Locator(*at),
            State::Stroke { points, .. } => Measure::Stroke(points.clone()),
            State::Valuator { value, .. } => Measure::Valuator(*value),
            State::Choice { at: at @ Some(_), .. } => Measure::Pick(*at),
            State::Choice { marked, .. } => Measure::Choice(*marked),
            State::Pick { at } => Measure::Pick(*at),
            State::String { text, .. } => Measure::String(text.iter().collect()),
        }
    }

    /// Whether the device is operated by pointing into the picture.
    pub(super) fn points(&self) -> bool {
        matches!(self.device.class, InputClass::Locator | InputClass::Stroke | InputClass::Pick)
    }

    /// The position whose echo is wanted, if it is another one than before.
    pub(super) fn question(&mut self) -> Option<Option<Point<Dc>>> {
        let at = match self.state {
            State::Pick { at } => at,
            State::Choice { at, .. } => at,
            _ => return None,
        };
        let new = self.setting.echo && at != self.asked;
        self.asked = at;
        new.then_some(at)
    }

    /// Whether the position is that of the pointer from the start, and not an initial one.
    pub(super) fn follows(&self) -> bool {
        matches!(self.device.class, InputClass::Stroke | InputClass::Pick) || self.setting.picture.is_some()
    }

    /// Prepares for the next report after the trigger fired: what was entered is gone, what was set stays.
    pub(super) fn renew(&mut self) {
        match &mut self.state {
            State::Stroke { points, held, .. } => {
                points.clear();
                *held = false;
            }
            State::String { .. } => self.state = State::new(&self.setting),
            State::Choice { typed, .. } => typed.clear(),
            _ => {}
        }
    }

    /// The pointer moved.
    pub(super) fn moved(&mut self, to: Point<Dc>) -> Effect {
        let within = self.setting.within;
        match (&mut self.state, &self.setting.detail) {
            (State::Locator { at, .. }, _) => *at = inside(&within, to),
            (State::Pick { at }, _) => *at = within.contains(to).then_some(to),
            (State::Stroke { points, at, held }, Detail::Stroke { buffer, interval }) => {
                let to = inside(&within, to);
                *at = Some(to);
                let far = points.last().is_none_or(|last| {
                    let by = (to.0 - last.0).abs();
                    // A distance of whole pixels may lack the last digit.
                    let far = |by: f64, least: f64| by >= least * (1.0 - 1e-9);
                    by.max_element() > 0.0 && (far(by.x, interval.0) || far(by.y, interval.1))
                });
                if *held && far && points.len() < *buffer {
                    points.push(to);
                }
            }
            (State::Valuator { held: true, .. }, _) => return self.grab(to),
            (State::Choice { marked, at, .. }, _) => {
                let Some(panel) = &self.panel else { return Effect::None };
                if panel.kind == Kind::Picture {
                    let before = std::mem::replace(at, panel.frame.contains(to).then_some(to));
                    return if *at == before { Effect::None } else { Effect::Taken };
                }
                match panel.item_at(to).and_then(|item| i32::try_from(item).ok()) {
                    Some(item) if enabled(&self.setting, item) => *marked = Some(item),
                    _ => return Effect::None,
                }
            }
            _ => return Effect::None,
        }
        Effect::Taken
    }

    /// The first button went down in the panel of this device.
    pub(super) fn pressed_in_panel(&mut self, at: Point<Dc>) -> Effect {
        match &mut self.state {
            State::Valuator { held, .. } => {
                *held = true;
                self.grab(at)
            }
            State::Choice { marked, .. } => {
                let Some(panel) = &self.panel else { return Effect::None };
                match panel.kind {
                    Kind::Picture => return Effect::Trigger,
                    Kind::Stepper => match panel.step_at(at) {
                        0 => return Effect::Trigger,
                        by => return self.step(by),
                    },
                    _ => {}
                }
                match panel.item_at(at).and_then(|item| i32::try_from(item).ok()) {
                    Some(item) if enabled(&self.setting, item) => {
                        *marked = Some(item);
                        Effect::Trigger
                    }
                    _ => Effect::Taken,
                }
            }
            State::String { .. } => Effect::Taken,
            _ => Effect::None,
        }
    }

    /// The first button went down in the picture.
    pub(super) fn pressed(&mut self, at: Point<Dc>) -> Effect {
        self.moved(at);
        match (&mut self.state, &self.setting.detail) {
            (State::Locator { .. } | State::Pick { .. }, _) => Effect::Trigger,
            (State::Stroke { points, at: Some(at), held }, Detail::Stroke { buffer, .. }) => {
                *held = true;
                if points.len() < *buffer && points.last() != Some(at) {
                    points.push(*at);
                }
                Effect::Taken
            }
            _ => Effect::None,
        }
    }

    /// The first button went up.
    pub(super) fn released(&mut self) -> Effect {
        match &mut self.state {
            State::Stroke { held, .. } if *held => {
                *held = false;
                Effect::Taken
            }
            State::Valuator { held, .. } if *held => {
                *held = false;
                Effect::Trigger
            }
            _ => Effect::None,
        }
    }

    /// The wheel turned.
    pub(super) fn wheel(&mut self, notches: f64) -> Effect {
        match self.device.class {
            InputClass::Valuator => self.shift(notches / 50.0),
            InputClass::Choice => self.step(if notches > 0.0 { -1 } else { 1 }),
            _ => Effect::None,
        }
    }

    /// A key went down.
    pub(super) fn key(&mut self, key: Key) -> Effect {
        match &mut self.state {
            State::Locator { .. } | State::Pick { .. } => match key {
                Key::Return => Effect::Trigger,
                _ => self.nudge(key),
            },
            State::Stroke { points, .. } => match key {
                Key::Return => Effect::Trigger,
                Key::Backspace | Key::Delete => {
                    points.pop();
                    Effect::Taken
                }
                _ => self.nudge(key),
            },
            State::Valuator { .. } => match key {
                Key::Return => Effect::Trigger,
                Key::Right | Key::Up => self.shift(0.01),
                Key::Left | Key::Down => self.shift(-0.01),
                Key::PageUp => self.shift(0.1),
                Key::PageDown => self.shift(-0.1),
                Key::Home => self.shift(-1.0),
                Key::End => self.shift(1.0),
                _ => Effect::None,
            },
            State::Choice { marked, typed, at } => match key {
                Key::Return => match marked {
                    Some(marked) if !enabled(&self.setting, *marked) => Effect::Taken,
                    _ => Effect::Trigger,
                },
                Key::Backspace => {
                    typed.clear();
                    (*marked, *at) = (None, None);
                    Effect::Taken
                }
                Key::Down | Key::Right => self.step(1),
                Key::Up | Key::Left => self.step(-1),
                Key::Function(number) => self.choose(i32::from(number)),
                _ => Effect::None,
            },
            State::String { text, cursor } => {
                match key {
                    Key::Return => return Effect::Trigger,
                    Key::Left => *cursor = cursor.saturating_sub(1),
                    Key::Right => *cursor = (*cursor + 1).min(text.len()),
                    Key::Home => *cursor = 0,
                    Key::End => *cursor = text.len(),
                    Key::Backspace if *cursor > 0 => {
                        *cursor -= 1;
                        text.remove(*cursor);
                    }
                    Key::Delete if *cursor < text.len() => drop(text.remove(*cursor)),
                    Key::Backspace | Key::Delete => {}
                    _ => return Effect::None,
                }
                Effect::Taken
            }
        }
    }

    /// A character was typed.
    pub(super) fn character(&mut self, character: char) -> Effect {
        match (&mut self.state, &self.setting.detail) {
            (State::String { text, cursor }, Detail::String { buffer, .. }) if !character.is_control() => {
                if text.len() < *buffer {
                    text.insert(*cursor, character);
                    *cursor += 1;
                }
                Effect::Taken
            }
            (State::Choice { .. }, Detail::Choice { .. }) => self.type_choice(character),
            (State::Stroke { at: Some(at), .. }, _) if character == ' ' => {
                let at = *at;
                let effect = self.pressed(at);
                self.released();
                effect
            }
            _ => Effect::None,
        }
    }

    /// Sets the value that a position on the slider or the dial means.
    fn grab(&mut self, at: Point<Dc>) -> Effect {
        let part = self.panel.as_ref().and_then(|panel| panel.part_at(at));
        if let (State::Valuator { value, .. }, &Detail::Valuator { low, high }, Some(part)) =
            (&mut self.state, &self.setting.detail, part)
        {
            // So that the ends are met exactly and ranges as wide as there are numbers do not overflow.
            *value = if part == 1.0 { high } else { low * (1.0 - part) + high * part };
        }
        Effect::Taken
    }

    /// Moves the value by a part of its range.
    fn shift(&mut self, part: f64) -> Effect {
        if let (State::Valuator { value, .. }, &Detail::Valuator { low, high }) =
            (&mut self.state, &self.setting.detail)
        {
            let shifted = *value + (high * part - low * part);
            *value = shifted.clamp(low.min(high), high.max(low));
        }
        Effect::Taken
    }

    /// Moves the position by an arrow key.
    fn nudge(&mut self, key: Key) -> Effect {
        let within = self.setting.within;
        let by = match key {
            Key::Left => (-1.0, 0.0),
            Key::Right => (1.0, 0.0),
            Key::Down => (0.0, -1.0),
            Key::Up => (0.0, 1.0),
            _ => return Effect::None,
        };
        let from = match &self.state {
            State::Locator { at, .. } => *at,
            State::Pick { at } | State::Stroke { at, .. } => at.unwrap_or(within.centre()),
            _ => return Effect::None,
        };
        let step = within.width().max(within.height()) / 100.0;
        let to = inside(&within, Point::from_vec(from.0 + glam::DVec2::from(by) * step));
        self.moved(to)
    }

    /// Marks the next alternative that is offered.
    fn step(&mut self, by: i32) -> Effect {
        let (State::Choice { marked, typed, at: place }, &Detail::Choice { alternatives, .. }) =
            (&mut self.state, &self.setting.detail)
        else {
            return Effect::None;
        };
        typed.clear();
        *place = None;
        let mut at = marked.unwrap_or(if by > 0 { 0 } else { alternatives.saturating_add(1) });
        loop {
            at = at.saturating_add(by);
            if at < 1 || at > alternatives {
                return Effect::Taken;
            }
            if enabled(&self.setting, at) {
                *marked = Some(at);
                return Effect::Taken;
            }
        }
    }

    /// Chooses an alternative at once, if it is offered.
    fn choose(&mut self, number: i32) -> Effect {
        let State::Choice { marked, at, .. } = &mut self.state else { return Effect::None };
        if !enabled(&self.setting, number) {
            return Effect::Taken;
        }
        (*marked, *at) = (Some(number), None);
        Effect::Trigger
    }

    /// Digits give the number of an alternative, which is chosen as soon as no longer number is possible;
    /// letters mark the alternative whose name starts with them.
    fn type_choice(&mut self, character: char) -> Effect {
        let (State::Choice { marked, typed, at }, Detail::Choice { alternatives, names, .. }) =
            (&mut self.state, &self.setting.detail)
        else {
            return Effect::None;
        };
        if character.is_control() || typed.len() > 64 {
            return Effect::None;
        }
        *at = None;
        let of_digits = typed.bytes().all(|b| b.is_ascii_digit());
        if character.is_ascii_digit() && of_digits {
            typed.push(character);
            let number: i32 = typed.parse().unwrap_or(i32::MAX);
            if number == 0 {
                typed.clear();
                *marked = None;
                return Effect::Trigger;
            }
            if !(1..=*alternatives).contains(&number) {
                typed.clear();
                return Effect::Taken;
            }
            *marked = Some(number);
            if number.saturating_mul(10) > *alternatives {
                typed.clear();
                return if enabled(&self.setting, number) { Effect::Trigger } else { Effect::Taken };
            }
            return Effect::Taken;
        }
        typed.push(character);
        let starts = |name: &str, with: &str| {
            let mut letters = name.chars().flat_map(char::to_lowercase);
            with.chars().flat_map(char::to_lowercase).all(|c| letters.next() == Some(c))
        };
        let find = |typed: &str| {
            (1..).zip(names).find(|(number, name)| starts(name, typed) && enabled(&self.setting, *number))
        };
        let found = find(typed).or_else(|| {
            *typed = character.to_string();
            find(typed)
        });
        match found {
            Some((number, _)) => *marked = Some(number),
            None => typed.clear(),
        }
        if names.is_empty() { Effect::None } else { Effect::Taken }
    }
}

/// Whether an alternative exists and is offered.
pub(super) fn enabled(setting: &Setting, number: i32) -> bool {
    let Detail::Choice { alternatives, enabled, .. } = &setting.detail else { return false };
    let index = usize::try_from(number).ok().and_then(|number| number.checked_sub(1));
    (1..=*alternatives).contains(&number)
        && index.is_some_and(|index| enabled.is_empty() || enabled.get(index) == Some(&true))
}
