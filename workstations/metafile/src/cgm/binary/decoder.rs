//! Elements out of a stream of octets (ISO/IEC 8632-3, 5.4).

use super::parameters::Coding;
use crate::cgm::decoder::{Decoder, senseless, unknown};
use crate::cgm::element::{Element, by_code};
use crate::generated::elements::Kind;
use gks_pipeline::record::{Skipped, SourceError};
use std::io::{ErrorKind, Read};

/// Decodes the binary encoding.
///
/// Memory holds one element at a time, whose octets are read partition by partition.
pub struct BinaryDecoder<R> {
    input: R,
    offset: u64,
    coding: Coding,
    /// The coding with which pictures begin: what the metafile descriptor has said.
    defaults: Option<Coding>,
    octets: Vec<u8>,
    /// The octets of the metafile defaults replacement whose elements are being given, and how many are done.
    replacement: Option<(Vec<u8>, usize)>,
    skipped: Skipped,
    ended: bool,
}

impl<R: Read> BinaryDecoder<R> {
    /// A decoder of what is read from `input`.
    pub fn new(input: R) -> Self {
        BinaryDecoder {
            input,
            offset: 0,
            coding: Coding::default(),
            defaults: None,
            octets: Vec::new(),
            replacement: None,
            skipped: Skipped::default(),
            ended: false,
        }
    }

    /// Reads exactly as many octets behind those that are there, or fewer at the end of the stream.
    fn read(&mut self, count: usize) -> Result<usize, SourceError> {
        if let Some((data, done)) = &mut self.replacement {
            let part = &data[*done..(*done + count).min(data.len())];
            self.octets.extend_from_slice(part);
            *done += part.len();
            return Ok(part.len());
        }
        let start = self.octets.len();
        self.octets.resize(start + count, 0);
        let mut filled = 0;
        while filled < count {
            match self.input.read(&mut self.octets[start + filled..]) {
                Ok(0) => break,
                Ok(more) => filled += more,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error.into()),
            }
        }
        self.octets.truncate(start + filled);
        self.offset += filled as u64;
        Ok(filled)
    }

    /// A word, or none at the end of the stream.
    fn word(&mut self) -> Result<Option<u16>, SourceError> {
        let start = self.octets.len();
        let count = self.read(2)?;
        let word = (count == 2).then(|| u16::from_be_bytes([self.octets[start], self.octets[start + 1]]));
        self.octets.truncate(start);
        Ok(word)
    }

    fn malformed(&self, what: &str) -> SourceError {
        SourceError::Malformed { offset: self.offset, what: what.to_owned() }
    }

    /// Class and identifier of the next element, whose octets are in `self.octets` then.
    fn frame(&mut self) -> Result<Option<(u8, u8)>, SourceError> {
        self.octets.clear();
        let Some(header) = self.word()? else { return Ok(None) };
        let code = ((header >> 12) as u8, (header >> 5 & 0x7f) as u8);
        let short = usize::from(header & 0x1f);
        if short < 31 {
            self.part(short)?;
            return Ok(Some(code));
        }
        loop {
            let Some(word) = self.word()? else { return Err(self.malformed("an element is cut off")) };
            self.part(usize::from(word & 0x7fff))?;
            if word & 0x8000 == 0 {
                return Ok(Some(code));
            }
        }
    }

    /// A partition, with the octet that makes its length even.
    fn part(&mut self, count: usize) -> Result<(), SourceError> {
        if self.read(count)? < count {
            return Err(self.malformed("an element is cut off"));
        }
        if count % 2 == 1 {
            let length = self.octets.len();
            self.read(1)?;
            self.octets.truncate(length);
        }
        Ok(())
    }

    fn element(&mut self) -> Result<Option<Element>, SourceError> {
        while !self.ended {
            let Some((class, id)) = self.frame()? else {
                if self.replacement.take().is_some() {
                    return Ok(Some(Element::new(Kind::EndMetafileDefaultsReplacement, [])));
                }
                break;
            };
            match by_code(class, id).map(|row| (row, row.kind)) {
                Some((_, Kind::NoOp)) => {}
                Some((_, Kind::BeginMetafileDefaultsReplacement)) if self.replacement.is_none() => {
                    self.replacement = Some((std::mem::take(&mut self.octets), 0));
                    return Ok(Some(Element::new(Kind::BeginMetafileDefaultsReplacement, [])));
                }
                Some((_, Kind::BeginMetafileDefaultsReplacement | Kind::EndMetafileDefaultsReplacement))
                | None => self.skipped.add(&unknown(format_args!("{class}/{id}"))),
                Some((row, kind)) => {
                    if kind == Kind::BeginMetafile {
                        (self.coding, self.defaults) = (Coding::default(), None);
                    } else if kind == Kind::BeginPicture {
                        self.coding = self.defaults.get_or_insert_with(|| self.coding.clone()).clone();
                    }
                    let element = self.coding.element(row, &self.octets);
                    self.coding.observe(&element);
                    return Ok(Some(element));
                }
            }
        }
        self.ended = true;
        Ok(None)
    }
}

impl<R: Read + Send> Decoder for BinaryDecoder<R> {
    fn next(&mut self) -> Result<Option<Element>, SourceError> {
        let result = self.element();
        if result.is_err() {
            if self.replacement.take().is_some() {
                // The rest of the metafile is not touched by what is wrong in there.
                self.skipped.add(&senseless(Kind::BeginMetafileDefaultsReplacement.row()));
                return Ok(Some(Element::new(Kind::EndMetafileDefaultsReplacement, [])));
            }
            self.ended = true;
        }
        result
    }

    fn skipped(&self) -> &Skipped {
        &self.skipped
    }
}
