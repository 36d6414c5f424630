//! What the data records of the INITIALISE functions hold.
//!
//! | class | prompt and echo type | integers | reals | strings |
//! |---|---|---|---|---|
//! | locator | 4 | attribute control flag, and attributes that are not used | | |
//! | | 5 | polyline or fill area, attribute control flag, and the same | | |
//! | stroke | any | editing position | least distance in x, in y (WC), in time | |
//! | choice | 2 | a prompt switch for each alternative | | |
//! | | 3, 4 | | | the name of each alternative |
//! | | 5 | segment name, the pick identifier of each alternative | | |
//! | pick | any | | half a side of the aperture in metres | |
//!
//! An empty record leaves everything to the driver where the table does not need it, and what a record holds
//! beyond the table is kept for inquiries and means nothing.

use crate::DataRecord;
use gks_geometry::{Map, Vector, Wc};
use gks_pipeline::generated::numbers;
use gks_pipeline::input::Detail;

/// The greatest number of alternatives of a choice.
const MOST: usize = numbers::MAX_CHOICE_ALTERNATIVES as usize;

/// Whether the flags that begin the integers of a locator's record are such.
pub(super) fn locator(prompt: i32, record: &DataRecord) -> Option<Detail> {
    let flags = match prompt {
        4 => 1,
        5 => 2,
        _ => 0,
    };
    record.integers.iter().take(flags).all(|flag| matches!(flag, 0 | 1)).then_some(Detail::Locator)
}

/// The buffer and the intervals of a stroke, which `map` takes to metres; those of a record without reals are
/// those of the `usual` one. A buffer may not be larger than the greatest one there is.
pub(super) fn stroke<S: gks_geometry::Space>(
    buffer: i32,
    map: &Map<Wc, S>,
    usual: &Detail,
    record: &DataRecord,
) -> Option<Detail> {
    let buffer = usize::try_from(buffer).ok().filter(|&size| size > 0)?;
    let mut reals = record.reals.iter().copied();
    let interval = match (reals.next(), reals.next()) {
        (None, _) => match usual {
            Detail::Stroke { interval, .. } => *interval,
            _ => (0.0, 0.0),
        },
        (Some(x), y) => {
            let y = y.unwrap_or(x);
            let usable = |interval: f64| interval >= 0.0 && interval.is_finite();
            if !usable(x) || !usable(y) {
                return None;
            }
            (map.vector(Vector::new(x, 0.0)).length(), map.vector(Vector::new(0.0, y)).length())
        }
    };
    Some(Detail::Stroke { buffer: buffer.min(numbers::MAX_STROKE_POINTS as usize), interval })
}

/// The limits of a valuator.
pub(super) fn valuator(low: f64, high: f64) -> Option<Detail> {
    (low < high && low.is_finite() && high.is_finite()).then_some(Detail::Valuator { low, high })
}

/// The alternatives of a choice.
pub(super) fn choice(prompt: i32, record: &DataRecord) -> Option<Detail> {
    let (mut enabled, mut names) = (Vec::new(), Vec::new());
    let count = match prompt {
        2 => {
            enabled.extend(record.integers.iter().take(MOST + 1).map(|&switch| switch != 0));
            enabled.len()
        }
        3 | 4 => {
            names.extend(record.strings.iter().take(MOST + 1).cloned());
            names.len()
        }
        5 => record.integers.len().saturating_sub(1),
        _ => MOST,
    };
    let alternatives = (1..=MOST).contains(&count).then_some(count as i32)?;
    Some(Detail::Choice { alternatives, enabled, names })
}

/// The aperture of a pick: that of the record, else the `usual` one.
pub(super) fn pick(usual: &Detail, record: &DataRecord) -> Option<Detail> {
    match record.reals.first() {
        None => Some(usual.clone()),
        Some(&aperture) => (aperture > 0.0 && aperture.is_finite()).then_some(Detail::Pick { aperture }),
    }
}

/// The buffer of a string device and the position of its cursor. A buffer may not be larger than the greatest
/// one there is.
pub(super) fn string(buffer: i32, cursor: usize) -> Option<Detail> {
    let buffer = usize::try_from(buffer).ok().filter(|&size| size > 0)?;
    Some(Detail::String { buffer: buffer.min(numbers::MAX_STRING_CHARACTERS as usize), cursor })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integers(integers: &[i32]) -> DataRecord {
        DataRecord::new(integers, &[], &[])
    }

    #[test]
    fn prompts_with_names_need_names() {
        let names = DataRecord::new(&[], &[], &["red", "green"]);
        let Some(Detail::Choice { alternatives: 2, names: said, .. }) = choice(3, &names) else { panic!() };
        assert_eq!(said, ["red", "green"]);
        assert_eq!(choice(3, &DataRecord::default()), None);
        assert_eq!(choice(4, &integers(&[1])), None);
        let many = DataRecord { strings: vec![String::new(); MOST + 1], ..DataRecord::default() };
        assert_eq!(choice(3, &many), None);
    }

    #[test]
    fn switches_and_pick_identifiers_count_alternatives() {
        let Some(Detail::Choice { alternatives: 3, enabled, .. }) = choice(2, &integers(&[1, 0, 1])) else {
            panic!()
        };
        assert_eq!(enabled, [true, false, true]);
        assert!(matches!(choice(5, &integers(&[7, 1, 2])), Some(Detail::Choice { alternatives: 2, .. })));
        assert_eq!(choice(5, &integers(&[7])), None);
        let most = Detail::Choice { alternatives: MOST as i32, enabled: vec![], names: vec![] };
        assert_eq!(choice(1, &DataRecord::default()), Some(most));
    }

    #[test]
    fn intervals_are_mapped_and_buffers_cut() {
        let map: Map<Wc, gks_geometry::Dc> = Map::from_rows([[0.5, 0.0, 9.0], [0.0, 2.0, 9.0]]);
        let usual = Detail::Stroke { buffer: 1, interval: (3.0, 4.0) };
        let with = |reals: &[f64]| stroke(1_000_000, &map, &usual, &DataRecord::new(&[], reals, &[]));
        let detail = |interval| Detail::Stroke { buffer: numbers::MAX_STROKE_POINTS as usize, interval };
        assert_eq!(with(&[]), Some(detail((3.0, 4.0))));
        assert_eq!(with(&[1.0, 1.0, 5.0]), Some(detail((0.5, 2.0))));
        assert_eq!(with(&[1.0, -1.0]), None);
        assert_eq!(with(&[f64::NAN]), None);
        assert_eq!(stroke(0, &map, &usual, &DataRecord::default()), None);
    }
}
