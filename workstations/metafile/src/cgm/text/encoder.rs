//! Elements into words (ISO/IEC 8632-4).

use crate::cgm::coding::Modes;
use crate::cgm::element::{Cells, Element, Ink, Inks, Value};
use crate::cgm::encoder::{Coordinates, Encoder, Grid};
use crate::cgm::parameter::Parameter;
use crate::generated::elements::Kind;
use gks_pipeline::colour::Colour;

/// How long lines may become.
const COLUMNS: usize = 76;

/// Encodes in clear text, an element a line as long as it fits.
pub struct TextEncoder {
    modes: Modes,
    line: String,
    column: usize,
}

impl TextEncoder {
    /// An encoder; coordinates are real numbers.
    pub fn new() -> TextEncoder {
        TextEncoder { modes: Modes::new(255.0), line: String::new(), column: 0 }
    }

    fn word(&mut self, word: &str) {
        if self.column + word.len() >= COLUMNS && self.column > 0 {
            self.line.push_str("\n ");
            self.column = 1;
        }
        if !self.line.is_empty() {
            self.line.push(' ');
            self.column += 1;
        }
        self.line.push_str(word);
        self.column += word.len();
    }

    fn real(&mut self, x: f64) {
        self.word(&number(x));
    }

    fn point(&mut self, x: f64, y: f64) {
        self.word(&format!("({},{})", number(x), number(y)));
    }

    fn colour(&mut self, colour: Colour) {
        for component in self.modes.components(colour) {
            self.word(&format!("{}", component.round()));
        }
    }

    fn string(&mut self, bytes: &[u8]) {
        // A string is not broken; what is not ASCII is kept as it is, octet by octet.
        let text: String = match std::str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        };
        self.word(&format!("'{}'", text.replace('\'', "''")));
    }

    fn list(&mut self, parameters: &[Parameter], values: &mut std::slice::Iter<'_, Value>) {
        for parameter in parameters {
            match parameter {
                Parameter::Repeat(group) if !matches!(values.as_slice(), [Value::Points(_)]) => {
                    while !values.as_slice().is_empty() {
                        self.list(group, values);
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
        match (parameter, value) {
            (Parameter::Enumeration(words), Value::Integer(n)) => {
                let word = usize::try_from(*n).ok().and_then(|n| words.get(n));
                match word {
                    Some(word) => self.word(word),
                    None => self.word(&n.to_string()),
                }
            }
            (_, Value::Integer(n)) => self.word(&n.to_string()),
            (_, Value::Real(x)) => self.real(*x),
            (_, Value::Point(p)) => self.point(p.x, p.y),
            (_, Value::Points(points)) => {
                for p in points {
                    self.point(p.x, p.y);
                }
            }
            (_, Value::Text(bytes) | Value::Data(bytes)) => self.string(bytes),
            (_, Value::Ink(Ink::Index(index))) => self.word(&index.to_string()),
            (_, Value::Ink(Ink::Direct(colour))) => self.colour(*colour),
            (_, Value::Cells(cells)) => self.cells(cells),
        }
    }

    /// Columns, rows, the default colour precision, and the colours.
    fn cells(&mut self, cells: &Cells) {
        for count in [cells.columns, cells.rows, 0] {
            self.word(&count.to_string());
        }
        match &cells.inks {
            Inks::Indices(indices) => {
                for index in indices {
                    self.word(&index.to_string());
                }
            }
            Inks::Direct(colours) => {
                for component in colours.iter().flatten() {
                    self.word(&component.to_string());
                }
            }
        }
    }
}

impl Default for TextEncoder {
    fn default() -> Self {
        TextEncoder::new()
    }
}

/// A real number with all its digits; what is far smaller than the others is nothing.
fn number(x: f64) -> String {
    let x = if x.is_finite() && x.abs() > 1e-30 { x } else { 0.0 };
    x.to_string()
}

impl Encoder for TextEncoder {
    fn encode(&mut self, element: &Element, out: &mut Vec<u8>) {
        let row = element.kind.row();
        if row.keyword.is_empty() {
            return;
        }
        (self.line, self.column) = (String::new(), 0);
        self.word(row.keyword);
        match element.kind {
            // Ranges, where the binary encoding has bits.
            Kind::IntegerPrecision => self.range(-32768, 32767),
            Kind::IndexPrecision => self.range(-32768, 32767),
            Kind::ColourPrecision => self.word("255"),
            Kind::ColourIndexPrecision => self.word("65535"),
            Kind::RealPrecision | Kind::VdcRealPrecision => {
                for word in ["-32768.", "32767.", "17"] {
                    self.word(word);
                }
            }
            _ => self.list(row.parameters, &mut element.values.iter()),
        }
        self.line.push_str(";\n");
        out.extend_from_slice(self.line.as_bytes());
        self.modes.observe(element);
    }

    fn precisions(&self) -> Vec<Element> {
        let element = |kind| Element::new(kind, []);
        [
            Kind::IntegerPrecision,
            Kind::RealPrecision,
            Kind::IndexPrecision,
            Kind::ColourPrecision,
            Kind::ColourIndexPrecision,
        ]
        .map(element)
        .to_vec()
    }

    fn coordinate_precisions(&self) -> Vec<Element> {
        vec![Element::new(Kind::VdcRealPrecision, [])]
    }

    fn grid(&self) -> Grid {
        Coordinates::Real.grid()
    }

    fn most_colour(&self) -> u32 {
        65535
    }
}

impl TextEncoder {
    fn range(&mut self, least: i32, most: i32) {
        self.word(&least.to_string());
        self.word(&most.to_string());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn encoded(kind: Kind, values: impl Into<Vec<Value>>) -> String {
        let mut out = Vec::new();
        TextEncoder::new().encode(&Element::new(kind, values), &mut out);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn elements_are_lines_of_words() {
        let points = Value::Points(vec![DVec2::ZERO, DVec2::new(0.5, -0.25)]);
        assert_eq!(encoded(Kind::Polyline, [points]), "LINE (0,0) (0.5,-0.25);\n");
        let text = [Value::Point(DVec2::ONE), Value::Integer(1), Value::Text(b"it's".to_vec())];
        assert_eq!(encoded(Kind::Text, text), "TEXT (1,1) final 'it''s';\n");
        let white = Value::Ink(Ink::Direct(Colour::WHITE));
        let table = encoded(Kind::ColourTable, [Value::Ink(Ink::Index(7)), white]);
        assert_eq!(table, "COLRTABLE 7 255 255 255;\n");
    }

    #[test]
    fn long_elements_are_broken_into_lines() {
        let points = Value::Points(vec![DVec2::new(0.123_456_789, 0.5); 40]);
        let text = encoded(Kind::Polygon, [points]);
        assert!(text.lines().count() > 5 && text.lines().all(|line| line.len() <= COLUMNS + 1));
    }
}
