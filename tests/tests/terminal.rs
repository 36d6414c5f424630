//! The terminal workstations in terminals: pictures decoded by programs that nobody here wrote, and keys that are
//! sent to them.

use data_encoding::BASE64;
use gks_tests::operation::{Operation, Results, SIZE, compiled, difference, is_near, picture, wait};
use gks_tests::program;
use gks_tests::reader::{self, present};
use gks_workstations::interactive::scale::{Scaler, fit};
use image::{Rgb, RgbImage};
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex};

/// A terminal that does not show anything but remembers what it is sent.
struct Terminal {
    process: Child,
    said: Arc<Mutex<Vec<u8>>>,
}

impl Terminal {
    /// Runs the program with steps in a terminal of 120 columns and 62 rows.
    fn start(program: &Path, folder: &Path, kind: &str, steps: &[&str]) -> Terminal {
        let results = folder.join("results");
        let line = format!(
            "stty rows 62 cols 120; exec {} {} {}",
            program.display(),
            results.display(),
            steps.join(" ")
        );
        let mut process = Command::new("script")
            .args(["-qefc", &line, "/dev/null"])
            .current_dir(folder)
            .env("TERM", "xterm")
            .env_remove("TERM_PROGRAM")
            .env_remove("KITTY_WINDOW_ID")
            .env("GKS_WSTYPE", kind)
            .env("GKS_OPTIONS", format!("size={SIZE}x{SIZE}"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("a terminal");
        let said = Arc::new(Mutex::new(Vec::new()));
        let (shared, mut output) = (Arc::clone(&said), process.stdout.take().expect("its output"));
        std::thread::spawn(move || {
            let mut bytes = [0; 4096];
            while let Ok(count) = output.read(&mut bytes)
                && count > 0
            {
                shared.lock().expect("no panic").extend(&bytes[..count]);
            }
        });
        Terminal { process, said }
    }

    fn said(&self) -> Vec<u8> {
        self.said.lock().expect("no panic").clone()
    }

    fn send(&mut self, bytes: &[u8]) {
        let input = self.process.stdin.as_mut().expect("its input");
        input.write_all(bytes).and_then(|()| input.flush()).expect("a terminal that listens");
    }

    /// Waits for the end of the program and gives all that it has sent.
    fn finish(mut self) -> Vec<u8> {
        let status = wait("the end of the program", || self.process.try_wait().ok().flatten());
        assert!(status.success(), "{status}");
        let mut length = None;
        wait("the rest", || {
            let before = length.replace(self.said().len());
            (before == length).then_some(())
        });
        self.said()
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The program and an empty folder; none where something is missing.
fn prepared(name: &str, needed: &[&str]) -> Option<(&'static Path, PathBuf)> {
    if !present(name, needed) {
        return None;
    }
    let program = compiled(env!("CARGO_TARGET_TMPDIR"))?;
    Some((program, program::folder(env!("CARGO_TARGET_TMPDIR"), "terminal", name)))
}

/// The pieces between two marks.
fn between<'a>(text: &'a [u8], start: &[u8], end: &[u8]) -> Vec<&'a [u8]> {
    let find = |text: &[u8], what: &[u8]| text.windows(what.len()).position(|part| part == what);
    let (mut rest, mut found) = (text, Vec::new());
    while let Some(at) = find(rest, start) {
        let inside = &rest[at + start.len()..];
        let Some(length) = find(inside, end) else { break };
        found.push(&inside[..length]);
        rest = &inside[length + end.len()..];
    }
    found
}

/// The picture in sixels, as libsixel decodes it.
fn sixels(folder: &Path, image: &[u8]) -> RgbImage {
    let [from, to] =
        ["picture.six", "sixels.png"].map(|name| folder.join(name).to_string_lossy().into_owned());
    fs::write(&from, [b"\x1bP", image, b"\x1b\\"].concat()).expect("a file");
    reader::run(60, "sixel2png", &["-i", &from, "-o", &to]).expect("sixels");
    image::open(to).expect("a picture").to_rgb8()
}

#[test]
fn sixels_are_the_picture_in_256_colours() {
    let Some((program, folder)) = prepared("sixel", &["script", "sixel2png"]) else { return };
    let expected = picture(program, &folder);
    let said = Terminal::start(program, &folder, "sixel", &[]).finish();
    let images = between(&said, b"\x1bP", b"\x1b\\");
    assert_eq!(images.len(), 1, "one page, one picture");
    let shown = sixels(&folder, images[0]);
    let (mean, most) = difference(&shown, &expected);
    // Components are said in hundredths.
    assert!(mean < 0.5 && most <= 32, "{mean} {most}");
}

#[test]
fn a_terminal_that_says_it_has_sixels_gets_them() {
    let Some((program, folder)) = prepared("asked", &["script", "sixel2png"]) else { return };
    let mut terminal = Terminal::start(program, &folder, "terminal", &[]);
    wait("the question", || {
        let said = terminal.said();
        said.windows(3).any(|part| part == b"\x1b[c").then_some(())
    });
    terminal.send(b"\x1b[?62;4;22c");
    let said = terminal.finish();
    let image = *between(&said, b"\x1bP0;1;0q", b"\x1b\\").first().expect("sixels");
    assert_eq!(sixels(&folder, &[b"0;1;0q", image].concat()).dimensions(), (SIZE, SIZE));
}

#[test]
fn kitty_gets_the_picture_to_the_last_pixel() {
    let Some((program, folder)) = prepared("kitty", &["script"]) else { return };
    let expected = picture(program, &folder);
    let said = Terminal::start(program, &folder, "kitty", &[]).finish();
    let pieces = between(&said, b"\x1b_G", b"\x1b\\");
    let text: Vec<u8> = pieces
        .iter()
        .flat_map(|piece| piece.split(|&byte| byte == b';').nth(1).expect("control and content"))
        .copied()
        .collect();
    assert!(pieces[0].starts_with(b"a=T,f=100,"), "shown at once, PNG");
    let shown = image::load_from_memory(&BASE64.decode(&text).expect("base 64")).expect("PNG").to_rgb8();
    assert_eq!(difference(&shown, &expected), (0.0, 0));
}

/// The picture that is shown in half blocks, by the colours that are selected (ECMA-48, SGR): above and below in
/// each cell.
fn blocks(text: &str) -> RgbImage {
    let (mut colours, mut row, mut rows) = ([[0; 3]; 2], Vec::new(), Vec::new());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        if let Some(sequence) = rest.strip_prefix("\x1b[") {
            let end = sequence.find(|c: char| c.is_ascii_alphabetic()).expect("a whole sequence");
            let numbers: Vec<u8> = sequence[..end].split(';').filter_map(|n| n.parse().ok()).collect();
            let mut numbers = &numbers[..];
            while let [layer @ (38 | 48), 2, red, green, blue, others @ ..] = numbers {
                colours[usize::from(*layer == 48)] = [*red, *green, *blue];
                numbers = others;
            }
            rest = &sequence[end + 1..];
            continue;
        }
        match first {
            '\u{2580}' => row.push(colours),
            '\n' if !row.is_empty() => rows.push(std::mem::take(&mut row)),
            _ => {}
        }
        rest = &rest[first.len_utf8()..];
    }
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    RgbImage::from_fn(width as u32, rows.len() as u32 * 2, |x, y| {
        let cell = rows[y as usize / 2].get(x as usize);
        Rgb(cell.map_or([0; 3], |cell| cell[y as usize % 2]))
    })
}

/// A picture as it fits into a room.
fn scaled(picture: &RgbImage, room: (u32, u32)) -> RgbImage {
    let size = fit(picture.dimensions(), room);
    let scaler = Scaler::new(picture.dimensions(), size);
    let old = |column: usize, row: usize| picture.get_pixel(column as u32, row as u32).0;
    RgbImage::from_fn(size.0, size.1, |x, y| Rgb(scaler.pixel(x as usize, y as usize, old)))
}

#[test]
fn half_blocks_are_the_means_of_the_picture() {
    let Some((program, folder)) = prepared("blocks", &["script"]) else { return };
    let expected = scaled(&picture(program, &folder), (120, 120));
    let said = Terminal::start(program, &folder, "blocks", &[]).finish();
    let text = String::from_utf8(said).expect("UTF-8");
    let shown = blocks(&text);
    shown.save(folder.join("blocks.png")).expect("a picture");
    assert_eq!(difference(&shown, &expected), (0.0, 0));
}

/// A program in tmux.
struct Tmux {
    socket: PathBuf,
    results: Results,
}

impl Tmux {
    fn start(program: &Path, folder: &Path, steps: &[&str]) -> Tmux {
        // Paths of sockets may not be long.
        let socket = std::env::temp_dir().join(format!("gks-tmux-{}", std::process::id()));
        let results = folder.join("results");
        let line = format!(
            "GKS_WSTYPE=blocks GKS_OPTIONS=size={SIZE}x{SIZE} {} {} {}; tput cup 0 0; cat",
            program.display(),
            results.display(),
            steps.join(" ")
        );
        let tmux = Tmux { socket, results: Results::new(results) };
        tmux.tell(&["-f", "/dev/null", "new-session", "-d", "-x", "100", "-y", "50", &line]);
        tmux
    }

    fn tell(&self, words: &[&str]) -> String {
        let socket = self.socket.to_string_lossy();
        let said = Command::new("tmux")
            .args(["-u", "-S", &socket])
            .args(words)
            .env_remove("TMUX")
            .env("LC_ALL", "C.UTF-8")
            .output()
            .expect("tmux runs");
        assert!(said.status.success(), "{words:?}: {}", String::from_utf8_lossy(&said.stderr));
        String::from_utf8_lossy(&said.stdout).into_owned()
    }

    fn keys(&self, keys: &[&str]) {
        self.tell(&[&["send-keys"], keys].concat());
    }

    /// What is on the screen.
    fn screen(&self) -> RgbImage {
        blocks(&self.tell(&["capture-pane", "-e", "-p"]))
    }

    /// Waits until a part of the screen is unlike the picture by a share of its pixels: prompts are shown.
    fn shows(&self, name: &str, expected: &RgbImage, folder: &Path, unlike: std::ops::Range<f64>) {
        wait(name, || {
            let screen = self.screen();
            // Between two requests the terminal shows text.
            if screen.dimensions() != expected.dimensions() {
                return None;
            }
            screen.save(folder.join(format!("{name}.png"))).expect("a picture");
            let pairs = screen.pixels().zip(expected.pixels());
            let other = pairs.filter(|(a, b)| (0..3).any(|i| a.0[i].abs_diff(b.0[i]) > 2)).count();
            unlike.contains(&(other as f64 / expected.pixels().len() as f64)).then_some(())
        });
    }
}

impl Drop for Tmux {
    fn drop(&mut self) {
        let socket = self.socket.to_string_lossy();
        let _ = Command::new("tmux").args(["-S", &socket, "kill-server"]).output();
        let _ = fs::remove_file(&self.socket);
    }
}

#[test]
fn each_kind_of_input_is_typed_in_a_terminal() {
    let Some((program, folder)) = prepared("keys", &["tmux"]) else { return };
    let expected = scaled(&picture(program, &folder), (100, 100));
    let steps = [
        "request:locator:3",
        "request:stroke:4",
        "request:valuator:1",
        "request:choice:3",
        "request:pick:1",
        "request:string:1",
        "request:choice:1",
        "sample:valuator:1",
        "event:choice:3",
    ];
    let mut tmux = Tmux::start(program, &folder, &steps);
    assert_eq!(tmux.results.line(), "drawn");
    // The cross covers little.
    tmux.shows("locator", &expected, &folder, 0.0003..0.03);
    tmux.keys(&["-N", "5", "Right"]);
    tmux.keys(&["Down", "Enter"]);
    let line = tmux.results.line();
    assert!(is_near(&line, "locator ok", &[2.51, 5.89], 0.001), "{line}");
    // Nothing but the picture: a stroke has no position yet.
    tmux.shows("stroke-start", &expected, &folder, 0.0..0.0003);
    tmux.keys(&["Right", "Space"]);
    tmux.keys(&["-N", "10", "Up"]);
    tmux.keys(&["Space"]);
    tmux.shows("stroke", &expected, &folder, 0.001..0.05);
    tmux.keys(&["Enter"]);
    let line = tmux.results.line();
    assert!(is_near(&line, "stroke ok", &[5.1, 5.0, 5.1, 6.0], 0.001), "{line}");
    tmux.shows("valuator", &expected, &folder, 0.02..0.06);
    tmux.keys(&["PageUp", "PageUp", "Up", "Enter"]);
    let line = tmux.results.line();
    assert!(is_near(&line, "valuator ok", &[41.0], 0.001), "{line}");
    tmux.shows("choice", &expected, &folder, 0.01..0.06);
    tmux.keys(&["F3"]);
    assert_eq!(tmux.results.line(), "choice ok 3");
    tmux.shows("pick-start", &expected, &folder, 0.0..0.0003);
    tmux.keys(&["-N", "22", "Right"]);
    tmux.keys(&["-N", "22", "Up"]);
    tmux.shows("pick", &expected, &folder, 0.001..0.05);
    tmux.keys(&["Enter"]);
    assert_eq!(tmux.results.line(), "pick ok 1 11");
    tmux.shows("string", &expected, &folder, 0.01..0.06);
    tmux.keys(&["-l", " and \u{e4}"]);
    tmux.keys(&["Enter"]);
    assert_eq!(tmux.results.line(), "string ok text and \u{e4}");
    tmux.shows("break", &expected, &folder, 0.005..0.06);
    tmux.keys(&["Escape"]);
    assert_eq!(tmux.results.line(), "choice none");
    tmux.shows("sample", &expected, &folder, 0.02..0.06);
    tmux.keys(&["Up"]);
    assert_eq!(tmux.results.line(), "valuator ok 21.00");
    tmux.shows("event", &expected, &folder, 0.01..0.06);
    tmux.keys(&["4"]);
    assert_eq!(tmux.results.line(), "choice ok 4");
    assert_eq!(tmux.results.line(), "closed");
}

#[test]
fn the_end_of_a_terminal_ends_requests_and_not_the_program() {
    let Some((program, folder)) = prepared("gone", &["script"]) else { return };
    let steps = ["request:locator:3", "request:string:1"];
    let mut terminal = Terminal::start(program, &folder, "blocks", &steps);
    let mut results = Results::new(folder.join("results"));
    assert_eq!(results.line(), "drawn");
    wait("the whole terminal", || {
        let said = terminal.said();
        said.windows(8).any(|part| part == b"\x1b[?1049h").then_some(())
    });
    // The end of all input.
    terminal.send(b"\x04");
    assert_eq!(results.line(), "locator none");
    assert_eq!(results.line(), "string none");
    assert_eq!(results.line(), "closed");
    let said = terminal.finish();
    assert!(said.windows(8).any(|part| part == b"\x1b[?1049l"), "the text is back");
}

#[test]
fn no_terminal_is_no_fault() {
    let Some((program, folder)) = prepared("none", &[]) else { return };
    let mut operation =
        Operation::start(program, &folder, &[("GKS_WSTYPE", "blocks")], &["request:locator:1"]);
    assert_eq!(operation.line(), "drawn");
    assert_eq!(operation.line(), "locator none");
    assert!(operation.finish().success());
}
