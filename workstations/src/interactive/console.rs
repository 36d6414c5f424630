//! The operator's console: turns what the operator does into measures and triggers of the logical input
//! devices that are started. It knows no screen.
//!
//! A click into the picture is the trigger of all locators and picks that are started; one into a panel
//! belongs to the device of the panel. Keys go to the device that has the focus and, if it has no use for
//! them, to the others.

use super::event::{Button, Event, Key};
use super::interaction::{Effect, Interaction};
use super::panel;
use gks_geometry::{Dc, Point};
use gks_pipeline::device::Surface;
use gks_pipeline::input::{InputClass, LogicalDevice, Measure, Report, Setting};
use gks_pipeline::trace::Trace;
use glam::DVec2;
use std::collections::VecDeque;

/// The most reports that are kept for a program that does not ask for them.
const MOST_REPORTS: usize = 65536;

/// The logical input devices that are started, and what they have reported.
pub struct Console {
    /// Side of a pixel in metres.
    unit: f64,
    /// Height of the display surface in metres.
    height: f64,
    letter: f64,
    started: Vec<Interaction>,
    focus: Option<LogicalDevice>,
    pointer: Option<Point<Dc>>,
    reports: VecDeque<Report>,
}

impl Console {
    /// A console for a display surface.
    pub fn new(surface: &Surface) -> Console {
        let side = surface.width.min(surface.height) * surface.unit;
        Console {
            unit: surface.unit,
            height: surface.height * surface.unit,
            letter: panel::letter(side, surface.unit),
            started: Vec::new(),
            focus: None,
            pointer: None,
            reports: VecDeque::new(),
        }
    }

    /// Starts a device, or starts it again.
    pub fn start(&mut self, device: LogicalDevice, setting: &Setting) {
        let interaction = Interaction::new(device, setting);
        match self.started.iter_mut().find(|other| other.device == device) {
            Some(old) => *old = interaction,
            None => self.started.push(interaction),
        }
        self.arrange();
        // What has no position of its own at first is where the pointer is.
        if let Some(at) = self.pointer {
            self.all(|i| i.device == device && i.follows(), |i| i.moved(at));
        }
    }

    /// Ends a device; what it has reported stays.
    pub fn stop(&mut self, device: LogicalDevice) {
        self.started.retain(|other| other.device != device);
        if self.focus == Some(device) {
            self.focus = None;
        }
        self.arrange();
    }

    /// Whether no device is started.
    pub fn is_idle(&self) -> bool {
        self.started.is_empty()
    }

    /// The measure of a device that is started.
    pub fn measure(&self, device: LogicalDevice) -> Option<Measure> {
        self.started.iter().find(|other| other.device == device).map(Interaction::measure)
    }

    /// The next report.
    pub fn report(&mut self) -> Option<Report> {
        self.reports.pop_front()
    }

    /// The next device whose echo is what it picks at a new position, and the position; once for each.
    pub fn question(&mut self) -> Option<Report> {
        let ask = |i: &mut Interaction| i.question().map(|at| Report::Pointed(i.device, at));
        self.started.iter_mut().find_map(ask)
    }

    /// Takes what a device picks as its echo.
    pub fn show(&mut self, device: LogicalDevice, picked: Trace) {
        if let Some(interaction) = self.started.iter_mut().find(|other| other.device == device) {
            interaction.picked = picked;
        }
    }

    /// The devices that are started.
    pub(super) fn started(&self) -> &[Interaction] {
        &self.started
    }

    /// The device that keys go to first.
    pub(super) fn focus(&self) -> Option<LogicalDevice> {
        let rank = |class| match class {
            InputClass::String => 0,
            InputClass::Stroke => 1,
            InputClass::Locator => 2,
            InputClass::Pick => 3,
            InputClass::Choice => 4,
            InputClass::Valuator => 5,
        };
        let first = || self.started.iter().map(|i| i.device).min_by_key(|device| rank(device.class));
        self.focus.or_else(first)
    }

    /// Gives each panel its place.
    fn arrange(&mut self) {
        for at in 0..self.started.len() {
            let (before, rest) = self.started.split_at_mut(at);
            let Interaction { device, setting, panel, .. } = &mut rest[0];
            let same = before.iter().filter(|other| {
                other.device.class == device.class
                    && other.panel.is_some()
                    && other.setting.area == setting.area
            });
            *panel = panel::panel(setting, device.class, self.letter, same.count());
        }
    }

    fn position(&self, at: DVec2) -> Point<Dc> {
        Point::new(at.x * self.unit, self.height - at.y * self.unit)
    }

    /// Takes an event; the answer is whether an echo may have changed.
    pub fn handle(&mut self, event: Event) -> bool {
        match event {
            Event::Moved(at) => self.moved(at),
            Event::Pressed(Button::Primary, at) => self.pressed(at),
            Event::Released(Button::Primary, at) => {
                let moved = self.moved(at);
                self.all(|_| true, Interaction::released) || moved
            }
            Event::Pressed(Button::Secondary, at) => {
                let moved = self.moved(at);
                let stroke = |i: &Interaction| i.device.class == InputClass::Stroke;
                self.all(stroke, |_| Effect::Trigger) || moved
            }
            Event::Wheel(notches) => self.wheel(notches),
            Event::Key(Key::Escape) => {
                if !self.is_idle() {
                    self.push(Report::Break);
                }
                true
            }
            Event::Key(Key::Tab) => self.next_focus(),
            Event::Key(Key::Return) => self.confirm(),
            Event::Key(key) => {
                let pointing = |i: &Interaction| i.points();
                let arrow = matches!(key, Key::Left | Key::Right | Key::Up | Key::Down);
                // What points into the picture moves together.
                if arrow && self.focused().is_some_and(pointing) {
                    self.all(pointing, |i| i.key(key))
                } else {
                    self.first(|i| i.key(key))
                }
            }
            Event::Character(character) => self.first(|i| i.character(character)),
            Event::Pressed(..) | Event::Released(..) | Event::Closed => false,
        }
    }

    fn push(&mut self, report: Report) {
        if self.reports.len() < MOST_REPORTS {
            self.reports.push_back(report);
        }
    }

    fn focused(&self) -> Option<&Interaction> {
        let focus = self.focus()?;
        self.started.iter().find(|i| i.device == focus)
    }

    fn moved(&mut self, at: DVec2) -> bool {
        let at = self.position(at);
        self.pointer = Some(at);
        self.all(|_| true, |i| i.moved(at))
    }

    fn pressed(&mut self, at: DVec2) -> bool {
        self.moved(at);
        let at = self.position(at);
        let in_panel = |i: &Interaction| {
            let own =
                matches!(i.device.class, InputClass::Valuator | InputClass::Choice | InputClass::String);
            own && i.panel.as_ref().is_some_and(|panel| panel.frame.contains(at))
        };
        // The panel on top is the one that was drawn last.
        if let Some(device) = self.started.iter().rev().find(|i| in_panel(i)).map(|i| i.device) {
            self.focus = Some(device);
            return self.all(|i| i.device == device, |i| i.pressed_in_panel(at));
        }
        self.all(Interaction::points, |i| i.pressed(at))
    }

    /// The wheel belongs to the panel under the pointer, or to whoever has a use for it.
    fn wheel(&mut self, notches: f64) -> bool {
        let under = |i: &&Interaction| {
            let panel = i.panel.as_ref();
            self.pointer.is_some_and(|at| panel.is_some_and(|panel| panel.frame.contains(at)))
        };
        match self.started.iter().rev().find(under).map(|i| i.device) {
            Some(device) => self.all(|i| i.device == device, |i| i.wheel(notches)),
            None => self.first(|i| i.wheel(notches)),
        }
    }

    /// Return is the trigger of the device with the focus, and of locators and picks together.
    fn confirm(&mut self) -> bool {
        let Some(focus) = self.focused().map(|i| i.device) else { return false };
        let together = |class| matches!(class, InputClass::Locator | InputClass::Pick);
        let belongs =
            |i: &Interaction| i.device == focus || (together(focus.class) && together(i.device.class));
        self.all(belongs, |i| i.key(Key::Return))
    }

    fn next_focus(&mut self) -> bool {
        let at = self.focus().and_then(|focus| self.started.iter().position(|i| i.device == focus));
        if let Some(at) = at {
            self.focus = Some(self.started[(at + 1) % self.started.len()].device);
        }
        true
    }

    /// Lets some devices act; those whose triggers fire report together.
    fn all(
        &mut self,
        belongs: impl Fn(&Interaction) -> bool,
        act: impl Fn(&mut Interaction) -> Effect,
    ) -> bool {
        let (mut fired, mut taken) = (Vec::new(), false);
        for interaction in self.started.iter_mut().filter(|i| belongs(i)) {
            match act(interaction) {
                Effect::None => continue,
                Effect::Taken => {}
                Effect::Trigger => {
                    fired.push((interaction.device, interaction.measure()));
                    interaction.renew();
                }
            }
            taken = true;
        }
        if !fired.is_empty() {
            self.push(Report::Trigger(fired));
        }
        taken
    }

    /// Lets the devices act one after the other, from that with the focus on, until one has a use for it.
    fn first(&mut self, act: impl Fn(&mut Interaction) -> Effect) -> bool {
        let focus = self.focus();
        let mut order: Vec<LogicalDevice> = self.started.iter().map(|i| i.device).collect();
        order.sort_by_key(|&device| Some(device) != focus);
        order.into_iter().any(|device| self.all(|i| i.device == device, &act))
    }
}

#[cfg(test)]
mod tests;
