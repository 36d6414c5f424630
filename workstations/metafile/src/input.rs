//! Bytes of a metafile, read ahead by a bounded amount.

use std::io::{self, Read};

/// The most that is read ahead, and that [`Input::peek`] can show.
const BUFFER: usize = 1 << 16;

/// The bytes of a metafile.
pub(crate) struct Input {
    reader: Box<dyn Read + Send>,
    buffer: Vec<u8>,
    start: usize,
    end: usize,
    /// The place of `buffer[start]` in the file.
    offset: u64,
}

impl Input {
    /// The bytes that a reader gives.
    pub(crate) fn new(reader: impl Read + Send + 'static) -> Input {
        Input { reader: Box::new(reader), buffer: vec![0; BUFFER], start: 0, end: 0, offset: 0 }
    }

    /// The place of the next byte in the file.
    pub(crate) fn offset(&self) -> u64 {
        self.offset
    }

    /// The next `count` bytes without taking them, fewer at the end of the file.
    pub(crate) fn peek(&mut self, count: usize) -> io::Result<&[u8]> {
        let count = count.min(BUFFER);
        while self.end - self.start < count {
            if self.start + count > BUFFER {
                self.buffer.copy_within(self.start..self.end, 0);
                self.end -= self.start;
                self.start = 0;
            }
            match self.reader.read(&mut self.buffer[self.end..]) {
                Ok(0) => break,
                Ok(read) => self.end += read,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        let count = count.min(self.end - self.start);
        Ok(&self.buffer[self.start..self.start + count])
    }

    /// The next byte without taking it.
    pub(crate) fn peek_byte(&mut self) -> io::Result<Option<u8>> {
        Ok(self.peek(1)?.first().copied())
    }

    /// Passes over bytes that have been peeked at.
    pub(crate) fn consume(&mut self, count: usize) {
        let count = count.min(self.end - self.start);
        self.start += count;
        self.offset += count as u64;
    }

    /// Takes the next byte.
    pub(crate) fn byte(&mut self) -> io::Result<Option<u8>> {
        let byte = self.peek_byte()?;
        self.consume(usize::from(byte.is_some()));
        Ok(byte)
    }

    /// Appends the next `count` bytes to `out`, which grows as they come. Whether they were all there.
    pub(crate) fn read(&mut self, count: usize, out: &mut Vec<u8>) -> io::Result<bool> {
        let mut left = count;
        while left > 0 {
            let bytes = self.peek(left)?;
            if bytes.is_empty() {
                return Ok(false);
            }
            let taken = bytes.len();
            out.extend_from_slice(bytes);
            self.consume(taken);
            left -= taken;
        }
        Ok(true)
    }

    /// Passes over the next `count` bytes. Whether they were all there.
    pub(crate) fn skip(&mut self, count: u64) -> io::Result<bool> {
        let mut left = count;
        while left > 0 {
            let there = self.peek(usize::try_from(left).unwrap_or(BUFFER))?.len();
            if there == 0 {
                return Ok(false);
            }
            self.consume(there);
            left -= there as u64;
        }
        Ok(true)
    }
}

impl Read for Input {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        self.peek(1)?;
        let count = out.len().min(self.end - self.start);
        out[..count].copy_from_slice(&self.buffer[self.start..self.start + count]);
        self.consume(count);
        Ok(count)
    }
}
