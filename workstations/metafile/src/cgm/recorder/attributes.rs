//! Attributes, resolved and written where they change.

use super::descriptor::line_type;
use super::{CgmRecorder, Class};
use crate::cgm::element::{Cells, Ink, Inks, Value};
use crate::generated::elements::Kind;
use gks_pipeline::look::{InteriorStyle, Look};
use glam::DVec2;
use std::borrow::Cow;

/// The octets of a text: Latin-1 where that is enough and cannot be taken for UTF-8, else UTF-8.
pub(super) fn encoded(text: &str) -> Cow<'_, [u8]> {
    if text.is_ascii() {
        return Cow::Borrowed(text.as_bytes());
    }
    let latin: Option<Vec<u8>> = text.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect();
    match latin {
        Some(latin) if std::str::from_utf8(&latin).is_err() => Cow::Owned(latin),
        _ => Cow::Borrowed(text.as_bytes()),
    }
}

fn integer(number: i32) -> [Value; 1] {
    [Value::Integer(number)]
}

fn real(number: f64) -> [Value; 1] {
    [Value::Real(number)]
}

impl CgmRecorder {
    fn set_ink(&mut self, kind: Kind, index: u32) {
        let index = self.colour(index);
        self.set(kind, [Value::Ink(Ink::Index(index))]);
    }

    /// Whether the attributes for a class are those of a look already; if not, they are taken to be so from now on.
    fn is_set(&mut self, class: Class, look: &Look) -> bool {
        let last = &mut self.looks[class as usize];
        if last.as_ref() == Some(look) {
            return true;
        }
        *last = Some(look.clone());
        false
    }

    /// A length in virtual device coordinates.
    fn length(&self, length: f64) -> f64 {
        self.rounded(DVec2::splat(length * self.scale)).x
    }

    /// Two vectors of which only the directions and the ratio of lengths count, with many digits.
    pub(super) fn directions(&self, vectors: [DVec2; 2]) -> [Value; 4] {
        let largest = vectors[0].abs().max(vectors[1].abs()).max_element();
        // Real vectors keep their last digits.
        let factor = if self.grid.real { 1.0 } else { self.grid.most.min(16_777_216.0) / largest };
        let [u, v] = vectors.map(|vector| self.rounded(vector * factor));
        [u.x, u.y, v.x, v.y].map(Value::Real)
    }

    pub(super) fn set_line(&mut self, look: &Look) {
        if self.is_set(Class::Line, look) {
            return;
        }
        let line = self.tables.line(look);
        self.set(Kind::LineType, integer(line_type(line.linetype)));
        self.set(Kind::LineWidth, real(line.width));
        self.set_ink(Kind::LineColour, line.colour);
        if self.settings.version >= 3 {
            self.set(Kind::LineCap, [2 + look.cap as i32, 1].map(Value::Integer));
            self.set(Kind::LineJoin, integer(2 + look.join as i32));
        }
    }

    pub(super) fn set_marker(&mut self, look: &Look) {
        if self.is_set(Class::Marker, look) {
            return;
        }
        let marker = self.tables.marker(look);
        self.set(Kind::MarkerType, integer(marker.kind));
        self.set(Kind::MarkerSize, real(marker.size));
        self.set_ink(Kind::MarkerColour, marker.colour);
    }

    pub(super) fn set_text(&mut self, look: &Look) {
        if self.is_set(Class::Text, look) {
            return;
        }
        let text = self.tables.text(look);
        let font = self.fonts.index(text.font);
        self.set(Kind::TextFontIndex, integer(font));
        self.set(Kind::TextPrecision, integer(text.precision as i32));
        self.set(Kind::CharacterExpansionFactor, real(text.expansion));
        self.set(Kind::CharacterSpacing, real(text.spacing));
        self.set_ink(Kind::TextColour, text.colour);
        let geometry = &look.text_geometry;
        self.set(Kind::CharacterHeight, real(self.length(geometry.height.length())));
        let orientation = self.directions([geometry.height.0, geometry.width.0]);
        self.set(Kind::CharacterOrientation, orientation);
        self.set(Kind::TextPath, integer(geometry.path as i32));
        let (horizontal, vertical) = (geometry.horizontal as i32, geometry.vertical as i32);
        let alignment =
            [Value::Integer(horizontal), Value::Integer(vertical), Value::Real(0.0), Value::Real(0.0)];
        self.set(Kind::TextAlignment, alignment);
    }

    pub(super) fn set_fill(&mut self, look: &Look) {
        if self.is_set(Class::Area, look) {
            return;
        }
        let fill = self.tables.fill(look);
        match fill.interior {
            InteriorStyle::Hatch => self.set(Kind::HatchIndex, integer(fill.style)),
            InteriorStyle::Pattern => {
                self.set_pattern(fill.style);
                self.set(Kind::PatternIndex, integer(fill.style));
                let (height, width) = (look.pattern.height.0 * self.scale, look.pattern.width.0 * self.scale);
                let [height, width] = [height, width].map(|vector| self.rounded(vector));
                self.set(Kind::PatternSize, [height.x, height.y, width.x, width.y].map(Value::Real));
                let reference = self.coordinates(look.pattern.reference.0);
                self.set(Kind::FillReferencePoint, [Value::Point(reference)]);
            }
            InteriorStyle::Hollow | InteriorStyle::Solid => {}
        }
        self.set(Kind::InteriorStyle, integer(fill.interior as i32));
        self.set_ink(Kind::FillColour, fill.colour);
    }

    /// Writes a pattern unless the picture has it already.
    fn set_pattern(&mut self, style: i32) {
        let index = u32::try_from(style).unwrap_or(1);
        let Some(pattern) =
            self.tables.patterns.get(&index).or_else(|| self.tables.patterns.get(&1)).cloned()
        else {
            return;
        };
        if self.patterns.get(&style) == Some(&pattern) {
            return;
        }
        let indices = pattern.indices.iter().map(|&index| self.cell(index)).collect();
        let cells = Cells { columns: pattern.columns, rows: pattern.rows, inks: Inks::Indices(indices) };
        self.put(Kind::PatternTable, [Value::Integer(style), Value::Cells(cells)]);
        self.patterns.insert(style, pattern);
    }

    /// The index under which the colour of a cell is written.
    pub(super) fn cell(&mut self, index: i32) -> i32 {
        self.colour(u32::try_from(index).unwrap_or(1)) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::encoded;

    #[test]
    fn text_is_latin_where_nobody_takes_it_for_something_else() {
        assert_eq!(encoded("Größe").as_ref(), b"Gr\xf6\xdfe");
        assert_eq!(encoded("Ã¶").as_ref(), "Ã¶".as_bytes());
        assert_eq!(encoded("π").as_ref(), "π".as_bytes());
    }
}
