//! Stroke faces: characters drawn as pen strokes, of the Hershey repertoire.

use std::collections::HashMap;
use std::sync::{LazyLock, OnceLock, PoisonError, RwLock};

use glam::DVec2;

use super::Metrics;
use super::accent::{Mark, attachment};
use super::hershey::CAP;
use super::outline::outline_face;
use super::repertoire::{FAMILIES, Family};
use super::sketch::Sketch;

/// Number of characters from U+0000 on whose glyphs are found without a lock.
const LATIN: usize = 0x180;

/// A character of a stroke face: pen strokes in character heights, y up, origin at the left edge of the body on the
/// base line.
#[derive(Clone, Debug, PartialEq)]
pub struct StrokeGlyph {
    /// Width of the character body in character heights; 0 for combining marks.
    pub advance: f64,
    /// The points of all strokes.
    pub points: Vec<DVec2>,
    /// Index one past the last point of every stroke.
    pub ends: Vec<u32>,
    /// Lower left and upper right corner of the strokes; both zero for a blank.
    pub bounds: [DVec2; 2],
}

impl StrokeGlyph {
    /// The strokes one by one; a stroke of one point is a dot.
    pub fn strokes(&self) -> impl Iterator<Item = &[DVec2]> {
        let mut start = 0;
        self.ends.iter().map(move |&end| {
            let stroke = &self.points[start..end as usize];
            start = end as usize;
            stroke
        })
    }
}

impl From<Sketch> for StrokeGlyph {
    fn from(sketch: Sketch) -> Self {
        let (advance, bounds) = (sketch.advance(), sketch.bounds());
        let (points, ends) = sketch.into_parts();
        Self { advance, points, ends, bounds }
    }
}

/// A face whose characters are pen strokes.
///
/// Glyphs are composed when first asked for and stay for the life of the program.
#[derive(Debug)]
pub struct StrokeFace {
    family: &'static Family,
    latin: [OnceLock<Option<&'static StrokeGlyph>>; LATIN],
    others: RwLock<HashMap<char, &'static StrokeGlyph>>,
}

impl StrokeFace {
    fn new(family: &'static Family) -> Self {
        Self { family, latin: [const { OnceLock::new() }; LATIN], others: RwLock::default() }
    }

    /// The font number: 1 or -2 to -20.
    pub fn number(&self) -> i32 {
        self.family.number
    }

    /// The name of the face.
    pub fn name(&self) -> &'static str {
        self.family.name
    }

    /// The lines of the font design box in character heights.
    pub fn metrics(&self) -> Metrics {
        Metrics {
            top: 28.0 / CAP,
            cap: 1.0,
            half: 0.5,
            base: 0.0,
            bottom: -f64::from(self.family.descent) / CAP,
        }
    }

    /// The glyph of a character; none for control and other invisible characters, which have no body.
    ///
    /// What the family lacks is taken from the roman family of similar weight, then from the contours of the sans
    /// outline face; what is nowhere is a box.
    pub fn glyph(&'static self, character: char) -> Option<&'static StrokeGlyph> {
        (!super::is_invisible(character)).then(|| self.find(character).unwrap_or_else(missing))
    }

    /// The glyph of a character that exists anywhere.
    fn find(&'static self, character: char) -> Option<&'static StrokeGlyph> {
        if let Some(slot) = self.latin.get(character as usize) {
            return *slot.get_or_init(|| self.compose(character));
        }
        if let Some(glyph) = self.others.read().unwrap_or_else(PoisonError::into_inner).get(&character) {
            return Some(glyph);
        }
        // Characters that exist nowhere are not remembered, so that the table is no larger than the fonts.
        let glyph = self.compose(character)?;
        Some(self.others.write().unwrap_or_else(PoisonError::into_inner).entry(character).or_insert(glyph))
    }

    /// Makes the glyph of a character.
    fn compose(&'static self, character: char) -> Option<&'static StrokeGlyph> {
        let monospaced = self.number() == 1;
        let sketch = match self.family.sketch(character) {
            Some(sketch) => sketch,
            None => match stroke_face(self.family.weight.roman()) {
                Some(roman) if roman.number() != self.number() && !monospaced => {
                    return roman.find(character);
                }
                _ => contour(character)?,
            },
        };
        let sketch = if monospaced { fit_to_cell(&sketch) } else { sketch };
        Some(Box::leak(Box::new(StrokeGlyph::from(sketch))))
    }

    /// Where the glyph of a combining mark is put on a letter: its origin relative to that of the letter's glyph.
    pub(crate) fn mark_origin(&self, letter: &StrokeGlyph, mark: char) -> DVec2 {
        let Some(kind) = Mark::of(mark) else {
            return DVec2::new(letter.advance, 0.0);
        };
        let [low, high] = letter.bounds;
        let middle = (low + high) / 2.0;
        let y = if kind.above() { attachment(high.y) - attachment(0.0) } else { 0.0 };
        let reach = if kind.above() { attachment(high.y) } else { 0.0 };
        DVec2::new(middle.x + self.family.slant * (reach - middle.y), y)
    }
}

/// The contours of a character in the outline faces, as strokes.
fn contour(character: char) -> Option<Sketch> {
    let (face, glyph) = outline_face(-21)?.find(character);
    if glyph == 0 {
        return None;
    }
    let em = face.em();
    let mut sketch = Sketch::new(face.advance(glyph) * em);
    for verb in &face.outline(glyph).verbs {
        sketch.trace(verb, em);
    }
    Some(sketch)
}

/// A character centred in a cell as wide as the character is high; wide letters are narrowed, marks left alone.
fn fit_to_cell(sketch: &Sketch) -> Sketch {
    if sketch.advance() == 0.0 {
        return sketch.clone();
    }
    let [low, high] = sketch.bounds();
    let centre = sketch.advance() / 2.0;
    let reach = (high.x - centre).max(centre - low.x);
    let scale = (9.5 / CAP / reach).min(1.0);
    sketch.mapped(1.0, |point| DVec2::new((point.x - centre) * scale + 0.5, point.y))
}

/// What stands for a character that no face has: a box.
fn missing() -> &'static StrokeGlyph {
    static MISSING: OnceLock<StrokeGlyph> = OnceLock::new();
    MISSING.get_or_init(|| {
        let mut sketch = Sketch::new(1.0);
        sketch.draw(&[&[(3, 0), (3, 21), (18, 21), (18, 0), (3, 0)]], CAP, DVec2::ZERO);
        sketch.into()
    })
}

static FACES: LazyLock<[StrokeFace; FAMILIES.len()]> =
    LazyLock::new(|| std::array::from_fn(|place| StrokeFace::new(&FAMILIES[place])));

/// The stroke face of a font number.
pub(crate) fn stroke_face(number: i32) -> Option<&'static StrokeFace> {
    let place = match number {
        1 => 0,
        -20..=-2 => (-1 - number) as usize,
        _ => return None,
    };
    FACES.get(place)
}

/// The face of font number 1, which stands in for an unknown number.
pub(super) fn default_face() -> &'static StrokeFace {
    &FACES[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn font_1_is_monospaced_and_keeps_its_ink_inside_the_cell() {
        let face = default_face();
        for character in (' '..='~').chain('\u{a1}'..='\u{17f}').chain("ΩжЩ∑→😀".chars()) {
            let glyph = face.glyph(character).unwrap();
            assert_eq!(glyph.advance, 1.0, "{character}");
            let [low, high] = glyph.bounds;
            assert!(low.x >= 0.0 && high.x <= 1.0, "{character} from {} to {}", low.x, high.x);
        }
        assert_eq!(face.glyph('\u{301}').unwrap().advance, 0.0);
    }

    #[test]
    fn a_glyph_is_made_once() {
        for character in ['A', 'é', 'Ω', '\u{2603}', '\u{e000}'] {
            for face in FACES.iter() {
                let (first, second) = (face.glyph(character).unwrap(), face.glyph(character).unwrap());
                assert!(std::ptr::eq(first, second), "{} {character}", face.name());
            }
        }
    }

    #[test]
    fn what_no_face_has_is_a_box_and_what_is_invisible_is_nothing() {
        for face in FACES.iter() {
            let unknown = face.glyph('\u{e000}').unwrap();
            assert!(std::ptr::eq(unknown, missing()));
            assert_eq!(unknown.strokes().count(), 1);
            for character in ['\0', '\n', '\u{7f}', '\u{9b}', '\u{200d}', '\u{fe0f}'] {
                assert!(face.glyph(character).is_none());
            }
        }
    }

    #[test]
    fn what_the_repertoire_lacks_is_drawn_as_contours() {
        let snowman = stroke_face(-7).unwrap().glyph('\u{2603}').unwrap();
        assert!(snowman.strokes().count() > 5);
        for stroke in snowman.strokes() {
            assert_eq!(stroke.first(), stroke.last(), "contours are closed");
        }
    }

    #[test]
    fn the_families_are_the_ones_their_numbers_say() {
        let strokes = |number, character| stroke_face(number).unwrap().glyph(character).unwrap().ends.len();
        // The same letter takes more and more strokes from simplex to triplex.
        let weights = [-4, -12, -7, -13].map(|number| strokes(number, 'I'));
        assert_eq!(weights, [1, 2, 4, 13]);
        // Italic letters lean to the right: the top of I is right of its foot.
        for (number, leans) in [(-4, false), (-7, false), (-13, false), (-10, true), (-14, true), (-9, true)]
        {
            let glyph = stroke_face(number).unwrap().glyph('I').unwrap();
            let middle = |from: f64, to: f64| {
                let places = glyph.points.iter().filter(|point| (from..=to).contains(&point.y));
                let (sum, count) =
                    places.fold((0.0, 0.0), |(sum, count), point| (sum + point.x, count + 1.0));
                sum / count
            };
            assert_eq!(middle(0.8, 1.0) > middle(0.0, 0.2) + 0.1, leans, "{number}");
        }
    }
}
