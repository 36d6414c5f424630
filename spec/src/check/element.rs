//! Checks `cgm/elements.toml`: codes and names must be unique, parameters must be known.

use super::unique;
use crate::elements::parameters;
use crate::tables::{Element, Tables};

/// Adds what is wrong with the elements of CGM.
pub(super) fn check(tables: &Tables, faults: &mut Vec<String>) {
    let elements = &tables.elements.element;
    unique("element", elements.iter().map(|e| format!("{}.{}", e.class, e.id)), faults);
    unique("element", elements.iter().map(Element::variant), faults);
    if !elements.is_sorted_by_key(|e| (e.class, e.id)) {
        faults.push("the elements do not stand in the order of their codes".to_owned());
    }
    let named = |text: &&str| !text.is_empty();
    unique("keyword", elements.iter().map(|e| e.keyword.as_str()).filter(named), faults);
    unique("opcode", elements.iter().map(|e| e.opcode.as_str()).filter(named), faults);
    for element in elements {
        if element.class > 14 || element.id > 127 || !(1..=4).contains(&element.version) {
            faults.push(format!("{}: class, identifier or version out of range", element.name));
        }
        if element.opcode.bytes().any(|byte| !(0x20..0x40).contains(&byte)) {
            faults.push(format!("{}: the opcode is not in columns 2 and 3", element.name));
        }
        if let Err(fault) = parameters(&element.parameters) {
            faults.push(format!("{}: {fault}", element.name));
        }
    }
}
