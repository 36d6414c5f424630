use super::*;
use crate::interactive::event::{Button, Event};
use crate::interactive::queue::Operator;
use glam::DVec2;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};
use tungstenite::{Message, WebSocket};

fn opened() -> (Web, EventQueue) {
    super::open("a test", (40, 30), None, false).unwrap()
}

/// The host with the port, and the path with the secret.
fn place(web: &Web) -> (String, String) {
    let rest = web.address.strip_prefix("http://").unwrap();
    let (host, path) = rest.split_once('/').unwrap();
    (host.to_owned(), format!("/{path}"))
}

fn get(host: &str, path: &str) -> String {
    let mut stream = TcpStream::connect(host).unwrap();
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

fn viewer(web: &Web) -> WebSocket<TcpStream> {
    let (host, path) = place(web);
    let stream = TcpStream::connect(&host).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(10))).unwrap();
    tungstenite::client(format!("ws://{host}{path}socket"), stream).unwrap().0
}

/// The next binary message.
fn next(page: &mut WebSocket<TcpStream>) -> Vec<u8> {
    loop {
        match page.read().unwrap() {
            Message::Binary(bytes) => return bytes.to_vec(),
            Message::Close(_) => return Vec::new(),
            _ => {}
        }
    }
}

/// The next message with a tag.
fn expect(page: &mut WebSocket<TcpStream>, tag: u8) -> Vec<u8> {
    loop {
        let message = next(page);
        if message.first() == Some(&tag) {
            return message;
        }
    }
}

fn show(web: &mut Web, frame: &mut Frame, picture: &[u8]) {
    if let Some(changed) = frame.compose(picture, None) {
        web.show(frame, changed).unwrap();
    }
}

/// Size and pixels of the image in a message.
fn image(message: &[u8]) -> ((u32, u32), Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(&message[9..])).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    pixels.truncate(info.buffer_size());
    ((info.width, info.height), pixels)
}

#[test]
fn without_the_secret_nothing_is_told() {
    let (web, _) = opened();
    let (host, path) = place(&web);
    assert!(path.len() == 34, "128 bits: {path}");
    let page = get(&host, &path);
    assert!(page.starts_with("HTTP/1.1 200 OK\r\n") && page.contains("<canvas"), "{page}");
    assert!(get(&host, &format!("{path}page.js")).contains("WebSocket"));
    assert!(get(&host, &format!("{path}page.css")).contains("canvas"));
    assert!(get(&host, &format!("{path}other")).starts_with("HTTP/1.1 404 "));
    let wrong = path.replace(|c: char| c.is_ascii_digit(), "a");
    for path in ["/", "/socket", "//", &wrong[..], &format!("{wrong}socket"), &path[..33]] {
        let answer = get(&host, path);
        assert!(answer.starts_with("HTTP/1.1 403 Forbidden\r\n"), "{path}: {answer}");
        assert!(!answer.contains("canvas"));
    }
    let stream = TcpStream::connect(&host).unwrap();
    assert!(tungstenite::client(format!("ws://{host}{wrong}socket"), stream).is_err());
    let mut stream = TcpStream::connect(&host).unwrap();
    stream.write_all(b"POST / HTTP/1.1\r\n\r\n").unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    assert!(answer.starts_with("HTTP/1.1 400 "), "{answer}");
}

#[test]
fn two_addresses_are_never_the_same() {
    let (first, second) = (opened().0, opened().0);
    assert_ne!(place(&first).1, place(&second).1);
}

#[test]
fn a_viewer_sees_the_picture_and_operates_it() {
    let (mut web, mut queue) = opened();
    let mut frame = Frame::new(40, 30);
    let mut picture = vec![255; 4800];
    show(&mut web, &mut frame, &picture);
    let mut page = viewer(&web);
    let hello = next(&mut page);
    assert_eq!(hello[..9], [0, 40, 0, 0, 0, 30, 0, 0, 0]);
    assert_eq!(&hello[9..], b"a test");
    assert_eq!(next(&mut page), [2, 1], "the first one steers");
    let (size, pixels) = image(&expect(&mut page, 1));
    assert_eq!((size, pixels.len()), ((40, 30), 3600));
    picture[(7 * 40 + 5) * 4 + 1] = 9;
    show(&mut web, &mut frame, &picture);
    let message = expect(&mut page, 1);
    assert_eq!(message[1..9], [5, 0, 0, 0, 7, 0, 0, 0]);
    assert_eq!(image(&message), ((1, 1), vec![255, 9, 255]));
    let event = Event::Pressed(Button::Secondary, DVec2::new(3.5, 4.5));
    page.send(Message::binary(event.to_bytes().to_vec())).unwrap();
    page.send(Message::binary(vec![99; 18])).unwrap();
    page.send(Message::text("what is this?")).unwrap();
    assert_eq!(queue.next(Some(Duration::from_secs(5))), Some(event));
    assert_eq!(queue.next(Some(Duration::from_millis(100))), None);
    let end = std::thread::spawn(move || web.close(Ending::default()));
    assert_eq!(expect(&mut page, 3), [3]);
    end.join().unwrap();
}

#[test]
fn another_takes_over() {
    let (web, mut queue) = opened();
    let mut first = viewer(&web);
    assert_eq!(expect(&mut first, 2), [2, 1]);
    let mut second = viewer(&web);
    assert_eq!(expect(&mut second, 2), [2, 0]);
    let key = |character| Message::binary(Event::Character(character).to_bytes().to_vec());
    second.send(key('a')).unwrap();
    second.send(Message::binary(vec![0])).unwrap();
    assert_eq!(expect(&mut second, 2), [2, 1]);
    assert_eq!(expect(&mut first, 2), [2, 0]);
    second.send(key('b')).unwrap();
    assert_eq!(queue.next(Some(Duration::from_secs(5))), Some(Event::Character('b')));
    drop(second);
    assert_eq!(expect(&mut first, 2), [2, 1], "who remains steers");
}

#[test]
fn a_viewer_that_does_not_read_holds_nobody_up() {
    let (mut web, _) = super::open("", (1000, 1000), None, false).unwrap();
    let idle = viewer(&web);
    let mut frame = Frame::new(1000, 1000);
    let mut picture = vec![255; 4_000_000];
    let mut random = 1u32;
    let start = Instant::now();
    for _ in 0..20 {
        for byte in &mut picture {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            *byte = (random >> 24) as u8 | 1;
        }
        picture.chunks_exact_mut(4).for_each(|pixel| pixel[3] = 255);
        show(&mut web, &mut frame, &picture);
    }
    assert!(start.elapsed() < Duration::from_secs(20));
    web.close(Ending::default());
    drop(idle);
}
