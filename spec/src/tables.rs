//! The tables of `spec/`, as Rust values: what the TOML files say and nothing else.

mod ctype;
mod element;
mod number;
mod state;

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde::de::DeserializeOwned;

pub(crate) use ctype::{Macros, Structure, Types};
pub(crate) use element::{Element, Elements};
pub(crate) use number::{Hatch, Numbers};
pub(crate) use state::{Entry, States};

/// All tables together.
#[derive(Debug, Clone)]
pub(crate) struct Tables {
    pub(crate) functions: Vec<Function>,
    pub(crate) errors: Vec<Error>,
    pub(crate) error_categories: Vec<ErrorCategory>,
    pub(crate) enumerations: Enumerations,
    pub(crate) states: States,
    pub(crate) types: Types,
    pub(crate) numbers: Numbers,
    pub(crate) elements: Elements,
}

impl Tables {
    /// Reads the tables below the folder `spec`; the message of an error names the file and the line.
    pub(crate) fn load(spec: &Path) -> Result<Self, String> {
        let functions: FunctionFile = read(&spec.join("gks/functions.toml"))?;
        let errors: ErrorFile = read(&spec.join("gks/errors.toml"))?;
        Ok(Self {
            functions: functions.function,
            errors: errors.error,
            error_categories: errors.category,
            enumerations: read(&spec.join("gks/enumerations.toml"))?,
            states: read(&spec.join("gks/states.toml"))?,
            types: read(&spec.join("gks/types.toml"))?,
            numbers: read(&spec.join("numbers.toml"))?,
            elements: read(&spec.join("cgm/elements.toml"))?,
        })
    }
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<T, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    toml::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FunctionFile {
    function: Vec<Function>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ErrorFile {
    category: Vec<ErrorCategory>,
    error: Vec<Error>,
}

/// A function of the standard or of a language binding.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Function {
    pub(crate) name: String,
    pub(crate) category: String,
    pub(crate) level: String,
    pub(crate) rust: Option<String>,
    pub(crate) sample: Option<String>,
    pub(crate) sample_error: Option<i32>,
    pub(crate) awaits: Option<String>,
    pub(crate) c: Option<String>,
    pub(crate) prototype: Option<String>,
    pub(crate) confirmed: Option<bool>,
    #[serde(rename = "prototype_note")]
    _prototype_note: Option<String>,
    pub(crate) fortran: Vec<String>,
    #[serde(default)]
    pub(crate) fortran_split: Vec<String>,
    pub(crate) id: Option<i32>,
    pub(crate) states: Vec<String>,
    pub(crate) errors: Vec<i32>,
    #[serde(default)]
    pub(crate) fortran_errors: Vec<i32>,
    #[serde(rename = "note")]
    _note: Option<String>,
    #[serde(default)]
    pub(crate) unreachable: BTreeMap<String, String>,
    #[serde(default)]
    pub(crate) parameters: BTreeMap<String, Vec<Parameter>>,
}

/// A parameter of a Fortran subroutine.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Parameter {
    pub(crate) name: String,
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) direction: String,
    pub(crate) dimension: Option<String>,
    pub(crate) enumeration: Option<String>,
    pub(crate) meaning: String,
}

/// An error number with its text.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Error {
    pub(crate) number: i32,
    pub(crate) category: String,
    pub(crate) text: String,
    /// The test that provokes it, where no function lists it.
    pub(crate) provoked_by: Option<String>,
    /// Why this library never reports it.
    pub(crate) never: Option<String>,
    #[serde(rename = "note")]
    _note: Option<String>,
}

/// A category of error numbers that this library never reports, and why.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ErrorCategory {
    pub(crate) name: String,
    pub(crate) never: String,
}

/// The enumerations and the numbers that have names.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Enumerations {
    pub(crate) aspects: Vec<Aspect>,
    pub(crate) enumeration: Vec<Enumeration>,
    pub(crate) named_numbers: Vec<NumberGroup>,
    pub(crate) demonstration_numbers: Vec<NumberGroup>,
    pub(crate) dialect_workstation_types: Vec<DialectTypes>,
}

/// One of the 13 aspects that have a source flag.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Aspect {
    pub(crate) name: String,
    pub(crate) c: String,
    pub(crate) xgks: String,
}

/// An enumeration.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Enumeration {
    pub(crate) name: String,
    pub(crate) rust: String,
    pub(crate) c: String,
    #[serde(rename = "confirmed")]
    _confirmed: bool,
    #[serde(rename = "note")]
    _note: Option<String>,
    pub(crate) values: Vec<Value>,
}

/// Integers with names, not an enumeration: linetypes, marker types.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct NumberGroup {
    pub(crate) name: String,
    #[serde(rename = "note")]
    _note: Option<String>,
    pub(crate) values: Vec<Value>,
}

/// A value of an enumeration, with its names.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Value {
    pub(crate) value: i32,
    pub(crate) rust: Option<String>,
    pub(crate) fortran: OneOrMore,
    pub(crate) c: Option<String>,
    #[serde(rename = "xgks")]
    _xgks: Option<String>,
    #[serde(rename = "xgks_value")]
    _xgks_value: Option<i32>,
    #[serde(rename = "gr")]
    _gr: Option<String>,
}

/// One name or several.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(crate) enum OneOrMore {
    One(String),
    More(Vec<String>),
}

impl OneOrMore {
    /// The names, in order.
    pub(crate) fn names(&self) -> &[String] {
        match self {
            Self::One(name) => std::slice::from_ref(name),
            Self::More(names) => names,
        }
    }
}

/// Workstation type numbers of another implementation.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DialectTypes {
    pub(crate) dialect: String,
    pub(crate) values: Vec<DialectType>,
}

/// A range of them.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DialectType {
    pub(crate) first: i32,
    pub(crate) last: i32,
    pub(crate) meaning: String,
    #[serde(rename = "gr")]
    _gr: Option<String>,
}
