//! Text as text, in fonts that the document brings along.
//!
//! The position of every character is written, and in addition the letter spacing, because some viewers heed
//! only the first position. Characters that do not follow at their natural distance start a new piece with
//! a position of its own. Viewers that ignore embedded fonts find the family, or one with the same
//! metrics, by name.

use super::base64::Base64;
use super::document::{Document, attribute, open_attribute, paint};
use super::subset::subset;
use super::{COORDINATE, FINE};
use gks_geometry::{Du, Rect};
use gks_pipeline::device::GlyphRun;
use gks_pipeline::font::OutlineFace;
use glam::{DMat2, DVec2};
use std::collections::BTreeMap;
use std::io::{self, Write};

/// As far in user units a character may be from where it would be by itself.
const TOLERANCE: f64 = 0.05;

/// The fonts of a document.
#[derive(Default)]
pub(super) struct Fonts(Vec<Font>);

/// A font of which a document shows characters.
struct Font {
    face: &'static OutlineFace,
    /// The glyphs shown, by characters.
    glyphs: BTreeMap<char, u16>,
}

impl Fonts {
    /// Forgets the fonts of the document before.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// Draws a run of characters, if it can be written as text.
    pub(super) fn draw(
        &mut self,
        document: &mut Document,
        clip: Option<&Rect<Du>>,
        run: &GlyphRun<'_>,
    ) -> io::Result<bool> {
        let Some(characters) = characters(run) else { return Ok(false) };
        let Some(number) = self.admit(run.face, &characters, run) else { return Ok(false) };
        // What is left of the em square beside its height; where nothing is left, nothing is seen.
        let size = run.y.length();
        let basis = DMat2::from_cols(run.x.0, -run.y.0) * (1.0 / size);
        let inverse = basis.inverse();
        if characters.is_empty() || !inverse.is_finite() {
            return Ok(true);
        }
        document.group(clip, |out| {
            paint(out, "fill", run.paint.colour);
            write_family(out, number, run.face);
            open_attribute(out, "font-size");
            FINE.write(out, size);
            out.push(b'"');
        });
        document.raw("<text");
        let is_upright = (basis - DMat2::IDENTITY).abs_diff_eq(DMat2::ZERO, 1e-6);
        let origin = if is_upright { DVec2::ZERO } else { run.glyphs[0].origin.0 };
        if !is_upright {
            let [a, b, c, d] = basis.to_cols_array();
            open_attribute(&mut document.out, "transform");
            document.raw("matrix(");
            for value in [a, b, c, d] {
                FINE.write(&mut document.out, value);
                document.raw(" ");
            }
            document.number(origin.x);
            document.raw(" ");
            document.number(origin.y);
            document.raw(")\"");
        }
        let places: Vec<DVec2> = run.glyphs.iter().map(|glyph| inverse * (glyph.origin.0 - origin)).collect();
        let widths: Vec<f64> = run.glyphs.iter().map(|glyph| run.face.advance(glyph.id) * size).collect();
        let spacing = spacing(&places, &widths);
        let pieces = ends_of_pieces(&places, &widths, spacing);
        // Some viewers drop a space at either end of a piece.
        let blank = |at: usize| characters.get(at) == Some(&' ');
        let at_edge = blank(0) || pieces.iter().any(|&end| blank(end) || end > 0 && blank(end - 1));
        if at_edge || run.text.contains("  ") {
            document.raw(" xml:space=\"preserve\"");
        }
        if COORDINATE.steps(spacing) != 0 && pieces.len() < places.len() {
            open_attribute(&mut document.out, "letter-spacing");
            FINE.write(&mut document.out, spacing);
            document.raw("\"");
        }
        let (mut first, mut line) = (0, 0.0);
        for next in pieces {
            if first > 0 {
                document.raw("<tspan");
            }
            write_places(&mut document.out, &places[first..next], line);
            line = places[first].y;
            document.raw(">");
            characters[first..next].iter().for_each(|&character| escape(&mut document.out, character));
            if first > 0 {
                document.raw("</tspan>");
            }
            first = next;
        }
        document.raw("</text>\n");
        Ok(true)
    }

    /// The number of a font to which the characters of a run have been added; none if a character is
    /// already shown by another glyph of the font.
    fn admit(
        &mut self,
        face: &'static OutlineFace,
        characters: &[char],
        run: &GlyphRun<'_>,
    ) -> Option<usize> {
        let number = match self.0.iter().position(|font| std::ptr::eq(font.face, face)) {
            Some(number) => number,
            None => {
                self.0.push(Font { face, glyphs: BTreeMap::new() });
                self.0.len() - 1
            }
        };
        let known = &mut self.0[number].glyphs;
        let pairs = || characters.iter().copied().zip(run.glyphs.iter().map(|glyph| glyph.id));
        if pairs().any(|(character, glyph)| known.get(&character).is_some_and(|&other| other != glyph)) {
            return None;
        }
        known.extend(pairs());
        Some(number)
    }

    /// Writes the fonts themselves, at the end of the document, when all characters are known.
    pub(super) fn write(&self, document: &mut Document) -> io::Result<()> {
        if self.0.is_empty() {
            return Ok(());
        }
        document.raw("<style type=\"text/css\">\n");
        for (number, Font { face, glyphs }) in self.0.iter().enumerate() {
            let Some(file) = subset(face.data, glyphs) else { continue };
            document.raw(&format!("@font-face{{font-family:gks{number};"));
            document.raw(if face.bold { "font-weight:bold;" } else { "" });
            document.raw(if face.italic { "font-style:italic;" } else { "" });
            document.raw("src:url(data:font/ttf;base64,");
            let mut writer = Base64::new(document);
            writer.write_all(&file)?;
            writer.finish()?;
            document.raw(")format(\"truetype\")}\n");
        }
        document.raw("</style>\n");
        Ok(())
    }
}

/// The characters of a run, one for each glyph; none if they do not belong to one another one by one, or if a
/// viewer would not show them so: what is written from right to left, combined or reordered, and controls.
fn characters(run: &GlyphRun<'_>) -> Option<Vec<char>> {
    let mut glyphs = run.glyphs.iter();
    let mut characters = Vec::with_capacity(run.glyphs.len());
    for (at, character) in run.text.char_indices() {
        if glyphs.next()?.cluster as usize != at || !is_plain(character) {
            return None;
        }
        characters.push(character);
    }
    glyphs.next().is_none().then_some(characters)
}

/// Whether a character stands for itself wherever it is: not a control, a mark or a character of the scripts
/// whose letters change with their neighbours, and in the basic multilingual plane.
fn is_plain(character: char) -> bool {
    !matches!(u32::from(character),
        0..=0x1f | 0x7f..=0x9f | 0xad
        | 0x300..=0x36f
        | 0x483..=0x489
        | 0x590..=0x10ff
        | 0x1700..=0x1cff
        | 0x1dc0..=0x1dff
        | 0x200b..=0x200f
        | 0x2028..=0x202e
        | 0x2060..=0x206f
        | 0x20d0..=0x20ff
        | 0x302a..=0x302f
        | 0xa66f..=0xa69f
        | 0xa800..=0xabff
        | 0xd7b0..=0xf8ff
        | 0xfb1d..=0xfe2f
        | 0xfe70..=0xfeff
        | 0xfff0..
    )
}

/// The distance that is added between characters: the median, because pairs may be kerned.
fn spacing(places: &[DVec2], widths: &[f64]) -> f64 {
    let mut gaps: Vec<f64> =
        places.windows(2).zip(widths).map(|(pair, width)| pair[1].x - pair[0].x - width).collect();
    gaps.sort_by(f64::total_cmp);
    gaps.get(gaps.len() / 2).copied().unwrap_or(0.0)
}

/// Where the pieces end whose characters follow one another at the natural distance and `spacing`.
fn ends_of_pieces(places: &[DVec2], widths: &[f64], spacing: f64) -> Vec<usize> {
    let mut ends = Vec::new();
    let mut expected = places[0];
    for (i, (&place, width)) in places.iter().zip(widths).enumerate() {
        if (place - expected).abs().max_element() > TOLERANCE {
            ends.push(i);
            expected = place;
        }
        expected.x += width + spacing;
    }
    ends.push(places.len());
    ends
}

/// Appends the positions of the characters of a piece, which lie on a horizontal line; `line` is the one
/// before.
fn write_places(out: &mut Vec<u8>, places: &[DVec2], line: f64) {
    open_attribute(out, "x");
    for (i, place) in places.iter().enumerate() {
        if i > 0 {
            out.push(b' ');
        }
        COORDINATE.write(out, place.x);
    }
    out.push(b'"');
    if COORDINATE.steps(places[0].y) != COORDINATE.steps(line) {
        attribute(out, "y", places[0].y);
    }
}

/// Appends the attributes that choose a font: the embedded one, the family, families with the same metrics.
fn write_family(out: &mut Vec<u8>, number: usize, face: &OutlineFace) {
    let family = face.family;
    let substitutes = if family.contains("Mono") {
        "Cousine,'Courier New',Courier,monospace"
    } else if family.contains("Serif") || family.contains("Math") {
        "Tinos,'Times New Roman',Times,serif"
    } else {
        "Arimo,Arial,Helvetica,sans-serif"
    };
    open_attribute(out, "font-family");
    out.extend_from_slice(format!("gks{number},'").as_bytes());
    family.chars().filter(|&c| c != '\'').for_each(|character| escape(out, character));
    out.extend_from_slice(format!("',{substitutes}\"").as_bytes());
    if face.bold {
        out.extend_from_slice(b" font-weight=\"bold\"");
    }
    if face.italic {
        out.extend_from_slice(b" font-style=\"italic\"");
    }
}

/// Appends a character so that it is not taken for markup.
fn escape(out: &mut Vec<u8>, character: char) {
    match character {
        '&' => out.extend_from_slice(b"&amp;"),
        '<' => out.extend_from_slice(b"&lt;"),
        '>' => out.extend_from_slice(b"&gt;"),
        '"' => out.extend_from_slice(b"&quot;"),
        _ => out.extend_from_slice(character.encode_utf8(&mut [0; 4]).as_bytes()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::Options;
    use crate::svg::tests::{BLACK, RED, body, page_with};
    use crate::svg::{Svg, tests::draw as must_draw};
    use gks_geometry::{Point, Vector};
    use gks_pipeline::device::{Device, Drawn, Form, Glyph, Mark};
    use gks_pipeline::font::{Face, face};

    fn outline(number: i32) -> &'static OutlineFace {
        match face(number) {
            Some(Face::Outline(face)) => face,
            _ => panic!("{number} is no outline face"),
        }
    }

    /// Glyphs of a text from `at` on, `gap` em apart beside their widths.
    fn glyphs(face: &OutlineFace, text: &str, at: DVec2, x: DVec2, gap: f64) -> Vec<Glyph> {
        let mut at = at;
        let place = |(cluster, character)| {
            let id = face.glyph_id(character).unwrap_or(0);
            let origin = Point::from_vec(at);
            at += x * (face.advance(id) + gap);
            Glyph { id, cluster: cluster as u32, origin }
        };
        text.char_indices().map(place).collect()
    }

    fn run<'a>(text: &'a str, glyphs: &'a [Glyph], x: (f64, f64), y: (f64, f64)) -> GlyphRun<'a> {
        GlyphRun { text, face: outline(-21), glyphs, x: x.into(), y: y.into(), paint: BLACK }
    }

    /// What a page shows before the fonts.
    fn shown(draw: impl FnOnce(&mut Svg)) -> String {
        let text = body(draw);
        text[..text.find("<style").unwrap()].to_owned()
    }

    const GROUP: &str = "<g fill=\"#000\" \
        font-family=\"gks0,'Liberation Sans',Arimo,Arial,Helvetica,sans-serif\" font-size=\"10\">\n";

    #[test]
    fn characters_are_placed_one_by_one() {
        let face = outline(-21);
        let (at, x) = (DVec2::new(20.0, 30.0), DVec2::new(10.0, 0.0));
        let near = glyphs(face, "a<b", at, x, 0.0);
        let far = glyphs(face, " i  &", at, x, 0.25);
        let mut kerned = glyphs(face, "AVAB", at, x, 0.0);
        kerned[1].origin = kerned[1].origin - Vector::new(0.74, 0.0);
        let mut down = glyphs(face, "AB", at, x, 0.0);
        down[1].origin = Point::new(20.0, 42.0);
        let text = shown(|svg| {
            for (text, glyphs) in [("a<b", &near), (" i  &", &far), ("AVAB", &kerned), ("AB", &down)] {
                must_draw(svg, Form::Text(run(text, glyphs, (10.0, 0.0), (0.0, -10.0))), None);
            }
        });
        let expected = "<text x=\"20 25.56 31.4\" y=\"30\">a&lt;b</text>\n\
            <text xml:space=\"preserve\" letter-spacing=\"2.5\" \
            x=\"20 25.28 30 35.28 40.56\" y=\"30\"> i  &amp;</text>\n\
            <text x=\"20\" y=\"30\">A<tspan x=\"25.93\">V</tspan><tspan x=\"33.34 40.01\">AB</tspan></text>\n\
            <text x=\"20\" y=\"30\">A<tspan x=\"20\" y=\"42\">B</tspan></text>\n";
        assert_eq!(text, format!("{GROUP}{expected}</g>\n"));
    }

    #[test]
    fn other_directions_are_matrices() {
        let glyphs = glyphs(outline(-21), "up", DVec2::new(50.0, 60.0), DVec2::new(0.0, -20.0), 0.0);
        let text = shown(|svg| {
            must_draw(svg, Form::Text(run("up", &glyphs, (0.0, -20.0), (-10.0, 0.0))), None);
        });
        let expected = "<text transform=\"matrix(0 -2 1 0 50 60)\" x=\"0 5.56\">up</text>\n";
        assert_eq!(text, format!("{GROUP}{expected}</g>\n"));
        // Flat text leaves nothing to see.
        for (x, y) in [((0.0, 0.0), (0.0, -10.0)), ((10.0, 0.0), (0.0, 0.0)), ((5.0, 5.0), (5.0, 5.0))] {
            let text = body(|svg| must_draw(svg, Form::Text(run("up", &glyphs, x, y)), None));
            assert!(!text.contains("<text"));
        }
    }

    #[test]
    fn text_that_viewers_would_change_is_refused() {
        let face = outline(-21);
        let refused = |svg: &mut Svg, text: &str, glyphs: &[Glyph]| {
            let mark = Mark { form: Form::Text(run(text, glyphs, (10.0, 0.0), (0.0, -10.0))), clip: None };
            svg.draw(&mark).unwrap() == Drawn::No
        };
        let place = |text| glyphs(face, text, DVec2::ZERO, DVec2::new(10.0, 0.0), 0.0);
        body(|svg| {
            for text in
                ["a\u{1b}b", "tab\there", "שלום", "e\u{301}", "soft\u{ad}hyphen", "\u{1f600}", "\u{ffff}"]
            {
                assert!(refused(svg, text, &place(text)), "{text:?}");
            }
            // A ligature, a glyph too many, and a character with another glyph than before.
            let plain = place("fix");
            assert!(refused(svg, "fix", &plain[1..]));
            assert!(refused(svg, "fi", &plain));
            assert!(!refused(svg, "fix", &plain));
            let mut other = plain.clone();
            other[2].id = other[0].id;
            assert!(refused(svg, "fix", &other));
        });
        let outlines = Options { outlines: true, ..Options::default() };
        let text = page_with(&outlines, |svg| assert!(refused(svg, "fix", &place("fix"))));
        assert!(!text.contains("@font-face"));
    }

    #[test]
    fn fonts_come_at_the_end_and_only_with_what_is_shown() {
        let place = |face, text| glyphs(face, text, DVec2::ZERO, DVec2::new(10.0, 0.0), 0.0);
        let (roman, bold) = (outline(-21), outline(-28));
        let text = body(|svg| {
            for face in [roman, bold, roman] {
                let run = GlyphRun {
                    face,
                    glyphs: &place(face, "ab"),
                    paint: RED,
                    ..run("ab", &[], (10.0, 0.0), (0.0, -10.0))
                };
                must_draw(svg, Form::Text(run), None);
            }
        });
        let fonts = &text[text.find("<style type=\"text/css\">\n").unwrap()..];
        assert!(fonts.ends_with("</style>\n"));
        let rules: Vec<&str> = fonts.lines().filter(|line| line.starts_with("@font-face")).collect();
        assert_eq!(rules.len(), 2);
        assert!(rules[0].starts_with("@font-face{font-family:gks0;src:url(data:font/ttf;base64,AAEAAAAK"));
        assert!(rules[1].starts_with("@font-face{font-family:gks1;font-weight:bold;font-style:italic;src:"));
        assert!(rules[0].len() < 2500, "{}", rules[0].len());
        assert_eq!(text.matches("font-weight=\"bold\" font-style=\"italic\"").count(), 1);
    }
}
