//! As much of HTTP/1.1 (RFC 9112) as a page and its socket need.

use std::io::{self, Read, Write};

/// The most bytes of a request.
const MOST: usize = 8192;

/// A request without its body, which none of ours has.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Request {
    /// The path, without what follows a `?`.
    pub(super) path: String,
    /// The key of a request to become a web socket (RFC 6455, section 4.2.1).
    pub(super) key: Option<String>,
}

/// Reads a request, or says why it is none.
pub(super) fn read(input: &mut impl Read) -> io::Result<Request> {
    let bad = |what: &str| io::Error::new(io::ErrorKind::InvalidData, what.to_owned());
    let mut head = Vec::new();
    let mut buffer = [0; 1024];
    while !head.windows(4).any(|end| end == b"\r\n\r\n") {
        let count = input.read(&mut buffer)?;
        if count == 0 || head.len() + count > MOST {
            return Err(bad("the request does not end"));
        }
        head.extend(&buffer[..count]);
    }
    let head = String::from_utf8_lossy(&head);
    let mut lines = head.split("\r\n");
    let mut first = lines.next().unwrap_or_default().split(' ');
    let (Some("GET"), Some(target), Some("HTTP/1.1")) = (first.next(), first.next(), first.next()) else {
        return Err(bad("only GET is understood"));
    };
    let mut key = None;
    let mut upgrade = false;
    for (name, value) in lines.filter_map(|line| line.split_once(':')) {
        match name.to_ascii_lowercase().as_str() {
            "upgrade" => upgrade |= value.trim().eq_ignore_ascii_case("websocket"),
            "sec-websocket-key" => key = Some(value.trim().to_owned()),
            _ => {}
        }
    }
    let path = target.split('?').next().unwrap_or_default().to_owned();
    Ok(Request { path, key: key.filter(|_| upgrade) })
}

/// Writes an answer and that the connection ends with it.
pub(super) fn answer(out: &mut impl Write, status: &str, kind: &str, body: &str) -> io::Result<()> {
    // The address holds the secret: it shall not be stored or told to others.
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {}\r\n\
         Connection: close\r\nCache-Control: no-store\r\nReferrer-Policy: no-referrer\r\n\
         X-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n\
         Content-Security-Policy: default-src 'self'; img-src data: blob:\r\n\r\n",
        body.len()
    );
    out.write_all(head.as_bytes())?;
    out.write_all(body.as_bytes())?;
    out.flush()
}

/// Writes the answer that turns the connection into a web socket.
pub(super) fn switch(out: &mut impl Write, accept: &str) -> io::Result<()> {
    let head = format!(
        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\
         Sec-WebSocket-Accept: {accept}\r\n\r\n"
    );
    out.write_all(head.as_bytes())?;
    out.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_are_read() {
        let page = read(&mut &b"GET /abc/?x=1 HTTP/1.1\r\nHost: x\r\n\r\n"[..]).unwrap();
        assert_eq!(page, Request { path: "/abc/".to_owned(), key: None });
        let socket = b"GET /s HTTP/1.1\r\nUPGRADE: WebSocket\r\nsec-websocket-key:  k==\r\n\r\n";
        assert_eq!(read(&mut &socket[..]).unwrap().key.as_deref(), Some("k=="));
        let no_socket = b"GET /s HTTP/1.1\r\nsec-websocket-key: k==\r\n\r\n";
        assert_eq!(read(&mut &no_socket[..]).unwrap().key, None);
    }

    #[test]
    fn what_is_no_request_is_refused() {
        for wrong in ["", "\r\n\r\n", "POST / HTTP/1.1\r\n\r\n", "GET /\r\n\r\n", "GET / HTTP/1.1\r\nHost: x"]
        {
            assert!(read(&mut wrong.as_bytes()).is_err(), "{wrong:?}");
        }
        let endless = std::iter::repeat_n(b'x', 20_000).collect::<Vec<u8>>();
        assert!(read(&mut endless.as_slice()).is_err());
    }
}
