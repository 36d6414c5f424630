//! The Fortran binding, by programs that check themselves, compiled with gfortran and linked with `libgks`.

use gks_tests::program::{self, Linking, assert_good, library, repository, run};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Whether there is a Fortran compiler; says loudly if there is none.
fn has_compiler() -> bool {
    program::has_compiler("gfortran")
}

/// An empty folder for the files of a program.
fn folder(name: &str) -> PathBuf {
    program::folder(env!("CARGO_TARGET_TMPDIR"), "fortran", name)
}

/// Compiles a program of `programs/f` from its sources, the first of which gives the name.
fn compile(folder: &Path, sources: &[&str], linking: Linking) -> PathBuf {
    let program = folder.join(sources[0]);
    let mut compiler = Command::new("gfortran");
    compiler.args(["-std=f2008", "-fimplicit-none", "-ffixed-form", "-O1"]);
    compiler.arg("-I").arg(repository().join("bindings/fortran/include")).arg("-o").arg(&program);
    for source in sources {
        compiler.arg(repository().join("tests/programs/f").join(source).with_extension("f"));
    }
    program::compile(&mut compiler, linking);
    program
}

/// Compiles and runs a program that checks itself, and gives the folder with the files that it wrote.
fn passes(sources: &[&str], linking: Linking, environment: &[(&str, &str)]) -> Option<PathBuf> {
    if !has_compiler() {
        return None;
    }
    let folder = folder(&format!("{}-{linking:?}", sources[0]));
    let sources = [sources, &["check"]].concat();
    let output = run(&compile(&folder, &sources, linking), environment);
    assert_good(&output);
    Some(folder)
}

fn passes_shared(sources: &[&str]) {
    passes(sources, Linking::Shared, &[]);
}

#[test]
fn attributes_are_inquired_as_they_are_set() {
    passes_shared(&["attributes"]);
}

#[test]
fn arguments_outside_of_their_enumerations_are_refused() {
    passes_shared(&["enumerations", "recorder"]);
}

#[test]
fn lists_are_inquired_by_element() {
    passes_shared(&["lists"]);
}

#[test]
fn text_is_taken_as_it_is() {
    passes_shared(&["strings"]);
}

#[test]
fn data_records_are_packed_and_unpacked() {
    passes_shared(&["data_records", "recorder"]);
}

#[test]
fn parts_of_arrays_are_drawn_and_read_back() {
    passes_shared(&["pixels", "recorder"]);
}

#[test]
fn segments_are_made_changed_and_stored() {
    passes_shared(&["segments", "recorder"]);
}

#[test]
fn an_error_handler_of_the_program_wins() {
    for linking in [Linking::Shared, Linking::Static] {
        let Some(folder) = passes(&["handler"], linking, &[]) else { return };
        let log = fs::read_to_string(folder.join("fort.19")).expect("the handler logs");
        assert_eq!(log.matches("GKS ERROR 92 IN SET POLYLINE COLOUR INDEX").count(), 1, "{log}");
        assert_eq!(log.lines().count(), 1, "{log}");
    }
}

#[test]
fn an_error_logger_of_the_program_wins() {
    for linking in [Linking::Shared, Linking::Static] {
        let Some(folder) = passes(&["logger"], linking, &[]) else { return };
        assert!(!folder.join("fort.19").exists(), "the library has logged too");
    }
}

#[test]
fn errors_are_logged_in_the_error_file() {
    for linking in [Linking::Shared, Linking::Static] {
        if !has_compiler() {
            return;
        }
        let folder = folder(&format!("logged-{linking:?}"));
        let output = run(&compile(&folder, &["logged", "check"], linking), &[]);
        let starts = |text: &str| -> Vec<String> {
            text.lines().map(|line| line.split(':').next().unwrap_or_default().trim().to_owned()).collect()
        };
        let errors = String::from_utf8_lossy(&output.stderr);
        let message = "GKS message on workstation 1";
        let expected = ["GKS ERROR 2 IN CLOSE GKS", "GKS ERROR 200 IN OPEN GKS", message, message];
        assert_eq!(starts(&errors), expected);
        assert!(errors.ends_with(": change the pen\nGKS message on workstation 1: and the p\n"), "{errors}");
        assert_eq!(
            starts(&String::from_utf8_lossy(&output.stdout)),
            ["before", "GKS ERROR 69 IN SET MARKER TYPE", "good"]
        );
        let log = fs::read_to_string(folder.join("fort.23")).expect("the error file");
        assert_eq!(starts(&log), ["GKS ERROR 63 IN SET LINETYPE", "GKS ERROR 78 IN SET CHARACTER HEIGHT"]);
        assert!(log.contains("(value -1.5)"), "{log}");
    }
}

#[test]
fn a_program_that_closes_nothing_leaves_a_complete_picture() {
    if !has_compiler() {
        return;
    }
    let folder = folder("forgotten");
    let output = run(&compile(&folder, &["forgotten"], Linking::Shared), &[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let picture = fs::read_to_string(folder.join("gks.5.svg")).expect("the picture");
    assert!(picture.trim_end().ends_with("</svg>"), "{picture}");
}

#[test]
fn gks_is_as_new_after_every_way_of_closing_it() {
    let Some(folder) = passes(&["reopen"], Linking::Shared, &[]) else { return };
    let first = ["GKS ERROR 63 IN SET LINETYPE", "GKS ERROR 66 IN SET POLYMARKER INDEX"];
    let last = "GKS ERROR 65 IN SET LINEWIDTH SCALE FACTOR";
    for round in 1..=4 {
        let log = fs::read_to_string(folder.join(format!("fort.{}", 20 + round))).expect("the error file");
        let heads: Vec<&str> = log.lines().map(|line| line.split(':').next().unwrap_or_default()).collect();
        assert!(heads.starts_with(&first) && heads.len() == 2 + usize::from(round == 3), "{log}");
        assert_eq!(heads.contains(&last), round == 3, "{log}");
        let file = |extension: &str| {
            let name = format!("gks.{round}.{extension}");
            fs::read(folder.join(&name)).unwrap_or_else(|error| panic!("{name}: {error}"))
        };
        assert!(file("png").ends_with(b"IEND\xaeB`\x82"), "picture {round} is not complete");
        // END ITEM: its name, and zeros for its type and its length.
        assert!(file("gksm").ends_with(b"GKSM\0\0\0\0\0\0\0\0"), "metafile {round} is not complete");
    }
}

#[test]
fn utilities_of_ncar_graphics_find_what_they_expect() {
    let environment = [("GKS_DIALECT", "ncar"), ("GKS_WSTYPE", "svg")];
    let Some(folder) = passes(&["ncar", "recorder"], Linking::Shared, &environment) else { return };
    let files = fs::read_dir(&folder).expect("the folder of the program");
    let names: BTreeMap<String, u64> = files
        .filter_map(Result::ok)
        .filter(|file| file.path().extension().is_some_and(|e| e == "svg"))
        .map(|file| (file.file_name().to_string_lossy().into_owned(), file.metadata().map_or(0, |m| m.len())))
        .collect();
    assert_eq!(names.keys().collect::<Vec<_>>(), ["gmeta.svg", "named.svg"]);
    assert!(names.values().all(|&length| length > 100), "{names:?}");
}

#[test]
fn a_metafile_is_written_read_and_interpreted() {
    let Some(folder) = passes(&["metaf"], Linking::Shared, &[]) else { return };
    let file = |name: &str| fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert!(file("gks.7.gksm").starts_with(b"GKSM"));
    assert!(file("gks.8.png") == file("gks.9.png"), "the pictures differ");
}

/// Every subroutine of the table is a symbol of the shared library.
#[test]
fn every_name_of_the_standard_is_there() {
    let library = fs::read(library().join("libgks.so")).expect("the shared library");
    let has = |symbol: &str| {
        let name = format!("\0{symbol}_\0");
        library.windows(name.len()).any(|bytes| bytes == name.as_bytes())
    };
    let names: Vec<String> =
        gks::Function::ALL.iter().flat_map(|f| f.fortran()).map(|name| name.to_lowercase()).collect();
    assert_eq!(names.len(), 220);
    let missing: Vec<_> = names.iter().filter(|name| !has(name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
    assert!(has("gzw2nx") && has("gzw2ny"));
    assert!(!has("gxxxxx"));
}

#[test]
fn a_script_operates_input_devices() {
    let script = repository().join("tests/programs/f/input.txt");
    passes(&["input", "recorder"], Linking::Shared, &[("GKS_SCRIPT", &script.to_string_lossy())]);
}
