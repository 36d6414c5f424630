//! The rows of `gks/types.toml`.

use serde::Deserialize;

/// `types.toml`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Types {
    pub(crate) typedef: Vec<Typedef>,
    pub(crate) structure: Vec<Structure>,
    pub(crate) macros: Vec<Macros>,
    pub(crate) extra_prototype: Vec<Prototype>,
}

/// A type that is neither a structure nor an enumeration.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Typedef {
    pub(crate) name: String,
    pub(crate) declaration: String,
    pub(crate) meaning: String,
}

/// A structure or a union.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Structure {
    pub(crate) name: String,
    pub(crate) kind: Option<String>,
    #[serde(rename = "implementation", default)]
    _implementation: bool,
    #[serde(rename = "confirmed")]
    _confirmed: Option<bool>,
    pub(crate) members: Vec<String>,
    pub(crate) meaning: String,
}

/// Macros for one purpose.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Macros {
    pub(crate) name: String,
    pub(crate) values: Vec<Macro>,
}

/// A macro.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Macro {
    pub(crate) name: String,
    pub(crate) value: String,
}

/// The prototype of a function beyond the standard.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Prototype {
    pub(crate) name: String,
    pub(crate) prototype: String,
    pub(crate) meaning: String,
}
