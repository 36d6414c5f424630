//! Compares the pictures of the legacy programs: with those of the original GKS where they are at hand, and
//! device with device.
//!
//! Arguments: the folder of the runs (`PROGRAM/DEVICE/page.*.png`), the folder of the originals (may be
//! absent), the names of the programs.
//!
//! The measure is [`Likeness`].

use gks_tests::likeness::{Likeness, SIZE, likeness, open, plot_likeness};
use image::RgbImage;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

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

/// Differences from the originals that are known and explained, with the page where they are.
const EXPLAINED: &[(&str, &str)] = &[
    ("pgkex10 1 original", "the characters of the original are of other height and width"),
    ("pgkex13 1 original", "the characters of the original are of other height and width"),
    ("pgkex07 1 original", "the characters of the original are of other height and width, its dots larger"),
    ("fgkgpm 1 original", "the dots of the original are larger"),
    ("pgkex23 1 original", "the original draws hatches with thinner lines, which begin half a spacing away"),
    (
        "sfex01 1 original",
        "Ghostscript paints every point that a line touches, so that lines side by side are black",
    ),
    ("sfex01 1 pdf", "lines side by side that are drawn one by one are antialiased one by one"),
    ("fcell 1 pdf", "the PDF reader smooths small cells"),
    ("pgkex18 1 pdf", "the PDF reader smooths small cells"),
    ("pgkex19 1 hpgl", "a pen draws characters of outline fonts as strokes"),
];

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
