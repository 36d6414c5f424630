//! Writes `bindings/fortran/include/gks.inc` and `gkspar.inc`: the named constants of the Fortran binding (ISO 8651-1).
//!
//! The text is at once fixed form (columns 7 to 72, no continuation) and free form (`!` comments).

use std::fmt::Write as _;

use crate::tables::Tables;

/// The text of `gks.inc`: the standard's constants.
pub(crate) fn generate(tables: &Tables) -> String {
    include(tables, "gks.inc", false)
}

/// The text of `gkspar.inc`: the same and what demonstration programs expect besides.
pub(crate) fn generate_demonstration(tables: &Tables) -> String {
    include(tables, "gkspar.inc", true)
}

fn include(tables: &Tables, name: &str, demonstration: bool) -> String {
    let mut out = format!("! {name}: the constants of the Fortran binding of GKS (ISO 8651-1).\n!\n");
    out += "! Written by `gks-spec generate` from the tables in spec/gks; do not edit.\n";
    let groups = &tables.enumerations;
    for enumeration in &groups.enumeration {
        let values = enumeration.values.iter();
        let values = values.flat_map(|v| v.fortran.names().iter().map(|name| (name.clone(), v.value)));
        write_group(&mut out, &enumeration.name, values);
    }
    let mut others: Vec<_> = groups.named_numbers.iter().collect();
    if demonstration {
        others.extend(&groups.demonstration_numbers);
    }
    for group in others {
        let values = group.values.iter();
        let values = values.flat_map(|v| v.fortran.names().iter().map(|name| (name.clone(), v.value)));
        write_group(&mut out, &group.name, values);
    }
    let identifiers = tables.functions.iter().filter_map(|f| Some((identifier(f.fortran.first()?)?, f.id?)));
    write_group(&mut out, "function identifiers, as the error handler is given them", identifiers);
    out
}

/// The name of a function identifier: that of the subroutine with E for G.
pub(crate) fn identifier(subroutine: &str) -> Option<String> {
    subroutine.strip_prefix('G').map(|rest| format!("E{rest}"))
}

fn write_group(out: &mut String, name: &str, values: impl Iterator<Item = (String, i32)>) {
    let _ = writeln!(out, "!\n! {name}");
    let values: Vec<(String, i32)> = values.collect();
    for chunk in values.chunks(4) {
        let names: Vec<&str> = chunk.iter().map(|(name, _)| name.as_str()).collect();
        let settings: Vec<String> = chunk.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let _ = writeln!(out, "      INTEGER {}", names.join(", "));
        let _ = writeln!(out, "      PARAMETER ({})", settings.join(", "));
    }
}
