//! The C binding, by programs that check themselves, compiled with gcc and linked with `libgks`.

use gks_tests::program::{self, Linking, assert_good, library, repository, run};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const BOTH: [Linking; 2] = [Linking::Shared, Linking::Static];

/// Whether there is a C compiler; says loudly if there is none.
fn has_compiler() -> bool {
    program::has_compiler("gcc")
}

/// An empty folder for the files of a program.
fn folder(name: &str) -> PathBuf {
    program::folder(env!("CARGO_TARGET_TMPDIR"), "c", name)
}

/// Compiles a program of `programs/c`.
fn compile(folder: &Path, name: &str, linking: Linking) -> PathBuf {
    let program = folder.join(name);
    let sources = repository().join("tests/programs/c");
    let mut compiler = Command::new("gcc");
    compiler.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O1"]);
    compiler.arg("-I").arg(repository().join("bindings/c/include")).arg("-o").arg(&program);
    compiler.arg(sources.join(name).with_extension("c")).arg(sources.join("check.c"));
    program::compile(&mut compiler, linking);
    program
}

/// Compiles and runs a program that checks itself, and gives the folder with the files that it wrote.
fn passes(name: &str, linking: Linking) -> Option<PathBuf> {
    if !has_compiler() {
        return None;
    }
    let folder = folder(&format!("{name}-{linking:?}"));
    assert_good(&run(&compile(&folder, name, linking), &[]));
    Some(folder)
}

/// What the lines of a log say before the colon.
fn beginnings(log: &str) -> Vec<&str> {
    log.lines().map(|line| line.split(':').next().unwrap_or_default()).collect()
}

#[test]
fn workstations_are_opened_and_closed() {
    for linking in BOTH {
        let Some(folder) = passes("control", linking) else { return };
        let picture = fs::read(folder.join("named.png")).expect("the picture");
        assert!(picture.starts_with(b"\x89PNG"));
        assert!(folder.join("gks.png").exists());
    }
}

#[test]
fn attributes_are_inquired_as_they_are_set() {
    passes("attributes", Linking::Shared);
}

#[test]
fn a_metafile_is_written_read_and_interpreted() {
    passes("metafile", Linking::Shared);
}

#[test]
fn primitives_leave_pixels() {
    passes("output", Linking::Shared);
}

#[test]
fn transformations_are_set_and_evaluated() {
    passes("transformation", Linking::Shared);
}

#[test]
fn lists_are_inquired_in_parts() {
    passes("lists", Linking::Shared);
}

#[test]
fn representations_are_inquired_and_stores_hold_results() {
    for linking in BOTH {
        passes("representations", linking);
    }
}

#[test]
fn types_of_workstations_are_described() {
    passes("description", Linking::Shared);
}

#[test]
fn segments_are_made_changed_and_stored() {
    passes("segments", Linking::Shared);
}

#[test]
fn an_error_handler_is_set_and_given_back() {
    for linking in BOTH {
        let Some(folder) = passes("handler", linking) else { return };
        let log = fs::read_to_string(folder.join("errors")).expect("the error file");
        assert_eq!(
            beginnings(&log),
            [
                "GKS ERROR 63 IN SET LINETYPE",
                "GKS ERROR 78 IN SET CHARACTER HEIGHT",
                "GKS ERROR 69 IN SET MARKER TYPE",
                "GKS ERROR 72 IN SET TEXT INDEX",
            ]
        );
        assert!(log.contains("(value -1.5)"), "{log}");
    }
}

#[test]
fn error_functions_of_the_program_win() {
    for linking in BOTH {
        let Some(folder) = passes("replaced", linking) else { return };
        assert!(!folder.join("errors").exists(), "the library has logged too");
    }
}

#[test]
fn errors_are_logged_in_the_error_file() {
    for linking in BOTH {
        if !has_compiler() {
            return;
        }
        let folder = folder(&format!("logged-{linking:?}"));
        let output = run(&compile(&folder, "logged", linking), &[]);
        assert_good(&output);
        assert_eq!(
            beginnings(&String::from_utf8_lossy(&output.stderr)),
            [
                "GKS ERROR 2 IN CLOSE GKS",
                "GKS ERROR 200 IN OPEN GKS",
                "GKS ERROR 63 IN SET LINETYPE",
                "GKS ERROR 93 IN an unknown function",
            ]
        );
        let output = String::from_utf8_lossy(&output.stdout);
        assert_eq!(beginnings(&output), ["first", "GKS ERROR 69 IN SET MARKER TYPE", "good"]);
        let log = fs::read_to_string(folder.join("errors")).expect("the error file");
        assert_eq!(beginnings(&log), ["GKS ERROR 78 IN SET CHARACTER HEIGHT"]);
        let log = fs::read_to_string(folder.join("other")).expect("the other file");
        assert_eq!(beginnings(&log), ["GKS ERROR 92 IN SET FILL AREA COLOUR INDEX"]);
    }
}

#[test]
fn a_program_that_closes_nothing_leaves_a_complete_picture() {
    let Some(folder) = passes("forgotten", Linking::Shared) else { return };
    let picture = fs::read_to_string(folder.join("forgotten.svg")).expect("the picture");
    assert!(picture.trim_end().ends_with("</svg>"), "{picture}");
}

/// Every function of the table is a symbol of the shared library, and so are those of `gks_extra.h`.
#[test]
fn every_name_of_the_standard_is_there() {
    let library = fs::read(library().join("libgks.so")).expect("the shared library");
    let has = |symbol: &str| {
        let name = format!("\0{symbol}\0");
        library.windows(name.len()).any(|bytes| bytes == name.as_bytes())
    };
    let names: Vec<&str> = gks::Function::ALL.iter().filter_map(|f| f.c()).collect();
    assert_eq!(names.len(), 216);
    let missing: Vec<_> = names.iter().filter(|name| !has(name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
    assert!(has("ginq_pat_size") && has("gks_frame_buffer"));
    assert!(!has("ginq_lamp"));
}

/// C++ programs include the headers, too.
#[test]
fn the_headers_are_cpp() {
    if !program::has_compiler("g++") {
        return;
    }
    let source = folder("cpp").join("headers.cpp");
    fs::write(&source, "#include <gks_extra.h>\n").expect("the program can be written");
    let include = repository().join("bindings/c/include");
    let compiled = Command::new("g++")
        .args(["-std=c++11", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I"])
        .args([&include, &source])
        .output()
        .expect("g++ runs");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
}

#[test]
fn a_script_operates_input_devices() {
    if !has_compiler() {
        return;
    }
    // The program in Fortran has the same operator.
    let script = repository().join("tests/programs/f/input.txt");
    let program = compile(&folder("input"), "input", Linking::Shared);
    assert_good(&run(&program, &[("GKS_SCRIPT", &script.to_string_lossy())]));
}
