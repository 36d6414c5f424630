//! Elements out of clear text (ISO/IEC 8632-4, 6 and 7).

use super::token::{Characters, Token, integer, real};
use crate::cgm::coding::Modes;
use crate::cgm::decoder::{Decoder, senseless, unknown};
use crate::cgm::element::{Cells, Element, Ink, Inks, Value};
use crate::cgm::parameter::Parameter;
use crate::generated::elements::{ELEMENTS, Kind, Row};
use gks_pipeline::record::{Skipped, SourceError};
use glam::DVec2;
use std::collections::HashMap;
use std::io::Read;
use std::sync::LazyLock;

/// Decodes the clear text encoding.
pub struct TextDecoder<R> {
    characters: Characters<R>,
    modes: Modes,
    /// The modes with which pictures begin.
    defaults: Option<Modes>,
    skipped: Skipped,
    ended: bool,
}

static KEYWORDS: LazyLock<HashMap<String, &'static Row>> = LazyLock::new(|| {
    let rows = ELEMENTS.iter().filter(|row| !row.keyword.is_empty());
    let mut keywords: HashMap<String, &'static Row> =
        rows.map(|row| (row.keyword.to_ascii_lowercase(), row)).collect();
    // As the first edition and its readers also spell it.
    for (other, keyword) in [("incrline", "line"), ("begmfdefaultsrepl", "begmfdefaults")] {
        if let Some(row) = keywords.get(keyword).copied() {
            keywords.insert(other.to_owned(), row);
        }
    }
    keywords
});

/// The aspect source flags that a word of several stands for.
fn aspects(word: &str) -> Option<std::ops::RangeInclusive<i32>> {
    Some(match word {
        "all" => 0..=17,
        "allline" => 0..=2,
        "allmarker" => 3..=5,
        "alltext" => 6..=10,
        "allfill" => 11..=14,
        "alledge" => 15..=17,
        _ => return None,
    })
}

impl<R: Read> TextDecoder<R> {
    /// A decoder of what is read from `input`.
    pub fn new(input: R) -> Self {
        TextDecoder {
            characters: Characters::new(input),
            modes: Modes::new(255.0),
            defaults: None,
            skipped: Skipped::default(),
            ended: false,
        }
    }

    fn element(&mut self) -> Result<Option<Element>, SourceError> {
        while !self.ended {
            let Some(tokens) = self.characters.element()? else { break };
            let mut tokens = Tokens { rest: &tokens };
            let Some(Token::Word(keyword)) = tokens.next() else { continue };
            let incremental = keyword.starts_with("incr");
            let Some(row) = KEYWORDS.get(keyword.as_str()) else {
                self.skipped.add(&unknown(keyword));
                continue;
            };
            match row.kind {
                Kind::BeginMetafile => (self.modes, self.defaults) = (Modes::new(255.0), None),
                Kind::BeginPicture => {
                    self.modes = self.defaults.get_or_insert_with(|| self.modes.clone()).clone();
                }
                _ => {}
            }
            let mut element = Element::new(row.kind, []);
            let done = self.list(row, row.parameters, &mut tokens, &mut element.values);
            if done.is_none() && !tokens.rest.is_empty() {
                self.skipped.add(&senseless(row));
            }
            if incremental {
                sum_up(&mut element);
            }
            self.modes.observe(&element);
            if row.kind == Kind::ColourPrecision
                && let Some(most) = element.real(0)
            {
                self.modes.extent.1 = [most; 4];
            }
            return Ok(Some(element));
        }
        self.ended = true;
        Ok(None)
    }

    fn list(
        &self,
        row: &Row,
        parameters: &[Parameter],
        tokens: &mut Tokens<'_>,
        values: &mut Vec<Value>,
    ) -> Option<()> {
        for parameter in parameters {
            match parameter {
                Parameter::Repeat([Parameter::Point]) => values.push(Value::Points(tokens.points())),
                Parameter::Repeat(group) => {
                    while !tokens.rest.is_empty() {
                        if row.kind == Kind::AspectSourceFlags
                            && let Some(Token::Word(word)) = tokens.rest.first()
                            && let Some(all) = aspects(word)
                        {
                            tokens.next();
                            let value = self.single(group[1], tokens)?;
                            values.extend(all.flat_map(|aspect| [Value::Integer(aspect), value.clone()]));
                            continue;
                        }
                        self.list(row, group, tokens, values)?;
                    }
                }
                Parameter::CountedPoints => values.push(Value::Points(tokens.points())),
                Parameter::Precision => {
                    while let Some(number) = tokens.real() {
                        values.push(Value::Real(number));
                    }
                }
                Parameter::Spline | Parameter::RationalSpline => {
                    self.spline(*parameter == Parameter::RationalSpline, tokens, values)?;
                }
                Parameter::ElementList | Parameter::Bits | Parameter::Raw => tokens.rest = &[],
                single => values.push(self.single(*single, tokens)?),
            }
        }
        Some(())
    }

    fn single(&self, parameter: Parameter, tokens: &mut Tokens<'_>) -> Option<Value> {
        Some(match parameter {
            Parameter::Integer | Parameter::Index | Parameter::Name => Value::Integer(tokens.integer()?),
            Parameter::Enumeration(words) => match tokens.next()? {
                Token::Word(word) => {
                    let place = words.iter().position(|known| known.eq_ignore_ascii_case(word));
                    let number = || integer(word).and_then(|n| i32::try_from(n).ok());
                    Value::Integer(place.map(|place| place as i32).or_else(number)?)
                }
                Token::Text(_) => return None,
            },
            Parameter::Real
            | Parameter::Metric
            | Parameter::Coordinate
            | Parameter::Component
            | Parameter::Viewport
            | Parameter::LineWidth
            | Parameter::MarkerSize
            | Parameter::EdgeWidth
            | Parameter::StyleSize => Value::Real(tokens.real()?),
            Parameter::Point => Value::Point(tokens.point()?),
            Parameter::Text => Value::Text(tokens.text()?),
            Parameter::Data => Value::Data(tokens.text()?),
            Parameter::ColourIndex => Value::Ink(Ink::Index(u32::try_from(tokens.integer()?).ok()?)),
            Parameter::DirectColour => Value::Ink(self.direct(tokens)?),
            Parameter::Colour if self.modes.direct => Value::Ink(self.direct(tokens)?),
            Parameter::Colour => self.single(Parameter::ColourIndex, tokens)?,
            Parameter::Cells | Parameter::Pattern => Value::Cells(self.cells(tokens)?),
            _ => return None,
        })
    }

    fn direct(&self, tokens: &mut Tokens<'_>) -> Option<Ink> {
        let mut components = [0.0; 4];
        for component in components.iter_mut().take(self.modes.model.components()) {
            *component = tokens.real()?;
        }
        Some(Ink::Direct(self.modes.colour(components)))
    }

    fn spline(&self, rational: bool, tokens: &mut Tokens<'_>, values: &mut Vec<Value>) -> Option<()> {
        let (order, count) = (tokens.integer()?, tokens.integer()?);
        let points: Option<Vec<DVec2>> = (0..count).map(|_| tokens.point()).collect();
        values.extend([Value::Integer(order), Value::Points(points?)]);
        let weights = if rational { i64::from(count) } else { 0 };
        for _ in 0..i64::from(order) + i64::from(count) + 2 + weights {
            values.push(Value::Real(tokens.real()?));
        }
        Some(())
    }

    /// Columns, rows, local colour precision, and as many colours, all of which must be there.
    fn cells(&self, tokens: &mut Tokens<'_>) -> Option<Cells> {
        let (columns, rows) = (tokens.integer()?, tokens.integer()?);
        tokens.integer()?;
        let (columns, rows) = (usize::try_from(columns).ok()?, usize::try_from(rows).ok()?);
        let count = columns.checked_mul(rows).filter(|&count| count > 0)?;
        if count > tokens.rest.len() {
            return None;
        }
        let inks = if self.modes.direct {
            let mut colours = Vec::new();
            for _ in 0..count {
                let Ink::Direct(colour) = self.direct(tokens)? else { return None };
                let [red, green, blue, _] = colour.to_bytes();
                colours.push([red, green, blue]);
            }
            Inks::Direct(colours)
        } else {
            Inks::Indices((0..count).map(|_| tokens.integer()).collect::<Option<Vec<_>>>()?)
        };
        Some(Cells { columns, rows, inks })
    }
}

/// Makes displacements from point to point into points.
fn sum_up(element: &mut Element) {
    if let Some(Value::Points(points)) = element.values.first_mut() {
        let mut at = DVec2::ZERO;
        for point in points {
            at += *point;
            *point = at;
        }
    }
}

/// The tokens of an element that are left.
struct Tokens<'a> {
    rest: &'a [Token],
}

impl<'a> Tokens<'a> {
    fn next(&mut self) -> Option<&'a Token> {
        let (first, rest) = self.rest.split_first()?;
        self.rest = rest;
        Some(first)
    }

    fn word(&mut self) -> Option<&'a str> {
        match self.rest.first()? {
            Token::Word(word) => {
                self.rest = &self.rest[1..];
                Some(word)
            }
            Token::Text(_) => None,
        }
    }

    fn integer(&mut self) -> Option<i32> {
        let word = self.word()?;
        let number = integer(word).or_else(|| real(word).map(|x| x.round() as i64))?;
        Some(number.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32)
    }

    fn real(&mut self) -> Option<f64> {
        self.word().and_then(real)
    }

    fn point(&mut self) -> Option<DVec2> {
        Some(DVec2::new(self.real()?, self.real()?))
    }

    fn points(&mut self) -> Vec<DVec2> {
        std::iter::from_fn(|| self.point()).collect()
    }

    fn text(&mut self) -> Option<Vec<u8>> {
        match self.next()? {
            Token::Text(text) => Some(text.clone()),
            Token::Word(_) => None,
        }
    }
}

impl<R: Read + Send> Decoder for TextDecoder<R> {
    fn next(&mut self) -> Result<Option<Element>, SourceError> {
        let result = self.element();
        self.ended |= result.is_err();
        result
    }

    fn skipped(&self) -> &Skipped {
        &self.skipped
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn elements(text: &str) -> Vec<Element> {
        let mut decoder = TextDecoder::new(text.as_bytes());
        std::iter::from_fn(|| decoder.next().unwrap()).collect()
    }

    #[test]
    fn words_and_numbers_become_parameters() {
        let all = elements("COLRMODE direct; linecolr 255 0 0; text (.5,.5) FINAL 'hi'; bogus 1;");
        assert_eq!(all.len(), 3);
        let red = gks_pipeline::colour::Colour::rgb(1.0, 0.0, 0.0);
        assert_eq!(all[1].ink(0), Some(Ink::Direct(red)));
        assert_eq!((all[2].point(0), all[2].integer(1)), (Some(DVec2::splat(0.5)), Some(1)));
    }

    #[test]
    fn increments_and_flags_of_several_aspects() {
        let all = elements("incrline (1,1) (2,0); asf allmarker bundled linetype indiv;");
        assert_eq!(all[0].points(0), Some(&[DVec2::ONE, DVec2::new(3.0, 1.0)][..]));
        let numbers: Vec<i32> = (0..8).map(|i| all[1].integer(i).unwrap()).collect();
        assert_eq!(numbers, [3, 1, 4, 1, 5, 1, 0, 0]);
    }

    #[test]
    fn cells_without_colours_are_none() {
        let all = elements("cellarray (0,0) (1,1) (1,0) 30000 30000 0 1 2 3;");
        assert!(all[0].cells(3).is_none());
    }
}
