//! Other programs that read documents, as far as they are installed.

use crate::card::Picture;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The arguments that let Ghostscript print the text of a document.
pub(crate) const TXTWRITE: [&str; 6] = ["-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=txtwrite", "-o-"];

/// A directory for the files of one test.
pub(crate) fn directory(test: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Runs a program and gives what it prints, standard error after standard output; none if it is not installed.
/// A program that fails fails the test.
pub(crate) fn run(program: &str, arguments: &[&str]) -> Option<String> {
    let output = match Command::new(program).args(arguments).output() {
        Ok(output) => output,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            eprintln!("SKIPPED: {program} is not installed");
            return None;
        }
        Err(error) => panic!("{program}: {error}"),
    };
    let text = String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{program} {arguments:?} failed: {text}");
    Some(text.into_owned())
}

/// What Poppler shows of the first page of a PDF document, one pixel a point.
pub(crate) fn poppler(document: &Path) -> Option<Picture> {
    let name = document.with_extension("poppler");
    let arguments = ["-r", "72", "-singlefile", document.to_str()?, name.to_str()?];
    run("pdftoppm", &arguments).map(|_| read_ppm(&document.with_extension("poppler.ppm")))
}

/// What Ghostscript shows of the first page of a document, one pixel a point.
pub(crate) fn ghostscript(document: &Path) -> Option<Picture> {
    let picture = document.with_extension("ghostscript.ppm");
    let output = format!("-sOutputFile={}", picture.display());
    let device = ["-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=ppmraw", "-r72", "-dLastPage=1"];
    let arguments = [&device[..], &[&output, document.to_str()?]].concat();
    run("gs", &arguments).map(|_| read_ppm(&picture))
}

/// Reads a picture in binary PPM format.
fn read_ppm(path: &Path) -> Picture {
    let bytes = std::fs::read(path).unwrap();
    let mut at = 0;
    let mut fields = Vec::new();
    while fields.len() < 4 {
        let field: Vec<u8> =
            bytes[at..].iter().copied().take_while(|byte| !byte.is_ascii_whitespace()).collect();
        at += field.len() + 1;
        if field.first() == Some(&b'#') {
            at += bytes[at..].iter().take_while(|byte| **byte != b'\n').count() + 1;
        } else if !field.is_empty() {
            fields.push(String::from_utf8(field).unwrap());
        }
    }
    assert_eq!((fields[0].as_str(), fields[3].as_str()), ("P6", "255"));
    (fields[1].parse().unwrap(), fields[2].parse().unwrap(), bytes[at..].to_vec())
}
