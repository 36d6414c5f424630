//! NCAR's metafiles: the binary encoding in records of 1440 octets.
//!
//! A record has a head of four octets: how many octets of data it holds, then flags (the kind of data in the four high
//! bits, below them whether a picture begins in it, and whether it is the first or the last of the metafile), then
//! nothing. What follows the data up to the end of the record does not count. (NCAR Graphics, ncarview, `filter.h`.)

use gks_pipeline::device::Sink;
use std::io::{self, ErrorKind, Read};

/// The octets of a record.
pub const RECORD: usize = 1440;

/// The octets of the head of a record.
const HEAD: usize = 4;

/// The kind of data that is the binary encoding.
const BINARY: u8 = 3 << 4;
const NEW_FRAME: u8 = 1 << 3;
const FIRST: u8 = 1 << 2;
const LAST: u8 = 1 << 1;

/// Whether a file that begins with these octets is in such records.
pub fn is_ncgm(head: &[u8]) -> bool {
    let [high, low, flags, _, first, second, ..] = *head else { return false };
    let count = usize::from(high) << 8 | usize::from(low);
    // The first element begins a metafile.
    let element = u16::from(first) << 8 | u16::from(second);
    (2..=RECORD - HEAD).contains(&count) && flags & 0xf0 == BINARY && element & 0xffe0 == 0x0020
}

/// The data of records, as a stream.
pub struct Records<R> {
    input: R,
    record: Vec<u8>,
    /// What is left of the record: from here up to there.
    at: usize,
    end: usize,
}

impl<R: Read> Records<R> {
    /// The data of the records that are read from `input`.
    pub fn new(input: R) -> Self {
        Records { input, record: vec![0; RECORD], at: 0, end: 0 }
    }

    /// Reads the next record; whether there is one.
    fn refill(&mut self) -> io::Result<bool> {
        let mut filled = 0;
        while filled < RECORD {
            match self.input.read(&mut self.record[filled..]) {
                Ok(0) => break,
                Ok(more) => filled += more,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        let count = usize::from(self.record[0]) << 8 | usize::from(self.record[1]);
        self.at = HEAD.min(filled);
        self.end = (HEAD + count).min(filled).max(self.at);
        Ok(filled > HEAD)
    }
}

impl<R: Read> Read for Records<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        while self.at == self.end {
            if out.is_empty() || !self.refill()? {
                return Ok(0);
            }
        }
        let count = out.len().min(self.end - self.at);
        out[..count].copy_from_slice(&self.record[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}

/// Puts the elements of the binary encoding into records, elements of a picture from a new record on.
///
/// Each write must hold whole elements, as those of our recorder do.
pub struct RecordSink {
    sink: Box<dyn Sink>,
    /// The data of the record that is being filled.
    data: Vec<u8>,
    flags: u8,
}

impl RecordSink {
    /// Records in a sink.
    pub fn new(sink: Box<dyn Sink>) -> Self {
        RecordSink { sink, data: Vec::new(), flags: FIRST }
    }

    fn put(&mut self, flags: u8) -> io::Result<()> {
        let mut record = Vec::with_capacity(RECORD);
        record.extend_from_slice(&(self.data.len() as u16).to_be_bytes());
        record.extend([BINARY | self.flags | flags, 0]);
        record.append(&mut self.data);
        record.resize(RECORD, 0);
        self.flags = 0;
        self.sink.write(&record)
    }

    fn fill(&mut self, mut bytes: &[u8]) -> io::Result<()> {
        while !bytes.is_empty() {
            if self.data.len() == RECORD - HEAD {
                self.put(0)?;
            }
            let (now, later) = bytes.split_at(bytes.len().min(RECORD - HEAD - self.data.len()));
            self.data.extend_from_slice(now);
            bytes = later;
        }
        Ok(())
    }
}

/// The length of the element that begins `bytes`, with its header, and the code in its header.
fn element(bytes: &[u8]) -> Option<(usize, u16)> {
    let word = |at: usize| Some(u16::from_be_bytes([*bytes.get(at)?, *bytes.get(at + 1)?]));
    let header = word(0)?;
    let mut length = 2;
    if header & 0x1f < 31 {
        length += usize::from(header & 0x1f).next_multiple_of(2);
    } else {
        loop {
            let part = word(length)?;
            length += 2 + usize::from(part & 0x7fff).next_multiple_of(2);
            if part & 0x8000 == 0 {
                break;
            }
        }
    }
    Some((length, header & 0xffe0))
}

impl Sink for RecordSink {
    fn open(&mut self) -> io::Result<()> {
        self.sink.open()
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        let mut rest = bytes;
        while let Some((length, code)) = element(rest) {
            let (whole, later) = rest.split_at(length.min(rest.len()));
            // Pictures and the end of the metafile begin records.
            if code == 0x0060 || code == 0x0040 {
                if !self.data.is_empty() {
                    self.put(0)?;
                }
                self.flags |= if code == 0x0060 { NEW_FRAME } else { 0 };
            }
            self.fill(whole)?;
            rest = later;
        }
        self.fill(rest)
    }

    fn flush(&mut self) -> io::Result<()> {
        // A picture that is complete is in complete records.
        if !self.data.is_empty() {
            self.put(0)?;
        }
        self.sink.flush()
    }

    fn finish(&mut self) -> io::Result<()> {
        self.put(LAST)?;
        self.sink.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::{Arc, Mutex};

    struct Shared(Arc<Mutex<Vec<u8>>>);

    impl Sink for Shared {
        fn open(&mut self) -> io::Result<()> {
            Ok(())
        }
        fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
            self.0.lock().unwrap().extend_from_slice(bytes);
            Ok(())
        }
        fn finish(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn records_give_back_what_was_put_into_them() {
        let written = Arc::new(Mutex::new(Vec::new()));
        let mut sink = RecordSink::new(Box::new(Shared(Arc::clone(&written))));
        let mut bytes = vec![0x00, 0x22, 1, b'A', 0x00, 0x62, 1, b'P', 0x40, 0x3f, 0x0b, 0xb8];
        bytes.extend((0..3000).map(|i| i as u8));
        bytes.extend([0x00, 0xa0, 0x00, 0x40]);
        sink.write(&bytes).unwrap();
        sink.finish().unwrap();
        let file = written.lock().unwrap().clone();
        assert_eq!(file.len() % RECORD, 0);
        let flags: Vec<u8> = file.chunks(RECORD).map(|record| record[2]).collect();
        assert_eq!(flags, [BINARY | FIRST, BINARY | NEW_FRAME, BINARY, BINARY, BINARY | LAST]);
        assert!(is_ncgm(&file) && !is_ncgm(&bytes));
        let mut back = Vec::new();
        Records::new(&file[..]).read_to_end(&mut back).unwrap();
        assert_eq!(back, bytes);
    }
}
