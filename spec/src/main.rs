//! Checks the tables of the standards and copies them out into the sources that need them.
//!
//! `gks-spec generate` writes the generated files, `gks-spec check` looks for contradictions in the tables and for
//! generated files that are not up to date, and ends with status 1 if it finds any.

mod check;
mod coverage;
mod elements;
mod error_numbers;
mod error_text;
mod fortran_include;
mod function;
mod fuzz_calls;
mod header;
mod numbers;
mod samples;
mod tables;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use tables::Tables;

type Generator = fn(&Tables) -> String;

/// The generated files, as paths from the top of the repository, and what writes them.
const OUTPUTS: &[(&str, Generator)] = &[
    ("kernel/gks/src/generated/mod.rs", |_| {
        module("Copied out of the tables in `spec/gks`.", &["error_text", "function"])
    }),
    ("kernel/gks/src/generated/function.rs", function::generate),
    ("kernel/gks/src/generated/error_text.rs", error_text::generate),
    ("kernel/pipeline/src/generated/mod.rs", |_| module("Copied out of `spec/numbers.toml`.", &["numbers"])),
    ("kernel/pipeline/src/generated/numbers.rs", numbers::generate),
    ("bindings/cli/src/generated/mod.rs", |_| {
        module("Copied out of the tables in `spec` and the sources.", &["coverage", "error_numbers"])
    }),
    ("bindings/cli/src/generated/coverage.rs", coverage::generate),
    ("bindings/cli/src/generated/error_numbers.rs", error_numbers::generate),
    ("bindings/c/include/gks.h", header::generate),
    ("bindings/fortran/include/gks.inc", fortran_include::generate),
    ("bindings/fortran/include/gkspar.inc", fortran_include::generate_demonstration),
    ("workstations/metafile/src/generated/mod.rs", |_| {
        module("Copied out of the tables in `spec/cgm`.", &["elements"])
    }),
    ("workstations/metafile/src/generated/elements.rs", elements::generate),
    ("tests/conformance/generated.rs", samples::generate),
    ("tests/fuzz/src/generated.rs", fuzz_calls::generate),
];

fn main() -> ExitCode {
    let root = repository();
    let command = std::env::args().nth(1).unwrap_or_default();
    let result =
        Tables::load(&root.join("spec")).map_err(|e| vec![e]).and_then(|tables| match command.as_str() {
            "generate" => generate(&root, &tables).map_err(|e| vec![e]),
            "check" => sound(&root, &tables),
            _ => Err(vec!["usage: gks-spec check | generate".to_owned()]),
        });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(messages) => {
            for message in messages {
                eprintln!("{message}");
            }
            ExitCode::FAILURE
        }
    }
}

/// The top of the repository.
fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_path_buf).unwrap_or_default()
}

fn generate(root: &Path, tables: &Tables) -> Result<(), String> {
    for (path, generator) in OUTPUTS {
        let path = root.join(path);
        let text = generator(tables);
        if std::fs::read_to_string(&path).is_ok_and(|old| old == text) {
            continue;
        }
        let folder = path.parent().unwrap_or(root);
        std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        std::fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    Ok(())
}

/// Checks the tables, then whether the generated files are up to date.
fn sound(root: &Path, tables: &Tables) -> Result<(), Vec<String>> {
    let mut faults = check::check(tables);
    for (path, generator) in OUTPUTS {
        if !std::fs::read_to_string(root.join(path)).is_ok_and(|text| text == generator(tables)) {
            faults.push(format!("{path} is not up to date: run `cargo run -p gks-spec -- generate`"));
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

/// The text of a `mod.rs` of generated modules.
fn module(doc: &str, names: &[&str]) -> String {
    let mut out = format!("//! {doc}\n//!\n//! Written by `gks-spec generate`; do not edit.\n");
    for name in names {
        out += &format!("\n#[rustfmt::skip]\npub mod {name};\n");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_generated_files_are_up_to_date() {
        let root = repository();
        let tables = Tables::load(&root.join("spec")).expect("the tables can be read");
        assert_eq!(sound(&root, &tables), Ok(()));
    }

    #[test]
    fn a_stale_file_is_found() {
        let root = std::env::temp_dir().join("gks-spec-stale");
        let tables = Tables::load(&repository().join("spec")).expect("the tables can be read");
        generate(&root, &tables).expect("the files can be written");
        assert_eq!(sound(&root, &tables), Ok(()));
        let path = root.join(OUTPUTS[1].0);
        std::fs::write(&path, "// changed by hand").expect("the file can be written");
        let faults = sound(&root, &tables).expect_err("the file is stale");
        assert!(faults.len() == 1 && faults[0].contains("function.rs is not up to date"), "{faults:?}");
        std::fs::remove_dir_all(root).expect("the folder can be removed");
    }
}
