//! Font files cut down to the glyphs that a document shows, fit for web browsers.
//!
//! The crate `subsetter` makes files for PDF, which lack what a browser asks for: the map from characters
//! to glyphs and the metrics of `OS/2`. These are added here. Hinting programs, which are half of a typical
//! file and do nothing for text of arbitrary size and direction, are left out. Source: OpenType
//! specification 1.9.

use std::collections::BTreeMap;
use subsetter::GlyphRemapper;

/// The file that shows each character by the glyph that `glyphs` names, or none if `data` is no such
/// TrueType file.
pub(super) fn subset(data: &[u8], glyphs: &BTreeMap<char, u16>) -> Option<Vec<u8>> {
    let mut remapper = GlyphRemapper::new();
    let map: Vec<(u16, u16)> = glyphs
        .iter()
        .filter_map(|(&character, &glyph)| Some((u16::try_from(u32::from(character)).ok()?, glyph)))
        .map(|(character, glyph)| (character, remapper.remap(glyph)))
        .collect();
    let cut = subsetter::subset(data, 0, &remapper).ok()?;
    let mut head = table(&cut, b"head")?.to_vec();
    let (glyf, loca) = unhinted(table(&cut, b"glyf")?, table(&cut, b"loca")?, read(&head, 50)? != 0)?;
    // Offsets are written long; scaling is linear; the checksum is put in by `assemble`.
    put(&mut head, 50, 1)?;
    let flags = read(&head, 16)? & !0b1_1100;
    put(&mut head, 16, flags)?;
    head.get_mut(8..12)?.fill(0);
    let mut maxp = table(&cut, b"maxp")?.to_vec();
    // What the hinting programs would need, from maxTwilightPoints to maxSizeOfInstructions.
    maxp.get_mut(16..28)?.fill(0);
    let mut post = table(data, b"post")?.get(..32)?.to_vec();
    // Version 3: no glyph names.
    put(&mut post, 0, 3)?;
    put(&mut post, 2, 0)?;
    Some(assemble(&[
        (b"OS/2", table(data, b"OS/2")?.to_vec()),
        (b"cmap", character_map(&map)?),
        (b"glyf", glyf),
        (b"head", head),
        (b"hhea", table(&cut, b"hhea")?.to_vec()),
        (b"hmtx", table(&cut, b"hmtx")?.to_vec()),
        (b"loca", loca),
        (b"maxp", maxp),
        // Names: none.
        (b"name", vec![0, 0, 0, 0, 0, 6]),
        (b"post", post),
    ]))
}

/// The 16-bit number at an offset.
fn read(bytes: &[u8], at: usize) -> Option<u16> {
    let bytes = bytes.get(at..at.checked_add(2)?)?;
    Some(u16::from_be_bytes([bytes[0], bytes[1]]))
}

fn read_long(bytes: &[u8], at: usize) -> Option<usize> {
    Some(usize::from(read(bytes, at)?) << 16 | usize::from(read(bytes, at.checked_add(2)?)?))
}

fn put(bytes: &mut [u8], at: usize, value: u16) -> Option<()> {
    bytes.get_mut(at..at + 2)?.copy_from_slice(&value.to_be_bytes());
    Some(())
}

/// A table of a font file.
fn table<'a>(data: &'a [u8], tag: &[u8; 4]) -> Option<&'a [u8]> {
    let record = (0..usize::from(read(data, 4)?))
        .map(|i| 12 + 16 * i)
        .find(|&record| data.get(record..record + 4).is_some_and(|found| found == tag))?;
    let (start, length) = (read_long(data, record + 8)?, read_long(data, record + 12)?);
    data.get(start..start.checked_add(length)?)
}

/// The tables `glyf` and, with long offsets, `loca` without the programs in the glyphs.
fn unhinted(glyf: &[u8], loca: &[u8], is_long: bool) -> Option<(Vec<u8>, Vec<u8>)> {
    let offset =
        |i: usize| if is_long { read_long(loca, 4 * i) } else { Some(2 * usize::from(read(loca, 2 * i)?)) };
    let mut start = offset(0)?;
    let mut glyphs = Vec::with_capacity(glyf.len());
    let mut offsets = vec![0; 4];
    for end in (1..).map_while(offset) {
        let glyph = glyf.get(start..end)?;
        if !glyph.is_empty() {
            without_program(glyph, &mut glyphs)?;
            glyphs.resize(glyphs.len().next_multiple_of(4), 0);
        }
        offsets.extend(u32::try_from(glyphs.len()).ok()?.to_be_bytes());
        start = end;
    }
    Some((glyphs, offsets))
}

/// Appends a glyph without its program.
fn without_program(glyph: &[u8], out: &mut Vec<u8>) -> Option<()> {
    const HEADER: usize = 10;
    let contours = read(glyph, 0)? as i16;
    if let Ok(contours) = usize::try_from(contours) {
        // The ends of the contours, the length of the program, the program, flags and coordinates.
        let length = HEADER + 2 * contours;
        let rest = length + 2 + usize::from(read(glyph, length)?);
        out.extend_from_slice(glyph.get(..length)?);
        out.extend_from_slice(&[0, 0]);
        out.extend_from_slice(glyph.get(rest..)?);
        return Some(());
    }
    let first = out.len();
    let mut at = HEADER;
    out.extend_from_slice(glyph.get(..HEADER)?);
    loop {
        let flags = read(glyph, at)?;
        let has = |bit: u16| flags & bit != 0;
        let scale = usize::from(has(0x8)) * 2 + usize::from(has(0x40)) * 4 + usize::from(has(0x80)) * 8;
        let next = at + 4 + if has(0x1) { 4 } else { 2 } + scale;
        out.extend_from_slice(glyph.get(at..next)?);
        // Bit 8: a program follows the last component.
        put(&mut out[first..], at, flags & !0x100)?;
        if !has(0x20) {
            return Some(());
        }
        at = next;
    }
}

/// The table `cmap` in format 4, for pairs of character and glyph in increasing order of characters.
fn character_map(map: &[(u16, u16)]) -> Option<Vec<u8>> {
    // A segment: first and last character, and the difference from character to glyph.
    let mut segments: Vec<(u16, u16, u16)> = Vec::new();
    for &(character, glyph) in map.iter().filter(|(character, _)| *character != 0xffff) {
        let delta = glyph.wrapping_sub(character);
        match segments.last_mut() {
            Some((_, last, same)) if *last + 1 == character && *same == delta => *last = character,
            _ => segments.push((character, character, delta)),
        }
    }
    segments.push((0xffff, 0xffff, 1));
    let count = u16::try_from(segments.len()).ok()?;
    let length = 16_usize.checked_add(8 * segments.len()).and_then(|length| u16::try_from(length).ok())?;
    let power = 1 << count.ilog2();
    let head = [4, length, 0, 2 * count, 2 * power, count.ilog2() as u16, 2 * (count - power)];
    let mut words = vec![0, 1, 3, 1, 0, 12];
    words.extend(head);
    words.extend(segments.iter().map(|segment| segment.1));
    words.push(0);
    words.extend(segments.iter().map(|segment| segment.0));
    words.extend(segments.iter().map(|segment| segment.2));
    words.resize(words.len() + segments.len(), 0);
    Some(words.into_iter().flat_map(u16::to_be_bytes).collect())
}

/// The sum of a table as a sequence of 32-bit numbers.
fn checksum(bytes: &[u8]) -> u32 {
    bytes.chunks(4).fold(0, |sum: u32, chunk| {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        sum.wrapping_add(u32::from_be_bytes(word))
    })
}

/// The font file with these tables, which are in the order of their tags.
fn assemble(tables: &[(&[u8; 4], Vec<u8>)]) -> Vec<u8> {
    let count = tables.len() as u16;
    let power = 1_u16 << count.ilog2();
    let mut file = vec![0, 1, 0, 0];
    for word in [count, 16 * power, count.ilog2() as u16, 16 * (count - power)] {
        file.extend(word.to_be_bytes());
    }
    let mut start = 12 + 16 * tables.len();
    let mut adjustment = None;
    for (tag, bytes) in tables {
        if *tag == b"head" {
            adjustment = Some(start + 8);
        }
        file.extend_from_slice(*tag);
        for word in [checksum(bytes), start as u32, bytes.len() as u32] {
            file.extend(word.to_be_bytes());
        }
        start += bytes.len().next_multiple_of(4);
    }
    for (_, bytes) in tables {
        file.extend_from_slice(bytes);
        file.resize(file.len().next_multiple_of(4), 0);
    }
    let whole = 0xb1b0_afba_u32.wrapping_sub(checksum(&file));
    if let Some(place) = adjustment.and_then(|at| file.get_mut(at..at + 4)) {
        place.copy_from_slice(&whole.to_be_bytes());
    }
    file
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::font::{Face, face};
    use skrifa::{DrawMemory, Font, GlyphId, PathSink, ScalerFont};

    /// The steps of an outline as text.
    #[derive(Default)]
    struct Steps(String);

    impl PathSink for Steps {
        fn move_to(&mut self, x: f32, y: f32) {
            self.0 += &format!("M{x} {y}");
        }
        fn line_to(&mut self, x: f32, y: f32) {
            self.0 += &format!("L{x} {y}");
        }
        fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
            self.0 += &format!("Q{cx} {cy} {x} {y}");
        }
        fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
            self.0 += &format!("C{ax} {ay} {bx} {by} {x} {y}");
        }
        fn close(&mut self) {
            self.0 += "Z";
        }
    }

    fn outline(font: &Font, glyph: GlyphId) -> String {
        let mut steps = Steps::default();
        let scaler = ScalerFont::unhinted(font.clone(), None);
        if let Some(drawn) = scaler.outline(glyph) {
            drawn.draw(DrawMemory::Scratch, &mut steps).unwrap();
        }
        steps.0
    }

    #[test]
    fn every_character_looks_as_before() {
        for number in [-21, -24, -26, -31, -33, -34] {
            let Some(Face::Outline(face)) = face(number) else { panic!("no outline face {number}") };
            let text = "The five boxing wizards jump & ÄÖÜäöüéñç ½ Ωμ Жук €";
            let glyphs =
                text.chars().filter_map(|c| Some((c, face.glyph_id(c)?))).collect::<BTreeMap<_, _>>();
            let file = subset(face.data, &glyphs).unwrap();
            assert!(file.len() < 16_000, "{} bytes", file.len());
            assert_eq!(checksum(&file), 0xb1b0_afba);
            let cut = Font::new(file, 0).unwrap();
            let whole = Font::new(face.data, 0).unwrap();
            for (&character, &glyph) in &glyphs {
                let new = cut.charmap().map_unicode(character).expect("a glyph");
                let old = GlyphId::new(u32::from(glyph));
                assert_eq!(
                    outline(&cut, new),
                    outline(&whole, old),
                    "{character} of {}",
                    face.postscript_name
                );
                assert_eq!(cut.glyph_metrics().h_advance(new), whole.glyph_metrics().h_advance(old));
            }
            assert_eq!(cut.charmap().map_unicode('@'), None);
        }
    }

    #[test]
    fn what_is_no_font_gives_none() {
        let glyphs = BTreeMap::from([('a', 68)]);
        assert_eq!(subset(b"", &glyphs), None);
        assert_eq!(subset(&[0; 100], &glyphs), None);
        let Some(Face::Outline(face)) = face(-21) else { panic!("no outline face") };
        for length in (0..face.data.len()).step_by(9973) {
            let _ = subset(&face.data[..length], &glyphs);
        }
        assert_eq!(subset(face.data, &BTreeMap::from([('a', 60_000)])), None);
    }
}
