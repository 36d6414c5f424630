//! Writes `workstations/metafile/src/generated/elements.rs`: the elements of CGM.

use std::fmt::Write as _;

use crate::tables::Tables;

const HEAD: &str = "\
//! The elements of the Computer Graphics Metafile.
//!
//! Written by `gks-spec generate` from `spec/cgm/elements.toml`; do not edit.

use crate::cgm::parameter::Parameter::{self, *};

/// An element and how the encodings write it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Which element.
    pub kind: Kind,
    /// The class in the binary encoding.
    pub class: u8,
    /// The identifier in the class; 127 for what the binary encoding does not write.
    pub id: u8,
    /// The name in the standard.
    pub name: &'static str,
    /// The keyword of the clear text encoding; empty for none.
    pub keyword: &'static str,
    /// The version of the metafile in which it first appears.
    pub version: u8,
    /// The opcode of the character encoding; empty for none.
    pub opcode: &'static [u8],
    /// The parameters.
    pub parameters: &'static [Parameter],
}
";

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let elements = &tables.elements.element;
    let mut out = String::from(HEAD);
    out += "\n/// An element.\n#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]\n";
    out += "#[allow(missing_docs, reason = \"the names are those of the standard\")]\npub enum Kind {\n";
    for element in elements {
        let _ = writeln!(out, "    {},", element.variant());
    }
    out += "}\n\n/// All elements, by class and identifier.\n";
    let _ = writeln!(out, "pub static ELEMENTS: [Row; {}] = [", elements.len());
    for e in elements {
        let opcode: Vec<String> = e.opcode.bytes().map(|byte| format!("{byte:#04x}")).collect();
        let _ = writeln!(
            out,
            "    Row {{ kind: Kind::{}, class: {}, id: {}, name: {:?}, keyword: {:?}, version: {}, opcode: &[{}], \
             parameters: &[{}] }},",
            e.variant(),
            e.class,
            e.id,
            e.name,
            e.keyword,
            e.version,
            opcode.join(", "),
            parameters(&e.parameters).unwrap_or_default(),
        );
    }
    out += "];\n";
    out
}

/// The parameters in Rust, or what cannot be understood.
pub(crate) fn parameters(text: &str) -> Result<String, String> {
    let mut rust = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        let (token, after) = if let Some(list) = rest.strip_prefix('(') {
            let (inner, after) = list.rsplit_once(")*").ok_or("a list without end")?;
            (format!("Repeat(&[{}])", parameters(inner)?), after)
        } else {
            let end = match rest.strip_prefix("E(") {
                Some(words) => 3 + words.find(')').ok_or("an enumeration without end")?,
                None => rest.find(' ').unwrap_or(rest.len()),
            };
            let (token, after) = rest.split_at(end);
            let single = match token.strip_suffix('*') {
                Some(item) => format!("Repeat(&[{}])", parameter(item)?),
                None => parameter(token)?,
            };
            (single, after)
        };
        rust.push(token);
        rest = after.trim_start();
    }
    Ok(rust.join(", "))
}

fn parameter(token: &str) -> Result<String, String> {
    if let Some(words) = token.strip_prefix("E(").and_then(|words| words.strip_suffix(')')) {
        let words: Vec<String> = words.split(',').map(|word| format!("{word:?}")).collect();
        return Ok(format!("Enumeration(&[{}])", words.join(", ")));
    }
    let name = match token {
        "I" => "Integer",
        "IX" => "Index",
        "N" => "Name",
        "R" => "Real",
        "VDC" => "Coordinate",
        "P" => "Point",
        "S" => "Text",
        "D" => "Data",
        "CI" => "ColourIndex",
        "CD" => "DirectColour",
        "CO" => "Colour",
        "CCO" => "Component",
        "VC" => "Viewport",
        "LW" => "LineWidth",
        "MS" => "MarkerSize",
        "EW" => "EdgeWidth",
        "SS" => "StyleSize",
        "metric" => "Metric",
        "precision" => "Precision",
        "elements" => "ElementList",
        "cells" => "Cells",
        "pattern" => "Pattern",
        "counted" => "CountedPoints",
        "spline" => "Spline",
        "rational" => "RationalSpline",
        "bits" => "Bits",
        "raw" => "Raw",
        other => return Err(format!("unknown parameter {other:?}")),
    };
    Ok(name.to_owned())
}

#[cfg(test)]
mod tests {
    use super::parameters;

    #[test]
    fn lists_and_words_are_read() {
        assert_eq!(
            parameters("P E(off,on) S"),
            Ok("Point, Enumeration(&[\"off\", \"on\"]), Text".to_owned())
        );
        let list = "Index, Repeat(&[Point, Enumeration(&[\"a\"])])";
        assert_eq!(parameters("IX (P E(a))*"), Ok(list.to_owned()));
        assert_eq!(parameters("P*"), Ok("Repeat(&[Point])".to_owned()));
        assert!(parameters("Q").is_err() && parameters("(P").is_err() && parameters("E(a").is_err());
    }
}
