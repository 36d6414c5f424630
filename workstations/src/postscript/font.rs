//! Fonts embedded in a PostScript document: Type 42 fonts over subsets of TrueType files.
//!
//! A font must be defined before the characters that it shows, when it is not known yet which ones they will
//! be. So the text of a page is held back for a while, at most as long as its buffer lasts, which for most
//! pages is the whole page; when it is let go, the fonts with the characters that it needs go first. A
//! character that comes up later goes into another font. Fonts end with their page, so that pages can be
//! taken out of the document and put in another order.
//!
//! Characters have PostScript's names for Unicode characters, by which other programs find the text.

use super::ascii85::Ascii85;
use crate::number::Decimal;
use crate::pdf::content::Content;
use crate::pdf::run::{self, Step};
use crate::pdf::sfnt::{self, Table};
use gks_pipeline::device::{DeviceError, GlyphRun};
use gks_pipeline::font::OutlineFace;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use subsetter::GlyphRemapper;

/// The longest string in characters as written, well below the 255 that a line may have.
const LONGEST_STRING: usize = 160;

/// The longest part of a font file that a string of PostScript may hold.
const LONGEST_PART: usize = 65_000;

/// The fonts of a page.
#[derive(Default)]
pub(crate) struct Fonts {
    fonts: Vec<Font>,
    /// How many of them are written.
    written: usize,
    /// Where the characters are: the number of the face and the glyph lead to the font and the code.
    places: BTreeMap<(i32, u16), (usize, u8)>,
}

/// A font for up to 255 characters of a face.
struct Font {
    face: &'static OutlineFace,
    glyphs: GlyphRemapper,
    /// The glyph of the subset and the name by code; code 0 is the missing glyph.
    encoding: BTreeMap<u8, (u16, String)>,
}

impl Font {
    fn new(face: &'static OutlineFace) -> Self {
        let encoding = BTreeMap::from([(0, (0, ".notdef".to_owned()))]);
        Font { face, glyphs: GlyphRemapper::new(), encoding }
    }

    /// The code of a new character, or none if all are taken. Characters of ASCII keep their own code where
    /// they can, so that text can be read in the file.
    fn add(&mut self, glyph: u16, shown: &str) -> Option<u8> {
        let mut characters = shown.chars();
        let only = characters.next().filter(|_| characters.next().is_none());
        let own = only.and_then(|c| u8::try_from(c).ok()).filter(|code| (32..127).contains(code));
        let free = |code: &u8| !self.encoding.contains_key(code);
        let code = own.filter(free).or_else(|| (128..=255).chain(1..128).find(free))?;
        let number = self.glyphs.remap(glyph);
        let name = match only.map(u32::from) {
            Some(unicode @ 0..=0xffff) => format!("uni{unicode:04X}"),
            Some(unicode) => format!("u{unicode:05X}"),
            None => format!("g{glyph}"),
        };
        let taken = self.encoding.values().any(|(_, other)| *other == name);
        self.encoding.insert(code, (number, if taken { format!("g{glyph}") } else { name }));
        Some(code)
    }

    /// Writes the definition, by which the font gets the name `F` with its number. The names of the
    /// resource are added to `names`.
    fn write(&self, number: usize, names: &mut Vec<String>, out: &mut Vec<u8>) -> Result<(), DeviceError> {
        let name = sfnt::name(self.face, self.glyphs.remapped_gids());
        let tables = sfnt::subset(self.face, &self.glyphs)?;
        let mut text = format!(
            "%%BeginResource: font {name}\n\
             11 dict begin/FontName/{name} def/FontType 42 def/PaintType 0 def\n\
             /FontMatrix[1 0 0 1 0 0]def/FontBBox["
        );
        for (i, limit) in sfnt::bounds(self.face).into_iter().enumerate() {
            if i > 0 {
                text.push(' ');
            }
            let _ = write!(text, "{limit:.3}");
        }
        text.push_str("]def\n/Encoding 256 array def 0 1 255{Encoding exch/.notdef put}for\n");
        for (code, (_, name)) in self.encoding.iter().filter(|(code, _)| **code != 0) {
            let _ = writeln!(text, "Encoding {code}/{name} put");
        }
        let _ = writeln!(text, "/CharStrings {} dict def CharStrings begin", self.encoding.len());
        for (glyph, name) in self.encoding.values() {
            let _ = writeln!(text, "/{name} {glyph} def");
        }
        text.push_str("end\n/sfnts[\n");
        out.extend_from_slice(text.as_bytes());
        for part in parts(&tables) {
            out.extend_from_slice(b"<~");
            let mut digits = Ascii85::default();
            digits.write(&part, out);
            // One byte more than the font has, as the definition of Type 42 wants at the end of each string.
            digits.write(&[0], out);
            digits.finish(out);
            out.push(b'\n');
        }
        let end = format!(
            "]def\nFontName currentdict end definefont pop\n%%EndResource\n/F{number}/{name} findfont def\n"
        );
        out.extend_from_slice(end.as_bytes());
        if !names.contains(&name) {
            names.push(name);
        }
        Ok(())
    }
}

/// A font file in parts, cut between tables and between the characters of a table that is longer than a part
/// may be.
fn parts(tables: &[Table]) -> Vec<Vec<u8>> {
    let mut parts = vec![sfnt::directory(tables)];
    for table in tables {
        let mut data = table.data.clone();
        data.resize(data.len().next_multiple_of(4), 0);
        let cuts = if table.tag == *b"glyf" { offsets(tables) } else { Vec::new() };
        let mut rest = &data[..];
        let mut start = 0;
        while !rest.is_empty() {
            let fits = |cut: &&usize| **cut > start && **cut - start <= LONGEST_PART;
            let end = match cuts.iter().rev().find(fits) {
                Some(&cut) if rest.len() > LONGEST_PART => cut - start,
                _ => rest.len(),
            };
            let part = &rest[..end];
            match parts.last_mut() {
                Some(last) if last.len() + part.len() <= LONGEST_PART => last.extend_from_slice(part),
                _ => parts.push(part.to_vec()),
            }
            rest = &rest[end..];
            start += end;
        }
    }
    parts
}

/// Where the characters begin in the table that holds their outlines, as far as on an even offset.
fn offsets(tables: &[Table]) -> Vec<usize> {
    let table = |tag: &[u8; 4]| tables.iter().find(|table| table.tag == *tag).map(|table| &table.data[..]);
    let (Some(head), Some(loca)) = (table(b"head"), table(b"loca")) else { return Vec::new() };
    let offsets: Vec<usize> = if head.get(51) == Some(&0) {
        loca.chunks_exact(2).map(|o| usize::from(u16::from_be_bytes([o[0], o[1]])) * 2).collect()
    } else {
        loca.chunks_exact(4).map(|o| u32::from_be_bytes([o[0], o[1], o[2], o[3]]) as usize).collect()
    };
    offsets.into_iter().filter(|offset| offset % 2 == 0).collect()
}

impl Fonts {
    /// Writes the fonts that are not written yet.
    pub(crate) fn write(&mut self, names: &mut Vec<String>, out: &mut Vec<u8>) -> Result<(), DeviceError> {
        for (number, font) in self.fonts.iter().enumerate().skip(self.written) {
            font.write(number, names, out)?;
        }
        self.written = self.fonts.len();
        Ok(())
    }

    /// The font and the code of a character.
    fn place(&mut self, face: &'static OutlineFace, glyph: u16, shown: &str) -> (usize, u8) {
        let glyph = if glyph < face.glyphs() { glyph } else { 0 };
        let key = (face.number, glyph);
        if let Some(place) = self.places.get(&key) {
            return *place;
        }
        let open = |font: &Font| std::ptr::eq(font.face, face);
        let last = self.fonts[self.written..].iter().rposition(open).map(|at| at + self.written);
        let place = last.and_then(|at| Some((at, self.fonts[at].add(glyph, shown)?))).unwrap_or_else(|| {
            let mut font = Font::new(face);
            // A new font has room.
            let code = font.add(glyph, shown).unwrap_or(0);
            self.fonts.push(font);
            (self.fonts.len() - 1, code)
        });
        self.places.insert(key, place);
        place
    }

    /// Shows a run of characters.
    pub(crate) fn draw(&mut self, run: &GlyphRun<'_>, content: &mut Content) {
        content.area_colour(run.paint.colour);
        let mut line = Line::default();
        run::steps(run, |step| match step {
            Step::Line(origin) => {
                line.end(content.text());
                line.visible = content.system(run.x.0, run.y.0, origin);
                if line.visible {
                    content.text().extend_from_slice(b"T\n");
                }
            }
            Step::Gap(gap) => line.gap(gap, content.text()),
            Step::Show(i) => {
                let (font, code) = self.place(run.face, run.glyphs[i].id, run::shown(run, i));
                line.glyph(font, code, content.text());
            }
        });
        line.end(content.text());
    }
}

/// A line of characters in one coordinate system, while it is put together.
#[derive(Default)]
struct Line {
    visible: bool,
    font: Option<usize>,
    string: Vec<u8>,
}

impl Line {
    fn glyph(&mut self, font: usize, code: u8, text: &mut Vec<u8>) {
        if !self.visible {
            return;
        }
        if self.font != Some(font) || self.string.len() > LONGEST_STRING {
            self.show(text);
        }
        if self.font != Some(font) {
            text.extend_from_slice(format!("F{font} y\n").as_bytes());
            self.font = Some(font);
        }
        match code {
            b'(' | b')' | b'\\' => self.string.extend([b'\\', code]),
            32..127 => self.string.push(code),
            _ => self.string.extend_from_slice(format!("\\{code:03o}").as_bytes()),
        }
    }

    fn gap(&mut self, gap: i64, text: &mut Vec<u8>) {
        if self.visible {
            self.show(text);
            Decimal::new(0).write_steps(text, gap);
            text.extend_from_slice(b" k\n");
        }
    }

    fn show(&mut self, text: &mut Vec<u8>) {
        if !self.string.is_empty() {
            text.push(b'(');
            text.append(&mut self.string);
            text.extend_from_slice(b")s\n");
        }
    }

    fn end(&mut self, text: &mut Vec<u8>) {
        self.show(text);
        if self.visible {
            text.extend_from_slice(b"Q\n");
        }
        *self = Line::default();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::font::{Face, face};

    fn table(tag: [u8; 4], data: Vec<u8>) -> Table {
        Table { tag, data }
    }

    #[test]
    fn long_tables_are_cut_between_characters() {
        let mut head = vec![0; 54];
        head[51] = 1;
        let offsets = (0..=150_u32).flat_map(|i| (i * 1000).to_be_bytes()).collect();
        let outlines = (0..150_000_u32).map(|i| (i / 1000) as u8).collect();
        let tables = [
            table(*b"glyf", outlines),
            table(*b"head", head),
            table(*b"loca", offsets),
            table(*b"maxp", vec![7; 6]),
        ];
        let parts = parts(&tables);
        assert_eq!(parts.concat(), sfnt::file(&tables));
        let lengths: Vec<usize> = parts.iter().map(Vec::len).collect();
        assert!(lengths.iter().all(|length| *length <= LONGEST_PART), "{lengths:?}");
        assert_eq!(lengths[1..3], [65_000, 65_000]);
        let short = &tables[1..];
        assert_eq!(super::parts(short), [sfnt::file(short)]);
    }

    #[test]
    fn ascii_keeps_its_codes_and_names_are_unique() {
        let Some(Face::Outline(sans)) = face(-21) else { panic!("font -21 is an outline face") };
        let mut font = Font::new(sans);
        let codes: Vec<u8> = [(10, "A"), (11, "é"), (12, "A"), (13, "fi"), (14, "😀")]
            .map(|(glyph, shown)| font.add(glyph, shown).unwrap())
            .into();
        assert_eq!(codes, [65, 128, 129, 130, 131]);
        let names: Vec<&str> = font.encoding.values().map(|(_, name)| name.as_str()).collect();
        assert_eq!(names, [".notdef", "uni0041", "uni00E9", "g12", "g13", "u1F600"]);
        let more = (100..).map_while(|glyph| font.add(glyph, "")).count();
        assert_eq!(more, 250);
    }
}
