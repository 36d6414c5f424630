//! The scripted workstation: a true-colour picture, and an operator who does what a script says.
//!
//! A script is text, a step on each line:
//!
//! ```text
//! # a comment
//! locator 1 0.3 0.4            enter a position with locator 1
//! stroke 1 0.1 0.1 0.2 0.3     enter positions with stroke 1
//! valuator 1 0.5               enter a number
//! choice 1 3                   choose alternative 3; `choice 1 none` chooses nothing
//! pick 1 0.5 0.5               pick what is there; `pick 1 none` picks nothing
//! string 1 hello, world        enter the rest of the line
//! break                        refuse to answer
//! wait 0.5                     do nothing for half a second
//! together                     the lines down to `end` are entered by one trigger
//!   choice 1 2
//!   locator 1 0.5 0.5
//! end
//! snapshot menu.png            write the picture as it is now
//! ```
//!
//! Positions are fractions of the shorter side of the display surface, from the lower left corner: NDC on a
//! workstation whose transformation has not been changed. Each step answers the next request or becomes an event.
//! A step for a device that is not started then is an error that names the line. A sample takes the steps that
//! are about its device. At the end of the script the operator is gone: requests get no answer any more.

mod script;

use crate::options::Options;
use crate::raster::{self, Format, SizeError, TrueColour};
use gks_geometry::{Dc, Point};
use gks_pipeline::description::{Category, Description};
use gks_pipeline::device::{Device, DeviceError, Drawn, FrameBuffer, Mark, Page, Sink, Surface};
use gks_pipeline::input::{Input, LogicalDevice, Measure, Report, Setting};
use gks_pipeline::trace::Trace;
use script::{Act, Entry, Step, Steps};
use std::collections::{HashMap, VecDeque};
use std::io;
use std::time::{Duration, Instant};

/// How many logical input devices there are in each class.
const DEVICES: u32 = 10;

/// The description of the scripted workstation.
pub fn describe(number: i32, name: &'static str, options: &Options) -> Result<Description, SizeError> {
    let picture = raster::true_colour(number, name, options)?;
    Ok(Description { category: Category::OutIn, input: [DEVICES; 6], ..picture })
}

/// Opens a file by its name, for the pictures that a script has written.
pub type OpenFile = fn(&str) -> io::Result<Box<dyn Sink>>;

/// A workstation with a frame buffer and a script.
pub struct Scripted {
    picture: TrueColour,
    operator: Operator,
}

impl Scripted {
    /// A workstation that draws on `picture` and whose operator does what the script says. `open` opens the files
    /// of snapshots. An error names the line of the script that makes no sense.
    pub fn new(picture: TrueColour, script: &str, open: OpenFile) -> Result<Self, String> {
        let steps = script::parse(script)?;
        Ok(Scripted { picture, operator: Operator::new(steps, open) })
    }
}

impl Device for Scripted {
    fn surface(&self) -> &Surface {
        self.picture.surface()
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.picture.begin(page)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        self.picture.draw(mark)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.picture.end()
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        self.picture.close()
    }

    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        self.picture.frame_buffer()
    }

    fn input(&mut self) -> Option<&mut dyn Input> {
        Some(self)
    }
}

/// The operator: what is left of the script, and the devices that are started.
struct Operator {
    steps: VecDeque<(usize, Step)>,
    /// When the time is over that the script says nothing happens.
    idle_until: Option<Instant>,
    measures: HashMap<LogicalDevice, Measure>,
    open: OpenFile,
}

impl Operator {
    fn new(steps: Steps, open: OpenFile) -> Self {
        Operator { steps: steps.into(), idle_until: None, measures: HashMap::new(), open }
    }

    /// Lets the time pass that the script says nothing happens in, but no more than `patience`. Whether that time
    /// is over.
    fn idle(&mut self, time: Duration, patience: Option<Duration>) -> bool {
        let until = *self.idle_until.get_or_insert_with(|| Instant::now() + time);
        let left = until.saturating_duration_since(Instant::now());
        let over = patience.is_none_or(|patience| patience >= left);
        std::thread::sleep(patience.map_or(left, |patience| patience.min(left)));
        if over {
            self.idle_until = None;
            self.steps.pop_front();
        }
        over
    }

    /// Enters what one trigger fires for; the step is done whether it can be or not.
    fn enter(&mut self, line: usize, acts: Vec<Act>, scale: f64) -> Result<Report, DeviceError> {
        let mut measures = Vec::new();
        for Act { class, device, entry } in acts {
            let device = LogicalDevice { class, number: device };
            let Some(measure) = self.measures.get_mut(&device) else {
                let class = format!("{class:?}").to_lowercase();
                let message = format!("line {line} of the script: {class} {} is not started", device.number);
                return Err(io::Error::new(io::ErrorKind::InvalidData, message).into());
            };
            *measure = entered(entry, scale);
            measures.push((device, measure.clone()));
        }
        Ok(Report::Trigger(measures))
    }
}

/// The measure of what is entered; `scale` metres are the unit of the script.
fn entered(entry: Entry, scale: f64) -> Measure {
    let at = |(x, y): (f64, f64)| Point::<Dc>::new(x * scale, y * scale);
    match entry {
        Entry::Locator(p) => Measure::Locator(at(p)),
        Entry::Stroke(points) => Measure::Stroke(points.into_iter().map(at).collect()),
        Entry::Valuator(value) => Measure::Valuator(value),
        Entry::Choice(choice) => Measure::Choice(choice),
        Entry::Pick(position) => Measure::Pick(position.map(at)),
        Entry::String(text) => Measure::String(text),
    }
}

impl Scripted {
    /// The unit of the script in metres.
    fn scale(&self) -> f64 {
        let surface = self.picture.surface();
        surface.width.min(surface.height) * surface.unit
    }

    fn snapshot(&mut self, name: &str) -> Result<(), DeviceError> {
        let mut sink = (self.operator.open)(name)?;
        self.picture.write(sink.as_mut(), Format::Png)
    }
}

impl Input for Scripted {
    fn start(&mut self, device: LogicalDevice, setting: &Setting) -> Result<(), DeviceError> {
        self.operator.measures.insert(device, setting.initial.clone());
        Ok(())
    }

    fn stop(&mut self, device: LogicalDevice) -> Result<(), DeviceError> {
        self.operator.measures.remove(&device);
        Ok(())
    }

    fn sample(&mut self, device: LogicalDevice) -> Result<Option<Measure>, DeviceError> {
        loop {
            match self.operator.steps.front().cloned() {
                Some((line, Step::Enter(acts)))
                    if acts.iter().all(|act| (act.class, act.device) == (device.class, device.number)) =>
                {
                    self.operator.steps.pop_front();
                    self.operator.enter(line, acts, self.scale())?;
                    break;
                }
                Some((_, Step::Snapshot(name))) => {
                    self.operator.steps.pop_front();
                    self.snapshot(&name)?;
                }
                Some((_, Step::Wait(time))) => {
                    if !self.operator.idle(time, Some(Duration::ZERO)) {
                        break;
                    }
                }
                _ => break,
            }
        }
        Ok(self.operator.measures.get(&device).cloned())
    }

    fn show(&mut self, _device: LogicalDevice, _picked: Trace) -> Result<(), DeviceError> {
        Ok(())
    }

    fn wait(&mut self, patience: Option<Duration>) -> Result<Report, DeviceError> {
        let deadline = patience.and_then(|patience| Instant::now().checked_add(patience));
        loop {
            match self.operator.steps.front().cloned() {
                None => return Ok(Report::Gone),
                Some((_, Step::Wait(time))) => {
                    let left = deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
                    if !self.operator.idle(time, left) {
                        return Ok(Report::Nothing);
                    }
                }
                Some((line, step)) => {
                    self.operator.steps.pop_front();
                    match step {
                        Step::Enter(acts) => return self.operator.enter(line, acts, self.scale()),
                        Step::Break => return Ok(Report::Break),
                        Step::Snapshot(name) => self.snapshot(&name)?,
                        Step::Wait(_) => {}
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::Rect;
    use gks_pipeline::input::{Detail, InputClass};

    fn no_file(name: &str) -> io::Result<Box<dyn Sink>> {
        Err(io::Error::new(io::ErrorKind::NotFound, name))
    }

    /// A workstation of 200 x 100 pixels of 0.2 mm with a script.
    fn scripted(script: &str) -> Scripted {
        let options = Options { size: Some((200.0, 100.0)), ..Options::default() };
        Scripted::new(TrueColour::new(&options, None).unwrap(), script, no_file).unwrap()
    }

    fn device(class: InputClass) -> LogicalDevice {
        LogicalDevice { class, number: 1 }
    }

    fn start(workstation: &mut Scripted, class: InputClass, initial: Measure) {
        let all = Rect::new(0.0, 0.04, 0.0, 0.02);
        let detail = Detail::Locator;
        let setting =
            Setting { echo: true, prompt: 1, area: all, within: all, initial, detail, picture: None };
        workstation.start(device(class), &setting).unwrap();
    }

    #[test]
    fn steps_are_reported_in_order_and_then_nobody_is_there() {
        let mut operated = scripted("locator 1 0.5 0.5\nbreak\ntogether\nlocator 1 0 0\nvaluator 1 3\nend\n");
        start(&mut operated, InputClass::Locator, Measure::Locator(Point::new(0.0, 0.0)));
        start(&mut operated, InputClass::Valuator, Measure::Valuator(0.0));
        let place = |x, y| (device(InputClass::Locator), Measure::Locator(Point::new(x, y)));
        let Report::Trigger(first) = operated.wait(None).unwrap() else { panic!("no trigger") };
        let [(of, Measure::Locator(at))] = &first[..] else { panic!("{first:?}") };
        assert_eq!(*of, device(InputClass::Locator));
        assert!(at.0.distance(glam::dvec2(0.01, 0.01)) < 1e-12, "{at:?}");
        assert_eq!(operated.wait(None).unwrap(), Report::Break);
        let number = (device(InputClass::Valuator), Measure::Valuator(3.0));
        assert_eq!(operated.wait(None).unwrap(), Report::Trigger(vec![place(0.0, 0.0), number]));
        assert_eq!(operated.wait(None).unwrap(), Report::Gone);
    }

    #[test]
    fn a_step_for_a_device_that_is_not_started_is_an_error_that_names_the_line() {
        let mut operated = scripted("# out of step\nchoice 1 2\nbreak");
        let said = operated.wait(None).unwrap_err().to_string();
        assert!(said.ends_with("line 2 of the script: choice 1 is not started"), "{said}");
        assert_eq!(operated.wait(None).unwrap(), Report::Break);
    }

    #[test]
    fn a_sample_takes_only_what_is_about_its_device() {
        let mut operated = scripted("valuator 1 2\nchoice 1 1\nvaluator 1 3");
        start(&mut operated, InputClass::Valuator, Measure::Valuator(0.5));
        start(&mut operated, InputClass::Choice, Measure::Choice(None));
        let valuator = device(InputClass::Valuator);
        for _ in 0..2 {
            assert_eq!(operated.sample(valuator).unwrap(), Some(Measure::Valuator(2.0)));
        }
        assert_eq!(operated.sample(device(InputClass::Choice)).unwrap(), Some(Measure::Choice(Some(1))));
        assert_eq!(operated.sample(valuator).unwrap(), Some(Measure::Valuator(3.0)));
        assert_eq!(operated.sample(device(InputClass::String)).unwrap(), None);
    }

    #[test]
    fn time_passes_and_files_that_cannot_be_written_are_reported() {
        let mut operated = scripted("wait 0.05\nsnapshot here.png\nbreak");
        let before = Instant::now();
        assert_eq!(operated.wait(Some(Duration::from_millis(1))).unwrap(), Report::Nothing);
        assert!(operated.wait(None).unwrap_err().to_string().contains("here.png"));
        assert!(before.elapsed() >= Duration::from_millis(50));
        assert_eq!(operated.wait(None).unwrap(), Report::Break);
    }
}
