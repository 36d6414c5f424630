//! The keyboard and the pointer of a terminal: the codes that it sends (ECMA-48; xterm control sequences).

use crate::interactive::event::{Button, Event, Key};
use glam::DVec2;

/// What a terminal sent.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) enum Code {
    /// A key or a character.
    Event(Event),
    /// The pointer: the act, and the column and the row of the cell, from 0.
    Pointer(Act, DVec2),
}

/// What the pointer did.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Act {
    Moved,
    Pressed(Button),
    Released(Button),
    Wheel(i8),
}

/// Takes the codes out of what a terminal sent, piece by piece.
#[derive(Default)]
pub(super) struct Decoder {
    bytes: Vec<u8>,
}

impl Decoder {
    /// Appends what has arrived.
    pub(super) fn push(&mut self, bytes: &[u8]) {
        self.bytes.extend(bytes);
    }

    /// Whether a code has begun and not ended: an escape character may be a key or the start of a code.
    pub(super) fn is_open(&self) -> bool {
        !self.bytes.is_empty()
    }

    /// The next code. If `all` is set, nothing more of it will come.
    pub(super) fn next(&mut self, all: bool) -> Option<Code> {
        loop {
            let (length, code) = match *self.bytes.first()? {
                0x1b => escape(&self.bytes, all)?,
                b'\r' | b'\n' => (1, key(Key::Return)),
                0x08 | 0x7f => (1, key(Key::Backspace)),
                b'\t' => (1, key(Key::Tab)),
                // Interrupt: raw mode takes the signal away, and break is what is meant.
                0x03 => (1, key(Key::Escape)),
                0x04 => (1, Some(Code::Event(Event::Closed))),
                byte if byte < b' ' => (1, None),
                byte => character(byte, &self.bytes, all)?,
            };
            self.bytes.drain(..length);
            if code.is_some() {
                return code;
            }
        }
    }
}

fn key(key: Key) -> Option<Code> {
    Some(Code::Event(Event::Key(key)))
}

/// A character in UTF-8 and its length.
fn character(first: u8, bytes: &[u8], all: bool) -> Option<(usize, Option<Code>)> {
    let length = match first {
        0..0x80 => 1,
        0xc0..0xe0 => 2,
        0xe0..0xf0 => 3,
        0xf0..0xf8 => 4,
        _ => return Some((1, None)),
    };
    if bytes.len() < length {
        return all.then_some((bytes.len(), None));
    }
    let text = std::str::from_utf8(&bytes[..length]).ok();
    match text.and_then(|text| text.chars().next()) {
        Some(character) => Some((length, Some(Code::Event(Event::Character(character))))),
        None => Some((1, None)),
    }
}

/// What starts with an escape character, and its length; none if more is needed.
fn escape(bytes: &[u8], all: bool) -> Option<(usize, Option<Code>)> {
    let alone = Some((1, key(Key::Escape)));
    match bytes.get(1) {
        None => alone.filter(|_| all),
        Some(b'O') => match bytes.get(2) {
            None => alone.filter(|_| all),
            Some(&last) => Some((3, letter(last))),
        },
        Some(b'[') => {
            let end = bytes[2..].iter().position(|byte| (0x40..=0x7e).contains(byte));
            match end {
                None if bytes.len() > 64 => Some((bytes.len(), None)),
                None => alone.filter(|_| all),
                Some(end) => Some((end + 3, sequence(&bytes[2..end + 2], bytes[end + 2]))),
            }
        }
        Some(_) => alone,
    }
}

fn letter(last: u8) -> Option<Code> {
    key(match last {
        b'A' => Key::Up,
        b'B' => Key::Down,
        b'C' => Key::Right,
        b'D' => Key::Left,
        b'H' => Key::Home,
        b'F' => Key::End,
        b'M' => Key::Return,
        b'P'..=b'S' => Key::Function(last - b'P' + 1),
        _ => return None,
    })
}

/// A control sequence: its parameters and its last character.
fn sequence(parameters: &[u8], last: u8) -> Option<Code> {
    let text = std::str::from_utf8(parameters).ok()?;
    if let Some(pointer) = text.strip_prefix('<') {
        return self::pointer(pointer, last);
    }
    if last != b'~' {
        return letter(last);
    }
    let number: u8 = text.split(';').next()?.parse().ok()?;
    key(match number {
        1 | 7 => Key::Home,
        3 => Key::Delete,
        4 | 8 => Key::End,
        5 => Key::PageUp,
        6 => Key::PageDown,
        11..=15 => Key::Function(number - 10),
        17..=21 => Key::Function(number - 11),
        23 | 24 => Key::Function(number - 12),
        _ => return None,
    })
}

/// A report of the pointer (mode 1006): button and modifiers; column; row.
fn pointer(parameters: &str, last: u8) -> Option<Code> {
    let mut numbers = parameters.split(';').map(|number| number.parse::<u16>().ok());
    let (buttons, column, row) = (numbers.next()??, numbers.next()??, numbers.next()??);
    let at = DVec2::new(f64::from(column.max(1) - 1), f64::from(row.max(1) - 1));
    let button = match buttons & 3 {
        0 => Some(Button::Primary),
        1 => Some(Button::Middle),
        2 => Some(Button::Secondary),
        _ => None,
    };
    let act = match (buttons & 0b110_0000, button) {
        (64, _) => Act::Wheel(if buttons & 1 == 0 { 1 } else { -1 }),
        (32, _) => Act::Moved,
        (0, Some(button)) if last == b'M' => Act::Pressed(button),
        (0, Some(button)) if last == b'm' => Act::Released(button),
        _ => return None,
    };
    Some(Code::Pointer(act, at))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(bytes: &[u8]) -> Vec<Code> {
        let mut decoder = Decoder::default();
        decoder.push(bytes);
        std::iter::from_fn(|| decoder.next(true)).collect()
    }

    fn events(bytes: &[u8]) -> Vec<Event> {
        let event = |code| if let Code::Event(event) = code { Some(event) } else { None };
        decoded(bytes).into_iter().filter_map(event).collect()
    }

    #[test]
    fn characters_and_keys() {
        let c = Event::Character;
        assert_eq!(events("a\u{e4}\u{1f600}".as_bytes()), [c('a'), c('\u{e4}'), c('\u{1f600}')]);
        let keys = |bytes: &[u8]| -> Vec<Key> {
            events(bytes)
                .into_iter()
                .filter_map(|e| if let Event::Key(k) = e { Some(k) } else { None })
                .collect()
        };
        assert_eq!(
            keys(b"\r\x7f\t\x1b[A\x1b[D\x1bOC"),
            [Key::Return, Key::Backspace, Key::Tab, Key::Up, Key::Left, Key::Right]
        );
        assert_eq!(
            keys(b"\x1b[3~\x1b[H\x1b[4~\x1b[5~\x1b[1;5F"),
            [Key::Delete, Key::Home, Key::End, Key::PageUp, Key::End]
        );
        let f = Key::Function;
        assert_eq!(
            keys(b"\x1bOP\x1b[15~\x1b[17~\x1b[21~\x1b[23~\x1b[24~"),
            [f(1), f(5), f(6), f(10), f(11), f(12)]
        );
        assert_eq!(keys(b"\x1b\x1b"), [Key::Escape, Key::Escape]);
        assert_eq!(keys(b"\x03"), [Key::Escape]);
        assert_eq!(events(b"\x04"), [Event::Closed]);
    }

    #[test]
    fn the_pointer_in_cells() {
        let codes = decoded(b"\x1b[<35;10;5M\x1b[<0;1;1M\x1b[<2;1;1m\x1b[<65;3;3M");
        let at = DVec2::new;
        assert_eq!(
            codes,
            [
                Code::Pointer(Act::Moved, at(9.0, 4.0)),
                Code::Pointer(Act::Pressed(Button::Primary), at(0.0, 0.0)),
                Code::Pointer(Act::Released(Button::Secondary), at(0.0, 0.0)),
                Code::Pointer(Act::Wheel(-1), at(2.0, 2.0)),
            ]
        );
    }

    #[test]
    fn codes_may_come_in_pieces() {
        let mut decoder = Decoder::default();
        for byte in *b"\x1b[1" {
            decoder.push(&[byte]);
            assert_eq!(decoder.next(false), None);
            assert!(decoder.is_open());
        }
        decoder.push(b"7~x");
        assert_eq!(decoder.next(false), Some(Code::Event(Event::Key(Key::Function(6)))));
        assert_eq!(decoder.next(false), Some(Code::Event(Event::Character('x'))));
        decoder.push("\u{20ac}".as_bytes()[..2].as_ref());
        assert_eq!(decoder.next(false), None);
        assert_eq!(decoder.next(true), None);
        assert!(!decoder.is_open());
    }

    #[test]
    fn nonsense_is_passed_over() {
        for bytes in
            [&b"\xff\xfe\x80"[..], b"\x1b[999;9~", b"\x1b[<1M", b"\x1b[<99999;1;1M", b"\x00\x01\x1b[z"]
        {
            assert_eq!(decoded(bytes), [], "{bytes:?}");
        }
        assert!(
            !decoded(&[0x1b, b'['].iter().copied().chain([b'1'; 100]).collect::<Vec<u8>>())
                .contains(&Code::Event(Event::Closed))
        );
    }
}
