//! TrueType files as embedded in documents: subsets of their characters, and their tables (OpenType
//! specification, "Organization of an OpenType font").

use super::hint;
use gks_pipeline::device::DeviceError;
use gks_pipeline::font::OutlineFace;
use subsetter::GlyphRemapper;

/// A table of a font file.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Table {
    /// The name of the table.
    pub(crate) tag: [u8; 4],
    /// The content.
    pub(crate) data: Vec<u8>,
}

/// The tables that documents need; others name the font and its characters for other uses.
const NEEDED: [&[u8; 4]; 9] =
    [b"cvt ", b"fpgm", b"glyf", b"head", b"hhea", b"hmtx", b"loca", b"maxp", b"prep"];

/// The tables of a font file with only those characters of a face that `glyphs` numbers anew, as far as
/// documents need them.
pub(crate) fn subset(face: &OutlineFace, glyphs: &GlyphRemapper) -> Result<Vec<Table>, DeviceError> {
    let failed = |why: String| DeviceError::Encode(format!("font {}: {why}", face.postscript_name));
    let file = subsetter::subset(face.data, 0, glyphs).map_err(|error| failed(error.to_string()))?;
    let mut tables = tables(&file).ok_or_else(|| failed("the subset makes no sense".to_owned()))?;
    tables.retain(|table| NEEDED.contains(&&table.tag));
    hint::remove(&mut tables);
    Ok(tables)
}

/// The tables of a font file, or none where it makes no sense.
fn tables(file: &[u8]) -> Option<Vec<Table>> {
    let count = u16_at(file, 4)?;
    (0..usize::from(count))
        .map(|i| {
            let record = file.get(12 + 16 * i..28 + 16 * i)?;
            let word = |at: usize| Some(u32::from_be_bytes(record.get(at..at + 4)?.try_into().ok()?));
            let start = word(8)? as usize;
            let data = file.get(start..start.checked_add(word(12)? as usize)?)?.to_vec();
            Some(Table { tag: record.get(..4)?.try_into().ok()?, data })
        })
        .collect()
}

/// The beginning of a font file: version and directory. The tables follow, each on a multiple of four bytes.
pub(crate) fn directory(tables: &[Table]) -> Vec<u8> {
    let count = tables.len() as u16;
    let power = count.max(1).ilog2();
    let range = 16_u16 << power;
    let mut bytes = vec![0, 1, 0, 0];
    for value in [count, range, power as u16, (count * 16).saturating_sub(range)] {
        bytes.extend(value.to_be_bytes());
    }
    let mut offset = 12 + 16 * tables.len();
    for table in tables {
        bytes.extend(table.tag);
        for value in [checksum(&table.data), offset as u32, table.data.len() as u32] {
            bytes.extend(value.to_be_bytes());
        }
        offset += table.data.len().next_multiple_of(4);
    }
    bytes
}

/// The sum of the words of a table. It takes in what a table holds of the sum of the whole file, which
/// readers of documents do not look at.
fn checksum(data: &[u8]) -> u32 {
    let word = |bytes: &[u8]| bytes.iter().fold(0, |word, &byte| word << 8 | u32::from(byte));
    data.chunks(4).map(|bytes| word(bytes) << (8 * (4 - bytes.len()))).fold(0, u32::wrapping_add)
}

/// A font file made of tables.
pub(crate) fn file(tables: &[Table]) -> Vec<u8> {
    let mut bytes = directory(tables);
    for table in tables {
        bytes.extend(&table.data);
        bytes.resize(bytes.len().next_multiple_of(4), 0);
    }
    bytes
}

/// The smallest rectangle around all characters of a face, in em: left, bottom, right, top.
pub(crate) fn bounds(face: &OutlineFace) -> [f64; 4] {
    let record = (0..usize::from(u16_at(face.data, 4).unwrap_or(0)))
        .filter_map(|i| face.data.get(12 + 16 * i..28 + 16 * i))
        .find(|record| record.starts_with(b"head"));
    let start = record
        .and_then(|record| Some(u32::from_be_bytes(record.get(8..12)?.try_into().ok()?)))
        .unwrap_or(u32::MAX) as usize;
    [36, 38, 40, 42].map(|at| {
        let value = start.checked_add(at).and_then(|at| u16_at(face.data, at)).unwrap_or(0);
        f64::from(value.cast_signed()) / f64::from(face.units_per_em.max(1))
    })
}

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_be_bytes(bytes.get(at..at.checked_add(2)?)?.try_into().ok()?))
}

/// The name of a subset: a tag of six letters that says which characters it has, and the name of the face.
pub(crate) fn name(face: &OutlineFace, glyphs: impl Iterator<Item = u16>) -> String {
    // FNV-1a, which spreads small differences over all bits.
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for byte in glyphs.flat_map(u16::to_be_bytes) {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    let mut name = String::new();
    for _ in 0..6 {
        name.push(char::from(b'A' + (hash % 26) as u8));
        hash /= 26;
    }
    name.push('+');
    name.extend(face.postscript_name.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '-'));
    name
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::font::{Face, face};

    fn sans() -> &'static OutlineFace {
        let Some(Face::Outline(face)) = face(-21) else { panic!("font -21 is an outline face") };
        face
    }

    #[test]
    fn subset_is_a_small_font_file_with_the_tables_needed() {
        let face = sans();
        let mut glyphs = GlyphRemapper::new();
        for character in "Ångström".chars() {
            glyphs.remap(face.glyph_id(character).unwrap());
        }
        let subset = subset(face, &glyphs).unwrap();
        let names: Vec<&[u8; 4]> = subset.iter().map(|table| &table.tag).collect();
        assert_eq!(names, [b"glyf", b"head", b"hhea", b"hmtx", b"loca", b"maxp"]);
        let file = file(&subset);
        assert!(file.len() < 3_000, "{} bytes", file.len());
        assert_eq!(tables(&file).unwrap(), subset);
        assert_eq!(tables(&file[..file.len() - 4]), None);
        assert_eq!(tables(&[]), None);
    }

    #[test]
    fn checksums_count_words() {
        assert_eq!(checksum(&[0, 0, 0, 1, 0xff, 0xff, 0xff, 0xff]), 0);
        assert_eq!(checksum(&[1, 2, 3, 4, 5]), 0x0602_0304);
    }

    #[test]
    fn bounds_surround_the_characters() {
        let [left, bottom, right, top] = bounds(sans());
        assert!(left < 0.0 && bottom < -0.2 && right > 1.0 && top > 0.9, "{left} {bottom} {right} {top}");
    }

    #[test]
    fn names_differ_where_subsets_do() {
        let of = |glyphs: &[u16]| name(sans(), glyphs.iter().copied());
        let (a, b) = (of(&[0, 1, 2]), of(&[0, 1, 3]));
        assert_ne!(a, b);
        assert_eq!(a, of(&[0, 1, 2]));
        let (tag, rest) = a.split_once('+').unwrap();
        assert!(tag.len() == 6 && tag.chars().all(|c| c.is_ascii_uppercase()), "{tag}");
        assert_eq!(rest, "LiberationSans");
    }
}
