//! The Computer Graphics Metafile (ISO/IEC 8632) in its three encodings, and in the records of NCAR.
//!
//! | layer | clauses | modules |
//! |---|---|---|
//! | elements and their parameters | part 1, 7 | [`element`], [`parameter`], the generated table |
//! | binary | part 3 of 1999 | [`binary`] |
//! | clear text | part 4 of 1999 | [`text`] |
//! | character | part 2 of 1987 | [`character`] |
//! | from elements to records | part 1, 6 | [`interpreter`] |
//! | from records to elements | the 1987 edition, annex E | [`recorder`] |
//!
//! A decoder of any encoding gives elements, an [`interpreter::Interpreter`] makes records of them. A
//! [`recorder::CgmRecorder`] makes elements of records, which an encoder of any encoding writes.

pub mod binary;
pub mod character;
pub mod coding;
pub mod decoder;
pub mod element;
pub mod encoder;
pub mod fonts;
pub mod interpreter;
pub mod ncgm;
pub mod parameter;
pub mod recorder;
pub mod text;

use binary::decoder::BinaryDecoder;
use binary::encoder::BinaryEncoder;
use character::decoder::CharacterDecoder;
use character::encoder::CharacterEncoder;
use encoder::{Coordinates, Encoder};
use gks_pipeline::device::Sink;
use gks_pipeline::record::{PictureRecorder, Source};
use interpreter::Interpreter;
use recorder::{CgmRecorder, Settings};
use std::io::Read;
use text::decoder::TextDecoder;
use text::encoder::TextEncoder;

/// The most polylines that are one primitive.
const MOST_LINES: usize = 1 << 16;

/// How a metafile is encoded.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// In binary.
    Binary,
    /// In clear text.
    Text,
    /// In characters.
    Character,
    /// In binary, in records of NCAR.
    Ncgm,
}

impl Encoding {
    /// The encoding of a file that begins with these octets, if it is a metafile.
    pub fn of(head: &[u8]) -> Option<Encoding> {
        if ncgm::is_ncgm(head) {
            return Some(Encoding::Ncgm);
        }
        // Elements that do nothing may come first.
        let mut words = head.chunks_exact(2).skip_while(|word| **word == [0, 0]);
        if words.next().is_some_and(|word| word[0] == 0 && word[1] & 0xe0 == 0x20) {
            return Some(Encoding::Binary);
        }
        let mut characters = head.iter().filter(|byte| **byte > 0x20 || **byte == 0x1b);
        if head.starts_with(b"0 ") && matches!(characters.nth(1), Some(0x1b | 0x98 | 0x40..=0x7f)) {
            return Some(Encoding::Character);
        }
        is_text(head).then_some(Encoding::Text)
    }
}

/// Whether clear text begins a metafile, after comments.
fn is_text(head: &[u8]) -> bool {
    let (mut word, mut comment) = (Vec::new(), false);
    for &byte in head {
        match byte {
            b'%' => comment = !comment,
            _ if comment => {}
            b'_' | b'$' => {}
            b' ' | b'\t' | b'\r' | b'\n' if word.is_empty() => {}
            _ if word.len() < 5 => word.push(byte.to_ascii_uppercase()),
            _ => return word == b"BEGMF",
        }
    }
    false
}

/// The records of a metafile.
///
/// Memory is bounded by the largest element, cells in runs by an array of 2048 by 2048 or 64 for each octet, and what the
/// metafile defines to be used again. Elements that are unknown or make no sense are skipped.
pub fn open(bytes: impl Read + Send + 'static, encoding: Encoding) -> Box<dyn Source> {
    match encoding {
        Encoding::Binary => Box::new(Interpreter::new(BinaryDecoder::new(bytes))),
        Encoding::Text => Box::new(Interpreter::new(TextDecoder::new(bytes))),
        Encoding::Character => Box::new(Interpreter::new(CharacterDecoder::new(bytes))),
        Encoding::Ncgm => Box::new(Interpreter::new(BinaryDecoder::new(ncgm::Records::new(bytes)))),
    }
}

/// A recorder that writes a metafile; coordinates are chosen in binary only.
pub fn create(
    sink: Box<dyn Sink>,
    encoding: Encoding,
    coordinates: Option<Coordinates>,
    mut settings: Settings,
) -> Box<dyn PictureRecorder> {
    let (sink, encoder): (Box<dyn Sink>, Box<dyn Encoder>) = match encoding {
        Encoding::Binary => {
            let coordinates = coordinates.unwrap_or(Coordinates::Integer16);
            // Not all readers know more than 256 colours.
            let colour_bits = if coordinates == Coordinates::Real { 16 } else { 8 };
            (sink, Box::new(BinaryEncoder::new(coordinates, colour_bits)))
        }
        Encoding::Text => (sink, Box::new(TextEncoder::new())),
        Encoding::Character => (sink, Box::new(CharacterEncoder::new())),
        Encoding::Ncgm => {
            settings.plain = true;
            let encoder = BinaryEncoder::new(Coordinates::Integer16, 8);
            (Box::new(ncgm::RecordSink::new(sink)), Box::new(encoder))
        }
    };
    Box::new(CgmRecorder::new(sink, encoder, settings))
}

/// Reads all records of some octets as a binary metafile and gives their number; for tests with octets of any kind.
pub fn count_binary(octets: &[u8]) -> u64 {
    count(&mut Interpreter::new(BinaryDecoder::new(octets)))
}

/// Reads all records of some octets as a metafile in clear text and gives their number.
pub fn count_text(octets: &[u8]) -> u64 {
    count(&mut Interpreter::new(TextDecoder::new(octets)))
}

/// Reads all records of some octets as a metafile in characters and gives their number.
pub fn count_character(octets: &[u8]) -> u64 {
    count(&mut Interpreter::new(CharacterDecoder::new(octets)))
}

/// Reads on after errors, until there is nothing more.
fn count(source: &mut dyn Source) -> u64 {
    let (mut records, mut errors) = (0, 0);
    while errors < 16 {
        match source.next() {
            Ok(Some(_)) => records += 1,
            Ok(None) => break,
            Err(_) => errors += 1,
        }
    }
    records
}

#[cfg(test)]
mod tests;
