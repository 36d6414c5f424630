//! Writes `kernel/gks/src/generated/function.rs`: the functions of GKS with what the kernel must know of each.

use std::fmt::Write as _;

use crate::tables::{Enumeration, Function, Tables};

const HEAD: &str = "\
//! The functions of GKS, their operating states, levels, errors and names in the bindings.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.
";

const MASK: &str = "
/// A set of operating states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StateMask(u8);

impl StateMask {
    /// Whether `state` is one of the set.
    #[must_use]
    pub const fn contains(self, state: OperatingState) -> bool {
        self.0 & (1 << state as u8) != 0
    }
}

impl Level {
    /// The output level, 0 to 2.
    #[must_use]
    pub const fn output(self) -> u8 {
        self as u8 / 3
    }

    /// The input level: 0 for a, 1 for b, 2 for c.
    #[must_use]
    pub const fn input(self) -> u8 {
        self as u8 % 3
    }

    /// Whether an implementation of this level has the functions of level `other`.
    #[must_use]
    pub const fn includes(self, other: Self) -> bool {
        self.output() >= other.output() && self.input() >= other.input()
    }
}
";

const METHODS: &str = "
struct Entry {
    name: &'static str,
    fortran: &'static [&'static str],
    c: &'static str,
    level: Level,
    id: i32,
    states: u8,
    errors: &'static [i32],
}

impl Function {
    /// The standard's name, in capitals.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ENTRIES[self as usize].name
    }

    /// The Fortran subroutines: the full variant, then the subset variant; none for what only the C binding has
    /// and for inquiries that Fortran splits into others.
    #[must_use]
    pub const fn fortran(self) -> &'static [&'static str] {
        ENTRIES[self as usize].fortran
    }

    /// The C function; `None` for what only the Fortran binding has.
    #[must_use]
    pub const fn c(self) -> Option<&'static str> {
        let c = ENTRIES[self as usize].c;
        if c.is_empty() { None } else { Some(c) }
    }

    /// The lowest level of GKS that has the function.
    #[must_use]
    pub const fn level(self) -> Level {
        ENTRIES[self as usize].level
    }

    /// The function identifier that the error handler is given, the same in Fortran and C; inquiries have none.
    #[must_use]
    pub const fn id(self) -> Option<i32> {
        let id = ENTRIES[self as usize].id;
        if id < 0 { None } else { Some(id) }
    }

    /// The operating states in which the function may be called.
    #[must_use]
    pub const fn states(self) -> StateMask {
        StateMask(ENTRIES[self as usize].states)
    }

    /// The error, 1 to 8, of a call in another state; 0 for functions that may be called in every state.
    #[must_use]
    pub const fn state_error(self) -> i32 {
        let errors = ENTRIES[self as usize].errors;
        if !errors.is_empty() && errors[0] <= 8 { errors[0] } else { 0 }
    }

    /// The errors that the standard lists for the function, in the order of checking.
    #[must_use]
    pub const fn errors(self) -> &'static [i32] {
        ENTRIES[self as usize].errors
    }
}
";

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut out = String::from(HEAD);
    for name in ["operating state", "level of GKS"] {
        if let Some(enumeration) = tables.enumerations.enumeration.iter().find(|e| e.name == name) {
            write_enumeration(&mut out, enumeration);
        }
    }
    out += MASK;
    out += "\n/// A function of GKS or of one of its language bindings.\n";
    out += "#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]\n#[repr(u8)]\npub enum Function {\n";
    for function in &tables.functions {
        let _ = writeln!(out, "    /// {}.\n    {},", function.name, variant(&function.name));
    }
    out += "}\n";
    out += METHODS;
    let count = tables.functions.len();
    let _ = writeln!(
        out,
        "\nimpl Function {{\n    /// All functions, in the order of the table.\n    pub const ALL: [Self; {count}] = ["
    );
    for function in &tables.functions {
        let _ = writeln!(out, "        Self::{},", variant(&function.name));
    }
    out += "    ];\n}\n";
    let _ = writeln!(out, "\nstatic ENTRIES: [Entry; {count}] = [");
    for function in &tables.functions {
        write_entry(&mut out, function);
    }
    out += "];\n";
    out
}

fn write_enumeration(out: &mut String, enumeration: &Enumeration) {
    let _ = writeln!(
        out,
        "\n/// The {}.\n#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]\n#[repr(u8)]\npub enum {} {{",
        enumeration.name, enumeration.rust
    );
    for value in &enumeration.values {
        let name = value.rust.as_deref().unwrap_or_default();
        let fortran = value.fortran.names().join(", ");
        let _ = writeln!(out, "    /// {fortran}.\n    {name} = {},", value.value);
    }
    out.push_str("}\n");
}

fn write_entry(out: &mut String, function: &Function) {
    let states = function.states.iter().fold(0u8, |mask, state| mask | state_bit(state));
    let _ = writeln!(
        out,
        "    Entry {{ name: {:?}, fortran: &{:?}, c: {:?}, level: Level::L{}, id: {}, states: {states:#07b}, errors: &{:?} }},",
        function.name,
        function.fortran,
        function.c.as_deref().unwrap_or_default(),
        function.level,
        function.id.unwrap_or(-1),
        function.errors,
    );
}

/// The bit of an operating state; 0 for a name that is not one.
pub(crate) fn state_bit(state: &str) -> u8 {
    let states = ["GKCL", "GKOP", "WSOP", "WSAC", "SGOP"];
    states.iter().position(|s| *s == state).map_or(0, |position| 1 << position)
}

/// The name of the enumeration variant: `SET POLYLINE INDEX` becomes `SetPolylineIndex`.
pub(crate) fn variant(name: &str) -> String {
    name.split(' ')
        .map(|word| {
            word.get(..1).unwrap_or_default().to_owned() + &word.get(1..).unwrap_or_default().to_lowercase()
        })
        .collect()
}
