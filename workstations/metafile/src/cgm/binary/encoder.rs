//! Elements into octets (ISO/IEC 8632-3).

use super::parameters::Coding;
use super::precision::{Precisions, RealFormat};
use crate::cgm::coding::SizeMode;
use crate::cgm::element::{Cells, Element, Ink, Inks, Value};
use crate::cgm::encoder::{Coordinates, Encoder, Grid};
use crate::cgm::parameter::Parameter;
use crate::generated::elements::Kind;
use gks_pipeline::colour::Colour;

/// The most octets of a partition: the largest even number that fits.
const PARTITION: usize = 32766;

/// Encodes in binary.
///
/// Integers and indices have 16 bits, real numbers 16 before and 16 after the binary point, or double precision where
/// coordinates are real too.
pub struct BinaryEncoder {
    coordinates: Coordinates,
    colour_index_bits: u32,
    coding: Coding,
    /// The octets of the metafile defaults replacement that is open.
    replacement: Option<Vec<u8>>,
    parameters: Vec<u8>,
}

impl BinaryEncoder {
    /// An encoder with a way to code coordinates and 8 or 16 bits for a colour index.
    pub fn new(coordinates: Coordinates, colour_index_bits: u32) -> Self {
        BinaryEncoder {
            coordinates,
            colour_index_bits,
            coding: Coding::default(),
            replacement: None,
            parameters: Vec::new(),
        }
    }

    fn list(&mut self, parameters: &[Parameter], values: &mut std::slice::Iter<'_, Value>) {
        for parameter in parameters {
            match parameter {
                Parameter::Repeat(group) => {
                    if let [Value::Points(points)] = values.as_slice() {
                        for point in points {
                            self.coordinate(point.x);
                            self.coordinate(point.y);
                        }
                        return;
                    }
                    while !values.as_slice().is_empty() {
                        self.list(group, values);
                    }
                }
                Parameter::ElementList => {
                    // The drawing set and the control set, as two indices each.
                    values.next();
                    for number in [1, -1, 1] {
                        self.signed(number, 16);
                    }
                }
                Parameter::Precision => {
                    for value in values.by_ref() {
                        self.single(Parameter::Integer, value);
                    }
                }
                single => {
                    if let Some(value) = values.next() {
                        self.single(*single, value);
                    }
                }
            }
        }
    }

    fn single(&mut self, parameter: Parameter, value: &Value) {
        let Precisions { integer, index, name, colour_index, real, .. } = self.coding.precisions;
        match (parameter, value) {
            (Parameter::Index, Value::Integer(n)) => self.signed(*n, index),
            (Parameter::Name, Value::Integer(n)) => self.signed(*n, name),
            (Parameter::Enumeration(_), Value::Integer(n)) => self.signed(*n, 16),
            (_, Value::Integer(n)) => self.signed(*n, integer),
            (Parameter::Coordinate, Value::Real(x)) => self.coordinate(*x),
            (Parameter::Metric, Value::Real(x)) => self.real(*x, RealFormat::Float32),
            (Parameter::LineWidth, Value::Real(x)) => self.size(*x, self.coding.modes.line_width),
            (Parameter::MarkerSize, Value::Real(x)) => self.size(*x, self.coding.modes.marker_size),
            (Parameter::EdgeWidth, Value::Real(x)) => self.size(*x, self.coding.modes.edge_width),
            (Parameter::StyleSize, Value::Real(x)) => self.size(*x, self.coding.modes.style_size),
            (_, Value::Real(x)) => self.real(*x, real),
            (_, Value::Point(p)) => {
                self.coordinate(p.x);
                self.coordinate(p.y);
            }
            (Parameter::CountedPoints, Value::Points(points)) => {
                self.signed(points.len().min(i16::MAX as usize) as i32, integer);
                for point in points {
                    self.coordinate(point.x);
                    self.coordinate(point.y);
                }
            }
            (Parameter::Text | Parameter::Data, Value::Text(bytes) | Value::Data(bytes)) => {
                self.string(bytes);
            }
            (_, Value::Text(bytes) | Value::Data(bytes)) => self.parameters.extend_from_slice(bytes),
            (_, Value::Ink(Ink::Index(index))) => self.signed(*index as i32, colour_index),
            (_, Value::Ink(Ink::Direct(colour))) => self.colour(*colour),
            (Parameter::Cells, Value::Cells(cells)) => self.cells(cells, true),
            (_, Value::Cells(cells)) => self.cells(cells, false),
            (_, Value::Points(_)) => {}
        }
    }

    fn signed(&mut self, number: i32, bits: u32) {
        let octets = number.to_be_bytes();
        self.parameters.extend_from_slice(&octets[4 - bits as usize / 8..]);
    }

    fn coordinate(&mut self, x: f64) {
        if self.coding.modes.real_coordinates {
            self.real(x, self.coding.precisions.vdc_real);
        } else {
            let bits = self.coding.precisions.vdc_integer;
            let most = f64::from(i32::MAX >> (32 - bits));
            self.signed(x.round().clamp(-most, most) as i32, bits);
        }
    }

    fn size(&mut self, x: f64, mode: SizeMode) {
        match mode {
            SizeMode::Absolute => self.coordinate(x),
            _ => self.real(x, self.coding.precisions.real),
        }
    }

    fn real(&mut self, x: f64, format: RealFormat) {
        let fixed = |scale: f64, most: f64| (x.clamp(-most, most) * scale).round() as i64;
        match format {
            RealFormat::Fixed32 => {
                let number = fixed(65536.0, 32767.0) as i32;
                self.parameters.extend_from_slice(&number.to_be_bytes());
            }
            RealFormat::Fixed64 => {
                let number = fixed(4_294_967_296.0, 2_147_483_647.0);
                self.parameters.extend_from_slice(&number.to_be_bytes());
            }
            RealFormat::Float32 => self.parameters.extend_from_slice(&(x as f32).to_be_bytes()),
            RealFormat::Float64 => self.parameters.extend_from_slice(&x.to_be_bytes()),
        }
    }

    fn string(&mut self, bytes: &[u8]) {
        if bytes.len() < 255 {
            self.parameters.push(bytes.len() as u8);
            self.parameters.extend_from_slice(bytes);
            return;
        }
        self.parameters.push(255);
        let mut parts = bytes.chunks(0x7fff).peekable();
        while let Some(part) = parts.next() {
            let more = if parts.peek().is_some() { 0x8000 } else { 0 };
            self.parameters.extend_from_slice(&(part.len() as u16 | more).to_be_bytes());
            self.parameters.extend_from_slice(part);
        }
    }

    fn colour(&mut self, colour: Colour) {
        for component in self.coding.modes.components(colour) {
            self.signed(component.round() as i32, self.coding.precisions.colour);
        }
    }

    /// Columns, rows, the default colour precision, and the packed colours.
    fn cells(&mut self, cells: &Cells, representation: bool) {
        for count in [cells.columns, cells.rows] {
            self.signed(count.min(i16::MAX as usize) as i32, self.coding.precisions.integer);
        }
        self.signed(0, self.coding.precisions.integer);
        if representation {
            self.signed(1, 16);
        }
        let bits = self.coding.precisions.colour_index;
        for row in 0..cells.rows {
            let start = self.parameters.len();
            let range = row * cells.columns..(row + 1) * cells.columns;
            match &cells.inks {
                Inks::Indices(indices) => {
                    for index in indices.get(range).unwrap_or_default() {
                        self.signed(*index, bits);
                    }
                }
                Inks::Direct(colours) => {
                    self.parameters.extend(colours.get(range).unwrap_or_default().iter().flatten());
                }
            }
            if (self.parameters.len() - start) % 2 == 1 {
                self.parameters.push(0);
            }
        }
    }
}

/// Appends an element with its header, in partitions if it is long.
fn frame(class: u8, id: u8, octets: &[u8], out: &mut Vec<u8>) {
    let code = u16::from(class) << 12 | u16::from(id) << 5;
    if octets.len() < 31 {
        out.extend_from_slice(&(code | octets.len() as u16).to_be_bytes());
        out.extend_from_slice(octets);
    } else {
        out.extend_from_slice(&(code | 31).to_be_bytes());
        let mut parts = octets.chunks(PARTITION).peekable();
        while let Some(part) = parts.next() {
            let more = if parts.peek().is_some() { 0x8000 } else { 0 };
            out.extend_from_slice(&(part.len() as u16 | more).to_be_bytes());
            out.extend_from_slice(part);
        }
    }
    if octets.len() % 2 == 1 {
        out.push(0);
    }
}

impl Encoder for BinaryEncoder {
    fn encode(&mut self, element: &Element, out: &mut Vec<u8>) {
        let row = element.kind.row();
        match element.kind {
            Kind::BeginMetafileDefaultsReplacement => {
                self.replacement = Some(Vec::new());
                return;
            }
            Kind::EndMetafileDefaultsReplacement => {
                if let Some(octets) = self.replacement.take() {
                    frame(row.class, Kind::BeginMetafileDefaultsReplacement.row().id, &octets, out);
                }
                return;
            }
            _ => {}
        }
        self.parameters.clear();
        self.list(row.parameters, &mut element.values.iter());
        let target = self.replacement.as_mut().unwrap_or(out);
        frame(row.class, row.id, &self.parameters, target);
        self.coding.observe(element);
    }

    fn precisions(&self) -> Vec<Element> {
        let mut elements = vec![
            Precisions::element(Kind::IntegerPrecision, 16),
            Precisions::real_element(Kind::RealPrecision, RealFormat::Fixed32),
            Precisions::element(Kind::IndexPrecision, 16),
            Precisions::element(Kind::ColourPrecision, 8),
            Precisions::element(Kind::ColourIndexPrecision, self.colour_index_bits),
        ];
        if self.coordinates == Coordinates::Real {
            elements[1] = Precisions::real_element(Kind::RealPrecision, RealFormat::Float64);
        }
        elements
    }

    fn coordinate_precisions(&self) -> Vec<Element> {
        match self.coordinates {
            Coordinates::Integer16 => Vec::new(),
            Coordinates::Integer32 => vec![Precisions::element(Kind::VdcIntegerPrecision, 32)],
            Coordinates::Real => vec![Precisions::real_element(Kind::VdcRealPrecision, RealFormat::Float64)],
        }
    }

    fn grid(&self) -> Grid {
        self.coordinates.grid()
    }

    fn most_colour(&self) -> u32 {
        u32::MAX >> (32 - self.colour_index_bits)
    }
}
