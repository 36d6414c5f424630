//! Writes `bindings/c/src/generated/unbuilt.rs`: the C functions of the levels of GKS that are still to be built.
//!
//! A program that calls them can be linked; the call reports that its level is not built.

use std::fmt::Write as _;

use crate::function::variant;
use crate::tables::Tables;
use crate::wrappers::is_built;

const HEAD: &str = "\
//! The functions of the levels of GKS that are not built yet.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

use crate::argument::Out;
use crate::types::*;
use crate::unbuilt::{refuse, refusal};
use gks::Function;
use std::ffi::{c_char, c_void};
";

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut out = String::from(HEAD);
    for function in tables.functions.iter().filter(|f| !is_built(f)) {
        if let (Some(name), Some(prototype)) = (&function.c, &function.prototype) {
            write_function(&mut out, &function.name, name, &parameters(prototype));
        }
    }
    out
}

/// A parameter of a C function.
#[derive(Debug, PartialEq)]
struct Parameter {
    name: String,
    /// The type without `const` and without asterisks.
    kind: String,
    /// The number of asterisks, 1 for an array.
    pointers: usize,
    constant: bool,
}

/// The parameters of a prototype without parameters that are functions.
fn parameters(prototype: &str) -> Vec<Parameter> {
    let list = prototype.split_once('(').map_or("", |(_, rest)| rest.trim_end_matches(')'));
    list.split(',').map(str::trim).filter(|text| !matches!(*text, "" | "void")).map(parameter).collect()
}

fn parameter(text: &str) -> Parameter {
    let constant = text.starts_with("const ");
    let text = text.trim_start_matches("const ");
    let (kind, name) = text.split_once(' ').unwrap_or((text, ""));
    // A matrix is an array.
    let pointers = name.matches('*').count() + usize::from(kind == "Gtran_matrix" || name.contains('['));
    let name = name.trim_start_matches('*').split('[').next().unwrap_or_default();
    Parameter { name: name.to_owned(), kind: kind.to_owned(), pointers, constant }
}

impl Parameter {
    /// A result; a store is the room for one.
    fn is_result(&self) -> bool {
        self.pointers > 0 && !self.constant && self.kind != "Gstore"
    }

    /// The type in Rust.
    fn rust(&self) -> String {
        let kind = match self.kind.as_str() {
            "Gdouble" | "Gfloat" | "Gpoint" | "Gvec" | "Glimit" | "Gpick" | "Gnum_in" | "Gseg_attrs"
            | "Gdyn_mod_seg_attrs" | "Gint_list" | "Gpoint_list" | "Gtran_matrix" => self.kind.as_str(),
            "char" => "c_char",
            // An enumeration is passed as an integer.
            _ => "Gint",
        };
        match self.pointers {
            0 => kind.to_owned(),
            1 if self.is_result() => format!("Out<{kind}>"),
            2 if self.is_result() => "Out<*mut c_void>".to_owned(),
            _ => "*const c_void".to_owned(),
        }
    }

    /// The statement that sets a result to zero, a list to an empty one.
    fn clearing(&self) -> String {
        match (self.pointers, self.kind.as_str()) {
            (1, "Gint_list" | "Gpoint_list") => format!("{}.count().clear();", self.name),
            _ => format!("{}.clear();", self.name),
        }
    }
}

fn write_function(out: &mut String, function: &str, name: &str, parameters: &[Parameter]) {
    let variant = variant(function);
    let is_inquiry = parameters.iter().any(|p| p.name == "err_ind");
    let arguments: Vec<String> = parameters
        .iter()
        .map(|p| {
            let mark = if p.is_result() { "" } else { "_" };
            format!("{mark}{}: {}", p.name, p.rust())
        })
        .collect();
    let results = parameters.iter().filter(|p| p.is_result() && p.name != "err_ind");
    let mut body: Vec<String> = results.map(Parameter::clearing).collect();
    body.push(match is_inquiry {
        true => format!("err_ind.set(refusal(Function::{variant}));"),
        false => format!("refuse(Function::{variant});"),
    });
    let _ = writeln!(
        out,
        "\n/// {function}.\n#[unsafe(no_mangle)]\nextern \"C\" fn {name}({}) {{\n    {}\n}}",
        arguments.join(", "),
        body.join("\n    ")
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inquiry_clears_its_results_and_returns_the_error() {
        let prototype = "void ginq_lamp(Gint ws_id, const Gpoint *pos, Gstore *store, Gint *err_ind, \
                         Gop_mode *op_mode, Gint_list *lamps, Gdouble low_value, char *text, Gloc_data **data)";
        let mut text = String::new();
        write_function(&mut text, "INQUIRE LAMP", "ginq_lamp", &parameters(prototype));
        let expected = "
/// INQUIRE LAMP.
#[unsafe(no_mangle)]
extern \"C\" fn ginq_lamp(_ws_id: Gint, _pos: *const c_void, _store: *const c_void, err_ind: Out<Gint>, \
op_mode: Out<Gint>, lamps: Out<Gint_list>, _low_value: Gdouble, text: Out<c_char>, data: Out<*mut c_void>) {
    op_mode.clear();
    lamps.count().clear();
    text.clear();
    data.clear();
    err_ind.set(refusal(Function::InquireLamp));
}
";
        assert_eq!(text, expected);
    }

    #[test]
    fn matrices_and_empty_lists_are_parameters_too() {
        assert_eq!(parameters("void gclose_seg(void)"), []);
        let [name, matrix] =
            &parameters("void gset_seg_tran(Gint seg_name, const Gtran_matrix tran_matrix)")[..]
        else {
            panic!("two parameters")
        };
        assert_eq!((name.rust(), name.is_result()), ("Gint".to_owned(), false));
        assert_eq!((matrix.rust(), matrix.is_result()), ("*const c_void".to_owned(), false));
    }
}
