//! Elements out of characters.

use super::RealCoding;
use super::operand::{Bits, OPERAND, Operands};
use crate::cgm::coding::{Modes, SizeMode};
use crate::cgm::decoder::{Decoder, senseless, unknown};
use crate::cgm::element::{Cells, Element, Ink, Inks, Value, most_cells, repeat};
use crate::cgm::parameter::Parameter;
use crate::generated::elements::{ELEMENTS, Kind};
use gks_pipeline::record::{Skipped, SourceError};
use glam::DVec2;
use std::io::{ErrorKind, Read};

/// The most colours that a table may be given at once.
const MOST_COLOURS: usize = 1 << 16;

/// What earlier elements say about how later ones are coded.
#[derive(Clone, Debug)]
struct Coding {
    modes: Modes,
    real: RealCoding,
    vdc: RealCoding,
    /// Bits of components of direct colours.
    colour: u32,
    /// Bits of colour indices in bit streams.
    colour_index: u32,
}

impl Default for Coding {
    fn default() -> Self {
        let (real, vdc) = (RealCoding::DEFAULT, RealCoding::DEFAULT);
        Coding { modes: Modes::new(63.0), real, vdc, colour: 6, colour_index: 6 }
    }
}

/// Decodes the character encoding. Displacements in chain code are not known; points end where they begin.
pub struct CharacterDecoder<R> {
    input: R,
    buffer: Vec<u8>,
    at: usize,
    coding: Coding,
    defaults: Option<Coding>,
    /// An opcode that has been read.
    opcode: Option<Vec<u8>>,
    /// The control characters that are written as a tilde and another character.
    substitutes: bool,
    skipped: Skipped,
    ended: bool,
}

impl<R: Read> CharacterDecoder<R> {
    /// A decoder of what is read from `input`.
    pub fn new(input: R) -> Self {
        CharacterDecoder {
            input,
            buffer: Vec::new(),
            at: 0,
            coding: Coding::default(),
            defaults: None,
            opcode: None,
            substitutes: false,
            skipped: Skipped::default(),
            ended: false,
        }
    }

    fn octet(&mut self) -> Result<Option<u8>, SourceError> {
        while self.at >= self.buffer.len() {
            self.buffer.resize(1 << 14, 0);
            self.at = 0;
            match self.input.read(&mut self.buffer) {
                Ok(count) => {
                    self.buffer.truncate(count);
                    if count == 0 {
                        return Ok(None);
                    }
                }
                Err(error) => {
                    self.buffer.clear();
                    if error.kind() != ErrorKind::Interrupted {
                        return Err(error.into());
                    }
                }
            }
        }
        self.at += 1;
        Ok(self.buffer.get(self.at - 1).copied())
    }

    /// The next character, with substitutes replaced by what they stand for.
    fn character(&mut self) -> Result<Option<u8>, SourceError> {
        let first = self.octet()?;
        if !self.substitutes || first != Some(b'~') {
            return Ok(first);
        }
        Ok(self.octet()?.map(|second| match second {
            0x40..=0x60 => second - 0x40,
            0x3f => 0x7f,
            0x3e => b'~',
            other => other,
        }))
    }

    /// The substitution string of BEGIN METAFILE: the characters that a tilde and another one stand for from here on,
    /// in their substitutes.
    fn substitution(&mut self) -> Result<(), SourceError> {
        while let Some(first) = self.octet()? {
            if first != b'~' {
                // What comes after the string, or the terminator of it.
                self.at -= 1;
                break;
            }
            self.substitutes = true;
            // The terminator itself, as substitutes have it.
            if self.octet()? == Some(b'[') {
                match self.octet()? {
                    Some(b'\\') => break,
                    Some(_) => self.at -= 1,
                    None => {}
                }
            }
        }
        Ok(())
    }

    /// The opcode that comes next, after what belongs to none.
    fn next_opcode(&mut self) -> Result<Option<Vec<u8>>, SourceError> {
        if let Some(opcode) = self.opcode.take() {
            return Ok(Some(opcode));
        }
        while let Some(character) = self.character()? {
            if let Some(opcode) = self.opcode_from(character)? {
                return Ok(Some(opcode));
            }
        }
        Ok(None)
    }

    /// The opcode that begins with a character; none if it begins none.
    fn opcode_from(&mut self, character: u8) -> Result<Option<Vec<u8>>, SourceError> {
        match character {
            0x20..=0x2f => Ok(Some(vec![character])),
            0x30..=0x3f => {
                let mut opcode = vec![character];
                // The last character of column 3 leads to further ones.
                while opcode.last() == Some(&0x3f) && opcode.len() < 8 {
                    let Some(next) = self.character()? else { break };
                    opcode.push(next);
                }
                opcode.extend(self.character()?);
                Ok(Some(opcode))
            }
            _ => Ok(None),
        }
    }

    /// The operands up to the next opcode, which is kept.
    fn operands(&mut self) -> Result<Vec<u8>, SourceError> {
        let mut operands = Vec::new();
        while let Some(character) = self.character()? {
            match character {
                0x1b | 0x98 => {
                    operands.push(character);
                    self.string(character, &mut operands)?;
                }
                _ if character & OPERAND != 0 => operands.push(character & 0x7f),
                0x20..=0x3f => {
                    self.opcode = self.opcode_from(character)?;
                    break;
                }
                _ => {}
            }
        }
        Ok(operands)
    }

    /// The rest of a string, with its terminator.
    fn string(&mut self, start: u8, out: &mut Vec<u8>) -> Result<(), SourceError> {
        if start == 0x1b {
            if self.character()? != Some(b'X') {
                // Another escape sequence, which is none of the operands.
                out.pop();
                return Ok(());
            }
            out.push(b'X');
        }
        while let Some(character) = self.character()? {
            out.push(character);
            if start == 0x98 && character == 0x9c {
                break;
            }
            if character == 0x1b {
                let second = self.character()?;
                out.extend(second);
                if second == Some(b'\\') {
                    break;
                }
            }
        }
        Ok(())
    }

    fn element(&mut self) -> Result<Option<Element>, SourceError> {
        while !self.ended {
            let Some(opcode) = self.next_opcode()? else { break };
            let row = ELEMENTS.iter().find(|row| !row.opcode.is_empty() && row.opcode == opcode);
            if row.is_some_and(|row| row.kind == Kind::BeginMetafile) {
                self.substitutes = false;
                self.substitution()?;
            }
            let operands = self.operands()?;
            let Some(row) = row else {
                self.skipped.add(&unknown(opcode.escape_ascii()));
                continue;
            };
            match row.kind {
                Kind::BeginMetafile => (self.coding, self.defaults) = (Coding::default(), None),
                Kind::EndMetafile => self.substitutes = false,
                Kind::BeginPicture => {
                    self.coding = self.defaults.get_or_insert_with(|| self.coding.clone()).clone();
                }
                _ => {}
            }
            let mut operands = Operands::new(&operands);
            // A terminator of the substitution string leaves its second character.
            while row.kind == Kind::BeginMetafile && operands.character().is_some() {}
            let mut element = Element::new(row.kind, []);
            let complete = self.coding.list(row.parameters, &mut operands, &mut element.values).is_some();
            if operands.is_chain() {
                self.skipped.add("points in chain code");
            } else if !complete && !operands.is_empty() {
                self.skipped.add(&senseless(row));
            }
            self.coding.observe(&element);
            return Ok(Some(element));
        }
        self.ended = true;
        Ok(None)
    }
}

impl Coding {
    fn observe(&mut self, element: &Element) {
        self.modes.observe(element);
        let number = |place: usize| element.integer(place);
        let real = |old: RealCoding| RealCoding {
            exponent: number(2).unwrap_or(old.exponent).clamp(-1000, 1000),
            explicit: number(3).map_or(old.explicit, |forbidden| forbidden == 0),
        };
        let bits = number(0).and_then(|bits| u32::try_from(bits).ok()).filter(|bits| (1..=32).contains(bits));
        match element.kind {
            Kind::RealPrecision => self.real = real(self.real),
            Kind::VdcRealPrecision => self.vdc = real(self.vdc),
            Kind::ColourPrecision => {
                self.colour = bits.unwrap_or(self.colour).min(16);
                self.modes.extent.1 = [f64::from(u32::MAX >> (32 - self.colour)); 4];
            }
            Kind::ColourIndexPrecision => self.colour_index = bits.unwrap_or(self.colour_index),
            _ => {}
        }
    }

    fn list(
        &self,
        parameters: &[Parameter],
        operands: &mut Operands<'_>,
        values: &mut Vec<Value>,
    ) -> Option<()> {
        for parameter in parameters {
            match parameter {
                Parameter::Repeat([Parameter::Point]) | Parameter::CountedPoints => {
                    let mut at = Displaced::new(self);
                    values.push(Value::Points(std::iter::from_fn(|| at.point(self, operands)).collect()));
                }
                Parameter::Repeat([Parameter::Point, flag]) => {
                    let mut at = Displaced::new(self);
                    while let Some(point) = at.point(self, operands) {
                        values.push(Value::Point(point));
                        values.push(self.single(*flag, operands)?);
                    }
                }
                Parameter::Repeat([Parameter::DirectColour]) => {
                    let Inks::Direct(colours) = self.inks(MOST_COLOURS, self.colour, true, operands)? else {
                        return None;
                    };
                    let colour = |[r, g, b]: [u8; 3]| [r, g, b].map(|c| f32::from(c) / 255.0);
                    values.extend(colours.into_iter().map(colour).map(|[red, green, blue]| {
                        Value::Ink(Ink::Direct(gks_pipeline::colour::Colour::rgb(red, green, blue)))
                    }));
                }
                Parameter::Repeat([Parameter::Component]) => {
                    // Components come three by three: the least ones and the greatest ones.
                    while let Some(components) = operands.components(self.colour) {
                        values.extend(components.map(Value::Real));
                    }
                }
                Parameter::Repeat(group) => {
                    while !operands.is_empty() {
                        self.list(group, operands, values)?;
                    }
                }
                Parameter::Precision => {
                    while let Some(number) = operands.integer() {
                        values.push(Value::Integer(number.clamp(-1_000_000, 1_000_000) as i32));
                    }
                }
                Parameter::ElementList => return Some(()),
                single => values.push(self.single(*single, operands)?),
            }
        }
        Some(())
    }

    fn single(&self, parameter: Parameter, operands: &mut Operands<'_>) -> Option<Value> {
        let size = |mode: SizeMode, operands: &mut Operands<'_>| match mode {
            SizeMode::Absolute => self.coordinate(operands),
            _ => operands.real(self.real, None),
        };
        let modes = &self.modes;
        Some(match parameter {
            Parameter::Integer | Parameter::Index | Parameter::Name | Parameter::Enumeration(_) => {
                Value::Integer(operands.integer()?.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32)
            }
            Parameter::Real | Parameter::Metric => Value::Real(operands.real(self.real, None)?),
            Parameter::Coordinate => Value::Real(self.coordinate(operands)?),
            Parameter::Point => {
                Value::Point(DVec2::new(self.coordinate(operands)?, self.coordinate(operands)?))
            }
            Parameter::Text => Value::Text(operands.string()?),
            Parameter::Data => Value::Data(operands.string()?),
            Parameter::ColourIndex => Value::Ink(Ink::Index(u32::try_from(operands.integer()?).ok()?)),
            Parameter::DirectColour => Value::Ink(self.direct(self.colour, operands)?),
            Parameter::Colour if modes.direct => Value::Ink(self.direct(self.colour, operands)?),
            Parameter::Colour => self.single(Parameter::ColourIndex, operands)?,
            Parameter::LineWidth => Value::Real(size(modes.line_width, operands)?),
            Parameter::MarkerSize => Value::Real(size(modes.marker_size, operands)?),
            Parameter::EdgeWidth => Value::Real(size(modes.edge_width, operands)?),
            Parameter::StyleSize => Value::Real(size(modes.style_size, operands)?),
            Parameter::Cells | Parameter::Pattern => Value::Cells(self.cells(operands)?),
            _ => return None,
        })
    }

    fn coordinate(&self, operands: &mut Operands<'_>) -> Option<f64> {
        if self.modes.real_coordinates {
            operands.real(self.vdc, None)
        } else {
            operands.integer().map(|n| n as f64)
        }
    }

    fn direct(&self, bits: u32, operands: &mut Operands<'_>) -> Option<Ink> {
        let [red, green, blue] = operands.components(bits)?;
        Some(Ink::Direct(self.modes.colour([red, green, blue, 0.0])))
    }

    /// Columns, rows, local colour precision, and a list of colours.
    fn cells(&self, operands: &mut Operands<'_>) -> Option<Cells> {
        let mut size = || operands.integer().and_then(|n| usize::try_from(n).ok());
        let (columns, rows, local) = (size()?, size()?, size()?);
        let most = most_cells(operands.len());
        let count = columns.checked_mul(rows).filter(|count| (1..=most).contains(count))?;
        let default = if self.modes.direct { self.colour } else { self.colour_index };
        let precision = if local == 0 { default } else { u32::try_from(local).ok().filter(|p| *p <= 32)? };
        let inks = self.inks(count, precision, self.modes.direct, operands)?;
        (inks.len() == count).then_some(Cells { columns, rows, inks })
    }

    /// A list of at most so many colours: one by one or in runs, as operands or as bits.
    fn inks(&self, most: usize, bits: u32, direct: bool, operands: &mut Operands<'_>) -> Option<Inks> {
        let form = operands.character()? & 3;
        let (streamed, runs) = (form & 1 == 1, form & 2 == 2);
        let mut inks = if direct { Inks::Direct(Vec::new()) } else { Inks::Indices(Vec::new()) };
        if streamed && !runs {
            let mut stream = Bits::new(operands);
            while inks.len() < most {
                match &mut inks {
                    Inks::Indices(indices) => match stream.next(bits) {
                        Some(index) => indices.push(index.min(i32::MAX as u32) as i32),
                        None => break,
                    },
                    Inks::Direct(colours) => {
                        let mut components =
                            || Some([stream.next(bits)?, stream.next(bits)?, stream.next(bits)?]);
                        let Some([red, green, blue]) = components() else { break };
                        colours.push(self.octets([red, green, blue].map(f64::from)));
                    }
                }
            }
            return Some(inks);
        }
        while inks.len() < most && !operands.is_empty() {
            match &mut inks {
                Inks::Indices(indices) => {
                    let index = if streamed {
                        Bits::new(operands).next(bits).map(i64::from)
                    } else {
                        operands.integer()
                    };
                    let Some(index) = index else { break };
                    let count = if runs { run(most - indices.len(), operands)? } else { 1 };
                    repeat(indices, index.clamp(0, i64::from(i32::MAX)) as i32, count, most);
                }
                Inks::Direct(colours) => {
                    let Some(components) = operands.components(bits) else { break };
                    let count = if runs { run(most - colours.len(), operands)? } else { 1 };
                    let colour = self.octets(components);
                    repeat(colours, colour, count, most);
                }
            }
        }
        Some(inks)
    }

    fn octets(&self, [red, green, blue]: [f64; 3]) -> [u8; 3] {
        let [red, green, blue, _] = self.modes.colour([red, green, blue, 0.0]).to_bytes();
        [red, green, blue]
    }
}

/// The length of a run, at most what is left.
fn run(left: usize, operands: &mut Operands<'_>) -> Option<usize> {
    let count = usize::try_from(operands.integer()?).ok()?;
    Some(count.min(left))
}

/// The point from which the next one is displaced, and the exponents of its coordinates.
struct Displaced {
    at: DVec2,
    exponents: [i32; 2],
}

impl Displaced {
    fn new(coding: &Coding) -> Displaced {
        Displaced { at: DVec2::ZERO, exponents: [coding.vdc.exponent; 2] }
    }

    fn point(&mut self, coding: &Coding, operands: &mut Operands<'_>) -> Option<DVec2> {
        if operands.is_chain() && coding.modes.real_coordinates {
            return None;
        }
        let [x, y] = &mut self.exponents;
        let displacement = if coding.modes.real_coordinates {
            DVec2::new(operands.real(coding.vdc, Some(x))?, operands.real(coding.vdc, Some(y))?)
        } else {
            DVec2::new(operands.integer()? as f64, operands.integer()? as f64)
        };
        self.at += displacement;
        Some(self.at)
    }
}

impl<R: Read + Send> Decoder for CharacterDecoder<R> {
    fn next(&mut self) -> Result<Option<Element>, SourceError> {
        let result = self.element();
        self.ended |= result.is_err();
        result
    }

    fn skipped(&self) -> &Skipped {
        &self.skipped
    }
}
