use super::*;
use crate::colour::Colour;
use crate::description::{DeferralMode, RegenerationMode};
use crate::item::{Cells, Closure, Curve, Ellipse, Parallelogram, Role, Shape};
use crate::look::{
    Cap, ClipSector, FillBundle, InteriorStyle, Join, LineBundle, MarkerBundle, Precision, TextBundle,
};
use crate::look_difference::State;
use crate::record::{Attribute, Record};
use crate::tables::Pattern;
use gks_geometry::{Map, Paths, Point, Rect, Vector};
use glam::dvec2;

fn items(record: &Record<'_>) -> Vec<(i32, Vec<u8>)> {
    let mut binary = Binary::default();
    encode(record, &mut binary);
    binary.items
}

/// What the items of a record say.
fn there_and_back(record: &Record<'_>) -> Vec<String> {
    let mut decoder = Decoder::default();
    let items = items(record);
    let back = items
        .iter()
        .map(|(kind, data)| decoder.decode(*kind, &mut Bytes::new(data)).map(|r| format!("{r:?}")));
    back.collect::<Result<_, _>>().unwrap()
}

fn said(record: &Record<'_>) -> String {
    format!("{:?}", Some(record))
}

#[test]
fn control_and_tables_come_back() {
    let pattern = Pattern { columns: 3, rows: 2, indices: vec![0, 1, 2, 3, 4, 5] };
    let text = TextBundle { font: -4, precision: Precision::Char, expansion: 0.5, spacing: 0.1, colour: 3 };
    let records = [
        Record::Clear { always: true },
        Record::Clear { always: false },
        Record::RedrawAllSegments,
        Record::Update { perform: true },
        Record::Deferral(DeferralMode::Bnil, RegenerationMode::Allowed),
        Record::Message("größer"),
        Record::Escape(-1400, b"data\0\n"),
        Record::LineRepresentation(2, LineBundle { linetype: -3, width: 1.0 / 3.0, colour: 4 }),
        Record::MarkerRepresentation(3, MarkerBundle { kind: 5, size: 0.7, colour: 6 }),
        Record::TextRepresentation(4, text),
        Record::FillRepresentation(5, FillBundle { interior: InteriorStyle::Hatch, style: -7, colour: 8 }),
        Record::PatternRepresentation(6, &pattern),
        Record::ColourRepresentation(7, Colour::rgb(0.1, 0.2, 0.3)),
        Record::WorkstationWindow(Rect::new(0.1, 0.2, 0.3, 0.4)),
        Record::WorkstationViewport(Rect::new(0.01, 0.02, 0.03, 0.04)),
        Record::CreateSegment(1),
        Record::CloseSegment,
        Record::RenameSegment(1, 2),
        Record::DeleteSegment(2),
        Record::SegmentTransformation(3, Map::from_rows([[1.0, 0.5, 0.25], [0.125, 2.0, 0.1]])),
        Record::Visibility(3, false),
        Record::Highlighting(3, true),
        Record::SegmentPriority(3, 0.75),
        Record::Detectability(3, true),
        Record::User(101, b"\xff\x00"),
    ];
    for record in &records {
        assert_eq!(there_and_back(record), [said(record)]);
        let kind = items(record)[0].0;
        assert!(kind::is_standard(kind) || kind == 101);
    }
}

#[test]
fn attributes_come_back() {
    let mut state = State::default();
    state.set(Attribute::Cap(Cap::Round));
    state.set(Attribute::Join(Join::Bevel));
    state.set(Attribute::ClipSector(Some(ClipSector { start: 30.0, end: 270.0 })));
    state.set(Attribute::CharacterVectors(Vector::new(0.1, 0.2), Vector::new(0.3, -0.1)));
    let mut count = 0;
    for attribute in state.attributes() {
        let record = Record::Attribute(attribute);
        assert_eq!(there_and_back(&record), [said(&record)]);
        count += 1;
    }
    assert_eq!(count, 28);
}

#[test]
fn primitives_come_back_to_the_last_bit() {
    let points = [dvec2(0.1, 0.2), dvec2(1.0 / 3.0, 0.7), dvec2(0.9, 0.1), dvec2(0.5, 0.5)];
    let ellipse = Ellipse {
        centre: Point::new(0.3, 0.7),
        a: Vector::new(0.1, 0.02),
        b: Vector::new(-0.05, 0.3),
        start: 0.7,
        sweep: -2.1,
        closure: Closure::Pie,
    };
    let cells: Vec<i32> = (0..12).collect();
    let place = Parallelogram {
        origin: Point::new(0.1, 0.9),
        columns: Vector::new(0.7 - 0.1, 0.0),
        rows: Vector::new(0.0, 0.2 - 0.9),
    };
    let shapes = [
        Shape::Polyline(Paths::new(&points, &[4])),
        Shape::Polymarker(&points),
        Shape::Text(Point::new(0.1, 0.3), "Straße"),
        Shape::FillArea(Paths::new(&points, &[4])),
        Shape::CellArray(place, Cells::new(&cells, 4, 3, 4).unwrap()),
        Shape::Generalized(Curve::Ellipse(ellipse), Role::Area),
        Shape::Generalized(Curve::Ellipse(Ellipse { closure: Closure::Open, ..ellipse }), Role::Line),
        Shape::Generalized(Curve::Bezier(&points), Role::Line),
        Shape::Generalized(Curve::Bezier(&points), Role::Area),
    ];
    for shape in shapes {
        let record = Record::Primitive(shape);
        assert_eq!(there_and_back(&record), [said(&record)]);
    }
}

#[test]
fn parts_of_an_array_are_written_without_the_rest() {
    let cells: Vec<i32> = (0..12).collect();
    let place = Parallelogram {
        origin: Point::new(0.0, 0.0),
        columns: Vector::new(1.0, 0.0),
        rows: Vector::new(0.0, 1.0),
    };
    let shape = |cells| Record::Primitive(Shape::CellArray(place, cells));
    let part = shape(Cells::new(&cells[1..], 2, 2, 4).unwrap());
    let whole = shape(Cells::new(&[1, 2, 5, 6], 2, 2, 2).unwrap());
    assert_eq!(items(&part), items(&whole));
}

#[test]
fn several_paths_are_announced() {
    let points = [dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(0.0, 1.0), dvec2(1.0, 1.0)];
    let items = items(&Record::Primitive(Shape::Polyline(Paths::new(&points, &[2, 4]))));
    let kinds: Vec<i32> = items.iter().map(|(kind, _)| *kind).collect();
    assert_eq!(kinds, [kind::ESCAPE, kind::POLYLINE, kind::POLYLINE]);
    assert_eq!(Decoder::compound(kinds[0], &mut Bytes::new(&items[0].1)), Some(2));
    assert_eq!(Decoder::compound(kinds[1], &mut Bytes::new(&items[1].1)), None);
    let mut decoder = Decoder::default();
    decoder.begin_compound();
    for (_, data) in &items[1..] {
        decoder.add_to_compound(&mut Bytes::new(data)).unwrap();
    }
    let Record::Primitive(Shape::Polyline(paths)) = decoder.end_compound(kind::POLYLINE) else { panic!() };
    assert_eq!((paths.points, paths.ends), (&points[..], &[2, 4][..]));
}

#[test]
fn opacity_follows_the_colour() {
    let colour = Colour { alpha: 0.25, ..Colour::rgb(0.5, 0.5, 1.0) };
    let items = items(&Record::ColourRepresentation(9, colour));
    assert_eq!(
        items.iter().map(|(kind, _)| *kind).collect::<Vec<_>>(),
        [kind::COLOUR_REPRESENTATION, kind::ESCAPE]
    );
    assert!(String::from_utf8_lossy(&items[1].1).ends_with("GKSDR1 2 1 0 0 9 0.25"));
}

#[test]
fn circles_of_other_implementations_are_circles() {
    let mut data = Vec::new();
    for integer in [-4_i32, 2, 0] {
        data.extend_from_slice(&integer.to_le_bytes());
    }
    for real in [0.5_f64, 0.75, 0.5, 0.5] {
        data.extend_from_slice(&real.to_le_bytes());
    }
    let mut decoder = Decoder::default();
    let record = decoder.decode(kind::GENERALIZED, &mut Bytes::new(&data)).unwrap();
    let Some(Record::Primitive(Shape::Generalized(Curve::Ellipse(e), Role::Area))) = record else { panic!() };
    assert_eq!((e.centre, e.a.length(), e.closure), (Point::new(0.5, 0.5), 0.25, Closure::Full));
}

#[test]
fn what_makes_no_sense_is_refused() {
    let read = |kind: i32, data: &[u8]| {
        let mut decoder = Decoder::default();
        decoder.decode(kind, &mut Bytes::new(data)).map(|r| format!("{r:?}")).unwrap_err()
    };
    assert_eq!(read(7, b""), Unreadable::Kind(7));
    assert_eq!(read(-1, b""), Unreadable::Kind(-1));
    assert_eq!(read(kind::CLEAR, &[0; 3]), Unreadable::Short);
    assert!(matches!(read(kind::CLEAR, &[2, 0, 0, 0]), Unreadable::Value(_)));
    assert!(matches!(read(kind::LINE_WIDTH, &f64::NAN.to_le_bytes()), Unreadable::Value(_)));
    // Counts beyond the data, and their products beyond all bounds.
    assert_eq!(read(kind::POLYLINE, &[255, 255, 255, 127, 0, 0, 0, 0]), Unreadable::Short);
    assert!(matches!(read(kind::POLYLINE, &[255; 8]), Unreadable::Value(_)));
    assert_eq!(read(kind::MESSAGE, &[255, 255, 255, 127]), Unreadable::Short);
    let huge: Vec<u8> = [1, i32::MAX, i32::MAX].iter().flat_map(|n: &i32| n.to_le_bytes()).collect();
    assert_eq!(read(kind::PATTERN_REPRESENTATION, &huge), Unreadable::Short);
    let flat: Vec<u8> = [0.5_f64, 0.5, 0.0, 1.0].iter().flat_map(|r| r.to_le_bytes()).collect();
    assert!(matches!(read(kind::CLIPPING_RECTANGLE, &flat), Unreadable::Value(_)));
}

#[test]
fn switches_of_xgks_are_the_other_way_round() {
    let mut decoder = Decoder::new(Convention::Xgks);
    let mut read = |kind, data: &[u8]| format!("{:?}", decoder.decode(kind, &mut Bytes::new(data)).unwrap());
    assert_eq!(read(kind::UPDATE, &[0; 4]), said(&Record::Update { perform: true }));
    assert_eq!(read(kind::VISIBILITY, &[1, 0, 0, 0, 1, 0, 0, 0]), said(&Record::Visibility(1, false)));
}

#[test]
fn gksgral_writes_colours_second() {
    let data: Vec<u8> = [2_i32, 7, -3, 1].iter().flat_map(|n| n.to_le_bytes()).collect();
    let mut decoder = Decoder::new(Convention::Gral);
    let record = decoder.decode(kind::FILL_REPRESENTATION, &mut Bytes::new(&data)).unwrap_err();
    assert!(matches!(record, Unreadable::Value(_)));
    let data: Vec<u8> = [2_i32, 7, 3, -1].iter().flat_map(|n| n.to_le_bytes()).collect();
    let record = decoder.decode(kind::FILL_REPRESENTATION, &mut Bytes::new(&data)).unwrap();
    let bundle = FillBundle { interior: InteriorStyle::Hatch, style: -1, colour: 7 };
    assert_eq!(format!("{record:?}"), said(&Record::FillRepresentation(2, bundle)));
}
