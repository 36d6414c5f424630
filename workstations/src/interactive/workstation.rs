//! The device of all interactive workstations: the true-colour frame buffer, a screen and a console.

use super::console::Console;
use super::echo;
use super::event::Event;
use super::presenter::{Ending, Presenter, Screen};
use super::queue::Operator;
use super::sketch::Sketch;
use crate::options::Options;
use crate::raster::TrueColour;
use gks_pipeline::device::{Device, DeviceError, Drawn, FrameBuffer, Mark, Page, Surface};
use gks_pipeline::input::{Input, LogicalDevice, Measure, Report, Setting};
use gks_pipeline::trace::Trace;
use std::time::{Duration, Instant};

/// The part of the surroundings in which an operator is; none where nobody is.
pub(super) struct Operation {
    operator: Box<dyn Operator>,
    console: Console,
    sketch: Sketch,
    /// Whether echoes are visible.
    echoed: bool,
    /// Whether the operator is gone.
    gone: bool,
}

/// An interactive workstation.
pub(super) struct Interactive {
    canvas: TrueColour,
    presenter: Presenter,
    operation: Option<Operation>,
    /// Whether the last picture stays visible; none if that depends on whether somebody operated it.
    keep: Option<bool>,
    operated: bool,
}

impl Interactive {
    /// A workstation that shows its picture on a screen, and that somebody operates if there is an operator.
    pub(super) fn new(
        options: &Options,
        screen: Box<dyn Screen>,
        operator: Option<Box<dyn Operator>>,
    ) -> Result<Interactive, String> {
        let canvas = TrueColour::new(options, None).map_err(|error| error.to_string())?;
        let operation = operator
            .map(|operator| {
                Ok::<_, String>(Operation {
                    operator,
                    console: Console::new(canvas.surface()),
                    sketch: Sketch::new(canvas.surface())?,
                    echoed: false,
                    gone: false,
                })
            })
            .transpose()?;
        let presenter = Presenter::start(canvas.shared(), screen).map_err(|error| error.to_string())?;
        Ok(Interactive { canvas, presenter, operation, keep: options.keep, operated: false })
    }
}

impl Operation {
    /// Takes all events that have arrived; the answer is whether echoes may have changed.
    fn drain(&mut self) -> bool {
        let mut changed = false;
        while !self.gone
            && let Some(event) = self.operator.next(Some(Duration::ZERO))
        {
            changed |= self.take(event);
        }
        changed
    }

    fn take(&mut self, event: Event) -> bool {
        self.gone |= event == Event::Closed;
        self.console.handle(event)
    }

    /// Says whether input is wanted.
    fn attend(&mut self, on: bool, presenter: &Presenter) {
        // What is being shown is meant for the screen as it is now.
        presenter.settle();
        if self.operator.attend(on) {
            presenter.forget();
        }
    }

    /// Shows the echoes as they are now.
    fn echo(&mut self, presenter: &Presenter) -> Result<(), DeviceError> {
        if echo::draw(&self.console, &mut self.sketch)? {
            presenter.set_overlay(Some(self.sketch.pixels()));
            self.echoed = true;
        } else if std::mem::take(&mut self.echoed) {
            presenter.set_overlay(None);
        }
        Ok(())
    }
}

impl Device for Interactive {
    fn surface(&self) -> &Surface {
        self.canvas.surface()
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.presenter.save();
        if let Some(operation) = &mut self.operation {
            operation.sketch.set_paper(page.background);
        }
        self.canvas.begin(page)
    }

    /// What is drawn again takes the place of the picture before the operator's eyes.
    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.begin(page)?;
        Ok(Drawn::Yes)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        self.canvas.draw(mark)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.presenter.show_page();
        self.canvas.end()
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        if let Some(operation) = &mut self.operation
            && operation.echoed
        {
            self.presenter.set_overlay(None);
        }
        self.presenter.end(Ending { keep: self.keep, operated: self.operated });
        self.canvas.close()
    }

    fn frame_buffer(&mut self) -> Option<&mut dyn FrameBuffer> {
        self.canvas.frame_buffer()
    }

    fn flush(&mut self) -> Result<(), DeviceError> {
        self.presenter.show_page();
        Ok(())
    }

    fn input(&mut self) -> Option<&mut dyn Input> {
        if self.operation.is_some() { Some(self) } else { None }
    }
}

impl Input for Interactive {
    fn start(&mut self, device: LogicalDevice, setting: &Setting) -> Result<(), DeviceError> {
        self.operated = true;
        let Some(operation) = &mut self.operation else { return Ok(()) };
        // What the operator did while nothing was started was not meant for this device.
        operation.drain();
        if operation.console.is_idle() {
            operation.attend(true, &self.presenter);
        }
        operation.console.start(device, setting);
        self.presenter.show();
        operation.echo(&self.presenter)
    }

    fn stop(&mut self, device: LogicalDevice) -> Result<(), DeviceError> {
        let Some(operation) = &mut self.operation else { return Ok(()) };
        let idle = operation.console.is_idle();
        operation.console.stop(device);
        operation.echo(&self.presenter)?;
        if operation.console.is_idle() && !idle {
            operation.attend(false, &self.presenter);
        }
        Ok(())
    }

    fn sample(&mut self, device: LogicalDevice) -> Result<Option<Measure>, DeviceError> {
        let Some(operation) = &mut self.operation else { return Ok(None) };
        if operation.drain() {
            operation.echo(&self.presenter)?;
        }
        Ok(operation.console.measure(device).filter(|_| !operation.gone))
    }

    fn show(&mut self, device: LogicalDevice, picked: Trace) -> Result<(), DeviceError> {
        let Some(operation) = &mut self.operation else { return Ok(()) };
        operation.console.show(device, picked);
        operation.echo(&self.presenter)
    }

    fn wait(&mut self, patience: Option<Duration>) -> Result<Report, DeviceError> {
        self.presenter.show();
        let end = patience.and_then(|patience| Instant::now().checked_add(patience));
        let Some(operation) = &mut self.operation else { return Ok(Report::Gone) };
        loop {
            if operation.drain() {
                operation.echo(&self.presenter)?;
            }
            if let Some(report) = operation.console.report() {
                return Ok(report);
            }
            if operation.gone {
                return Ok(Report::Gone);
            }
            if let Some(question) = operation.console.question() {
                return Ok(question);
            }
            let rest = end.map(|end| end.saturating_duration_since(Instant::now()));
            match operation.operator.next(rest) {
                Some(event) => {
                    if operation.take(event) {
                        operation.echo(&self.presenter)?;
                    }
                }
                None => return Ok(Report::Nothing),
            }
        }
    }
}
