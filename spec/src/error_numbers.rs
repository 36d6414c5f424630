//! Writes `bindings/cli/src/generated/error_numbers.rs`: every error number, and how it is met.

use std::fmt::Write as _;

use crate::tables::{Error, Tables};

const HEAD: &str = "\
//! The error numbers of GKS, and how each of them is met.
//!
//! Written by `gks-spec generate` from the tables in `spec/gks`; do not edit.

use serde::Serialize;

/// An error number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ErrorNumber {
    /// The number.
    pub number: i32,
    /// What it means.
    pub text: &'static str,
    /// The functions that list it and are made to meet it.
    pub functions: &'static [&'static str],
    /// The test that provokes it, where no function lists it.
    pub provoked_by: Option<&'static str>,
    /// Why it is never reported.
    pub never: Option<&'static str>,
}
";

/// A way in which an error number is met.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Met<'a> {
    /// Functions of the kernel list it and do not call it unreachable, so that the conformance tests provoke it.
    Functions(Vec<&'a str>),
    /// A test provokes it.
    Test(&'a str),
    /// It is never reported, for this reason.
    Never(&'a str),
}

/// The ways in which a number is met; there has to be just one.
pub(crate) fn met<'a>(tables: &'a Tables, error: &'a Error) -> Vec<Met<'a>> {
    let number = error.number.to_string();
    let lists = |f: &&crate::tables::Function| {
        f.rust.is_some() && f.errors.contains(&error.number) && !f.unreachable.contains_key(&number)
    };
    let functions: Vec<&str> = tables.functions.iter().filter(lists).map(|f| f.name.as_str()).collect();
    let category = tables.error_categories.iter().find(|category| category.name == error.category);
    let mut ways = Vec::new();
    if !functions.is_empty() {
        ways.push(Met::Functions(functions));
    }
    ways.extend(error.provoked_by.as_deref().map(Met::Test));
    ways.extend(error.never.as_deref().map(Met::Never));
    ways.extend(category.map(|category| Met::Never(category.never.as_str())));
    ways
}

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut out = String::from(HEAD);
    out += "\n/// Every error number.\npub const ERROR_NUMBERS: &[ErrorNumber] = &[\n";
    for error in &tables.errors {
        let (mut functions, mut test, mut never) = (Vec::new(), None, None);
        for way in met(tables, error) {
            match way {
                Met::Functions(names) => functions = names,
                Met::Test(path) => test = Some(path),
                Met::Never(reason) => never = Some(reason),
            }
        }
        let _ = writeln!(
            out,
            "    ErrorNumber {{\n        number: {},\n        text: {:?},\n        functions: &{functions:?},\n        \
             provoked_by: {test:?},\n        never: {never:?},\n    }},",
            error.number, error.text
        );
    }
    out += "];\n";
    out
}
