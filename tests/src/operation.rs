//! The program `programs/c/operate.c`, which somebody operates: a person, or a test that does what a person does.

use crate::program::{self, Linking, built, has_compiler, repository};
use image::RgbImage;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::OnceLock;
use std::thread;
use std::time::{Duration, Instant};

/// How long a test waits for what must happen, on a machine that has other things to do, too.
pub const PATIENCE: Duration = Duration::from_secs(90);

/// Number of columns and rows of the picture.
pub const SIZE: u32 = 600;

/// Waits until there is something, or says what is missing.
///
/// # Panics
/// Where it does not come.
pub fn wait<T>(what: &str, mut attempt: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(found) = attempt() {
            return found;
        }
        assert!(start.elapsed() < PATIENCE, "waited in vain for {what}");
        thread::sleep(Duration::from_millis(30));
    }
}

/// The program, compiled once, and the command that shows windows; none where there is no compiler.
pub fn compiled(temporary: &str) -> Option<&'static Path> {
    static PROGRAM: OnceLock<Option<PathBuf>> = OnceLock::new();
    let program = PROGRAM.get_or_init(|| {
        if !has_compiler("gcc") {
            return None;
        }
        built("gks-cli", "gks");
        // Tests of several programs run at a time.
        let program = program::folder(temporary, "operate", &std::process::id().to_string()).join("operate");
        let mut compiler = Command::new("gcc");
        compiler.args(["-std=gnu99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O1"]);
        compiler.arg("-I").arg(repository().join("bindings/c/include")).arg("-o").arg(&program);
        compiler.arg(repository().join("tests/programs/c/operate.c"));
        program::compile(&mut compiler, Linking::Shared);
        Some(program)
    });
    program.as_deref()
}

/// The program at work.
pub struct Operation {
    /// The process.
    pub child: Child,
    /// What it has said.
    pub results: Results,
}

/// What the program has said so far.
pub struct Results {
    file: PathBuf,
    /// How many lines have been seen.
    seen: usize,
}

impl Results {
    /// The results of a program that writes them to a file.
    pub fn new(file: PathBuf) -> Results {
        Results { file, seen: 0 }
    }

    /// The next line of the results, if it is there.
    pub fn arrived(&mut self) -> Option<String> {
        let text = fs::read_to_string(&self.file).ok()?;
        let line = text.split_inclusive('\n').nth(self.seen)?.strip_suffix('\n')?.to_owned();
        self.seen += 1;
        Some(line)
    }

    /// The next line of the results.
    pub fn line(&mut self) -> String {
        wait(&format!("line {} of {}", self.seen + 1, self.file.display()), || self.arrived())
    }
}

impl Operation {
    /// Starts the program with steps, in a folder and with what the environment says to GKS.
    ///
    /// # Panics
    /// Where it cannot be started.
    pub fn start(program: &Path, folder: &Path, environment: &[(&str, &str)], steps: &[&str]) -> Operation {
        let file = folder.join("results");
        let mut command = Command::new(program);
        for (name, _) in env::vars().filter(|(name, _)| name.starts_with("GKS_")) {
            command.env_remove(name);
        }
        let child = command
            .arg(&file)
            .args(steps)
            .env("GKS_OPTIONS", format!("size={SIZE}x{SIZE}"))
            .envs(environment.iter().copied())
            .current_dir(folder)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        Operation { child, results: Results::new(file) }
    }

    /// The next line of the results.
    pub fn line(&mut self) -> String {
        self.results.line()
    }

    /// The processes that the program has started.
    pub fn children(&self) -> Vec<u32> {
        let id = self.child.id();
        let text = fs::read_to_string(format!("/proc/{id}/task/{id}/children")).unwrap_or_default();
        text.split_whitespace().filter_map(|number| number.parse().ok()).collect()
    }

    /// Waits for the end of the program, after its last word.
    pub fn finish(mut self) -> ExitStatus {
        assert_eq!(self.line(), "closed");
        wait("the end of the program", || self.child.try_wait().ok().flatten())
    }
}

impl Drop for Operation {
    fn drop(&mut self) {
        // It may have ended.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The picture of the program as the driver for PNG draws it.
pub fn picture(program: &Path, folder: &Path) -> RgbImage {
    let folder = folder.join("png");
    fs::create_dir_all(&folder).expect("a folder for the picture");
    let mut operation = Operation::start(program, &folder, &[("GKS_WSTYPE", "png")], &[]);
    assert_eq!(operation.line(), "drawn");
    assert!(operation.finish().success());
    image::open(folder.join("gks.png")).expect("the picture").to_rgb8()
}

/// The numbers in a result.
pub fn numbers(line: &str) -> Vec<f64> {
    line.split(' ').filter_map(|word| word.parse().ok()).collect()
}

/// Whether a result has some words and then numbers that lie within `reach` of others.
pub fn is_near(line: &str, words: &str, expected: &[f64], reach: f64) -> bool {
    let found = numbers(line);
    line.starts_with(words)
        && found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= reach)
}

/// The mean difference of the components of two pictures of one size, and the greatest one.
pub fn difference(a: &RgbImage, b: &RgbImage) -> (f64, u8) {
    assert_eq!(a.dimensions(), b.dimensions());
    let by = |(a, b): (&u8, &u8)| a.abs_diff(*b);
    let sum: u64 = a.as_raw().iter().zip(b.as_raw()).map(|pair| u64::from(by(pair))).sum();
    let most = a.as_raw().iter().zip(b.as_raw()).map(by).max().unwrap_or(0);
    (sum as f64 / a.as_raw().len().max(1) as f64, most)
}

/// A colour that a picture is looked at for.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Of lines over the picture.
    Dark,
    /// Of the background.
    White,
    /// Of what the operator moves.
    Accent,
    /// Of highlighting.
    Orange,
    /// Of panels.
    Panel,
    /// Colour index 2.
    Red,
    /// Colour index 3.
    Green,
    /// Colour index 4.
    Blue,
}

/// Whether a pixel has a colour, or nearly.
pub fn is(picture: &RgbImage, x: u32, y: u32, colour: Colour) -> bool {
    let expected: [u8; 3] = match colour {
        Colour::Dark => [16, 20, 28],
        Colour::White => [255, 255, 255],
        Colour::Accent => [77, 163, 255],
        Colour::Orange => [255, 128, 0],
        Colour::Panel => [27, 30, 38],
        Colour::Red => [255, 0, 0],
        Colour::Green => [0, 255, 0],
        Colour::Blue => [0, 0, 255],
    };
    // Lines over the picture are darker than panels, but not by much.
    let reach = if colour == Colour::Panel { 5 } else { 24 };
    let found = picture.get_pixel(x, y).0;
    found.iter().zip(expected).all(|(&a, b)| a.abs_diff(b) <= reach)
}

/// Whether a rectangle, given as left, right, upper and lower edge, has a pixel of a colour.
pub fn has(picture: &RgbImage, [left, right, upper, lower]: [u32; 4], colour: Colour) -> bool {
    (upper..lower).any(|y| (left..right).any(|x| is(picture, x, y, colour)))
}
