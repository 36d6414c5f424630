//! What a program and the process that shows its window tell each other.
//!
//! Each message is a tag of one byte, the length of the rest in four bytes, little end first, and the rest. A
//! length is checked before anything is read.

use super::event::{EVENT_BYTES, Event};
use super::frame::Area;
use std::io::{self, Read, Write};

/// The version of this protocol; both sides must have the same one.
pub const VERSION: u32 = 1;
/// The most pixels of a picture.
const MOST_PIXELS: u64 = 1 << 28;
/// The most bytes of a text.
const MOST_TEXT: u32 = 4096;

/// What a program tells a viewer.
#[derive(Clone, Debug, PartialEq)]
pub enum Order {
    /// Shows a window for a picture of so many columns and rows; the first message.
    Open(u32, u32, String),
    /// Replaces an area of the picture: red, green and blue of each pixel, row by row.
    Paint(Area, Vec<u8>),
    /// Goes on showing the last picture after the program is gone, until the operator closes the window.
    Keep,
    /// Closes the window.
    Close,
}

/// What a viewer tells a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// The window is there.
    Ready,
    /// There can be no window, and why.
    Refused(String),
    /// The operator did something.
    Event(Event),
}

fn bad(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}

fn message(out: &mut impl Write, tag: u8, parts: &[&[u8]]) -> io::Result<()> {
    let length: usize = parts.iter().map(|part| part.len()).sum();
    let length = u32::try_from(length).map_err(|_| bad("the message is too long"))?;
    let [a, b, c, d] = length.to_le_bytes();
    let mut bytes = Vec::with_capacity(5 + length as usize);
    bytes.extend([tag, a, b, c, d]);
    parts.iter().for_each(|part| bytes.extend(*part));
    out.write_all(&bytes)
}

/// The tag and the length of the next message, or none at the end.
fn header(input: &mut impl Read) -> io::Result<Option<(u8, u32)>> {
    let mut tag = [0];
    loop {
        match input.read(&mut tag) {
            Ok(0) => return Ok(None),
            Ok(_) => break,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(Some((tag[0], number(input)?)))
}

fn number(input: &mut impl Read) -> io::Result<u32> {
    let mut bytes = [0; 4];
    input.read_exact(&mut bytes)?;
    Ok(u32::from_le_bytes(bytes))
}

fn text(input: &mut impl Read, length: u32) -> io::Result<String> {
    if length > MOST_TEXT {
        return Err(bad("the text is too long"));
    }
    let mut bytes = vec![0; length as usize];
    input.read_exact(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// As much of a text as a message holds.
fn limited(text: &str) -> &[u8] {
    &text.as_bytes()[..text.len().min(MOST_TEXT as usize)]
}

impl Order {
    /// Writes the message.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        match self {
            Order::Open(width, height, title) => {
                let numbers = [VERSION, *width, *height].map(u32::to_le_bytes).concat();
                message(out, b'O', &[&numbers, limited(title)])
            }
            Order::Paint(area, pixels) => {
                let Area { x, y, width, height } = *area;
                let numbers = [x, y, width, height].map(u32::to_le_bytes).concat();
                message(out, b'P', &[&numbers, pixels])
            }
            Order::Keep => message(out, b'K', &[]),
            Order::Close => message(out, b'C', &[]),
        }
    }

    /// Reads the next message; `size` is that of the picture once it is known. None at the end.
    pub fn read(input: &mut impl Read, size: Option<(u32, u32)>) -> io::Result<Option<Order>> {
        let Some((tag, length)) = header(input)? else { return Ok(None) };
        let order = match (tag, size) {
            (b'O', None) if length >= 12 => {
                let [version, width, height] = [number(input)?, number(input)?, number(input)?];
                if version != VERSION {
                    return Err(bad("the program and the viewer are of different versions"));
                }
                let pixels = u64::from(width) * u64::from(height);
                if pixels == 0 || pixels > MOST_PIXELS {
                    return Err(bad("no picture has this size"));
                }
                Order::Open(width, height, text(input, length - 12)?)
            }
            (b'P', Some(size)) if length >= 16 => {
                let [x, y] = [number(input)?, number(input)?];
                let [width, height] = [number(input)?, number(input)?];
                let inside = |from: u32, count, all| from.checked_add(count).is_some_and(|end| end <= all);
                let bytes = u64::from(width) * u64::from(height) * 3;
                if !inside(x, width, size.0) || !inside(y, height, size.1) || bytes + 16 != u64::from(length)
                {
                    return Err(bad("the area is not a part of the picture"));
                }
                let mut pixels = vec![0; bytes as usize];
                input.read_exact(&mut pixels)?;
                Order::Paint(Area { x, y, width, height }, pixels)
            }
            (b'K', Some(_)) if length == 0 => Order::Keep,
            (b'C', Some(_)) if length == 0 => Order::Close,
            _ => return Err(bad("no such message")),
        };
        Ok(Some(order))
    }
}

impl Answer {
    /// Writes the message.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        match self {
            Answer::Ready => message(out, b'R', &[]),
            Answer::Refused(why) => message(out, b'N', &[limited(why)]),
            Answer::Event(event) => message(out, b'E', &[&event.to_bytes()]),
        }
    }

    /// Reads the next message, or none at the end. An event that means nothing is passed over.
    pub fn read(input: &mut impl Read) -> io::Result<Option<Answer>> {
        loop {
            let Some((tag, length)) = header(input)? else { return Ok(None) };
            match tag {
                b'R' if length == 0 => return Ok(Some(Answer::Ready)),
                b'N' => return Ok(Some(Answer::Refused(text(input, length)?))),
                b'E' if length as usize == EVENT_BYTES => {
                    let mut bytes = [0; EVENT_BYTES];
                    input.read_exact(&mut bytes)?;
                    if let Some(event) = Event::from_bytes(&bytes) {
                        return Ok(Some(Answer::Event(event)));
                    }
                }
                _ => return Err(bad("no such message")),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area() -> Area {
        Area { x: 1, y: 2, width: 2, height: 1 }
    }

    #[test]
    fn messages_survive() {
        let orders = [
            (None, Order::Open(30, 20, "a window".to_owned())),
            (Some((30, 20)), Order::Paint(area(), vec![1, 2, 3, 4, 5, 6])),
            (Some((30, 20)), Order::Keep),
            (Some((30, 20)), Order::Close),
        ];
        let mut bytes = Vec::new();
        orders.iter().for_each(|(_, order)| order.write(&mut bytes).unwrap());
        let mut input = bytes.as_slice();
        for (size, order) in orders {
            assert_eq!(Order::read(&mut input, size).unwrap(), Some(order));
        }
        assert_eq!(Order::read(&mut input, None).unwrap(), None);
        let answers =
            [Answer::Ready, Answer::Refused("no display".to_owned()), Answer::Event(Event::Wheel(1.0))];
        let mut bytes = Vec::new();
        answers.iter().for_each(|answer| answer.write(&mut bytes).unwrap());
        let mut input = bytes.as_slice();
        for answer in answers {
            assert_eq!(Answer::read(&mut input).unwrap(), Some(answer));
        }
        assert_eq!(Answer::read(&mut input).unwrap(), None);
    }

    #[test]
    fn no_length_is_believed() {
        let read = |bytes: &[u8], size| Order::read(&mut &bytes[..], size);
        let mut bytes = Vec::new();
        Order::Paint(area(), vec![0; 6]).write(&mut bytes).unwrap();
        for size in [(2, 20), (30, 2), (0, 0)] {
            assert!(read(&bytes, Some(size)).is_err(), "{size:?}");
        }
        assert!(read(&bytes, None).is_err(), "before the window is open");
        for cut in 1..bytes.len() {
            assert!(read(&bytes[..cut], Some((30, 20))).is_err());
        }
        bytes[1] = 255;
        assert!(read(&bytes, Some((30, 20))).is_err());
        for (width, height) in [(0, 5), (65536, 65536)] {
            let mut bytes = Vec::new();
            Order::Open(width, height, String::new()).write(&mut bytes).unwrap();
            assert!(read(&bytes, None).is_err());
        }
        assert!(read(b"O\xff\xff\xff\xff\x01\0\0\0\x01\0\0\0\x01\0\0\0", None).is_err());
        assert!(Answer::read(&mut &b"N\xff\xff\xff\xff"[..]).is_err());
        assert!(Answer::read(&mut &b"x\0\0\0\0"[..]).is_err());
    }
}
