//! PostScript documents and encapsulated pictures.

use crate::card::{self, card, lines, page, pen};
use crate::programs::{TXTWRITE, directory, ghostscript, run};
use crate::receiver::Receiver;
use gks_geometry::{Paths, Rect, Vector};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::device::*;
use gks_pipeline::item::Closure;
use gks_pipeline::look::{Cap, Join};
use gks_workstations::options::Options;
use gks_workstations::postscript::PostScript;
use glam::DVec2;
use std::path::{Path, PathBuf};

/// Draws one document page by page.
fn document(options: &Options, pages: u32, draw: impl FnMut(u32, &mut PostScript)) -> Vec<u8> {
    let receiver = Receiver::default();
    paged(PostScript::new(receiver.sink(), options), pages, draw);
    receiver.document()
}

/// Draws one encapsulated picture.
fn encapsulated(options: &Options, mut draw: impl FnMut(&mut PostScript)) -> Vec<u8> {
    let receiver = Receiver::default();
    paged(PostScript::encapsulated(receiver.sink(), options), 1, |_, device| draw(device));
    receiver.document()
}

fn paged(mut device: PostScript, pages: u32, mut draw: impl FnMut(u32, &mut PostScript)) {
    for number in 1..=pages {
        device.begin(&page(number)).unwrap();
        draw(number, &mut device);
        device.end().unwrap();
    }
    device.close().unwrap();
}

/// Writes a document to a file for other programs.
fn saved(name: &str, document: &[u8]) -> PathBuf {
    let path = directory("postscript").join(name);
    std::fs::write(&path, document).unwrap();
    path
}

/// Checks the comments of structure: how the document begins and ends, that what begins ends, that pages are
/// counted, and that any program may read it as text.
fn check_structure(document: &[u8], pages: usize) -> String {
    let text = String::from_utf8(document.to_vec()).unwrap();
    assert!(text.is_ascii());
    assert!(text.starts_with("%!PS-Adobe-3.0"));
    assert!(text.ends_with("\n%%EOF\n"));
    let longest = text.lines().max_by_key(|line| line.len()).unwrap();
    assert!(longest.len() < 255, "{longest}");
    let mut open = Vec::new();
    for line in text.lines().filter_map(|line| line.strip_prefix("%%")) {
        let word = line.split([':', ' ']).next().unwrap();
        if let Some(what) = word.strip_prefix("Begin") {
            open.push(what.to_owned());
        } else if let Some(what) = word.strip_prefix("End").filter(|what| *what != "Comments") {
            assert_eq!(open.pop().as_deref(), Some(what), "{line}");
        }
    }
    assert!(open.is_empty(), "{open:?}");
    let numbers: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("%%Page: ")).collect();
    let expected: Vec<String> = (1..=pages).map(|number| format!("{number} {number}")).collect();
    assert_eq!(numbers, expected);
    assert!(text.contains(&format!("\n%%Pages: {pages}\n")));
    text
}

/// The bounding boxes that Ghostscript finds, page by page, as whole and as finer numbers.
fn boxes(path: &Path) -> Option<Vec<(String, Vec<f64>)>> {
    let device = ["-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=bbox", path.to_str()?];
    let report = run("gs", &device)?;
    let whole = report.lines().filter_map(|line| line.strip_prefix("%%BoundingBox: "));
    let fine = report.lines().filter_map(|line| line.strip_prefix("%%HiResBoundingBox: "));
    let numbers = |line: &str| line.split(' ').map(|number| number.parse().unwrap()).collect();
    Some(whole.zip(fine).map(|(whole, fine)| (whole.to_owned(), numbers(fine))).collect())
}

/// What follows a comment of structure.
fn comment<'a>(text: &'a str, name: &str) -> &'a str {
    let start = format!("%%{name}: ");
    let found = text.lines().filter_map(|line| line.strip_prefix(&start)).find(|value| *value != "(atend)");
    found.unwrap_or_else(|| panic!("no {name}"))
}

#[test]
fn all_forms() {
    let draw = |device: &mut PostScript| {
        card(device);
        card::texts(device);
    };
    let document = document(&Options::default(), 1, |_, device| draw(device));
    check_structure(&document, 1);
    let picture = encapsulated(&Options::default(), draw);
    assert!(check_structure(&picture, 1).starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
    for path in [saved("card.ps", &document), saved("card.eps", &picture)] {
        if let Some(picture) = ghostscript(&path) {
            card::probe(&picture);
            card::probe_text(&picture);
        }
    }
    assert!(document.len() < 80_000, "{} bytes", document.len());
}

#[test]
fn text_is_text() {
    let path = saved("text.ps", &document(&Options::default(), 2, |_, device| card::texts(device)));
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    let search = |program: &str, text: &str| {
        for line in card::LINES {
            assert_eq!(squeezed(text).matches(&squeezed(line)).count(), 2, "{program}, {line}: {text}");
        }
    };
    let name = path.to_str().unwrap();
    if let Some(text) = run("gs", &[&TXTWRITE[..], &[name]].concat()) {
        search("gs", &text);
    }
    let distilled = path.with_extension("pdf");
    if run("ps2pdf", &[name, distilled.to_str().unwrap()]).is_some()
        && let Some(text) = run("pdftotext", &["-raw", distilled.to_str().unwrap(), "-"])
    {
        search("ps2pdf and pdftotext", &text);
    }
}

#[test]
fn pages_stand_alone() {
    let options = Options { landscape: Some(true), ..Options::default() };
    let document = document(&options, 3, |number, device| {
        let at = 100.0 * f64::from(number);
        lines(device, &[(at, 50.0), (at, 150.0)], pen(20.0));
        card::text(device, card::outline_face(-21), "Page", (at, 200.0), [(20.0, 0.0), (0.0, 20.0)], 0.0);
    });
    let text = check_structure(&document, 3);
    assert!(text.contains("%%DocumentMedia: Sheet 841.89 595.28 0 () ()\n"));
    let (before, rest) = text.split_once("%%Page: 1 1\n").unwrap();
    let (_, rest) = rest.split_once("%%Page: 2 2\n").unwrap();
    let (second, _) = rest.split_once("%%Page: 3 3\n").unwrap();
    let path = saved("second.ps", format!("{before}%%Page: 2 2\n{second}%%EOF\n").as_bytes());
    if let Some(picture) = ghostscript(&path) {
        assert!((picture.0, picture.1) == (842, 595) || (picture.0, picture.1) == (842, 596));
        assert_eq!(card::pixel(&picture, 200, 100), [0; 3]);
        assert_eq!(card::pixel(&picture, 100, 100), [255; 3]);
    }
    if let Some(boxes) = boxes(&saved("pages.ps", &document)) {
        let own = text.lines().filter_map(|line| line.strip_prefix("%%PageBoundingBox: "));
        for ((theirs, _), own) in boxes.iter().zip(own) {
            let numbers = |text: &str| -> Vec<i32> { text.split(' ').map(|n| n.parse().unwrap()).collect() };
            let same = numbers(theirs).iter().zip(numbers(own)).all(|(a, b)| a.abs_diff(b) <= 1);
            assert!(same, "{own}, not {theirs}");
        }
        assert_eq!(boxes.len(), 3);
    }
}

#[test]
fn bounding_boxes_are_tight() {
    type Draw = fn(&mut PostScript);
    let shapes: [(&str, Draw); 8] = [
        ("miter", |device| lines(device, &[(100.0, 100.0), (200.0, 120.0), (100.0, 140.0)], pen(10.0))),
        ("bevelled", |device| lines(device, &[(100.0, 100.0), (300.0, 105.0), (100.0, 110.0)], pen(10.0))),
        ("projecting", |device| {
            lines(device, &[(100.0, 100.0), (200.0, 150.0)], Pen { cap: Cap::Projecting, ..pen(30.0) });
        }),
        ("round", |device| {
            let pen = Pen { cap: Cap::Round, join: Join::Round, ..pen(30.0) };
            lines(device, &[(100.0, 100.0), (200.0, 150.0), (190.0, 90.0)], pen);
        }),
        ("closed", |device| {
            lines(device, &[(100.0, 100.0), (200.0, 100.0), (150.0, 180.0), (100.0, 100.0)], pen(20.0));
        }),
        ("text", |device| {
            let leaning = [(30.0, 20.0), (-10.0, 40.0)];
            card::text(device, card::outline_face(-25), "Quay", (100.0, 100.0), leaning, 0.0);
        }),
        ("curves", |device| {
            for (i, closure) in
                [Closure::Full, Closure::Open, Closure::Chord, Closure::Pie].into_iter().enumerate()
            {
                let centre = (150.0, 150.0 + 150.0 * i as f64);
                card::draw(
                    device,
                    Form::Stroke(card::ellipse(centre.0, centre.1, 0.2, 1.0, closure), pen(20.0)),
                );
            }
        }),
        ("clipped cells", |device| {
            let cells = [card::paint(1.0, 0.0, 0.0)];
            let grid = Grid { paints: &cells, columns: 1, rows: 1 };
            let form = Form::Cells(card::place((90.0, 90.0), (50.0, 20.0), (-20.0, 70.0)), grid);
            card::clipped(device, form, Some(Rect::new(80.5, 120.25, 95.0, 300.0)));
        }),
    ];
    for (name, draw) in shapes {
        let text = check_structure(&encapsulated(&Options::default(), draw), 1);
        let at_the_beginning = text.split("%%EndComments").next().unwrap();
        let fine = comment(at_the_beginning, "HiResBoundingBox");
        let whole = comment(at_the_beginning, "BoundingBox");
        let Some(boxes) = boxes(&saved(&format!("{name}.eps"), text.as_bytes())) else { continue };
        for (ours, theirs) in fine.split(' ').zip(&boxes[0].1) {
            let ours: f64 = ours.parse().unwrap();
            assert!((ours - theirs).abs() < 0.1, "{name}: {fine}, not {:?}", boxes[0].1);
        }
        for (i, (whole, fine)) in whole.split(' ').zip(fine.split(' ')).enumerate() {
            let (whole, fine): (f64, f64) = (whole.parse().unwrap(), fine.parse().unwrap());
            let outside = if i < 2 { fine - whole } else { whole - fine };
            assert!((-0.001..1.0).contains(&outside), "{name}: {whole} for {fine}");
        }
    }
    let empty = encapsulated(&Options::default(), |_| {});
    assert_eq!(comment(&check_structure(&empty, 1), "BoundingBox"), "0 0 0 0");
    let blue = Options { background: Some(Colour::rgb(0.0, 0.0, 1.0)), ..Options::default() };
    let filled = encapsulated(&blue, |_| {});
    assert_eq!(comment(&check_structure(&filled, 1), "BoundingBox"), "0 0 596 842");
}

#[test]
fn pictures_are_documents_of_their_own() {
    let receiver = Receiver::default();
    paged(PostScript::encapsulated(receiver.sink(), &Options::default()), 3, |number, device| {
        lines(device, &[(0.0, 0.0), (100.0 * f64::from(number), 50.0)], pen(1.0));
    });
    let received = receiver.0.lock().unwrap();
    assert_eq!(received.documents.len(), 3);
    assert!(received.current.is_none());
    for document in &received.documents {
        check_structure(document, 1);
    }
}

/// Long pages are let go in parts; characters that come up later go into fonts of their own.
#[test]
fn memory_does_not_grow_with_the_number_of_marks() {
    let receiver = Receiver::default();
    let mut device = PostScript::new(receiver.sink(), &Options::default());
    device.begin(&page(1)).unwrap();
    let sans = card::outline_face(-21);
    let upright = [(20.0, 0.0), (0.0, 20.0)];
    let mut drawn = 0;
    for (round, word) in ["First", "Second", "Third", "Fourth"].into_iter().enumerate() {
        card::text(&mut device, sans, word, (50.0, 100.0 * round as f64 + 50.0), upright, 0.0);
        for i in 0..25_000 {
            let at = f64::from(i * 7919 % 10_000) * 0.05;
            lines(&mut device, &[(at, at * 0.7), (f64::from(i % 523), f64::from(i % 811))], pen(0.5));
        }
        drawn += 25_000 * 20;
        assert!(receiver.so_far() + (2 << 20) > drawn, "{} bytes of {drawn}", receiver.so_far());
    }
    assert!(receiver.so_far() > 1 << 20);
    device.end().unwrap();
    device.close().unwrap();
    let document = receiver.document();
    let text = check_structure(&document, 1);
    assert!(text.contains("%%PageBoundingBox: (atend)\n"));
    let (_, trailer) = text.split_once("%%PageTrailer\n").unwrap();
    assert!(trailer.starts_with("%%PageBoundingBox: "));
    let fonts = text.matches("%%BeginResource: font").count();
    assert!((2..=4).contains(&fonts), "{fonts} fonts");
    let path = saved("long.ps", &document);
    if let Some(found) = run("gs", &[&TXTWRITE[..], &[path.to_str().unwrap()]].concat()) {
        for word in ["First", "Second", "Third", "Fourth"] {
            assert!(found.contains(word), "{word}: {found}");
        }
    }
}

#[test]
fn more_characters_than_a_font_has_codes() {
    let sans = card::outline_face(-21);
    let characters: Vec<char> =
        ('!'..'\u{500}').filter(|c| sans.glyph_id(*c).is_some_and(|id| id != 0)).collect();
    assert!(characters.len() > 600);
    let document = document(&Options::default(), 1, |_, device| {
        for (i, line) in characters.chunks(32).enumerate() {
            let line: String = line.iter().collect();
            card::text(device, sans, &line, (40.0, 800.0 - 20.0 * i as f64), [(12.0, 0.0), (0.0, 12.0)], 0.2);
        }
    });
    let text = check_structure(&document, 1);
    assert!(text.matches("%%BeginResource: font").count() >= 3);
    let path = saved("characters.ps", &document);
    if let Some(found) = run("gs", &[&TXTWRITE[..], &[path.to_str().unwrap()]].concat()) {
        let missing: String =
            characters.iter().filter(|c| c.is_alphabetic() && !found.contains(**c)).collect();
        assert!(missing.is_empty(), "not found: {missing}");
    }
}

#[test]
fn large_images_are_let_go_on_the_way() {
    let mut state = 1_u32;
    let noise: Vec<Paint> = std::iter::repeat_with(|| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let part = |shift: u32| (state >> shift & 255) as f32 / 255.0;
        card::paint(part(24), part(16), part(20))
    })
    .take(1000 * 600)
    .collect();
    let document = document(&Options::default(), 1, |_, device| {
        card::text(device, card::outline_face(-21), "Before", (50.0, 50.0), [(20.0, 0.0), (0.0, 20.0)], 0.0);
        let grid = Grid { paints: &noise, columns: 1000, rows: 600 };
        card::draw(device, Form::Cells(card::place((50.0, 700.0), (500.0, 0.0), (0.0, -500.0)), grid));
        card::text(device, card::outline_face(-21), "After", (50.0, 100.0), [(20.0, 0.0), (0.0, 20.0)], 0.0);
    });
    assert!(document.len() > 2 << 20);
    check_structure(&document, 1);
    let path = saved("noise.ps", &document);
    if let Some(picture) = ghostscript(&path) {
        assert_ne!(card::pixel(&picture, 300, 210), [255; 3], "the last row is missing");
    }
    if let Some(found) = run("gs", &[&TXTWRITE[..], &[path.to_str().unwrap()]].concat()) {
        assert!(found.contains("Before") && found.contains("After"), "{found}");
    }
}

#[test]
fn there_is_no_opacity() {
    let half = card::translucent(card::paint(1.0, 0.0, 0.0), 0.5);
    let nothing = card::translucent(half, 0.0);
    let document = document(&Options::default(), 1, |_, device| {
        lines(device, &[(100.0, 100.0), (100.0, 200.0)], Pen { paint: half, ..pen(10.0) });
        lines(device, &[(200.0, 100.0), (200.0, 200.0)], Pen { paint: nothing, ..pen(10.0) });
        let at = card::place((300.0, 200.0), (100.0, 0.0), (0.0, -100.0));
        card::draw(device, Form::Cells(at, Grid { paints: &[half], columns: 1, rows: 1 }));
        let holes = Form::Cells(at, Grid { paints: &[half, nothing], columns: 2, rows: 1 });
        assert_eq!(device.draw(&Mark { form: holes, clip: None }).unwrap(), Drawn::No);
    });
    if let Some(picture) = ghostscript(&saved("opaque.ps", &document)) {
        for (x, colour) in [(100, [255, 0, 0]), (200, [255; 3]), (350, [255, 0, 0])] {
            assert_eq!(card::pixel(&picture, x, 150), colour, "at {x}");
        }
    }
}

#[test]
fn failing_sink_is_reported() {
    for room in [0, 10, 3_000, 1_200_000] {
        let receiver = Receiver::with_room(room);
        let mut device = PostScript::new(receiver.sink(), &Options::default());
        let mut all = || {
            device.begin(&page(1))?;
            for i in 0..100_000 {
                let path = [DVec2::new(0.0, f64::from(i % 800)), DVec2::new(f64::from(i * 31 % 500), 9.0)];
                let form = Form::Lines(Paths::new(&path, &[2]), pen(1.0));
                let _ = device.draw(&Mark { form, clip: None })?;
            }
            device.end()?;
            device.close()
        };
        assert!(matches!(all(), Err(DeviceError::Io(_))), "room for {room} bytes");
    }
}

#[test]
fn outlines_markers_and_patterns_are_refused() {
    let options = Options { outlines: true, ..Options::default() };
    let mut device = PostScript::new(Receiver::default().sink(), &options);
    device.begin(&page(1)).unwrap();
    card::refusals(&mut device);
    let (x, y) = (Vector::new(1.0, 0.0), Vector::new(0.0, 1.0));
    let paint = card::paint(0.0, 0.0, 0.0);
    let run = GlyphRun { text: "", face: card::outline_face(-21), glyphs: &[], x, y, paint };
    assert_eq!(device.draw(&Mark { form: Form::Text(run), clip: None }).unwrap(), Drawn::No);
}
