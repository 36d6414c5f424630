//! Metafiles of GKS: what is written is read back to the last bit, what is damaged never ends the program, and
//! what others write is understood.

use gks::Gks;
use gks_metafile::{Format, ReadOptions, open_source};
use gks_pipeline::generated::numbers::workstation_type as own;
use gks_pipeline::record::{Attribute, Record, SourceError};
use gks_tests::drawing::{self, Way, drivers};
use gks_tests::pictures::{PICTURES, Picture, draw_gks};
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;

const SURFACE: &str = "size=400x400";

fn folder() -> PathBuf {
    drawing::folder(env!("CARGO_TARGET_TMPDIR"), "gksm")
}

fn round_trip(picture: &Picture, coding: &str) -> Result<(), String> {
    let options = &format!("&coding={coding}");
    let way = Way { kind: own::GKSM, options, surface: SURFACE, folder: &folder() };
    drawing::round_trip(picture, way, |direct, played| {
        let same = fs::read(direct).ok() == fs::read(played).ok();
        if same { Ok(()) } else { Err("the pictures differ".to_owned()) }
    })
}

#[test]
fn every_picture_survives_binary_coding() {
    let faults: Vec<String> =
        PICTURES.iter().filter_map(|picture| round_trip(picture, "binary").err()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_picture_survives_formatted_coding() {
    let faults: Vec<String> =
        PICTURES.iter().filter_map(|picture| round_trip(picture, "formatted").err()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A small metafile with something of everything.
fn sample(coding: &str) -> Vec<u8> {
    let file = folder().join(format!("sample-{coding}-{:?}.gksm", std::thread::current().id()));
    let connection = format!("{}?coding={coding}", file.display());
    draw_gks(Box::new(drivers()), &connection, own::GKSM, |gks, ws| {
        gks.message(ws, "größer\nund kleiner")?;
        gks.set_colour_representation(ws, 2, (0.25, 0.5, 0.75))?;
        gks.set_colour_alpha(ws, 2, 0.5)?;
        gks.set_pattern_representation_of(ws, 3, &[0, 1, 1, 0], 2, 2, 2)?;
        gks.polyline(&[(0.1, 0.1), (0.9, 0.2), (f64::NAN, 0.0), (0.2, 0.8), (0.3, 0.9)])?;
        gks.text((0.5, 0.5), "Text")?;
        gks.cell_array_of((0.1, 0.1), (0.4, 0.3), &[1, 2, 3, 4, 5, 6], 3, 2, 3)?;
        gks.arc((0.1, 0.5), (0.5, 0.9), (0.9, 0.5))?;
        gks.write_item_to_gksm(ws, 101, b"an item of the program")?;
        gks.clear_workstation(ws, true)?;
        gks.fill_area(&[(0.0, 0.0), (1.0, 0.0), (0.5, 1.0)])
    })
    .expect("a metafile");
    let bytes = fs::read(&file).expect("it has been written");
    let _ = fs::remove_file(file);
    bytes
}

/// What is read from bytes: the records, as far as there are, and the faults.
fn read(bytes: &[u8]) -> (Vec<String>, usize) {
    let (mut records, mut faults) = (Vec::new(), 0);
    let Ok(mut opened) = open_source(Cursor::new(bytes.to_vec()), &ReadOptions::default()) else {
        return (records, 1);
    };
    loop {
        match opened.source.next() {
            Ok(None) => return (records, faults),
            Ok(Some(record)) => records.push(format!("{record:?}")),
            Err(SourceError::Malformed { offset, .. }) => {
                assert!(offset <= bytes.len() as u64);
                faults += 1;
            }
            Err(SourceError::Io(error)) => panic!("{error}"),
        }
        assert!(records.len() + faults <= bytes.len(), "reading does not end");
    }
}

/// Draws whatever can be read, on a small surface.
fn draw(bytes: &[u8]) {
    let Ok(mut opened) = open_source(Cursor::new(bytes.to_vec()), &ReadOptions::default()) else { return };
    let mut gks = Gks::open(Box::new(drivers()));
    gks.open_workstation(1, "?size=32x32", own::FRAMEBUFFER).expect("pixels in memory");
    gks.activate_workstation(1).expect("it is open");
    for _ in 0..1000 {
        match opened.source.next() {
            Ok(None) => break,
            Ok(Some(record)) => drop(gks.interpret(&record)),
            Err(_) => {}
        }
    }
}

#[test]
fn both_codings_hold_the_same() {
    let (binary, formatted) = (read(&sample("binary")), read(&sample("formatted")));
    assert_eq!(binary, formatted);
    let (records, faults) = binary;
    assert_eq!(faults, 0);
    let has = |text: &str| records.iter().any(|record| record.contains(text));
    assert!(has("größer\\nund kleiner") && has("User(101") && has("Clear"));
    assert_eq!(records.iter().filter(|record| record.starts_with("Primitive(Polyline")).count(), 1);
}

#[test]
fn truncated_metafiles_give_what_is_there() {
    for coding in ["binary", "formatted"] {
        let whole = sample(coding);
        let (records, _) = read(&whole);
        for length in 0..whole.len() {
            let (part, faults) = read(&whole[..length]);
            // The line break after the last item is not missed.
            assert!(faults > 0 || length + 1 == whole.len(), "{length} bytes of {coding}");
            // A primitive of several items may be cut too.
            let common = part.iter().zip(&records).take_while(|(a, b)| a == b).count();
            assert!(common + 1 >= part.len(), "{length} bytes of {coding}");
        }
    }
}

#[test]
fn flipped_bits_and_lying_headers_do_no_harm() {
    for coding in ["binary", "formatted"] {
        let whole = sample(coding);
        for at in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[at] ^= 1 << (at % 8);
            read(&damaged);
            if at % 16 == 0 {
                draw(&damaged);
            }
        }
        for at in (54..90).step_by(2) {
            for lie in ["99", " 0", "-1", "  ", " 1", " 2", " 8"] {
                let mut damaged = whole.clone();
                damaged[at..at + 2].copy_from_slice(lie.as_bytes());
                read(&damaged);
            }
        }
    }
}

#[test]
fn reading_goes_on_behind_what_is_damaged() {
    let whole = sample("binary");
    let (records, _) = read(&whole);
    // The length of the second item: the first one ends 4 bytes of mark, type and length and its data later.
    let second = whole[94..].windows(4).position(|four| four == b"GKSM").expect("a second item") + 94;
    let mut damaged = whole.clone();
    damaged[second + 1] = b'x';
    let (rest, faults) = read(&damaged);
    assert_eq!(faults, 1);
    assert!(rest.len() + 2 >= records.len() && rest.last() == records.last());
}

#[test]
fn a_count_is_not_believed() {
    let mut bytes = sample("binary")[..90].to_vec();
    bytes.extend_from_slice(b"GKSM");
    bytes.extend_from_slice(&11_i32.to_le_bytes());
    bytes.extend_from_slice(&12_i32.to_le_bytes());
    bytes.extend_from_slice(&i32::MAX.to_le_bytes());
    bytes.extend_from_slice(&0.5_f64.to_le_bytes());
    assert_eq!(read(&bytes).1, 2);
}

/// A header as other implementations write it.
fn header(author: &str, widths: &str, numbers: &str) -> String {
    format!("GKSM{author:<40}85/06/01 1{widths}{numbers}")
}

fn debug(records: &[Record<'_>]) -> Vec<String> {
    records.iter().map(|record| format!("{record:?}")).collect()
}

#[test]
fn lines_of_other_widths_than_the_header_says_are_scanned() {
    let mut file = header("user@host XGKS 2.5", " 0 3 6 611 1 1", "dummy info.dummy info.") + "\n";
    file += "  3       8       1\n";
    file += " 22       8       3\n";
    file += " 56      41       2    0.25000    0.50000    1.00000\n";
    file += " 13      39    0.50000    0.25000       9A B     C\n";
    file += "  0       0\n";
    let (records, faults) = read(file.as_bytes());
    assert_eq!(faults, 0);
    let colour = gks_pipeline::colour::Colour::rgb(0.25, 0.5, 1.0);
    let expected = [
        Record::Update { perform: false },
        Record::Attribute(Attribute::Linetype(3)),
        Record::ColourRepresentation(2, colour),
    ];
    assert_eq!(records[..3], debug(&expected));
    assert!(records[3].contains("A B     C"), "{}", records[3]);
}

#[test]
fn records_of_80_characters_are_joined() {
    let mut text = header("RAL GKS", " 4 3 6 611 1 1", "          0          1");
    text += "GKSM  3     6     1";
    text += "GKSM 11    50     2 0.12500000  0.2500000   0.500000  0.7500000";
    text += "GKSM 22     6     4";
    text += "GKSM  0     0";
    let lines: Vec<&str> = text.as_bytes().chunks(80).map(|line| str::from_utf8(line).unwrap()).collect();
    let (records, faults) = read(lines.join("\n").as_bytes());
    assert_eq!((records.len(), faults), (3, 0), "{records:?}");
    assert_eq!(records[0], format!("{:?}", Record::Update { perform: true }));
    assert!(records[1].contains("DVec2(0.125, 0.25), DVec2(0.5, 0.75)"), "{}", records[1]);
}

#[test]
fn a_header_may_be_short() {
    let mut file = header("VARKON", " 4 3 6 6 8 1 1", "") + "\n";
    file += "GKSM  1     6     0\nGKSM 11    38     2 0.25000 0.50000 0.75000 1.00000\nGKSM  0     0\n";
    let (records, faults) = read(file.as_bytes());
    assert_eq!((records.len(), faults), (2, 0), "{records:?}");
}

#[test]
fn reals_may_be_integers_and_bytes_the_other_way_round() {
    let mut file = header("elsewhere", " 0 2 2 2 2 2 2", "          0      10000").into_bytes();
    for value in [11_i16, 10, 2, 0, 5000, 10_000, 2500] {
        file.extend_from_slice(&value.to_be_bytes());
    }
    file.extend_from_slice(&[0; 4]);
    let (records, faults) = read(&file);
    assert_eq!((records.len(), faults), (1, 0), "{records:?}");
    assert!(records[0].contains("DVec2(0.0, 0.5), DVec2(1.0, 0.25)"), "{}", records[0]);
}

#[test]
fn the_format_is_found_by_content() {
    assert_eq!(Format::of(&sample("binary")), Some(Format::Gksm));
    assert_eq!(Format::of(b"GKSM"), None);
    assert!(open_source(&b"\x89PNG\r\n"[..], &ReadOptions::default()).is_err());
}
