//! Fonts embedded in a PDF document: composite fonts over subsets of TrueType files, with the Unicode
//! characters that their glyphs show.

use super::content::Content;
use super::document::Document;
use super::run::{self, Step};
use super::sfnt;
use crate::number::Decimal;
use gks_pipeline::device::{DeviceError, GlyphRun};
use gks_pipeline::font::OutlineFace;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Name, Rect, Ref, Str};
use subsetter::GlyphRemapper;

/// The character collection of fonts whose character codes are glyph numbers.
const IDENTITY: SystemInfo<'static> =
    SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };

/// Gaps are counted in tenths of what PDF counts them in: thousandths of an em.
const GAP: Decimal = Decimal::new(1).bare();

/// The fonts of a document; they are written when all of their characters are known.
#[derive(Default)]
pub(crate) struct Fonts(Vec<Font>);

struct Font {
    face: &'static OutlineFace,
    id: Ref,
    glyphs: GlyphRemapper,
    /// The characters that each glyph of the subset shows.
    shown: Vec<String>,
}

impl Font {
    /// The number of a glyph in the subset; the missing glyph for a number that is none of the face.
    fn code(&mut self, glyph: u16, shown: &str) -> u16 {
        let code = self.glyphs.remap(if glyph < self.face.glyphs() { glyph } else { 0 });
        let known = usize::from(code) + 1;
        if self.shown.len() < known {
            self.shown.resize(known, String::new());
        }
        if self.shown[known - 1].is_empty() {
            self.shown[known - 1].push_str(shown);
        }
        code
    }

    fn write(&self, document: &mut Document) -> Result<(), DeviceError> {
        let face = self.face;
        let name = sfnt::name(face, self.glyphs.remapped_gids());
        let [cid, descriptor, data, to_unicode] =
            [document.reserve()?, document.reserve()?, document.reserve()?, document.reserve()?];
        document.object(self.id, |chunk| {
            let mut font = chunk.type0_font(self.id);
            font.base_font(Name(name.as_bytes())).encoding_predefined(Name(b"Identity-H"));
            font.descendant_font(cid).to_unicode(to_unicode);
        })?;
        document.object(cid, |chunk| {
            let mut font = chunk.cid_font(cid);
            font.subtype(CidFontType::Type2).base_font(Name(name.as_bytes())).system_info(IDENTITY);
            font.font_descriptor(descriptor).cid_to_gid_map_predefined(Name(b"Identity"));
            let advances = self.glyphs.remapped_gids().map(|glyph| (face.advance(glyph) * 1000.0) as f32);
            font.widths().consecutive(0, advances);
        })?;
        let metrics = face.metrics();
        let units = |heights: f64| (heights / face.em() * 1000.0) as f32;
        let [left, bottom, right, top] = sfnt::bounds(face).map(|em| (em * 1000.0) as f32);
        let mut flags = FontFlags::SYMBOLIC;
        flags.set(FontFlags::ITALIC, face.italic);
        flags.set(FontFlags::FIXED_PITCH, face.family.ends_with("Mono"));
        flags.set(FontFlags::SERIF, face.family.ends_with("Serif"));
        document.object(descriptor, |chunk| {
            let mut entry = chunk.font_descriptor(descriptor);
            entry.name(Name(name.as_bytes())).flags(flags).bbox(Rect::new(left, bottom, right, top));
            entry.italic_angle(if face.italic { -12.0 } else { 0.0 });
            entry.ascent(units(metrics.top)).descent(units(metrics.bottom)).cap_height(units(metrics.cap));
            entry.stem_v(if face.bold { 140.0 } else { 80.0 }).font_file2(data);
        })?;
        let file = sfnt::file(&sfnt::subset(face, &self.glyphs)?);
        document.begin_stream(data, &format!("/Length1 {}", file.len()))?;
        document.write_stream(&file)?;
        document.end_stream()?;
        let mut map = UnicodeCmap::new(Name(b"GKS-Unicode"), IDENTITY);
        for (code, shown) in (0_u16..).zip(&self.shown) {
            if !shown.is_empty() {
                map.pair_with_multiple(code, shown.chars());
            }
        }
        document.begin_stream(to_unicode, "")?;
        document.write_stream(map.finish().as_slice())?;
        document.end_stream()
    }
}

impl Fonts {
    /// The object of a font, and its name among the resources of a page.
    pub(crate) fn resource(&self, index: usize) -> Option<(String, Ref)> {
        self.0.get(index).map(|font| (format!("F{index}"), font.id))
    }

    /// Shows a run of characters; the position of its font among all.
    pub(crate) fn draw(
        &mut self,
        run: &GlyphRun<'_>,
        content: &mut Content,
        document: &mut Document,
    ) -> Result<usize, DeviceError> {
        let known = self.0.iter().position(|font| std::ptr::eq(font.face, run.face));
        let index = match known {
            Some(index) => index,
            None => {
                let (id, glyphs) = (document.reserve()?, GlyphRemapper::new());
                self.0.push(Font { face: run.face, id, glyphs, shown: Vec::new() });
                self.0.len() - 1
            }
        };
        let font = &mut self.0[index];
        content.area_colour(run.paint.colour);
        content.text().extend_from_slice(b"BT\n");
        if content.changes_font(index) {
            content.text().extend_from_slice(format!("/F{index} 1 Tf\n").as_bytes());
        }
        let mut line = Line::default();
        run::steps(run, |step| match step {
            Step::Line(origin) => {
                line.show(content.text());
                line.visible = content.system(run.x.0, run.y.0, origin);
                if line.visible {
                    content.text().extend_from_slice(b"Tm\n");
                }
            }
            Step::Gap(gap) => line.gap(gap),
            Step::Show(i) => {
                let code = font.code(run.glyphs[i].id, run::shown(run, i));
                line.glyph(code);
            }
        });
        line.show(content.text());
        content.text().extend_from_slice(b"ET\n");
        Ok(index)
    }

    /// Writes all fonts.
    pub(crate) fn write(&self, document: &mut Document) -> Result<(), DeviceError> {
        self.0.iter().try_for_each(|font| font.write(document))
    }
}

/// The operand of an operator that shows characters, while it is put together.
#[derive(Default)]
struct Line {
    operand: Vec<u8>,
    in_string: bool,
    has_gaps: bool,
    visible: bool,
}

impl Line {
    fn glyph(&mut self, code: u16) {
        if !self.in_string {
            self.operand.push(b'<');
            self.in_string = true;
        }
        self.operand.extend_from_slice(format!("{code:04X}").as_bytes());
    }

    /// Moves by ten-thousandths of an em, which PDF counts backwards.
    fn gap(&mut self, gap: i64) {
        if self.in_string {
            self.operand.push(b'>');
            self.in_string = false;
        }
        GAP.write_steps(&mut self.operand, -gap);
        self.has_gaps = true;
    }

    fn show(&mut self, text: &mut Vec<u8>) {
        if self.in_string {
            self.operand.push(b'>');
        }
        if self.visible && !self.operand.is_empty() {
            if self.has_gaps {
                text.push(b'[');
                text.extend_from_slice(&self.operand);
                text.extend_from_slice(b"] TJ\n");
            } else {
                text.extend_from_slice(&self.operand);
                text.extend_from_slice(b" Tj\n");
            }
        }
        self.operand.clear();
        (self.in_string, self.has_gaps) = (false, false);
    }
}
