//! PDF documents.

use crate::card::{self, card, draw, lines, near, page, paint, pen, pixel, place, translucent};
use crate::programs::{TXTWRITE, directory, ghostscript, poppler, run};
use crate::receiver::Receiver;
use gks_geometry::Paths;
use gks_pipeline::colour::Colour;
use gks_pipeline::device::*;
use gks_workstations::options::Options;
use gks_workstations::pdf::Pdf;
use glam::DVec2;
use std::path::{Path, PathBuf};

/// Draws one document page by page.
fn document(options: &Options, pages: u32, mut draw: impl FnMut(u32, &mut Pdf)) -> Vec<u8> {
    let receiver = Receiver::default();
    let mut pdf = Pdf::new(receiver.sink(), options);
    for number in 1..=pages {
        pdf.begin(&page(number)).unwrap();
        draw(number, &mut pdf);
        pdf.end().unwrap();
    }
    pdf.close().unwrap();
    receiver.document()
}

/// Writes a document to a file for other programs.
fn saved(test: &str, document: &[u8]) -> PathBuf {
    let path = directory("pdf").join(test);
    std::fs::write(&path, document).unwrap();
    path
}

/// Lets qpdf check a document.
fn check(path: &Path) {
    let report = run("qpdf", &["--check", path.to_str().unwrap()]);
    assert!(report.is_none_or(|text| text.contains("No syntax or stream encoding errors")));
}

/// Every entry of the cross-reference table must lead to its object.
fn check_table(document: &[u8]) {
    let text: String = document.iter().map(|byte| char::from(byte & 0x7f)).collect();
    let (_, end) = text.rsplit_once("startxref\n").unwrap();
    let start: usize = end.lines().next().unwrap().parse().unwrap();
    let mut lines = text[start..].lines();
    assert_eq!(lines.next(), Some("xref"));
    let count: usize = lines.next().unwrap().strip_prefix("0 ").unwrap().parse().unwrap();
    assert_eq!(lines.next(), Some("0000000000 65535 f"));
    for number in 1..count {
        let entry = lines.next().unwrap();
        let (offset, rest) = entry.split_once(' ').unwrap();
        assert_eq!(rest, "00000 n", "object {number} is not in the file");
        let offset: usize = offset.parse().unwrap();
        assert!(text[offset..].starts_with(&format!("{number} 0 obj")), "object {number}");
    }
    assert!(lines.next().unwrap().starts_with("trailer"));
}

#[test]
fn all_forms() {
    let document = document(&Options::default(), 1, |_, pdf| card(pdf));
    check_table(&document);
    let path = saved("card.pdf", &document);
    check(&path);
    for picture in [poppler(&path), ghostscript(&path)].into_iter().flatten() {
        card::probe(&picture);
    }
}

#[test]
fn pages_of_one_document() {
    let options =
        Options { landscape: Some(true), background: Some(Colour::rgb(1.0, 1.0, 0.5)), ..Options::default() };
    let document = document(&options, 3, |number, pdf| {
        if number != 2 {
            lines(pdf, &[(0.0, 0.0), (100.0, 100.0)], pen(f64::from(number)));
        }
    });
    check_table(&document);
    let path = saved("pages.pdf", &document);
    check(&path);
    if let Some(text) = run("pdfinfo", &[path.to_str().unwrap()]) {
        let has = |line: &[&str]| text.lines().any(|l| l.split_whitespace().eq(line.iter().copied()));
        assert!(has(&["Pages:", "3"]), "{text}");
        assert!(has(&["Producer:", "GKS"]), "{text}");
        assert!(has(&["Page", "size:", "841.89", "x", "595.28", "pts", "(A4)"]), "{text}");
    }
}

#[test]
fn text_is_text() {
    let document = document(&Options::default(), 2, |_, pdf| card::texts(pdf));
    check_table(&document);
    let path = saved("text.pdf", &document);
    check(&path);
    let path_text = path.to_str().unwrap();
    let readers =
        [("pdftotext", vec!["-raw", path_text, "-"]), ("gs", [&TXTWRITE[..], &[path_text]].concat())];
    for (program, arguments) in readers {
        if let Some(text) = run(program, &arguments) {
            // How readers guess blanks from gaps is their own affair.
            let squeezed = |text: &str| text.split_whitespace().collect::<String>();
            for line in card::LINES {
                assert_eq!(squeezed(&text).matches(&squeezed(line)).count(), 2, "{program}, {line}: {text}");
            }
        }
    }
    if let Some(text) = run("pdffonts", &[path.to_str().unwrap()]) {
        let fonts: Vec<&str> = text.lines().filter(|line| line.contains("CID TrueType")).collect();
        assert_eq!(fonts.len(), 3, "{text}");
        assert!(
            fonts.iter().all(|font| font.contains("yes yes yes")),
            "not embedded or without Unicode: {text}"
        );
    }
    for picture in [poppler(&path), ghostscript(&path)].into_iter().flatten() {
        card::probe_text(&picture);
    }
    assert!(document.len() < 60_000, "{} bytes", document.len());
}

#[test]
fn same_marks_give_the_same_bytes() {
    let draw = || {
        document(&Options::default(), 2, |_, pdf| {
            card(pdf);
            card::texts(pdf);
        })
    };
    assert!(draw() == draw());
}

#[test]
fn translucent_marks_and_cells() {
    let document = document(&Options::default(), 1, |_, pdf| {
        let half = translucent(paint(1.0, 0.0, 0.0), 0.5);
        lines(pdf, &[(100.0, 0.0), (100.0, 800.0)], Pen { paint: half, ..pen(40.0) });
        let cells = [half, paint(0.0, 0.0, 1.0), translucent(half, 0.0), translucent(half, 0.25)];
        let grid = Grid { paints: &cells, columns: 2, rows: 2 };
        draw(pdf, Form::Cells(place((200.0, 400.0), (200.0, 0.0), (0.0, -200.0)), grid));
    });
    let path = saved("translucent.pdf", &document);
    check(&path);
    if let Some(picture) = poppler(&path) {
        let cases = [
            ((100, 400), [255, 127, 127]),
            ((250, 350), [255, 127, 127]),
            ((350, 350), [0, 0, 255]),
            ((250, 250), [255, 255, 255]),
            ((350, 250), [255, 191, 191]),
        ];
        for ((x, y), colour) in cases {
            assert!(near(pixel(&picture, x, y), colour), "at {x}, {y}: {:?}", pixel(&picture, x, y));
        }
    }
}

#[test]
fn memory_does_not_grow_with_the_number_of_marks() {
    let receiver = Receiver::default();
    let mut pdf = Pdf::new(receiver.sink(), &Options::default());
    pdf.begin(&page(1)).unwrap();
    let mut last = 0;
    for round in 0..30_usize {
        for i in 0..10_000 {
            let at = f64::from(i * 7919 % 10_000) * 0.05;
            lines(&mut pdf, &[(at, at * 0.7), (round as f64, f64::from(i % 811))], pen(0.5));
        }
        let so_far = receiver.so_far();
        // What waits for the thread that deflates is no more than a few rounds.
        assert!(so_far >= round.saturating_sub(4) * 30_000, "round {round}: {so_far} bytes");
        last = so_far;
    }
    pdf.end().unwrap();
    let rest = receiver.so_far() - last;
    assert!(rest < 400_000, "{rest} bytes were held back");
    pdf.close().unwrap();
    check_table(&receiver.document());
}

#[test]
fn failing_sink_is_reported() {
    for room in [0, 10, 200, 5_000] {
        let receiver = Receiver::with_room(room);
        let mut pdf = Pdf::new(receiver.sink(), &Options::default());
        let mut all = || {
            pdf.begin(&page(1))?;
            for i in 0..50_000 {
                let path = [DVec2::new(0.0, f64::from(i % 800)), DVec2::new(f64::from(i * 31 % 500), 9.0)];
                let form = Form::Lines(Paths::new(&path, &[2]), pen(1.0));
                let _ = pdf.draw(&Mark { form, clip: None })?;
            }
            pdf.end()?;
            pdf.close()
        };
        assert!(matches!(all(), Err(DeviceError::Io(_))), "room for {room} bytes");
    }
}

#[test]
fn markers_and_patterns_are_refused() {
    let mut pdf = Pdf::new(Receiver::default().sink(), &Options::default());
    pdf.begin(&page(1)).unwrap();
    card::refusals(&mut pdf);
}
