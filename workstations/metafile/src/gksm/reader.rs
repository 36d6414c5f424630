//! Reading a GKSM, written here or by another implementation.

use super::fields::{Fields, binary};
use super::formatted::{Layout, integer, newline, whole};
use super::header::{self, Header};
use crate::format::ReadOptions;
use crate::input::Input;
use gks_pipeline::record::item::{Convention, Decoder, Unreadable, kind};
use gks_pipeline::record::{Record, Skipped, Source, SourceError};
use std::cmp::Reverse;

/// The most bytes that the data of an item may have.
const MOST: u64 = 1 << 30;

/// What stands before every item where the header says so.
const MARK: &[u8; 4] = b"GKSM";

/// A GKSM that is read.
pub struct Reader {
    input: Input,
    header: Header,
    layout: Layout,
    /// Whether the most significant byte of binary numbers comes first.
    big_endian: bool,
    decoder: Decoder,
    /// The data of the current item.
    data: Vec<u8>,
    /// The type of an item that was read and not yet given.
    pending: Option<i32>,
    state: State,
    skipped: Skipped,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum State {
    /// The next item begins here.
    Item,
    /// What is here is no item; the next one has to be looked for.
    Lost,
    /// There is nothing more to read.
    Ended,
}

impl Reader {
    /// The metafile in some bytes.
    pub(crate) fn new(mut input: Input, options: &ReadOptions) -> Result<Reader, SourceError> {
        let head = input.peek(2 * header::LENGTH)?;
        let header = Header::parse(head)
            .ok_or_else(|| SourceError::Malformed { offset: 0, what: "no header of a GKSM".to_owned() })?;
        input.skip(header.size as u64)?;
        let mut decoder = Decoder::new(header.convention());
        if let Some(items) = options.items {
            decoder.inverted = items == Convention::Xgks;
        }
        let first = input.peek(1 << 12)?;
        let layout = Layout::of(&header, first);
        let big_endian = !header.formatted && is_big_endian(&header, first);
        let (data, pending, state, skipped) = (Vec::new(), None, State::Item, Skipped::default());
        Ok(Reader { input, header, layout, big_endian, decoder, data, pending, state, skipped })
    }

    fn lost<T>(&mut self, offset: u64, what: &str) -> Result<T, SourceError> {
        // Without marks nobody knows where the next item begins.
        let findable = self.header.mark == MARK.len();
        self.state = if findable { State::Lost } else { State::Ended };
        Err(SourceError::Malformed { offset, what: what.to_owned() })
    }

    fn cut<T>(&mut self, offset: u64) -> Result<T, SourceError> {
        self.state = State::Ended;
        Err(SourceError::Malformed { offset, what: "the file ends in the middle of an item".to_owned() })
    }

    /// Passes over what may stand between items, and looks for the next one where it is not known. Whether
    /// there is more to read.
    fn find(&mut self) -> Result<bool, SourceError> {
        if self.state == State::Lost {
            while self.input.peek(MARK.len())? != MARK {
                if self.input.byte()?.is_none() {
                    break;
                }
            }
            self.state = State::Item;
        }
        let mark = &MARK[..self.header.mark];
        if self.header.formatted {
            // Records may be filled up with blanks, and every item may begin a new one.
            while let Some(byte) = self.input.peek_byte()? {
                let blank = byte == b' ' && !mark.is_empty();
                if !(newline(byte) || blank) {
                    break;
                }
                self.input.consume(1);
            }
        }
        Ok(self.input.peek_byte()?.is_some())
    }

    /// Appends the next bytes that are no ends of lines to `self.data`. Whether they were all there.
    fn read(&mut self, count: usize) -> Result<bool, SourceError> {
        if self.layout != Layout::Wrapped {
            return Ok(self.input.read(count, &mut self.data)?);
        }
        for _ in 0..count {
            let byte = loop {
                match self.input.byte()? {
                    Some(byte) if newline(byte) => {}
                    other => break other,
                }
            };
            let Some(byte) = byte else { return Ok(false) };
            self.data.push(byte);
        }
        Ok(true)
    }

    /// A number before the data of an item; none at the end of the file.
    fn number(&mut self, width: usize) -> Result<Option<i64>, SourceError> {
        let offset = self.input.offset();
        self.data.clear();
        if !self.read(width)? {
            return self.cut(offset);
        }
        let formatted = self.header.formatted;
        Ok(if formatted { integer(&self.data) } else { binary(&self.data, self.big_endian) })
    }

    /// The type of the next item, whose data are in `self.data` then; none at the end of the file.
    fn item(&mut self) -> Result<Option<i32>, SourceError> {
        if let Some(kind) = self.pending.take() {
            return Ok(Some(kind));
        }
        if self.state == State::Ended {
            return Ok(None);
        }
        let offset = self.input.offset();
        if !self.find()? {
            self.state = State::Ended;
            let what = "the metafile ends without an END ITEM".to_owned();
            return Err(SourceError::Malformed { offset, what });
        }
        let kind = if self.layout == Layout::Scanned { self.scanned()? } else { self.fixed()? };
        if kind == kind::END {
            self.state = State::Ended;
            return Ok(None);
        }
        Ok(Some(kind))
    }

    /// An item whose fields have the widths that the header says.
    fn fixed(&mut self) -> Result<i32, SourceError> {
        let offset = self.input.offset();
        let mark = self.header.mark;
        if self.input.peek(mark)? == &MARK[..mark] {
            self.input.consume(mark);
        } else {
            // A line may end in the middle of the word.
            self.data.clear();
            let cut = self.layout == Layout::Wrapped && self.read(mark)? && self.data == MARK[..mark];
            if !cut {
                return self.lost(offset, "an item does not begin with GKSM");
            }
        }
        let kind = self.number(self.header.kind)?.and_then(|kind| i32::try_from(kind).ok());
        let length = self.number(self.header.length)?.and_then(|length| u64::try_from(length).ok());
        let (Some(kind), Some(length)) =
            (kind.filter(|&kind| kind >= 0), length.filter(|&length| length <= MOST))
        else {
            return self.lost(offset, "the type or the length of an item makes no sense");
        };
        self.data.clear();
        if !self.read(length as usize)? {
            return self.cut(offset);
        }
        Ok(kind)
    }

    /// An item on a line of its own.
    fn scanned(&mut self) -> Result<i32, SourceError> {
        let offset = self.input.offset();
        self.data.clear();
        while let Some(byte) = self.input.byte()? {
            if byte == b'\n' {
                break;
            }
            if self.data.len() as u64 == MOST {
                return self.cut(offset);
            }
            self.data.push(byte);
        }
        if self.data.last() == Some(&b'\r') {
            self.data.pop();
        }
        let mut rest = self.data.as_slice();
        let kind = whole(&mut rest).and_then(|kind| i32::try_from(kind).ok());
        let length = whole(&mut rest);
        let (Some(kind), Some(_)) = (kind.filter(|&kind| kind >= 0), length) else {
            return Err(SourceError::Malformed { offset, what: "a line is no item".to_owned() });
        };
        let head = self.data.len() - rest.len();
        self.data.drain(..head);
        Ok(kind)
    }

    /// The type of the next item that stands for something.
    fn known(&mut self) -> Result<Option<i32>, SourceError> {
        loop {
            match self.item()? {
                // What other implementations escape to is theirs.
                Some(kind::ESCAPE) if self.header.convention() != Convention::Own => {
                    self.skipped.add(kind::name(kind::ESCAPE));
                }
                Some(kind) if kind::is_standard(kind) || kind > kind::LAST => return Ok(Some(kind)),
                None => return Ok(None),
                Some(kind) => self.skipped.add(&format!("item of the unknown type {kind}")),
            }
        }
    }

    fn fields(&self) -> Fields<'_> {
        Fields::new(&self.header, self.layout, self.big_endian, &self.data)
    }

    fn unreadable(&self, kind: i32, error: &Unreadable) -> SourceError {
        let offset = self.input.offset().saturating_sub(self.data.len() as u64);
        SourceError::Malformed { offset, what: format!("item type {kind}: {error}") }
    }

    /// Reads items that are one primitive; the type of the items, whose points the decoder has.
    fn compound(&mut self, count: usize) -> Result<Option<i32>, SourceError> {
        let Some(kind) = self.known()? else { return Ok(None) };
        if !matches!(kind, kind::POLYLINE | kind::FILL_AREA) {
            self.pending = Some(kind);
            return Ok(None);
        }
        self.decoder.begin_compound();
        let mut left = count;
        loop {
            let mut fields = Fields::new(&self.header, self.layout, self.big_endian, &self.data);
            let added = self.decoder.add_to_compound(&mut fields);
            added.map_err(|error| self.unreadable(kind, &error))?;
            left = left.saturating_sub(1);
            if left == 0 {
                return Ok(Some(kind));
            }
            match self.known()? {
                Some(next) if next == kind => {}
                Some(other) => {
                    self.pending = Some(other);
                    return Ok(Some(kind));
                }
                None => return Ok(Some(kind)),
            }
        }
    }
}

impl Source for Reader {
    fn next(&mut self) -> Result<Option<Record<'_>>, SourceError> {
        let kind = loop {
            let Some(kind) = self.known()? else { return Ok(None) };
            match Decoder::compound(kind, &mut self.fields()) {
                None => break kind,
                Some(count) => {
                    if let Some(kind) = self.compound(count)? {
                        return Ok(Some(self.decoder.end_compound(kind)));
                    }
                }
            }
        };
        let offset = self.input.offset().saturating_sub(self.data.len() as u64);
        let mut fields = Fields::new(&self.header, self.layout, self.big_endian, &self.data);
        self.decoder
            .decode(kind, &mut fields)
            .map_err(|error| SourceError::Malformed { offset, what: format!("item type {kind}: {error}") })
    }

    fn skipped(&self) -> Skipped {
        self.skipped.clone()
    }
}

/// Whether the head of the first item makes more sense with the most significant byte first.
fn is_big_endian(header: &Header, first: &[u8]) -> bool {
    let sense = |big_endian| {
        let field = |from: usize, width: usize| binary(first.get(from..from + width)?, big_endian);
        let kind = field(header.mark, header.kind).and_then(|kind| i32::try_from(kind).ok())?;
        let length = field(header.mark + header.kind, header.length)?;
        let user = kind > kind::LAST;
        // The better one is the greater one.
        (length >= 0 && (user || kind::is_standard(kind))).then_some((!user, Reverse(length)))
    };
    sense(true) > sense(false)
}
