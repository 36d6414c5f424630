//! Items as records.

use super::encode::packed;
use super::generalized::{Drawn, drawn, unpacked};
use super::{Get, Unreadable, kind};
use crate::colour::Colour;
use crate::description::{DeferralMode, RegenerationMode};
use crate::generated::numbers::escape;
use crate::item::{Cells, Curve, Parallelogram, Shape};
use crate::look::{
    AspectSourceFlags, Cap, ClipSector, FillBundle, Horizontal, InteriorStyle, Join, LineBundle,
    MarkerBundle, Precision, TextBundle, TextPath, Vertical,
};
use crate::record::{Attribute, Record};
use crate::tables::Pattern;
use gks_geometry::{Map, Ndc, PathBuf, Point, Rect, Space, Vector};
use glam::DVec2;

/// How authors of metafiles read the standard.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum Convention {
    /// This library: data records are characters.
    #[default]
    Own,
    /// RAL GKS: data records are numbers of integers and reals, the integers and the reals.
    Ral,
    /// XGKS: as RAL GKS, but UPDATE is 0 perform, 1 postpone, and VISIBILITY 0 visible, 1 invisible.
    Xgks,
    /// SunGKS: as RAL GKS, but messages have no length.
    Sun,
    /// GKSGRAL: as RAL GKS, but colours come second in representations, and cell arrays have four more integers.
    Gral,
}

/// Reads items, and keeps what their records borrow.
#[derive(Debug, Default)]
pub struct Decoder {
    convention: Convention,
    /// Whether the switches in UPDATE and VISIBILITY are those of XGKS.
    pub inverted: bool,
    paths: PathBuf<Ndc>,
    text: String,
    bytes: Vec<u8>,
    pattern: Option<Pattern>,
    cells: Vec<i32>,
}

/// A value of an enumeration or an index in an item.
pub trait Field: Sized {
    /// The value with a number, or none.
    fn of(number: i32) -> Option<Self>;
}

macro_rules! fields {
    ($($name:ident),+) => { $(
        impl Field for $name {
            fn of(number: i32) -> Option<Self> {
                $name::from_number(number)
            }
        }
    )+ };
}

fields!(DeferralMode, RegenerationMode, Cap, Horizontal, InteriorStyle, Join, Precision, TextPath, Vertical);

impl Field for i32 {
    fn of(number: i32) -> Option<Self> {
        Some(number)
    }
}

impl Field for u32 {
    fn of(number: i32) -> Option<Self> {
        u32::try_from(number).ok()
    }
}

impl Field for bool {
    fn of(number: i32) -> Option<Self> {
        match number {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }
}

fn field<F: Field>(get: &mut impl Get) -> Result<F, Unreadable> {
    let number = get.integer()?;
    F::of(number).ok_or_else(|| Unreadable::value("no value of the field:", number))
}

/// A number of fields, or of groups of `size` fields, that the data may have.
fn count(get: &mut impl Get, size: usize) -> Result<usize, Unreadable> {
    let number = field::<u32>(get)? as usize;
    if number.saturating_mul(size) > get.left() { Err(Unreadable::Short) } else { Ok(number) }
}

fn point(get: &mut impl Get) -> Result<DVec2, Unreadable> {
    Ok(DVec2::new(get.real()?, get.real()?))
}

fn vector(get: &mut impl Get) -> Result<Vector<Ndc>, Unreadable> {
    point(get).map(Vector::from_vec)
}

fn limits<S: Space>(get: &mut impl Get) -> Result<Rect<S>, Unreadable> {
    let rect = Rect::new(get.real()?, get.real()?, get.real()?, get.real()?);
    if rect.is_proper() { Ok(rect) } else { Err(Unreadable::value("limits", format!("{:?}", rect.limits()))) }
}

fn colour(get: &mut impl Get) -> Result<Colour, Unreadable> {
    let colour = Colour::rgb(get.real()? as f32, get.real()? as f32, get.real()? as f32);
    if colour.is_valid() { Ok(colour) } else { Err(Unreadable::value("colour", format!("{colour:?}"))) }
}

impl Decoder {
    /// A decoder for items of an author.
    pub fn new(convention: Convention) -> Self {
        Decoder { convention, inverted: convention == Convention::Xgks, ..Decoder::default() }
    }

    /// The record that an item is, or none for END ITEM.
    ///
    /// The type of an application's own item is above 100. Fields after those of the standard are ignored.
    pub fn decode<'s>(&'s mut self, kind: i32, get: &mut impl Get) -> Result<Option<Record<'s>>, Unreadable> {
        let gral = self.convention == Convention::Gral;
        Ok(Some(match kind {
            kind::END => return Ok(None),
            kind::CLEAR => Record::Clear { always: field(get)? },
            kind::REDRAW_ALL_SEGMENTS => Record::RedrawAllSegments,
            kind::UPDATE => Record::Update { perform: field::<bool>(get)? != self.inverted },
            kind::DEFERRAL => Record::Deferral(field(get)?, field(get)?),
            kind::MESSAGE => {
                if self.convention == Convention::Sun {
                    self.take_text(get.rest());
                } else {
                    self.string(get)?;
                }
                Record::Message(&self.text)
            }
            kind::ESCAPE => {
                let id = get.integer()?;
                self.data_record(get)?;
                private_attribute(id, &self.bytes).unwrap_or(Record::Escape(id, &self.bytes))
            }
            kind::POLYLINE | kind::POLYMARKER | kind::TEXT | kind::FILL_AREA => {
                Record::Primitive(self.primitive(kind, get)?)
            }
            kind::CELL_ARRAY => Record::Primitive(self.cell_array(get)?),
            kind::GENERALIZED => Record::Primitive(self.generalized(get)?),
            21..=44 | kind::CLIPPING_RECTANGLE => Record::Attribute(attribute(kind, get)?),
            kind::LINE_REPRESENTATION | kind::MARKER_REPRESENTATION => {
                let (index, early) = (field(get)?, early(gral, get)?);
                let (style, size) = (get.integer()?, get.real()?);
                let colour = late(early, get)?;
                if kind == kind::LINE_REPRESENTATION {
                    Record::LineRepresentation(index, LineBundle { linetype: style, width: size, colour })
                } else {
                    Record::MarkerRepresentation(index, MarkerBundle { kind: style, size, colour })
                }
            }
            kind::TEXT_REPRESENTATION => {
                let (index, early) = (field(get)?, early(gral, get)?);
                let (font, precision) = (get.integer()?, field(get)?);
                let (expansion, spacing) = (get.real()?, get.real()?);
                let bundle = TextBundle { font, precision, expansion, spacing, colour: late(early, get)? };
                Record::TextRepresentation(index, bundle)
            }
            kind::FILL_REPRESENTATION => {
                let (index, early) = (field(get)?, early(gral, get)?);
                let (interior, style) = (field(get)?, get.integer()?);
                Record::FillRepresentation(index, FillBundle { interior, style, colour: late(early, get)? })
            }
            kind::PATTERN_REPRESENTATION => {
                let index = field(get)?;
                let (columns, rows) = self.cells(get)?;
                let indices = std::mem::take(&mut self.cells);
                Record::PatternRepresentation(index, self.pattern.insert(Pattern { columns, rows, indices }))
            }
            kind::COLOUR_REPRESENTATION => Record::ColourRepresentation(field(get)?, colour(get)?),
            kind::WORKSTATION_WINDOW => Record::WorkstationWindow(limits(get)?),
            kind::WORKSTATION_VIEWPORT => Record::WorkstationViewport(limits(get)?),
            kind::CREATE_SEGMENT => Record::CreateSegment(get.integer()?),
            kind::CLOSE_SEGMENT => Record::CloseSegment,
            kind::RENAME_SEGMENT => Record::RenameSegment(get.integer()?, get.integer()?),
            kind::DELETE_SEGMENT => Record::DeleteSegment(get.integer()?),
            kind::SEGMENT_TRANSFORMATION => {
                let name = get.integer()?;
                let mut rows = [[0.0; 3]; 2];
                for value in rows.as_flattened_mut() {
                    *value = get.real()?;
                }
                Record::SegmentTransformation(name, Map::from_rows(rows))
            }
            kind::VISIBILITY => Record::Visibility(get.integer()?, field::<bool>(get)? != self.inverted),
            kind::HIGHLIGHTING => Record::Highlighting(get.integer()?, field(get)?),
            kind::SEGMENT_PRIORITY => Record::SegmentPriority(get.integer()?, get.real()?),
            kind::DETECTABILITY => Record::Detectability(get.integer()?, field(get)?),
            _ if kind > kind::LAST => {
                self.bytes.clear();
                self.bytes.extend_from_slice(get.rest());
                Record::User(kind, &self.bytes)
            }
            _ => return Err(Unreadable::Kind(kind)),
        }))
    }

    /// How many of the items that follow are one primitive, if the item says so.
    pub fn compound(kind: i32, get: &mut impl Get) -> Option<usize> {
        if kind != kind::ESCAPE || get.integer().ok()? != escape::COMPOUND_PRIMITIVE {
            return None;
        }
        let length = field::<u32>(get).ok()? as usize;
        let (integers, _) = unpacked(get.characters(length).ok()?)?;
        usize::try_from(*integers.first()?).ok()
    }

    /// Begins a primitive of several items.
    pub fn begin_compound(&mut self) {
        self.paths.clear();
    }

    /// Adds the points of an item to the primitive.
    pub fn add_to_compound(&mut self, get: &mut impl Get) -> Result<(), Unreadable> {
        let number = count(get, 2)?;
        self.points(number, get)
    }

    /// The primitive of several items of a type.
    pub fn end_compound(&self, kind: i32) -> Record<'_> {
        let paths = self.paths.as_paths();
        Record::Primitive(if kind == kind::FILL_AREA {
            Shape::FillArea(paths)
        } else {
            Shape::Polyline(paths)
        })
    }

    /// The length and the characters of a string: UTF-8, or Latin-1 where they are not valid as that.
    fn string(&mut self, get: &mut impl Get) -> Result<(), Unreadable> {
        let length = field::<u32>(get)? as usize;
        self.take_text(get.characters(length)?);
        Ok(())
    }

    fn take_text(&mut self, bytes: &[u8]) {
        self.text.clear();
        match str::from_utf8(bytes) {
            Ok(text) => self.text.push_str(text),
            Err(_) => self.text.extend(bytes.iter().map(|&byte| char::from(byte))),
        }
    }

    /// A data record, into `self.bytes`.
    fn data_record(&mut self, get: &mut impl Get) -> Result<(), Unreadable> {
        self.bytes.clear();
        if self.convention == Convention::Own {
            let length = field::<u32>(get)? as usize;
            self.bytes.extend_from_slice(get.characters(length)?);
        } else {
            let (integers, reals) = (count(get, 1)?, count(get, 1)?);
            self.numbers(integers, reals, get)?;
        }
        Ok(())
    }

    /// Integers and reals as a data record, into `self.bytes`.
    fn numbers(&mut self, integers: usize, reals: usize, get: &mut impl Get) -> Result<(), Unreadable> {
        let integers = (0..integers).map(|_| get.integer()).collect::<Result<Vec<_>, _>>()?;
        let reals = (0..reals).map(|_| get.real()).collect::<Result<Vec<_>, _>>()?;
        self.bytes.extend_from_slice(packed(&integers, &reals).as_bytes());
        Ok(())
    }

    fn primitive(&mut self, kind: i32, get: &mut impl Get) -> Result<Shape<'_>, Unreadable> {
        if kind == kind::TEXT {
            let at = Point::from_vec(point(get)?);
            self.string(get)?;
            return Ok(Shape::Text(at, &self.text));
        }
        self.paths.clear();
        let number = count(get, 2)?;
        self.points(number, get)?;
        Ok(match kind {
            kind::POLYLINE => Shape::Polyline(self.paths.as_paths()),
            kind::POLYMARKER => Shape::Polymarker(&self.paths.points),
            _ => Shape::FillArea(self.paths.as_paths()),
        })
    }

    /// Adds a path of points.
    fn points(&mut self, number: usize, get: &mut impl Get) -> Result<(), Unreadable> {
        self.paths.points.reserve(number);
        for _ in 0..number {
            self.paths.push(point(get)?);
        }
        self.paths.end();
        Ok(())
    }

    /// Numbers of columns and rows, and as many indices, into `self.cells`.
    fn cells(&mut self, get: &mut impl Get) -> Result<(usize, usize), Unreadable> {
        let size = (field::<u32>(get)? as usize, field::<u32>(get)? as usize);
        self.indices(size, get)
    }

    fn indices(
        &mut self,
        (columns, rows): (usize, usize),
        get: &mut impl Get,
    ) -> Result<(usize, usize), Unreadable> {
        let number = columns.checked_mul(rows).filter(|&n| n <= get.left()).ok_or(Unreadable::Short)?;
        if number == 0 {
            return Err(Unreadable::value("number of cells", number));
        }
        self.cells.clear();
        self.cells.reserve(number);
        for _ in 0..number {
            let index = get.integer()?;
            self.cells.push(if index < 0 {
                return Err(Unreadable::value("colour index", index));
            } else {
                index
            });
        }
        Ok((columns, rows))
    }

    fn cell_array(&mut self, get: &mut impl Get) -> Result<Shape<'_>, Unreadable> {
        let [p, q, r] = [point(get)?, point(get)?, point(get)?];
        let (columns, rows) = if self.convention == Convention::Gral {
            let size = (field::<u32>(get)? as usize, field::<u32>(get)? as usize);
            for _ in 0..4 {
                get.integer()?;
            }
            self.indices(size, get)?
        } else {
            self.cells(get)?
        };
        let place = Parallelogram {
            origin: Point::from_vec(p),
            columns: Vector::from_vec(r - p),
            rows: Vector::from_vec(q - r),
        };
        let cells = Cells::new(&self.cells, columns, rows, columns).ok_or(Unreadable::Short)?;
        Ok(Shape::CellArray(place, cells))
    }

    fn generalized(&mut self, get: &mut impl Get) -> Result<Shape<'_>, Unreadable> {
        let id = get.integer()?;
        let number = count(get, 2)?;
        self.paths.clear();
        self.bytes.clear();
        if self.convention == Convention::Own {
            let length = field::<u32>(get)? as usize;
            self.points(number, get)?;
            self.bytes.extend_from_slice(get.characters(length)?);
        } else {
            let (integers, reals) = (count(get, 1)?, count(get, 1)?);
            self.points(number, get)?;
            self.numbers(integers, reals, get)?;
        }
        let data = if self.convention == Convention::Own { self.bytes.as_slice() } else { &[] };
        let unknown = || Unreadable::value("there is no generalized drawing primitive", id);
        Ok(match drawn(id, &mut self.paths.points, data).ok_or_else(unknown)? {
            Drawn::Ellipse(ellipse, role) => Shape::Generalized(Curve::Ellipse(ellipse), role),
            Drawn::Bezier(role) => Shape::Generalized(Curve::Bezier(&self.paths.points), role),
            Drawn::Polygon(crate::item::Role::Line) => Shape::Polyline(self.paths.as_paths()),
            Drawn::Polygon(crate::item::Role::Area) => Shape::FillArea(self.paths.as_paths()),
        })
    }
}

/// The colour index where it comes before what it colours.
fn early(gral: bool, get: &mut impl Get) -> Result<Option<u32>, Unreadable> {
    if gral { field(get).map(Some) } else { Ok(None) }
}

/// The colour index where it comes last, unless it is known.
fn late(early: Option<u32>, get: &mut impl Get) -> Result<u32, Unreadable> {
    early.map_or_else(|| field(get), Ok)
}

/// The attribute that an ESCAPE of our own sets.
fn private_attribute(id: i32, data: &[u8]) -> Option<Record<'static>> {
    let value = || unpacked(data).and_then(|(integers, _)| integers.first().copied());
    let attribute = match id {
        escape::SET_LINE_CAP => Attribute::Cap(Cap::of(value()?)?),
        escape::SET_LINE_JOIN => Attribute::Join(Join::of(value()?)?),
        escape::SET_CLIP_SECTOR => match unpacked(data)? {
            (on, reals) if on == [1] && reals.len() == 2 => {
                Attribute::ClipSector(Some(ClipSector { start: reals[0], end: reals[1] }))
            }
            _ => Attribute::ClipSector(None),
        },
        _ => return None,
    };
    Some(Record::Attribute(attribute))
}

fn attribute(kind: i32, get: &mut impl Get) -> Result<Attribute, Unreadable> {
    Ok(match kind {
        kind::LINE_INDEX => Attribute::LineIndex(field(get)?),
        kind::LINETYPE => Attribute::Linetype(field(get)?),
        kind::LINE_WIDTH => Attribute::LineWidth(get.real()?),
        kind::LINE_COLOUR => Attribute::LineColour(field(get)?),
        kind::MARKER_INDEX => Attribute::MarkerIndex(field(get)?),
        kind::MARKER_TYPE => Attribute::MarkerType(field(get)?),
        kind::MARKER_SIZE => Attribute::MarkerSize(get.real()?),
        kind::MARKER_COLOUR => Attribute::MarkerColour(field(get)?),
        kind::TEXT_INDEX => Attribute::TextIndex(field(get)?),
        kind::TEXT_FONT => Attribute::TextFont(field(get)?, field(get)?),
        kind::CHARACTER_EXPANSION => Attribute::CharacterExpansion(get.real()?),
        kind::CHARACTER_SPACING => Attribute::CharacterSpacing(get.real()?),
        kind::TEXT_COLOUR => Attribute::TextColour(field(get)?),
        kind::CHARACTER_VECTORS => Attribute::CharacterVectors(vector(get)?, vector(get)?),
        kind::TEXT_PATH => Attribute::TextPath(field(get)?),
        kind::TEXT_ALIGNMENT => Attribute::TextAlignment(field(get)?, field(get)?),
        kind::FILL_INDEX => Attribute::FillIndex(field(get)?),
        kind::INTERIOR_STYLE => Attribute::InteriorStyle(field(get)?),
        kind::FILL_STYLE => Attribute::FillStyle(field(get)?),
        kind::FILL_COLOUR => Attribute::FillColour(field(get)?),
        kind::PATTERN_SIZE => Attribute::PatternVectors(vector(get)?, vector(get)?),
        kind::PATTERN_REFERENCE => Attribute::PatternReference(Point::from_vec(point(get)?)),
        kind::ASPECT_SOURCE_FLAGS => {
            let mut flags = [false; 13];
            for flag in &mut flags {
                *flag = field(get)?;
            }
            Attribute::AspectSourceFlags(AspectSourceFlags::from_array(flags))
        }
        kind::PICK_IDENTIFIER => Attribute::PickIdentifier(get.integer()?),
        kind::CLIPPING_RECTANGLE => Attribute::ClippingRectangle(limits(get)?),
        _ => return Err(Unreadable::Kind(kind)),
    })
}
