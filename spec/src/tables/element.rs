//! The rows of `cgm/elements.toml`.

use serde::Deserialize;

/// The elements of the Computer Graphics Metafile.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Elements {
    pub(crate) element: Vec<Element>,
}

/// An element.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Element {
    pub(crate) class: u8,
    pub(crate) id: u8,
    pub(crate) name: String,
    pub(crate) keyword: String,
    pub(crate) version: u8,
    #[serde(default)]
    pub(crate) opcode: String,
    #[serde(default)]
    pub(crate) parameters: String,
}

impl Element {
    /// The name as a variant in Rust.
    pub(crate) fn variant(&self) -> String {
        let words = self.name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        words.map(|word| word[..1].to_uppercase() + &word[1..].to_lowercase()).collect()
    }
}
