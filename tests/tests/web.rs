//! The web workstation in a browser: Chromium without a screen, told by the DevTools protocol what a person does.

use data_encoding::BASE64;
use gks_tests::operation::{Colour, Operation, SIZE, compiled, difference, has, is, is_near, picture, wait};
use gks_tests::program;
use gks_tests::reader::present;
use image::RgbImage;
use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use tungstenite::{Message, WebSocket};

/// A browser.
struct Browser {
    process: Child,
    socket: WebSocket<TcpStream>,
    calls: u64,
    folder: PathBuf,
}

/// A page in it, by the number of its session.
struct Page {
    session: String,
    target: String,
}

impl Browser {
    fn start(folder: &Path) -> Browser {
        let profile = folder.join("profile");
        fs::create_dir_all(&profile).expect("a folder for the browser");
        let process = Command::new("chromium")
            .args("--headless --no-sandbox --disable-gpu --disable-quic --no-first-run".split(' '))
            .args("--disable-background-networking --disable-component-update --disable-sync".split(' '))
            .args("--hide-scrollbars --force-color-profile=srgb --remote-debugging-port=0".split(' '))
            .arg(format!("--user-data-dir={}", profile.display()))
            .arg("about:blank")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the browser starts");
        let told = profile.join("DevToolsActivePort");
        let (port, path) = wait("the browser", || {
            let text = fs::read_to_string(&told).ok()?;
            let (port, path) = text.split_once('\n')?;
            Some((port.to_owned(), path.trim().to_owned()))
        });
        let stream = TcpStream::connect(format!("127.0.0.1:{port}")).expect("a connection to the browser");
        stream.set_read_timeout(Some(Duration::from_secs(90))).expect("a time limit");
        let (socket, _) =
            tungstenite::client(format!("ws://127.0.0.1:{port}{path}"), stream).expect("a socket");
        Browser { process, socket, calls: 0, folder: folder.to_owned() }
    }

    /// The result of a method.
    fn call(&mut self, page: Option<&Page>, method: &str, parameters: &Value) -> Value {
        self.calls += 1;
        let mut message = json!({"id": self.calls, "method": method, "params": parameters});
        if let Some(page) = page {
            message["sessionId"] = json!(page.session);
        }
        self.socket.send(Message::text(message.to_string())).expect("the browser listens");
        loop {
            let Message::Text(text) = self.socket.read().expect("the browser answers") else { continue };
            let mut answer: Value = serde_json::from_str(&text).expect("an answer");
            if answer["id"] == json!(self.calls) {
                assert!(answer["error"].is_null(), "{method}: {answer}");
                return answer["result"].take();
            }
        }
    }

    /// Opens a page at an address, large enough for the picture.
    fn open(&mut self, address: &str) -> Page {
        let target = self.call(None, "Target.createTarget", &json!({"url": "about:blank"}));
        let target = target["targetId"].as_str().expect("a page").to_owned();
        let session = self.call(None, "Target.attachToTarget", &json!({"targetId": target, "flatten": true}));
        let page = Page { session: session["sessionId"].as_str().expect("a session").to_owned(), target };
        let size = json!({"width": 900, "height": 760, "deviceScaleFactor": 1, "mobile": false});
        self.call(Some(&page), "Emulation.setDeviceMetricsOverride", &size);
        self.call(Some(&page), "Page.navigate", &json!({"url": address}));
        page
    }

    fn close(&mut self, page: &Page) {
        self.call(None, "Target.closeTarget", &json!({"targetId": page.target}));
    }

    /// The value of an expression on a page.
    fn evaluate(&mut self, page: &Page, expression: &str) -> Value {
        let parameters = json!({"expression": expression, "returnByValue": true, "awaitPromise": true});
        self.call(Some(page), "Runtime.evaluate", &parameters)["result"]["value"].take()
    }

    /// Where the picture is on a page, once it is there in its own size.
    fn place(&mut self, page: &Page) -> (f64, f64) {
        let script = "(() => { const c = document.getElementById('picture'); if (!c) return null; \
                      const b = c.getBoundingClientRect(); return [Math.round(b.left), Math.round(b.top), b.width, b.height, c.width]; })()";
        wait("the picture on the page", || {
            let found = self.evaluate(page, script);
            let side = f64::from(SIZE);
            let number = |at: usize| found[at].as_f64().unwrap_or(0.0);
            (number(2) == side && number(3) == side && number(4) == side).then(|| (number(0), number(1)))
        })
    }

    /// What the browser shows where the picture is.
    fn screen(&mut self, page: &Page) -> RgbImage {
        let (x, y) = self.place(page);
        let clip = json!({"x": x, "y": y, "width": SIZE, "height": SIZE, "scale": 1});
        let shot = self.call(Some(page), "Page.captureScreenshot", &json!({"format": "png", "clip": clip}));
        let bytes = BASE64.decode(shot["data"].as_str().expect("an image").as_bytes()).expect("base 64");
        image::load_from_memory(&bytes).expect("an image").to_rgb8()
    }

    /// Waits until the picture on a page is as it should be, and keeps it under a name to be looked at.
    fn shows(&mut self, page: &Page, name: &str, condition: impl Fn(&RgbImage) -> bool) -> RgbImage {
        let file = self.folder.join(format!("{name}.png"));
        wait(name, || {
            let screen = self.screen(page);
            screen.save(&file).expect("a screenshot");
            condition(&screen).then_some(screen)
        })
    }

    /// Keeps a picture of a whole page.
    fn keep(&mut self, page: &Page, name: &str) {
        let shot = self.call(Some(page), "Page.captureScreenshot", &json!({"format": "png"}));
        let bytes = BASE64.decode(shot["data"].as_str().expect("an image").as_bytes()).expect("base 64");
        fs::write(self.folder.join(format!("{name}.png")), bytes).expect("a screenshot");
    }

    /// Moves, presses or releases at a pixel of the picture.
    fn pointer(&mut self, page: &Page, act: &str, button: &str, x: f64, y: f64) {
        let (left, top) = self.place(page);
        let held = if act == "mouseMoved" && button == "left" { 1 } else { 0 };
        let parameters = json!({
            "type": act, "x": left + x, "y": top + y, "button": button, "clickCount": 1, "buttons": held,
        });
        self.call(Some(page), "Input.dispatchMouseEvent", &parameters);
    }

    fn moved(&mut self, page: &Page, x: f64, y: f64) {
        self.pointer(page, "mouseMoved", "none", x, y);
    }

    fn click(&mut self, page: &Page, x: f64, y: f64) {
        self.moved(page, x, y);
        self.pointer(page, "mousePressed", "left", x, y);
        self.pointer(page, "mouseReleased", "left", x, y);
    }

    fn key(&mut self, page: &Page, key: &str) {
        let text = if key.chars().count() == 1 { key } else { "" };
        let down = json!({"type": "keyDown", "key": key, "text": text});
        self.call(Some(page), "Input.dispatchKeyEvent", &down);
        self.call(Some(page), "Input.dispatchKeyEvent", &json!({"type": "keyUp", "key": key}));
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The program with steps and a browser; none where something is missing.
fn started(name: &str, options: &str, steps: &[&str]) -> Option<(Browser, Operation, String, PathBuf)> {
    if !present(name, &["chromium"]) {
        return None;
    }
    let program = compiled(env!("CARGO_TARGET_TMPDIR"))?;
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "web", name);
    let options = format!("size={SIZE}x{SIZE}{options}");
    let environment = [("GKS_WSTYPE", "web"), ("GKS_OPTIONS", &options)];
    let mut operation = Operation::start(program, &folder, &environment, steps);
    let mut said = String::new();
    let errors = operation.child.stderr.take().expect("its standard error");
    BufReader::new(errors).read_line(&mut said).expect("the address");
    let address = said.trim_end().strip_prefix("gks: the picture is at ").expect("the address").to_owned();
    assert_eq!(operation.line(), "drawn");
    Some((Browser::start(&folder), operation, address, folder))
}

#[test]
fn the_browser_shows_the_picture_of_the_program_to_the_last_pixel() {
    let Some((mut browser, mut operation, address, folder)) = started("picture", "&keep=1", &[]) else {
        return;
    };
    let program = compiled(env!("CARGO_TARGET_TMPDIR")).expect("the program");
    let expected = picture(program, &folder);
    let page = browser.open(&address);
    browser.shows(&page, "picture", |screen| difference(screen, &expected) == (0.0, 0));
    browser.keep(&page, "page");
    browser.close(&page);
    let status = wait("the end of the program", || operation.child.try_wait().ok().flatten());
    assert!(status.success());
}

#[test]
fn each_kind_of_input_comes_back_from_the_browser() {
    let steps = [
        "request:locator:2",
        "request:stroke:4",
        "request:valuator:1",
        "request:choice:3",
        "request:pick:3",
        "request:string:1",
        "request:locator:1",
        "sample:locator:3",
        "event:choice:5",
    ];
    let Some((mut browser, mut program, address, _)) = started("input", "", &steps) else { return };
    let page = browser.open(&address);
    browser.moved(&page, 300.0, 150.0);
    browser.shows(&page, "locator", |s| is(s, 50, 150, Colour::Dark) && is(s, 150, 480, Colour::Green));
    browser.click(&page, 300.0, 150.0);
    let line = program.line();
    assert!(is_near(&line, "locator ok", &[5.01, 7.49], 0.02), "{line}");

    // The cross is at the pointer, where the click was.
    browser.shows(&page, "stroke-start", |s| is(s, 306, 150, Colour::Dark) && is(s, 50, 150, Colour::White));
    browser.pointer(&page, "mouseMoved", "none", 60.0, 340.0);
    browser.pointer(&page, "mousePressed", "left", 60.0, 340.0);
    browser.pointer(&page, "mouseMoved", "left", 120.0, 280.0);
    browser.pointer(&page, "mouseReleased", "left", 120.0, 280.0);
    browser.shows(&page, "stroke", |s| has(s, [88, 92, 308, 312], Colour::Accent));
    browser.key(&page, "Enter");
    let line = program.line();
    assert!(is_near(&line, "stroke ok", &[1.01, 4.32, 2.01, 5.32], 0.02), "{line}");

    browser.shows(&page, "valuator", |s| has(s, [18, 50, 580, 585], Colour::Accent));
    browser.pointer(&page, "mouseMoved", "none", 60.0, 582.0);
    browser.pointer(&page, "mousePressed", "left", 60.0, 582.0);
    browser.pointer(&page, "mouseMoved", "left", 125.0, 582.0);
    browser.pointer(&page, "mouseReleased", "left", 125.0, 582.0);
    let line = program.line();
    assert!(is_near(&line, "valuator ok", &[50.3], 0.5), "{line}");

    browser.shows(&page, "choice", |s| has(s, [500, 595, 5, 90], Colour::Panel));
    browser.click(&page, 548.0, 39.0);
    assert_eq!(program.line(), "choice ok 2");

    browser.moved(&page, 150.0, 480.0);
    browser.shows(&page, "pick", |s| {
        has(s, [55, 245, 539, 545], Colour::Orange) && has(s, [415, 421, 130, 140], Colour::Orange)
    });
    browser.click(&page, 150.0, 480.0);
    assert_eq!(program.line(), "pick ok 1 11");

    browser.shows(&page, "string", |s| has(s, [5, 250, 5, 35], Colour::Panel));
    for key in [" ", "\u{e4}", "x", "Backspace", "!", "Enter"] {
        browser.key(&page, key);
    }
    assert_eq!(program.line(), "string ok text \u{e4}!");

    browser.shows(&page, "break", |s| is(s, 130, 240, Colour::Dark));
    browser.key(&page, "Escape");
    assert_eq!(program.line(), "locator none");

    browser.shows(&page, "sample", |s| is(s, 127, 240, Colour::Dark));
    browser.moved(&page, 300.0, 150.0);
    let line = program.line();
    assert!(is_near(&line, "locator ok", &[5.01, 7.49], 0.02), "{line}");

    browser.shows(&page, "event", |s| is(s, 528, 120, Colour::Red));
    browser.click(&page, 528.0, 120.0);
    assert_eq!(program.line(), "choice ok 2");
    assert!(program.finish().success());
    wait("the page to say that it is over", || {
        (browser.evaluate(&page, "document.getElementById('state').textContent") == "ended").then_some(())
    });
}

#[test]
fn two_watch_one_steers_and_who_lacks_the_secret_sees_nothing() {
    let steps = ["request:choice:3", "request:choice:3", "request:string:1"];
    let Some((mut browser, mut program, address, _)) = started("viewers", "", &steps) else { return };
    let (host, secret) =
        address.strip_prefix("http://").and_then(|rest| rest.split_once('/')).expect("an address");

    let stranger = browser.open(&format!("http://{host}/"));
    let text = "document.body ? document.body.innerText : ''";
    wait("the refusal", || {
        let said = browser.evaluate(&stranger, text);
        said.as_str().is_some_and(|said| said.contains("lacks the secret")).then_some(())
    });
    assert_eq!(browser.evaluate(&stranger, "document.querySelector('canvas') === null"), true);
    let other = secret.replace(|c: char| c.is_ascii_digit(), "f");
    for path in ["socket", &format!("{other}socket")] {
        let attempt = format!(
            "new Promise((done) => {{ const s = new WebSocket('ws://{host}/{path}'); \
             s.onopen = () => done('open'); s.onerror = () => done('refused'); }})"
        );
        assert_eq!(browser.evaluate(&stranger, &attempt), "refused");
    }
    let mut stream = TcpStream::connect(host).expect("a connection");
    write!(stream, "GET /{other} HTTP/1.1\r\nHost: {host}\r\n\r\n").expect("a request");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("an answer");
    assert!(answer.starts_with("HTTP/1.1 403 "), "{answer}");

    let state = "document.getElementById('state')?.dataset.state ?? ''";
    let first = browser.open(&address);
    wait("the first to steer", || (browser.evaluate(&first, state) == "steering").then_some(()));
    let second = browser.open(&address);
    wait("the second to watch", || (browser.evaluate(&second, state) == "watching").then_some(()));
    for (page, name) in [(&first, "first"), (&second, "second")] {
        browser.shows(page, name, |s| {
            is(s, 150, 480, Colour::Green) && has(s, [500, 595, 5, 90], Colour::Panel)
        });
    }
    browser.keep(&second, "watching");
    // What the second does counts only after it has taken over.
    browser.click(&second, 548.0, 20.0);
    browser.click(&first, 548.0, 39.0);
    assert_eq!(program.line(), "choice ok 2");
    browser.evaluate(&second, "document.getElementById('take').click()");
    wait("the second to steer", || (browser.evaluate(&second, state) == "steering").then_some(()));
    wait("the first to watch", || (browser.evaluate(&first, state) == "watching").then_some(()));
    browser.click(&first, 548.0, 20.0);
    browser.click(&second, 548.0, 59.0);
    assert_eq!(program.line(), "choice ok 3");
    // When everybody has left, the program goes on alone.
    browser.close(&first);
    browser.close(&second);
    assert_eq!(program.line(), "string none");
    assert!(program.finish().success());
}
