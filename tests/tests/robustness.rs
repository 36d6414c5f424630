//! Bad input: every call answers with the error of the standard or does what its documentation says, and the
//! program goes on.

use gks::{DataRecord, Error, Gks, Result};
use gks_geometry::Rect;
use gks_pipeline::colour::Colour;
use gks_pipeline::description::Catalogue;
use gks_pipeline::generated::numbers::{GDPS, WORKSTATION_TYPES, workstation_type as own};
use gks_pipeline::look::{
    AspectSourceFlags, Cap, Horizontal, InteriorStyle, Join, Precision, TextPath, Vertical,
};
use gks_tests::drawing::drivers;
use gks_tests::folder::Folder;
use gks_tests::random::Random;
use gks_tests::reader;
use std::fs;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

fn folder(name: &str) -> Folder {
    Folder::new(env!("CARGO_TARGET_TMPDIR"), name)
}

/// An open kernel with a small active frame buffer.
fn active() -> Gks {
    let mut gks = Gks::open(Box::new(drivers()));
    gks.open_workstation(1, "?size=200x200", own::FRAMEBUFFER).unwrap();
    gks.activate_workstation(1).unwrap();
    gks
}

fn number<T>(result: Result<T>) -> i32 {
    result.err().map_or(0, |error: Error| error.number)
}

/// The types of the installation that write files, with their extensions.
fn file_types() -> Vec<(i32, &'static str, &'static str)> {
    let there = drivers().types();
    let writes = |number: i32| there.contains(&number) && number != own::DEFAULT;
    WORKSTATION_TYPES
        .iter()
        .filter(|kind| writes(kind.number) && !kind.extension.is_empty())
        .map(|kind| (kind.number, kind.name, kind.extension))
        .collect()
}

/// Runs in a thread of its own and fails where that does not come back in time.
fn within(seconds: u64, what: &str, work: impl FnOnce() + Send + 'static) {
    let (sender, receiver) = mpsc::channel();
    let worker = thread::spawn(move || {
        work();
        let _ = sender.send(());
    });
    match receiver.recv_timeout(Duration::from_secs(seconds)) {
        Err(mpsc::RecvTimeoutError::Timeout) => panic!("{what}: still busy after {seconds} s"),
        _ => {
            if let Err(panic) = worker.join() {
                std::panic::resume_unwind(panic);
            }
        }
    }
}

const STYLES: [InteriorStyle; 4] =
    [InteriorStyle::Hollow, InteriorStyle::Solid, InteriorStyle::Pattern, InteriorStyle::Hatch];

/// Draws every primitive in every style with the two coordinates among good ones.
fn primitives_with(gks: &mut Gks, x: f64, y: f64) -> Result<()> {
    let points = [(0.1, 0.1), (x, 0.5), (0.9, 0.1), (0.9, 0.9), (0.5, y), (0.1, 0.9), (0.2, 0.2)];
    for linetype in [1, 2] {
        gks.set_linetype(linetype)?;
        gks.polyline(&points)?;
        gks.polyline(&[(x, y), (0.5, 0.5)])?;
        gks.polyline(&[(x, y), (x, y)])?;
    }
    gks.polymarker(&points)?;
    for font in [1, -21] {
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        gks.text((x, y), "text")?;
        gks.text((x, 0.5), "text")?;
    }
    gks.cell_array_of((x, 0.1), (0.5, y), &[1, 2, 3, 4], 2, 2, 2)?;
    for style in STYLES {
        gks.set_fill_area_interior_style(style)?;
        gks.set_fill_area_style_index(if style == InteriorStyle::Hatch { -1 } else { 1 })?;
        gks.fill_area(&points)?;
        for kind in GDPS {
            let count = kind.least.max(4).min(if kind.most == 0 { 7 } else { kind.most });
            for bad in 0..count {
                let mut points = points;
                points[1] = (0.4, 0.5);
                points[4] = (0.5, 0.3);
                points[bad] = (x, y);
                gks.generalized_drawing_primitive(&points[..count], kind.number, &DataRecord::default())?;
            }
        }
    }
    Ok(())
}

#[test]
fn coordinates_that_are_not_finite_or_huge_harm_no_device() {
    let folder = folder("coordinates");
    let huge = [1e30, -1e30, 1e15, -1e9, 1e300];
    for (kind, name, extension) in file_types() {
        for (x, y) in [(f64::NAN, f64::NAN), (f64::INFINITY, 0.5), (0.5, f64::NEG_INFINITY)]
            .into_iter()
            .chain(huge.map(|v| (v, 0.5)))
            .chain(huge.map(|v| (v, -v)))
        {
            let file = folder.file(&format!("{name}.{extension}"));
            let what = format!("{name} with ({x:e}, {y:e})");
            within(120, &what.clone(), move || {
                let mut gks = Gks::open(Box::new(drivers()));
                gks.open_workstation(1, &format!("{file}?size=100x100"), kind).unwrap();
                gks.activate_workstation(1).unwrap();
                primitives_with(&mut gks, x, y).unwrap_or_else(|error| panic!("{what}: {error}"));
                gks.deactivate_workstation(1).unwrap();
                gks.close_workstation(1).unwrap_or_else(|error| panic!("{what}: {error}"));
                assert!(fs::metadata(&file).unwrap().len() > 20, "{what}");
                let text = fs::read(&file).unwrap();
                let holds =
                    |word: &str| text.windows(word.len()).any(|w| w.eq_ignore_ascii_case(word.as_bytes()));
                if ["svg", "ps", "eps", "plt"].contains(&extension) {
                    assert!(!holds(" nan") && !holds(",nan") && !holds(" inf"), "{what}");
                }
            });
        }
    }
}

#[test]
fn windows_and_viewports_must_have_an_area_and_a_place() {
    let mut gks = active();
    let flat = [[0.0; 4], [0.0, 1.0, 0.5, 0.5], [1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 1.0, 0.0]];
    let endless = [[0.0, f64::NAN, 0.0, 1.0], [0.0, f64::INFINITY, 0.0, 1.0]];
    for limits in flat.into_iter().chain(endless) {
        assert_eq!(number(gks.set_window(1, limits)), 51, "{limits:?}");
        assert_eq!(number(gks.set_viewport(1, limits)), 51, "{limits:?}");
        assert_eq!(number(gks.set_workstation_window(1, limits)), 51, "{limits:?}");
        assert_eq!(number(gks.set_workstation_viewport(1, Rect::from(limits))), 51, "{limits:?}");
    }
    assert_eq!(number(gks.set_viewport(1, [0.0, 1.1, 0.0, 1.0])), 52);
    assert_eq!(number(gks.set_workstation_window(1, [0.0, 1.0, -0.1, 1.0])), 53);
    assert_eq!(number(gks.set_workstation_viewport(1, [0.0, 1e3, 0.0, 1.0])), 54);
    for transformation in [0, -1, 100_000] {
        assert_eq!(number(gks.set_window(transformation, [0.0, 1.0, 0.0, 1.0])), 50);
    }
    // What was refused has changed nothing.
    let kept = gks.inquire_normalization_transformation(1).unwrap();
    assert_eq!((kept.window, kept.viewport), (Rect::UNIT, Rect::UNIT));
    // Windows that are proper but extreme draw without harm.
    for size in [1e-300, 1e-30, 1e30, 1e300] {
        gks.set_window(1, [-size, size, -size, size]).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        primitives_with(&mut gks, size, -size / 2.0).unwrap();
    }
}

#[test]
fn a_polyline_of_a_million_points_is_drawn_on_every_device() {
    let points: Vec<(f64, f64)> = (0..1_000_000)
        .map(|i| (f64::from(i) / 1e6, 0.5 + 0.4 * (f64::from(i) * 0.001).sin() * (f64::from(i) * 1.3).cos()))
        .collect();
    let folder = folder("million");
    for (kind, name, extension) in file_types() {
        let file = folder.file(&format!("{name}.{extension}"));
        let mut gks = Gks::open(Box::new(drivers()));
        gks.open_workstation(1, &file, kind).unwrap();
        gks.activate_workstation(1).unwrap();
        gks.polyline(&points).unwrap();
        gks.deactivate_workstation(1).unwrap();
        gks.close_workstation(1).unwrap();
        let bytes = fs::metadata(&file).unwrap().len();
        assert!((1000..100_000_000).contains(&bytes), "{name}: {bytes} bytes");
        check(name, &file, extension);
        fs::remove_file(&file).unwrap();
    }
}

#[test]
fn strings_may_be_empty_or_hold_control_characters() {
    let folder = folder("strings");
    let strings =
        ["", " ", "\0", "a\0b", "tab\tline\nreturn\r", "\u{1b}[31m", "\u{7f}\u{80}\u{9f}", "<&>\"'\\()%{}"];
    let further = ["\u{feff}\u{202e}\u{fffe}", "\u{10ffff}\u{e000}", "\u{301}\u{301}\u{301}", "\u{200d}"];
    for (kind, name, extension) in file_types() {
        let file = folder.file(&format!("{name}.{extension}"));
        let mut gks = Gks::open(Box::new(drivers()));
        gks.open_workstation(1, &format!("{file}?size=100x100"), kind).unwrap();
        gks.activate_workstation(1).unwrap();
        for font in [1, -7, -21, -33] {
            gks.set_text_font_and_precision(font, Precision::Stroke).unwrap();
            for path in [TextPath::Right, TextPath::Left, TextPath::Up, TextPath::Down] {
                gks.set_text_path(path).unwrap();
                for text in strings.iter().chain(&further) {
                    gks.text((0.5, 0.5), text).unwrap_or_else(|error| panic!("{name} {text:?}: {error}"));
                }
                gks.text((0.5, 0.5), &"long ".repeat(200)).unwrap();
            }
        }
        gks.message(1, "a\0b").unwrap();
        gks.deactivate_workstation(1).unwrap();
        gks.close_workstation(1).unwrap();
        if extension == "svg" {
            let text = fs::read_to_string(&file).expect("SVG is UTF-8");
            let forbidden =
                |c: char| c.is_control() && !"\t\n\r".contains(c) || "\u{fffe}\u{ffff}".contains(c);
            assert_eq!(text.chars().find(|&c| forbidden(c)), None);
        }
        check(name, &file, extension);
    }
}

/// Has a file judged by a reader of its format where there is one.
fn check(name: &str, file: &str, extension: &str) {
    let judged = match extension {
        "svg" if reader::present(name, &["xmllint"]) => {
            reader::run(60, "xmllint", &["--noout", "--nonet", file])
        }
        "pdf" if reader::present(name, &["qpdf"]) => reader::run(60, "qpdf", &["--check", file]),
        "ps" | "eps" if reader::present(name, &["gs"]) => {
            reader::run(60, "gs", &["-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=nullpage", file])
        }
        _ => return,
    };
    judged.unwrap_or_else(|said| panic!("{name}: {said}"));
}

#[test]
fn files_that_cannot_be_opened_are_error_26_and_leave_nothing() {
    let folder = folder("unwritable");
    fs::create_dir(folder.file("directory")).unwrap();
    for (kind, name, extension) in file_types() {
        let mut gks = Gks::open(Box::new(drivers()));
        for file in [
            folder.file(&format!("missing/picture.{extension}")),
            folder.file("directory"),
            folder.file("new/"),
            folder.file(&format!("{}.{extension}", "long".repeat(200))),
        ] {
            assert_eq!(number(gks.open_workstation(1, &file, kind)), 26, "{name}: {file}");
        }
        let file = folder.file(&format!("picture.{extension}"));
        for options in ["size=0x0", "size=1e99x1", "colour=red", "dpi=x", "size"] {
            let connection = format!("{file}?{options}");
            assert_eq!(number(gks.open_workstation(1, &connection, kind)), 21, "{name}: {connection}");
        }
        assert_eq!(folder.names(), ["directory"], "{name}");
        // The identifier is still free.
        gks.open_workstation(1, &file, kind).unwrap();
        gks.close_workstation(1).unwrap();
        assert_eq!(folder.names(), ["directory", &format!("picture.{extension}")], "{name}");
        fs::remove_file(file).unwrap();
    }
}

#[test]
fn an_unfinished_picture_does_not_appear_under_its_name() {
    let folder = folder("unfinished");
    for (kind, name, extension) in file_types() {
        let file = folder.file(&format!("picture.{extension}"));
        fs::write(&file, "what was there before").unwrap();
        let mut gks = Gks::open(Box::new(drivers()));
        gks.open_workstation(1, &file, kind).unwrap();
        gks.activate_workstation(1).unwrap();
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"what was there before", "{name}");
        drop(gks);
        let left: Vec<String> = folder.names();
        assert_eq!(left, [format!("picture.{extension}")], "{name}");
        fs::remove_file(&file).unwrap();
    }
}

#[test]
fn a_full_disk_is_error_303_and_the_program_goes_on() {
    let folder = folder("full");
    let file = folder.file("picture.png");
    for (kind, name, _) in file_types() {
        let mut gks = Gks::open(Box::new(drivers()));
        gks.open_workstation(1, "/dev/full?size=200x200", kind).unwrap();
        gks.open_workstation(2, &format!("{file}?size=200x200"), own::PNG).unwrap();
        gks.activate_workstation(1).unwrap();
        gks.activate_workstation(2).unwrap();
        let mut errors: Vec<i32> = Vec::new();
        let zigzag: Vec<(f64, f64)> =
            (0..50).map(|i| (f64::from(i) / 49.0, 0.5 + 0.3 * f64::from(i % 2))).collect();
        for _ in 0..400 {
            errors.push(number(gks.polyline(&zigzag)));
        }
        gks.deactivate_workstation(1).unwrap();
        errors.push(number(gks.close_workstation(1)));
        assert!(errors.contains(&303), "{name}: the full disk was not told");
        assert!(errors.iter().all(|&error| error == 0 || error == 303), "{name}: {errors:?}");
        assert_eq!(number(gks.close_workstation(1)), 25, "{name}: still open");
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        gks.deactivate_workstation(2).unwrap();
        gks.close_workstation(2).unwrap();
        gks.open_workstation(1, &file, own::PNG).unwrap();
        gks.close_workstation(1).unwrap();
        gks.close_gks().unwrap();
    }
}

#[test]
fn unknown_workstation_types_are_refused() {
    let mut gks = Gks::open(Box::new(drivers()));
    for kind in [4, 99, 106, 899, 901, 31_999, i32::MAX] {
        assert_eq!(number(gks.open_workstation(1, "", kind)), 23, "type {kind}");
    }
    for kind in [-1, i32::MIN] {
        assert_eq!(number(gks.open_workstation(1, "", kind)), 22, "type {kind}");
    }
    for id in [0, -1, i32::MIN] {
        assert_eq!(number(gks.open_workstation(id, "", own::NULL)), 20, "identifier {id}");
    }
}

#[test]
fn indices_that_mean_nothing_are_refused_or_replaced() {
    let mut gks = active();
    assert_eq!(number(gks.set_polyline_colour_index(-1)), 92);
    assert_eq!(number(gks.set_polymarker_colour_index(-1)), 92);
    assert_eq!(number(gks.set_text_colour_index(i32::MIN)), 92);
    assert_eq!(number(gks.set_fill_area_colour_index(-7)), 92);
    assert_eq!(number(gks.set_colour_representation(1, -1, Colour::BLACK)), 93);
    assert_eq!(number(gks.set_colour_representation(1, i32::MAX, Colour::BLACK)), 93);
    assert_eq!(number(gks.set_colour_representation(1, 1, Colour::rgb(2.0, 0.0, 0.0))), 96);
    assert_eq!(number(gks.set_colour_representation(1, 1, Colour::rgb(f32::NAN, 0.0, 0.0))), 96);
    assert_eq!(number(gks.set_colour_alpha(1, 60_000, 0.5)), 94);
    assert_eq!(number(gks.set_linetype(0)), 63);
    assert_eq!(number(gks.set_marker_type(0)), 69);
    assert_eq!(number(gks.set_text_font_and_precision(0, Precision::Char)), 75);
    assert_eq!(number(gks.set_fill_area_style_index(0)), 84);
    for nothing in [0, -1, i32::MIN] {
        assert_eq!(number(gks.set_polyline_index(nothing)), 60);
        assert_eq!(number(gks.set_polymarker_index(nothing)), 66);
        assert_eq!(number(gks.set_text_index(nothing)), 72);
        assert_eq!(number(gks.set_fill_area_index(nothing)), 80);
    }
    for value in [f64::NAN, f64::INFINITY, -1.0] {
        assert_eq!(number(gks.set_linewidth_scale_factor(value)), 65);
        assert_eq!(number(gks.set_marker_size_scale_factor(value)), 71);
        assert_eq!(number(gks.set_character_expansion_factor(value)), 77);
        assert_eq!(number(gks.set_character_height(value)), 78);
        assert_eq!(number(gks.set_pattern_size(value, 1.0)), 87);
    }
    assert_eq!(number(gks.set_character_up_vector((0.0, 0.0))), 79);
    assert_eq!(number(gks.set_character_up_vector((f64::NAN, 1.0))), 79);
    assert_eq!(number(gks.set_text_representation(1, 1, 999, Precision::Char, 1.0, 0.0, 1)), 76);
    // Indices that no workstation has are accepted and drawn as another one.
    for index in [61, 4000, 65_535, 70_000, i32::MAX] {
        gks.set_polyline_colour_index(index).unwrap();
        gks.set_polymarker_colour_index(index).unwrap();
        gks.set_text_colour_index(index).unwrap();
        gks.set_fill_area_colour_index(index).unwrap();
        gks.set_linetype(index).unwrap();
        gks.set_marker_type(index).unwrap();
        gks.set_text_font_and_precision(index, Precision::Char).unwrap();
        gks.set_fill_area_style_index(index).unwrap();
        primitives_with(&mut gks, 0.3, 0.4).unwrap();
        gks.set_text_font_and_precision(-index, Precision::Char).unwrap();
        gks.set_linetype(-index).unwrap();
        gks.set_marker_type(-index).unwrap();
        gks.set_polyline_index(index).unwrap();
        gks.set_polymarker_index(index).unwrap();
        gks.set_text_index(index).unwrap();
        gks.set_fill_area_index(index).unwrap();
        primitives_with(&mut gks, 0.3, 0.4).unwrap();
        gks.set_aspect_source_flags(AspectSourceFlags::BUNDLED).unwrap();
        primitives_with(&mut gks, 0.3, 0.4).unwrap();
        gks.set_aspect_source_flags(AspectSourceFlags::INDIVIDUAL).unwrap();
    }
}

#[test]
fn arrays_without_cells_and_primitives_without_points_are_refused() {
    let mut gks = active();
    let cells = [1, 2, 3, 4, 5, 6];
    for (columns, rows, stride) in [
        (0, 0, 0),
        (0, 1, 1),
        (1, 0, 1),
        (3, 2, 2),
        (3, 3, 3),
        (7, 1, 7),
        (usize::MAX, usize::MAX, usize::MAX),
    ] {
        let drawn = gks.cell_array_of((0.0, 0.0), (1.0, 1.0), &cells, columns, rows, stride);
        assert_eq!(number(drawn), 91, "{columns} x {rows}");
        let kept = gks.set_pattern_representation_of(1, 1, &cells, columns, rows, stride);
        assert_eq!(number(kept), 91, "{columns} x {rows}");
    }
    // A rectangle without an area, and colour indices that mean nothing.
    gks.cell_array_of((0.5, 0.5), (0.5, 0.5), &cells, 3, 2, 3).unwrap();
    gks.cell_array_of((0.5, 0.1), (0.5, 0.9), &cells, 3, 2, 3).unwrap();
    gks.cell_array_of((0.1, 0.1), (0.9, 0.9), &[-1, i32::MIN, i32::MAX, 70_000], 2, 2, 2).unwrap();
    let none: [(f64, f64); 0] = [];
    assert_eq!(number(gks.polyline(&none)), 100);
    assert_eq!(number(gks.polyline(&[(0.0, 0.0)])), 100);
    assert_eq!(number(gks.polymarker(&none)), 100);
    assert_eq!(number(gks.fill_area(&[(0.0, 0.0), (1.0, 1.0)])), 100);
    assert_eq!(number(gks.generalized_drawing_primitive(&none, -1, &DataRecord::default())), 100);
}

#[test]
fn the_size_of_a_surface_is_limited_before_memory_is_taken() {
    let mut gks = Gks::open(Box::new(drivers()));
    for kind in [own::FRAMEBUFFER, own::FRAMEBUFFER8, own::NULL] {
        for size in ["32768x1", "32767x32767", "0x5", "-1x5", "99999999999999999999x1"] {
            assert_eq!(number(gks.open_workstation(1, &format!("?size={size}"), kind)), 21, "{kind}: {size}");
        }
    }
}

/// Values for real arguments, mostly good ones.
fn real(random: &mut Random) -> f64 {
    const ODD: [f64; 14] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e30,
        -1e30,
        1e-300,
        f64::MAX,
        f64::MIN_POSITIVE,
        1e9,
        -37.5,
    ];
    if random.below(8) == 0 { random.of(&ODD) } else { random.unit() * 1.4 - 0.2 }
}

/// Values for whole arguments, mostly small ones.
fn whole(random: &mut Random) -> i32 {
    if random.below(10) == 0 {
        random.of(&[i32::MIN, i32::MAX, -100, 255, 256, 65_535, 65_536])
    } else {
        random.below(14) as i32 - 4
    }
}

/// One call of a function chosen at random, with arguments chosen at random.
fn call(gks: &mut Gks, random: &mut Random) -> Result<()> {
    let mut points = [(0.0, 0.0); 9];
    for point in &mut points {
        *point = (real(random), real(random));
    }
    let points = &points[..random.below(10)];
    let limits = [real(random), real(random), real(random), real(random)];
    let (x, y, i, j) = (real(random), real(random), whole(random), whole(random));
    let ws = 1 + random.below(5) as i32;
    let precision = random.of(&[Precision::String, Precision::Char, Precision::Stroke]);
    let style = random.of(&STYLES);
    let text =
        random.of(&["", "a", "Text\0", "größer", "∫ ± \u{301}", "مرحبا", "0123456789 abcdefghi", "\n"]);
    let cells: [i32; 12] = std::array::from_fn(|_| whole(random));
    let (columns, rows, stride) = (random.below(5), random.below(5), random.below(6));
    match random.below(58) {
        0 => gks.open_workstation(ws, "?size=120x90", random.of(&[120, 121, 900, i.min(-1)])),
        1 => gks.close_workstation(ws),
        2..=5 => gks.activate_workstation(ws),
        6 => gks.deactivate_workstation(ws),
        7 => gks.clear_workstation(ws, random.below(2) == 0),
        8 => gks.update_workstation(ws, random.below(2) == 0),
        9 => gks.message(ws, text),
        10 => gks.set_window(i, limits),
        11 => gks.set_viewport(i, limits),
        12 => gks.select_normalization_transformation(i),
        13 => gks.set_clipping_indicator(random.below(2) == 0),
        14 => gks.set_workstation_window(ws, limits),
        15 => gks.set_workstation_viewport(ws, limits),
        16 => gks.set_linetype(i),
        17 => gks.set_linewidth_scale_factor(x * random.of(&[1.0, 50.0])),
        18 => gks.set_polyline_colour_index(i),
        19 => gks.set_polyline_index(i),
        20 => gks.set_marker_type(i),
        21 => gks.set_marker_size_scale_factor(x * random.of(&[1.0, 50.0])),
        22 => gks.set_polymarker_colour_index(i),
        23 => gks.set_polymarker_index(i),
        24 => gks.set_text_font_and_precision(random.of(&[i, i.wrapping_mul(7), -21, -34, 1]), precision),
        25 => gks.set_character_height(x * random.of(&[1.0, 0.05])),
        26 => gks.set_character_up_vector((x, y)),
        27 => gks.set_character_expansion_factor(x),
        28 => gks.set_character_spacing(x),
        29 => gks.set_text_path(random.of(&[TextPath::Right, TextPath::Left, TextPath::Up, TextPath::Down])),
        30 => gks.set_text_alignment(
            random.of(&[Horizontal::Normal, Horizontal::Left, Horizontal::Centre, Horizontal::Right]),
            random.of(&[Vertical::Normal, Vertical::Top, Vertical::Cap, Vertical::Half, Vertical::Bottom]),
        ),
        31 => gks.set_text_colour_index(i),
        32 => gks.set_text_index(i),
        33 => gks.set_fill_area_interior_style(style),
        34 => gks.set_fill_area_style_index(i),
        35 => gks.set_fill_area_colour_index(i),
        36 => gks.set_fill_area_index(i),
        37 => gks.set_pattern_size(x, y),
        38 => gks.set_pattern_reference_point((x, y)),
        39 => gks.set_line_cap(random.of(&[Cap::Butt, Cap::Round, Cap::Projecting])),
        40 => gks.set_line_join(random.of(&[Join::Miter, Join::Round, Join::Bevel])),
        41 => gks.set_aspect_source_flags(AspectSourceFlags::from_array(std::array::from_fn(|_| {
            random.below(3) > 0
        }))),
        42 => gks.set_polyline_representation(ws, i, j, x, whole(random)),
        43 => gks.set_polymarker_representation(ws, i, j, x, whole(random)),
        44 => gks.set_text_representation(ws, i, j, precision, x, y, whole(random)),
        45 => gks.set_fill_area_representation(ws, i, style, j, whole(random)),
        46 => gks.set_pattern_representation_of(ws, i, &cells, columns, rows, stride),
        47 => gks.set_colour_representation(ws, i, Colour::rgb(x as f32, y as f32, 0.5)),
        48 => gks.set_colour_alpha(ws, i, x),
        49 => gks.escape(-3000 - random.below(7) as i32, &DataRecord::new(&[i, j], &[x], &[])).map(drop),
        50 => gks.cell_array_of((x, y), (limits[0], limits[1]), &cells, columns, rows, stride),
        51 => gks.text((x, y), text),
        52 => gks.polymarker(points),
        53 => gks.fill_area(points),
        54 | 55 => {
            gks.generalized_drawing_primitive(points, -1 - random.below(12) as i32, &DataRecord::default())
        }
        _ => gks.polyline(points),
    }
}

#[test]
fn no_sequence_of_calls_panics_or_hangs() {
    for seed in 1..=8 {
        within(300, &format!("seed {seed}"), move || {
            let mut random = Random::new(seed);
            let mut gks = Gks::open(Box::new(drivers()));
            let mut refused = 0;
            for (id, kind) in [(1, own::FRAMEBUFFER), (2, own::FRAMEBUFFER8), (3, own::NULL)] {
                gks.open_workstation(id, "?size=120x90", kind).unwrap();
            }
            const CALLS: usize = 2000;
            for _ in 0..CALLS {
                if let Err(error) = call(&mut gks, &mut random) {
                    refused += 1;
                    assert_ne!(error.text(), "unknown error", "seed {seed}: {error}");
                    assert_ne!(error.number, 303, "seed {seed}: {error}");
                }
            }
            // Most calls are good enough to do something.
            assert!(refused < CALLS * 2 / 3, "seed {seed}: {refused} calls refused");
            gks.emergency_close_gks();
        });
    }
}
