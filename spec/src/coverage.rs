//! Writes `bindings/cli/src/generated/coverage.rs`: how many functions of each level are there, in each language.
//!
//! A function is there in a language if the sources define every name that the language has for it. What is
//! generated for levels that are still to be built does not count.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

use crate::tables::{Function, Tables};

const HEAD: &str = "\
//! How many functions of the standards are there, in each language.
//!
//! Written by `gks-spec generate` from the tables in `spec` and the names that the sources define; do not edit.

use serde::Serialize;

/// The functions whose lowest level is a level of a standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Coverage {
    /// The standard.
    pub standard: &'static str,
    /// The level.
    pub level: &'static str,
    /// The number of functions.
    pub functions: usize,
    /// How many of them Rust has.
    pub rust: usize,
    /// How many of them C has.
    pub c: usize,
    /// How many of them Fortran has.
    pub fortran: usize,
    /// What a language has no name for, as \"language: function\"; it counts as there.
    pub na: &'static [&'static str],
}
";

const LEVELS: [&str; 9] = ["0a", "0b", "0c", "1a", "1b", "1c", "2a", "2b", "2c"];

/// The languages: name, folders with its sources, the names that it has for a function.
type Language = (&'static str, &'static [&'static str], fn(&Function) -> Vec<String>);

const LANGUAGES: [Language; 3] = [
    ("rust", &["kernel/gks/src"], |f| f.rust.iter().cloned().collect()),
    ("c", &["bindings/c/src", "bindings/c/gerr_hand/src", "bindings/c/gerr_log/src"], |f| {
        f.c.iter().cloned().collect()
    }),
    (
        "fortran",
        &["bindings/fortran/src", "bindings/fortran/gerhnd/src", "bindings/fortran/gerlog/src"],
        |f| {
            let names = if f.fortran.is_empty() { &f.fortran_split } else { &f.fortran };
            names.iter().map(|name| format!("{}_", name.to_lowercase())).collect()
        },
    ),
];

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let root = crate::repository();
    let defined = LANGUAGES.map(|(_, folders, _)| {
        let mut names = BTreeSet::new();
        folders.iter().for_each(|folder| read(&root.join(folder), &mut names));
        names
    });
    let mut out = String::from(HEAD);
    out += "\n/// The coverage of each level.\npub const COVERAGE: &[Coverage] = &[\n";
    for level in LEVELS {
        write_level(&mut out, level, tables, &defined);
    }
    out += "];\n";
    out
}

fn write_level(out: &mut String, level: &str, tables: &Tables, defined: &[BTreeSet<String>; 3]) {
    let functions: Vec<&Function> = tables.functions.iter().filter(|f| f.level == level).collect();
    let mut na = Vec::new();
    let counts = [0, 1, 2].map(|i| {
        let (language, _, names) = LANGUAGES[i];
        let is_there = |function: &&&Function| {
            let names = names(function);
            if names.is_empty() {
                na.push(format!("{language}: {}", function.name));
            }
            names.iter().all(|name| defined[i].contains(name))
        };
        functions.iter().filter(is_there).count()
    });
    let [rust, c, fortran] = counts;
    let _ = writeln!(
        out,
        "    Coverage {{\n        standard: \"gks\",\n        level: {level:?},\n        functions: {},",
        functions.len()
    );
    let _ = writeln!(out, "        rust: {rust},\n        c: {c},\n        fortran: {fortran},");
    if na.is_empty() {
        out.push_str("        na: &[],\n    },\n");
        return;
    }
    out.push_str("        na: &[\n");
    for what in na {
        let _ = writeln!(out, "            {what:?},");
    }
    out.push_str("        ],\n    },\n");
}

/// Adds the names that the Rust files below a folder define, generated files apart.
fn read(folder: &Path, names: &mut BTreeSet<String>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.is_dir() {
            if !path.ends_with("generated") {
                read(&path, names);
            }
        } else if path.extension().is_some_and(|extension| extension == "rs")
            && let Ok(text) = std::fs::read_to_string(&path)
        {
            define(&text, names);
        }
    }
}

/// Adds the names that a source defines: the public methods of `Gks`, functions with the calling convention
/// of C, and what begins a line in a call of a macro at the top of the file.
fn define(text: &str, names: &mut BTreeSet<String>) {
    let (mut methods, mut call) = (false, false);
    for line in text.lines().filter(|line| !line.is_empty()) {
        if !line.starts_with(' ') {
            methods = line == "impl Gks {";
            call = line
                .split_once("! {")
                .is_some_and(|(name, rest)| rest.is_empty() && identifier(name) == name);
        }
        let method = line.trim_start().strip_prefix("pub fn ").filter(|_| methods);
        let exported = line.split_once("extern \"C\" fn ").map(|(_, name)| name);
        let called = Some(line.trim_start()).filter(|_| call && line.starts_with(' '));
        let name = method.or(exported).or(called).map_or("", identifier);
        if !name.is_empty() {
            names.insert(name.to_owned());
        }
    }
}

/// The identifier that begins a text; empty if none does.
fn identifier(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(text.len());
    &text[..end]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn defined(text: &str) -> Vec<String> {
        let mut names = BTreeSet::new();
        define(text, &mut names);
        names.into_iter().collect()
    }

    #[test]
    fn methods_of_the_kernel_are_found_and_those_of_others_are_not() {
        let text = "impl Gks {\n    fn draw() {}\n\n    pub fn polyline(&mut self) {\n        self.draw();\n    }\n}\n\
                    impl Error {\n    pub fn text(&self) {}\n}\n";
        assert_eq!(defined(text), ["polyline"]);
    }

    #[test]
    fn exported_functions_are_found_and_templates_of_macros_are_not() {
        let text = "macro_rules! setters {\n    () => {\n        extern \"C\" fn $name() {}\n    };\n}\n\
                    pub unsafe extern \"C\" fn gerlog_(error: i32) {\n    gerhnd_(error);\n}\n";
        assert_eq!(defined(text), ["gerlog_"]);
    }

    #[test]
    fn what_a_macro_is_called_with_is_found() {
        let text = "setters! {\n    /// SET LINETYPE.\n    gset_linetype(Gint) SetLinetype\n        => set_linetype;\n}\n\
                    fn other() {\n    gpolyline();\n}\n";
        assert_eq!(defined(text), ["gset_linetype"]);
    }

    #[test]
    fn a_function_is_there_if_all_its_names_are_and_a_function_without_names_is() {
        let tables = Tables::load(&crate::repository().join("spec")).expect("the tables can be read");
        let mut out = String::new();
        let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
        write_level(
            &mut out,
            "2a",
            &tables,
            &[BTreeSet::new(), names(&["gcopy_seg_ws"]), names(&["ginsg_"])],
        );
        assert!(out.contains("functions: 3,\n        rust: 0,\n        c: 1,\n        fortran: 1,"), "{out}");
        out.clear();
        write_level(&mut out, "0a", &tables, &[BTreeSet::new(), BTreeSet::new(), names(&["gtx_"])]);
        assert!(out.contains("\"c: PACK DATA RECORD\""), "{out}");
        // TEXT has a subset variant as well; CREATE STORE and its like have no names in Fortran.
        assert!(out.contains("fortran: 3,"), "{out}");
    }
}
