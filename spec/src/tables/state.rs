//! The rows of `gks/states.toml`.

use std::collections::BTreeMap;

use serde::Deserialize;

/// `states.toml`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct States {
    pub(crate) operating_state: Vec<OperatingState>,
    pub(crate) table: Vec<Table>,
    pub(crate) least_support: BTreeMap<String, [i32; 3]>,
    #[serde(rename = "least_input_support")]
    _least_input_support: BTreeMap<String, [i32; 3]>,
}

/// An operating state.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct OperatingState {
    pub(crate) name: String,
    #[serde(rename = "meaning")]
    _meaning: String,
    pub(crate) entered_by: Vec<String>,
    #[serde(rename = "note")]
    _note: Option<String>,
}

/// A state list or description table.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Table {
    pub(crate) name: String,
    pub(crate) created_by: String,
    pub(crate) entries: Vec<Entry>,
}

/// An entry of a state list or description table.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Entry {
    pub(crate) name: String,
    #[serde(rename = "type")]
    pub(crate) kind: Option<String>,
    pub(crate) enumeration: Option<String>,
    pub(crate) space: Option<String>,
    pub(crate) initial: Option<String>,
    #[serde(default)]
    pub(crate) set_by: Vec<String>,
    #[serde(default)]
    pub(crate) inquiry: Vec<String>,
    #[serde(default)]
    pub(crate) categories: Vec<String>,
    pub(crate) level: Option<String>,
    #[serde(rename = "note")]
    _note: Option<String>,
}
