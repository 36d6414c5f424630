//! Looks for error numbers that are neither provoked by a test nor explained.

use super::unique;
use crate::error_numbers::{Met, met};
use crate::repository;
use crate::tables::{Error, Tables};

/// What is wrong with the error numbers.
pub(super) fn check(tables: &Tables, faults: &mut Vec<String>) {
    unique("error", tables.errors.iter().map(|e| e.number), faults);
    for error in &tables.errors {
        let sentence = error.text.starts_with(char::is_uppercase) && error.text.ends_with('.');
        if !sentence || error.category.is_empty() {
            faults.push(format!(
                "error {}: the text is not a sentence or the category is missing",
                error.number
            ));
        }
        if let Some(fault) = fault(tables, error) {
            faults.push(format!("error {}: {fault}", error.number));
        }
    }
    unique("error category", tables.error_categories.iter().map(|c| &c.name), faults);
    for category in &tables.error_categories {
        if category.never.is_empty() || !tables.errors.iter().any(|e| e.category == category.name) {
            faults.push(format!("error category {}: it has no reason or no error", category.name));
        }
    }
}

/// What is wrong with how a number is met.
fn fault(tables: &Tables, error: &Error) -> Option<&'static str> {
    let ways = met(tables, error);
    match ways.as_slice() {
        [] => Some("it is neither provoked nor explained"),
        [Met::Never("")] => Some("it is never met, without a reason"),
        [Met::Test(path)] => {
            // The number stands in the test by itself, not as a part of another one.
            let text = std::fs::read_to_string(repository().join(path)).unwrap_or_default();
            let number = error.number.to_string();
            let is_there = text.split(|c: char| !c.is_alphanumeric() && c != '-').any(|word| word == number);
            (!is_there).then_some("the test that is said to provoke it does not name it")
        }
        [_] => None,
        _ => Some("it is met in more than one way, or met and never met"),
    }
}
