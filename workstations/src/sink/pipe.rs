//! Writing into pipes whose reader may be gone.

use std::io::{self, Write};

/// A writer into what may be a pipe: a pipe that nobody reads any more is an error of the write, not the end
/// of the program, whatever the program does about the signal SIGPIPE.
#[derive(Debug)]
pub(super) struct Patient<W>(pub(super) W);

impl<W: Write> Write for Patient<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        without_signal(|| self.0.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        without_signal(|| self.0.flush())
    }
}

/// Does `write` while SIGPIPE waits, and takes back the one that it brought about.
#[cfg(unix)]
fn without_signal<T>(write: impl FnOnce() -> io::Result<T>) -> io::Result<T> {
    use nix::sys::signal::{SigSet, SigmaskHow, Signal};
    let mut pipe = SigSet::empty();
    pipe.add(Signal::SIGPIPE);
    let Ok(before) = pipe.thread_swap_mask(SigmaskHow::SIG_BLOCK) else { return write() };
    let written = write();
    if !before.contains(Signal::SIGPIPE) {
        // A signal that is blocked is kept even where it is ignored, so that this does not wait for another one.
        if written.as_ref().is_err_and(|error| error.kind() == io::ErrorKind::BrokenPipe) {
            let _ = pipe.wait();
        }
        let _ = before.thread_set_mask();
    }
    written
}

#[cfg(not(unix))]
fn without_signal<T>(write: impl FnOnce() -> io::Result<T>) -> io::Result<T> {
    write()
}
