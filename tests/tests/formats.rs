//! The demonstration pictures in every format, judged by programs and libraries that nobody here wrote.

use gks_pipeline::description::Catalogue;
use gks_pipeline::generated::numbers::workstation_type as own;
use gks_tests::drawing::drivers;
use gks_tests::folder::Folder;
use gks_tests::pictures::Picture;
use gks_tests::reader::{present, run, skip};
use std::fs;
use std::path::Path;

/// The demonstration pictures on a type: one test for one format.
struct Demo {
    folder: Folder,
    extension: &'static str,
}

const PICTURES: [&str; 2] = ["demo-gks", "demo-phigs"];

impl Demo {
    /// Draws the pictures, unless the installation lacks the type or the machine the programs.
    fn draw(
        kind: i32,
        name: &str,
        extension: &'static str,
        options: &str,
        programs: &[&str],
    ) -> Option<Demo> {
        if !drivers().types().contains(&kind) {
            skip(name, "no such workstation type yet");
            return None;
        }
        if !present(name, programs) {
            return None;
        }
        let demo =
            Demo { folder: Folder::new(env!("CARGO_TARGET_TMPDIR"), &format!("formats-{name}")), extension };
        for picture in PICTURES {
            let connection = format!("{}?{options}", demo.file(picture));
            Picture::named(picture).draw(Box::new(drivers()), &connection, kind).expect(picture);
        }
        Some(demo)
    }

    fn file(&self, picture: &str) -> String {
        self.folder.file(&format!("{picture}.{}", self.extension))
    }

    /// Calls `judge` with the name of each file.
    fn each(&self, judge: impl Fn(&str)) {
        PICTURES.iter().for_each(|picture| judge(&self.file(picture)));
    }
}

fn said(seconds: u32, program: &str, arguments: &[&str]) -> String {
    let output = run(seconds, program, arguments).unwrap_or_else(|said| panic!("{said}"));
    String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned()
}

#[test]
fn png_is_accepted_by_pngcheck() {
    for (kind, name) in [(own::PNG, "png"), (own::PNG8, "png8")] {
        let Some(demo) = Demo::draw(kind, name, "png", "size=800x600&dpi=144", &["pngcheck"]) else { return };
        demo.each(|file| {
            let said = said(20, "pngcheck", &["-v", file]);
            assert!(said.contains("No errors detected") && said.contains("800 x 600"), "{said}");
            // 144 pixels per inch are 5669 per metre.
            assert!(said.contains("5669x5669 pixels/meter"), "{said}");
        });
    }
}

#[test]
fn images_of_other_formats_show_the_pixels_of_png() {
    let size = "size=800x600";
    let Some(png) = Demo::draw(own::PNG, "png-for-others", "png", size, &[]) else { return };
    let exact = 0.0;
    let types = [
        (own::BMP, "bmp", "bmp", exact),
        (own::TIFF, "tiff", "tif", exact),
        (own::WEBP, "webp", "webp", exact),
        (own::JPEG, "jpeg", "jpg", 4.0),
    ];
    for (kind, name, extension, deviation) in types {
        let Some(demo) = Demo::draw(kind, name, extension, size, &[]) else { continue };
        for picture in PICTURES {
            let open =
                |file: String| image::open(&file).unwrap_or_else(|e| panic!("{file}: {e}")).into_rgb8();
            let (ours, reference) = (open(demo.file(picture)), open(png.file(picture)));
            assert_eq!(ours.dimensions(), (800, 600), "{name}");
            let apart = |(a, b): (&u8, &u8)| f64::from(a.abs_diff(*b)).powi(2);
            let sum: f64 = ours.as_raw().iter().zip(reference.as_raw()).map(apart).sum();
            let mean = (sum / ours.as_raw().len() as f64).sqrt();
            assert!(mean <= deviation, "{name}: the components deviate by {mean:.2}");
        }
    }
}

#[test]
fn svg_is_valid_by_its_document_type_definition() {
    const DTD: &str = "/usr/share/xml/w3c-sgml-lib/schema/dtd/REC-SVG11-20110816/svg11.dtd";
    for (kind, name) in [(own::SVG, "svg"), (own::SVG_OUTLINES, "svg-outlines")] {
        let Some(demo) = Demo::draw(kind, name, "svg", "", &["xmllint"]) else { return };
        if !Path::new(DTD).exists() {
            assert!(!std::env::var("CI").is_ok_and(|value| value == "true"), "{DTD} is missing");
            return skip(name, &format!("missing file: {DTD}"));
        }
        demo.each(|file| {
            said(60, "xmllint", &["--noout", "--nonet", "--dtdvalid", DTD, file]);
        });
        let text = fs::read_to_string(demo.file("demo-gks")).unwrap();
        let kept = text.contains(">Graphical Kernel System<");
        assert_eq!(kept, kind == own::SVG, "{name}: text is kept as text in SVG only");
    }
}

#[test]
fn pdf_is_accepted_by_qpdf_and_its_text_can_be_searched() {
    let programs = ["qpdf", "pdftotext", "pdffonts", "pdfinfo"];
    let Some(demo) = Demo::draw(own::PDF, "pdf", "pdf", "", &programs) else { return };
    demo.each(|file| {
        let said = said(60, "qpdf", &["--check", file]);
        assert!(said.contains("No syntax or stream encoding errors found"), "{said}");
        assert!(!said.to_lowercase().contains("warning"), "{said}");
    });
    let file = demo.file("demo-gks");
    let text = said(60, "pdftotext", &["-layout", &file, "-"]);
    for words in
        ["Graphical Kernel System", "one program, every device", "Sans Bold", "Serif Bold Жд", "rotated"]
    {
        assert!(text.contains(words), "{words} is not in:\n{text}");
    }
    // Every font is embedded, as a subset, with a map to Unicode.
    let fonts = said(60, "pdffonts", &[&file]);
    let rows: Vec<&str> = fonts.lines().skip(2).collect();
    assert!(rows.len() >= 6, "{fonts}");
    for row in rows {
        let words: Vec<&str> = row.split_whitespace().collect();
        assert_eq!(words[words.len() - 5..words.len() - 2], ["yes", "yes", "yes"], "{fonts}");
    }
    let info = said(60, "pdfinfo", &[&file]);
    assert!(info.contains("595.28 x 841.89 pts (A4)") && info.contains("Pages:           1"), "{info}");
}

#[test]
fn postscript_is_run_by_ghostscript_within_its_bounding_box() {
    for (kind, name, extension) in [(own::PS, "ps", "ps"), (own::EPS, "eps", "eps")] {
        let Some(demo) = Demo::draw(kind, name, extension, "", &["gs"]) else { continue };
        demo.each(|file| {
            let bytes = fs::read(file).unwrap();
            let text = String::from_utf8_lossy(&bytes);
            let first = text.lines().next().unwrap_or_default();
            assert!(first.starts_with("%!PS-Adobe-3.0"), "{first}");
            assert_eq!(first.contains("EPSF-3.0"), kind == own::EPS, "{first}");
            let told = bounding_box(&text).unwrap_or_else(|| panic!("{name} has no bounding box"));
            let arguments = ["-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=bbox", file];
            let said = said(120, "gs", &arguments);
            assert_eq!(said.matches("%%BoundingBox").count(), 1, "one page: {said}");
            assert!(!said.contains("Error"), "{said}");
            let drawn = bounding_box(&said).unwrap_or_else(|| panic!("{said}"));
            let inside =
                told[0] <= drawn[0] && told[1] <= drawn[1] && told[2] >= drawn[2] && told[3] >= drawn[3];
            assert!(inside, "{name}: {drawn:?} is not inside of {told:?}");
            assert!(drawn[2] - drawn[0] > 400.0, "{name}: {drawn:?} is too small");
        });
    }
}

/// The limits in the first bounding box comment that has some.
fn bounding_box(text: &str) -> Option<[f64; 4]> {
    let boxes = text.lines().filter_map(|line| line.trim().strip_prefix("%%BoundingBox:"));
    boxes
        .filter_map(|limits| {
            let numbers: Vec<f64> = limits.split_whitespace().filter_map(|n| n.parse().ok()).collect();
            numbers.try_into().ok()
        })
        .next()
}

#[test]
fn hpgl_is_drawn_by_hp2xx() {
    let Some(demo) = Demo::draw(own::HPGL, "hpgl", "plt", "", &["hp2xx"]) else { return };
    demo.each(|file| {
        let image = format!("{file}.png");
        // Without -q it tells how many errors it met.
        let told = said(20, "hp2xx", &["-m", "png", "-t", "-d", "100", "-f", &image, file]);
        assert!(!told.to_lowercase().contains("error") && !told.contains("unknown"), "{told}");
        let drawn = image::open(&image).unwrap().into_luma8();
        let ink = drawn.pixels().filter(|p| p.0[0] < 128).count();
        let part = ink as f64 / f64::from(drawn.width() * drawn.height());
        assert!(drawn.width() > 500 && drawn.height() > 500, "{} x {}", drawn.width(), drawn.height());
        assert!((0.02..0.9).contains(&part), "{part} of the sheet is ink");
        // Only instructions that every reader knows.
        let text = fs::read_to_string(file).unwrap();
        let words = text.split(|c: char| c == ';' || c.is_ascii_whitespace()).filter(|word| !word.is_empty());
        for word in words {
            assert!(["IN", "IP", "SP", "PU", "PD", "PA"].contains(&&word[..2]), "{word}");
        }
    });
}
