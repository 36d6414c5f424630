//! Outline faces: characters drawn as filled outlines, from the TrueType files that come with the library.

use std::sync::{Mutex, OnceLock, PoisonError};

use glam::DVec2;
use harfrust::{Direction, Feature, Script, ShapePlan, Tag};
use skrifa::{DrawMemory, Font, GlyphId, PathSink, ScalerFont};

use super::Metrics;
use super::stroke::{StrokeFace, stroke_face};

/// One step of an outline, in em, y up, origin at the left end of the base line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verb {
    /// Starts a contour.
    Move(DVec2),
    /// A straight line to a point.
    Line(DVec2),
    /// A quadratic Bézier curve: control point, end.
    Quad(DVec2, DVec2),
    /// A cubic Bézier curve: two control points, end.
    Cubic(DVec2, DVec2, DVec2),
    /// Closes the contour.
    Close,
}

/// The outline of a glyph, to be filled by the non-zero winding rule.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// The steps, contour after contour; empty for a blank glyph.
    pub verbs: Vec<Verb>,
}

/// Receives an outline in design units and keeps it in em.
struct EmSink<'a> {
    scale: f64,
    outline: &'a mut Outline,
}

impl EmSink<'_> {
    fn point(&self, x: f32, y: f32) -> DVec2 {
        DVec2::new(f64::from(x), f64::from(y)) * self.scale
    }
}

impl PathSink for EmSink<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.outline.verbs.push(Verb::Move(self.point(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.outline.verbs.push(Verb::Line(self.point(x, y)));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.outline.verbs.push(Verb::Quad(self.point(cx, cy), self.point(x, y)));
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        self.outline.verbs.push(Verb::Cubic(self.point(ax, ay), self.point(bx, by), self.point(x, y)));
    }

    fn close(&mut self) {
        self.outline.verbs.push(Verb::Close);
    }
}

/// A face whose characters are filled outlines, with the file it comes from.
///
/// The file is read when the face is first used; glyph numbers, advances and outlines are kept, so that repeated text
/// does not look into the tables of the file again.
pub struct OutlineFace {
    /// The font number: -21 to -34.
    pub number: i32,
    /// The family name, as other programs know it.
    pub family: &'static str,
    /// The PostScript name.
    pub postscript_name: &'static str,
    /// Whether the face is a bold one.
    pub bold: bool,
    /// Whether the face is an italic one.
    pub italic: bool,
    /// The font file (TrueType).
    pub data: &'static [u8],
    /// Font units to the em.
    pub units_per_em: u16,
    pen: i32,
    tables: OnceLock<Option<Tables>>,
}

/// What is kept of a font file.
struct Tables {
    font: Font,
    scaler: ScalerFont,
    em: f64,
    metrics: Metrics,
    /// Glyph numbers of the characters from U+0000 on, 0 where there is none.
    latin: [u16; LATIN],
    /// Advance widths of all glyphs in design units.
    advances: Vec<f32>,
    outlines: Vec<OnceLock<Box<Outline>>>,
    plans: Mutex<Vec<&'static ShapePlan>>,
}

/// Number of characters whose glyph numbers are looked up once.
const LATIN: usize = 0x250;

/// The features that shaping has off: a character of the string stays a glyph of its own.
static FEATURES: [Feature; 4] = [off(b"liga"), off(b"clig"), off(b"calt"), off(b"dlig")];

const fn off(tag: &[u8; 4]) -> Feature {
    Feature { tag: Tag::new(tag), value: 0, start: Feature::GLOBAL_START, end: Feature::GLOBAL_END }
}

impl std::fmt::Debug for OutlineFace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("OutlineFace")
            .field("number", &self.number)
            .field("name", &self.postscript_name)
            .finish()
    }
}

impl Tables {
    fn read(data: &'static [u8]) -> Option<Self> {
        let font = Font::new(data, 0)?;
        let units = f32::from(font.units_per_em().max(1));
        let glyphs = usize::try_from(font.num_glyphs()).ok()?.min(usize::from(u16::MAX));
        let charmap = font.charmap();
        let mut latin = [0; LATIN];
        for (code, slot) in (0_u32..).zip(latin.iter_mut()) {
            *slot =
                charmap.map_unicode(code).and_then(|glyph| u16::try_from(glyph.to_u32()).ok()).unwrap_or(0);
        }
        let lines = font.metrics().scaled_f32(units);
        let glyph_metrics = font.glyph_metrics();
        let height_of_h = || {
            let extents = glyph_metrics.extents(charmap.map_unicode('H')?)?;
            Some(extents.y_bearing)
        };
        let cap = f64::from(
            lines.cap_height().filter(|&cap| cap > 0.0).or_else(height_of_h).unwrap_or(0.7 * units),
        );
        let line = lines.hhea_line();
        Some(Self {
            em: f64::from(units) / cap,
            metrics: Metrics {
                top: f64::from(line.map_or(0.9 * units, |line| line.ascender)) / cap,
                cap: 1.0,
                half: 0.5,
                base: 0.0,
                bottom: f64::from(line.map_or(-0.2 * units, |line| line.descender)) / cap,
            },
            latin,
            advances: (0..glyphs as u32).map(|glyph| glyph_metrics.h_advance(GlyphId::new(glyph))).collect(),
            outlines: (0..glyphs).map(|_| OnceLock::new()).collect(),
            plans: Mutex::default(),
            scaler: ScalerFont::unhinted(font.clone(), None),
            font,
        })
    }
}

impl OutlineFace {
    fn tables(&self) -> Option<&Tables> {
        self.tables.get_or_init(|| Tables::read(self.data)).as_ref()
    }

    /// Number of glyphs in the file.
    pub fn glyphs(&self) -> u16 {
        self.tables().map_or(0, |tables| tables.advances.len() as u16)
    }

    /// Size of the em in character heights: the em over the height of capitals.
    pub fn em(&self) -> f64 {
        self.tables().map_or(1.0, |tables| tables.em)
    }

    /// The lines of the font design box in character heights.
    pub fn metrics(&self) -> Metrics {
        self.tables()
            .map_or(Metrics { top: 1.25, cap: 1.0, half: 0.5, base: 0.0, bottom: -0.25 }, |t| t.metrics)
    }

    /// The glyph of a character in this file.
    pub fn glyph_id(&self, character: char) -> Option<u16> {
        let tables = self.tables()?;
        let glyph = match tables.latin.get(character as usize) {
            Some(&glyph) => glyph,
            None => u16::try_from(tables.font.charmap().map_unicode(character)?.to_u32()).ok()?,
        };
        (glyph != 0).then_some(glyph)
    }

    /// The face and glyph that show a character: this face, the regular face of the family, the symbols, the
    /// mathematics, at last the missing glyph of this face.
    pub fn find(&'static self, character: char) -> (&'static Self, u16) {
        let regular = match self.number {
            -32..=-21 => -21 - (-21 - self.number) / 4 * 4,
            other => other,
        };
        [self.number, regular, -34, -33]
            .into_iter()
            .filter_map(outline_face)
            .find_map(|face| Some((face, face.glyph_id(character)?)))
            .unwrap_or((self, 0))
    }

    /// Advance width of a glyph in em; 0 for a number that is not a glyph of the file.
    pub fn advance(&self, glyph: u16) -> f64 {
        let Some(tables) = self.tables() else { return 0.0 };
        let advance = tables.advances.get(usize::from(glyph)).copied().unwrap_or(0.0);
        f64::from(advance) / f64::from(self.units_per_em)
    }

    /// The outline of a glyph in em; empty for a blank and for a number that is not a glyph of the file.
    pub fn outline(&self, glyph: u16) -> &Outline {
        static EMPTY: Outline = Outline { verbs: Vec::new() };
        let Some(tables) = self.tables() else { return &EMPTY };
        let Some(slot) = tables.outlines.get(usize::from(glyph)) else { return &EMPTY };
        slot.get_or_init(|| {
            let mut outline = Box::<Outline>::default();
            let scale = 1.0 / f64::from(self.units_per_em);
            if let Some(drawn) = tables.scaler.outline(GlyphId::from(glyph)) {
                let mut sink = EmSink { scale, outline: &mut outline };
                if drawn.draw(DrawMemory::Scratch, &mut sink).is_err() {
                    outline.verbs.clear();
                }
            }
            outline
        })
    }

    /// The stroke face that a pen draws instead of this face.
    pub fn pen_substitute(&self) -> &'static StrokeFace {
        stroke_face(self.pen).unwrap_or_else(super::stroke::default_face)
    }

    /// The font in the form that the shaper takes.
    pub(crate) fn font(&self) -> Option<&Font> {
        Some(&self.tables()?.font)
    }

    /// The plan for shaping text of a script in a direction, made once.
    pub(crate) fn plan(&self, script: Option<Script>, direction: Direction) -> Option<&'static ShapePlan> {
        let tables = self.tables()?;
        let mut plans = tables.plans.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(&plan) =
            plans.iter().find(|plan| plan.script() == script && plan.direction() == direction)
        {
            return Some(plan);
        }
        let plan = ShapePlan::new(&tables.font, direction, script, None, &FEATURES);
        let plan: &'static ShapePlan = Box::leak(Box::new(plan));
        plans.push(plan);
        Some(plan)
    }

    /// The features that a plan was made with.
    pub(crate) fn features() -> &'static [Feature] {
        &FEATURES
    }
}

const SANS: &str = "Liberation Sans";
const SERIF: &str = "Liberation Serif";
const MONO: &str = "Liberation Mono";

/// A face of the table: number, units to the em, family, style, PostScript name, number of the stroke face for pens, file.
macro_rules! face {
    ($number:literal, $units:literal, $family:expr, $bold:literal, $italic:literal, $name:literal, $pen:literal, $file:literal) => {
        OutlineFace {
            number: $number,
            family: $family,
            postscript_name: $name,
            bold: $bold,
            italic: $italic,
            data: include_bytes!(concat!("../../data/outline/", $file, ".ttf")),
            units_per_em: $units,
            pen: $pen,
            tables: OnceLock::new(),
        }
    };
}

#[rustfmt::skip]
static FACES: [OutlineFace; 14] = [
    face!(-21, 2048, SANS, false, false, "LiberationSans", -4, "LiberationSans-Regular"),
    face!(-22, 2048, SANS, true, false, "LiberationSans-Bold", -12, "LiberationSans-Bold"),
    face!(-23, 2048, SANS, false, true, "LiberationSans-Italic", -4, "LiberationSans-Italic"),
    face!(-24, 2048, SANS, true, true, "LiberationSans-BoldItalic", -12, "LiberationSans-BoldItalic"),
    face!(-25, 2048, SERIF, false, false, "LiberationSerif", -7, "LiberationSerif-Regular"),
    face!(-26, 2048, SERIF, true, false, "LiberationSerif-Bold", -13, "LiberationSerif-Bold"),
    face!(-27, 2048, SERIF, false, true, "LiberationSerif-Italic", -10, "LiberationSerif-Italic"),
    face!(-28, 2048, SERIF, true, true, "LiberationSerif-BoldItalic", -14, "LiberationSerif-BoldItalic"),
    face!(-29, 2048, MONO, false, false, "LiberationMono", 1, "LiberationMono-Regular"),
    face!(-30, 2048, MONO, true, false, "LiberationMono-Bold", 1, "LiberationMono-Bold"),
    face!(-31, 2048, MONO, false, true, "LiberationMono-Italic", 1, "LiberationMono-Italic"),
    face!(-32, 2048, MONO, true, true, "LiberationMono-BoldItalic", 1, "LiberationMono-BoldItalic"),
    face!(-33, 1000, "DejaVu Math TeX Gyre", false, false, "DejaVuMathTeXGyre-Regular", -7, "DejaVuMathTeXGyre"),
    face!(-34, 2048, "DejaVu Sans", false, false, "DejaVuSans", -7, "DejaVuSans"),
];

/// The outline face of a font number.
pub(crate) fn outline_face(number: i32) -> Option<&'static OutlineFace> {
    FACES.get(usize::try_from((-21_i32).checked_sub(number)?).ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(number: i32) -> &'static OutlineFace {
        outline_face(number).unwrap()
    }

    #[test]
    fn every_file_is_read_and_says_what_the_table_says() {
        for (number, face) in (21..).map(|number: i32| -number).zip(&FACES) {
            assert_eq!(face.number, number);
            let tables = face.tables().unwrap_or_else(|| panic!("{}", face.postscript_name));
            assert_eq!(tables.font.units_per_em(), face.units_per_em, "{}", face.postscript_name);
            let attributes = tables.font.default_attributes();
            assert_eq!(attributes.weight.value() > 500.0, face.bold, "{}", face.postscript_name);
            let id = skrifa::font::name::NameId::POSTSCRIPT_NAME;
            let name = tables.font.names().get(id).and_then(|name| name.english_or_first());
            let name = name.map(|name| name.name().chars().collect::<String>());
            assert_eq!(name.as_deref(), Some(face.postscript_name));
            assert!(face.glyphs() > 500);
        }
    }

    #[test]
    fn capitals_are_one_character_height_high() {
        for face in &FACES {
            let glyph = face.glyph_id('H').unwrap();
            let ends = face.outline(glyph).verbs.iter().filter_map(|verb| match *verb {
                Verb::Move(to) | Verb::Line(to) | Verb::Quad(_, to) | Verb::Cubic(_, _, to) => Some(to.y),
                Verb::Close => None,
            });
            let (low, high) = ends.fold((f64::MAX, f64::MIN), |(low, high), y| (low.min(y), high.max(y)));
            assert!(low.abs() < 1e-6, "{}: {low}", face.postscript_name);
            assert!((high * face.em() - 1.0).abs() < 0.02, "{}: {}", face.postscript_name, high * face.em());
        }
    }

    #[test]
    fn monospaced_faces_are_monospaced_and_others_are_not() {
        for face in &FACES {
            let advance = |character| face.advance(face.glyph_id(character).unwrap());
            assert_eq!(advance('i') == advance('M'), (-32..=-29).contains(&face.number), "{}", face.number);
        }
    }

    #[test]
    fn a_missing_character_is_found_in_the_family_then_in_the_symbols_then_in_mathematics() {
        let found = |number, character| face(number).find(character).0.number;
        assert_eq!(found(-26, 'A'), -26);
        assert_eq!(found(-28, '\u{2603}'), -34, "a snowman is a symbol");
        assert_eq!(found(-21, '\u{1d49c}'), -33, "script capital A is mathematics");
        let (face, glyph) = face(-23).find('\u{e000}');
        assert_eq!((face.number, glyph), (-23, 0));
    }

    #[test]
    fn pens_get_strokes_of_the_same_character() {
        let pens: Vec<i32> = FACES.iter().map(|face| face.pen_substitute().number()).collect();
        assert_eq!(pens, [-4, -12, -4, -12, -7, -13, -10, -14, 1, 1, 1, 1, -7, -7]);
    }

    #[test]
    fn numbers_that_are_not_glyphs_are_blank() {
        let face = face(-21);
        assert_eq!(face.advance(u16::MAX), 0.0);
        assert!(face.outline(u16::MAX).verbs.is_empty());
        assert!(face.outline(face.glyph_id(' ').unwrap()).verbs.is_empty());
    }

    #[test]
    fn the_licences_come_with_the_files() {
        let liberation = include_str!("../../data/outline/LICENSE-Liberation");
        assert!(liberation.contains("Reserved Font Name Liberation") && liberation.contains("DISCLAIMER"));
        let dejavu = include_str!("../../data/outline/LICENSE-DejaVu");
        assert!(dejavu.contains("Bitstream Vera Fonts Copyright") && dejavu.contains("Arev Fonts Copyright"));
        let hershey = include_str!("../../data/hershey/LICENSE");
        assert!(hershey.contains("A. V. Hershey") && hershey.contains("James Hurt"));
    }
}
