//! Inquiries of the GKS description table: what this implementation is.

use super::inquiries;
use crate::{Function, Gks, Level, Result};
use gks_pipeline::generated::numbers;

/// The level of this implementation: the greatest one that has all its functions.
const LEVEL: Level = Level::L2c;

/// How many workstations there may be.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct WorkstationMaximumNumbers {
    /// Open at the same time.
    pub open: u32,
    /// Active at the same time.
    pub active: u32,
    /// Associated with one segment.
    pub of_a_segment: u32,
}

inquiries! {
    /// INQUIRE LEVEL OF GKS. Error: 8.
    inquire_level_of_gks -> Level, InquireLevelOfGks => |_| LEVEL;
    /// INQUIRE LIST OF AVAILABLE WORKSTATION TYPES, in increasing order. Error: 8.
    inquire_list_of_available_workstation_types -> Vec<i32>, InquireListOfAvailableWorkstationTypes
        => |gks| gks.catalogue.types();
    /// INQUIRE WORKSTATION MAXIMUM NUMBERS. Error: 8.
    inquire_workstation_maximum_numbers -> WorkstationMaximumNumbers, InquireWorkstationMaximumNumbers
        => |_| WorkstationMaximumNumbers {
            open: numbers::MAX_OPEN_WORKSTATIONS,
            active: numbers::MAX_ACTIVE_WORKSTATIONS,
            of_a_segment: numbers::MAX_WORKSTATIONS_OF_A_SEGMENT,
        };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{PLAIN, closed, number, open};
    use std::path::Path;

    #[test]
    fn nothing_can_be_inquired_while_gks_is_closed() {
        let gks = closed();
        assert_eq!(number(gks.inquire_level_of_gks()), 8);
        assert_eq!(number(gks.inquire_list_of_available_workstation_types()), 8);
        assert_eq!(number(gks.inquire_workstation_maximum_numbers()), 8);
    }

    #[test]
    fn the_implementation_describes_itself() {
        let (gks, _) = open(&[]);
        let types = gks.inquire_list_of_available_workstation_types().unwrap();
        assert!(types.contains(&PLAIN) && types.is_sorted());
        let most = gks.inquire_workstation_maximum_numbers().unwrap();
        assert_eq!(most, WorkstationMaximumNumbers { open: 32, active: 32, of_a_segment: 32 });
    }

    /// The sources of this crate.
    fn sources(folder: &Path) -> String {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let text = |path: std::path::PathBuf| {
            if path.is_dir() { sources(&path) } else { std::fs::read_to_string(path).unwrap() }
        };
        entries.map(text).collect()
    }

    /// The level claimed has all its functions, and no greater level has.
    #[test]
    fn the_level_is_the_greatest_one_that_is_complete() {
        use Level::{L0a, L0b, L0c, L1a, L1b, L1c, L2a, L2b, L2c};
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let table = std::fs::read_to_string(root.join("../../spec/gks/functions.toml")).unwrap();
        let sources = sources(&root.join("src"));
        let levels = [L0a, L0b, L0c, L1a, L1b, L1c, L2a, L2b, L2c];
        let mut missing = Vec::new();
        let mut found = 0;
        for entry in table.split("[[function]]").skip(1) {
            let value = |key: &str| {
                let line = entry.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "));
                line.map(|value| value.trim_matches('"'))
            };
            let Some(method) = value("rust") else { continue };
            let level = levels.into_iter().find(|level| value("level") == Some(&format!("{level:?}")[1..]));
            let level = level.unwrap_or_else(|| panic!("{method} has no level"));
            // Methods are written out, or named by a line of a macro with their arguments or their type.
            let beginnings = [
                format!("pub fn {method}("),
                format!("pub fn {method}<"),
                format!("\n    {method}("),
                format!("\n    {method} ->"),
                format!("\n    {method},"),
                format!("\n        {method},"),
            ];
            let is_there = beginnings.iter().any(|beginning| sources.contains(beginning));
            assert_eq!(is_there, value("awaits").is_none(), "{method}: the table is wrong about it");
            if is_there {
                found += 1;
            } else {
                missing.push((level, method));
            }
        }
        assert!(found > 100, "{found} methods");
        for level in levels.into_iter().filter(|level| level.includes(LEVEL)) {
            let lacks: Vec<_> = missing.iter().filter(|(of, _)| level.includes(*of)).collect();
            assert_eq!(lacks.is_empty(), level == LEVEL, "{level:?} lacks {lacks:?}");
        }
    }
}
