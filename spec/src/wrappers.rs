//! Writes `bindings/fortran/src/generated/unbuilt.rs`: the subroutines of the levels of GKS that are still to be built.
//!
//! A program that calls them can be linked; the call reports that its level is not built.

use std::fmt::Write as _;

use crate::function::variant;
use crate::tables::{Function, Parameter, Tables};

const HEAD: &str = "\
//! The subroutines of the levels of GKS that are not built yet.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

use crate::argument::{Character, Integer, Real};
use crate::data_record::LINE;
use crate::unbuilt::{refusal, refuse};
use gks::Function;
";

/// Whether the kernel has what the function works on.
pub(crate) fn is_built(function: &Function) -> bool {
    function.awaits.is_none()
}

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut out = String::from(HEAD);
    for function in tables.functions.iter().filter(|f| !is_built(f)) {
        for name in &function.fortran {
            let parameters = function.parameters.get(name).map(Vec::as_slice).unwrap_or_default();
            write_subroutine(&mut out, function, name, parameters);
        }
    }
    out
}

fn write_subroutine(out: &mut String, function: &Function, name: &str, parameters: &[Parameter]) {
    let variant = variant(&function.name);
    let is_inquiry = parameters.iter().any(|p| p.name == "ERRIND");
    let sizes: Vec<&str> = parameters.iter().filter(|p| is_output(p)).filter_map(size).collect();
    let mut arguments = Vec::new();
    let mut lengths = Vec::new();
    let mut body = Vec::new();
    for parameter in parameters {
        let argument = identifier(&parameter.name);
        let mark = |used| if used { "" } else { "_" };
        let used = mark(is_output(parameter) || sizes.contains(&parameter.name.as_str()));
        let kind = match &parameter.kind[..1] {
            "I" => "Integer",
            "R" => "Real",
            _ => "Character",
        };
        arguments.push(format!("{used}{argument}: {kind}"));
        if kind == "Character" {
            let used = mark(is_output(parameter) && parameter.dimension.is_none());
            lengths.push(format!("{used}{argument}_length: usize"));
        }
        if is_output(parameter) && parameter.name != "ERRIND" {
            body.push(clearing(parameter, &argument, kind));
        }
    }
    body.push(match is_inquiry {
        true => format!("errind.set(refusal(Function::{variant}));"),
        false => format!("refuse(Function::{variant});"),
    });
    arguments.extend(lengths);
    let symbol = format!("{}_", name.to_lowercase());
    let _ = writeln!(
        out,
        "\n/// {name}: {}.\n#[unsafe(no_mangle)]\nextern \"C\" fn {symbol}({}) {{\n    {}\n}}",
        function.name,
        arguments.join(", "),
        body.join("\n    ")
    );
}

fn is_output(parameter: &Parameter) -> bool {
    parameter.direction == "out"
}

/// The parameter that says how many elements an array has, where it is not of a fixed size.
fn size(parameter: &Parameter) -> Option<&str> {
    parameter.dimension.as_deref().filter(|d| !d.starts_with(|c: char| c.is_ascii_digit()))
}

/// The statement that sets an output to zero or blanks.
fn clearing(parameter: &Parameter, argument: &str, kind: &str) -> String {
    let count = match (size(parameter), &parameter.dimension) {
        (Some(size), _) => format!("{}.count()", identifier(size)),
        (None, Some(fixed)) => fixed.replace(',', " * "),
        (None, None) => "1".to_owned(),
    };
    match kind {
        "Character" if count == "1" => format!("{argument}.fill({argument}_length, b' ');"),
        "Character" => format!("{argument}.fill({count} * LINE, b' ');"),
        "Real" => format!("{argument}.fill({count}, 0.0);"),
        _ => format!("{argument}.fill({count}, 0);"),
    }
}

/// A Fortran name as a Rust one.
fn identifier(name: &str) -> String {
    match name.to_lowercase().as_str() {
        keyword @ ("type" | "in" | "box" | "mod") => format!("{keyword}_"),
        name => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameter(name: &str, kind: &str, direction: &str, dimension: Option<&str>) -> Parameter {
        Parameter {
            name: name.to_owned(),
            kind: kind.to_owned(),
            direction: direction.to_owned(),
            dimension: dimension.map(str::to_owned),
            enumeration: None,
            meaning: String::new(),
        }
    }

    #[test]
    fn an_inquiry_clears_its_outputs_and_returns_the_error() {
        let mut function = Function::default();
        function.name = "INQUIRE LAMP".to_owned();
        let parameters = [
            parameter("MLDR", "I", "in", None),
            parameter("TYPE", "I", "in", None),
            parameter("ERRIND", "I", "out", None),
            parameter("EAREA", "R", "out", Some("2,3")),
            parameter("DATREC", "C*80", "out", Some("MLDR")),
        ];
        let mut text = String::new();
        write_subroutine(&mut text, &function, "GQLAMP", &parameters);
        let expected = "
/// GQLAMP: INQUIRE LAMP.
#[unsafe(no_mangle)]
extern \"C\" fn gqlamp_(mldr: Integer, _type_: Integer, errind: Integer, earea: Real, datrec: Character, _datrec_length: usize) {
    earea.fill(2 * 3, 0.0);
    datrec.fill(mldr.count() * LINE, b' ');
    errind.set(refusal(Function::InquireLamp));
}
";
        assert_eq!(text, expected);
    }

    #[test]
    fn input_is_to_be_built() {
        let tables = Tables::load(&crate::repository().join("spec")).expect("the tables can be read");
        let built = |name: &str| {
            is_built(tables.functions.iter().find(|f| f.name == name).expect("the function is in the table"))
        };
        assert!(built("POLYLINE"));
        assert!(built("SET PATTERN REPRESENTATION"));
        assert!(built("SET VIEWPORT INPUT PRIORITY"));
        assert!(built("SET VISIBILITY"));
        assert!(built("INQUIRE NAME OF OPEN SEGMENT"));
        assert!(!built("SET PICK IDENTIFIER"));
        assert!(!built("AWAIT EVENT"));
    }
}
