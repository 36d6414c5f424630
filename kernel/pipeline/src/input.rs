//! The contract between the kernel and what an operator acts on: logical input devices.
//!
//! The kernel keeps the standard's view of input (operating modes, initial values, the event queue) and
//! says which logical input devices are *started*. A driver turns what the operator does (pointer, keys,
//! the lines of a script) into measures of the devices that are started, shows their prompts and echoes,
//! and reports triggers. Positions are device coordinates in metres; the kernel takes them to world
//! coordinates, and finds what a pick position hits: a driver that echoes picks asks for it
//! ([`Report::Pointed`]), and the kernel answers with what there is to show ([`Input::show`]).

use crate::device::DeviceError;
use crate::look::enumeration;
use crate::trace::Trace;
use gks_geometry::{Dc, Point, Rect};
use std::time::Duration;

enumeration! {
    /// The classes of logical input devices.
    InputClass {
        /// A position.
        Locator = 1,
        /// A sequence of positions.
        Stroke = 2,
        /// A real number.
        Valuator = 3,
        /// One of several alternatives.
        Choice = 4,
        /// A primitive of a segment.
        Pick = 5,
        /// A string of characters.
        String = 6,
    }
}

/// A logical input device of a workstation.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct LogicalDevice {
    /// Its class.
    pub class: InputClass,
    /// Its number, from 1.
    pub number: i32,
}

/// What an operator acts on: the input side of a device. Several logical devices may be started at a time.
pub trait Input: Send {
    /// Starts an interaction: the measure takes its initial value; prompt and echo appear if wanted.
    /// A device that is started already starts again.
    fn start(&mut self, device: LogicalDevice, setting: &Setting) -> Result<(), DeviceError>;

    /// Ends the interaction; prompt and echo disappear. Without effect on a device that is not started.
    fn stop(&mut self, device: LogicalDevice) -> Result<(), DeviceError>;

    /// The current measure of a device that is started, with everything considered that the operator has
    /// done so far; none where there is nobody left to operate it.
    fn sample(&mut self, device: LogicalDevice) -> Result<Option<Measure>, DeviceError>;

    /// The next thing the operator reports, waiting for it at most as long as `patience` says (none: as
    /// long as it takes). Reports come in the order in which triggers fired; nothing is lost between calls.
    /// All that was drawn is visible before the wait begins.
    fn wait(&mut self, patience: Option<Duration>) -> Result<Report, DeviceError>;

    /// Shows what a device that is started picks at the position it was asked about last, as its echo in the place
    /// of the one before. A driver that never asks has nothing to show.
    fn show(&mut self, device: LogicalDevice, picked: Trace) -> Result<(), DeviceError>;
}

/// What an operator reports.
#[derive(Clone, Debug, PartialEq)]
pub enum Report {
    /// A trigger fired: the measures of all started devices that it belongs to, in order.
    Trigger(Vec<(LogicalDevice, Measure)>),
    /// The position of a device that picks changed (none: it is nowhere), and its echo is wanted:
    /// [`Input::show`] is called, and then it is waited again.
    Pointed(LogicalDevice, Option<Point<Dc>>),
    /// The operator refuses to answer (break).
    Break,
    /// Nothing happened while it was waited for.
    Nothing,
    /// Nobody will ever report anything more: the viewer is gone, the script is at its end.
    Gone,
}

/// The measure of a logical input device in terms of the display surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Measure {
    /// A position.
    Locator(Point<Dc>),
    /// Positions in the order in which they were entered.
    Stroke(Vec<Point<Dc>>),
    /// A number.
    Valuator(f64),
    /// The number of an alternative, from 1, or none chosen.
    Choice(Option<i32>),
    /// The position at which to pick, or none; also of a choice device whose alternatives are a picture.
    Pick(Option<Point<Dc>>),
    /// A string.
    String(String),
}

/// How a logical input device is operated.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Whether the measure is echoed.
    pub echo: bool,
    /// The prompt and echo type of the standard for the class; 1 is always there.
    pub prompt: i32,
    /// Where prompts and echoes that need room appear.
    pub area: Rect<Dc>,
    /// The part of the display surface that positions are inside of: the current workstation viewport, as
    /// far as the workstation window fills it.
    pub within: Rect<Dc>,
    /// The initial value.
    pub initial: Measure,
    /// What only one class has.
    pub detail: Detail,
    /// The picture in the echo area whose parts are the alternatives of a choice.
    pub picture: Option<Trace>,
}

/// The part of a setting that depends on the class: what the data records of the INITIALISE functions say.
#[derive(Clone, Debug, PartialEq)]
pub enum Detail {
    /// Nothing.
    Locator,
    /// For strokes.
    Stroke {
        /// The greatest number of points.
        buffer: usize,
        /// The least distance in x and y between points that are entered by moving, in metres.
        interval: (f64, f64),
    },
    /// For valuators.
    Valuator {
        /// The lowest value.
        low: f64,
        /// The highest value.
        high: f64,
    },
    /// For choices.
    Choice {
        /// The number of alternatives.
        alternatives: i32,
        /// Which alternatives are offered (prompt ON); as many as there are alternatives, or none for all.
        enabled: Vec<bool>,
        /// The names of the alternatives, where they have any.
        names: Vec<String>,
    },
    /// For picks.
    Pick {
        /// Half the side of the square in which primitives are hit, in metres.
        aperture: f64,
    },
    /// For strings.
    String {
        /// The greatest number of characters.
        buffer: usize,
        /// The initial position of the cursor, from 1.
        cursor: usize,
    },
}
