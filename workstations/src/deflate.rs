//! Deflated streams (RFC 1950) that are passed on while they are written.
//!
//! A short stream is deflated when it is complete, and well. A long one is deflated by a thread of its own while
//! the writer goes on; no more than a few portions are on their way at any time.

use flate2::{Compress, Compression, FlushCompress, Status};
use gks_pipeline::device::DeviceError;
use std::sync::mpsc::{Receiver, SyncSender, channel, sync_channel};
use std::thread::{self, JoinHandle};

/// How many bytes are deflated at a time; a stream of no more is short.
const PORTION: usize = 1 << 16;

/// How many portions may wait for the thread.
const WAITING: usize = 4;

/// The level of short streams, and of all where a small file is worth more time: level 9 takes several times as long
/// and saves a hundredth.
const THOROUGH: u32 = 6;

/// The level of long streams else. They come out half as long again, four times as fast.
const FAST: u32 = 1;

/// Deflates one stream after the other.
pub(crate) struct Deflate {
    /// The level of long streams.
    level: u32,
    /// What is not deflated yet.
    portion: Vec<u8>,
    worker: Option<Worker>,
}

impl Deflate {
    /// Ready for the first stream.
    pub(crate) fn new(small: bool) -> Self {
        Deflate { level: if small { THOROUGH } else { FAST }, portion: Vec::new(), worker: None }
    }

    /// Adds bytes to the stream and gives `pass` what is deflated by then.
    pub(crate) fn write(
        &mut self,
        mut bytes: &[u8],
        mut pass: impl FnMut(&[u8]) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        while !bytes.is_empty() {
            if self.portion.len() == PORTION {
                let level = self.level;
                let worker = self.worker.get_or_insert_with(|| Worker::new(level));
                worker.deflate(&mut self.portion, &mut pass)?;
            }
            let (now, later) = bytes.split_at(bytes.len().min(PORTION - self.portion.len()));
            self.portion.extend_from_slice(now);
            bytes = later;
        }
        Ok(())
    }

    /// Completes the stream, gives `pass` the rest of it, and is ready for the next one.
    pub(crate) fn finish(
        &mut self,
        mut pass: impl FnMut(&[u8]) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        let portion = std::mem::take(&mut self.portion);
        match self.worker.take() {
            Some(worker) => worker.finish(portion, &mut pass),
            None => {
                let mut out = Vec::with_capacity(portion.len() / 2);
                let mut state = Compress::new(Compression::new(THOROUGH), true);
                run(&mut state, &portion, FlushCompress::Finish, &mut out)?;
                self.portion = portion;
                self.portion.clear();
                pass(&out)
            }
        }
    }
}

/// A thread that deflates portions, or this one where there can be no other.
enum Worker {
    Thread(Thread),
    Here(Box<Compress>),
}

/// What has become of a portion.
struct Deflated {
    bytes: Vec<u8>,
    /// The portion, empty, to be filled again.
    portion: Vec<u8>,
}

struct Thread {
    portions: SyncSender<Vec<u8>>,
    deflated: Receiver<Result<Deflated, DeviceError>>,
    handle: JoinHandle<()>,
    /// Empty portions.
    spare: Vec<Vec<u8>>,
}

impl Worker {
    fn new(level: u32) -> Worker {
        let state = || Box::new(Compress::new(Compression::new(level), true));
        if thread::available_parallelism().is_ok_and(|count| count.get() > 1)
            && let Some(thread) = Thread::start(state())
        {
            return Worker::Thread(thread);
        }
        Worker::Here(state())
    }

    /// Deflates a portion, sooner or later, and leaves it empty.
    fn deflate(
        &mut self,
        portion: &mut Vec<u8>,
        pass: &mut impl FnMut(&[u8]) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        match self {
            Worker::Thread(thread) => {
                while let Ok(done) = thread.deflated.try_recv() {
                    let Deflated { bytes, portion } = done?;
                    thread.spare.push(portion);
                    pass(&bytes)?;
                }
                let next = thread.spare.pop().unwrap_or_else(|| Vec::with_capacity(PORTION));
                thread.portions.send(std::mem::replace(portion, next)).map_err(|_| failed())
            }
            Worker::Here(state) => {
                let mut out = Vec::new();
                run(state, portion, FlushCompress::None, &mut out)?;
                portion.clear();
                pass(&out)
            }
        }
    }

    /// Deflates the last portion and gives all that is left to give.
    fn finish(
        self,
        portion: Vec<u8>,
        pass: &mut impl FnMut(&[u8]) -> Result<(), DeviceError>,
    ) -> Result<(), DeviceError> {
        match self {
            Worker::Thread(Thread { portions, deflated, handle, .. }) => {
                portions.send(portion).map_err(|_| failed())?;
                drop(portions);
                for done in deflated {
                    pass(&done?.bytes)?;
                }
                handle.join().map_err(|_| failed())
            }
            Worker::Here(mut state) => {
                let mut out = Vec::new();
                run(&mut state, &portion, FlushCompress::None, &mut out)?;
                run(&mut state, &[], FlushCompress::Finish, &mut out)?;
                pass(&out)
            }
        }
    }
}

impl Thread {
    /// A thread that deflates what it is sent until there is no more, and completes the stream then.
    fn start(mut state: Box<Compress>) -> Option<Thread> {
        let (portions, todo) = sync_channel::<Vec<u8>>(WAITING);
        let (done, deflated) = channel();
        let work = move || {
            while let Ok(mut portion) = todo.recv() {
                let mut bytes = Vec::new();
                let result = run(&mut state, &portion, FlushCompress::None, &mut bytes);
                portion.clear();
                if done.send(result.map(|()| Deflated { bytes, portion })).is_err() {
                    return;
                }
            }
            let mut bytes = Vec::new();
            let result = run(&mut state, &[], FlushCompress::Finish, &mut bytes);
            // Nobody waits for the end of a stream that is given up.
            let _ = done.send(result.map(|()| Deflated { bytes, portion: Vec::new() }));
        };
        let handle = thread::Builder::new().name("deflate".into()).spawn(work).ok()?;
        Some(Thread { portions, deflated, handle, spare: Vec::new() })
    }
}

/// Deflates all of `bytes` to the end of `out`.
fn run(
    state: &mut Compress,
    mut bytes: &[u8],
    flush: FlushCompress,
    out: &mut Vec<u8>,
) -> Result<(), DeviceError> {
    loop {
        if out.len() == out.capacity() {
            out.reserve(PORTION / 2);
        }
        let before = state.total_in();
        let status = state.compress_vec(bytes, out, flush).map_err(|_| failed())?;
        bytes = &bytes[(state.total_in() - before) as usize..];
        let full = out.len() == out.capacity();
        match status {
            Status::StreamEnd => return Ok(()),
            _ if bytes.is_empty() && !full && flush == FlushCompress::None => return Ok(()),
            _ => out.reserve(PORTION / 2),
        }
    }
}

fn failed() -> DeviceError {
    DeviceError::Encode("deflating failed".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Decompress, FlushDecompress};

    fn noise(length: usize) -> Vec<u8> {
        let mut state = 1_u32;
        let noise = std::iter::repeat_with(|| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 27) as u8
        });
        noise.take(length).collect()
    }

    fn inflated(packed: &[u8], length: usize) -> Vec<u8> {
        let mut text = Vec::with_capacity(length + 1);
        let mut state = Decompress::new(true);
        let status = state.decompress_vec(packed, &mut text, FlushDecompress::Finish).unwrap();
        assert_eq!((status, state.total_in()), (Status::StreamEnd, packed.len() as u64));
        text
    }

    #[test]
    fn streams_of_any_length_come_back_and_flow() {
        for small in [false, true] {
            let mut deflate = Deflate::new(small);
            for length in [0, 1, 1000, PORTION - 1, PORTION, PORTION + 1, 2 * PORTION, 3_000_000] {
                let text = noise(length);
                let mut packed = Vec::new();
                for part in text.chunks(70_000) {
                    deflate
                        .write(part, |bytes| {
                            packed.extend_from_slice(bytes);
                            Ok(())
                        })
                        .unwrap();
                }
                assert!(length < 1_000_000 || packed.len() > 100_000, "nothing was passed on before the end");
                deflate
                    .finish(|bytes| {
                        packed.extend_from_slice(bytes);
                        Ok(())
                    })
                    .unwrap();
                assert_eq!(inflated(&packed, length), text);
            }
        }
    }

    #[test]
    fn a_thread_writes_what_is_written_here() {
        let text = noise(1_000_000);
        let state = || Box::new(Compress::new(Compression::new(FAST), true));
        let workers = [Worker::Thread(Thread::start(state()).unwrap()), Worker::Here(state())];
        let [one, other] = workers.map(|mut worker| {
            let mut packed = Vec::new();
            let mut pass = |bytes: &[u8]| {
                packed.extend_from_slice(bytes);
                Ok(())
            };
            let mut portion = Vec::new();
            for part in text.chunks(PORTION) {
                portion.extend_from_slice(part);
                worker.deflate(&mut portion, &mut pass).unwrap();
                assert!(portion.is_empty());
            }
            worker.finish(Vec::new(), &mut pass).unwrap();
            packed
        });
        assert_eq!(one, other);
        assert_eq!(inflated(&one, text.len()), text);
    }

    #[test]
    fn failure_is_passed_back() {
        let fail = |_: &[u8]| Err(DeviceError::Encode("full".into()));
        for length in [4, 30 * PORTION] {
            let mut deflate = Deflate::new(false);
            let written = deflate.write(&noise(length), fail);
            assert!(length == 4 || written.is_err());
            assert!(deflate.finish(fail).is_err());
        }
    }
}
