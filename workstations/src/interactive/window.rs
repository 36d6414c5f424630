//! The window workstation, shown by a process of its own.
//!
//! The viewer is the command `gks viewer`. That it is another process means that no window system is linked
//! into a program, that no thread of the program runs an event loop, and that a window system or a viewer
//! that dies leaves the program alone.

use super::event::Event;
use super::frame::{Area, Frame};
use super::presenter::{Ending, Screen};
use super::protocol::{Answer, Order};
use super::queue::EventQueue;
use rustix::io::Errno;
use rustix::net::{SendFlags, send};
use std::env;
use std::ffi::OsStr;
use std::fs;
use std::io::{self, BufReader, Write};
use std::net::Shutdown;
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

/// How long a viewer may take to open its window.
const OPENING: Duration = Duration::from_secs(20);
/// How long a viewer may keep the picture waiting before it counts as gone.
const STUCK: Duration = Duration::from_secs(10);

/// The program's end of the connection to a viewer.
pub(super) struct Window {
    stream: UnixStream,
}

/// A stream to write to that raises no signal when nobody reads any more: the program may not expect one.
struct Quiet<'a>(&'a UnixStream);

impl Write for Quiet<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        loop {
            match send(self.0, bytes, SendFlags::NOSIGNAL) {
                Err(Errno::INTR) => {}
                done => return Ok(done?),
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Opens a window for a picture of `size` pixels; the queue receives what the operator does in it.
pub(super) fn open(title: &str, size: (u32, u32)) -> Result<(Window, EventQueue), String> {
    let viewer = find()?;
    let failed = |error: io::Error| format!("{}: {error}", viewer.display());
    let (stream, theirs) = UnixStream::pair().map_err(failed)?;
    let (input, output) = (OwnedFd::from(theirs.try_clone().map_err(failed)?), OwnedFd::from(theirs));
    let mut command = Command::new(&viewer);
    // In a group of its own: what interrupts the program from the keyboard ends the viewer through the program.
    command.arg("viewer").stdin(Stdio::from(input)).stdout(Stdio::from(output)).process_group(0);
    let child = command.spawn().map_err(failed)?;
    // The command holds the viewer's end of the connection open as long as it lives.
    drop(command);
    start(stream, child, title, size).map_err(|why| format!("no window can be opened: {why}"))
}

/// Waits until the viewer has opened its window, and listens to it from then on.
fn start(
    stream: UnixStream,
    mut child: Child,
    title: &str,
    size: (u32, u32),
) -> Result<(Window, EventQueue), String> {
    let failed = |error: io::Error| error.to_string();
    stream.set_write_timeout(Some(STUCK)).map_err(failed)?;
    stream.set_read_timeout(Some(OPENING)).map_err(failed)?;
    let mut input = BufReader::new(stream.try_clone().map_err(failed)?);
    let order = Order::Open(size.0, size.1, title.to_owned());
    let answer = order.write(&mut Quiet(&stream)).and_then(|()| Answer::read(&mut input));
    let refusal = match answer {
        Ok(Some(Answer::Ready)) => None,
        Ok(Some(Answer::Refused(why))) => Some(why),
        Ok(_) => Some("the viewer ended at once".to_owned()),
        Err(error) => Some(format!("the viewer does not answer: {error}")),
    };
    if let Some(why) = refusal {
        // Whatever it does, it shall not stay.
        let _ = child.kill();
        let _ = child.wait();
        return Err(why);
    }
    stream.set_read_timeout(None).map_err(failed)?;
    let queue = EventQueue::default();
    let events = queue.clone();
    thread::Builder::new()
        .name("gks window".to_owned())
        .spawn(move || {
            while let Ok(Some(answer)) = Answer::read(&mut input) {
                if let Answer::Event(event) = answer {
                    events.push(event);
                }
            }
            events.push(Event::Closed);
            // So that it does not remain as a defunct process.
            let _ = child.wait();
        })
        .map_err(failed)?;
    Ok((Window { stream }, queue))
}

impl Screen for Window {
    fn show(&mut self, frame: &Frame, changed: Area) -> io::Result<()> {
        let mut pixels = Vec::with_capacity(changed.width as usize * changed.height as usize * 3);
        for row in frame.rows(changed) {
            row.chunks_exact(4).for_each(|pixel| pixels.extend(&pixel[..3]));
        }
        Order::Paint(changed, pixels).write(&mut Quiet(&self.stream))
    }

    fn close(&mut self, ending: Ending) {
        // A picture that nobody was asked about would vanish before it is seen.
        let keep = ending.keep.unwrap_or(!ending.operated);
        // A viewer that is gone needs no message.
        let _ = if keep { Order::Keep } else { Order::Close }.write(&mut Quiet(&self.stream));
        let _ = self.stream.shutdown(Shutdown::Both);
    }
}

/// The command that shows windows.
fn find() -> Result<PathBuf, String> {
    if let Some(named) = env::var_os("GKS_VIEWER").filter(|name| !name.is_empty()) {
        let named = PathBuf::from(named);
        return match named.is_file() {
            true => Ok(named),
            false => Err(format!("GKS_VIEWER={}: there is no such file", named.display())),
        };
    }
    let program = env::current_exe().ok();
    let library = fs::read_to_string("/proc/self/maps").ok().and_then(|maps| library(&maps));
    let beside =
        [program, library].into_iter().flatten().filter_map(|file| file.parent().map(Path::to_owned));
    let path = env::var_os("PATH").unwrap_or_default();
    search(beside, &path).ok_or_else(|| {
        "the command gks, which shows windows, is neither beside the program or the library nor in PATH; \
         GKS_VIEWER may name it"
            .to_owned()
    })
}

/// The command in or beside the folders of the program and the library, or else in the search path.
fn search(beside: impl Iterator<Item = PathBuf>, path: &OsStr) -> Option<PathBuf> {
    let near = beside.flat_map(|folder| {
        ["gks", "../bin/gks", "../../bin/gks", "../gks"].map(|command| folder.join(command))
    });
    let far = env::split_paths(path).filter(|folder| folder.is_absolute()).map(|folder| folder.join("gks"));
    near.chain(far).find(|file| file.is_file())
}

/// The file of this library in the list of what is mapped into a process (Linux, proc(5)).
fn library(maps: &str) -> Option<PathBuf> {
    let files = maps.lines().filter_map(|line| line.find('/').map(|at| &line[at..]));
    let is_library = |file: &&str| {
        let name = file.rsplit('/').next().unwrap_or_default();
        name.starts_with("lib") && name.to_ascii_lowercase().contains("gks") && name.contains(".so")
    };
    files.filter(is_library).map(PathBuf::from).next()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sink::tests::Directory;

    #[test]
    fn the_library_is_found_among_what_is_mapped() {
        let maps = "7f00-7f01 r-xp 00000000 08:01 12 /usr/lib/libc.so.6\n\
                    7f02-7f03 rw-p 00000000 00:00 0 [heap]\n\
                    7f04-7f05 r-xp 00000000 08:01 13   /opt/my lib/libgks.so.1\n";
        assert_eq!(library(maps), Some(PathBuf::from("/opt/my lib/libgks.so.1")));
        let gr = "7f00-7f01 r-xp 00000000 08:01 12 /opt/libGKS.so\n";
        assert_eq!(library(gr), Some(PathBuf::from("/opt/libGKS.so")));
        assert_eq!(library("7f00-7f01 r-xp 00000000 08:01 12 /home/gks/libm.so\n"), None);
    }

    #[test]
    fn the_command_is_sought_beside_before_the_path() {
        let directory = Directory::new();
        let root = PathBuf::from(directory.name(""));
        let paths = ["lib", "bin", "other"].map(|name| root.join(name));
        paths.iter().for_each(|path| fs::create_dir(path).unwrap());
        let path = env::join_paths([Path::new("."), &paths[2]]).unwrap();
        let find = || search([paths[0].clone()].into_iter(), &path);
        assert_eq!(find(), None);
        for (file, found) in
            [("other/gks", "other/gks"), ("bin/gks", "lib/../bin/gks"), ("lib/gks", "lib/gks")]
        {
            fs::write(root.join(file), "").unwrap();
            assert_eq!(find(), Some(root.join(found)));
        }
        // Libraries of other names lie one folder deeper.
        let apart = root.join("lib/apart");
        fs::create_dir(&apart).unwrap();
        fs::remove_file(root.join("lib/gks")).unwrap();
        assert_eq!(search([apart.clone()].into_iter(), &path), Some(apart.join("../../bin/gks")));
    }
}
