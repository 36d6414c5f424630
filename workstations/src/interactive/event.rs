//! What an operator does, as every screen reports it.

use glam::DVec2;

/// A raw event. Positions are in pixels of the picture, from its upper left corner; whoever shows the
/// picture at another size takes them back.
#[derive(Copy, Clone, Debug, PartialEq)]
pub enum Event {
    /// The pointer moved to a position, which may lie outside of the picture.
    Moved(DVec2),
    /// A button went down at a position.
    Pressed(Button, DVec2),
    /// A button went up at a position.
    Released(Button, DVec2),
    /// The wheel turned by a number of notches, away from the operator if positive.
    Wheel(f64),
    /// A key without a character went down.
    Key(Key),
    /// A character was typed.
    Character(char),
    /// The operator is gone and nothing will ever be reported again.
    Closed,
}

/// A button of the pointer.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Button {
    /// The first, usually the left one.
    Primary,
    /// The one in the middle.
    Middle,
    /// The second, usually the right one.
    Secondary,
}

/// A key without a character.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "they are what is printed on them")]
pub enum Key {
    Return,
    Escape,
    Backspace,
    Delete,
    Tab,
    Left,
    Right,
    Up,
    Down,
    Home,
    End,
    PageUp,
    PageDown,
    /// A function key, from 1.
    Function(u8),
}

const KEYS: [Key; 13] = [
    Key::Return,
    Key::Escape,
    Key::Backspace,
    Key::Delete,
    Key::Tab,
    Key::Left,
    Key::Right,
    Key::Up,
    Key::Down,
    Key::Home,
    Key::End,
    Key::PageUp,
    Key::PageDown,
];

const BUTTONS: [Button; 3] = [Button::Primary, Button::Middle, Button::Secondary];

/// Number of bytes of an event on its way to the program.
pub const EVENT_BYTES: usize = 18;

impl Event {
    /// The event as bytes: a tag, a number, and two values of 8 bytes, little end first.
    pub fn to_bytes(self) -> [u8; EVENT_BYTES] {
        let button = |button| BUTTONS.iter().position(|&b| b == button).unwrap_or(0) as u8;
        let (tag, number, at) = match self {
            Event::Moved(at) => (1, 0, at),
            Event::Pressed(which, at) => (2, button(which), at),
            Event::Released(which, at) => (3, button(which), at),
            Event::Wheel(notches) => (4, 0, DVec2::new(notches, 0.0)),
            Event::Key(Key::Function(number)) => (6, number, DVec2::ZERO),
            Event::Key(key) => (5, KEYS.iter().position(|&k| k == key).unwrap_or(0) as u8, DVec2::ZERO),
            Event::Character(character) => (7, 0, DVec2::new(f64::from(u32::from(character)), 0.0)),
            Event::Closed => (8, 0, DVec2::ZERO),
        };
        let mut bytes = [0; EVENT_BYTES];
        (bytes[0], bytes[1]) = (tag, number);
        bytes[2..10].copy_from_slice(&at.x.to_le_bytes());
        bytes[10..].copy_from_slice(&at.y.to_le_bytes());
        bytes
    }

    /// The event that bytes mean, or none if they mean nothing.
    pub fn from_bytes(bytes: &[u8]) -> Option<Event> {
        let &[tag, number, ref values @ ..] = bytes else { return None };
        let (x, y) = values.split_at_checked(8)?;
        let at = DVec2::new(f64::from_le_bytes(x.try_into().ok()?), f64::from_le_bytes(y.try_into().ok()?));
        // Far outside of every picture, but nothing overflows that is computed from it.
        if !at.is_finite() || at.abs().max_element() > 1e9 {
            return None;
        }
        let button = || BUTTONS.get(usize::from(number)).copied();
        Some(match tag {
            1 => Event::Moved(at),
            2 => Event::Pressed(button()?, at),
            3 => Event::Released(button()?, at),
            4 => Event::Wheel(at.x.clamp(-100.0, 100.0)),
            5 => Event::Key(*KEYS.get(usize::from(number))?),
            6 => Event::Key(Key::Function(number)),
            7 => Event::Character(char::from_u32(at.x as u32)?),
            8 => Event::Closed,
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_survive_the_way_to_the_program() {
        let at = DVec2::new(-3.25, 1e6);
        let keys = KEYS.into_iter().chain([Key::Function(12)]).map(Event::Key);
        let buttons = BUTTONS.into_iter().flat_map(|b| [Event::Pressed(b, at), Event::Released(b, at)]);
        let rest = [Event::Moved(at), Event::Wheel(-1.5), Event::Character('\u{1f600}'), Event::Closed];
        for event in keys.chain(buttons).chain(rest) {
            assert_eq!(Event::from_bytes(&event.to_bytes()), Some(event));
        }
    }

    #[test]
    fn what_means_nothing_is_refused() {
        let mut bytes = Event::Moved(DVec2::ZERO).to_bytes();
        assert_eq!(Event::from_bytes(&bytes[..17]), None);
        assert_eq!(Event::from_bytes(&[]), None);
        for (at, value) in [(0, 0), (0, 9), (9, 0x7f)] {
            let mut wrong = bytes;
            wrong[at] = value;
            if at == 9 {
                wrong[8] = 0xf8;
            }
            assert_eq!(Event::from_bytes(&wrong), None);
        }
        bytes[2..10].copy_from_slice(&1e300f64.to_le_bytes());
        assert_eq!(Event::from_bytes(&bytes), None);
        let surrogate = DVec2::new(f64::from(0xd800), 0.0);
        bytes[2..10].copy_from_slice(&surrogate.x.to_le_bytes());
        bytes[0] = 7;
        assert_eq!(Event::from_bytes(&bytes), None);
        (bytes[0], bytes[1]) = (2, 3);
        assert_eq!(Event::from_bytes(&bytes), None);
    }
}
