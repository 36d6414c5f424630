//! Metafiles written and read again, whole and damaged.

use super::character::decoder::CharacterDecoder;
use super::decoder::Decoder;
use super::element::{Element, Value};
use super::encoder::Coordinates;
use super::recorder::Settings;
use super::{Encoding, count_binary, count_character, count_text, create, open};
use crate::generated::elements::Kind;
use gks_geometry::{Ndc, PathBuf, Point, Rect, Vector};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::Sink;
use gks_pipeline::item::{Cells, Closure, Curve, Ellipse, Item, Parallelogram, Role, Shape};
use gks_pipeline::look::{Aspect, AspectSourceFlags, InteriorStyle, LineBundle, Look, Precision};
use gks_pipeline::look_difference::State;
use gks_pipeline::record::{Record, Recorder, Source};
use glam::DVec2;
use std::io;
use std::sync::{Arc, Mutex};

struct Shared(Arc<Mutex<Vec<u8>>>);

impl Sink for Shared {
    fn open(&mut self) -> io::Result<()> {
        Ok(())
    }
    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.0.lock().expect("nobody panicked").extend_from_slice(bytes);
        Ok(())
    }
    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

const ENCODINGS: [Encoding; 4] = [Encoding::Binary, Encoding::Text, Encoding::Character, Encoding::Ncgm];

/// Two pictures with every kind of primitive.
fn written(encoding: Encoding, coordinates: Option<Coordinates>) -> Vec<u8> {
    let bytes = Arc::new(Mutex::new(Vec::new()));
    let sink = Box::new(Shared(Arc::clone(&bytes)));
    let mut recorder = create(sink, encoding, coordinates, Settings::default());
    draw(&mut *recorder);
    recorder.control(&Record::Clear { always: true }).expect("the sink takes all");
    recorder.control(&Record::WorkstationWindow(Rect::new(0.25, 0.75, 0.25, 0.5))).expect("a window");
    draw(&mut *recorder);
    recorder.close().expect("the sink takes all");
    let bytes = bytes.lock().expect("nobody panicked");
    bytes.clone()
}

fn draw(recorder: &mut dyn Recorder) {
    let mut look = Look::default();
    let put = |recorder: &mut dyn Recorder, shape: Shape<'_>, look: &Look| {
        let clip = Rect::new(0.1, 0.9, 0.0, 1.0);
        recorder.draw(&Item { shape, look, clip, pick: 0 }).expect("the sink takes all");
    };
    recorder.control(&Record::ColourRepresentation(3, Colour::rgb(0.2, 0.4, 0.6))).expect("a colour");
    recorder
        .control(&Record::LineRepresentation(7, LineBundle { linetype: 2, width: 3.0, colour: 3 }))
        .expect("a bundle");
    let mut flags = [true; 13];
    flags[Aspect::Linewidth as usize] = false;
    look.sources = AspectSourceFlags::from_array(flags);
    look.line_index = 7;
    look.line.colour = 3;
    let mut paths = PathBuf::<Ndc>::new();
    paths.add([DVec2::new(0.125, 0.25), DVec2::new(0.5, 0.75), DVec2::new(0.875, 0.25)]);
    put(recorder, Shape::Polyline(paths.as_paths()), &look);
    put(recorder, Shape::Polymarker(&paths.points), &look);
    look.text.font = -26;
    look.text.precision = Precision::Stroke;
    look.text_geometry.height = Vector::new(-0.03, 0.04);
    look.text_geometry.width = Vector::new(0.08, 0.06);
    put(recorder, Shape::Text(Point::new(0.5, 0.5), "Größe π 'x'"), &look);
    look.fill.interior = InteriorStyle::Pattern;
    look.pattern.width = Vector::new(0.125, 0.0);
    look.pattern.height = Vector::new(0.0, 0.25);
    put(recorder, Shape::FillArea(paths.as_paths()), &look);
    paths.add([DVec2::new(0.25, 0.25), DVec2::new(0.5, 0.5), DVec2::new(0.5, 0.25)]);
    put(recorder, Shape::FillArea(paths.as_paths()), &look);
    let place = Parallelogram {
        origin: Point::new(0.25, 0.25),
        columns: Vector::new(0.5, 0.0),
        rows: Vector::new(0.0, 0.25),
    };
    let cells = Cells::new(&[1, 2, 3, 4, 5, 6], 3, 2, 3).expect("six cells");
    put(recorder, Shape::CellArray(place, cells), &look);
    let mut e = Ellipse {
        centre: Point::new(0.5, 0.5),
        a: Vector::new(0.25, 0.0),
        b: Vector::new(0.0, 0.25),
        start: 0.5,
        sweep: 1.0,
        closure: Closure::Pie,
    };
    put(recorder, Shape::Generalized(Curve::Ellipse(e), Role::Area), &look);
    (e.b, e.sweep, e.closure) = (Vector::new(0.125, 0.125), -1.0, Closure::Open);
    put(recorder, Shape::Generalized(Curve::Ellipse(e), Role::Line), &look);
}

/// What is read, in words with few digits, and the state with which each primitive is drawn.
fn read(source: &mut dyn Source) -> (Vec<String>, Vec<State>) {
    let (mut all, mut states, mut state) = (Vec::new(), Vec::new(), State::default());
    let points = |points: &[DVec2]| {
        points.iter().map(|p| format!("{:.3} {:.3}", p.x, p.y)).collect::<Vec<_>>().join(", ")
    };
    while let Some(record) = source.next().expect("it is sound") {
        let words = match record {
            Record::Attribute(attribute) => {
                state.set(attribute);
                continue;
            }
            Record::Primitive(shape) => {
                states.push(state.clone());
                match shape {
                    Shape::Polyline(paths) => format!("lines {}", points(paths.points)),
                    Shape::Polymarker(at) => format!("markers {}", points(at)),
                    Shape::Text(at, text) => format!("text {} {text}", points(&[at.0])),
                    Shape::FillArea(rings) => format!("area {} {:?}", points(rings.points), rings.ends),
                    Shape::CellArray(place, cells) => {
                        let corners = place.corners().map(|corner| corner.0);
                        format!("cells {} {:?} {:?}", points(&corners), cells.row(0), cells.row(1))
                    }
                    Shape::Generalized(Curve::Ellipse(e), role) => {
                        let ends = [e.at(e.start).0, e.at(e.start + e.sweep).0];
                        format!("{role:?} {:?} {}", e.closure, points(&ends))
                    }
                    Shape::Generalized(..) => "curve".to_owned(),
                }
            }
            Record::Clear { .. } => "clear".to_owned(),
            Record::WorkstationWindow(window) => format!("window {:?}", window.limits()),
            _ => continue,
        };
        all.push(words);
    }
    (all, states)
}

#[test]
fn every_encoding_gives_back_what_was_drawn() {
    let expected = [
        "clear",
        "window [0.0, 1.0, 0.0, 1.0]",
        "lines 0.125 0.250, 0.500 0.750, 0.875 0.250",
        "markers 0.125 0.250, 0.500 0.750, 0.875 0.250",
        "text 0.500 0.500 Größe π 'x'",
        "area 0.125 0.250, 0.500 0.750, 0.875 0.250 [3]",
        "area 0.125 0.250, 0.500 0.750, 0.875 0.250, 0.250 0.250, 0.500 0.500, 0.500 0.250 [3, 6]",
        "cells 0.250 0.250, 0.750 0.250, 0.750 0.500, 0.250 0.500 [1, 2, 3] [4, 5, 6]",
        "Area Pie 0.719 0.620, 0.518 0.749",
        // In negative direction, which dashes would show.
        "Line Open 0.779 0.560, 0.659 0.440",
    ];
    for encoding in ENCODINGS {
        for coordinates in [None, Some(Coordinates::Integer16), Some(Coordinates::Real)] {
            let bytes = written(encoding, coordinates);
            assert_eq!(Encoding::of(&bytes), Some(encoding));
            let (all, states) = read(&mut *open(io::Cursor::new(bytes), encoding));
            if encoding == Encoding::Ncgm {
                // Several rings are one, curves are chords.
                assert_eq!(all[..6], expected[..6]);
                assert!(all[6].ends_with("[9]") && all[8].starts_with("area") && all[9].starts_with("lines"));
            } else {
                assert_eq!(all[..10], expected, "{encoding:?}");
            }
            let line = states[0].look.line;
            assert_eq!((line.linetype, line.width, line.colour), (1, 3.0, 3), "{encoding:?}");
            assert_eq!(states[2].look.text.font, -26);
            let geometry = &states[2].look.text_geometry;
            assert!((geometry.height.0 - DVec2::new(-0.03, 0.04)).length() < 1e-4, "{encoding:?}");
            assert!((geometry.width.0 - DVec2::new(0.08, 0.06)).length() < 1e-4, "{encoding:?}");
            let pattern = &states[3].look.pattern;
            assert!((pattern.height.0 - DVec2::new(0.0, 0.25)).length() < 1e-4, "{encoding:?}");
            let clip = states[0].clip;
            assert!((clip.min.x() - 0.1).abs() < 1e-4 && (clip.max.x() - 0.9).abs() < 1e-4, "{encoding:?}");
            // The window of the second picture is half as wide as the first, and fills the square in x.
            assert_eq!(all[10], "clear");
            assert_eq!(all[11], "lines -0.250 0.000, 0.500 1.000, 1.250 0.000", "{encoding:?}");
            let clip = states[8].clip;
            assert!((clip.max.y() - 0.5).abs() < 1e-4 && clip.min.x().abs() < 1e-4, "{clip:?}");
        }
    }
}

/// A pseudo random number: Marsaglia, "Xorshift RNGs", 2003.
fn random(state: &mut u64) -> u64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    *state
}

#[test]
fn damaged_metafiles_neither_panic_nor_hang() {
    let mut seed = 0x1234_5678_9abc_def1;
    for encoding in ENCODINGS {
        let whole = written(encoding, None);
        for round in 0..300 {
            let mut bytes = whole.clone();
            for _ in 0..=random(&mut seed) % 8 {
                let at = random(&mut seed) as usize % bytes.len();
                match round % 3 {
                    0 => bytes[at] = random(&mut seed) as u8,
                    1 => bytes.truncate(at.max(1)),
                    _ => {
                        let other = random(&mut seed) as usize % bytes.len();
                        bytes.swap(at, other);
                    }
                }
            }
            count_binary(&bytes);
            count_text(&bytes);
            count_character(&bytes);
            let mut source = open(io::Cursor::new(bytes), encoding);
            super::count(&mut *source);
        }
    }
}

#[test]
fn a_count_without_data_is_not_believed() {
    // A cell array of 30000 by 30000 with one run in it, and a polygon whose partition is not there.
    let mut bytes = written(Encoding::Binary, None);
    bytes.truncate(bytes.len() - 4);
    let mut cells = vec![0; 24];
    cells.extend([0x75, 0x30, 0x75, 0x30, 0, 8, 0, 0, 0x75, 0x30, 1, 0]);
    bytes.extend([0x41, 0x3f, 0, cells.len() as u8]);
    bytes.extend(cells);
    bytes.extend([0x40, 0xff, 0xff, 0xff, 1, 2, 3]);
    let mut source = open(io::Cursor::new(bytes), Encoding::Binary);
    assert!(std::iter::from_fn(|| source.next().ok().flatten().map(|_| ())).count() > 50);
}

/// What a source has skipped, and how many records it gave.
fn skipped(bytes: &'static [u8], encoding: Encoding) -> (Vec<(String, u64)>, usize) {
    let mut source = open(bytes, encoding);
    let mut records = 0;
    while source.next().expect("nothing is malformed").is_some() {
        records += 1;
    }
    (source.skipped().iter().map(|(name, count)| (name.to_owned(), count)).collect(), records)
}

#[test]
fn what_is_skipped_is_told() {
    let text =
        b"BEGMF 'a'; BEGPIC 'b'; BEGPICBODY; BOGUS 1; bogus 2; LINE (0,0) (1,1); COPYSEG 7; MITRELIMIT 3; TEXTSCORETYPE 1 1;";
    let (names, records) = skipped(text, Encoding::Text);
    let wanted = [
        ("COPY SEGMENT with senseless parameters", 1),
        ("MITRE LIMIT", 1),
        ("TEXT SCORE TYPE", 1),
        ("unknown element bogus", 2),
    ];
    assert_eq!(names, wanted.map(|(name, count)| (name.to_owned(), count)));
    assert!(records > 0, "the line is drawn");
    // Class 4, identifier 99, without parameters.
    let (names, _) = skipped(b"\x00\x21\x00\x00\x4c\x60\x00\x40", Encoding::Binary);
    assert_eq!(names, [("unknown element 4/99".to_owned(), 1)]);
    // POLYLINE with points in chain code.
    let (names, _) = skipped(b"0 \x1bXa\x1b\\0\"\x1bXb\x1b\\0#1\"A @@\x50AA0!", Encoding::Character);
    assert!(names.iter().any(|(name, _)| name == "points in chain code"), "{names:?}");
}

#[test]
fn version_3_says_how_our_own_linetypes_are_dashed() {
    let written = |version: u8, encoding: Encoding| {
        let bytes = Arc::new(Mutex::new(Vec::new()));
        let sink = Box::new(Shared(Arc::clone(&bytes)));
        let mut recorder = create(sink, encoding, None, Settings { version, ..Settings::default() });
        let mut look = Look::default();
        look.line.linetype = -4;
        let mut paths = PathBuf::<Ndc>::new();
        paths.add([DVec2::ZERO, DVec2::X]);
        let shape = Shape::Polyline(paths.as_paths());
        recorder.draw(&Item { shape, look: &look, clip: Rect::UNIT, pick: 0 }).expect("the sink takes all");
        recorder.close().expect("the sink takes all");
        bytes.lock().expect("nobody panicked").clone()
    };
    let linetype = |bytes: Vec<u8>, encoding: Encoding| {
        let (all, states) = read(&mut *open(io::Cursor::new(bytes), encoding));
        (all.last().cloned().unwrap_or_default(), states[0].look.line.linetype)
    };
    for encoding in [Encoding::Binary, Encoding::Text] {
        let line = "lines 0.000 0.000, 1.000 0.000".to_owned();
        assert_eq!(linetype(written(3, encoding), encoding), (line, -4), "{encoding:?}");
    }
    let text = |version| String::from_utf8(written(version, Encoding::Text)).expect("clear text");
    assert!(!text(1).contains("LINEEDGETYPEDEF"), "{}", text(1));
    let text = text(3);
    assert!(text.contains("LINEEDGETYPEDEF -4 42 12 6 2 6 2 6 2 6;"), "{text}");
    // What a reader draws that knows nothing of our linetypes.
    let text = text.replace("TYPEDEF -4 ", "TYPEDEF -40 ").replace("LINETYPE -4;", "LINETYPE -40;");
    let (words, linetype) = linetype(text.into_bytes(), Encoding::Text);
    assert!(words.starts_with("lines 0.000 0.000, 0.012 0.000, 0.018 0.000, 0.020 0.000, "), "{words}");
    assert_eq!(linetype, 1);
}

#[test]
fn no_more_colours_are_written_than_may_be() {
    let bytes = Arc::new(Mutex::new(Vec::new()));
    let sink = Box::new(Shared(Arc::clone(&bytes)));
    let settings = Settings { colours: Some(100), ..Settings::default() };
    let mut recorder = create(sink, Encoding::Text, None, settings);
    recorder.control(&Record::ColourRepresentation(99, Colour::rgb(1.0, 0.0, 0.0))).expect("a colour");
    recorder.control(&Record::ColourRepresentation(200, Colour::rgb(0.99, 0.0, 0.0))).expect("a colour");
    draw(&mut *recorder);
    recorder.close().expect("the sink takes all");
    let text = String::from_utf8(bytes.lock().expect("nobody panicked").clone()).expect("clear text");
    assert!(text.contains("MAXCOLRINDEX 99;"), "{text}");
    let tables = text.split(';').filter_map(|element| element.trim().strip_prefix("COLRTABLE "));
    let ends: Vec<usize> = tables
        .map(|table| table.split_whitespace().map(|word| word.parse().expect("a number")).collect())
        .map(|numbers: Vec<usize>| numbers[0] + (numbers.len() - 1) / 3)
        .collect();
    assert_eq!(ends.iter().max(), Some(&100), "{ends:?}");
}

#[test]
fn names_that_are_invented_do_not_fill_the_memory() {
    let mut skipped = gks_pipeline::record::Skipped::default();
    (0..1000).for_each(|i| skipped.add(&i.to_string()));
    assert_eq!((skipped.count(), skipped.iter().count()), (1000, 65));
}

#[test]
fn formats_are_told_apart() {
    assert_eq!(Encoding::of(b"% note % beg_mf 'x';"), Some(Encoding::Text));
    assert_eq!(Encoding::of(&[0, 0, 0, 0x22, 1, b'A']), Some(Encoding::Binary));
    assert_eq!(Encoding::of(b"0 \x1bXname\x1b\\"), Some(Encoding::Character));
    for other in [&b""[..], b"\x89PNG\r\n", b"GKSM", b"0 1 2", b"BEGIN", &[0; 64]] {
        assert_eq!(Encoding::of(other), None, "{other:?}");
    }
}

/// Control characters, spaces and tildes in substitutes, the terminator of their list among them or as it is; a width
/// of 2048 units of the precision that holds where none is stated.
#[test]
fn storage_for_runs_is_not_set_aside_twice() {
    let mut list = Vec::new();
    (0..1000).for_each(|_| super::element::repeat(&mut list, 7_u32, 990, 1_000_000));
    assert_eq!((list.len(), list.capacity()), (990_000, 1_000_000));
    super::element::repeat(&mut list, 7, 200_000, 1_000_000);
    assert_eq!(list.len(), 1_190_000);
}

#[test]
fn an_opcode_that_is_cut_off_ends_the_metafile() {
    let mut decoder = CharacterDecoder::new(&b"0 ??"[..]);
    assert_eq!(
        decoder.next().expect("BEGIN METAFILE").map(|element| element.kind),
        Some(Kind::BeginMetafile)
    );
    assert_eq!(decoder.next().expect("the end"), None);
}

#[test]
fn characters_may_have_substitutes() {
    for begin in
        [&b"0 ~@~[~\\~`~>~[\\~[Xa~`b~[\\"[..], b"0 ~`~>\x1b\\\x1bXa b\x1b\\", b"0 \x1b\\\x1bXa b\x1b\\"]
    {
        let (space, tilde): (&[u8], &[u8]) =
            if begin.get(2) == Some(&b'~') { (b"~`", b"~>") } else { (b" ", b"~") };
        // LINE WIDTH, POLYLINE from 2, -1 by 1984 up.
        let octets = [begin, b"5\"b`@", space, b"BQ@a", tilde, b"@"].concat();
        let mut decoder = CharacterDecoder::new(&octets[..]);
        let points = [(2.0, -1.0), (2.0, 1983.0)].map(|(x, y)| DVec2::new(x, y));
        for element in [
            Element::new(Kind::BeginMetafile, [Value::Text(b"a b".to_vec())]),
            Element::new(Kind::LineWidth, [Value::Real(2.0)]),
            Element::new(Kind::Polyline, [Value::Points(points.to_vec())]),
        ] {
            assert_eq!(decoder.next().unwrap(), Some(element));
        }
    }
}
