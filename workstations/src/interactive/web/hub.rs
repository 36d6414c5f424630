//! What the page server's threads share: the picture, who watches it, and who steers.

use crate::interactive::event::Event;
use crate::interactive::frame::{Area, Frame};
use crate::interactive::queue::EventQueue;
use std::io::{self, Write};
use std::os::unix::net::UnixStream;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// How long requests wait for somebody to come back after the last viewer has left.
pub(super) const GRACE: Duration = Duration::from_secs(10);

/// The state that the threads share.
pub(super) struct Hub {
    state: Mutex<State>,
    changed: Condvar,
    /// What whoever steers does.
    pub(super) events: EventQueue,
    /// Number of columns and rows of the picture.
    pub(super) size: (u32, u32),
    pub(super) title: String,
}

struct State {
    /// Red, green and blue of each pixel.
    pixels: Vec<u8>,
    viewers: Vec<Viewer>,
    /// The number of the next viewer.
    next: u64,
    /// The viewer whose acts count.
    steering: Option<u64>,
    ended: bool,
}

/// A page that is connected.
struct Viewer {
    number: u64,
    /// What it has not been sent yet.
    missing: Option<Area>,
    /// Whether it has been sent all that there was when it last asked.
    served: bool,
    /// Wakes the thread that serves it.
    wake: UnixStream,
}

/// What a viewer is to be sent next.
pub(super) struct Portion {
    /// A part of the picture: red, green and blue of each pixel.
    pub(super) part: Option<(Area, Vec<u8>)>,
    pub(super) steers: bool,
    pub(super) ended: bool,
}

/// The smallest area that contains two.
fn union(a: Area, b: Area) -> Area {
    let (x, y) = (a.x.min(b.x), a.y.min(b.y));
    let (right, lower) = ((a.x + a.width).max(b.x + b.width), (a.y + a.height).max(b.y + b.height));
    Area { x, y, width: right - x, height: lower - y }
}

impl Hub {
    pub(super) fn new(size: (u32, u32), title: &str, events: EventQueue) -> Hub {
        let state = State {
            pixels: vec![255; size.0 as usize * size.1 as usize * 3],
            viewers: Vec::new(),
            next: 0,
            steering: None,
            ended: false,
        };
        Hub { state: Mutex::new(state), changed: Condvar::new(), events, size, title: title.to_owned() }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes over what changed in the picture.
    pub(super) fn update(&self, frame: &Frame, changed: Area) {
        let mut state = self.lock();
        let stride = self.size.0 as usize * 3;
        let State { pixels, viewers, .. } = &mut *state;
        let lines = pixels.chunks_exact_mut(stride).skip(changed.y as usize);
        for (line, row) in lines.zip(frame.rows(changed)) {
            let line = line[changed.x as usize * 3..].chunks_exact_mut(3);
            line.zip(row.chunks_exact(4)).for_each(|(to, from)| to.copy_from_slice(&from[..3]));
        }
        for viewer in viewers {
            viewer.missing = Some(viewer.missing.map_or(changed, |missing| union(missing, changed)));
            viewer.wake();
        }
    }

    /// Adds a viewer, which steers if nobody does.
    pub(super) fn join(&self, wake: UnixStream) -> u64 {
        let mut state = self.lock();
        let number = state.next;
        state.next += 1;
        let missing = Some(Area { x: 0, y: 0, width: self.size.0, height: self.size.1 });
        state.viewers.push(Viewer { number, missing, served: false, wake });
        state.steering.get_or_insert(number);
        number
    }

    /// Removes a viewer; the one that has been there longest steers then.
    pub(super) fn leave(&self, number: u64) {
        let mut state = self.lock();
        state.viewers.retain(|viewer| viewer.number != number);
        if state.steering == Some(number) {
            state.steering = state.viewers.first().map(|viewer| viewer.number);
            state.viewers.iter().for_each(Viewer::wake);
        }
        self.changed.notify_all();
        if state.viewers.is_empty() {
            // Who reloads the page is not gone.
            let nobody = |state: &mut State| state.viewers.is_empty() && !state.ended;
            let (state, _) =
                self.changed.wait_timeout_while(state, GRACE, nobody).unwrap_or_else(PoisonError::into_inner);
            if state.viewers.is_empty() {
                self.events.push(Event::Closed);
            }
        }
    }

    /// Makes a viewer the one that steers.
    pub(super) fn take_over(&self, number: u64) {
        let mut state = self.lock();
        state.steering = Some(number);
        state.viewers.iter().for_each(Viewer::wake);
    }

    /// Passes on what a viewer did if it is the one that steers.
    pub(super) fn act(&self, number: u64, event: Event) {
        if self.lock().steering == Some(number) && event != Event::Closed {
            self.events.push(event);
        }
    }

    /// What a viewer is to be sent; none if it is not known.
    pub(super) fn portion(&self, number: u64) -> Option<Portion> {
        let mut state = self.lock();
        let State { pixels, viewers, steering, ended, .. } = &mut *state;
        let viewer = viewers.iter_mut().find(|viewer| viewer.number == number)?;
        let stride = self.size.0 as usize * 3;
        let part = viewer.missing.take().map(|area| {
            let rows = pixels.chunks_exact(stride).skip(area.y as usize).take(area.height as usize);
            let columns = area.x as usize * 3..(area.x + area.width) as usize * 3;
            (area, rows.flat_map(|row| &row[columns.clone()]).copied().collect())
        });
        viewer.served = part.is_none();
        let portion = Portion { part, steers: *steering == Some(number), ended: *ended };
        drop(state);
        self.changed.notify_all();
        Some(portion)
    }

    /// Ends it. Waits until all viewers have the last picture, but not for long; if `stay` is set, it waits
    /// as long as it takes until somebody has come and everybody has left.
    pub(super) fn end(&self, stay: bool) {
        let mut state = self.lock();
        if stay {
            let watched = |state: &mut State| state.next == 0 || !state.viewers.is_empty();
            state = self.changed.wait_while(state, watched).unwrap_or_else(PoisonError::into_inner);
        }
        let end = Instant::now() + Duration::from_secs(2);
        while state.viewers.iter().any(|viewer| !viewer.served || viewer.missing.is_some()) {
            let rest = end.saturating_duration_since(Instant::now());
            if rest.is_zero() {
                break;
            }
            state = self.changed.wait_timeout(state, rest).unwrap_or_else(PoisonError::into_inner).0;
        }
        state.ended = true;
        state.viewers.iter().for_each(Viewer::wake);
        drop(state);
        self.changed.notify_all();
    }

    /// Waits a moment for the viewers to hear that it has ended.
    pub(super) fn farewell(&self) {
        let state = self.lock();
        let some = |state: &mut State| !state.viewers.is_empty();
        let patience = Duration::from_secs(1);
        drop(self.changed.wait_timeout_while(state, patience, some).unwrap_or_else(PoisonError::into_inner));
    }
}

impl Viewer {
    /// Wakes its thread. One that has been woken often already needs no more of it.
    fn wake(&self) {
        match (&self.wake).write(&[0]) {
            Err(error) if error.kind() != io::ErrorKind::WouldBlock => {}
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interactive::queue::Operator;
    use glam::DVec2;
    use std::sync::Arc;

    fn hub() -> Hub {
        Hub::new((4, 3), "title", EventQueue::default())
    }

    fn viewer(hub: &Hub) -> u64 {
        let (wake, _) = UnixStream::pair().unwrap();
        wake.set_nonblocking(true).unwrap();
        hub.join(wake)
    }

    #[test]
    fn a_viewer_gets_everything_and_then_what_changed() {
        let hub = hub();
        let mut frame = Frame::new(4, 3);
        let mut picture = vec![255; 48];
        let all = frame.compose(&picture, None).unwrap();
        hub.update(&frame, all);
        let number = viewer(&hub);
        let (area, pixels) = hub.portion(number).unwrap().part.unwrap();
        assert_eq!((area, pixels.len()), (all, 36));
        assert!(hub.portion(number).unwrap().part.is_none());
        // Two changes that it was too slow for come as one.
        for column in [1, 2] {
            picture[(4 + column) * 4] = 7;
            let changed = frame.compose(&picture, None).unwrap();
            hub.update(&frame, changed);
        }
        let (area, pixels) = hub.portion(number).unwrap().part.unwrap();
        assert_eq!(area, Area { x: 1, y: 1, width: 2, height: 1 });
        assert_eq!(pixels, [7, 255, 255, 7, 255, 255]);
    }

    #[test]
    fn the_first_steers_until_another_takes_over() {
        let hub = Arc::new(hub());
        let (first, second) = (viewer(&hub), viewer(&hub));
        assert!(hub.portion(first).unwrap().steers && !hub.portion(second).unwrap().steers);
        let event = |x| Event::Moved(DVec2::new(x, 0.0));
        hub.act(first, event(1.0));
        hub.act(second, event(2.0));
        hub.take_over(second);
        hub.act(first, event(3.0));
        hub.act(second, event(4.0));
        hub.leave(second);
        assert!(hub.portion(first).unwrap().steers);
        hub.act(first, event(5.0));
        hub.act(first, Event::Closed);
        let mut events = hub.events.clone();
        let seen: Vec<_> = std::iter::from_fn(|| events.next(Some(Duration::ZERO))).collect();
        assert_eq!(seen, [event(1.0), event(4.0), event(5.0)]);
        assert!(hub.portion(second).is_none());
    }

    #[test]
    fn a_viewer_that_is_stuck_does_not_hold_up_the_end_for_long() {
        let hub = hub();
        viewer(&hub);
        let start = Instant::now();
        hub.end(false);
        hub.farewell();
        assert!(start.elapsed() < Duration::from_secs(6));
    }
}
