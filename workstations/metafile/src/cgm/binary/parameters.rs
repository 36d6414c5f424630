//! Parameters of elements out of their octets (ISO/IEC 8632-3, 7 and 8).

use super::octets::{Bits, Octets};
use super::precision::{Precisions, RealFormat};
use crate::cgm::coding::{Modes, SizeMode};
use crate::cgm::element::{Cells, Element, Ink, Inks, Value, most_cells, repeat};
use crate::cgm::parameter::Parameter;
use crate::generated::elements::{Kind, Row};
use glam::DVec2;

/// How the parameters of an element are coded: what earlier elements have said.
#[derive(Clone, Debug)]
pub struct Coding {
    /// The precisions.
    pub precisions: Precisions,
    /// The modes.
    pub modes: Modes,
    /// The columns and rows of the tiles of the tile array that is open.
    pub(super) tile_size: Option<(usize, usize)>,
}

impl Default for Coding {
    fn default() -> Self {
        Coding { precisions: Precisions::default(), modes: Modes::new(255.0), tile_size: None }
    }
}

impl Coding {
    /// Takes note of an element.
    pub fn observe(&mut self, element: &Element) {
        self.precisions.observe(element);
        self.modes.observe(element);
        match element.kind {
            // The greatest component follows the precision unless it is said otherwise.
            Kind::ColourPrecision => {
                self.modes.extent.1 = [f64::from(u32::MAX >> (32 - self.precisions.colour)); 4];
            }
            Kind::BeginTileArray => {
                let count = |place: usize| usize::try_from(element.integer(place)?).ok();
                self.tile_size = count(5).zip(count(6));
            }
            _ => {}
        }
    }

    /// The element of a row with these octets. What is cut off is left out.
    pub fn element(&self, row: &Row, octets: &[u8]) -> Element {
        let mut values = Vec::new();
        let mut octets = Octets::new(octets);
        // Whether all parameters are there is seen by their number.
        let _ = self.list(row, row.parameters, &mut octets, &mut values);
        let mut element = Element { kind: row.kind, values };
        if row.parameters.last() == Some(&Parameter::Bits) {
            let cells = self.tile(&element, octets.take_all());
            element.values.extend(cells.map(Value::Cells));
        }
        element
    }

    fn list(
        &self,
        row: &Row,
        parameters: &[Parameter],
        octets: &mut Octets<'_>,
        values: &mut Vec<Value>,
    ) -> Option<()> {
        for parameter in parameters {
            match parameter {
                Parameter::Repeat([Parameter::Point]) => {
                    let mut points = Vec::new();
                    while let Some(point) = self.point(octets) {
                        points.push(point);
                    }
                    values.push(Value::Points(points));
                }
                Parameter::Repeat(group) => {
                    while !octets.is_empty() {
                        self.list(row, group, octets, values)?;
                    }
                }
                Parameter::CountedPoints => {
                    let count = self.integer(octets)?;
                    let points = self.points(count, octets)?;
                    values.push(Value::Points(points));
                }
                Parameter::Spline | Parameter::RationalSpline => {
                    self.spline(*parameter == Parameter::RationalSpline, octets, values)?;
                }
                Parameter::Precision if matches!(row.kind, Kind::RealPrecision | Kind::VdcRealPrecision) => {
                    values.push(Value::Integer(octets.signed(16)?));
                    values.push(Value::Integer(self.integer(octets)?));
                    values.push(Value::Integer(self.integer(octets)?));
                }
                // What is left, to which the element gives its sense.
                Parameter::Bits => {}
                single => values.push(self.single(*single, octets)?),
            }
        }
        Some(())
    }

    fn single(&self, parameter: Parameter, octets: &mut Octets<'_>) -> Option<Value> {
        let Coding { precisions, modes, .. } = self;
        let size = |mode: SizeMode, octets: &mut Octets<'_>| match mode {
            SizeMode::Absolute => self.coordinate(octets).map(Value::Real),
            _ => octets.real(precisions.real).map(Value::Real),
        };
        Some(match parameter {
            Parameter::Integer | Parameter::Precision => Value::Integer(self.integer(octets)?),
            Parameter::Index => Value::Integer(octets.signed(precisions.index)?),
            Parameter::Name => Value::Integer(octets.signed(precisions.name)?),
            Parameter::Enumeration(_) => Value::Integer(octets.signed(16)?),
            Parameter::Real => Value::Real(octets.real(precisions.real)?),
            Parameter::Metric => Value::Real(octets.real(match precisions.real {
                RealFormat::Float64 if octets.len() >= 8 => RealFormat::Float64,
                _ => RealFormat::Float32,
            })?),
            Parameter::Coordinate => Value::Real(self.coordinate(octets)?),
            Parameter::Point => Value::Point(self.point(octets)?),
            Parameter::Text => Value::Text(octets.string()?),
            Parameter::Data => Value::Data(octets.string()?),
            Parameter::ColourIndex => Value::Ink(Ink::Index(octets.unsigned(precisions.colour_index)?)),
            Parameter::DirectColour => Value::Ink(Ink::Direct(modes.colour(self.components(octets)?))),
            Parameter::Colour if modes.direct => self.single(Parameter::DirectColour, octets)?,
            Parameter::Colour => self.single(Parameter::ColourIndex, octets)?,
            Parameter::Component => Value::Real(f64::from(octets.unsigned(precisions.colour)?)),
            Parameter::Viewport if modes.device_viewport => {
                Value::Real(f64::from(octets.signed(precisions.integer)?))
            }
            Parameter::Viewport => Value::Real(octets.real(precisions.real)?),
            Parameter::LineWidth => size(modes.line_width, octets)?,
            Parameter::MarkerSize => size(modes.marker_size, octets)?,
            Parameter::EdgeWidth => size(modes.edge_width, octets)?,
            Parameter::StyleSize => size(modes.style_size, octets)?,
            Parameter::Cells => Value::Cells(self.cells(octets, true)?),
            Parameter::Pattern => Value::Cells(self.cells(octets, false)?),
            Parameter::ElementList | Parameter::Raw => Value::Data(octets.take_all().to_vec()),
            Parameter::Bits
            | Parameter::CountedPoints
            | Parameter::Spline
            | Parameter::RationalSpline
            | Parameter::Repeat(_) => return None,
        })
    }

    fn integer(&self, octets: &mut Octets<'_>) -> Option<i32> {
        octets.signed(self.precisions.integer)
    }

    fn coordinate(&self, octets: &mut Octets<'_>) -> Option<f64> {
        if self.modes.real_coordinates {
            octets.real(self.precisions.vdc_real)
        } else {
            octets.signed(self.precisions.vdc_integer).map(f64::from)
        }
    }

    fn point(&self, octets: &mut Octets<'_>) -> Option<DVec2> {
        Some(DVec2::new(self.coordinate(octets)?, self.coordinate(octets)?))
    }

    /// As many points, all of which must be there.
    fn points(&self, count: i32, octets: &mut Octets<'_>) -> Option<Vec<DVec2>> {
        (0..count).map(|_| self.point(octets)).collect()
    }

    fn components(&self, octets: &mut Octets<'_>) -> Option<[f64; 4]> {
        let mut components = [0.0; 4];
        for component in components.iter_mut().take(self.modes.model.components()) {
            *component = f64::from(octets.unsigned(self.precisions.colour)?);
        }
        Some(components)
    }

    /// Order, number of points, points, knots, the range of the parameter, and weights.
    fn spline(&self, rational: bool, octets: &mut Octets<'_>, values: &mut Vec<Value>) -> Option<()> {
        let (order, count) = (self.integer(octets)?, self.integer(octets)?);
        let points = self.points(count, octets)?;
        values.extend([Value::Integer(order), Value::Points(points)]);
        let knots = order.checked_add(count).filter(|&knots| knots > 0)?;
        let weights = if rational { count } else { 0 };
        for _ in 0..i64::from(knots) + 2 + i64::from(weights) {
            values.push(Value::Real(octets.real(self.precisions.real)?));
        }
        Some(())
    }

    /// Columns, rows, local colour precision, and colours; runs are known to cell arrays only.
    fn cells(&self, octets: &mut Octets<'_>, runs: bool) -> Option<Cells> {
        let (columns, rows) = (self.integer(octets)?, self.integer(octets)?);
        let local = self.integer(octets)?;
        let packed = !runs || octets.signed(16)? != 0;
        let (columns, rows) = (usize::try_from(columns).ok()?, usize::try_from(rows).ok()?);
        columns.checked_mul(rows).filter(|&count| count > 0)?;
        let precision = self.local_precision(local)?;
        let octets = octets.take_all();
        let inks = if packed {
            self.packed(columns, rows, precision, octets)
        } else {
            self.runs(columns, rows, precision, octets)
        }?;
        Some(Cells { columns, rows, inks })
    }

    /// The bits of a colour index or component of a cell: as many as are said, or as elsewhere.
    pub(super) fn local_precision(&self, local: i32) -> Option<u32> {
        match local {
            0 if self.modes.direct => Some(self.precisions.colour),
            0 => Some(self.precisions.colour_index),
            1 | 2 | 4 | 8 | 16 | 24 | 32 => Some(local as u32),
            _ => None,
        }
    }

    /// Every cell, rows on word boundaries. Every cell takes a bit at least, so that the octets bound them.
    fn packed(&self, columns: usize, rows: usize, precision: u32, octets: &[u8]) -> Option<Inks> {
        let mut bits = Bits::new(octets);
        let components = if self.modes.direct { self.modes.model.components() } else { 1 };
        let most = columns.checked_mul(rows)?;
        if most.checked_mul(components * precision as usize)? > octets.len() * 8 {
            return None;
        }
        let mut inks = self.inks();
        for _ in 0..rows {
            for _ in 0..columns {
                self.cell(&mut bits, precision, 1, most, &mut inks)?;
            }
            bits.align(16);
        }
        Some(inks)
    }

    /// Runs of a count and a colour, each row on a word boundary of its own.
    fn runs(&self, columns: usize, rows: usize, precision: u32, octets: &[u8]) -> Option<Inks> {
        let most = columns.checked_mul(rows).filter(|most| *most <= most_cells(octets.len()))?;
        let mut bits = Bits::new(octets);
        let mut inks = self.inks();
        for row in 0..rows {
            let end = (row + 1) * columns;
            while inks.len() < end {
                let count = bits.next(self.precisions.integer)? as usize;
                let count = count.min(end - inks.len());
                self.cell(&mut bits, precision, count, most, &mut inks)?;
            }
            bits.align(16);
        }
        Some(inks)
    }

    pub(super) fn inks(&self) -> Inks {
        if self.modes.direct { Inks::Direct(Vec::new()) } else { Inks::Indices(Vec::new()) }
    }

    /// Appends a colour several times to those of an array that has `most` of them in all.
    pub(super) fn cell(
        &self,
        bits: &mut Bits<'_>,
        precision: u32,
        count: usize,
        most: usize,
        inks: &mut Inks,
    ) -> Option<()> {
        match inks {
            Inks::Indices(indices) => {
                let index = bits.next(precision)?.min(i32::MAX as u32) as i32;
                repeat(indices, index, count, most);
            }
            Inks::Direct(colours) => {
                let mut components = [0.0; 4];
                // A local precision scales with it; the extent is for the precision of the metafile.
                let scale = f64::from(u32::MAX >> (32 - self.precisions.colour))
                    / f64::from(u32::MAX >> (32 - precision));
                for component in components.iter_mut().take(self.modes.model.components()) {
                    *component = f64::from(bits.next(precision)?) * scale;
                }
                let [red, green, blue, _] = self.modes.colour(components).to_bytes();
                repeat(colours, [red, green, blue], count, most);
            }
        }
        Some(())
    }
}
