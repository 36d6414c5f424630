//! The web workstation: a page for browsers on the same machine.
//!
//! The address holds a secret of 128 bits, so that only who can read what the program prints can look at the
//! picture or operate it. Several pages may watch; one steers.

mod http;
mod hub;
mod server;

use super::frame::{Area, Frame};
use super::presenter::{Ending, Screen};
use super::queue::EventQueue;
use hub::Hub;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::os::unix::net::UnixStream;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::thread;

/// The program's side of the pages.
pub(super) struct Web {
    hub: Arc<Hub>,
    /// Ends the server when it is closed.
    wake: Option<UnixStream>,
    /// The address with the secret.
    #[cfg(test)]
    address: String,
}

/// Serves a page for a picture of `size` pixels at a port, or at any if there is none; the queue receives
/// what is done in it.
pub(super) fn open(
    title: &str,
    size: (u32, u32),
    port: Option<u16>,
    browser: bool,
) -> Result<(Web, EventQueue), String> {
    let port = port.unwrap_or(0);
    let failed = |error: io::Error| format!("no page can be served at port {port} of 127.0.0.1: {error}");
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(failed)?;
    listener.set_nonblocking(true).map_err(failed)?;
    let mut secret = [0u8; 16];
    rustix::rand::getrandom(&mut secret, rustix::rand::GetRandomFlags::empty())
        .map_err(|error| failed(error.into()))?;
    let token: String = secret.iter().map(|byte| format!("{byte:02x}")).collect();
    let address = format!("http://{}/{token}/", listener.local_addr().map_err(failed)?);
    let queue = EventQueue::default();
    let hub = Arc::new(Hub::new(size, title, queue.clone()));
    let (wake, heard) = UnixStream::pair().map_err(failed)?;
    let shared = Arc::clone(&hub);
    thread::Builder::new()
        .name("gks web".to_owned())
        .spawn(move || server::run(&listener, &heard, &shared, &token))
        .map_err(failed)?;
    eprintln!("gks: the picture is at {address}");
    if browser {
        show(&address);
    }
    let web = Web {
        hub,
        wake: Some(wake),
        #[cfg(test)]
        address,
    };
    Ok((web, queue))
}

/// Opens the address in a browser, which the user may have or not.
fn show(address: &str) {
    let mut command = Command::new("xdg-open");
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    match command.spawn() {
        Ok(mut child) => {
            // So that it does not remain as a defunct process.
            thread::spawn(move || child.wait());
        }
        Err(error) => eprintln!("gks: no browser could be opened: xdg-open: {error}"),
    }
}

impl Screen for Web {
    fn show(&mut self, frame: &Frame, changed: Area) -> io::Result<()> {
        self.hub.update(frame, changed);
        Ok(())
    }

    fn close(&mut self, ending: Ending) {
        self.hub.end(ending.keep == Some(true));
        self.wake = None;
        self.hub.farewell();
    }
}

#[cfg(test)]
mod tests;
