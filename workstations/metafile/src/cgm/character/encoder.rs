//! Elements into characters.

use super::RealCoding;
use crate::cgm::coding::{Modes, SizeMode};
use crate::cgm::element::{Cells, Element, Ink, Inks, Value};
use crate::cgm::encoder::{Coordinates, Encoder, Grid};
use crate::cgm::parameter::Parameter;
use crate::generated::elements::Kind;
use glam::DVec2;

/// The exponent of 2 of the last digit of real numbers.
const EXPONENT: i32 = -16;

/// Encodes in characters; coordinates are integers.
pub struct CharacterEncoder {
    modes: Modes,
    real: RealCoding,
    out: Vec<u8>,
}

impl Default for CharacterEncoder {
    fn default() -> Self {
        CharacterEncoder::new()
    }
}

impl CharacterEncoder {
    /// An encoder.
    pub fn new() -> CharacterEncoder {
        CharacterEncoder {
            modes: Modes::new(255.0),
            real: RealCoding { exponent: EXPONENT, explicit: false },
            out: Vec::new(),
        }
    }

    /// A signed number, most significant bits first: four bits in the first character, five in each other.
    fn integer(&mut self, number: i64) {
        let magnitude = number.unsigned_abs();
        let mut groups = 0;
        while magnitude >> (4 + 5 * groups) != 0 {
            groups += 1;
        }
        let sign = if number < 0 { 0x10 } else { 0 };
        let more = |left: u32| if left > 0 { 0x20 } else { 0 };
        self.out.push(0x40 | more(groups) | sign | (magnitude >> (5 * groups)) as u8);
        for left in (0..groups).rev() {
            self.out.push(0x40 | more(left) | (magnitude >> (5 * left) & 0x1f) as u8);
        }
    }

    fn real(&mut self, x: f64) {
        let scaled = x * f64::from(-self.real.exponent).exp2();
        self.integer(scaled.round().clamp(-1e15, 1e15) as i64);
    }

    fn coordinate(&mut self, x: f64) {
        self.integer(x.round() as i64);
    }

    fn size(&mut self, x: f64, mode: SizeMode) {
        match mode {
            SizeMode::Absolute => self.coordinate(x),
            _ => self.real(x),
        }
    }

    /// Each point as its displacement from the one before.
    fn points<'a>(&mut self, points: impl Iterator<Item = (&'a DVec2, Option<i32>)>) {
        let mut last = DVec2::ZERO;
        for (point, flag) in points {
            let at = point.round();
            self.coordinate(at.x - last.x);
            self.coordinate(at.y - last.y);
            if let Some(flag) = flag {
                self.integer(i64::from(flag));
            }
            last = at;
        }
    }

    fn string(&mut self, bytes: &[u8]) {
        self.out.extend_from_slice(b"\x1bX");
        // What would end the string has no place in it.
        self.out.extend(bytes.iter().filter(|byte| **byte != 0x1b));
        self.out.extend_from_slice(b"\x1b\\");
    }

    /// Red, green and blue, two bits of each in a character.
    fn direct(&mut self, components: [u8; 3]) {
        for shift in [6, 4, 2, 0] {
            let mut character = 0x40;
            for (i, component) in components.iter().enumerate() {
                let two = component >> shift & 3;
                character |= (two >> 1) << (5 - i) | (two & 1) << (2 - i);
            }
            self.out.push(character);
        }
    }

    fn list(&mut self, parameters: &[Parameter], values: &mut std::slice::Iter<'_, Value>) {
        for parameter in parameters {
            match (parameter, values.as_slice()) {
                (Parameter::Repeat(_), [Value::Points(points)]) => {
                    self.points(points.iter().map(|point| (point, None)));
                    return;
                }
                (Parameter::Repeat([Parameter::Point, _]), rest) => {
                    let pairs = rest.chunks_exact(2).filter_map(|pair| match pair {
                        [Value::Point(point), Value::Integer(flag)] => Some((point, Some(*flag))),
                        _ => None,
                    });
                    self.points(pairs);
                    return;
                }
                (Parameter::Repeat(group), rest) => {
                    if *group == [Parameter::DirectColour] {
                        // A list of colours one by one.
                        self.out.push(0x40);
                    }
                    if !rest.is_empty() {
                        while !values.as_slice().is_empty() {
                            self.list(group, values);
                        }
                    }
                }
                (Parameter::Precision, rest) => {
                    let numbers: Vec<i32> = rest
                        .iter()
                        .filter_map(|value| if let Value::Integer(n) = value { Some(*n) } else { None })
                        .collect();
                    for number in numbers {
                        self.integer(i64::from(number));
                    }
                    return;
                }
                (Parameter::ElementList, _) => {
                    values.next();
                    // The drawing set and the control set.
                    self.string(b"A");
                }
                _ => {
                    if let Some(value) = values.next() {
                        self.single(*parameter, value);
                    }
                }
            }
        }
    }

    fn single(&mut self, parameter: Parameter, value: &Value) {
        match (parameter, value) {
            (_, Value::Integer(n)) => self.integer(i64::from(*n)),
            (Parameter::Coordinate, Value::Real(x)) => self.coordinate(*x),
            (Parameter::LineWidth, Value::Real(x)) => self.size(*x, self.modes.line_width),
            (Parameter::MarkerSize, Value::Real(x)) => self.size(*x, self.modes.marker_size),
            (Parameter::EdgeWidth, Value::Real(x)) => self.size(*x, self.modes.edge_width),
            (Parameter::StyleSize, Value::Real(x)) => self.size(*x, self.modes.style_size),
            (_, Value::Real(x)) => self.real(*x),
            (_, Value::Point(p)) => {
                self.coordinate(p.x);
                self.coordinate(p.y);
            }
            (_, Value::Points(points)) => self.points(points.iter().map(|point| (point, None))),
            (_, Value::Text(bytes) | Value::Data(bytes)) => self.string(bytes),
            (_, Value::Ink(Ink::Index(index))) => self.integer(i64::from(*index)),
            (_, Value::Ink(Ink::Direct(colour))) => {
                let [red, green, blue, _] = colour.to_bytes();
                self.direct([red, green, blue]);
            }
            (_, Value::Cells(cells)) => self.cells(cells),
        }
    }

    fn cells(&mut self, cells: &Cells) {
        for number in [cells.columns, cells.rows, 0] {
            self.integer(number as i64);
        }
        self.out.push(0x40);
        match &cells.inks {
            Inks::Indices(indices) => {
                for index in indices {
                    self.integer(i64::from(*index));
                }
            }
            Inks::Direct(colours) => {
                for colour in colours {
                    self.direct(*colour);
                }
            }
        }
    }
}

impl Encoder for CharacterEncoder {
    fn encode(&mut self, element: &Element, out: &mut Vec<u8>) {
        let row = element.kind.row();
        if row.opcode.is_empty() {
            return;
        }
        self.out.clear();
        self.out.extend_from_slice(row.opcode);
        self.list(row.parameters, &mut element.values.iter());
        out.append(&mut self.out);
        self.modes.observe(element);
    }

    fn precisions(&self) -> Vec<Element> {
        let element = |kind, numbers: &[i32]| {
            Element::new(kind, numbers.iter().map(|&n| Value::Integer(n)).collect::<Vec<_>>())
        };
        vec![
            element(Kind::IntegerPrecision, &[31]),
            // The largest power of 2, that of the last digit, that of all numbers, and that no other is written.
            element(Kind::RealPrecision, &[16, EXPONENT, EXPONENT, 1]),
            element(Kind::IndexPrecision, &[16]),
            element(Kind::ColourPrecision, &[8]),
            element(Kind::ColourIndexPrecision, &[16]),
        ]
    }

    fn coordinate_precisions(&self) -> Vec<Element> {
        vec![Element::new(Kind::VdcIntegerPrecision, [Value::Integer(31)])]
    }

    fn grid(&self) -> Grid {
        Coordinates::Integer32.grid()
    }

    fn most_colour(&self) -> u32 {
        65535
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cgm::character::decoder::CharacterDecoder;
    use crate::cgm::decoder::Decoder;
    use gks_pipeline::colour::Colour;

    #[test]
    fn elements_come_back() {
        let integer = Value::Integer;
        let colours = [Colour::rgb(1.0, 0.0, 0.2), Colour::BLACK].map(|c| Value::Ink(Ink::Direct(c)));
        let mut table = vec![Value::Ink(Ink::Index(300))];
        table.extend(colours);
        let cells = Cells { columns: 2, rows: 1, inks: Inks::Indices(vec![70, 0]) };
        let elements = [
            Element::new(Kind::BeginMetafile, [Value::Text(b"name".to_vec())]),
            Element::new(Kind::ColourPrecision, [integer(8)]),
            Element::new(Kind::RealPrecision, [16, EXPONENT, EXPONENT, 1].map(integer)),
            Element::new(Kind::ColourTable, table),
            Element::new(
                Kind::Polyline,
                [Value::Points(vec![DVec2::new(-5.0, 70000.0), DVec2::new(3.0, 1.0)])],
            ),
            Element::new(Kind::LineWidth, [Value::Real(2.5)]),
            Element::new(Kind::Text, [Value::Point(DVec2::ONE), integer(1), Value::Text(b"A 0!".to_vec())]),
            Element::new(Kind::PatternTable, [integer(1), Value::Cells(cells)]),
            Element::new(
                Kind::PolygonSet,
                [Value::Point(DVec2::ONE), integer(1), Value::Point(DVec2::ZERO), integer(3)],
            ),
        ];
        let (mut encoder, mut out) = (CharacterEncoder::new(), Vec::new());
        for element in &elements {
            encoder.encode(element, &mut out);
        }
        let mut decoder = CharacterDecoder::new(&out[..]);
        for element in elements {
            assert_eq!(decoder.next().unwrap(), Some(element));
        }
        assert_eq!(decoder.next().unwrap(), None);
        assert!(decoder.skipped().is_empty());
    }
}
