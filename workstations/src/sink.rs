//! Sinks: where drivers write. Files appear under their names only when they are complete.

mod pipe;

use gks_pipeline::device::Sink;
use pipe::Patient;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Bytes collected before they are handed to the operating system.
const BUFFER: usize = 1 << 16;

/// The name of a document: pages after the first have names of their own.
///
/// `%d` in `name` stands for the number of the document, from 1; `%03d` writes it with leading zeros.
/// Without `%d` the first document has the plain name and document n has `.n` before the extension.
pub fn document_name(name: &str, number: u32) -> String {
    if let Some((before, width, after)) = number_directive(name) {
        return format!("{before}{number:0width$}{after}");
    }
    match number {
        0 | 1 => name.to_owned(),
        _ => before_extension(name, &format!(".{number}")),
    }
}

/// The name with `text` between its stem and its extension, or at its end where it has no extension.
pub fn before_extension(name: &str, text: &str) -> String {
    let stem = name.len() - extension(name).map_or(0, |e| e.len() + 1);
    format!("{}{text}{}", &name[..stem], &name[stem..])
}

/// The extension of a file name without the dot; the dot of `.profile` starts no extension.
pub fn extension(name: &str) -> Option<&str> {
    let file = name.rsplit('/').next()?;
    let (stem, extension) = file.rsplit_once('.')?;
    (!stem.is_empty() && !extension.is_empty()).then_some(extension)
}

/// What is before the first `%d` or `%0Nd`, its width, and what is after it.
fn number_directive(name: &str) -> Option<(&str, usize, &str)> {
    name.match_indices('%').find_map(|(at, _)| {
        let rest = &name.as_bytes()[at + 1..];
        let (width, length) = match rest {
            [b'd', ..] => (0, 1),
            [b'0', width @ b'1'..=b'9', b'd', ..] => (usize::from(width - b'0'), 3),
            _ => return None,
        };
        Some((&name[..at], width, &name[at + 1 + length..]))
    })
}

/// A sink that writes files.
///
/// A document is written to a temporary file in the directory of its final name and renamed when it is
/// finished; an unfinished one is removed with the sink. What exists and is no regular file, and every name
/// below `/dev/` but not `/dev/shm/`, is written directly, all documents one after the other.
#[derive(Debug)]
pub struct FileSink {
    name: String,
    documents: u32,
    state: State,
}

#[derive(Debug)]
enum State {
    /// No document is begun.
    Idle,
    /// The file of the next document exists and `open` has not been called.
    Ready(Draft),
    /// A document is being written.
    Writing(Draft),
    /// A device is written directly.
    Direct(BufWriter<Patient<File>>),
}

impl FileSink {
    /// The sink for files called `name` (see [`document_name`]).
    ///
    /// The temporary file for the first document is created at once: the error that the caller gets is the
    /// one that writing would meet, and it names the file.
    pub fn create(name: &str) -> io::Result<FileSink> {
        let state = if is_special(Path::new(name)) {
            let file = OpenOptions::new().append(true).open(name).map_err(naming(name))?;
            State::Direct(BufWriter::with_capacity(BUFFER, Patient(file)))
        } else {
            State::Ready(Draft::create(&document_name(name, 1))?)
        };
        Ok(FileSink { name: name.to_owned(), documents: 0, state })
    }
}

impl Sink for FileSink {
    fn open(&mut self) -> io::Result<()> {
        self.documents += 1;
        self.state = match std::mem::replace(&mut self.state, State::Idle) {
            State::Direct(file) => State::Direct(file),
            State::Ready(draft) => State::Writing(draft),
            State::Idle => State::Writing(Draft::create(&document_name(&self.name, self.documents))?),
            State::Writing(unfinished) => {
                drop(unfinished);
                State::Writing(Draft::create(&document_name(&self.name, self.documents))?)
            }
        };
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        match &mut self.state {
            State::Writing(draft) => draft.file.write_all(bytes).map_err(naming(&self.name)),
            State::Direct(file) => file.write_all(bytes).map_err(naming(&self.name)),
            State::Idle | State::Ready(_) => Err(no_document()),
        }
    }

    fn restart(&mut self) -> io::Result<bool> {
        let State::Writing(draft) = &mut self.state else { return Ok(false) };
        draft.empty().map_err(naming(&self.name))?;
        Ok(true)
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.state {
            State::Writing(draft) => draft.file.flush().map_err(naming(&self.name)),
            State::Direct(file) => file.flush().map_err(naming(&self.name)),
            State::Idle | State::Ready(_) => Ok(()),
        }
    }

    fn finish(&mut self) -> io::Result<()> {
        match std::mem::replace(&mut self.state, State::Idle) {
            State::Writing(draft) => draft.finish().map_err(naming(&self.name)),
            State::Direct(mut file) => {
                let flushed = file.flush().map_err(naming(&self.name));
                self.state = State::Direct(file);
                flushed
            }
            other => {
                self.state = other;
                Err(no_document())
            }
        }
    }
}

/// A document under its temporary name, which is removed unless the document is finished.
#[derive(Debug)]
struct Draft {
    file: BufWriter<File>,
    temporary: PathBuf,
    target: PathBuf,
    finished: bool,
}

impl Draft {
    fn create(name: &str) -> io::Result<Draft> {
        Draft::beside(name).map_err(naming(name))
    }

    fn beside(name: &str) -> io::Result<Draft> {
        if name.ends_with('/') {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "the name of a directory"));
        }
        // A symbolic link stays; what it points to is replaced.
        let target = fs::canonicalize(name).unwrap_or_else(|_| PathBuf::from(name));
        let no_name = || io::Error::new(io::ErrorKind::InvalidInput, "not the name of a file");
        target.file_name().ok_or_else(no_name)?;
        let permissions = match fs::metadata(&target) {
            Ok(existing) if existing.is_dir() => {
                return Err(io::Error::new(io::ErrorKind::IsADirectory, "a directory"));
            }
            Ok(existing) => {
                // A file that its owner protects is not replaced behind his back.
                OpenOptions::new().write(true).open(&target)?;
                Some(existing.permissions())
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let directory = target.parent().unwrap_or(Path::new(""));
        let (file, temporary) = temporary_file(directory)?;
        if let Some(permissions) = permissions {
            // Where permissions cannot be kept the picture is worth more than they are.
            let _ = fs::set_permissions(&temporary, permissions);
        }
        Ok(Draft { file: BufWriter::with_capacity(BUFFER, file), temporary, target, finished: false })
    }

    fn empty(&mut self) -> io::Result<()> {
        self.file.rewind()?;
        self.file.get_ref().set_len(0)
    }

    fn finish(mut self) -> io::Result<()> {
        self.file.flush()?;
        // Some file systems report a full disk only here.
        self.file.get_ref().sync_data()?;
        fs::rename(&self.temporary, &self.target)?;
        self.finished = true;
        Ok(())
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if !self.finished {
            let _ = fs::remove_file(&self.temporary);
        }
    }
}

/// Creates a file with an unused name in a directory.
fn temporary_file(directory: &Path) -> io::Result<(File, PathBuf)> {
    let mut number = 0u32;
    loop {
        let path = directory.join(format!(".gks-{}-{number}.part", process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((file, path)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && number < 10_000 => number += 1,
            Err(error) => return Err(error),
        }
    }
}

/// Whether a name is that of a device, a pipe or the like, which cannot be replaced by renaming.
fn is_special(path: &Path) -> bool {
    let device = path.starts_with("/dev/") && !path.starts_with("/dev/shm/");
    device || fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
}

/// Puts the name of the file before the message of an error.
fn naming(name: &str) -> impl Fn(io::Error) -> io::Error + '_ {
    move |error| io::Error::new(error.kind(), format!("{name}: {error}"))
}

fn no_document() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, "no document is open")
}

/// A sink that keeps documents in memory.
#[derive(Debug)]
pub struct MemorySink {
    current: Option<Vec<u8>>,
    documents: MemoryDocuments,
}

/// The completed documents of a [`MemorySink`], shared with it.
#[derive(Clone, Debug, Default)]
pub struct MemoryDocuments(Arc<Mutex<Vec<Vec<u8>>>>);

impl MemorySink {
    /// A sink and the handle through which its completed documents are read.
    pub fn new() -> (MemorySink, MemoryDocuments) {
        let documents = MemoryDocuments::default();
        (MemorySink { current: None, documents: documents.clone() }, documents)
    }
}

impl MemoryDocuments {
    /// Number of completed documents not yet taken.
    pub fn len(&self) -> usize {
        self.lock().len()
    }

    /// Whether there is no completed document.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A copy of document `index`, counted from 0.
    pub fn get(&self, index: usize) -> Option<Vec<u8>> {
        self.lock().get(index).cloned()
    }

    /// Document `index` as text, with U+FFFD for what is no UTF-8.
    pub fn text(&self, index: usize) -> Option<String> {
        self.lock().get(index).map(|document| String::from_utf8_lossy(document).into_owned())
    }

    /// Takes all completed documents away.
    pub fn take(&self) -> Vec<Vec<u8>> {
        std::mem::take(&mut *self.lock())
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Vec<u8>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Sink for MemorySink {
    fn open(&mut self) -> io::Result<()> {
        self.current = Some(Vec::new());
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.current.as_mut().ok_or_else(no_document)?.extend_from_slice(bytes);
        Ok(())
    }

    fn restart(&mut self) -> io::Result<bool> {
        self.current.as_mut().ok_or_else(no_document)?.clear();
        Ok(true)
    }

    fn finish(&mut self) -> io::Result<()> {
        let document = self.current.take().ok_or_else(no_document)?;
        self.documents.lock().push(document);
        Ok(())
    }
}

/// A sink that writes to the standard output, all documents one after the other.
#[derive(Debug)]
pub struct StdoutSink(BufWriter<Patient<io::Stdout>>);

impl StdoutSink {
    /// The sink.
    pub fn new() -> StdoutSink {
        StdoutSink(BufWriter::with_capacity(BUFFER, Patient(io::stdout())))
    }
}

impl Default for StdoutSink {
    fn default() -> Self {
        StdoutSink::new()
    }
}

impl Sink for StdoutSink {
    fn open(&mut self) -> io::Result<()> {
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.0.write_all(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }

    fn finish(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

#[cfg(test)]
pub(crate) mod tests;
