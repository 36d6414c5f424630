//! Shaping: from characters to the glyphs of outline faces, with kerning and marks in place.

use glam::DVec2;
use harfrust::{Buffer, ClusterLevel, Direction, Script, ShapeOptions, ShaperFont, shape, unicode};

use super::layout::{Cell, FaceGlyph, PlacedGlyph, characters};
use super::outline::OutlineFace;

/// Whether a character is a mark that belongs to the character before it.
pub(crate) fn is_mark(character: char) -> bool {
    let code = u32::from(character);
    code >= 0x300 && (unicode::combining_class(code) != 0 || unicode::script(code) == Script::INHERITED)
}

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
    /// Whether this is a mark with a letter before it.
    mark: bool,
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
            let letter = self.letters.last().filter(|_| is_mark(character));
            if let Some(&Letter { face, .. }) = letter
                && let Some(own) = face.glyph_id(character)
            {
                (in_face, glyph) = (face, own);
            }
            let mark = letter.is_some();
            self.letters.push(Letter { character, cluster, face: in_face, glyph, mark });
        }
        let reversed = kerned == Some(true);
        if reversed {
            reverse_groups(&mut self.letters, |letter| letter.mark);
        }
        let mut letters = std::mem::take(&mut self.letters);
        let mut rest = letters.as_mut_slice();
        while let Some(&first) = rest.first() {
            // A run is shaped as a whole: neighbours of the same face, or one character with its marks, or marks
            // that the face of their letter lacks.
            let neighbours = kerned.is_some() && !first.mark;
            let same_run =
                |letter: &Letter| std::ptr::eq(letter.face, first.face) && (neighbours || letter.mark);
            let length = 1 + rest[1..].iter().take_while(|letter| same_run(letter)).count();
            let (run, after) = rest.split_at_mut(length);
            self.run(run, reversed, expansion, glyphs, cells);
            rest = after;
        }
        self.letters = letters;
        if reversed {
            restore_order(glyphs, cells);
        }
    }

    /// Shapes one run of a single face, given from left to right.
    fn run(
        &mut self,
        run: &mut [Letter],
        reversed: bool,
        expansion: f64,
        glyphs: &mut Vec<PlacedGlyph>,
        cells: &mut Vec<Cell>,
    ) {
        let Some(&Letter { face, glyph, cluster, mark, .. }) = run.first() else { return };
        // A mark that the face of its letter lacks stands at the end of the letter's body, in its cell.
        let joined = cells.last().filter(|_| mark).map(|cell| cell.width);
        if run.len() == 1 {
            if let Some(width) = joined {
                let origin = DVec2::new(width, 0.0);
                glyphs.push(PlacedGlyph {
                    glyph: FaceGlyph::Outline(face, glyph),
                    cluster,
                    origin,
                    advance: 0.0,
                });
                return;
            }
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
        fill(&mut buffer, run);
        buffer.guess_segment_properties();
        // What is written from right to left comes in its own order, and leaves the shaper from left to right again.
        let leftward = reversed && buffer.direction() == Direction::RightToLeft;
        let script = buffer.script();
        if leftward {
            reverse_groups(run, |letter| letter.mark);
            fill(&mut buffer, run);
            buffer.set_script(script);
        }
        buffer.set_direction(if leftward { Direction::RightToLeft } else { Direction::LeftToRight });
        let plan = face.plan(script, buffer.direction());
        let options = ShapeOptions::new().plan(plan).features(OutlineFace::features());
        if shape(&ShaperFont::new(font), &mut buffer, options).is_ok() {
            let unit = face.em() / f64::from(face.units_per_em);
            let scale = DVec2::new(unit * expansion, unit);
            let (infos, positions) = (buffer.glyph_infos(), buffer.glyph_positions());
            let mut current = None;
            let mut pen = DVec2::ZERO;
            let mut shown = cluster;
            for (index, (info, position)) in infos.iter().zip(positions).enumerate() {
                if current != Some(info.cluster) {
                    current = Some(info.cluster);
                    pen = DVec2::ZERO;
                    match joined.filter(|_| index == 0) {
                        Some(width) => pen.x = width,
                        None => cells.push(Cell { first: glyphs.len(), width: 0.0 }),
                    }
                    // The cluster shows the letters from its own to that of the next one in the buffer's order.
                    let others = if leftward { &infos[..index] } else { &infos[index..] };
                    let mut ends = others.iter().map(|other| other.cluster).filter(|&end| end > info.cluster);
                    let end = if leftward { ends.next_back() } else { ends.next() };
                    let letters = info.cluster as usize..end.map_or(run.len(), |end| end as usize);
                    shown = run
                        .get(letters)
                        .unwrap_or(&[])
                        .iter()
                        .map(|letter| letter.cluster)
                        .min()
                        .unwrap_or(cluster);
                }
                let offset = DVec2::new(f64::from(position.x_offset), f64::from(position.y_offset));
                let advance = f64::from(position.x_advance) * scale.x;
                glyphs.push(PlacedGlyph {
                    glyph: FaceGlyph::Outline(face, u16::try_from(info.glyph_id).unwrap_or(0)),
                    cluster: shown,
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

/// Fills a buffer with letters; a mark belongs to the cluster of the letter before it.
fn fill(buffer: &mut Buffer, letters: &[Letter]) {
    buffer.reset();
    buffer.set_cluster_level(ClusterLevel::MonotoneCharacters);
    let mut cluster = 0;
    for (index, letter) in (0..).zip(letters) {
        if !letter.mark {
            cluster = index;
        }
        buffer.push(u32::from(letter.character), cluster);
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
