//! Writes `tests/fuzz/src/generated.rs`: how every Fortran subroutine of GKS is called with arbitrary arguments.

use std::fmt::Write as _;

use crate::tables::{Parameter, Tables};

const HEAD: &str = "\
//! How every subroutine of the Fortran binding is called with arbitrary arguments.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

use crate::arguments::Arguments;

/// A subroutine.
pub(crate) struct Subroutine {
    /// Its name.
    pub(crate) name: &'static str,
    /// Calls it.
    pub(crate) call: fn(&mut Arguments<'_>),
}
";

/// The error procedures, which are not for programs to call.
const LEFT_OUT: [&str; 2] = ["GERHND", "GERLOG"];

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut externs = String::from("\nunsafe extern \"C\" {\n");
    let mut calls = String::new();
    for function in &tables.functions {
        for name in function.fortran.iter().filter(|name| !LEFT_OUT.contains(&name.as_str())) {
            let parameters = function.parameters.get(name).map(Vec::as_slice).unwrap_or_default();
            write_subroutine(&mut externs, &mut calls, name, parameters);
        }
    }
    format!(
        "{HEAD}{externs}}}\n\n/// Every subroutine.\npub(crate) static SUBROUTINES: &[Subroutine] = &[\n{calls}];\n"
    )
}

fn write_subroutine(externs: &mut String, calls: &mut String, name: &str, parameters: &[Parameter]) {
    let symbol = format!("{}_", name.to_lowercase());
    let has_arrays = parameters.iter().any(|p| p.dimension.is_some());
    let (mut types, mut values, mut lengths) = (Vec::new(), Vec::new(), 0);
    for parameter in parameters {
        let (kind, single, array) = match &parameter.kind[..1] {
            "I" if has_arrays => ("*mut i32", "a.count()", "a.integers()"),
            "I" => ("*mut i32", "a.integer()", "a.integers()"),
            "R" => ("*mut f32", "a.real()", "a.reals()"),
            _ => ("*mut u8", "a.characters()", "a.characters()"),
        };
        lengths += usize::from(kind == "*mut u8");
        types.push(kind);
        values.push(if parameter.dimension.is_some() { array } else { single });
    }
    types.extend(std::iter::repeat_n("usize", lengths));
    values.extend(std::iter::repeat_n("Arguments::LENGTH", lengths));
    let types: Vec<String> = types.iter().enumerate().map(|(i, t)| format!("p{i}: {t}")).collect();
    let _ = writeln!(externs, "    pub(crate) fn {symbol}({});", types.join(", "));
    let arguments = if values.is_empty() { "_" } else { "a" };
    let _ = writeln!(
        calls,
        "    // SAFETY: every argument has the type and at least the size that the subroutine asks for.\n    \
         Subroutine {{ name: \"{name}\", call: |{arguments}| unsafe {{ {symbol}({}) }} }},",
        values.join(", ")
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_follow_the_table() {
        let parameter = |kind: &str, dimension: Option<&str>| Parameter {
            name: "N".to_owned(),
            kind: kind.to_owned(),
            direction: "in".to_owned(),
            dimension: dimension.map(str::to_owned),
            enumeration: None,
            meaning: String::new(),
        };
        let parameters = [
            parameter("I", None),
            parameter("R", Some("N")),
            parameter("C*80", None),
            parameter("I", Some("N")),
        ];
        let (mut externs, mut calls) = (String::new(), String::new());
        write_subroutine(&mut externs, &mut calls, "GLAMP", &parameters);
        assert_eq!(
            externs,
            "    pub(crate) fn glamp_(p0: *mut i32, p1: *mut f32, p2: *mut u8, p3: *mut i32, p4: usize);\n"
        );
        assert!(
            calls.contains("glamp_(a.count(), a.reals(), a.characters(), a.integers(), Arguments::LENGTH)")
        );
    }
}
