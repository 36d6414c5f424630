//! Writes `bindings/c/include/gks.h`: the header of the C binding (ISO/IEC 8651-4).

use std::fmt::Write as _;

use crate::tables::{Structure, Tables};

const HEAD: &str = "\
/* gks.h: the C binding of GKS (ISO/IEC 8651-4).
 *
 * Written by `gks-spec generate` from the tables in spec/gks; do not edit.
 */
#ifndef GKS_H
#define GKS_H

#include <stddef.h>

#ifdef __cplusplus
extern \"C\" {
#endif
";

const FOOT: &str = "
#ifdef __cplusplus
}
#endif

#endif
";

/// The longest line of the header.
const WIDTH: usize = 100;

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut out = String::from(HEAD);
    for typedef in &tables.types.typedef {
        let _ = writeln!(out, "\n/* {} */\ntypedef {};", typedef.meaning, typedef.declaration);
    }
    for enumeration in &tables.enumerations.enumeration {
        let constants: Vec<String> = enumeration
            .values
            .iter()
            .map(|v| format!("    {} = {}", v.c.as_deref().unwrap_or_default(), v.value))
            .collect();
        let _ = writeln!(
            out,
            "\n/* {} */\ntypedef enum {{\n{}\n}} {};",
            enumeration.name,
            constants.join(",\n"),
            enumeration.c
        );
    }
    for structure in &tables.types.structure {
        write_structure(&mut out, structure);
    }
    for group in &tables.enumerations.named_numbers {
        let values = group.values.iter().map(|v| (v.c.as_deref().unwrap_or_default(), v.value.to_string()));
        write_macros(&mut out, &format!("{}s", group.name), values);
    }
    for group in &tables.types.macros {
        write_macros(&mut out, &group.name, group.values.iter().map(|m| (m.name.as_str(), m.value.clone())));
    }
    let identifiers: Vec<(String, String)> = tables
        .functions
        .iter()
        .filter_map(|f| Some((format!("Gfn_{}", f.c.as_deref()?.strip_prefix('g')?), f.id?.to_string())))
        .collect();
    let identifiers = identifiers.iter().map(|(name, value)| (name.as_str(), value.clone()));
    write_macros(&mut out, "function identifiers, as the error handler is given them", identifiers);
    let mut category = "";
    for function in &tables.functions {
        let Some(prototype) = &function.prototype else { continue };
        if function.category != category {
            category = &function.category;
            let _ = writeln!(out, "\n/* ---- {category} ---- */");
        }
        write_prototype(&mut out, &function.name, prototype);
    }
    out += "\n/* ---- beyond the standard ---- */\n";
    for extra in &tables.types.extra_prototype {
        write_prototype(&mut out, &extra.meaning, &extra.prototype);
    }
    out += FOOT;
    out
}

fn write_structure(out: &mut String, structure: &Structure) {
    let kind = structure.kind.as_deref().unwrap_or("struct");
    let _ = writeln!(out, "\n/* {} */\ntypedef {kind} {{", structure.meaning);
    for member in &structure.members {
        let _ = writeln!(out, "    {member};");
    }
    let _ = writeln!(out, "}} {};", structure.name);
}

fn write_macros<'a>(out: &mut String, name: &str, values: impl Iterator<Item = (&'a str, String)>) {
    let _ = writeln!(out, "\n/* {name} */");
    for (name, value) in values {
        let value = if value.starts_with('-') { format!("({value})") } else { value };
        let _ = writeln!(out, "#define {name} {value}");
    }
}

/// Writes a prototype, broken after the comma between parameters that would cross the margin.
fn write_prototype(out: &mut String, name: &str, prototype: &str) {
    let _ = writeln!(out, "\n/* {name} */");
    let indent = prototype.find('(').map_or(4, |open| (open + 1).min(40));
    let mut depth = 0;
    let parts = prototype.split_inclusive(|c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        c == ',' && depth == 1
    });
    let mut column = 0;
    for part in parts {
        if column > 0 && column + part.len() > WIDTH {
            let _ = write!(out, "\n{:indent$}{}", "", part.trim_start());
            column = indent + part.trim_start().len();
        } else {
            out.push_str(part);
            column += part.len();
        }
    }
    out.push_str(";\n");
}
