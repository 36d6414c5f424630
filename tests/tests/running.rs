//! `gks run` and `gks doctor` on programs of many kinds.
#![cfg(target_os = "linux")]

use gks_tests::program::{self, built, example, has_compiler, repository, run};
use gks_tests::reader::skip;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The command, with the libraries beside it that it puts in front of programs.
fn gks() -> &'static Path {
    static COMMAND: OnceLock<PathBuf> = OnceLock::new();
    COMMAND.get_or_init(|| {
        for (package, library) in [
            ("gks-xgks", "libxgks_gfortran.so"),
            ("gks-gr", "libGKS.so"),
            ("gks-ncar", "libNGgks.so"),
            ("libgks", "libgks.so"),
        ] {
            built(package, library);
        }
        built("gks-cli", "gks")
    })
}

/// Runs the command in a folder and gives what it says, good or bad, with the rest.
fn say(folder: &Path, arguments: &[&str]) -> (Output, String) {
    let mut command = Command::new(gks());
    for variable in ["GKS_WSTYPE", "GKS_CONID", "GKS_DIALECT", "LD_LIBRARY_PATH"] {
        command.env_remove(variable);
    }
    let output = command.args(arguments).current_dir(folder).output().expect("the command runs");
    let said = [&output.stdout[..], &output.stderr].concat();
    (output, String::from_utf8_lossy(&said).into_owned())
}

/// A program of XGKS, and the object that it is made of, in a folder.
fn program_of_xgks(name: &str) -> Option<PathBuf> {
    if !has_compiler("gcc") {
        return None;
    }
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "running", name);
    let gcc = |arguments: &[&str]| {
        let mut compiler = Command::new("gcc");
        compiler.args(arguments).current_dir(&folder);
        let include = repository().join("bindings/compat/xgks/include");
        let library = built("gks-xgks", "libxgks_gfortran.so");
        let source = repository().join("tests/programs/compat/run.c");
        match arguments {
            ["-c", ..] => compiler.arg("-I").arg(include).arg(source),
            _ => compiler.arg(library),
        };
        let compiled = compiler.output().expect("the compiler runs");
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    };
    gcc(&["-c", "-std=c99", "-o", "run.o"]);
    gcc(&["-o", "run", "run.o"]);
    Some(folder)
}

#[test]
fn a_program_draws_what_and_where_the_user_says() {
    let Some(folder) = program_of_xgks("draws") else { return };
    let (output, said) = say(&folder, &["run", "--on", "svg", "-o", "line.svg", "--", "./run"]);
    assert!(output.status.success(), "{said}");
    let picture = fs::read_to_string(folder.join("line.svg")).expect("the picture");
    assert!(picture.contains("<svg") && picture.contains("</svg>"), "{picture}");
    // The name alone says what to draw.
    let (output, said) = say(&folder, &["run", "-o", "line.pdf", "./run"]);
    assert!(output.status.success(), "{said}");
    assert!(fs::read(folder.join("line.pdf")).expect("the picture").starts_with(b"%PDF"));
}

#[test]
fn the_status_and_the_signal_of_a_program_are_passed_on() {
    let Some(folder) = program_of_xgks("status") else { return };
    let (output, said) = say(&folder, &["run", "--on", "null", "--", "./run", "7"]);
    assert_eq!(output.status.code(), Some(7), "{said}");
    let (output, said) = say(&folder, &["run", "--on", "null", "--", "./run", "signal"]);
    assert_eq!(output.status.signal(), Some(15), "{said}");
}

#[test]
fn a_script_runs_with_the_library_that_the_user_names() {
    let Some(folder) = program_of_xgks("script") else { return };
    let script = folder.join("script");
    fs::write(&script, "#!/bin/sh\n./run 3\n").expect("a script");
    fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).expect("it is ours");
    let (output, said) = say(&folder, &["run", "--dialect", "xgks", "-o", "line.png", "--", "./script"]);
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(folder.join("line.png").exists());
    for arguments in [&["run", "./script"][..], &["doctor", "./script"]] {
        let (output, said) = say(&folder, arguments);
        assert!(
            !output.status.success() && said.contains("a script") && said.contains("--dialect"),
            "{said}"
        );
    }
}

#[test]
fn what_cannot_be_run_is_said() {
    let Some(folder) = program_of_xgks("errors") else { return };
    let refused = |arguments: &[&str], reason: &str| {
        let (output, said) = say(&folder, arguments);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains(reason), "{arguments:?}: {said}");
    };
    refused(&["run", "./nothing"], "no such program");
    refused(&["run", "--on", "papyrus", "./run"], "gks workstations");
    refused(&["run", "./run.o"], "an object");
    refused(&["run", "ls"], "needs no GKS");
    refused(&["doctor", "nothing"], "no such file");
    refused(&["doctor", "ls"], "link it again");
}

#[test]
fn the_doctor_knows_programs_and_objects() {
    let Some(folder) = program_of_xgks("doctor") else { return };
    let (output, said) = say(&folder, &["doctor", "run"]);
    assert!(output.status.success(), "{said}");
    for part in ["a program for the GKS of XGKS", "needs 7 functions", "has   7", "gks run --on svg -- "] {
        assert!(said.contains(part), "{part}: {said}");
    }
    let (output, said) = say(&folder, &["doctor", "run.o"]);
    assert!(output.status.success() && said.contains("an object"), "{said}");
}

/// Programs that Debian ships, linked with other implementations.
#[test]
fn the_doctor_knows_installed_programs() {
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "running", "installed");
    for (name, family) in [("gksm2ps", "XGKS"), ("ferret_c", "XGKS"), ("ncl", "NCAR Graphics")] {
        if !Path::new("/usr/bin").join(name).exists() {
            skip(name, "it is not installed");
            continue;
        }
        let (output, said) = say(&folder, &["doctor", name]);
        assert!(output.status.success(), "{name}: {said}");
        assert!(said.contains(&format!("a program for the GKS of {family}")), "{name}: {said}");
    }
}

/// The command itself needs no GKS in front of it.
#[test]
fn a_program_that_was_linked_statically_must_be_linked_again() {
    let Some(folder) = program_of_xgks("static") else { return };
    let source = folder.join("static.c");
    fs::write(&source, "int main(void) { return 0; }\n").expect("a program");
    let compiled =
        Command::new("gcc").args(["-static", "-o", "static", "static.c"]).current_dir(&folder).output();
    if !compiled.is_ok_and(|compiled| compiled.status.success()) {
        return skip("a static program", "there is no static library of C");
    }
    assert!(run(&folder.join("static"), &[]).status.success());
    let (output, said) = say(&folder, &["run", "./static"]);
    assert!(!output.status.success() && said.contains("libgks.a"), "{said}");
}

/// Compiles an example of XGKS with the original library, as its authors meant it, or with ours and our header; nothing if
/// something that it takes is not installed.
fn example_of_xgks(folder: &Path, source: &str, original: bool) -> Option<PathBuf> {
    let is_fortran = source.ends_with(".f");
    let compiler = if is_fortran { "gfortran" } else { "gcc" };
    let path = example(source).filter(|_| has_compiler(compiler))?;
    if original && !Path::new("/usr/include/xgks.h").exists() {
        return None;
    }
    let program = folder.join(format!("{source}.{}", if original { "original" } else { "ours" }));
    let mut command = Command::new(compiler);
    match is_fortran {
        true => command.args(["-std=legacy", "-w", "-fallow-argument-mismatch", "-fno-automatic"]),
        false => command.args(["-std=gnu89", "-w"]),
    };
    let include = |command: &mut Command, folder: &str| {
        command.arg("-I").arg(repository().join(folder));
    };
    // Neither is in a package of the original: the constants for Fortran and a header of its programs.
    include(&mut command, "bindings/fortran/include");
    include(&mut command, "tests/legacy/xgks");
    if !original {
        include(&mut command, "bindings/compat/xgks/include");
    }
    command.arg(path).arg("-o").arg(&program);
    if original {
        command.args(["-lxgks-gfortran", "-lX11", "-lm"]);
    } else {
        command.arg(built("gks-xgks", "libxgks_gfortran.so")).arg("-lm");
    }
    let compiled = command.output().expect("the compiler runs");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    Some(program)
}

/// Programs that were linked with the library of XGKS itself, with nothing of ours.
#[test]
fn binaries_of_xgks_draw_what_programs_do_that_are_compiled_again() {
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "running", "binaries");
    for source in ["star.f", "hanoi.c"] {
        let pictures = [true, false].map(|original| {
            let program = example_of_xgks(&folder, source, original)?;
            let name = program.file_name()?.to_str()?;
            let picture = format!("{name}.png");
            let (output, said) = say(&folder, &["run", "-o", &picture, "--", &format!("./{name}")]);
            assert!(output.status.success(), "{name}: {said}");
            Some(image::open(folder.join(picture)).expect("the picture").into_rgb8())
        });
        let [Some(binary), Some(ours)] = pictures else {
            return skip("binaries of XGKS", "there is no package libxgks-dev");
        };
        let drawn = binary.pixels().filter(|pixel| pixel.0 != [255; 3]).count();
        assert!(drawn > 1000, "{source}: {drawn} pixels");
        assert!(binary == ours, "{source} draws something else when it is compiled again");
    }
}

/// The demonstration of XGKS, linked with the library of XGKS, is operated through all its menus.
#[test]
fn the_demonstration_that_was_linked_with_xgks_is_operated_by_a_script() {
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "running", "demonstration");
    if example_of_xgks(&folder, "gksdemo.f", true).is_none() {
        return skip("the demonstration of XGKS", "there is no package libxgks-dev");
    }
    let script = repository().join("tests/legacy/gksdemo.txt");
    // One that is out of step with its operator would wait for ever.
    let mut command = Command::new("timeout");
    command.arg("120").arg(gks()).args(["run", "--on", "scripted", "--", "./gksdemo.f.original"]);
    command.current_dir(&folder).env("GKS_SCRIPT", &script).env("GKS_OPTIONS", "background=black");
    let output = command.output().expect("timeout runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && !said.contains("GKS ERROR"), "{}:\n{said}", output.status);
    let steps = fs::read_to_string(&script).expect("the script");
    let snapshots: Vec<_> = steps.lines().filter_map(|line| line.strip_prefix("snapshot ")).collect();
    assert_eq!(snapshots.len(), 38);
    for name in snapshots {
        let screen = image::open(folder.join(name)).expect("a picture").into_rgb8();
        let drawn = screen.pixels().filter(|pixel| pixel.0 != [0; 3]).count();
        assert!(drawn > 2000, "{name}: {drawn} pixels");
    }
}
