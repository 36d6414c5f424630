//! The libraries that stand in for XGKS and for the GKS of GR: their symbols, and that their names draw what those of
//! ISO draw.

use gks_tests::program::{self, has_compiler, repository, run};
use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// The folder of the libraries, which are built if they are not up to date.
fn libraries() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let built = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(["build", "--quiet", "--package", "gks-xgks", "--package", "gks-gr", "--package", "libgks"])
            .current_dir(repository())
            .output()
            .expect("cargo runs");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        program::library().to_owned()
    })
}

/// The symbols that a shared library defines for others.
fn exported(library: &Path) -> BTreeSet<String> {
    let listed = Command::new("nm").args(["-D", "--defined-only"]).arg(library).output().expect("nm runs");
    assert!(listed.status.success(), "{}", String::from_utf8_lossy(&listed.stderr));
    let lines = String::from_utf8_lossy(&listed.stdout);
    lines.lines().filter_map(|line| line.split_whitespace().nth(2)).map(str::to_owned).collect()
}

/// The names that a library promises in its list and does not have.
fn missing(name: &str, library: &str) -> Vec<String> {
    let list = repository().join("bindings/compat").join(name).join("symbols.txt");
    let promised = fs::read_to_string(list).expect("the list of symbols");
    let exported = exported(&libraries().join(library));
    promised.lines().filter(|name| !exported.contains(*name)).map(str::to_owned).collect()
}

#[cfg(target_os = "linux")]
#[test]
fn the_libraries_have_all_symbols_of_their_lists() {
    if !has_compiler("nm") {
        return;
    }
    assert_eq!(missing("xgks", "libxgks_gfortran.so"), [""; 0]);
    assert_eq!(missing("gr", "libGKS.so"), [""; 0]);
}

/// Compiles a program of `programs/compat` with the header and the library of its binding, runs it, and gives the
/// picture that it wrote.
fn picture(name: &str, include: &str, library: &str) -> Vec<u8> {
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "compat", name);
    let program = folder.join(name);
    let mut compiler = Command::new("gcc");
    compiler.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror"]);
    compiler.arg("-I").arg(repository().join("bindings").join(include)).arg("-o").arg(&program);
    compiler.arg(repository().join("tests/programs/compat").join(name).with_extension("c"));
    // Programs look for a library by the name that is in it, so that this one gets a link of that name.
    compiler.arg(libraries().join(library)).arg("-lm");
    let compiled = compiler.output().expect("the compiler runs");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    #[cfg(unix)]
    std::os::unix::fs::symlink(libraries().join("libxgks_gfortran.so"), folder.join("libxgks-gfortran.so.2"))
        .expect("a link to the library");
    let path = env::join_paths([folder.as_path(), libraries()]).expect("folders without colons");
    let path = path.to_str().expect("folders in UTF-8");
    let output = run(&program, &[("LD_LIBRARY_PATH", path)]);
    assert!(output.status.success(), "{name}: {output:?}");
    if name == "xgks" {
        let said = String::from_utf8_lossy(&output.stdout);
        assert!(said.starts_with("SET LINETYPE   63 "), "{said}");
    }
    fs::read(folder.join(name).with_extension("png")).expect("the picture")
}

#[cfg(target_os = "linux")]
#[test]
fn all_bindings_to_c_draw_the_same_figure() {
    if !has_compiler("gcc") {
        return;
    }
    let iso = picture("iso", "c/include", "libgks.so");
    assert!(iso.starts_with(b"\x89PNG") && iso.len() > 4000);
    assert!(picture("xgks", "compat/xgks/include", "libxgks_gfortran.so") == iso, "XGKS differs from ISO");
    assert!(picture("gr", "compat/gr/include", "libGKS.so") == iso, "GR differs from ISO");
}
