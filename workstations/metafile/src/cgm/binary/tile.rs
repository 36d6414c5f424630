//! The cells of tiles (ISO/IEC 8632-3, TILE and BITONAL TILE).

use super::octets::{Bits, Octets};
use super::parameters::Coding;
use crate::cgm::element::{Cells, Element, Ink, Inks, most_cells, repeat};
use crate::generated::elements::Kind;

/// Ways of compression: nothing but background or foreground, every cell, and runs of cells.
const BACKGROUND: i32 = 0;
const FOREGROUND: i32 = 1;
const BITMAP: i32 = 5;
const RUN_LENGTH: i32 = 6;

impl Coding {
    /// The cells of a tile of the tile array that is open, out of the last parameter of the element; none if the way of
    /// compression is another one, or cells are missing.
    pub(super) fn tile(&self, e: &Element, octets: &[u8]) -> Option<Cells> {
        let (columns, rows) = self.tile_size?;
        let most = most_cells(octets.len());
        let count = columns.checked_mul(rows).filter(|count| (1..=most).contains(count))?;
        let padding = usize::try_from(e.integer(1)?).ok()?.max(1);
        let both = (e.kind == Kind::BitonalTile).then(|| Some([e.ink(2)?, e.ink(3)?]));
        let (precision, both) = match both {
            Some(both) => (1, Some(both?)),
            None => (self.local_precision(e.integer(2)?)?, None),
        };
        let mut inks = self.inks();
        let mut bits = Bits::new(octets);
        let put = |bits: &mut Bits<'_>, length: usize, inks: &mut Inks| match both {
            Some(both) => add(both[bits.next(1)? as usize], length, count, inks),
            None => self.cell(bits, precision, length, count, inks),
        };
        match (e.integer(0)?, both) {
            (BACKGROUND, Some(both)) => add(both[0], count, count, &mut inks)?,
            (FOREGROUND, Some(both)) => add(both[1], count, count, &mut inks)?,
            (BITMAP, _) => {
                if count > octets.len() * 8 {
                    return None;
                }
                for _ in 0..rows {
                    for _ in 0..columns {
                        put(&mut bits, 1, &mut inks)?;
                    }
                    bits.align(padding);
                }
            }
            (RUN_LENGTH, both) => {
                let length = self.run_count_precision(e.bytes(if both.is_some() { 4 } else { 3 })?)?;
                for row in 1..=rows {
                    while inks.len() < row * columns {
                        let run = bits.next(length)? as usize;
                        put(&mut bits, run.min(row * columns - inks.len()), &mut inks)?;
                    }
                    bits.align(padding);
                }
            }
            _ => return None,
        }
        Some(Cells { columns, rows, inks })
    }

    /// The number of bits in which the length of a run is given: the only value of a structured data record, behind its
    /// type and the number of values.
    fn run_count_precision(&self, record: &[u8]) -> Option<u32> {
        let mut octets = Octets::new(record);
        octets.signed(self.precisions.index)?;
        octets.signed(self.precisions.integer)?;
        let bits = octets.signed(self.precisions.integer)?;
        u32::try_from(bits).ok().filter(|bits| (1..=32).contains(bits))
    }
}

/// Appends a colour several times to those of a tile that has `most` of them in all.
fn add(ink: Ink, count: usize, most: usize, inks: &mut Inks) -> Option<()> {
    match (inks, ink) {
        (Inks::Indices(indices), Ink::Index(index)) => {
            repeat(indices, index.min(i32::MAX as u32) as i32, count, most);
        }
        (Inks::Direct(colours), Ink::Direct(colour)) => {
            let [red, green, blue, _] = colour.to_bytes();
            repeat(colours, [red, green, blue], count, most);
        }
        _ => return None,
    }
    Some(())
}
