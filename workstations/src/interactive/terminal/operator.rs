//! Who operates a terminal: the keyboard and the pointer while input is wanted.

use super::keyboard::{Act, Code, Decoder};
use super::{Attention, Tty};
use crate::interactive::event::Event;
use crate::interactive::queue::Operator;
use glam::DVec2;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;
use rustix::termios::{
    InputModes, LocalModes, OptionalActions, SpecialCodeIndex, Termios, tcgetattr, tcsetattr,
};
use std::io::{Read, Write};
use std::time::{Duration, Instant};

/// How long an escape character waits for the rest of a code before it is a key.
const ESCAPE: Duration = Duration::from_millis(40);

/// Takes the whole terminal: other screen, hidden cursor, the pointer reported in any state.
const TAKE: &[u8] = b"\x1b[?1049h\x1b[2J\x1b[H\x1b[?25l\x1b[?1003h\x1b[?1006h";
/// Gives it back.
const GIVE: &[u8] = b"\x1b[?1006l\x1b[?1003l\x1b[?25h\x1b[?1049l";

/// The operator of a workstation without one.
pub(super) struct Nobody;

impl Operator for Nobody {
    fn next(&mut self, _: Option<Duration>) -> Option<Event> {
        Some(Event::Closed)
    }
}

/// The keyboard of a terminal.
pub(super) struct Keyboard {
    tty: Tty,
    decoder: Decoder,
    /// How the terminal was before input was wanted.
    saved: Option<Termios>,
    attention: Attention,
    closed: bool,
}

impl Keyboard {
    pub(super) fn new(tty: Tty, attention: Attention) -> Keyboard {
        Keyboard { tty, decoder: Decoder::default(), saved: None, attention, closed: false }
    }

    fn take(&mut self) {
        let Ok(saved) = tcgetattr(&self.tty) else {
            self.closed = true;
            return;
        };
        let mut raw = saved.clone();
        // Keys come one by one and unseen; output is still processed, for the program may print.
        raw.local_modes.remove(LocalModes::ICANON | LocalModes::ECHO | LocalModes::ISIG | LocalModes::IEXTEN);
        raw.input_modes.remove(InputModes::ICRNL | InputModes::IXON);
        raw.special_codes[SpecialCodeIndex::VMIN] = 0;
        raw.special_codes[SpecialCodeIndex::VTIME] = 0;
        if tcsetattr(&self.tty, OptionalActions::Now, &raw).is_err() {
            self.closed = true;
            return;
        }
        self.saved = Some(saved);
        self.closed |= self.tty.write_all(TAKE).is_err();
        self.attention.change(|stand| stand.whole = true);
    }

    fn give(&mut self) {
        if let Some(saved) = self.saved.take() {
            // A terminal that is gone needs nothing given back.
            let _ = self.tty.write_all(GIVE);
            let _ = tcsetattr(&self.tty, OptionalActions::Now, &saved);
            self.attention.change(|stand| stand.whole = false);
        }
    }

    fn event(&self, code: Code) -> Event {
        let (act, cell) = match code {
            Code::Event(event) => return event,
            Code::Pointer(act, cell) => (act, cell),
        };
        let at = (cell + 0.5) * DVec2::from(self.attention.get().cell);
        match act {
            Act::Moved => Event::Moved(at),
            Act::Pressed(button) => Event::Pressed(button, at),
            Act::Released(button) => Event::Released(button, at),
            Act::Wheel(notches) => Event::Wheel(f64::from(notches)),
        }
    }

    /// Reads what has been typed, after waiting for it; whether something came.
    fn read(&mut self, patience: Option<Duration>) -> bool {
        let timeout = patience.and_then(|patience| Timespec::try_from(patience).ok());
        match poll(&mut [PollFd::new(&self.tty, PollFlags::IN)], timeout.as_ref()) {
            Ok(0) | Err(Errno::INTR) => return false,
            Ok(_) => {}
            Err(_) => self.closed = true,
        }
        let mut buffer = [0; 1024];
        match self.tty.read(&mut buffer) {
            Ok(count) if count > 0 => {
                self.decoder.push(&buffer[..count]);
                return true;
            }
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            // It was ready and has nothing: the terminal is gone.
            _ => self.closed = true,
        }
        false
    }
}

impl Operator for Keyboard {
    fn next(&mut self, patience: Option<Duration>) -> Option<Event> {
        let end = patience.and_then(|patience| Instant::now().checked_add(patience));
        loop {
            if self.closed {
                return Some(Event::Closed);
            }
            // What is typed while no input is wanted is meant for the program's own input.
            self.saved.as_ref()?;
            if let Some(code) = self.decoder.next(false) {
                let event = self.event(code);
                self.closed |= event == Event::Closed;
                return Some(event);
            }
            let rest = end.map(|end| end.saturating_duration_since(Instant::now()));
            if self.decoder.is_open() {
                if !self.read(Some(rest.map_or(ESCAPE, |rest| rest.min(ESCAPE))))
                    && let Some(code) = self.decoder.next(true)
                {
                    return Some(self.event(code));
                }
            } else if !self.read(rest) && rest.is_some_and(|rest| rest.is_zero()) {
                return self.closed.then_some(Event::Closed);
            }
        }
    }

    fn attend(&mut self, on: bool) -> bool {
        if on {
            self.take();
        } else {
            self.give();
        }
        true
    }
}

impl Drop for Keyboard {
    fn drop(&mut self) {
        self.give();
    }
}
