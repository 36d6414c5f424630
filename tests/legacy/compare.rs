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
    /// The share of the ink of either picture that has no ink of the other within [`NEAR`] pixels.
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
const SAME: Limits = Limits { stray: 0.005, tone: 6.0 };
/// Ours and the original: other fonts, other linewidths.
const ORIGINAL: Limits = Limits { stray: 0.03, tone: 14.0 };
/// A pen plot and our picture of it: lines only.
const PLOT: Limits = Limits { stray: 0.05, tone: 255.0 };

const NEAR: u32 = 3;
const BLUR: f32 = 4.0;
/// How far a pixel must be from the background to count as ink, summed over the components.
const INK: i32 = 150;

/// Differences from the originals that are known and explained, with the page where they are.
const EXPLAINED: &[(&str, &str)] = &[];

fn open(path: &Path) -> Option<RgbImage> {
    let picture = image::open(path).ok()?.to_rgb8();
    let (w, h) = picture.dimensions();
    if (w, h) == (800, 800) {
        return Some(picture);
    }
    Some(image::imageops::resize(&picture, 800, 800, image::imageops::FilterType::Triangle))
}

/// The colour of most pixels on the border, where the paper is.
fn paper(picture: &RgbImage) -> [u8; 3] {
    let mut counts = std::collections::HashMap::new();
    for (x, y, pixel) in picture.enumerate_pixels() {
        if x.min(y) < 8 || x.max(y) >= 792 {
            *counts.entry(pixel.0).or_insert(0) += 1;
        }
    }
    counts.into_iter().max_by_key(|(_, n)| *n).map_or([255; 3], |(c, _)| c)
}

fn ink(picture: &RgbImage) -> GrayImage {
    let paper = paper(picture);
    GrayImage::from_fn(800, 800, |x, y| {
        let pixel = picture.get_pixel(x, y).0;
        let far: i32 = (0..3).map(|i| (i32::from(pixel[i]) - i32::from(paper[i])).abs()).sum();
        let inside = x >= 2 && y >= 2 && x < 798 && y < 798;
        Luma([if inside && far > INK { 255 } else { 0 }])
    })
}

/// Ink grown by `NEAR` pixels.
fn grown(ink: &GrayImage) -> GrayImage {
    let reach = NEAR as i64;
    let mut rows = GrayImage::new(800, 800);
    for (x, y, p) in ink.enumerate_pixels() {
        if p.0[0] > 0 {
            for k in (i64::from(x) - reach).max(0)..=(i64::from(x) + reach).min(799) {
                rows.put_pixel(k as u32, y, Luma([255]));
            }
        }
    }
    let mut both = GrayImage::new(800, 800);
    for (x, y, p) in rows.enumerate_pixels() {
        if p.0[0] > 0 {
            for k in (i64::from(y) - reach).max(0)..=(i64::from(y) + reach).min(799) {
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
    let (ink_a, ink_b) = (ink(a), ink(b));
    let stray = stray(&ink_a, &ink_b).max(stray(&ink_b, &ink_a));
    let blurred = |p: &RgbImage| image::imageops::fast_blur(p, BLUR);
    let (a, b) = (blurred(a), blurred(b));
    let mut sum = 0.0;
    let mut count = 0u32;
    for (x, y, p) in a.enumerate_pixels() {
        if x >= 2 && y >= 2 && x < 798 && y < 798 {
            let q = b.get_pixel(x, y);
            sum += (0..3).map(|i| (f64::from(p.0[i]) - f64::from(q.0[i])).powi(2)).sum::<f64>();
            count += 3;
        }
    }
    Likeness { stray, tone: (sum / f64::from(count.max(1))).sqrt() }
}

/// The picture moved to the right, to show that the measure notices.
fn moved(picture: &RgbImage, by: u32) -> RgbImage {
    RgbImage::from_fn(800, 800, |x, y| *picture.get_pixel(x.saturating_sub(by), y))
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
                    report.missing(&format!("{program}: a shift of 6 pixels goes unnoticed; the measure is too lax"));
                }
            }
            for (device, limits) in [("svg", SAME), ("pdf", SAME), ("ps", SAME), ("hpgl", PLOT)] {
                let what = format!("{program} {page} {device}");
                let others = pages(&runs.join(program).join(device));
                match others.get(i).and_then(|p| open(p)) {
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
