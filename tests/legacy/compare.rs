//! Compares the pictures of the legacy programs: with those of the original GKS where they are at hand, and
//! device with device.
//!
//! Arguments: the folder of the runs (`PROGRAM/DEVICE/page.*.png`), the folder of the originals (may be
//! absent), the names of the programs.
//!
//! The measure is [`Likeness`]: strays judge position and presence, tone judges colours and weight. Two border
//! pixels are ignored, for the originals were cut out of a page.

use image::{GrayImage, Luma, RgbImage};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// How alike two pictures are.
#[derive(Copy, Clone, Debug)]
struct Likeness {
    /// The share of the contours of either picture (for plots: of the ink) that has none of the other within
    /// [`NEAR`] pixels.
    stray: f64,
    /// The root mean square difference of colour after a blur over [`BLUR`] pixels, from 0 to 255.
    tone: f64,
}

/// What pictures of the same program must keep to.
struct Limits {
    stray: f64,
    tone: f64,
}

/// Devices of ours among themselves: same fonts, same widths.
const SAME: Limits = Limits { stray: 0.02, tone: 10.0 };
/// Ours and the original: other outlines of characters, other linewidths.
const ORIGINAL: Limits = Limits { stray: 0.03, tone: 15.0 };
/// A pen plot and our picture of it: where there is ink, not of what colour.
const PLOT: Limits = Limits { stray: 0.04, tone: 255.0 };

const NEAR: u32 = 3;
const BLUR: f32 = 4.0;
/// How much neighbouring pixels must differ, summed over the components, to be on either side of a contour.
const CONTOUR: i32 = 60;
/// How far a pixel must be from the paper to count as ink, summed over the components: strong ink must be in
/// the other picture too, where even weak ink answers for it.
const STRONG: i32 = 150;
const WEAK: i32 = 12;

/// Differences from the originals that are known and explained, with the page where they are.
const EXPLAINED: &[(&str, &str)] = &[
    ("pgkex10 1 original", "the characters of the original are of other height and width"),
    ("pgkex13 1 original", "the characters of the original are of other height and width"),
    ("pgkex07 1 original", "the characters of the original are of other height and width, its dots larger"),
    ("fgkgpm 1 original", "the dots of the original are larger"),
    ("sfex01 1 original", "lines side by side that are drawn one by one are antialiased one by one"),
    ("sfex01 1 svg", "lines side by side that are drawn one by one are antialiased one by one"),
    ("sfex01 1 pdf", "lines side by side that are drawn one by one are antialiased one by one"),
    ("sfex01 1 ps", "lines side by side that are drawn one by one are antialiased one by one"),
    ("fcell 1 pdf", "the PDF reader smooths small cells"),
    ("pgkex18 1 pdf", "the PDF reader smooths small cells"),
    ("pgkex19 1 hpgl", "a pen draws characters of outline fonts as strokes"),
];

/// The size in which pictures are compared.
const SIZE: u32 = 800;

fn open(path: &Path) -> Option<RgbImage> {
    let picture = image::open(path).ok()?.to_rgb8();
    if picture.dimensions() == (SIZE, SIZE) {
        return Some(picture);
    }
    // The mean of the pixels that fall into one: pictures of vector devices come four times as large.
    Some(image::imageops::thumbnail(&picture, SIZE, SIZE))
}

fn difference(a: [u8; 3], b: [u8; 3]) -> i32 {
    (0..3).map(|i| (i32::from(a[i]) - i32::from(b[i])).abs()).sum()
}

fn inside(x: u32, y: u32) -> bool {
    x >= 2 && y >= 2 && x < SIZE - 3 && y < SIZE - 3
}

/// The pixels that differ from the one to the right or below.
fn contours(picture: &RgbImage) -> GrayImage {
    GrayImage::from_fn(SIZE, SIZE, |x, y| {
        let edge = inside(x, y) && {
            let here = picture.get_pixel(x, y).0;
            let beside = [picture.get_pixel(x + 1, y).0, picture.get_pixel(x, y + 1).0];
            beside.iter().any(|&other| difference(here, other) > CONTOUR)
        };
        Luma([if edge { 255 } else { 0 }])
    })
}

/// The paper: white or black, whichever is more frequent along the border.
fn paper(picture: &RgbImage) -> [u8; 3] {
    let border = picture.enumerate_pixels().filter(|(x, y, _)| x.min(y) < &8 || *x.max(y) >= SIZE - 8);
    let black = border.fold(0i32, |sum, (_, _, p)| match p.0 {
        [0, 0, 0] => sum + 1,
        [255, 255, 255] => sum - 1,
        _ => sum,
    });
    if black > 0 { [0; 3] } else { [255; 3] }
}

/// The pixels that differ from the paper by more than `least`.
fn ink(picture: &RgbImage, paper: [u8; 3], least: i32) -> GrayImage {
    GrayImage::from_fn(SIZE, SIZE, |x, y| {
        let far = inside(x, y) && difference(picture.get_pixel(x, y).0, paper) > least;
        Luma([if far { 255 } else { 0 }])
    })
}

/// Ink grown by `NEAR` pixels.
fn grown(ink: &GrayImage) -> GrayImage {
    let reach = i64::from(NEAR);
    let mut rows = GrayImage::new(SIZE, SIZE);
    for (x, y, p) in ink.enumerate_pixels() {
        if p.0[0] > 0 {
            for k in (i64::from(x) - reach).max(0)..=(i64::from(x) + reach).min(i64::from(SIZE) - 1) {
                rows.put_pixel(k as u32, y, Luma([255]));
            }
        }
    }
    let mut both = GrayImage::new(SIZE, SIZE);
    for (x, y, p) in rows.enumerate_pixels() {
        if p.0[0] > 0 {
            for k in (i64::from(y) - reach).max(0)..=(i64::from(y) + reach).min(i64::from(SIZE) - 1) {
                both.put_pixel(x, k as u32, Luma([255]));
            }
        }
    }
    both
}

fn stray(a: &GrayImage, b: &GrayImage) -> f64 {
    let near = grown(b);
    let (mut all, mut alone) = (0u32, 0u32);
    for (p, q) in a.pixels().zip(near.pixels()) {
        if p.0[0] > 0 {
            all += 1;
            alone += u32::from(q.0[0] == 0);
        }
    }
    if all == 0 { 0.0 } else { f64::from(alone) / f64::from(all) }
}

fn likeness(a: &RgbImage, b: &RgbImage) -> Likeness {
    let (contours_a, contours_b) = (contours(a), contours(b));
    let stray = stray(&contours_a, &contours_b).max(stray(&contours_b, &contours_a));
    Likeness { stray, tone: tone(a, b) }
}

/// How alike a picture of ours and a pen plot on white paper are, background left out.
fn plot_likeness(ours: &RgbImage, plot: &RgbImage) -> Likeness {
    let paper = paper(ours);
    let white = [255; 3];
    let there = stray(&ink(ours, paper, STRONG), &ink(plot, white, WEAK));
    let back = stray(&ink(plot, white, STRONG), &ink(ours, paper, WEAK));
    Likeness { stray: there.max(back), tone: 0.0 }
}

fn tone(a: &RgbImage, b: &RgbImage) -> f64 {
    let blurred = |p: &RgbImage| image::imageops::fast_blur(p, BLUR);
    let (a, b) = (blurred(a), blurred(b));
    let mut sum = 0.0;
    let mut count = 0u32;
    for (x, y, p) in a.enumerate_pixels().filter(|(x, y, _)| inside(*x, *y)) {
        let q = b.get_pixel(x, y);
        sum += (0..3).map(|i| (f64::from(p.0[i]) - f64::from(q.0[i])).powi(2)).sum::<f64>();
        count += 3;
    }
    (sum / f64::from(count.max(1))).sqrt()
}

/// The picture moved to the right, to show that the measure notices.
fn moved(picture: &RgbImage, by: u32) -> RgbImage {
    RgbImage::from_fn(SIZE, SIZE, |x, y| *picture.get_pixel(x.saturating_sub(by), y))
}

fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut pages: Vec<PathBuf> = std::fs::read_dir(folder)
        .map(|entries| entries.flatten().map(|e| e.path()).collect())
        .unwrap_or_default();
    pages.retain(|p| p.extension().is_some_and(|e| e == "png"));
    pages.sort_by_key(|p| page_number(p));
    pages
}

/// The number in `page.N.png` or `page-N.png`.
fn page_number(path: &Path) -> u32 {
    let name = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    name.rsplit(['.', '-']).next().and_then(|n| n.parse().ok()).unwrap_or(0)
}

struct Report {
    text: String,
    passed: u32,
    failed: u32,
}

impl Report {
    fn judge(&mut self, what: &str, likeness: Likeness, limits: &Limits) {
        let good = likeness.stray <= limits.stray && likeness.tone <= limits.tone;
        let explained = EXPLAINED.iter().find(|(name, _)| *name == what);
        let verdict = match (good, explained) {
            (true, _) => "ok".to_owned(),
            (false, Some((_, why))) => format!("explained: {why}"),
            (false, None) => "DIFFERS".to_owned(),
        };
        self.count(good || explained.is_some());
        let Likeness { stray, tone } = likeness;
        let _ = writeln!(self.text, "{what:<34} stray {:>6.2} %  tone {tone:>6.1}  {verdict}", stray * 100.0);
    }

    fn count(&mut self, good: bool) {
        if good {
            self.passed += 1;
        } else {
            self.failed += 1;
        }
    }

    fn missing(&mut self, what: &str) {
        self.count(false);
        let _ = writeln!(self.text, "{what:<34} MISSING");
    }
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let (Some(runs), Some(originals)) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: legacy RUNS ORIGINALS PROGRAM...");
        return ExitCode::FAILURE;
    };
    let (runs, originals) = (PathBuf::from(runs), PathBuf::from(originals));
    let mut report = Report { text: String::new(), passed: 0, failed: 0 };
    if !originals.is_dir() {
        println!("SKIP: the pictures of the original are not at hand; devices are compared with one another");
    }
    for name in arguments {
        let program = name.rsplit('/').next().unwrap_or(&name);
        let prefix = if name.starts_with("tutorial") { "tut" } else { "ex" };
        let raster = pages(&runs.join(program).join("png"));
        if raster.is_empty() {
            report.missing(&format!("{program} png"));
        }
        for (i, path) in raster.iter().enumerate() {
            let Some(ours) = open(path) else {
                report.missing(&format!("{program} png {}", i + 1));
                continue;
            };
            let page = i + 1;
            if let Some(original) = open(&originals.join(format!("{prefix}.{program}.{page}.png"))) {
                report.judge(&format!("{program} {page} original"), likeness(&ours, &original), &ORIGINAL);
                let wrong = likeness(&moved(&ours, 6), &original);
                if page == 1 && wrong.stray <= ORIGINAL.stray && wrong.tone <= ORIGINAL.tone {
                    report.missing(&format!(
                        "{program}: a shift of 6 pixels goes unnoticed; the measure is too lax"
                    ));
                }
            }
            for (device, limits) in [("svg", SAME), ("pdf", SAME), ("ps", SAME), ("hpgl", PLOT)] {
                let what = format!("{program} {page} {device}");
                let others = pages(&runs.join(program).join(device));
                match others.get(i).and_then(|p| open(p)) {
                    Some(other) if device == "hpgl" => {
                        report.judge(&what, plot_likeness(&ours, &other), &limits);
                    }
                    Some(other) => report.judge(&what, likeness(&ours, &other), &limits),
                    None => report.missing(&what),
                }
            }
        }
    }
    print!("{}", report.text);
    println!("\n{} passed, {} failed", report.passed, report.failed);
    if report.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
