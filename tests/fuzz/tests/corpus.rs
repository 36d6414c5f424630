//! What a fuzzer has found stays harmless.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// The inputs that are kept for a target.
fn inputs(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(target);
    let files = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    assert!(!paths.is_empty(), "no input for {target}");
    paths.sort();
    let read = |path: PathBuf| std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    paths.into_iter().map(read).collect()
}

#[test]
fn every_input_comes_back() {
    for (name, run) in gks_fuzz::TARGETS {
        inputs(name).iter().for_each(|input| gks_fuzz::attempt(*run, input));
    }
}

/// What is fed to the fuzzer reaches more than the checks of arguments.
#[test]
fn every_subroutine_succeeds_for_some_input() {
    let mut failing: BTreeSet<&str> = gks_fuzz::calls::subroutines().collect();
    assert_eq!(failing.len(), 218);
    for input in inputs("calls") {
        gks_fuzz::calls::run_and_tell(&input, |call| {
            if call.good {
                failing.remove(call.name);
            }
            ControlFlow::Continue(())
        });
    }
    assert!(failing.is_empty(), "{failing:?}");
}
