//! Records as items.

use super::{Put, generalized, kind};
use crate::generated::numbers::escape;
use crate::item::{Cells, Parallelogram, Shape};
use crate::look::{ClipSector, FillBundle, LineBundle, MarkerBundle, TextBundle};
use crate::record::{Attribute, Record};
use crate::tables::Pattern;
use gks_geometry::{Ndc, Paths, Point, Rect, Space, Vector};
use glam::DVec2;

/// Writes a record as one item or several.
pub fn encode(record: &Record<'_>, put: &mut impl Put) {
    match *record {
        Record::Clear { always } => integers(put, kind::CLEAR, &[always.into()]),
        Record::RedrawAllSegments => integers(put, kind::REDRAW_ALL_SEGMENTS, &[]),
        Record::Update { perform } => integers(put, kind::UPDATE, &[perform.into()]),
        Record::Deferral(mode, regeneration) => {
            integers(put, kind::DEFERRAL, &[mode as i32, regeneration as i32]);
        }
        Record::Message(text) => {
            put.begin(kind::MESSAGE);
            string(put, text);
        }
        Record::Escape(id, data) => escaped(put, id, data),
        Record::Primitive(shape) => primitive(put, shape),
        Record::Attribute(value) => attribute(put, value),
        Record::LineRepresentation(index, LineBundle { linetype, width, colour }) => {
            mixed(put, kind::LINE_REPRESENTATION, &[signed(index), linetype], &[width], &[signed(colour)]);
        }
        Record::MarkerRepresentation(index, MarkerBundle { kind: marker, size, colour }) => {
            mixed(put, kind::MARKER_REPRESENTATION, &[signed(index), marker], &[size], &[signed(colour)]);
        }
        Record::TextRepresentation(index, TextBundle { font, precision, expansion, spacing, colour }) => {
            let before = [signed(index), font, precision as i32];
            mixed(put, kind::TEXT_REPRESENTATION, &before, &[expansion, spacing], &[signed(colour)]);
        }
        Record::FillRepresentation(index, FillBundle { interior, style, colour }) => {
            let fields = [signed(index), interior as i32, style, signed(colour)];
            integers(put, kind::FILL_REPRESENTATION, &fields);
        }
        Record::PatternRepresentation(index, pattern) => pattern_table(put, index, pattern),
        Record::ColourRepresentation(index, c) => {
            let components = [c.red, c.green, c.blue].map(f64::from);
            mixed(put, kind::COLOUR_REPRESENTATION, &[signed(index)], &components, &[]);
            if c.alpha != 1.0 {
                // Which workstation is meant, the reader knows better.
                let data = packed(&[0, signed(index)], &[c.alpha.into()]);
                escaped(put, escape::SET_COLOUR_ALPHA, data.as_bytes());
            }
        }
        Record::WorkstationWindow(rect) => limits(put, kind::WORKSTATION_WINDOW, &rect),
        Record::WorkstationViewport(rect) => limits(put, kind::WORKSTATION_VIEWPORT, &rect),
        Record::CreateSegment(name) => integers(put, kind::CREATE_SEGMENT, &[name]),
        Record::CloseSegment => integers(put, kind::CLOSE_SEGMENT, &[]),
        Record::RenameSegment(old, new) => integers(put, kind::RENAME_SEGMENT, &[old, new]),
        Record::DeleteSegment(name) => integers(put, kind::DELETE_SEGMENT, &[name]),
        Record::SegmentTransformation(name, map) => {
            mixed(put, kind::SEGMENT_TRANSFORMATION, &[name], map.rows().as_flattened(), &[]);
        }
        Record::Visibility(name, on) => integers(put, kind::VISIBILITY, &[name, on.into()]),
        Record::Highlighting(name, on) => integers(put, kind::HIGHLIGHTING, &[name, on.into()]),
        Record::SegmentPriority(name, priority) => {
            mixed(put, kind::SEGMENT_PRIORITY, &[name], &[priority], &[]);
        }
        Record::Detectability(name, on) => integers(put, kind::DETECTABILITY, &[name, on.into()]),
        Record::User(kind, data) => {
            put.begin(kind);
            put.characters(data);
            put.end();
        }
    }
}

fn signed(value: u32) -> i32 {
    i32::try_from(value).unwrap_or(i32::MAX)
}

fn count(length: usize) -> i32 {
    i32::try_from(length).unwrap_or(i32::MAX)
}

fn integers(put: &mut impl Put, kind: i32, values: &[i32]) {
    mixed(put, kind, values, &[], &[]);
}

fn reals(put: &mut impl Put, kind: i32, values: &[f64]) {
    mixed(put, kind, &[], values, &[]);
}

/// An item of integers, reals and integers again.
fn mixed(put: &mut impl Put, kind: i32, before: &[i32], values: &[f64], after: &[i32]) {
    put.begin(kind);
    before.iter().for_each(|&value| put.integer(value));
    values.iter().for_each(|&value| put.real(value));
    after.iter().for_each(|&value| put.integer(value));
    put.end();
}

fn limits<S: Space>(put: &mut impl Put, kind: i32, rect: &Rect<S>) {
    reals(put, kind, &rect.limits());
}

/// The length and the characters of a string, which end an item.
fn string(put: &mut impl Put, text: &str) {
    put.integer(count(text.len()));
    put.characters(text.as_bytes());
    put.end();
}

fn escaped(put: &mut impl Put, id: i32, data: &[u8]) {
    put.begin(kind::ESCAPE);
    put.integer(id);
    put.integer(count(data.len()));
    put.characters(data);
    put.end();
}

/// A data record as PACK DATA RECORD writes it, without the blanks at its end.
pub(super) fn packed(integers: &[i32], reals: &[f64]) -> String {
    let mut text = format!("GKSDR1 {} {} 0", integers.len(), reals.len());
    for value in integers {
        text += &format!(" {value}");
    }
    for value in reals {
        text += &format!(" {value:?}");
    }
    text
}

fn pattern_table(put: &mut impl Put, index: u32, pattern: &Pattern) {
    put.begin(kind::PATTERN_REPRESENTATION);
    put.integer(signed(index));
    put.integer(count(pattern.columns));
    put.integer(count(pattern.rows));
    pattern.indices.iter().for_each(|&index| put.integer(index));
    put.end();
}

fn primitive(put: &mut impl Put, shape: Shape<'_>) {
    match shape {
        Shape::Polyline(paths) => compound(put, kind::POLYLINE, &paths),
        Shape::FillArea(paths) => compound(put, kind::FILL_AREA, &paths),
        Shape::Polymarker(positions) => points(put, kind::POLYMARKER, positions),
        Shape::Text(at, text) => {
            put.begin(kind::TEXT);
            put.real(at.x());
            put.real(at.y());
            string(put, text);
        }
        Shape::CellArray(place, cells) => cell_array(put, &place, &cells),
        Shape::Generalized(curve, role) => {
            let gdp = generalized::Gdp::of(&curve, role);
            put.begin(kind::GENERALIZED);
            put.integer(gdp.id);
            put.integer(count(gdp.points.len()));
            put.integer(count(gdp.data.len()));
            for p in &gdp.points {
                put.real(p.x);
                put.real(p.y);
            }
            put.characters(gdp.data.as_bytes());
            put.end();
        }
    }
}

/// Paths as one item each. If they are several, an ESCAPE before them says that they are one primitive.
fn compound(put: &mut impl Put, kind: i32, paths: &Paths<'_, Ndc>) {
    if paths.ends.len() > 1 {
        let data = packed(&[count(paths.ends.len())], &[]);
        escaped(put, escape::COMPOUND_PRIMITIVE, data.as_bytes());
    }
    paths.iter().for_each(|path| points(put, kind, path));
}

fn points(put: &mut impl Put, kind: i32, points: &[DVec2]) {
    put.begin(kind);
    put.integer(count(points.len()));
    for p in points {
        put.real(p.x);
        put.real(p.y);
    }
    put.end();
}

fn cell_array(put: &mut impl Put, place: &Parallelogram<Ndc>, cells: &Cells<'_>) {
    // Columns advance along the edge from P to R, rows along the one from R to Q.
    let p = place.origin;
    let r = end_of(p, place.columns);
    let q = end_of(r, place.rows);
    put.begin(kind::CELL_ARRAY);
    for point in [p, q, r] {
        put.real(point.x());
        put.real(point.y());
    }
    put.integer(count(cells.columns));
    put.integer(count(cells.rows));
    for row in 0..cells.rows {
        cells.row(row).iter().for_each(|&index| put.integer(index));
    }
    put.end();
}

/// The end of a vector at a point, such that the difference of the two is the vector again, to the last bit
/// where there is such a point.
fn end_of(start: Point<Ndc>, vector: Vector<Ndc>) -> Point<Ndc> {
    let end = |start: f64, length: f64| {
        let sum = start + length;
        let (mut up, mut down) = (sum, sum);
        for _ in 0..4 {
            if let Some(found) = [up, down].into_iter().find(|end| end - start == length) {
                return found;
            }
            (up, down) = (up.next_up(), down.next_down());
        }
        sum
    };
    Point::new(end(start.x(), vector.x()), end(start.y(), vector.y()))
}

fn attribute(put: &mut impl Put, attribute: Attribute) {
    let two = |put: &mut _, kind, a: Vector<Ndc>, b: Vector<Ndc>| {
        reals(put, kind, &[a.x(), a.y(), b.x(), b.y()]);
    };
    match attribute {
        Attribute::LineIndex(v) => integers(put, kind::LINE_INDEX, &[signed(v)]),
        Attribute::Linetype(v) => integers(put, kind::LINETYPE, &[v]),
        Attribute::LineWidth(v) => reals(put, kind::LINE_WIDTH, &[v]),
        Attribute::LineColour(v) => integers(put, kind::LINE_COLOUR, &[signed(v)]),
        Attribute::MarkerIndex(v) => integers(put, kind::MARKER_INDEX, &[signed(v)]),
        Attribute::MarkerType(v) => integers(put, kind::MARKER_TYPE, &[v]),
        Attribute::MarkerSize(v) => reals(put, kind::MARKER_SIZE, &[v]),
        Attribute::MarkerColour(v) => integers(put, kind::MARKER_COLOUR, &[signed(v)]),
        Attribute::TextIndex(v) => integers(put, kind::TEXT_INDEX, &[signed(v)]),
        Attribute::TextFont(font, precision) => integers(put, kind::TEXT_FONT, &[font, precision as i32]),
        Attribute::CharacterExpansion(v) => reals(put, kind::CHARACTER_EXPANSION, &[v]),
        Attribute::CharacterSpacing(v) => reals(put, kind::CHARACTER_SPACING, &[v]),
        Attribute::TextColour(v) => integers(put, kind::TEXT_COLOUR, &[signed(v)]),
        Attribute::CharacterVectors(height, width) => two(put, kind::CHARACTER_VECTORS, height, width),
        Attribute::TextPath(v) => integers(put, kind::TEXT_PATH, &[v as i32]),
        Attribute::TextAlignment(horizontal, vertical) => {
            integers(put, kind::TEXT_ALIGNMENT, &[horizontal as i32, vertical as i32]);
        }
        Attribute::FillIndex(v) => integers(put, kind::FILL_INDEX, &[signed(v)]),
        Attribute::InteriorStyle(v) => integers(put, kind::INTERIOR_STYLE, &[v as i32]),
        Attribute::FillStyle(v) => integers(put, kind::FILL_STYLE, &[v]),
        Attribute::FillColour(v) => integers(put, kind::FILL_COLOUR, &[signed(v)]),
        Attribute::PatternVectors(width, height) => two(put, kind::PATTERN_SIZE, width, height),
        Attribute::PatternReference(p) => reals(put, kind::PATTERN_REFERENCE, &[p.x(), p.y()]),
        Attribute::AspectSourceFlags(flags) => {
            integers(put, kind::ASPECT_SOURCE_FLAGS, &flags.to_array().map(i32::from));
        }
        Attribute::PickIdentifier(v) => integers(put, kind::PICK_IDENTIFIER, &[v]),
        Attribute::ClippingRectangle(rect) => limits(put, kind::CLIPPING_RECTANGLE, &rect),
        Attribute::Cap(cap) => escaped(put, escape::SET_LINE_CAP, packed(&[cap as i32], &[]).as_bytes()),
        Attribute::Join(join) => {
            escaped(put, escape::SET_LINE_JOIN, packed(&[join as i32], &[]).as_bytes());
        }
        Attribute::ClipSector(sector) => {
            let (on, ClipSector { start, end }) = (sector.is_some(), sector.unwrap_or(ClipSector::WHOLE));
            escaped(put, escape::SET_CLIP_SECTOR, packed(&[on.into()], &[start, end]).as_bytes());
        }
    }
}
