//! The colour look-up table of an indexed frame buffer.

use gks_pipeline::colour::{Colour, Paint};
use std::collections::HashMap;

/// The colours that the pixels show.
#[derive(Default)]
pub(super) struct LookUpTable {
    /// The colour of each index that has one.
    entries: Vec<Option<Colour>>,
    /// What stands in for colours of other indices.
    nearest: HashMap<[u8; 4], u8>,
}

impl LookUpTable {
    /// Gives an index a colour.
    pub(super) fn set(&mut self, index: u8, colour: Colour) {
        self.entries.resize(256, None);
        self.entries[usize::from(index)] = Some(colour);
        self.nearest.clear();
    }

    /// The colour that an index shows, black unless it has been given one.
    pub(super) fn colour(&self, index: u8) -> Colour {
        self.entries.get(usize::from(index)).copied().flatten().unwrap_or(Colour::BLACK)
    }

    /// The index that a pixel of a paint stores: that of the paint, or that of the entry whose colour is nearest
    /// if the frame buffer cannot hold it.
    pub(super) fn index(&mut self, paint: &Paint) -> u8 {
        if let Ok(index) = u8::try_from(paint.index) {
            if !matches!(self.entries.get(usize::from(index)), Some(Some(_))) {
                self.set(index, paint.colour);
            }
            return index;
        }
        let bytes = paint.colour.to_bytes();
        *self.nearest.entry(bytes).or_insert_with(|| {
            let distance = |colour: &Colour| -> u32 {
                colour.to_bytes().iter().zip(bytes).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
            };
            let known = (0..=255u8).zip(&self.entries).filter_map(|(i, entry)| Some((i, entry.as_ref()?)));
            known.min_by_key(|(_, colour)| distance(colour)).map_or(0, |(index, _)| index)
        })
    }

    /// The entries up to the last one that has a colour, as bytes.
    pub(super) fn to_bytes(&self) -> Vec<[u8; 4]> {
        let count = self.entries.iter().rposition(Option::is_some).map_or(1, |last| last + 1);
        (0..count).map(|index| self.colour(index as u8).to_bytes()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_beyond_the_table_takes_the_nearest_colour() {
        let mut table = LookUpTable::default();
        let far = Paint { colour: Colour::rgb(0.2, 0.9, 0.1), index: 1000 };
        assert_eq!(table.index(&far), 0, "no entry at all");
        table.set(2, Colour::rgb(1.0, 0.0, 0.0));
        table.set(3, Colour::rgb(0.0, 1.0, 0.0));
        assert_eq!(table.index(&far), 3);
        table.set(9, far.colour);
        assert_eq!(table.index(&far), 9);
    }

    #[test]
    fn an_index_without_colour_gets_that_of_its_first_paint() {
        let mut table = LookUpTable::default();
        table.set(2, Colour::WHITE);
        for (index, blue) in [(77, 0.5), (2, 0.5), (77, 0.25)] {
            let paint = Paint { colour: Colour::rgb(0.0, 0.0, blue), index };
            assert_eq!(u32::from(table.index(&paint)), index);
        }
        assert_eq!((table.colour(2), table.colour(77)), (Colour::WHITE, Colour::rgb(0.0, 0.0, 0.5)));
        assert_eq!(table.to_bytes().len(), 78);
        assert_eq!(table.to_bytes()[77], [0, 0, 128, 255]);
    }
}
