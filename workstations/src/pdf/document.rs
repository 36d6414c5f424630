//! The file of a PDF document, written from its beginning to its end without going back.
//!
//! What is kept in memory is the offset of each object. Streams are deflated as they come; since their
//! length is known only after them, it is an object of its own.

use super::content::Drain;
use crate::deflate::Deflate;
use gks_pipeline::device::{DeviceError, Sink};
use pdf_writer::{Chunk, Ref, Settings};

/// How many objects a document may have.
const MOST_OBJECTS: usize = 8_388_607;

/// The first offset that a cross-reference table cannot hold.
const END_OF_TABLE: u64 = 10_000_000_000;

/// A stream being written.
struct Stream {
    length: Ref,
    start: u64,
}

/// A PDF file being written.
pub(crate) struct Document {
    sink: Box<dyn Sink>,
    position: u64,
    /// The offset of object *i* + 1; 0 while it is not written.
    offsets: Vec<u64>,
    stream: Option<Stream>,
    deflate: Deflate,
    contents: Vec<Ref>,
}

impl Document {
    /// A document that is not begun yet, whose long streams are deflated thoroughly if it is to be `small`.
    pub(crate) fn new(sink: Box<dyn Sink>, small: bool) -> Self {
        Document {
            sink,
            position: 0,
            offsets: Vec::new(),
            stream: None,
            deflate: Deflate::new(small),
            contents: Vec::new(),
        }
    }

    /// Begins the file.
    pub(crate) fn open(&mut self) -> Result<(), DeviceError> {
        self.sink.open()?;
        // Bytes above 127 tell programs that transfer files that this one is not text.
        self.write(b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n")
    }

    /// The number of an object to be written later.
    pub(crate) fn reserve(&mut self) -> Result<Ref, DeviceError> {
        if self.offsets.len() >= MOST_OBJECTS {
            return Err(DeviceError::Encode("a PDF document cannot hold more objects".into()));
        }
        self.offsets.push(0);
        Ok(Ref::new(self.offsets.len() as i32))
    }

    /// Writes an object, which `fill` adds to a chunk as its only one.
    pub(crate) fn object(&mut self, id: Ref, fill: impl FnOnce(&mut Chunk)) -> Result<(), DeviceError> {
        let mut chunk = Chunk::with_settings(Settings { pretty: false });
        fill(&mut chunk);
        self.locate(id)?;
        self.write(chunk.as_bytes())
    }

    /// Starts a deflated stream object with further entries of its dictionary, in PDF's notation.
    pub(crate) fn begin_stream(&mut self, id: Ref, entries: &str) -> Result<(), DeviceError> {
        let length = self.reserve()?;
        self.locate(id)?;
        let (id, length_id) = (id.get(), length.get());
        let head = format!("{id} 0 obj\n<</Length {length_id} 0 R/Filter/FlateDecode{entries}>>\nstream\n");
        self.write(head.as_bytes())?;
        self.stream = Some(Stream { length, start: self.position });
        Ok(())
    }

    /// Adds bytes to the stream that was begun.
    pub(crate) fn write_stream(&mut self, bytes: &[u8]) -> Result<(), DeviceError> {
        let Document { deflate, sink, position, .. } = self;
        deflate.write(bytes, |packed| append(sink.as_mut(), position, packed))
    }

    /// Completes the stream that was begun, if there is one.
    pub(crate) fn end_stream(&mut self) -> Result<(), DeviceError> {
        let Some(Stream { length, start }) = self.stream.take() else { return Ok(()) };
        let Document { deflate, sink, position, .. } = self;
        deflate.finish(|packed| append(sink.as_mut(), position, packed))?;
        let written = i32::try_from(self.position - start)
            .map_err(|_| DeviceError::Encode("a PDF stream cannot be longer than 2 GB".into()))?;
        self.write(b"\nendstream\nendobj\n")?;
        self.object(length, |chunk| chunk.indirect(length).primitive(written))
    }

    /// Completes the content streams of the page; their numbers.
    pub(crate) fn end_contents(&mut self) -> Result<Vec<Ref>, DeviceError> {
        self.end_stream()?;
        Ok(std::mem::take(&mut self.contents))
    }

    /// Completes the file.
    pub(crate) fn finish(&mut self, catalog: Ref, info: Ref) -> Result<(), DeviceError> {
        let start = self.position;
        if start >= END_OF_TABLE {
            return Err(DeviceError::Encode("a PDF document cannot be longer than 10 GB".into()));
        }
        let size = self.offsets.len() + 1;
        let mut table = format!("xref\n0 {size}\n0000000000 65535 f\r\n").into_bytes();
        for offsets in std::mem::take(&mut self.offsets).chunks(1 << 10) {
            for offset in offsets {
                let entry = match offset {
                    0 => "0000000000 65535 f\r\n".to_owned(),
                    _ => format!("{offset:010} 00000 n\r\n"),
                };
                table.extend_from_slice(entry.as_bytes());
            }
            self.write(&table)?;
            table.clear();
        }
        let (catalog, info) = (catalog.get(), info.get());
        let trailer = format!(
            "trailer\n<</Size {size}/Root {catalog} 0 R/Info {info} 0 R>>\nstartxref\n{start}\n%%EOF\n"
        );
        self.write(trailer.as_bytes())?;
        self.sink.finish()?;
        Ok(())
    }

    /// Records that an object starts here.
    fn locate(&mut self, id: Ref) -> Result<(), DeviceError> {
        debug_assert!(self.stream.is_none(), "an object inside of a stream");
        let index = usize::try_from(id.get() - 1).unwrap_or(usize::MAX);
        match self.offsets.get_mut(index) {
            Some(offset) => *offset = self.position,
            None => return Err(DeviceError::Encode(format!("object {} was not reserved", id.get()))),
        }
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), DeviceError> {
        append(self.sink.as_mut(), &mut self.position, bytes)
    }
}

fn append(sink: &mut dyn Sink, position: &mut u64, bytes: &[u8]) -> Result<(), DeviceError> {
    sink.write(bytes)?;
    *position += bytes.len() as u64;
    Ok(())
}

impl Drain for Document {
    /// Adds to the content stream of the page, which is begun where there is none.
    fn drain(&mut self, text: &mut Vec<u8>) -> Result<(), DeviceError> {
        if self.stream.is_none() {
            let id = self.reserve()?;
            self.begin_stream(id, "")?;
            self.contents.push(id);
        }
        self.write_stream(text)?;
        text.clear();
        Ok(())
    }
}
