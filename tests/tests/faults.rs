//! Faults from outside: what was complete stays, the rest is an error of the standard and not the end of the
//! program.

use gks_metafile::{ReadOptions, open_source};
use gks_pipeline::generated::numbers::{WORKSTATION_TYPES, workstation_type as own};
use gks_pipeline::item::Shape;
use gks_pipeline::record::Record;
use gks_tests::program::{self, Linking, repository};
use std::fs;
use std::io::{self, Read};
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

fn start(folder: &Path, program: &Path, fault: &str, kind: i32) -> Child {
    start_into(folder, program, fault, kind, Stdio::piped())
}

fn start_into(folder: &Path, program: &Path, fault: &str, kind: i32, output: impl Into<Stdio>) -> Child {
    let mut command = Command::new(program);
    // Lines enough to fill a pipe in the format that is read, few where nobody reads.
    let lines = if kind == own::SVG { "20000" } else { "1000" };
    command.args([fault, &kind.to_string(), lines]).current_dir(folder).stdout(output).stdin(Stdio::null());
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
    let mut child = start(&folder, &program, "pipe", own::SVG);
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
    let status = start(&folder, &program, "killed", 0).wait().expect("the program ends");
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

/// The types that write metafiles.
const METAFILES: [i32; 5] = [own::GKSM, own::CGM, own::CGM_TEXT, own::CGM_CHARACTER, own::NCGM];

/// The types that write files.
fn file_types() -> impl Iterator<Item = i32> {
    let files = WORKSTATION_TYPES.iter().filter(|kind| !kind.extension.is_empty());
    files.map(|kind| kind.number).filter(|number| *number < own::WINDOW)
}

/// The pictures in a metafile that begin, and the polylines in it, as far as they can be read.
fn content(file: &Path) -> (usize, usize) {
    let file = fs::File::open(file).expect("the metafile");
    let mut source = open_source(file, &ReadOptions::default()).expect("a metafile").source;
    let (mut clears, mut lines) = (0, 0);
    while let Ok(Some(record)) = source.next() {
        match record {
            Record::Clear { .. } => clears += 1,
            Record::Primitive(Shape::Polyline(paths)) => lines += paths.iter().count(),
            _ => {}
        }
    }
    (clears, lines)
}

#[test]
fn a_program_that_is_killed_leaves_the_complete_pictures_of_a_metafile() {
    let Some((folder, program)) = compiled("metafile") else { return };
    for kind in METAFILES {
        let status = start(&folder, &program, "metafile", kind).wait().expect("the program ends");
        assert!(!status.success());
        let names = files(&folder);
        assert!(
            !names.contains(&"pictures".to_owned()),
            "{kind}: half a metafile has the name of a whole one"
        );
        let part = names.iter().find(|name| name.ends_with(".part")).expect("what was written");
        let (clears, lines) = content(&folder.join(part));
        assert!(clears >= 3 && lines >= 30, "{kind}: {clears} pictures and {lines} lines are left");
        fs::remove_file(folder.join(part)).expect("it is a file");
    }
}

/// Runs the program, which has to come to its end, and checks that error 303 is logged and what was complete is whole.
fn survives(folder: &Path, program: &Path, fault: &str, kind: i32) {
    for name in ["errors", "before.svg"] {
        let _ = fs::remove_file(folder.join(name));
    }
    let status = start(folder, program, fault, kind).wait().expect("the program ends");
    assert!(status.success(), "{fault} {kind}: {status}");
    let log = fs::read_to_string(folder.join("errors")).expect("the error file");
    assert!(log.contains("303"), "{fault} {kind}: {log}");
    let before = fs::read_to_string(folder.join("before.svg")).expect("the picture before");
    assert!(before.trim_end().ends_with("</svg>"), "{fault} {kind}: cut off");
}

#[test]
fn a_full_device_is_error_303_for_every_format() {
    let Some((folder, program)) = compiled("full") else { return };
    for kind in file_types() {
        survives(&folder, &program, "full", kind);
    }
}

#[test]
fn a_full_disk_is_error_303_for_every_format_and_leaves_no_half_file() {
    let Some((folder, program)) = compiled("limit") else { return };
    for kind in file_types() {
        survives(&folder, &program, "limit", kind);
        assert_eq!(files(&folder), ["before.svg", "errors", "faults"], "{kind}");
    }
}

#[test]
fn a_pipe_without_reader_is_error_303_for_metafiles_and_pages() {
    let Some((folder, program)) = compiled("pipes") else { return };
    for kind in METAFILES.into_iter().chain([own::PNG, own::PDF, own::PS, own::EPS, own::HPGL]) {
        let (reader, writer) = io::pipe().expect("a pipe");
        drop(reader);
        let mut child = start_into(&folder, &program, "pipe", kind, writer);
        let status = child.wait().expect("the program ends");
        assert!(status.success(), "{kind}: {status}");
        let log = fs::read_to_string(folder.join("errors")).expect("the error file");
        assert!(log.contains("303"), "{kind}: {log}");
        let _ = fs::remove_file(folder.join("errors"));
        let other = fs::read_to_string(folder.join("whole.svg")).expect("the other picture");
        assert!(other.trim_end().ends_with("</svg>"), "{kind}: cut off");
    }
}

/// The name of a page of the picture that has no number in its name.
fn svg_page(page: usize) -> String {
    if page == 1 { "pages.svg".to_owned() } else { format!("pages.{page}.svg") }
}
