//! Large metafiles are written and played in the memory that small ones take.

use gks_pipeline::generated::numbers::workstation_type as own;
use gks_tests::folder::Folder;
use std::process::Command;

/// What a metafile may take more than another one that is a sixteenth as large, in KiB.
const MORE: u64 = 4096;

/// The peak of the resident memory of the program, in KiB.
fn peak(arguments: &[&str]) -> u64 {
    let run = Command::new(env!("CARGO_BIN_EXE_volume")).args(arguments).output().expect("the program runs");
    assert!(run.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&run.stderr));
    String::from_utf8_lossy(&run.stdout).trim().parse().expect("a number of KiB")
}

fn memory_is_constant(kind: i32, options: &str) {
    let folder = Folder::new(env!("CARGO_TARGET_TMPDIR"), &format!("volume-{kind}"));
    let [(written, played), (written_large, played_large)] = ["2", "32"].map(|mib| {
        let file = folder.file(&format!("{mib}.metafile"));
        let written = peak(&["write", &kind.to_string(), &format!("{file}{options}"), mib]);
        (written, peak(&["play", &file]))
    });
    assert!(written_large < written + MORE, "writing takes {written} and {written_large} KiB");
    assert!(played_large < played + MORE, "playing takes {played} and {played_large} KiB");
}

#[test]
fn gksm_takes_constant_memory() {
    memory_is_constant(own::GKSM, "");
}

#[test]
fn binary_cgm_takes_constant_memory() {
    memory_is_constant(own::CGM, "?vdc=real");
}
