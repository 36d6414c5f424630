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
    let values = |name: &str| {
        let found = tables.enumerations.enumeration.iter().find(|e| e.name == name);
        found.map_or(2, |enumeration| enumeration.values.len())
    };
    for function in &tables.functions {
        for name in function.fortran.iter().filter(|name| !LEFT_OUT.contains(&name.as_str())) {
            let parameters = function.parameters.get(name).map(Vec::as_slice).unwrap_or_default();
            write_subroutine(&mut externs, &mut calls, name, parameters, values);
        }
    }
    format!(
        "{HEAD}{externs}}}\n\n/// Every subroutine.\npub(crate) static SUBROUTINES: &[Subroutine] = &[\n{calls}];\n"
    )
}

fn write_subroutine(
    externs: &mut String,
    calls: &mut String,
    name: &str,
    parameters: &[Parameter],
    values: impl Fn(&str) -> usize,
) {
    let symbol = format!("{}_", name.to_lowercase());
    let has_arrays = parameters.iter().any(|p| p.dimension.is_some());
    let (mut types, mut arguments, mut lengths) = (Vec::new(), Vec::new(), 0);
    for parameter in parameters {
        let kind = match &parameter.kind[..1] {
            "I" => "*mut i32",
            "R" => "*mut f32",
            _ => "*mut u8",
        };
        lengths += usize::from(kind == "*mut u8");
        types.push(kind);
        arguments.push(argument(parameter, has_arrays, &values));
    }
    types.extend(std::iter::repeat_n("usize", lengths));
    arguments.extend(std::iter::repeat_n("Arguments::LENGTH".to_owned(), lengths));
    let types: Vec<String> = types.iter().enumerate().map(|(i, t)| format!("p{i}: {t}")).collect();
    let _ = writeln!(externs, "    pub(crate) fn {symbol}({});", types.join(", "));
    let closure = if arguments.is_empty() { "_" } else { "a" };
    let _ = writeln!(
        calls,
        "    // SAFETY: every argument has the type and at least the size that the subroutine asks for.\n    \
         Subroutine {{ name: \"{name}\", call: |{closure}| unsafe {{ {symbol}({}) }} }},",
        arguments.join(", ")
    );
}

/// How an argument is drawn. What means a workstation, a segment or a device is drawn from few numbers, so that calls
/// meet; `values` gives the number of values of an enumeration.
fn argument(parameter: &Parameter, has_arrays: bool, values: impl Fn(&str) -> usize) -> String {
    let kind = &parameter.kind[..1];
    let is_array = parameter.dimension.is_some();
    let call = match (kind, parameter.name.as_str(), parameter.direction.as_str()) {
        ("I", "ERRIND", _) => "indicator()",
        ("C", ..) if is_array && parameter.kind == "C*80" => "record()",
        ("I", "TYPE", _) if parameter.enumeration.is_none() => "kept(0)",
        ("I", "IDRL", _) => "kept(1)",
        ("I", _, "out") => "output_integers()",
        ("R", _, "out") => "output_reals()",
        ("C", _, "out") => "output_characters()",
        ("C", ..) => "characters()",
        ("I", ..) if is_array => "integers()",
        ("R", ..) if is_array => "reals()",
        ("R", "TOUT", _) => "timeout()",
        ("R", ..) => "real()",
        (_, "WTYPE", _) => "workstation_type()",
        (_, "WKID", _) => "among(1, 7)",
        (_, "CONID", _) => "among(1, 9)",
        (_, "SGNA" | "ISGNA" | "OLD" | "NEW", _) => "among(1, 4)",
        (_, "LCDNR" | "SKDNR" | "VLDNR" | "CHDNR" | "PKDNR" | "STDNR" | "IDNR" | "DEVNO", _) => "among(1, 2)",
        (_, "PRIMID", _) => "among(-10, 10)",
        (_, "FCTID", _) => "among(-3005, 5)",
        (_, name, _) => match &parameter.enumeration {
            Some(enumeration) => return format!("a.among(0, {})", values(enumeration)),
            // A number of points or of elements; the others are no sizes of arrays.
            None if has_arrays && name != "PET" => "count()",
            None => "integer()",
        },
    };
    format!("a.{call}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameter(name: &str, kind: &str, direction: &str) -> Parameter {
        Parameter {
            name: name.to_owned(),
            kind: kind.to_owned(),
            direction: direction.to_owned(),
            dimension: None,
            enumeration: None,
            meaning: String::new(),
        }
    }

    #[test]
    fn arguments_follow_the_table() {
        let array = |parameter| Parameter { dimension: Some("N".to_owned()), ..parameter };
        let parameters = [
            parameter("WKID", "I", "in"),
            parameter("N", "I", "in"),
            array(parameter("PXA", "R", "in")),
            parameter("CHARS", "C*80", "in"),
            array(parameter("DATREC", "C*80", "out")),
            array(parameter("IA", "I", "out")),
            Parameter { enumeration: Some("lamp".to_owned()), ..parameter("LAMP", "I", "in") },
            parameter("ERRIND", "I", "out"),
        ];
        let (mut externs, mut calls) = (String::new(), String::new());
        write_subroutine(&mut externs, &mut calls, "GLAMP", &parameters, |_| 3);
        assert_eq!(
            externs,
            "    pub(crate) fn glamp_(p0: *mut i32, p1: *mut i32, p2: *mut f32, p3: *mut u8, p4: *mut u8, \
             p5: *mut i32, p6: *mut i32, p7: *mut i32, p8: usize, p9: usize);\n"
        );
        let call = "glamp_(a.among(1, 7), a.count(), a.reals(), a.characters(), a.record(), \
                    a.output_integers(), a.among(0, 3), a.indicator(), Arguments::LENGTH, Arguments::LENGTH)";
        assert!(calls.contains(call), "{calls}");
    }
}
