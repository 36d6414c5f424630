//! Shaping: from characters to the glyphs of outline faces, with kerning and marks in place.

use glam::DVec2;
use harfrust::{Buffer, Direction, ShapeOptions, ShaperFont, shape};

use super::is_mark;
use super::layout::{Cell, FaceGlyph, PlacedGlyph, characters};
use super::outline::OutlineFace;

/// A shaper with its buffers.
#[derive(Debug, Default)]
pub(crate) struct Shaper {
    buffer: Option<Buffer>,
    letters: Vec<Letter>,
}

/// A character of the text with the face and glyph that show it.
#[derive(Clone, Copy, Debug)]
struct Letter {
    character: char,
    cluster: u32,
    face: &'static OutlineFace,
    glyph: u16,
}

impl Shaper {
    /// Makes a cell for every character with its marks, in the order of the text.
    ///
    /// `kerned` is none when every character stands for itself, else it tells whether the characters stand in
    /// reverse order on the base line.
    pub(crate) fn cells(
        &mut self,
        text: &str,
        face: &'static OutlineFace,
        kerned: Option<bool>,
        expansion: f64,
        glyphs: &mut Vec<PlacedGlyph>,
        cells: &mut Vec<Cell>,
    ) {
        self.letters.clear();
        for (cluster, character) in characters(text) {
            let (mut in_face, mut glyph) = face.find(character);
            // A mark stays in the face of its letter where that face has it.
            if let Some(letter) = self.letters.last().filter(|_| is_mark(character))
                && let Some(own) = letter.face.glyph_id(character)
            {
                (in_face, glyph) = (letter.face, own);
            }
            self.letters.push(Letter { character, cluster, face: in_face, glyph });
        }
        let reversed = kerned == Some(true);
        if reversed {
            reverse_groups(&mut self.letters, |letter| is_mark(letter.character));
        }
        let letters = std::mem::take(&mut self.letters);
        let mut rest = letters.as_slice();
        while let Some(first) = rest.first() {
            // A run is shaped as a whole: neighbours of the same face, or one character with its marks.
            let same_run = |letter: &Letter| {
                std::ptr::eq(letter.face, first.face) && (kerned.is_some() || is_mark(letter.character))
            };
            let length = 1 + rest[1..].iter().take_while(|letter| same_run(letter)).count();
            let (run, after) = rest.split_at(length);
            self.run(run, expansion, glyphs, cells);
            rest = after;
        }
        self.letters = letters;
        if reversed {
            restore_order(glyphs, cells);
        }
    }

    /// Shapes one run of a single face.
    fn run(&mut self, run: &[Letter], expansion: f64, glyphs: &mut Vec<PlacedGlyph>, cells: &mut Vec<Cell>) {
        let Some(&Letter { face, glyph, cluster, .. }) = run.first() else { return };
        if run.len() == 1 {
            let advance = face.advance(glyph) * face.em() * expansion;
            cells.push(Cell { first: glyphs.len(), width: advance });
            glyphs.push(PlacedGlyph {
                glyph: FaceGlyph::Outline(face, glyph),
                cluster,
                origin: DVec2::ZERO,
                advance,
            });
            return;
        }
        let Some(font) = face.font() else { return };
        let mut buffer = self.buffer.take().unwrap_or_default();
        buffer.reset();
        for (index, letter) in (0_u32..).zip(run) {
            buffer.push(u32::from(letter.character), index);
        }
        buffer.guess_segment_properties();
        buffer.set_language(None);
        buffer.set_direction(Direction::LeftToRight);
        let options = ShapeOptions::new().plan(face.plan(buffer.script())).features(OutlineFace::features());
        if shape(&ShaperFont::new(font), &mut buffer, options).is_ok() {
            let unit = face.em() / f64::from(face.units_per_em);
            let scale = DVec2::new(unit * expansion, unit);
            let mut pen = DVec2::ZERO;
            let mut current = None;
            for (info, position) in buffer.glyph_infos().iter().zip(buffer.glyph_positions()) {
                if current != Some(info.cluster) {
                    current = Some(info.cluster);
                    pen = DVec2::ZERO;
                    cells.push(Cell { first: glyphs.len(), width: 0.0 });
                }
                let offset = DVec2::new(f64::from(position.x_offset), f64::from(position.y_offset));
                let advance = f64::from(position.x_advance) * scale.x;
                glyphs.push(PlacedGlyph {
                    glyph: FaceGlyph::Outline(face, u16::try_from(info.glyph_id).unwrap_or(0)),
                    cluster: run.get(info.cluster as usize).map_or(cluster, |letter| letter.cluster),
                    origin: pen + offset * scale,
                    advance,
                });
                pen.x += advance;
                if let Some(cell) = cells.last_mut() {
                    cell.width = pen.x;
                }
            }
        }
        self.buffer = Some(buffer);
    }
}

/// Reverses the order of groups, each of which is an element and those after it that belong to it.
fn reverse_groups<T>(items: &mut [T], belongs: impl Fn(&T) -> bool) {
    items.reverse();
    let mut start = 0;
    for index in 0..items.len() {
        if !belongs(&items[index]) {
            items[start..=index].reverse();
            start = index + 1;
        }
    }
}

/// Brings cells made from reversed text back to the order of the text, with their glyphs.
fn restore_order(glyphs: &mut [PlacedGlyph], cells: &mut [Cell]) {
    let total = glyphs.len();
    for index in 0..cells.len() {
        let end = cells.get(index + 1).map_or(total, |next| next.first);
        glyphs[cells[index].first..end].reverse();
        // From here on `first` counts from the other end.
        cells[index].first = total - end;
    }
    glyphs.reverse();
    cells.reverse();
}
