//! The window workstation as an operator sees it: an X server without a screen, and a pointer and a keyboard that
//! are moved and typed on.

use gks_tests::operation::{Colour, Operation, compiled, has, is, is_near, wait};
use gks_tests::program;
use gks_tests::reader::present;
use image::{Rgb, RgbImage};
use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// An X server whose screen is a file.
struct Display {
    server: Child,
    number: String,
    folder: PathBuf,
}

impl Display {
    fn start(folder: &Path, width: u32, height: u32) -> Display {
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-nolisten", "tcp", "-noreset", "-fbdir"])
            .arg(folder)
            .args(["-screen", "0", &format!("{width}x{height}x24")])
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the X server starts");
        let mut number = String::new();
        BufReader::new(server.stdout.take().expect("its output")).read_line(&mut number).expect("a number");
        assert!(!number.trim().is_empty(), "the X server ended at once");
        Display { server, number: format!(":{}", number.trim()), folder: folder.to_owned() }
    }

    /// What is on the screen: a file as `xwd` writes it.
    fn screen(&self) -> RgbImage {
        let dump = fs::read(self.folder.join("Xvfb_screen0")).expect("the screen");
        let number = |at: usize| u32::from_be_bytes(dump[at * 4..at * 4 + 4].try_into().expect("four bytes"));
        let (header, width, height, stride, colours) =
            (number(0), number(4), number(5), number(12), number(19));
        assert_eq!((number(7), number(11)), (0, 32), "little end first, four bytes each");
        let first = (header + colours * 12) as usize;
        RgbImage::from_fn(width, height, |x, y| {
            let at = first + (y * stride + x * 4) as usize;
            Rgb([dump[at + 2], dump[at + 1], dump[at]])
        })
    }

    /// Waits until the screen shows something, and keeps the picture under a name to be looked at.
    fn shows(&self, name: &str, condition: impl Fn(&RgbImage) -> bool) -> RgbImage {
        let mut last = None;
        let seen = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            wait(name, || {
                let screen = self.screen();
                let found = condition(&screen);
                last = Some(screen);
                found.then_some(())
            });
        }));
        let screen = last.expect("the screen was looked at");
        screen.save(self.folder.join(format!("{name}.png"))).expect("a screenshot");
        if let Err(panic) = seen {
            std::panic::resume_unwind(panic);
        }
        screen
    }

    /// Moves the pointer to a position until the screen shows something: what the operator does before a device is
    /// started is not meant for it.
    fn points(&self, name: &str, (x, y): (u32, u32), condition: impl Fn(&RgbImage) -> bool) -> RgbImage {
        self.shows(name, |screen| {
            let found = condition(screen);
            if !found {
                self.act(&format!("mousemove {} {y} mousemove {x} {y}", x + 1));
            }
            found
        })
    }

    /// Lets `xdotool` do what a line says.
    fn act(&self, line: &str) {
        let words = line.split(' ');
        let status = Command::new("xdotool").args(words).env("DISPLAY", &self.number).status();
        assert!(status.expect("xdotool runs").success(), "{line}");
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// The program with steps in a window on a display of its own; none where something is missing.
fn opened(name: &str, steps: &[&str]) -> Option<(Display, Operation)> {
    opened_on(name, (900, 700), &[], steps)
}

fn opened_on(
    name: &str,
    size: (u32, u32),
    environment: &[(&str, &str)],
    steps: &[&str],
) -> Option<(Display, Operation)> {
    if !present(name, &["Xvfb", "xdotool"]) {
        return None;
    }
    let program = compiled(env!("CARGO_TARGET_TMPDIR"))?;
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "window", name);
    let display = Display::start(&folder, size.0, size.1);
    // Where it is while the window appears.
    display.act("mousemove 300 150");
    let own = [("GKS_WSTYPE", "window"), ("DISPLAY", &display.number), ("WAYLAND_DISPLAY", "")];
    let mut operation = Operation::start(program, &folder, &[&own, environment].concat(), steps);
    assert_eq!(operation.line(), "drawn");
    // There is no window manager to do it. Its window is there: what is drawn has been handed to it.
    display.act("search --name GKS windowfocus");
    Some((display, operation))
}

/// Whether the picture is there: the triangle is green and the square is blue.
fn is_drawn(screen: &RgbImage) -> bool {
    is(screen, 150, 480, Colour::Green) && is(screen, 465, 135, Colour::Blue)
}

#[test]
fn locators_have_crosshair_tracking_cross_rubber_band_rectangle_and_digits() {
    let steps = [2, 3, 4, 5, 6, 1].map(|prompt| format!("request:locator:{prompt}"));
    let steps = steps.each_ref().map(String::as_str);
    let Some((display, mut program)) = opened("locator", &steps) else { return };
    let near = |program: &mut Operation, x, y| {
        let line = program.line();
        assert!(is_near(&line, "locator ok", &[x, y], 0.02), "{line}");
    };
    display.points("locator-2", (300, 150), |s| {
        let lines = [(50, 150), (300, 550)];
        is_drawn(s) && lines.iter().all(|&(x, y)| is(s, x, y, Colour::Dark)) && is(s, 30, 30, Colour::White)
    });
    display.act("click 1");
    near(&mut program, 5.01, 7.49);
    display
        .points("locator-3", (350, 250), |s| is(s, 350, 243, Colour::Dark) && is(s, 300, 150, Colour::White));
    display.act("click 1");
    near(&mut program, 5.84, 5.83);
    // From the initial position.
    display.points("locator-4", (420, 300), |s| {
        has(s, [118, 123, 238, 243], Colour::Accent) && has(s, [268, 273, 267, 273], Colour::Dark)
    });
    display.act("click 1");
    near(&mut program, 7.01, 4.99);
    display.points("locator-5", (400, 320), |s| {
        has(s, [118, 123, 238, 243], Colour::Accent) && is(s, 255, 320, Colour::Dark)
    });
    display.act("click 1");
    near(&mut program, 6.68, 4.66);
    display.points("locator-6", (200, 320), |s| {
        has(s, [440, 595, 550, 598], Colour::Panel) && is(s, 210, 320, Colour::Dark)
    });
    // Ten steps of a hundredth of the window, and Return.
    display.act("key Right Right Right Right Right Right Right Right Right Right Return");
    near(&mut program, 4.34, 4.66);
    display.points("locator-1", (300, 200), |s| is(s, 310, 200, Colour::Dark));
    display.act("click 1");
    near(&mut program, 5.01, 6.66);
    assert!(program.finish().success());
}

#[test]
fn strokes_are_dragged_and_clicked() {
    let steps = ["request:stroke:4", "request:stroke:3", "request:stroke:2", "request:stroke:1"];
    let Some((display, mut program)) = opened("stroke", &steps) else { return };
    // The cross at the pointer says that the device is started.
    let cross = |x: u32, y: u32| move |s: &RgbImage| is_drawn(s) && is(s, x + 6, y, Colour::Dark);
    let request = |name: &str| {
        display.act("mousemove 60 340");
        display.shows(name, cross(60, 340))
    };
    request("stroke-4-start");
    display.act("mousedown 1 mousemove 120 280 mousemove 180 340 mouseup 1");
    display.act("mousemove 300 300 click 1 mousemove 360 240");
    display.shows("stroke-4", |s| {
        has(s, [88, 92, 308, 312], Colour::Accent) && has(s, [238, 242, 318, 322], Colour::Accent)
    });
    display.act("key Return");
    let line = program.line();
    let expected = [1.01, 4.32, 2.01, 5.32, 3.01, 4.32, 5.01, 4.99];
    assert!(is_near(&line, "stroke ok", &expected, 0.02), "{line}");
    request("stroke-3-start");
    display.act("click 1 mousemove 120 280 click 1 mousemove 200 200 click 1 mousemove 240 300");
    display.shows("stroke-3", |s| is(s, 200, 200, Colour::Accent) && is(s, 90, 310, Colour::White));
    display.act("key BackSpace mousemove 300 300 click 3");
    let line = program.line();
    assert!(is_near(&line, "stroke ok", &[1.01, 4.32, 2.01, 5.32], 0.02), "{line}");
    request("stroke-2-start");
    display.act("click 1");
    display.shows("stroke-2", |s| has(s, [440, 595, 550, 598], Colour::Panel));
    display.act("mousemove 300 300 key space key Return");
    let line = program.line();
    assert!(is_near(&line, "stroke ok", &[1.01, 4.32, 5.01, 4.99], 0.02), "{line}");
    request("stroke-1-start");
    display.act("click 1 mousemove 120 280 click 1");
    display.shows("stroke-1", |s| has(s, [88, 92, 308, 312], Colour::Accent));
    display.act("click 3");
    let line = program.line();
    assert!(is_near(&line, "stroke ok", &[1.01, 4.32, 2.01, 5.32], 0.02), "{line}");
    assert!(program.finish().success());
}

#[test]
fn valuators_have_slider_dial_and_digits() {
    let steps = ["request:valuator:1", "request:valuator:2", "request:valuator:3"];
    let Some((display, mut program)) = opened("valuator", &steps) else { return };
    display.shows("valuator-1-start", |s| is_drawn(s) && has(s, [18, 50, 580, 585], Colour::Accent));
    display.act("mousemove 60 582 mousedown 1 mousemove 125 582");
    display.shows("valuator-1", |s| has(s, [110, 124, 580, 585], Colour::Accent));
    display.act("mouseup 1");
    let line = program.line();
    assert!(is_near(&line, "valuator ok", &[50.3], 0.5), "{line}");
    display.shows("valuator-2-start", |s| has(s, [5, 105, 495, 595], Colour::Panel));
    // Up is more; this server reports two turns, when the button goes down and when it goes up.
    display.act("mousemove 300 300 click 4 key Prior");
    display.shows("valuator-2", |s| has(s, [5, 105, 495, 560], Colour::Accent));
    display.act("key Return");
    let line = program.line();
    assert!(is_near(&line, "valuator ok", &[34.0], 0.01), "{line}");
    display.shows("valuator-3", |s| has(s, [5, 150, 570, 598], Colour::Panel));
    display.act("key Up Up Up Next Return");
    let line = program.line();
    assert!(is_near(&line, "valuator ok", &[13.0], 0.01), "{line}");
    assert!(program.finish().success());
}

#[test]
fn choices_are_numbers_lamps_names_typed_names_and_pictures() {
    let steps = [1, 2, 3, 4, 5, 5].map(|prompt| format!("request:choice:{prompt}"));
    let steps = steps.each_ref().map(String::as_str);
    let Some((display, mut program)) = opened("choice", &steps) else { return };
    display.shows("choice-1-start", |s| is_drawn(s) && has(s, [460, 595, 5, 48], Colour::Panel));
    display.act("mousemove 579 33 click 1 click 1 click 1");
    display.shows("choice-1", |s| {
        has(s, [460, 595, 5, 48], Colour::Panel) && !has(s, [0, 450, 5, 600], Colour::Panel)
    });
    display.act("mousemove 527 33 click 1");
    assert_eq!(program.line(), "choice ok 3");
    display.act("mousemove 548 40");
    display.shows("choice-2", |s| has(s, [500, 595, 5, 70], Colour::Panel) && is(s, 548, 110, Colour::White));
    // The second one is not offered.
    display.act("click 1 key 2 mousemove 548 60 click 1");
    assert_eq!(program.line(), "choice ok 3");
    display.act("mousemove 548 39");
    display.shows("choice-3", |s| has(s, [500, 595, 5, 90], Colour::Panel));
    display.act("click 1");
    assert_eq!(program.line(), "choice ok 2");
    display.shows("choice-4", |s| has(s, [500, 595, 5, 90], Colour::Panel));
    display.act("type te");
    display.act("key Return");
    assert_eq!(program.line(), "choice ok 3");
    // The unit square in the upper right corner: the square of the menu is red, the picture below it is not seen.
    display.act("mousemove 100 300");
    display.shows("choice-5-start", |s| is(s, 528, 120, Colour::Red) && is(s, 465, 230, Colour::White));
    display.act("mousemove 528 120");
    display.shows("choice-5", |s| has(s, [474, 481, 118, 122], Colour::Orange));
    display.act("click 1");
    assert_eq!(program.line(), "choice ok 2");
    display.shows("choice-5-again", |s| has(s, [474, 481, 118, 122], Colour::Orange));
    display.act("mousemove 380 20 click 1");
    assert_eq!(program.line(), "choice nothing");
    assert!(program.finish().success());
}

#[test]
fn picks_show_what_they_would_pick() {
    let steps = ["request:pick:1", "request:pick:2", "request:pick:3", "request:pick:1", "request:pick:1"];
    let Some((display, mut program)) = opened("pick", &steps) else { return };
    // Left of the square, right of the wave, above the triangle: where bands of highlighting are.
    let square = |s: &RgbImage| has(s, [415, 421, 130, 140], Colour::Orange);
    let wave = |s: &RgbImage| has(s, [300, 540, 350, 360], Colour::Orange);
    let triangle = |s: &RgbImage| has(s, [55, 245, 539, 545], Colour::Orange);
    let shown = |s: &RgbImage| [triangle(s), square(s), wave(s)];
    display.shows("pick-start", is_drawn);
    display.act("mousemove 150 480");
    display.shows("pick-1", |s| shown(s) == [true, false, false] && is_drawn(s));
    display.act("mousemove 30 300");
    display.shows("pick-nothing", |s| shown(s) == [false; 3]);
    display.act("mousemove 150 480 click 1");
    assert_eq!(program.line(), "pick ok 1 11");
    display.shows("pick-2", |s| shown(s) == [true, true, false]);
    display.act("mousemove 360 360");
    display.shows("pick-2-wave", |s| shown(s) == [false, false, true]);
    display.act("click 1");
    assert_eq!(program.line(), "pick ok 1 12");
    display.shows("pick-3-wave", |s| shown(s) == [true; 3]);
    display.act("mousemove 150 480");
    display.shows("pick-3", |s| shown(s) == [true; 3]);
    display.act("key Return");
    assert_eq!(program.line(), "pick ok 1 11");
    display.act("mousemove 150 120");
    display.shows("pick-text", |s| has(s, [80, 220, 80, 160], Colour::Orange));
    display.act("click 1");
    assert_eq!(program.line(), "pick ok 2 21");
    display.shows("pick-again", |s| has(s, [80, 220, 80, 160], Colour::Orange));
    display.act("mousemove 30 300 click 1");
    assert_eq!(program.line(), "pick nothing");
    assert!(program.finish().success());
}

#[test]
fn strings_are_typed_and_edited() {
    let Some((display, mut program)) = opened("string", &["request:string:1"]) else { return };
    display.shows("string-start", |s| is_drawn(s) && has(s, [5, 250, 5, 35], Colour::Panel));
    display.act("mousemove 300 300 type and");
    display.act("key BackSpace BackSpace BackSpace space A Left exclam Home Delete");
    display.shows("string", |s| has(s, [5, 250, 5, 35], Colour::Panel));
    display.act("key Return");
    assert_eq!(program.line(), "string ok ext !A");
    assert!(program.finish().success());
}

#[test]
fn samples_follow_the_operator() {
    let steps = ["sample:locator:3", "sample:pick:1", "sample:choice:3", "sample:string:1"];
    let Some((display, mut program)) = opened("sample", &steps) else { return };
    let line = wait("a sample", || {
        display.act("mousemove 301 150 mousemove 300 150");
        program.results.arrived()
    });
    assert!(is_near(&line, "locator ok", &[5.01, 7.49], 0.03), "{line}");
    // The sample is over as soon as something is picked.
    display.act("mousemove 465 135");
    assert_eq!(program.line(), "pick ok 1 11");
    display.shows("sample-choice", |s| has(s, [500, 595, 5, 90], Colour::Panel));
    display.act("mousemove 548 39");
    assert_eq!(program.line(), "choice ok 2");
    display.shows("sample-string", |s| has(s, [5, 250, 5, 35], Colour::Panel));
    display.act("mousemove 300 300 key x");
    assert_eq!(program.line(), "string ok textx");
    assert!(program.finish().success());
}

#[test]
fn six_devices_make_events_and_do_not_get_in_each_others_way() {
    let Some((display, mut program)) = opened("event", &["event:all:1"]) else { return };
    display.shows("event-start", |s| {
        is_drawn(s)
            && has(s, [500, 595, 5, 90], Colour::Panel)
            && has(s, [5, 245, 555, 595], Colour::Panel)
            && has(s, [5, 250, 5, 35], Colour::Panel)
    });
    display.act("mousemove 548 20 click 1");
    assert_eq!(program.line(), "choice ok 1");
    display.act("mousemove 60 582 mousedown 1 mousemove 125 582 mouseup 1");
    let line = program.line();
    assert!(is_near(&line, "valuator ok", &[50.3], 0.5), "{line}");
    display.act("mousemove 20 20 click 1 type s");
    display.act("key Return");
    assert_eq!(program.line(), "string ok texts");
    // One click is the trigger of both, and a point of the stroke.
    display.act("mousemove 150 480");
    display.shows("event", |s| has(s, [55, 245, 539, 545], Colour::Orange));
    display.act("click 1");
    let line = program.line();
    assert!(is_near(&line, "locator ok", &[2.51, 1.99], 0.02), "{line}");
    assert_eq!(program.line(), "pick ok 1 11");
    display.act("click 3");
    let line = program.line();
    assert!(is_near(&line, "stroke ok", &[2.51, 1.99], 0.02), "{line}");
    assert!(program.finish().success());
}

#[test]
fn escape_is_break() {
    let steps = ["request:locator:1", "request:choice:1", "request:string:1"];
    let Some((display, mut program)) = opened("break", &steps) else { return };
    display.points("break-locator", (300, 240), |s| is(s, 310, 240, Colour::Dark));
    display.act("key Escape");
    assert_eq!(program.line(), "locator none");
    display.shows("break-choice", |s| has(s, [460, 595, 5, 48], Colour::Panel));
    display.act("key Escape");
    assert_eq!(program.line(), "choice none");
    display.shows("break-string", |s| has(s, [5, 250, 5, 35], Colour::Panel));
    display.act("key Escape");
    assert_eq!(program.line(), "string none");
    assert!(program.finish().success());
}

#[test]
fn a_viewer_that_dies_ends_requests_and_not_the_program() {
    let steps = ["request:locator:2", "request:choice:1", "event:locator:1"];
    let Some((display, mut program)) = opened("dead", &steps) else { return };
    display.shows("dead", is_drawn);
    let viewers = program.children();
    let [viewer] = viewers[..] else { panic!("{viewers:?}") };
    let killed = Command::new("kill").args(["-KILL", &viewer.to_string()]).status();
    assert!(killed.expect("kill runs").success());
    assert_eq!(program.line(), "locator none");
    assert_eq!(program.line(), "choice none");
    assert_eq!(program.line(), "none", "nobody can make an event");
    assert!(program.finish().success());
}

#[test]
fn a_display_that_dies_ends_requests_and_not_the_program() {
    let Some((mut display, mut program)) = opened("display", &["request:string:1"]) else { return };
    display.shows("display", is_drawn);
    display.server.kill().expect("the X server ends");
    assert_eq!(program.line(), "string none");
    assert!(program.finish().success());
}

#[test]
fn a_window_that_changes_its_size_shows_all_of_the_picture() {
    let Some((display, mut program)) = opened("resized", &["request:locator:3"]) else { return };
    display.shows("resized-start", is_drawn);
    display.act("search --name GKS windowsize 400 500");
    // Smaller, and in the middle from top to bottom.
    display.shows("resized", |s| {
        is(s, 100, 370, Colour::Green) && is(s, 310, 140, Colour::Blue) && !is_drawn(s)
    });
    display.act("mousemove 200 250 click 1");
    let line = program.line();
    assert!(is_near(&line, "locator ok", &[5.01, 4.99], 0.03), "{line}");
    assert!(program.finish().success());
}

#[test]
fn a_screen_with_small_pixels_shows_a_picture_as_large() {
    let environment = [("WINIT_X11_SCALE_FACTOR", "2")];
    let Some((display, mut program)) =
        opened_on("scaled", (1400, 1400), &environment, &["request:locator:3"])
    else {
        return;
    };
    display.shows("scaled", |s| is(s, 300, 960, Colour::Green) && is(s, 930, 270, Colour::Blue));
    display.act("mousemove 600 600 click 1");
    let line = program.line();
    assert!(is_near(&line, "locator ok", &[5.0, 5.0], 0.02), "{line}");
    assert!(program.finish().success());
}

/// A Wayland compositor in a window that covers the screen of an X server; it shows one program, as large as it can.
struct Compositor {
    process: Child,
    runtime: PathBuf,
}

impl Compositor {
    const SOCKET: &str = "wayland-gks";

    fn start(display: &Display) -> Compositor {
        // Names of sockets may not be long.
        let runtime = std::env::temp_dir().join(format!("gks-wayland-{}", std::process::id()));
        fs::create_dir_all(&runtime).expect("a folder for the socket");
        fs::set_permissions(&runtime, fs::Permissions::from_mode(0o700)).expect("a folder of our own");
        let process = Command::new("weston")
            .args(["--backend=x11-backend.so", "--shell=kiosk-shell.so", "--use-pixman", "--idle-time=0"])
            .args(["--width=900", "--height=700", &format!("--socket={}", Compositor::SOCKET)])
            .env("DISPLAY", &display.number)
            .env("XDG_RUNTIME_DIR", &runtime)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the compositor starts");
        let compositor = Compositor { process, runtime };
        let socket = compositor.runtime.join(Compositor::SOCKET);
        wait("the compositor", || socket.exists().then_some(()));
        display.shows("wayland-empty", |s| !is(s, 450, 350, Colour::White));
        compositor
    }
}

impl Drop for Compositor {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
        let _ = fs::remove_dir_all(&self.runtime);
    }
}

#[test]
fn a_wayland_session_needs_no_x_and_may_die_like_one() {
    if !present("wayland", &["Xvfb", "xdotool", "weston"]) {
        return;
    }
    let Some(program) = compiled(env!("CARGO_TARGET_TMPDIR")) else { return };
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "window", "wayland");
    let display = Display::start(&folder, 900, 700);
    let mut compositor = Compositor::start(&display);
    let runtime = compositor.runtime.to_string_lossy().into_owned();
    let environment = [
        ("GKS_WSTYPE", "window"),
        ("DISPLAY", ""),
        ("XDG_RUNTIME_DIR", &runtime),
        ("WAYLAND_DISPLAY", Compositor::SOCKET),
    ];
    let steps = ["request:locator:2", "request:string:1", "request:pick:1", "request:string:1"];
    let mut program = Operation::start(program, &folder, &environment, &steps);
    assert_eq!(program.line(), "drawn");
    // 700 x 700 pixels in the middle of 900 x 700.
    let at = |x: u32, y: u32| (100 + x * 7 / 6, y * 7 / 6);
    let (triangle, free) = (at(150, 480), at(330, 200));
    display.shows("wayland-start", |s| is(s, triangle.0, triangle.1, Colour::Green));
    display.points("wayland-locator", free, |s| !is(s, 140, free.1, Colour::White));
    display.act("click 1");
    let line = program.line();
    assert!(is_near(&line, "locator ok", &[5.51, 6.66], 0.02), "{line}");
    display.shows("wayland-string", |s| has(s, [110, 390, 8, 38], Colour::Panel));
    display.act("type ab");
    display.act("key Return");
    assert_eq!(program.line(), "string ok textab");
    display.act(&format!("mousemove {} {}", triangle.0, triangle.1));
    display.shows("wayland-pick", |s| has(s, [165, 385, 629, 638], Colour::Orange));
    display.act("click 1");
    assert_eq!(program.line(), "pick ok 1 11");
    display.shows("wayland-last", |s| has(s, [110, 390, 8, 38], Colour::Panel));
    compositor.process.kill().expect("the compositor ends");
    assert_eq!(program.line(), "string none");
    assert!(program.finish().success());
}
