//! LibreOffice Impress shows the pictures in our binary CGM, within what it reads.
//!
//! It is a coarse reader: it draws neither markers, cells nor patterns, clips nothing, has dashes and hatches of its own
//! and one font, and refuses text and ellipses that are turned. What is left is compared.

use gks_pipeline::generated::numbers::workstation_type as own;
use gks_tests::drawing::drivers;
use gks_tests::folder::Folder;
use gks_tests::likeness::{self, Likeness, SIZE};
use gks_tests::pictures::Picture;
use gks_tests::reader;
use image::imageops::{self, FilterType};
use image::{Rgb, RgbImage};

/// Pictures of what it draws: lines of every width, arcs, curves, areas, colours.
const SHOWN: [&str; 7] = [
    "polyline-widths",
    "polyline-degenerate",
    "gdp-circles",
    "gdp-curves",
    "bundle-colours",
    "segment-priorities",
    "demo-phigs",
];

/// A picture of which it draws nothing but a frame.
const NOT_SHOWN: &str = "polymarker-clipped";

/// The side of the unit square on its slide, in pixels; their upper left corners are the same.
const SIDE_ON_SLIDE: f64 = 793.5;

/// The rows of a picture that are on the slide, which is wider than high.
const ROWS: u32 = 590;

#[test]
#[ignore = "takes half a gigabyte of programs: tests/legacy/impress runs it"]
fn impress_shows_our_binary_encoding() {
    let folder = Folder::new(env!("CARGO_TARGET_TMPDIR"), "impress");
    let names = || SHOWN.into_iter().chain([NOT_SHOWN]);
    for name in names() {
        for (end, kind, options) in [("png", own::PNG, ""), ("cgm", own::CGM, "&colours=128")] {
            let connection = format!("{}?size={SIZE}x{SIZE}{options}", folder.file(&format!("{name}.{end}")));
            Picture::named(name).draw(Box::new(drivers()), &connection, kind).expect("a picture");
        }
    }
    let profile = format!("-env:UserInstallation=file://{}", folder.file("profile"));
    let shown = folder.file("shown");
    let files: Vec<String> = names().map(|name| folder.file(&format!("{name}.cgm"))).collect();
    let options = [&*profile, "--headless", "--convert-to", "png", "--outdir", &shown];
    let arguments: Vec<&str> = options.into_iter().chain(files.iter().map(String::as_str)).collect();
    reader::run(600, "soffice", &arguments).expect("soffice reads metafiles");

    let alike = |name: &str| -> Likeness {
        let open =
            |file: String| image::open(&file).unwrap_or_else(|error| panic!("{file}: {error}")).to_rgb8();
        let ours = open(folder.file(&format!("{name}.png")));
        let theirs = open(folder.file(&format!("shown/{name}.png")));
        likeness::likeness(&on_slide(&ours, f64::from(SIZE)), &on_slide(&theirs, SIDE_ON_SLIDE))
    };
    for name in SHOWN {
        let found = alike(name);
        println!("{name}: {found:?}");
        assert!(found.stray <= 0.05 && found.tone <= 10.0, "{name}: {found:?}");
    }
    assert!(alike(NOT_SHOWN).stray > 0.3, "markers that are missing are not noticed");
}

/// The upper part of a picture in which the unit square has a side of so many pixels, in the size of comparison.
fn on_slide(picture: &RgbImage, side: f64) -> RgbImage {
    let scale = f64::from(SIZE) / side;
    let [width, height] = [picture.width(), picture.height()].map(|n| (f64::from(n) * scale).round() as u32);
    let scaled = imageops::resize(picture, width, height, FilterType::Triangle);
    let mut square = RgbImage::from_pixel(SIZE, SIZE, Rgb([255; 3]));
    imageops::replace(&mut square, &*imageops::crop_imm(&scaled, 0, 0, SIZE, ROWS), 0, 0);
    square
}
