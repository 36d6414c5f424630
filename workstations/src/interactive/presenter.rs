//! Shows the picture while it grows, without holding up the program that draws it.
//!
//! A thread of its own hands the picture to the screen, at most as often as the screen likes; what is drawn
//! in between appears with the next one. A screen that is slow or gone costs the program nothing.

use super::frame::{Area, Frame};
use crate::raster::SharedPixels;
use std::io;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

/// Where a picture appears.
pub trait Screen: Send {
    /// Shows a picture of which an area changed since it was shown last.
    fn show(&mut self, frame: &Frame, changed: Area) -> io::Result<()>;

    /// Ends it.
    fn close(&mut self, ending: Ending);

    /// The time that passes at least between two pictures.
    fn pace(&self) -> Duration {
        Duration::from_millis(16)
    }

    /// Whether the picture is shown while it grows, so that one that is replaced at once need not be seen. One
    /// that is not growing shows every page.
    fn is_growing(&self) -> bool {
        true
    }
}

/// How a screen ends.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Ending {
    /// Whether the user wants the last picture to stay visible; none where that is left to the screen.
    pub keep: Option<bool>,
    /// Whether the program has asked the operator for something.
    pub operated: bool,
}

/// The thread that shows a picture.
pub(super) struct Presenter {
    stage: Arc<Stage>,
    growing: bool,
    thread: Option<JoinHandle<()>>,
}

struct Stage {
    pixels: SharedPixels,
    state: Mutex<State>,
    wake: Condvar,
}

#[derive(Default)]
struct State {
    /// Whether something is to be shown.
    wanted: bool,
    /// Whether something is being shown.
    busy: bool,
    /// Whether what has been shown is no longer there.
    forgotten: bool,
    /// The picture to be shown where the one in the frame buffer is a later one.
    picture: Option<Vec<u8>>,
    overlay: Option<Arc<Vec<u8>>>,
    /// Whether to end, and how.
    end: Option<Ending>,
}

impl Stage {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Presenter {
    /// A thread that shows pixels on a screen.
    pub(super) fn start(pixels: SharedPixels, screen: Box<dyn Screen>) -> io::Result<Presenter> {
        let stage = Arc::new(Stage { pixels, state: Mutex::default(), wake: Condvar::new() });
        let growing = screen.is_growing();
        let shared = Arc::clone(&stage);
        let thread = Builder::new().name("gks screen".to_owned()).spawn(move || run(&shared, screen))?;
        Ok(Presenter { stage, growing, thread: Some(thread) })
    }

    /// Has what has been drawn so far shown soon.
    pub(super) fn show(&self) {
        let mut state = self.stage.lock();
        state.wanted = true;
        // An earlier picture that nobody has seen is out of date now.
        state.picture = None;
        drop(state);
        self.stage.wake.notify_all();
    }

    /// Has what has been drawn shown as a page: a screen on which pictures do not grow has it shown when this
    /// returns.
    pub(super) fn show_page(&self) {
        self.show();
        if !self.growing {
            self.settle();
        }
    }

    /// Waits until everything is shown.
    pub(super) fn settle(&self) {
        let unsettled = |state: &mut State| (state.wanted || state.busy) && state.end.is_none();
        let alive = || self.thread.as_ref().is_some_and(|thread| !thread.is_finished());
        let mut state = self.stage.lock();
        while unsettled(&mut state) && alive() {
            let patience = Duration::from_millis(100);
            let (wake, lock) = (&self.stage.wake, state);
            state = wake.wait_timeout(lock, patience).unwrap_or_else(PoisonError::into_inner).0;
        }
    }

    /// Says that what has been shown is no longer there.
    pub(super) fn forget(&self) {
        self.stage.lock().forgotten = true;
    }

    /// Keeps what is still to be shown, because the frame buffer is about to be cleared.
    pub(super) fn save(&self) {
        let mut state = self.stage.lock();
        if state.wanted && state.picture.is_none() {
            state.picture = Some(self.stage.pixels.read(<[u8]>::to_vec));
        }
    }

    /// Shows echoes over the picture from now on, or none.
    pub(super) fn set_overlay(&self, overlay: Option<Vec<u8>>) {
        let mut state = self.stage.lock();
        state.overlay = overlay.map(Arc::new);
        state.wanted = true;
        drop(state);
        self.stage.wake.notify_all();
    }

    /// Shows the last picture and ends the screen. Without effect if it has ended.
    pub(super) fn end(&mut self, ending: Ending) {
        self.stage.lock().end = Some(ending);
        self.stage.wake.notify_all();
        if let Some(thread) = self.thread.take() {
            // A thread that panicked has ended too.
            let _ = thread.join();
        }
    }
}

impl Drop for Presenter {
    fn drop(&mut self) {
        self.end(Ending { keep: Some(false), operated: true });
    }
}

fn run(stage: &Stage, mut screen: Box<dyn Screen>) {
    let (width, height) = stage.pixels.size();
    let mut frame = Frame::new(width, height);
    let mut alive = true;
    let mut state = stage.lock();
    loop {
        let idle = |state: &mut State| !state.wanted && state.end.is_none();
        state = stage.wake.wait_while(state, idle).unwrap_or_else(PoisonError::into_inner);
        let (wanted, end) = (std::mem::take(&mut state.wanted), state.end);
        let (picture, overlay) = (state.picture.take(), state.overlay.clone());
        if wanted && std::mem::take(&mut state.forgotten) {
            frame.forget();
        }
        state.busy = wanted;
        drop(state);
        let next = Instant::now() + screen.pace();
        if wanted && alive {
            let overlay = overlay.as_ref().map(|overlay| overlay.as_slice());
            let changed = match &picture {
                Some(picture) => frame.compose(picture, overlay),
                None => stage.pixels.read(|pixels| frame.compose(pixels, overlay)),
            };
            if let Some(changed) = changed {
                alive = screen.show(&frame, changed).is_ok();
            }
        }
        if let Some(ending) = end {
            return screen.close(ending);
        }
        state = stage.lock();
        state.busy = false;
        stage.wake.notify_all();
        let rest = next.saturating_duration_since(Instant::now());
        let calm = |state: &mut State| state.end.is_none();
        state = stage.wake.wait_timeout_while(state, rest, calm).unwrap_or_else(PoisonError::into_inner).0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::Options;
    use crate::raster::TrueColour;
    use gks_pipeline::colour::Colour;
    use gks_pipeline::device::{Device, Page};

    /// Remembers the first byte and the area of every picture.
    struct Memory(Arc<Mutex<Vec<(u8, Area)>>>, Duration);

    impl Screen for Memory {
        fn show(&mut self, frame: &Frame, changed: Area) -> io::Result<()> {
            self.0.lock().unwrap().push((frame.pixels()[0], changed));
            Ok(())
        }

        fn close(&mut self, ending: Ending) {
            let area = Area { x: 0, y: 0, width: 0, height: 0 };
            self.0.lock().unwrap().push((u8::from(ending.operated), area));
        }

        fn pace(&self) -> Duration {
            self.1
        }
    }

    fn page(grey: f32) -> Page {
        Page { number: 1, background: Colour::rgb(grey, grey, grey), colours: Vec::new() }
    }

    fn first_bytes(pace: u64, act: impl FnOnce(&mut Presenter, &mut TrueColour)) -> Vec<u8> {
        let options = Options { size: Some((4.0, 4.0)), ..Options::default() };
        let mut device = TrueColour::new(&options, None).unwrap();
        let seen = Arc::default();
        let screen = Memory(Arc::clone(&seen), Duration::from_millis(pace));
        let mut presenter = Presenter::start(device.shared(), Box::new(screen)).unwrap();
        act(&mut presenter, &mut device);
        presenter.end(Ending { keep: None, operated: true });
        let seen = seen.lock().unwrap();
        seen.iter().map(|&(byte, _)| byte).collect()
    }

    #[test]
    fn the_last_picture_is_shown_however_fast_they_come() {
        let bytes = first_bytes(10_000, |presenter, device| {
            for grey in 0..=100 {
                presenter.save();
                device.begin(&page(grey as f32 / 255.0)).unwrap();
                presenter.show();
            }
        });
        assert!(bytes.len() <= 5, "{bytes:?}");
        assert_eq!(bytes[bytes.len() - 2..], [100, 1]);
    }

    #[test]
    fn a_picture_to_be_shown_survives_that_the_frame_buffer_is_cleared() {
        let bytes = first_bytes(200, |presenter, device| {
            device.begin(&page(0.0)).unwrap();
            presenter.show();
            std::thread::sleep(Duration::from_millis(50));
            device.begin(&page(51.0 / 255.0)).unwrap();
            presenter.show();
            presenter.save();
            device.begin(&page(1.0)).unwrap();
        });
        assert_eq!(bytes, [0, 51, 1]);
    }

    #[test]
    fn echoes_come_and_go() {
        let bytes = first_bytes(1, |presenter, device| {
            device.begin(&page(1.0)).unwrap();
            let wait = || std::thread::sleep(Duration::from_millis(60));
            presenter.set_overlay(Some([[0, 0, 0, 255]; 16].concat()));
            wait();
            presenter.set_overlay(None);
            wait();
            presenter.show();
        });
        assert_eq!(bytes, [0, 255, 1], "the same picture is not shown again");
    }
}
