//! Writes `tests/conformance/generated.rs`: a valid call of every function that the kernel has.

use std::fmt::Write as _;

use crate::function::variant;
use crate::tables::{Function, Tables};

const HEAD: &str = "\
//! A valid call of every function of the kernel, and the errors that no call can provoke.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

use super::*;

pub(crate) static SAMPLES: &[Sample] = &[
";

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let mut out = String::from(HEAD);
    for function in tables.functions.iter().filter(|function| function.awaits.is_none()) {
        write_sample(&mut out, function);
    }
    out += "];\n";
    out
}

fn write_sample(out: &mut String, function: &Function) {
    let (Some(method), Some(sample)) = (&function.rust, &function.sample) else { return };
    let (parameter, number, arguments) = match subject(sample).filter(|_| has_subject(function)) {
        Some((number, rest)) => ("subject", number, format!("subject{rest}")),
        None => ("_", 0, sample.clone()),
    };
    let call = if function.errors.is_empty() {
        format!("{{ gks.{method}({arguments}); Ok(()) }}")
    } else {
        format!("gks.{method}({arguments}).map(drop)")
    };
    let _ = writeln!(
        out,
        "    Sample {{\n        function: Function::{},\n        subject: {number},\n        \
         call: |gks, {parameter}| {call},\n        error: {},",
        variant(&function.name),
        function.sample_error.unwrap_or(0)
    );
    let reasons: Vec<String> =
        function.unreachable.iter().map(|(error, reason)| format!("({error}, {reason:?})")).collect();
    let _ = writeln!(out, "        unreachable: &[{}],\n    }},", reasons.join(", "));
}

/// Whether the function is about a workstation or a workstation type, which is its first parameter then.
pub(crate) fn has_subject(function: &Function) -> bool {
    function.errors.contains(&20) || function.errors.contains(&22)
}

/// The first argument of a sample if it is a number, and what follows it.
pub(crate) fn subject(sample: &str) -> Option<(i32, &str)> {
    let end = sample.find(',').unwrap_or(sample.len());
    let (first, rest) = sample.split_at(end);
    first.parse().ok().map(|number| (number, rest))
}
