//! Checks `types.toml` and the C prototypes: every type must be known where it is used.

use std::collections::BTreeSet;

use super::unique;
use crate::tables::{Macros, Tables};

/// Words of C and of its library that declarations may use besides the types of GKS.
const WORDS: [&str; 9] = ["void", "const", "char", "int", "float", "double", "struct", "union", "size_t"];

/// Adds what is wrong with the C types and prototypes.
pub(super) fn check(tables: &Tables, faults: &mut Vec<String>) {
    let types = &tables.types;
    let mut known: BTreeSet<&str> = tables.enumerations.enumeration.iter().map(|e| e.c.as_str()).collect();
    let all = known.iter().copied().chain(types.typedef.iter().map(|t| t.name.as_str()));
    unique("C type", all.chain(types.structure.iter().map(|s| s.name.as_str())).collect::<Vec<_>>(), faults);
    for typedef in &types.typedef {
        known.insert(&typedef.name);
        if !words(&typedef.declaration).any(|word| word == typedef.name) || typedef.meaning.is_empty() {
            faults.push(format!("{}: the declaration does not declare it", typedef.name));
        }
    }
    for structure in &types.structure {
        for member in &structure.members {
            unknown_types(&structure.name, member, &known, faults);
        }
        if structure.members.is_empty() || structure.meaning.is_empty() {
            faults.push(format!("{}: it has no members or no meaning", structure.name));
        }
        if !["struct", "union"].contains(&structure.kind.as_deref().unwrap_or("struct")) {
            faults.push(format!("{}: it is neither struct nor union", structure.name));
        }
        known.insert(&structure.name);
    }
    for function in &tables.functions {
        if let (Some(c), Some(prototype)) = (&function.c, &function.prototype) {
            prototype_faults(c, prototype, &known, faults);
        }
    }
    for extra in &types.extra_prototype {
        prototype_faults(&extra.name, &extra.prototype, &known, faults);
        if tables.functions.iter().any(|f| f.c.as_ref() == Some(&extra.name)) || extra.meaning.is_empty() {
            faults.push(format!("{}: the standard has this function", extra.name));
        }
    }
    unique("macro", types.macros.iter().flat_map(Macros::names), faults);
    let constants =
        tables.enumerations.enumeration.iter().flat_map(|e| &e.values).filter_map(|v| v.c.as_deref());
    unique("C name", constants.chain(types.macros.iter().flat_map(Macros::names)), faults);
}

impl Macros {
    fn names(&self) -> impl Iterator<Item = &str> {
        self.values.iter().map(|m| m.name.as_str())
    }
}

fn prototype_faults(name: &str, prototype: &str, known: &BTreeSet<&str>, faults: &mut Vec<String>) {
    if !prototype.starts_with(&format!("void {name}(")) || !prototype.ends_with(')') {
        faults.push(format!("{name}: the prototype is not one of it"));
    }
    unknown_types(name, prototype, known, faults);
}

/// Reports the types in a declaration that are not known: words that begin as the types of GKS do.
fn unknown_types(name: &str, declaration: &str, known: &BTreeSet<&str>, faults: &mut Vec<String>) {
    for word in words(declaration) {
        let kind = word.starts_with('G') && word[1..].starts_with(|c: char| c.is_ascii_lowercase());
        if kind && !known.contains(word) {
            faults.push(format!("{name}: unknown type {word}"));
        }
    }
    for parameter in declaration.split(['(', ',', ';', '{', ')']).map(str::trim) {
        let first = words(parameter).find(|word| *word != "const").unwrap_or_default();
        let lone = words(parameter).count() < 2;
        if !lone && !known.contains(first) && !WORDS.contains(&first) {
            faults.push(format!("{name}: {first} is not a type"));
        }
    }
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}
