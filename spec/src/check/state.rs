//! Checks `states.toml`.

use super::{LEVELS, unique};
use crate::tables::{Entry, Tables};

/// The types that an entry may have, alone or after "list of" and "set of".
const TYPES: [&str; 10] =
    ["integer", "real", "point", "vector", "rectangle", "matrix", "name", "string", "record", "table"];

/// Adds what is wrong with the state lists and description tables.
pub(super) fn check(tables: &Tables, faults: &mut Vec<String>) {
    let states: Vec<&str> = tables.states.operating_state.iter().map(|s| s.name.as_str()).collect();
    if states != ["GKCL", "GKOP", "WSOP", "WSAC", "SGOP"] {
        faults.push("the operating states are not the standard's".to_owned());
    }
    for state in &tables.states.operating_state {
        for function in state.entered_by.iter().filter(|name| !is_function(tables, name)) {
            faults.push(format!("{}: entered by the unknown function {function}", state.name));
        }
    }
    unique("table", tables.states.table.iter().map(|t| &t.name), faults);
    for table in &tables.states.table {
        if table.created_by != "the implementation" && !is_function(tables, &table.created_by) {
            faults.push(format!("{}: created by the unknown function {}", table.name, table.created_by));
        }
        unique(&format!("{}: entry", table.name), table.entries.iter().map(|e| &e.name), faults);
        for entry in &table.entries {
            for fault in entry_faults(tables, entry) {
                faults.push(format!("{}: {}: {fault}", table.name, entry.name));
            }
        }
    }
}

fn is_function(tables: &Tables, name: &str) -> bool {
    tables.functions.iter().any(|f| f.name == name)
}

fn entry_faults(tables: &Tables, entry: &Entry) -> Vec<String> {
    let mut faults = Vec::new();
    let enumerations = &tables.enumerations.enumeration;
    match (&entry.kind, &entry.enumeration) {
        (Some(kind), None) => {
            let inner = kind.trim_start_matches("list of ").trim_start_matches("set of ");
            if !TYPES.contains(&inner) {
                faults.push(format!("unknown type {kind}"));
            }
        }
        (None, Some(name)) => match enumerations.iter().find(|e| e.name == *name) {
            Some(enumeration) => {
                let known = |value: &str| enumeration.values.iter().any(|v| v.rust.as_deref() == Some(value));
                if entry.initial.as_deref().is_some_and(|value| value != "description" && !known(value)) {
                    faults.push("the initial value is not one of the enumeration's".to_owned());
                }
            }
            None => faults.push(format!("unknown enumeration {name}")),
        },
        _ => faults.push("it needs a type or an enumeration".to_owned()),
    }
    if entry.space.as_ref().is_some_and(|space| !["WC", "NDC", "DC"].contains(&space.as_str())) {
        faults.push("unknown coordinates".to_owned());
    }
    for name in entry.set_by.iter().filter(|name| !is_function(tables, name)) {
        faults.push(format!("set by the unknown function {name}"));
    }
    let subroutine = |name: &String| tables.functions.iter().any(|f| f.fortran.contains(name));
    for name in entry.inquiry.iter().filter(|name| !subroutine(name)) {
        faults.push(format!("returned by the unknown inquiry {name}"));
    }
    if entry.level.as_ref().is_some_and(|level| !LEVELS.contains(&level.as_str())) {
        faults.push("unknown level".to_owned());
    }
    let categories = enumerations.iter().find(|e| e.name == "workstation category");
    let category =
        |name: &str| categories.is_some_and(|e| e.values.iter().any(|v| v.rust.as_deref() == Some(name)));
    for name in entry.categories.iter().filter(|name| !category(name)) {
        faults.push(format!("unknown workstation category {name}"));
    }
    faults
}
