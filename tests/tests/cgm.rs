//! CGM in every encoding: what is written and played looks as if it had been drawn, and other readers understand it.

use gks_pipeline::generated::numbers::workstation_type as own;
use gks_tests::drawing::{self, Way, drivers};
use gks_tests::likeness;
use gks_tests::pictures::{PICTURES, Picture};
use gks_tests::program::repository;
use gks_tests::reader;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const SURFACE: &str = "size=500x500";

/// Left and lower edge and side of the unit square on a page of `ctrans`, in points.
const PAGE_OF_CTRANS: [f64; 3] = [50.4, 140.4, 509.9];

fn folder() -> PathBuf {
    drawing::folder(env!("CARGO_TARGET_TMPDIR"), "cgm")
}

fn pixels(file: &Path) -> Result<image::RgbaImage, String> {
    image::open(file)
        .map(image::DynamicImage::into_rgba8)
        .map_err(|error| format!("{}: {error}", file.display()))
}

/// How many of 10000 pixels differ by more than a quarter of the range in some component from the pixel in their place
/// and from all neighbours of it. An edge that lies on the middle of a pixel may fall on either side.
fn strays(one: &image::RgbaImage, other: &image::RgbaImage) -> u32 {
    let near =
        |a: &image::Rgba<u8>, b: &image::Rgba<u8>| a.0.iter().zip(b.0).all(|(a, b)| a.abs_diff(b) <= 64);
    let (width, height) = one.dimensions();
    let found = |x: u32, y: u32, pixel: &image::Rgba<u8>| {
        let (columns, rows) = (x.saturating_sub(1)..=x + 1, y.saturating_sub(1)..=y + 1);
        let inside = |x: &u32, y: &u32| *x < width && *y < height;
        columns
            .flat_map(|x| rows.clone().map(move |y| (x, y)))
            .any(|(x, y)| inside(&x, &y) && near(pixel, other.get_pixel(x, y)))
    };
    let count = one.enumerate_pixels().filter(|(x, y, pixel)| !found(*x, *y, pixel)).count();
    (count * 10_000).div_ceil((width * height) as usize) as u32
}

/// What may become of a picture on its way through a metafile.
#[derive(Clone, Copy)]
enum Loss {
    /// Nothing: every pixel is the same.
    None,
    /// Coordinates are rounded: some pixels of edges differ, and so many of 10000 may be strays.
    Strays(u32),
}

fn compare(direct: &Path, played: &Path, loss: Loss) -> Result<(), String> {
    let (one, other) = (pixels(direct)?, pixels(played)?);
    if one.dimensions() != other.dimensions() {
        return Err("another size".to_owned());
    }
    match loss {
        Loss::None => match one.pixels().zip(other.pixels()).filter(|(a, b)| a != b).count() {
            0 => Ok(()),
            count => Err(format!("{count} pixels differ")),
        },
        Loss::Strays(allowed) => match strays(&one, &other) {
            strays if strays <= allowed => Ok(()),
            strays => Err(format!("{strays} of 10000 pixels are strays")),
        },
    }
}

fn round_trip(picture: &Picture, kind: i32, options: &str, loss: Loss) -> Result<(), String> {
    let way = Way { kind, options, surface: SURFACE, folder: &folder() };
    drawing::round_trip(picture, way, |direct, played| compare(direct, played, loss))
}

fn all(kind: i32, options: &str, loss: Loss) {
    let faults: Vec<String> =
        PICTURES.iter().filter_map(|picture| round_trip(picture, kind, options, loss).err()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn real_coordinates_lose_nothing() {
    all(own::CGM, "&version=3&vdc=real", Loss::None);
}

#[test]
fn clear_text_loses_nothing() {
    all(own::CGM_TEXT, "&version=3", Loss::None);
}

#[test]
fn coordinates_of_32_bits_lose_next_to_nothing() {
    all(own::CGM, "&version=3&vdc=integer", Loss::Strays(1));
}

/// A coordinate is off by at most half of the 16383rd part of the longer side: here by a 65th of a pixel.
#[test]
fn coordinates_of_16_bits_move_edges_by_a_65th_of_a_pixel() {
    all(own::CGM, "&version=3", Loss::Strays(2));
}

/// The character encoding and the records of NCAR know version 1 only: neither line ends and corners nor curves.
#[test]
fn pictures_survive_characters_and_records_of_ncar() {
    let beyond = |name: &str| ["ends_and_corners", "dashed_curves"].iter().any(|part| name.contains(part));
    let faults: Vec<String> = PICTURES
        .iter()
        .filter(|picture| !beyond(picture.name))
        .flat_map(|picture| [(own::CGM_CHARACTER, 12), (own::NCGM, 12)].map(|how| (picture, how)))
        .filter_map(|(picture, (kind, strays))| round_trip(picture, kind, "", Loss::Strays(strays)).err())
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Pictures with nothing in them that is private to us, and without what has another size there: wide lines, markers.
const STANDARD: [&str; 3] = ["polyline-clipped", "cell_array-colours", "segment-priorities"];

/// A page that NCAR's `ctrans` has drawn in PostScript, of which `frame` is the unit square, in points.
fn rasterized(page: &Path, image: &Path, [left, bottom, side]: [f64; 3]) -> Result<(), String> {
    let scale = format!("-r{}", f64::from(likeness::SIZE) / side * 72.0);
    let size = format!("-g{0}x{0}", likeness::SIZE);
    let place = format!("<</PageOffset [{} {}]>> setpagedevice", -left, bottom);
    let (output, page) = (format!("-sOutputFile={}", image.display()), page.display().to_string());
    let options = ["-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=png16m", "-dGraphicsAlphaBits=4"];
    let arguments: Vec<&str> =
        options.into_iter().chain([&*scale, &size, &output, "-c", &place, "-f", &page]).collect();
    reader::run(60, "gs", &arguments).map(drop)
}

#[test]
fn ncar_draws_our_records_and_our_binary_encoding() {
    if !reader::present("NCAR's reader", &["ctrans", "cgm2ncgm", "gs"]) {
        return;
    }
    let file = |name: &str| folder().join(name);
    for name in STANDARD {
        let direct = file(&format!("{name}.ncar.png"));
        let surface = format!("size={0}x{0}", likeness::SIZE);
        let picture = Picture::named(name);
        picture
            .draw(Box::new(drivers()), &format!("{}?{surface}", direct.display()), own::PNG)
            .expect("a picture");
        for kind in [own::NCGM, own::CGM] {
            let [metafile, records, page, image] =
                ["cgm", "ncgm", "ps", "ctrans.png"].map(|end| file(&format!("{name}-{kind}.ncar.{end}")));
            picture
                .draw(Box::new(drivers()), &format!("{}?{surface}", metafile.display()), kind)
                .expect("a metafile");
            let read = if kind == own::CGM {
                let octets = fs::File::open(&metafile).expect("the metafile");
                let converted = Command::new("cgm2ncgm").stdin(octets).output().expect("cgm2ncgm runs");
                fs::write(&records, converted.stdout).expect("the records");
                &records
            } else {
                &metafile
            };
            let read = reader::run(60, "ctrans", &["-d", "ps.color", &read.display().to_string()]);
            fs::write(&page, read.expect("ctrans reads it").stdout).expect("the page");
            rasterized(&page, &image, PAGE_OF_CTRANS).expect("it is PostScript");
            let [ours, theirs] = [&direct, &image].map(|image| likeness::open(image).expect("a picture"));
            let found = likeness::likeness(&ours, &theirs);
            assert!(found.stray <= 0.1 && found.tone <= 10.0, "{name} {kind}: {found:?}");
        }
    }
}

/// What `tests/python_cgm.py` finds in a metafile: how many elements of each class and number.
fn elements_found(file: &Path) -> Vec<(String, usize)> {
    let python = repository().join("target/python-cgm/bin/python");
    let script = repository().join("tests/python_cgm.py");
    let [python, script, file] = [&*python, &*script, file].map(|path| path.display().to_string());
    let found = reader::run(60, &python, &[&script, &file]).expect("python-cgm reads it");
    let text = String::from_utf8_lossy(&found.stdout).into_owned();
    let pairs = text.lines().filter_map(|line| line.rsplit_once(' '));
    pairs.map(|(kind, count)| (kind.to_owned(), count.parse().expect("a number"))).collect()
}

#[test]
fn python_cgm_parses_our_clear_text_and_our_binary_encoding() {
    if !repository().join("target/python-cgm/bin/python").is_file() {
        let continuous = std::env::var("CI").is_ok_and(|value| value == "true");
        assert!(!continuous, "python-cgm is missing");
        reader::skip("python-cgm", "not in target/python-cgm");
        return;
    }
    let picture = Picture::named("demo-gks");
    let [text, binary] = [(own::CGM_TEXT, "parsed.cgmt"), (own::CGM, "parsed.cgm")].map(|(kind, name)| {
        let file = folder().join(name);
        picture
            .draw(Box::new(drivers()), &format!("{}?{SURFACE}", file.display()), kind)
            .expect("a metafile");
        file
    });
    let words = fs::read_to_string(&text).expect("text");
    let written = |keyword: &str| {
        let keyword = format!("{keyword} ");
        words.lines().filter(|line| line.starts_with(&keyword)).count()
    };
    let (in_text, in_binary) = (elements_found(&text), elements_found(&binary));
    // Text has the number of restricted text in what python-cgm makes of clear text.
    let kinds = [("LINE", "4 1", "4 1"), ("MARKER", "4 3", "4 3"), ("POLYGON", "4 7", "4 7")];
    for (keyword, number, in_octets) in kinds.into_iter().chain([("TEXT", "4 5", "4 4")]) {
        let count = |found: &[(String, usize)], number: &str| {
            found.iter().find(|(kind, _)| kind == number).map_or(0, |(_, count)| *count)
        };
        assert!(written(keyword) > 5, "{keyword}");
        assert_eq!(count(&in_text, number), written(keyword), "{keyword} in clear text");
        assert_eq!(count(&in_binary, in_octets), written(keyword), "{keyword} in binary");
    }
}
