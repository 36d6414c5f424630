//! The events that have arrived and that the program has not yet asked for.

use super::event::Event;
use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Beyond so many events, movements in a row count as one.
const CROWDED: usize = 256;
/// Beyond so many events, all but the end of the operator is dropped: nobody is listening.
const FULL: usize = 65536;

/// Where events come from.
pub trait Operator: Send {
    /// The next event, waiting for it at most as long as `patience` says (none: as long as it takes); none if
    /// there is none. After [`Event::Closed`] nothing but this comes.
    fn next(&mut self, patience: Option<Duration>) -> Option<Event>;

    /// Says that input is wanted from now on, or not any more; whether the screen has to be drawn again.
    fn attend(&mut self, _on: bool) -> bool {
        false
    }
}

/// A queue of events that others fill.
#[derive(Clone, Default)]
pub struct EventQueue {
    shared: Arc<(Mutex<State>, Condvar)>,
}

#[derive(Default)]
struct State {
    events: VecDeque<Event>,
    closed: bool,
}

impl EventQueue {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.shared.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Appends an event.
    pub fn push(&self, event: Event) {
        let mut state = self.lock();
        match (event, state.events.back()) {
            (Event::Closed, _) => state.closed = true,
            (Event::Moved(_), Some(Event::Moved(_))) if state.events.len() >= CROWDED => {
                state.events.pop_back();
                state.events.push_back(event);
            }
            _ if state.events.len() >= FULL => {}
            _ => state.events.push_back(event),
        }
        drop(state);
        self.shared.1.notify_all();
    }
}

impl Operator for EventQueue {
    fn next(&mut self, patience: Option<Duration>) -> Option<Event> {
        let end = patience.and_then(|patience| Instant::now().checked_add(patience));
        let mut state = self.lock();
        loop {
            if let Some(event) = state.events.pop_front() {
                return Some(event);
            }
            if state.closed {
                return Some(Event::Closed);
            }
            let wake = &self.shared.1;
            state = match end {
                None => wake.wait(state).unwrap_or_else(PoisonError::into_inner),
                Some(end) => {
                    let rest = end.checked_duration_since(Instant::now())?;
                    if rest.is_zero() {
                        return None;
                    }
                    wake.wait_timeout(state, rest).unwrap_or_else(PoisonError::into_inner).0
                }
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    const NOW: Option<Duration> = Some(Duration::ZERO);

    #[test]
    fn events_come_in_order_and_the_end_stays() {
        let mut queue = EventQueue::default();
        assert_eq!(queue.next(NOW), None);
        queue.push(Event::Character('a'));
        queue.push(Event::Wheel(1.0));
        queue.push(Event::Closed);
        assert_eq!(queue.next(None), Some(Event::Character('a')));
        assert_eq!(queue.next(None), Some(Event::Wheel(1.0)));
        assert_eq!(queue.next(None), Some(Event::Closed));
        assert_eq!(queue.next(NOW), Some(Event::Closed));
    }

    #[test]
    fn movements_that_nobody_asks_for_do_not_pile_up() {
        let mut queue = EventQueue::default();
        for x in 0..100_000 {
            queue.push(Event::Moved(DVec2::new(f64::from(x), 0.0)));
        }
        for _ in 0..100_000 {
            queue.push(Event::Wheel(1.0));
        }
        let events: Vec<Event> = std::iter::from_fn(|| queue.next(NOW)).collect();
        assert!(events.len() <= FULL);
        assert_eq!(events[CROWDED - 1], Event::Moved(DVec2::new(99_999.0, 0.0)));
    }

    #[test]
    fn whoever_waits_is_woken() {
        let mut queue = EventQueue::default();
        let other = queue.clone();
        let late = std::thread::spawn(move || {
            std::thread::sleep(Duration::from_millis(30));
            other.push(Event::Closed);
        });
        assert_eq!(queue.next(Some(Duration::from_millis(1))), None);
        assert_eq!(queue.next(None), Some(Event::Closed));
        late.join().unwrap();
    }
}
