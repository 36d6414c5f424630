//! Records that wait to be given out.

use gks_geometry::{Ndc, PathBuf, Point, Rect};
use gks_pipeline::colour::Colour;
use gks_pipeline::item::{Cells, Curve, Ellipse, Item, Parallelogram, Role, Shape};
use gks_pipeline::look::Look;
use gks_pipeline::look_difference::{State, differences};
use gks_pipeline::record::{Attribute, Record};
use gks_pipeline::tables::Pattern;
use glam::DVec2;
use std::collections::VecDeque;

/// A record with all it needs.
#[derive(Clone, Debug)]
pub(super) enum Entry {
    /// A new picture.
    Clear,
    /// The window of the picture.
    Window(Rect<Ndc>),
    /// A colour.
    Colour(u32, Colour),
    /// A pattern.
    Pattern(u32, Pattern),
    /// An attribute.
    Attribute(Attribute),
    /// A message.
    Message(String),
    /// Application data.
    User(i32, Vec<u8>),
    /// A primitive.
    Primitive(Drawing),
}

/// A primitive with its points.
#[derive(Clone, Debug)]
pub(super) enum Drawing {
    /// Lines.
    Lines(PathBuf<Ndc>),
    /// Markers.
    Markers(Vec<DVec2>),
    /// Text.
    Text(Point<Ndc>, String),
    /// An area.
    Area(PathBuf<Ndc>),
    /// Cells, as many as columns times rows.
    Cells(Parallelogram<Ndc>, usize, usize, Vec<i32>),
    /// An ellipse or a part of one.
    Ellipse(Ellipse<Ndc>, Role),
    /// Bezier curves.
    Bezier(Vec<DVec2>, Role),
}

impl Drawing {
    /// The primitive as items have it; none where cells are missing.
    fn shape(&self) -> Option<Shape<'_>> {
        Some(match self {
            Drawing::Lines(paths) => Shape::Polyline(paths.as_paths()),
            Drawing::Markers(points) => Shape::Polymarker(points),
            Drawing::Text(at, text) => Shape::Text(*at, text),
            Drawing::Area(rings) => Shape::FillArea(rings.as_paths()),
            Drawing::Cells(place, columns, rows, indices) => {
                Shape::CellArray(*place, Cells::new(indices, *columns, *rows, *columns)?)
            }
            Drawing::Ellipse(ellipse, role) => Shape::Generalized(Curve::Ellipse(*ellipse), *role),
            Drawing::Bezier(points, role) => Shape::Generalized(Curve::Bezier(points), *role),
        })
    }

    /// Whether all coordinates are numbers that arithmetic can deal with.
    fn is_sound(&self) -> bool {
        let sound = |p: &DVec2| p.is_finite() && p.abs().max_element() < 1e12;
        match self {
            Drawing::Lines(paths) | Drawing::Area(paths) => {
                !paths.ends.is_empty() && paths.points.iter().all(sound)
            }
            Drawing::Markers(points) | Drawing::Bezier(points, _) => {
                !points.is_empty() && points.iter().all(sound)
            }
            Drawing::Text(at, text) => sound(&at.0) && !text.is_empty(),
            Drawing::Cells(place, ..) => place.corners().iter().all(|corner| sound(&corner.0)),
            Drawing::Ellipse(ellipse, _) => {
                [ellipse.centre.0, ellipse.a.0, ellipse.b.0].iter().all(sound)
                    && ellipse.start.is_finite()
                    && ellipse.sweep.is_finite()
            }
        }
    }
}

impl Entry {
    /// The entry as a record; none if it is a primitive that cannot be one.
    pub(super) fn record(&self) -> Option<Record<'_>> {
        Some(match self {
            Entry::Clear => Record::Clear { always: true },
            Entry::Window(window) => Record::WorkstationWindow(*window),
            Entry::Colour(index, colour) => Record::ColourRepresentation(*index, *colour),
            Entry::Pattern(index, pattern) => Record::PatternRepresentation(*index, pattern),
            Entry::Attribute(attribute) => Record::Attribute(*attribute),
            Entry::Message(text) => Record::Message(text),
            Entry::User(kind, data) => Record::User(*kind, data),
            Entry::Primitive(drawing) => Record::Primitive(drawing.shape()?),
        })
    }
}

/// The records that wait, and the attributes that those before them have set.
#[derive(Debug, Default)]
pub(super) struct Queue {
    entries: VecDeque<Entry>,
    /// The attributes told so far; none before the first primitive, since whoever reads may have had others.
    known: Option<State>,
    /// The look that primitives have unless they change it.
    look: Look,
}

impl Queue {
    /// Adds a record.
    pub(super) fn push(&mut self, entry: Entry) {
        self.entries.push_back(entry);
    }

    /// Adds a colour representation.
    pub(super) fn colour(&mut self, index: u32, colour: Colour) {
        self.push(Entry::Colour(index, colour));
    }

    /// The next record.
    pub(super) fn pop(&mut self) -> Option<Entry> {
        self.entries.pop_front()
    }

    /// Whether no record waits.
    pub(super) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The look to start from.
    pub(super) fn look(&self) -> &Look {
        &self.look
    }

    /// Adds a primitive, after the attributes in which it differs from what was told.
    pub(super) fn draw(&mut self, drawing: Drawing, look: Look, clip: Rect<Ndc>) {
        if !drawing.is_sound() || drawing.shape().is_none() {
            return;
        }
        self.look = look;
        let item = Item { shape: Shape::Polymarker(&[]), look: &self.look, clip, pick: 0 };
        let entries = &mut self.entries;
        let tell = |attribute| entries.push_back(Entry::Attribute(attribute));
        let known = self.known.get_or_insert_with(|| contrary(&self.look));
        differences(known, &item, tell);
        self.push(Entry::Primitive(drawing));
    }
}

/// A state that differs from a look in everything, so that all of it is told.
fn contrary(look: &Look) -> State {
    use gks_pipeline::look::{
        AspectSourceFlags, Cap, Horizontal, InteriorStyle, Join, Precision, TextPath, Vertical,
    };
    let mut other = State { look: look.clone(), clip: Rect::new(f64::NAN, 0.0, 0.0, 0.0), pick: -1 };
    fn turned<T: PartialEq>(value: &mut T, one: T, two: T) {
        *value = if *value == one { two } else { one };
    }
    let odd = &mut other.look;
    turned(&mut odd.sources, AspectSourceFlags::BUNDLED, AspectSourceFlags::INDIVIDUAL);
    for index in [&mut odd.line_index, &mut odd.marker_index, &mut odd.text_index, &mut odd.fill_index] {
        *index = 0;
    }
    odd.line.width = f64::NAN;
    odd.line.linetype = 0;
    odd.line.colour ^= 1;
    turned(&mut odd.cap, Cap::Butt, Cap::Round);
    turned(&mut odd.join, Join::Miter, Join::Round);
    odd.marker.kind = 0;
    odd.marker.size = f64::NAN;
    odd.marker.colour ^= 1;
    turned(&mut odd.text.precision, Precision::String, Precision::Stroke);
    odd.text.expansion = f64::NAN;
    odd.text.spacing = f64::NAN;
    odd.text.colour ^= 1;
    odd.text_geometry.height = gks_geometry::Vector::new(f64::NAN, 0.0);
    turned(&mut odd.text_geometry.path, TextPath::Right, TextPath::Left);
    turned(&mut odd.text_geometry.horizontal, Horizontal::Normal, Horizontal::Left);
    turned(&mut odd.text_geometry.vertical, Vertical::Normal, Vertical::Base);
    turned(&mut odd.fill.interior, InteriorStyle::Hollow, InteriorStyle::Solid);
    odd.fill.style = 0;
    odd.fill.colour ^= 1;
    odd.pattern.width = gks_geometry::Vector::new(f64::NAN, 0.0);
    odd.pattern.reference = Point::new(f64::NAN, 0.0);
    other
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_primitive_tells_every_attribute() {
        let mut queue = Queue::default();
        let marker = Drawing::Markers(vec![DVec2::ZERO]);
        queue.draw(marker.clone(), Look::default(), Rect::UNIT);
        let mut told = std::iter::from_fn(|| queue.pop());
        assert_eq!(told.by_ref().filter(|entry| matches!(entry, Entry::Attribute(_))).count(), 27);
        queue.draw(marker, Look::default(), Rect::UNIT);
        assert!(matches!(queue.pop(), Some(Entry::Primitive(_))) && queue.is_empty());
    }

    #[test]
    fn what_is_not_a_number_is_not_drawn() {
        let mut queue = Queue::default();
        queue.draw(Drawing::Markers(vec![DVec2::new(f64::NAN, 0.0)]), Look::default(), Rect::UNIT);
        queue.draw(Drawing::Cells(unit(), 2, 2, vec![1]), Look::default(), Rect::UNIT);
        assert!(queue.is_empty());
    }

    fn unit() -> Parallelogram<Ndc> {
        let (columns, rows) = (gks_geometry::Vector::new(1.0, 0.0), gks_geometry::Vector::new(0.0, 1.0));
        Parallelogram { origin: Point::new(0.0, 0.0), columns, rows }
    }
}
