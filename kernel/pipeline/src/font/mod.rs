//! Fonts and text layout.
//!
//! Every face draws in character heights: the base line is 0 and the cap line 1, so that a character height of the
//! standard is the unit of length, and x and y are scaled alike before the expansion factor is applied. y goes up,
//! a glyph's origin is the left end of its base line.
//!
//! [`face`] finds the face of a font number, [`layout`] places the characters of a string by path, alignment,
//! spacing and expansion (ISO 7942, text attributes) and yields extent and concatenation point.
//!
//! All faces are available at all precisions. A device without filled areas replaces an outline face by
//! [`OutlineFace::pen_substitute`].

mod accent;
mod hand_drawn;
mod hershey;
mod layout;
mod letter;
mod outline;
mod repertoire;
mod shape;
mod sketch;
mod stroke;
mod style;

pub use layout::{FaceGlyph, Layout, PlacedGlyph, layout};
pub use outline::{Outline, OutlineFace, Verb};
pub use stroke::{StrokeFace, StrokeGlyph};
pub use style::{Horizontal, TextPath, TextStyle, Vertical};

/// The horizontal lines of a font's design box, in character heights above the base line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metrics {
    /// Top of the character body.
    pub top: f64,
    /// Cap line: 1.
    pub cap: f64,
    /// Half line: halfway between cap line and base line.
    pub half: f64,
    /// Base line: 0.
    pub base: f64,
    /// Bottom of the character body, below the base line and so negative.
    pub bottom: f64,
}

impl Metrics {
    /// Height of the character body, from bottom to top.
    pub fn body(&self) -> f64 {
        self.top - self.bottom
    }
}

/// A face: pen strokes or filled outlines.
#[derive(Clone, Copy, Debug)]
pub enum Face {
    /// Characters drawn by a pen.
    Stroke(&'static StrokeFace),
    /// Characters filled by the non-zero winding rule.
    Outline(&'static OutlineFace),
}

impl Face {
    /// The font number.
    pub fn number(self) -> i32 {
        match self {
            Self::Stroke(face) => face.number(),
            Self::Outline(face) => face.number,
        }
    }

    /// The name of the face: the family of strokes, or the PostScript name of a font file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Stroke(face) => face.name(),
            Self::Outline(face) => face.postscript_name,
        }
    }

    /// The lines of the design box.
    pub fn metrics(self) -> Metrics {
        match self {
            Self::Stroke(face) => face.metrics(),
            Self::Outline(face) => face.metrics(),
        }
    }

    /// The face that a pen draws: the face itself, or the substitute of an outline face.
    pub fn for_pen(self) -> &'static StrokeFace {
        match self {
            Self::Stroke(face) => face,
            Self::Outline(face) => face.pen_substitute(),
        }
    }
}

/// The face of a font number, or none for a number that is not one of [`numbers`].
pub fn face(number: i32) -> Option<Face> {
    stroke::stroke_face(number).map(Face::Stroke).or_else(|| outline::outline_face(number).map(Face::Outline))
}

/// The font numbers: 1 and -2 to -20 are stroke faces, -21 to -34 outline faces.
///
/// | number | face |
/// |---|---|
/// | 1 | monospaced simplex |
/// | -2, -3 | cartographic roman (capitals only), Greek |
/// | -4, -5, -6 | simplex roman, Greek, script |
/// | -7, -8, -9, -10, -11 | complex roman, Greek, script, italic, Cyrillic |
/// | -12 | duplex roman |
/// | -13, -14 | triplex roman, italic |
/// | -15, -16, -17 | Gothic German, English, Italian |
/// | -18, -19, -20 | mathematical symbols, symbol set 1, symbol set 2 |
/// | -21 to -24 | sans, bold, italic, bold italic |
/// | -25 to -28 | serif, bold, italic, bold italic |
/// | -29 to -32 | monospaced, bold, italic, bold italic |
/// | -33, -34 | mathematics, symbols |
pub fn numbers() -> &'static [i32] {
    &NUMBERS
}

static NUMBERS: [i32; 34] = {
    let mut numbers = [1; 34];
    let mut place = 1;
    while place < numbers.len() {
        numbers[place] = -1 - place as i32;
        place += 1;
    }
    numbers
};

/// Whether a character shows nothing and has no body: control characters, joiners, directional marks, variation
/// selectors.
pub(crate) fn is_invisible(character: char) -> bool {
    character.is_control()
        || matches!(character,
            '\u{34f}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}'
            | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_has_a_face_with_sane_metrics() {
        assert_eq!(numbers().len(), 34);
        assert_eq!(numbers()[..3], [1, -2, -3]);
        assert_eq!(numbers()[33], -34);
        for &number in numbers() {
            let face = face(number).unwrap_or_else(|| panic!("font {number}"));
            assert_eq!(face.number(), number);
            let Metrics { top, cap, half, base, bottom } = face.metrics();
            assert_eq!((cap, half, base), (1.0, 0.5, 0.0), "font {number}");
            assert!((1.05..1.4).contains(&top), "font {number}: top {top}");
            assert!((-0.7..-0.25).contains(&bottom), "font {number}: bottom {bottom}");
        }
        for number in [0, -1, 2, -35, i32::MIN, i32::MAX] {
            assert!(face(number).is_none(), "font {number}");
        }
    }
}
