//! The server of the page: one thread that accepts, one for each connection.

use super::http::{self, Request};
use super::hub::{Hub, Portion};
use crate::interactive::event::Event;
use crate::interactive::frame::Area;
use rustix::event::{PollFd, PollFlags, poll};
use rustix::io::Errno;
use std::io::{self, Read};
use std::net::{TcpListener, TcpStream};
use std::os::unix::net::UnixStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;
use tungstenite::handshake::derive_accept_key;
use tungstenite::protocol::{Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

/// The most connections at a time.
const MOST_CONNECTIONS: usize = 64;
/// How long a request may take to arrive.
const PATIENCE: Duration = Duration::from_secs(5);

/// Accepts connections until `wake` is written to or closed.
pub(super) fn run(listener: &TcpListener, wake: &UnixStream, hub: &Arc<Hub>, token: &str) {
    let connections = Arc::new(AtomicUsize::new(0));
    loop {
        let mut ready = [PollFd::new(listener, PollFlags::IN), PollFd::new(wake, PollFlags::IN)];
        match poll(&mut ready, None) {
            Ok(_) | Err(Errno::INTR) => {}
            Err(_) => return,
        }
        if !ready[1].revents().is_empty() {
            return;
        }
        let Ok((stream, _)) = listener.accept() else {
            // Too many open files, perhaps; it shall not become a busy loop.
            thread::sleep(Duration::from_millis(20));
            continue;
        };
        if connections.fetch_add(1, Ordering::Relaxed) >= MOST_CONNECTIONS {
            connections.fetch_sub(1, Ordering::Relaxed);
            continue;
        }
        let (hub, token, count) = (Arc::clone(hub), token.to_owned(), Arc::clone(&connections));
        let serve = move || {
            // A browser that breaks off is no fault of ours.
            let _ = connection(stream, &hub, &token);
            count.fetch_sub(1, Ordering::Relaxed);
        };
        if thread::Builder::new().name("gks page".to_owned()).spawn(serve).is_err() {
            connections.fetch_sub(1, Ordering::Relaxed);
        }
    }
}

fn connection(mut stream: TcpStream, hub: &Hub, token: &str) -> io::Result<()> {
    stream.set_nonblocking(false)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    stream.set_nodelay(true)?;
    let Request { path, key } = match http::read(&mut stream) {
        Ok(request) => request,
        Err(error) if error.kind() == io::ErrorKind::InvalidData => {
            return http::answer(&mut stream, "400 Bad Request", "text/plain", "bad request\n");
        }
        Err(error) => return Err(error),
    };
    let Some(name) = path.strip_prefix('/').and_then(|path| after_token(path, token)) else {
        let text = "The address lacks the secret that the program printed.\n";
        return http::answer(&mut stream, "403 Forbidden", "text/plain", text);
    };
    match (name, key) {
        ("", _) => http::answer(&mut stream, "200 OK", "text/html", include_str!("page.html")),
        ("page.css", _) => http::answer(&mut stream, "200 OK", "text/css", include_str!("page.css")),
        ("page.js", _) => http::answer(&mut stream, "200 OK", "text/javascript", include_str!("page.js")),
        ("socket", Some(key)) => {
            http::switch(&mut stream, &derive_accept_key(key.as_bytes()))?;
            serve(stream, hub)
        }
        _ => http::answer(&mut stream, "404 Not Found", "text/plain", "there is nothing here\n"),
    }
}

/// What follows the token and a slash. The comparison takes as long whatever is wrong.
fn after_token<'a>(path: &'a str, token: &str) -> Option<&'a str> {
    let (given, rest) = path.split_once('/')?;
    let same = given.bytes().zip(token.bytes()).fold(0, |differences, (a, b)| differences | (a ^ b)) == 0;
    (given.len() == token.len() && same).then_some(rest)
}

/// Sends a viewer what it lacks, and passes on what it does, until either side ends it.
fn serve(stream: TcpStream, hub: &Hub) -> io::Result<()> {
    stream.set_nonblocking(true)?;
    let (bell, mut heard) = UnixStream::pair()?;
    bell.set_nonblocking(true)?;
    heard.set_nonblocking(true)?;
    let ear = heard.try_clone()?;
    let socket = stream.try_clone()?;
    let config = WebSocketConfig::default().max_message_size(Some(1024)).max_frame_size(Some(1024));
    let mut page = WebSocket::from_raw_socket(stream, Role::Server, Some(config));
    let number = hub.join(bell);
    let done = converse(&mut page, hub, number, (&socket, &ear), &mut heard);
    hub.leave(number);
    done
}

fn converse(
    page: &mut WebSocket<TcpStream>,
    hub: &Hub,
    number: u64,
    (socket, ear): (&TcpStream, &UnixStream),
    heard: &mut UnixStream,
) -> io::Result<()> {
    let mut busy = send(page, greeting(hub))?;
    let mut steers = None;
    let mut bells = [0; 256];
    loop {
        while let Some(message) = receive(page)? {
            match message {
                Message::Binary(bytes) if bytes.as_ref() == [0] => hub.take_over(number),
                Message::Binary(bytes) => {
                    if let Some(event) = Event::from_bytes(&bytes) {
                        hub.act(number, event);
                    }
                }
                Message::Close(_) => return Ok(()),
                _ => {}
            }
        }
        if busy {
            busy = flush(page)?;
        }
        if !busy {
            let Some(Portion { part, steers: now, ended }) = hub.portion(number) else { return Ok(()) };
            if steers != Some(now) {
                busy = send(page, vec![2, u8::from(now)])?;
                steers = Some(now);
            }
            match part {
                Some((area, pixels)) => {
                    busy |= send(page, paint(area, &pixels)?)?;
                    continue;
                }
                None if ended && !busy => {
                    send(page, vec![3])?;
                    // Whether the page hears of it any more does not matter.
                    let _ = page.close(None);
                    return Ok(());
                }
                None => {}
            }
        }
        let wanted = if busy { PollFlags::IN | PollFlags::OUT } else { PollFlags::IN };
        match poll(&mut [PollFd::new(socket, wanted), PollFd::new(ear, PollFlags::IN)], None) {
            Ok(_) | Err(Errno::INTR) => {}
            Err(error) => return Err(error.into()),
        }
        while heard.read(&mut bells).is_ok_and(|count| count > 0) {}
    }
}

/// The next message, or none if none has arrived.
fn receive(page: &mut WebSocket<TcpStream>) -> io::Result<Option<Message>> {
    match page.read() {
        Ok(message) => Ok(Some(message)),
        Err(Error::Io(error)) if error.kind() == io::ErrorKind::WouldBlock => Ok(None),
        Err(error) => Err(io::Error::other(error)),
    }
}

/// Sends a message as far as the connection takes it; whether something of it is left.
fn send(page: &mut WebSocket<TcpStream>, message: Vec<u8>) -> io::Result<bool> {
    match page.write(Message::binary(message)) {
        Ok(()) => flush(page),
        Err(Error::Io(error)) if error.kind() == io::ErrorKind::WouldBlock => Ok(true),
        Err(error) => Err(io::Error::other(error)),
    }
}

fn flush(page: &mut WebSocket<TcpStream>) -> io::Result<bool> {
    match page.flush() {
        Ok(()) => Ok(false),
        Err(Error::Io(error)) if error.kind() == io::ErrorKind::WouldBlock => Ok(true),
        Err(error) => Err(io::Error::other(error)),
    }
}

fn greeting(hub: &Hub) -> Vec<u8> {
    let mut message = vec![0];
    message.extend(hub.size.0.to_le_bytes());
    message.extend(hub.size.1.to_le_bytes());
    message.extend(hub.title.bytes());
    message
}

/// A part of the picture as a PNG image with its place before it.
fn paint(area: Area, pixels: &[u8]) -> io::Result<Vec<u8>> {
    let mut message = vec![1];
    message.extend(area.x.to_le_bytes());
    message.extend(area.y.to_le_bytes());
    let mut encoder = png::Encoder::new(&mut message, area.width, area.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_token_opens() {
        assert_eq!(after_token("abcd/page.js", "abcd"), Some("page.js"));
        assert_eq!(after_token("abcd/", "abcd"), Some(""));
        for wrong in ["", "abcd", "abc/", "abcde/", "abce/x", "/abcd/"] {
            assert_eq!(after_token(wrong, "abcd"), None, "{wrong}");
        }
    }
}
