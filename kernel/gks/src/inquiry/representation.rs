//! Inquiries of the workstation state list: the bundle, pattern and colour tables.

use crate::{Error, Function, Gks, Result};
use gks_pipeline::colour::Colour;
use gks_pipeline::item::Cells;
use gks_pipeline::look::{FillBundle, LineBundle, MarkerBundle, TextBundle};
use gks_pipeline::tables::Tables;
use gks_pipeline::workstation::Workstation;
use std::collections::BTreeMap;

/// Which value an inquiry returns.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum ValueType {
    /// The value as the application set it.
    Set = 0,
    /// The value that the workstation uses in its place.
    Realized = 1,
}

impl ValueType {
    /// The value with the number that the language bindings use, or none for another number.
    pub const fn from_number(number: i32) -> Option<Self> {
        match number {
            0 => Some(ValueType::Set),
            1 => Some(ValueType::Realized),
            _ => None,
        }
    }
}

/// The entry of a table for an index, or error `invalid` for an index below 1 and error `missing` for one
/// without an entry.
fn entry<B>(
    function: Function,
    table: &BTreeMap<u32, B>,
    index: i32,
    [invalid, missing]: [i32; 2],
) -> Result<&B> {
    if index < 1 {
        return Err(Error::new(invalid, function));
    }
    table.get(&index.unsigned_abs()).ok_or_else(|| Error::new(missing, function))
}

macro_rules! lists {
    ($($(#[$doc:meta])* $name:ident, $function:ident => $table:ident;)+) => {
        impl Gks { $(
            $(#[$doc])*
            pub fn $name(&self, id: i32) -> Result<impl ExactSizeIterator<Item = i32> + Clone> {
                let tables = self.inquired_tables(Function::$function, id)?;
                Ok(tables.$table.keys().map(|&index| index as i32))
            }
        )+ }
    };
}

lists! {
    /// INQUIRE LIST OF POLYLINE INDICES that have a representation, in increasing order.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    inquire_list_of_polyline_indices, InquireListOfPolylineIndices => lines;
    /// INQUIRE LIST OF POLYMARKER INDICES that have a representation, in increasing order.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    inquire_list_of_polymarker_indices, InquireListOfPolymarkerIndices => markers;
    /// INQUIRE LIST OF TEXT INDICES that have a representation, in increasing order.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    inquire_list_of_text_indices, InquireListOfTextIndices => texts;
    /// INQUIRE LIST OF FILL AREA INDICES that have a representation, in increasing order.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    inquire_list_of_fill_area_indices, InquireListOfFillAreaIndices => fills;
    /// INQUIRE LIST OF PATTERN INDICES that have a representation, in increasing order.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    inquire_list_of_pattern_indices, InquireListOfPatternIndices => patterns;
}

macro_rules! representations {
    ($($(#[$doc:meta])* $name:ident -> $bundle:ty, $function:ident
        => $table:ident, $realized:ident, $errors:expr;)+) => {
        impl Gks { $(
            $(#[$doc])*
            pub fn $name(&self, id: i32, index: i32, value: ValueType) -> Result<$bundle> {
                const F: Function = Function::$function;
                let workstation = &self.inquired(F, id)?.workstation;
                let table = &workstation.tables().$table;
                let set = entry(F, table, index, $errors);
                match value {
                    ValueType::Set => set.copied(),
                    // An index without a representation is drawn as index 1.
                    ValueType::Realized => {
                        let drawn = set.or_else(|e| table.get(&1).filter(|_| index > 1).ok_or(e))?;
                        Ok(workstation.$realized(*drawn))
                    }
                }
            }
        )+ }
    };
}

representations! {
    /// INQUIRE POLYLINE REPRESENTATION.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS), 60 (index below 1), 61 (no representation;
    /// only for the value as it was set: an index without one is drawn as index 1).
    inquire_polyline_representation -> LineBundle, InquirePolylineRepresentation
        => lines, realized_line, [60, 61];
    /// INQUIRE POLYMARKER REPRESENTATION.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS), 66 (index below 1), 67 (no representation;
    /// only for the value as it was set: an index without one is drawn as index 1).
    inquire_polymarker_representation -> MarkerBundle, InquirePolymarkerRepresentation
        => markers, realized_marker, [66, 67];
    /// INQUIRE TEXT REPRESENTATION.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS), 72 (index below 1), 73 (no representation;
    /// only for the value as it was set: an index without one is drawn as index 1).
    inquire_text_representation -> TextBundle, InquireTextRepresentation => texts, realized_text, [72, 73];
    /// INQUIRE FILL AREA REPRESENTATION.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS), 80 (index below 1), 81 (no representation;
    /// only for the value as it was set: an index without one is drawn as index 1).
    inquire_fill_area_representation -> FillBundle, InquireFillAreaRepresentation
        => fills, realized_fill, [80, 81];
}

impl Gks {
    fn inquired_tables(&self, function: Function, id: i32) -> Result<&Tables> {
        Ok(self.inquired(function, id)?.workstation.tables())
    }

    /// INQUIRE PATTERN REPRESENTATION: the cells of a pattern, the upper row first. Every pattern is realized
    /// as it was set.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS), 85 (index below 1), 88 (no representation).
    pub fn inquire_pattern_representation(
        &self,
        id: i32,
        index: i32,
        _value: ValueType,
    ) -> Result<Cells<'_>> {
        const F: Function = Function::InquirePatternRepresentation;
        let pattern = entry(F, &self.inquired_tables(F, id)?.patterns, index, [85, 88])?;
        Cells::new(&pattern.indices, pattern.columns, pattern.rows, pattern.columns)
            .ok_or_else(|| Error::new(88, F))
    }

    /// INQUIRE LIST OF COLOUR INDICES that have a representation, in increasing order.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS).
    pub fn inquire_list_of_colour_indices(&self, id: i32) -> Result<impl Iterator<Item = i32> + Clone> {
        let tables = self.inquired_tables(Function::InquireListOfColourIndices, id)?;
        Ok(tables.colours.iter().map(|(index, _)| index as i32))
    }

    /// INQUIRE COLOUR REPRESENTATION.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT), 36 (WISS), 93 (negative index), 94 (no representation).
    pub fn inquire_colour_representation(&self, id: i32, index: i32, value: ValueType) -> Result<Colour> {
        const F: Function = Function::InquireColourRepresentation;
        let workstation: &Workstation = &self.inquired(F, id)?.workstation;
        let index = u32::try_from(index).map_err(|_| Error::new(93, F))?;
        let set = workstation.tables().colours.get(index).ok_or_else(|| Error::new(94, F))?;
        Ok(match value {
            ValueType::Set => set,
            ValueType::Realized => workstation.realized_colour(set),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{CATEGORIES, INDEXED, PLAIN, closed, number, open};
    use ValueType::{Realized, Set};
    use gks_pipeline::description::Category;
    use gks_pipeline::generated::numbers;
    use gks_pipeline::look::{InteriorStyle, Precision};

    fn errors(gks: &Gks, id: i32, index: i32) -> [i32; 12] {
        [
            gks.inquire_list_of_polyline_indices(id).map(drop),
            gks.inquire_list_of_polymarker_indices(id).map(drop),
            gks.inquire_list_of_text_indices(id).map(drop),
            gks.inquire_list_of_fill_area_indices(id).map(drop),
            gks.inquire_list_of_pattern_indices(id).map(drop),
            gks.inquire_list_of_colour_indices(id).map(drop),
            gks.inquire_polyline_representation(id, index, Set).map(drop),
            gks.inquire_polymarker_representation(id, index, Set).map(drop),
            gks.inquire_text_representation(id, index, Set).map(drop),
            gks.inquire_fill_area_representation(id, index, Set).map(drop),
            gks.inquire_pattern_representation(id, index, Set).map(drop),
            gks.inquire_colour_representation(id, index, Set).map(drop),
        ]
        .map(|result| result.map_or_else(|error| error.number, |()| 0))
    }

    #[test]
    fn states_identifiers_categories_and_indices_are_checked_in_this_order() {
        assert_eq!(errors(&closed(), -1, -1), [7; 12]);
        assert_eq!(errors(&open(&[]).0, -1, -1), [7; 12]);
        use Category::{Input, MetafileInput, MetafileOutput, Wiss};
        let kinds = [MetafileInput, Input, Wiss, MetafileOutput].map(|c| CATEGORIES + c as i32);
        let (gks, _) = open(&kinds);
        for (id, error) in [(0, 20), (9, 25), (1, 33), (2, 35), (3, 36)] {
            assert_eq!(errors(&gks, id, -1), [error; 12]);
        }
        assert_eq!(errors(&gks, 4, -1), [0, 0, 0, 0, 0, 0, 60, 66, 72, 80, 85, 93]);
        assert_eq!(errors(&gks, 4, 0), [0, 0, 0, 0, 0, 0, 60, 66, 72, 80, 85, 0]);
        assert_eq!(errors(&gks, 4, 1000), [0, 0, 0, 0, 0, 0, 61, 67, 73, 81, 88, 94]);
        assert_eq!(errors(&gks, 4, 1), [0; 12]);
    }

    #[test]
    fn tables_start_predefined_and_list_what_is_set() {
        let (mut gks, _) = open(&[PLAIN, PLAIN]);
        let colours: Vec<i32> = gks.inquire_list_of_colour_indices(1).unwrap().collect();
        assert!(colours.iter().copied().eq(0..numbers::COLOURS.len() as i32));
        let lines = gks.inquire_list_of_polyline_indices(1).unwrap();
        assert_eq!((lines.len(), lines.collect::<Vec<_>>()), (5, vec![1, 2, 3, 4, 5]));
        gks.set_polyline_representation(1, 30, 1, 1.0, 1).unwrap();
        gks.set_polymarker_representation(1, 31, 1, 1.0, 1).unwrap();
        gks.set_text_representation(1, 32, 1, Precision::Stroke, 1.0, 0.0, 1).unwrap();
        gks.set_fill_area_representation(1, 33, InteriorStyle::Solid, 1, 1).unwrap();
        gks.set_pattern_representation(1, 34, &Cells::new(&[0], 1, 1, 1).unwrap()).unwrap();
        gks.set_colour_representation(1, 50_000, (0.0, 0.0, 0.0)).unwrap();
        let last = |gks: &Gks, id| {
            [
                gks.inquire_list_of_polyline_indices(id).unwrap().last(),
                gks.inquire_list_of_polymarker_indices(id).unwrap().last(),
                gks.inquire_list_of_text_indices(id).unwrap().last(),
                gks.inquire_list_of_fill_area_indices(id).unwrap().last(),
                gks.inquire_list_of_pattern_indices(id).unwrap().last(),
                gks.inquire_list_of_colour_indices(id).unwrap().last(),
            ]
            .map(Option::unwrap)
        };
        assert_eq!(last(&gks, 1), [30, 31, 32, 33, 34, 50_000]);
        assert_eq!(last(&gks, 2), [5, 5, 6, 5, 10, numbers::COLOURS.len() as i32 - 1]);
    }

    #[test]
    fn representations_are_returned_as_they_were_set() {
        let (mut gks, _) = open(&[INDEXED]);
        gks.set_polyline_representation(1, 2, -3, 1e6, 200).unwrap();
        gks.set_polymarker_representation(1, 3, -5, 0.0, 7).unwrap();
        gks.set_text_representation(1, 4, -21, Precision::Char, 2.0, -0.5, 255).unwrap();
        gks.set_fill_area_representation(1, 5, InteriorStyle::Pattern, 99, 9).unwrap();
        gks.set_pattern_representation(1, 6, &Cells::new(&[1, 2, 3, 4, 5, 6], 2, 3, 2).unwrap()).unwrap();
        gks.set_colour_representation(1, 7, (0.1, 0.2, 0.3)).unwrap();
        let line = LineBundle { linetype: -3, width: 1e6, colour: 200 };
        assert_eq!(gks.inquire_polyline_representation(1, 2, Set), Ok(line));
        let marker = MarkerBundle { kind: -5, size: 0.0, colour: 7 };
        assert_eq!(gks.inquire_polymarker_representation(1, 3, Set), Ok(marker));
        let text =
            TextBundle { font: -21, precision: Precision::Char, expansion: 2.0, spacing: -0.5, colour: 255 };
        assert_eq!(gks.inquire_text_representation(1, 4, Set), Ok(text));
        let fill = FillBundle { interior: InteriorStyle::Pattern, style: 99, colour: 9 };
        assert_eq!(gks.inquire_fill_area_representation(1, 5, Set), Ok(fill));
        for value in [Set, Realized] {
            let cells = gks.inquire_pattern_representation(1, 6, value).unwrap();
            assert_eq!(
                (cells.columns, cells.rows, cells.row(0), cells.row(2)),
                (2, 3, &[1, 2][..], &[5, 6][..])
            );
        }
        let colour = Colour::rgb(0.1, 0.2, 0.3);
        assert_eq!(gks.inquire_colour_representation(1, 7, Set), Ok(colour));
        // Index 99 has no pattern and no 256 colours are predefined.
        let realized = gks.inquire_polyline_representation(1, 2, Realized).unwrap();
        assert_eq!(realized.width, 200.0);
        let realized = gks.inquire_fill_area_representation(1, 5, Realized).unwrap();
        assert_eq!(realized.style, 1);
        let realized = gks.inquire_colour_representation(1, 7, Realized).unwrap();
        assert_eq!(realized.to_bytes(), colour.to_bytes());
        assert_ne!(realized, colour);
    }

    #[test]
    fn value_types_have_the_numbers_of_the_bindings() {
        assert_eq!([0, 1, 2].map(ValueType::from_number), [Some(Set), Some(Realized), None]);
    }

    #[test]
    fn an_index_without_a_representation_is_realized_as_index_1() {
        let (mut gks, _) = open(&[PLAIN]);
        gks.set_polyline_representation(1, 1, 3, 2.0, 4).unwrap();
        let first = gks.inquire_polyline_representation(1, 1, Realized);
        assert_eq!(gks.inquire_polyline_representation(1, 30, Realized), first);
        assert_eq!(number(gks.inquire_polyline_representation(1, 30, Set)), 61);
        assert_eq!(number(gks.inquire_polyline_representation(1, 0, Realized)), 60);
        let first = gks.inquire_fill_area_representation(1, 1, Realized);
        assert_eq!(gks.inquire_fill_area_representation(1, 30, Realized), first);
    }
}
