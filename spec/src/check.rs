//! Looks for contradictions in the tables: dangling references, duplicates, gaps.

mod ctype;
mod element;
mod error;
mod number;
mod state;

use std::collections::{BTreeMap, BTreeSet};

use crate::fortran_include::identifier;
use crate::function::{state_bit, variant};
use crate::samples::{has_subject, subject};
use crate::tables::{Enumeration, Function, OneOrMore, Parameter, Tables, Value};

/// The levels of GKS.
const LEVELS: [&str; 9] = ["0a", "0b", "0c", "1a", "1b", "1c", "2a", "2b", "2c"];

/// The operating states in which a function that reports each state error may be called; bits as in `state_bit`.
const STATE_ERRORS: [(i32, u8); 8] = [
    (1, 0b00001),
    (2, 0b00010),
    (3, 0b01000),
    (4, 0b10000),
    (5, 0b11000),
    (6, 0b01100),
    (7, 0b11100),
    (8, 0b11110),
];

/// What is wrong with the tables, one sentence each; nothing if they are sound.
pub(crate) fn check(tables: &Tables) -> Vec<String> {
    let mut faults = Vec::new();
    names(tables, &mut faults);
    for function in &tables.functions {
        for fault in function_faults(tables, function) {
            faults.push(format!("{}: {fault}", function.name));
        }
    }
    error::check(tables, &mut faults);
    enumerations(tables, &mut faults);
    state::check(tables, &mut faults);
    ctype::check(tables, &mut faults);
    number::check(tables, &mut faults);
    element::check(tables, &mut faults);
    faults
}

/// Reports every item that occurs twice.
fn unique<T: Ord + std::fmt::Display>(
    what: &str,
    items: impl IntoIterator<Item = T>,
    faults: &mut Vec<String>,
) {
    let mut seen = BTreeSet::new();
    for item in items {
        if let Some(twice) = seen.replace(item) {
            faults.push(format!("{what} {twice} occurs twice"));
        }
    }
}

/// Names that must differ between functions, and identifiers that must follow one another.
fn names(tables: &Tables, faults: &mut Vec<String>) {
    let functions = &tables.functions;
    unique("function", functions.iter().map(|f| &f.name), faults);
    unique("variant", functions.iter().map(|f| variant(&f.name)), faults);
    unique("Rust method", functions.iter().filter_map(|f| f.rust.as_ref()), faults);
    unique("C function", functions.iter().filter_map(|f| f.c.as_ref()), faults);
    unique("Fortran subroutine", functions.iter().flat_map(|f| &f.fortran), faults);
    let mut ids: Vec<i32> = functions.iter().filter_map(|f| f.id).collect();
    unique("function identifier", ids.iter().copied(), faults);
    ids.sort_unstable();
    ids.dedup();
    if ids.iter().zip(0..).any(|(&id, place)| id != place) {
        faults.push("the function identifiers leave gaps".to_owned());
    }
    let subroutines: BTreeSet<&String> = functions.iter().flat_map(|f| &f.fortran).collect();
    for function in functions {
        for name in function.fortran_split.iter().filter(|name| !subroutines.contains(name)) {
            faults.push(format!("{}: no function has the Fortran subroutine {name}", function.name));
        }
    }
}

fn function_faults(tables: &Tables, function: &Function) -> Vec<String> {
    let mut faults = Vec::new();
    let mut want = |fine: bool, fault: &str| {
        if !fine {
            faults.push(fault.to_owned());
        }
    };
    want(
        !function.name.is_empty() && function.name == function.name.to_uppercase(),
        "the name is not in capitals",
    );
    want(!function.category.is_empty(), "it has no category");
    want(LEVELS.contains(&function.level.as_str()), "its level is not one of GKS");
    want(function.rust.is_some() == function.sample.is_some(), "a Rust method and a sample belong together");
    want(
        function.c.is_some() == function.prototype.is_some(),
        "a C function and a prototype belong together",
    );
    want(
        function.c.is_some() == function.confirmed.is_some(),
        "it does not say whether the prototype is confirmed",
    );
    let somewhere = function.rust.is_some() || function.c.is_some() || !function.fortran.is_empty();
    want(somewhere, "neither the kernel nor a binding has it");
    if function.awaits.is_some() {
        want(function.rust.is_some(), "it awaits something and has no Rust method");
        want(function.level != "0a", "level 0a awaits something");
        want(function.unreachable.is_empty(), "it awaits something and calls errors unreachable");
    }
    if let Some(rust) = &function.rust {
        want(*rust == function.name.to_lowercase().replace(' ', "_"), "the Rust name is not the standard's");
    }
    want(function.fortran.iter().all(|name| name.len() <= 6), "a Fortran name is longer than 6 characters");
    let own: BTreeSet<&String> = function.fortran.iter().collect();
    want(own == function.parameters.keys().collect(), "its subroutines and parameter lists differ");
    if function.id.is_some() {
        let named = function.fortran.first().is_some_and(|name| identifier(name).is_some());
        want(named, "it has an identifier and no Fortran name");
    }
    faults.extend(state_faults(function));
    faults.extend(error_faults(tables, function));
    faults.extend(sample_faults(tables, function));
    for (subroutine, parameters) in &function.parameters {
        for fault in parameter_faults(tables, parameters) {
            faults.push(format!("{subroutine}: {fault}"));
        }
    }
    faults
}

fn state_faults(function: &Function) -> Vec<String> {
    let mut faults: Vec<String> = function
        .states
        .iter()
        .filter(|s| state_bit(s) == 0)
        .map(|s| format!("{s} is not an operating state"))
        .collect();
    let states = function.states.iter().fold(0, |mask, state| mask | state_bit(state));
    if states == 0 {
        faults.push("it has no operating states".to_owned());
    }
    let error = function.errors.first().copied().filter(|number| *number <= 8);
    let expected = STATE_ERRORS.iter().find(|(_, mask)| *mask == states).map(|(number, _)| *number);
    if error != expected || (error.is_none() && states != 0b11111) {
        faults.push(format!(
            "its states call for the state error {expected:?}, its errors begin with {error:?}"
        ));
    }
    faults
}

fn error_faults(tables: &Tables, function: &Function) -> Vec<String> {
    let mut faults = Vec::new();
    unique("error", function.errors.iter().chain(&function.fortran_errors), &mut faults);
    let known: BTreeSet<i32> = tables.errors.iter().map(|e| e.number).collect();
    for number in function.errors.iter().chain(&function.fortran_errors).filter(|n| !known.contains(n)) {
        faults.push(format!("error {number} has no text"));
    }
    for (number, reason) in &function.unreachable {
        if !number.parse().is_ok_and(|n| function.errors.contains(&n)) {
            faults.push(format!("error {number} is called unreachable and not listed"));
        }
        if reason.is_empty() {
            faults.push(format!("error {number} is unreachable without a reason"));
        }
    }
    let parameters: Vec<&Parameter> = function.parameters.values().flatten().collect();
    let expected: Vec<i32> = fortran_errors(&parameters).filter(|n| !function.errors.contains(n)).collect();
    if function.fortran_errors != expected {
        faults.push(format!("its parameters call for the Fortran errors {expected:?}"));
    }
    faults
}

/// The errors that follow from the kinds of parameters: 2000 from an enumeration that is handed in, 2001 from a result
/// whose size the caller sets, 2002 from the number of a list element.
fn fortran_errors(parameters: &[&Parameter]) -> impl Iterator<Item = i32> {
    let handed_in = |p: &&&Parameter| p.direction == "in";
    let enumerated = parameters.iter().filter(handed_in).any(|p| p.enumeration.is_some());
    let sized = |p: &&Parameter| p.dimension.as_ref().is_some_and(|d| d.contains(char::is_alphabetic));
    let bounded = parameters.iter().any(|p| p.direction == "out" && (p.kind.starts_with('C') || sized(p)));
    let element = |p: &&Parameter| p.meaning.contains("list element");
    let listed = parameters.iter().filter(handed_in).any(element);
    let found = [(2000, enumerated), (2001, bounded), (2002, listed)];
    found.into_iter().filter_map(|(number, found)| found.then_some(number))
}

/// Enumerations in the sample must exist, and its brackets must match.
fn sample_faults(tables: &Tables, function: &Function) -> Vec<String> {
    let Some(sample) = &function.sample else { return Vec::new() };
    let mut faults = Vec::new();
    for (place, _) in sample.match_indices("::") {
        let word = |c: char| !c.is_alphanumeric();
        let kind = sample[..place].rsplit(word).next().unwrap_or_default();
        let value = sample[place + 2..].split(word).next().unwrap_or_default();
        let enumeration = tables.enumerations.enumeration.iter().find(|e| e.rust == kind);
        let known = enumeration.is_some_and(|e| e.values.iter().any(|v| v.rust.as_deref() == Some(value)));
        if !["AspectSourceFlags", "DataRecord", "Cells"].contains(&kind) && !known {
            faults.push(format!("the sample names {kind}::{value}, which is not an enumeration's"));
        }
    }
    let mut open = Vec::new();
    for c in sample.chars() {
        match c {
            '(' => open.push(')'),
            '[' => open.push(']'),
            ')' | ']' if open.pop() != Some(c) => faults.push(format!("the sample has an unmatched {c}")),
            _ => {}
        }
    }
    if !open.is_empty() || sample.matches('"').count() % 2 == 1 {
        faults.push("the sample is not closed".to_owned());
    }
    if function.awaits.is_none() && has_subject(function) && subject(sample).is_none() {
        faults.push("the sample does not begin with a workstation identifier or type".to_owned());
    }
    if function.sample_error.is_some_and(|error| !function.errors.contains(&error)) {
        faults.push("the error of the sample is not listed".to_owned());
    }
    faults
}

fn parameter_faults(tables: &Tables, parameters: &[Parameter]) -> Vec<String> {
    let mut faults = Vec::new();
    unique("parameter", parameters.iter().map(|p| &p.name), &mut faults);
    for parameter in parameters {
        let Parameter { name, kind, direction, dimension, enumeration, meaning } = parameter;
        if !["I", "R", "C*80", "C*(*)"].contains(&kind.as_str()) {
            faults.push(format!("{name} has the unknown type {kind}"));
        }
        if !["in", "out"].contains(&direction.as_str()) {
            faults.push(format!("{name} has the unknown direction {direction}"));
        }
        for bound in dimension.iter().flat_map(|d| d.split(',')) {
            if bound.parse::<u32>().is_err() && !parameters.iter().any(|p| p.name == bound) {
                faults.push(format!("{name} has the unknown dimension {bound}"));
            }
        }
        let known = |name: &String| tables.enumerations.enumeration.iter().any(|e| e.name == *name);
        if let Some(name_of_type) = enumeration.as_ref().filter(|e| kind != "I" || !known(e)) {
            faults.push(format!("{name} has the unknown enumeration {name_of_type}"));
        }
        if meaning.is_empty() {
            faults.push(format!("{name} has no meaning"));
        }
    }
    faults
}

fn enumerations(tables: &Tables, faults: &mut Vec<String>) {
    let groups = &tables.enumerations;
    unique("enumeration", groups.enumeration.iter().map(|e| &e.name), faults);
    unique("Rust type", groups.enumeration.iter().map(|e| &e.rust), faults);
    unique(
        "aspect",
        groups
            .aspects
            .iter()
            .flat_map(|a| [&a.name, &a.c, &a.xgks].map(String::as_str))
            .collect::<BTreeSet<_>>(),
        faults,
    );
    let plain = groups.named_numbers.iter().chain(&groups.demonstration_numbers);
    let values: Vec<&Value> =
        groups.enumeration.iter().flat_map(|e| &e.values).chain(plain.flat_map(|g| &g.values)).collect();
    unique("C constant", values.iter().filter_map(|v| v.c.as_ref()), faults);
    let fortran = values.iter().flat_map(|v| OneOrMore::names(&v.fortran));
    unique("Fortran constant", fortran.clone(), faults);
    for name in fortran.filter(|name| name.len() > 6 || !name.starts_with('G')) {
        faults.push(format!("{name} is not a name for a Fortran constant"));
    }
    for enumeration in &groups.enumeration {
        enumeration_faults(enumeration, faults);
    }
    let mut ranges: BTreeMap<&str, i32> = BTreeMap::new();
    for group in &groups.dialect_workstation_types {
        for types in &group.values {
            let after = ranges.insert(&group.dialect, types.last).unwrap_or(0);
            if types.first <= after || types.last < types.first || types.meaning.is_empty() {
                faults.push(format!(
                    "dialect {}: workstation type {} is out of order",
                    group.dialect, types.first
                ));
            }
        }
    }
}

fn enumeration_faults(enumeration: &Enumeration, faults: &mut Vec<String>) {
    let name = &enumeration.name;
    if enumeration.values.iter().zip(0..).any(|(value, place)| value.value != place) {
        faults.push(format!("{name}: the values do not count up from 0"));
    }
    if enumeration.values.iter().any(|value| value.rust.is_none() || value.c.is_none()) {
        faults.push(format!("{name}: a value has no name"));
    }
    unique(&format!("{name}: value"), enumeration.values.iter().filter_map(|v| v.rust.as_ref()), faults);
}

#[cfg(test)]
mod tests;
