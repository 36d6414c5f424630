//! Faults from outside: what was complete stays, the rest is an error of the standard and not the end of the
//! program.

use gks_tests::program::{self, Linking, repository};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// Compiles the program of the faults in an empty folder.
fn compiled(name: &str) -> Option<(PathBuf, PathBuf)> {
    if !program::has_compiler("gcc") {
        return None;
    }
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "faults", name);
    let program = folder.join("faults");
    let mut compiler = Command::new("gcc");
    compiler.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-O1"]);
    compiler.arg("-I").arg(repository().join("bindings/c/include")).arg("-o").arg(&program);
    compiler.arg(repository().join("tests/programs/c/faults.c"));
    program::compile(&mut compiler, Linking::Static);
    Some((folder, program))
}

fn start(folder: &Path, program: &Path, fault: &str) -> Child {
    let mut command = Command::new(program);
    command.arg(fault).current_dir(folder).stdout(Stdio::piped()).stdin(Stdio::null());
    command.env_clear().spawn().expect("the program starts")
}

fn files(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder");
    let mut names: Vec<String> =
        entries.map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_pipe_without_reader_is_error_303_and_the_other_picture_is_whole() {
    let Some((folder, program)) = compiled("pipe") else { return };
    let mut child = start(&folder, &program, "pipe");
    let mut beginning = [0; 100];
    child.stdout.take().expect("the pipe").read_exact(&mut beginning).expect("the beginning of a picture");
    let status = child.wait().expect("the program ends");
    assert!(status.success(), "{status}");
    let log = fs::read_to_string(folder.join("errors")).expect("the error file");
    assert!(log.contains("303"), "{log}");
    let other = fs::read_to_string(folder.join("whole.svg")).expect("the other picture");
    assert!(other.trim_end().ends_with("</svg>"), "cut off");
    assert!(beginning.starts_with(&other.as_bytes()[..20]));
}

#[test]
fn a_program_that_is_killed_leaves_the_complete_pages_and_no_half_ones() {
    let Some((folder, program)) = compiled("killed") else { return };
    let status = start(&folder, &program, "killed").wait().expect("the program ends");
    assert!(!status.success());
    let names = files(&folder);
    for page in 1..=3 {
        for name in [format!("page.{page}.png"), svg_page(page)] {
            assert!(names.contains(&name), "{name} is missing: {names:?}");
        }
        let picture = fs::read(folder.join(format!("page.{page}.png"))).expect("a page");
        image::load_from_memory(&picture).expect("a whole picture");
        let picture = fs::read_to_string(folder.join(svg_page(page))).expect("a page");
        assert!(picture.trim_end().ends_with("</svg>"));
    }
    assert!(!names.contains(&"page.4.png".to_owned()) && !names.contains(&svg_page(4)), "{names:?}");
}

/// The name of a page of the picture that has no number in its name.
fn svg_page(page: usize) -> String {
    if page == 1 { "pages.svg".to_owned() } else { format!("pages.{page}.svg") }
}
