//! Instruction counts of a few kernels against those that were accepted: a change that makes one of them dearer
//! by a tenth does not go unnoticed.
//!
//! Valgrind counts, so that neither the load nor the speed of the machine matters; vector instructions that only
//! some processors have are switched off in the C library. Another version of the compiler makes other
//! instructions: then growth is told, but is no failure.

use crate::Failure;
use crate::kernel::KERNELS;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

/// How much dearer a kernel may become.
const TOLERANCE: f64 = 1.10;

/// The counts that were accepted.
#[derive(Debug, Serialize, Deserialize)]
struct Accepted {
    /// The compiler that made the program.
    rustc: String,
    /// Instructions of each kernel.
    instructions: BTreeMap<String, u64>,
}

/// Counts, compares with the accepted counts, or accepts what has been counted.
pub(crate) fn run(accept: bool) -> Result<ExitCode, Failure> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("instructions.toml");
    let version = Command::new("rustc").arg("--version").output()?;
    let rustc = String::from_utf8(version.stdout)?.trim().to_owned();
    let mut instructions = BTreeMap::new();
    for kernel in KERNELS {
        instructions.insert(kernel.name.to_owned(), count(kernel.name)?);
    }
    if accept {
        let text = toml::to_string_pretty(&Accepted { rustc, instructions })?;
        fs::write(&file, format!("# Written by tests/bench/instructions --accept.\n\n{text}"))?;
        return Ok(ExitCode::SUCCESS);
    }
    let accepted: Accepted = toml::from_str(&fs::read_to_string(&file)?)?;
    let grown = compare(&accepted.instructions, &instructions);
    if grown.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    eprintln!("more than a tenth dearer: {}", grown.join(", "));
    if rustc == accepted.rustc {
        return Ok(ExitCode::FAILURE);
    }
    eprintln!("accepted with {}, counted with {rustc}: no failure", accepted.rustc);
    Ok(ExitCode::SUCCESS)
}

/// Prints the counts and returns the names of kernels that are too dear or have no accepted count.
fn compare(accepted: &BTreeMap<String, u64>, counted: &BTreeMap<String, u64>) -> Vec<String> {
    let mut grown = Vec::new();
    for (name, &count) in counted {
        let before = accepted.get(name).copied().unwrap_or(0);
        let ratio = count as f64 / before as f64;
        println!("{name:<44} {count:>14} {:>+7.1} %", (ratio - 1.0) * 100.0);
        if ratio > TOLERANCE {
            grown.push(name.clone());
        }
    }
    grown
}

/// The instructions of a kernel.
fn count(name: &str) -> Result<u64, Failure> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--collect-atstart=no"])
        .arg("--toggle-collect=gks_bench::kernel::measured*")
        .arg(std::env::current_exe()?)
        .args(["kernel", name])
        .env("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-AVX,-ERMS")
        .output()
        .map_err(|error| format!("valgrind: {error}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    let collected = text.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok());
    match collected {
        Some(count) if output.status.success() && count > 0 => Ok(count),
        _ => Err(format!("{name} was not counted: {text}").into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_beyond_a_tenth_is_told() {
        let counts = |counts: [(&str, u64); 3]| counts.map(|(name, count)| (name.to_owned(), count)).into();
        let accepted = counts([("a", 100), ("b", 100), ("c", 100)]);
        let counted = counts([("a", 109), ("b", 112), ("d", 1)]);
        assert_eq!(compare(&accepted, &counted), ["b", "d"]);
    }
}
