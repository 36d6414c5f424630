//! The workstation types of these tests: those of the library, recorded, and some that fail or have a category
//! that no driver serves.

use gks_pipeline::description::{Catalogue, Category, Description, OpenError};
use gks_pipeline::device::{Device, DeviceError, Drawn, FrameBuffer, Mark, Page, Surface};
use gks_pipeline::input::{Input, LogicalDevice, Measure, Report, Setting};
use gks_pipeline::record::{Record, Source, SourceError};
use gks_pipeline::workstation::Backend;
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use std::collections::BTreeMap;
use std::io;
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// The type of the library that draws nothing, a display surface without pixels.
pub(crate) const NULL: i32 = 900;
/// The type of the library that keeps its pixels, in true colour, and writes nothing.
pub(crate) const FRAME_BUFFER: i32 = 120;
/// As [`NULL`], but nothing can be written to it.
pub(crate) const BROKEN: i32 = 90_001;
/// As [`NULL`], but no picture can be encoded.
pub(crate) const UNENCODABLE: i32 = 90_002;
/// As [`FRAME_BUFFER`], but with a table of 256 colours.
pub(crate) const INDEXED: i32 = 90_003;
/// As [`NULL`], but with an operator and [`DEVICES`] input devices of each class.
pub(crate) const OPERATED: i32 = 90_004;
/// As [`OPERATED`], but what the operator does is not heard.
pub(crate) const UNHEARD: i32 = 90_005;
/// A metafile that cannot be read.
pub(crate) const UNREADABLE: i32 = 90_006;
/// How many input devices of each class the workstations with an operator have.
pub(crate) const DEVICES: u32 = 3;
/// The type of a category is this number plus the category; otherwise as [`NULL`].
pub(crate) const CATEGORIES: i32 = 91_000;

/// What all devices of a catalogue were asked to do, and the messages, in order.
#[derive(Clone, Default)]
pub(crate) struct Log(Arc<Mutex<Vec<String>>>);

impl Log {
    /// Adds an entry.
    pub(crate) fn push(&self, entry: String) {
        self.0.lock().expect("no thread panics while it holds the log").push(entry);
    }

    /// All entries so far.
    pub(crate) fn entries(&self) -> Vec<String> {
        self.0.lock().expect("no thread panics while it holds the log").clone()
    }
}

/// The catalogue whose devices write to a log.
pub(crate) struct Recording {
    drivers: Drivers,
    log: Log,
}

impl Recording {
    /// The catalogue that writes to `log`.
    pub(crate) fn new(log: Log) -> Recording {
        Recording { drivers: Drivers::new(Environment::default()), log }
    }
}

/// The type of the library that a type of these tests is made of.
fn base(number: i32) -> i32 {
    match number {
        BROKEN | UNENCODABLE | OPERATED | UNHEARD | UNREADABLE => NULL,
        INDEXED => FRAME_BUFFER,
        _ if Category::from_number(number - CATEGORIES).is_some() => NULL,
        _ => number,
    }
}

/// The description of a type of these tests, from that of its base.
fn changed(number: i32, description: Description) -> Description {
    let category = Category::from_number(number - CATEGORIES).unwrap_or(description.category);
    let colours = if number == INDEXED { 256 } else { description.colours };
    let category = if matches!(number, OPERATED | UNHEARD) { Category::OutIn } else { category };
    let category = if number == UNREADABLE { Category::MetafileInput } else { category };
    let input = match category {
        Category::OutIn | Category::Input => [DEVICES; 6],
        _ => description.input,
    };
    Description { number, category, colours, input, ..description }
}

impl Catalogue for Recording {
    fn types(&self) -> Vec<i32> {
        self.drivers.types()
    }

    fn describe(&self, number: i32) -> Option<Description> {
        Some(changed(number, self.drivers.describe(base(number))?))
    }

    fn open(&mut self, number: i32, connection: &str) -> Result<(Backend, Description), OpenError> {
        self.log.push(format!("open {number} \"{connection}\""));
        let (device, description) = self.drivers.open(base(number), connection)?;
        let description = changed(number, description);
        if description.category == Category::MetafileInput {
            let source = Senseless { given: false, is_readable: number != UNREADABLE };
            return Ok((Backend::Source(Box::new(source)), description));
        }
        let Backend::Device(device) = device else {
            return Ok((device, description));
        };
        if number == CATEGORIES + Category::Wiss as i32 {
            return Ok((Backend::Storage, description));
        }
        let operator = matches!(description.category, Category::OutIn | Category::Input)
            .then(|| Operator { is_heard: number != UNHEARD, ..Operator::default() });
        let recorded = Recorded { device, fault: number, log: self.log.clone(), operator };
        Ok((Backend::Device(Box::new(recorded)), description))
    }
}

/// A metafile with one item, which makes no sense.
struct Senseless {
    given: bool,
    is_readable: bool,
}

impl Source for Senseless {
    fn next(&mut self) -> Result<Option<Record<'_>>, SourceError> {
        if !self.is_readable {
            return Err(SourceError::Io(io::Error::other("nothing can be read")));
        }
        if std::mem::replace(&mut self.given, true) {
            return Ok(None);
        }
        Err(SourceError::Malformed { offset: 90, what: "there is no such item".to_owned() })
    }
}

/// A device that writes to the log what it is asked to do.
struct Recorded {
    device: Box<dyn Device>,
    /// The type of the workstation, which may be one that fails.
    fault: i32,
    log: Log,
    operator: Option<Operator>,
}

/// An operator who enters the initial values of all devices that are started, by one trigger at a time.
#[derive(Default)]
struct Operator {
    started: BTreeMap<(i32, i32), (LogicalDevice, Measure)>,
    is_heard: bool,
}

impl Operator {
    fn listen(&self) -> Result<(), DeviceError> {
        if self.is_heard { Ok(()) } else { Err(io::Error::other("nobody is heard").into()) }
    }
}

impl Input for Operator {
    fn start(&mut self, device: LogicalDevice, setting: &Setting) -> Result<(), DeviceError> {
        self.started.insert((device.class as i32, device.number), (device, setting.initial.clone()));
        Ok(())
    }

    fn stop(&mut self, device: LogicalDevice) -> Result<(), DeviceError> {
        self.started.remove(&(device.class as i32, device.number));
        Ok(())
    }

    fn sample(&mut self, device: LogicalDevice) -> Result<Option<Measure>, DeviceError> {
        self.listen()?;
        Ok(self.started.get(&(device.class as i32, device.number)).map(|(_, measure)| measure.clone()))
    }

    fn wait(&mut self, _patience: Option<Duration>) -> Result<Report, DeviceError> {
        self.listen()?;
        Ok(Report::Trigger(self.started.values().cloned().collect()))
    }
}

impl Recorded {
    fn attempt(&self) -> Result<(), DeviceError> {
        match self.fault {
            BROKEN => Err(io::Error::other("nothing can be written").into()),
            UNENCODABLE => Err(DeviceError::Encode("there is no code for it".to_owned())),
            _ => Ok(()),
        }
    }
}

impl Device for Recorded {
    fn surface(&self) -> &Surface {
        self.device.surface()
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.log.push(format!("begin page {}", page.number));
        self.device.begin(page)
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.log.push(format!("erase page {}", page.number));
        self.device.erase(page)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        self.attempt()?;
        self.log.push(format!("draw {mark:?}"));
        self.device.draw(mark)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.log.push("end page".to_owned());
        self.device.end()?;
        self.attempt()
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        self.log.push("close".to_owned());
        self.device.close()?;
        self.attempt()
    }

    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        self.device.frame_buffer()
    }

    fn input(&mut self) -> Option<&mut dyn Input> {
        self.operator.as_mut().map(|operator| operator as &mut dyn Input)
    }
}
