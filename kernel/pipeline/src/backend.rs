//! What is behind a workstation: a device, a metafile, or nothing but the segments that the kernel keeps.

use crate::device::{Device, DeviceError, Drawn, Page};
use crate::record::{PictureRecorder, Record, Recorder, Source};

/// What is behind a workstation.
pub enum Backend {
    /// A device: categories OUTPUT, OUTIN and INPUT.
    Device(Box<dyn Device>),
    /// A metafile that is written and has segments: category MO.
    Recorder(Box<dyn Recorder>),
    /// A metafile that is written and holds pictures only: category MO.
    Pictures(Box<dyn PictureRecorder>),
    /// A metafile that is read: category MI.
    Source(Box<dyn Source>),
    /// Nothing but the segments that the kernel keeps: category WISS.
    Storage,
}

impl Backend {
    pub(crate) fn device(&mut self) -> Option<&mut dyn Device> {
        match self {
            Backend::Device(device) => Some(&mut **device),
            _ => None,
        }
    }

    /// Passes a control function on to a metafile.
    pub(crate) fn control(&mut self, record: &Record<'_>) -> Result<(), DeviceError> {
        match self {
            Backend::Recorder(recorder) => recorder.control(record),
            Backend::Pictures(recorder) => recorder.control(record),
            Backend::Device(_) | Backend::Source(_) | Backend::Storage => Ok(()),
        }
    }

    /// Starts a page over, where that is possible.
    pub(crate) fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        match self {
            Backend::Device(device) => device.erase(page),
            Backend::Pictures(recorder) => recorder.erase(),
            Backend::Recorder(_) | Backend::Source(_) | Backend::Storage => Ok(Drawn::Yes),
        }
    }

    /// Completes the whole output.
    pub(crate) fn close(&mut self) -> Result<(), DeviceError> {
        match self {
            Backend::Device(device) => device.close(),
            Backend::Recorder(recorder) => recorder.close(),
            Backend::Pictures(recorder) => recorder.close(),
            Backend::Source(_) | Backend::Storage => Ok(()),
        }
    }
}
