//! Glyphs of TrueType files without their instructions (OpenType specification, "glyf" and "loca").
//!
//! Instructions fit characters to coarse pixels. They are two thirds of what embedded characters take, readers of
//! documents hardly use them today, and those that do space characters unevenly.

use super::sfnt::Table;

/// What the flags of a component of a composite glyph say.
mod component {
    /// Its position takes two words instead of two bytes.
    pub(super) const WORDS: u16 = 0x1;
    /// A scale follows.
    pub(super) const SCALE: u16 = 0x8;
    /// It is not the last one.
    pub(super) const MORE: u16 = 0x20;
    /// Two scales follow.
    pub(super) const TWO_SCALES: u16 = 0x40;
    /// A matrix follows.
    pub(super) const MATRIX: u16 = 0x80;
    /// Instructions follow the last component.
    pub(super) const INSTRUCTIONS: u16 = 0x100;
}

/// Takes the instructions out of the glyphs, and the tables that belong to them; leaves tables that make no sense as
/// they are.
pub(crate) fn remove(tables: &mut Vec<Table>) {
    let find = |tag: &[u8; 4]| tables.iter().position(|table| table.tag == *tag);
    let (Some(head), Some(glyf), Some(loca)) = (find(b"head"), find(b"glyf"), find(b"loca")) else { return };
    let long = tables[head].data.get(51) == Some(&1);
    if let Some((glyphs, offsets)) = rewritten(&tables[glyf].data, &tables[loca].data, long) {
        tables[glyf].data = glyphs;
        tables[loca].data = offsets;
        tables.retain(|table| ![b"cvt ", b"fpgm", b"prep"].contains(&&table.tag));
    }
}

/// The two tables without instructions.
fn rewritten(glyf: &[u8], loca: &[u8], long: bool) -> Option<(Vec<u8>, Vec<u8>)> {
    let offsets: Vec<usize> = if long {
        loca.chunks_exact(4).map(|o| u32::from_be_bytes([o[0], o[1], o[2], o[3]]) as usize).collect()
    } else {
        loca.chunks_exact(2).map(|o| usize::from(u16::from_be_bytes([o[0], o[1]])) * 2).collect()
    };
    let (mut glyphs, mut ends) = (Vec::with_capacity(glyf.len()), Vec::with_capacity(loca.len()));
    let mut end = |glyphs: &Vec<u8>| {
        if long {
            ends.extend((glyphs.len() as u32).to_be_bytes());
        } else {
            // Not longer than before, so that it still fits.
            ends.extend(((glyphs.len() / 2) as u16).to_be_bytes());
        }
    };
    end(&glyphs);
    for limits in offsets.windows(2) {
        let glyph = glyf.get(limits[0]..limits[1])?;
        if !glyph.is_empty() {
            bare(glyph, &mut glyphs)?;
            glyphs.resize(glyphs.len().next_multiple_of(2), 0);
        }
        end(&glyphs);
    }
    Some((glyphs, ends))
}

/// Appends a glyph without its instructions.
fn bare(glyph: &[u8], out: &mut Vec<u8>) -> Option<()> {
    let word = |at: usize| Some(u16::from_be_bytes(glyph.get(at..at + 2)?.try_into().ok()?));
    let contours = word(0)?.cast_signed();
    if let Ok(contours) = usize::try_from(contours) {
        let at = 10 + 2 * contours;
        let length = usize::from(word(at)?);
        out.extend_from_slice(glyph.get(..at)?);
        out.extend([0, 0]);
        out.extend_from_slice(glyph.get(at + 2 + length..)?);
        return Some(());
    }
    out.extend_from_slice(glyph.get(..10)?);
    let mut at = 10;
    loop {
        let flags = word(at)?;
        let position = if flags & component::WORDS != 0 { 4 } else { 2 };
        let scales = match flags {
            _ if flags & component::SCALE != 0 => 2,
            _ if flags & component::TWO_SCALES != 0 => 4,
            _ if flags & component::MATRIX != 0 => 8,
            _ => 0,
        };
        let next = at + 4 + position + scales;
        out.extend((flags & !component::INSTRUCTIONS).to_be_bytes());
        out.extend_from_slice(glyph.get(at + 2..next)?);
        at = next;
        if flags & component::MORE == 0 {
            return Some(());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simple_glyphs_keep_all_but_instructions() {
        let head = [0, 1, 0, 0, 0, 0, 0, 9, 0, 9, 0, 2];
        let outline = [0x01, 0x01, 0x01, 1, 2, 3, 4, 5, 6];
        let glyph = [&head[..], &[0, 3, 0xb0, 0x01, 0x2f], &outline].concat();
        let mut out = Vec::new();
        bare(&glyph, &mut out).unwrap();
        assert_eq!(out, [&head[..], &[0, 0], &outline].concat());
        assert_eq!(bare(&glyph[..14], &mut Vec::new()), None);
    }

    #[test]
    fn composite_glyphs_lose_flag_and_tail() {
        let head = [0xff, 0xff, 0, 0, 0, 0, 0, 9, 0, 9];
        let first = [0x01, 0x21, 0, 5, 0, 1, 0, 2];
        let second = [0x01, 0x48, 0, 6, 7, 8, 0x40, 0];
        let glyph = [&head[..], &first, &second, &[0, 2, 0xb0, 1]].concat();
        let mut out = Vec::new();
        bare(&glyph, &mut out).unwrap();
        let (mut first, mut second) = (first, second);
        (first[0], second[0]) = (0, 0);
        assert_eq!(out, [&head[..], &first, &second].concat());
        assert_eq!(bare(&glyph[..20], &mut Vec::new()), None);
    }

    #[test]
    fn offsets_follow_the_glyphs() {
        let glyph = |instructions: &[u8]| {
            let length = (instructions.len() as u16).to_be_bytes();
            [&[0_u8; 10][..], &length, instructions].concat()
        };
        let (a, b) = (glyph(&[1, 2, 3, 4]), glyph(&[]));
        let glyf = [&a[..], &b].concat();
        let ends = [0, 0, 8, 14].map(u16::to_be_bytes).concat();
        let (glyphs, offsets) = rewritten(&glyf, &ends, false).unwrap();
        assert_eq!(glyphs, [0; 24]);
        assert_eq!(offsets, [0, 0, 6, 12].map(u16::to_be_bytes).concat());
        let ends = [0, 0, 16, 28].map(u32::to_be_bytes).concat();
        let (_, offsets) = rewritten(&glyf, &ends, true).unwrap();
        assert_eq!(offsets, [0, 0, 12, 24].map(u32::to_be_bytes).concat());
        assert_eq!(rewritten(&glyf[..20], &ends, true), None);
        assert_eq!(rewritten(&glyf, &[28, 0, 0, 0, 0, 0, 0, 0], true), None);
    }
}
