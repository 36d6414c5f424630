//! What `gks install` puts into a folder is enough to compile, link and run programs, without the sources.
#![cfg(target_os = "linux")]

use gks_tests::folder::Folder;
use gks_tests::program::{built, has_compiler, run};
use std::fs;
use std::path::Path;
use std::process::Command;

/// A program that writes a picture with a line.
const C: &str = r#"
#include <gks.h>
int main(void)
{
    Gpoint ends[] = {{0.1f, 0.1f}, {0.9f, 0.9f}};
    Gpoint_list line = {2, ends};
    gopen_gks(NULL, GDEF_MEM_SIZE);
    gopen_ws(1, "line.svg", 200);
    gactivate_ws(1);
    gpolyline(&line);
    gdeactivate_ws(1);
    gclose_ws(1);
    gclose_gks();
    return 0;
}
"#;

/// The same in Fortran.
const FORTRAN: &str = "
      PROGRAM LINE
      INCLUDE 'gks.inc'
      REAL X(2), Y(2)
      DATA X, Y /0.1, 0.9, 0.1, 0.9/
      CALL GOPKS(0, -1)
      CALL GOPWK(1, 1, 200)
      CALL GACWK(1)
      CALL GPL(2, X, Y)
      CALL GDAWK(1)
      CALL GCLWK(1)
      CALL GCLKS
      END
";

/// Runs a command and gives what it prints.
fn said(command: &mut Command) -> String {
    let output = command.output().expect("the command runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// Whether a program in the folder draws; the library is found through `path` alone.
fn draws(folder: &Folder, program: &str, picture: &str, path: &str) {
    let output = run(Path::new(&folder.file(program)), &[("LD_LIBRARY_PATH", path)]);
    assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
    let picture = folder.file(picture);
    assert!(fs::read_to_string(&picture).expect("the picture").contains("</svg>"), "{program}");
    fs::remove_file(picture).expect("the picture was there");
}

#[test]
fn programs_need_nothing_but_the_folder() {
    let folder = Folder::new(env!("CARGO_TARGET_TMPDIR"), "installation");
    // A folder that is moved stays what it is.
    let (first, prefix) = (folder.file("first"), folder.file("prefix"));
    let listed = said(Command::new(built("gks-cli", "gks")).args(["install", &first]));
    let missing: Vec<&str> = listed.lines().filter(|file| !Path::new(file).is_file()).collect();
    assert!(listed.lines().count() > 12 && missing.is_empty(), "{listed}");
    fs::rename(first, &prefix).expect("the folder is ours");
    let installed = |name: &str| format!("{prefix}/{name}");
    fs::write(folder.file("line.c"), C).expect("the folder is ours");
    fs::write(folder.file("line.f"), FORTRAN).expect("the folder is ours");
    let here = folder.file("");

    if has_compiler("gcc") {
        said(Command::new(installed("bin/gks")).args(["cc", "line.c", "-o", "by_gks"]).current_dir(&here));
        draws(&folder, "by_gks", "line.svg", "");
        let doctor = said(Command::new(installed("bin/gks")).arg("doctor").arg(folder.file("by_gks")));
        for library in ["libgks.so", "libNGgks.so.1", "libxgks-gfortran.so.2", "libGKS.so"] {
            assert!(doctor.contains(library), "{doctor}");
        }
    }
    if has_compiler("gfortran") {
        said(
            Command::new(installed("bin/gks")).args(["fc", "line.f", "-o", "in_fortran"]).current_dir(&here),
        );
        draws(&folder, "in_fortran", "gks.1.svg", "");
    }
    if has_compiler("gcc") && has_compiler("pkg-config") {
        let flags = |arguments: &[&str]| {
            let mut command = Command::new("pkg-config");
            command.env("PKG_CONFIG_PATH", installed("lib/pkgconfig")).args(arguments).arg("gks");
            said(&mut command).split_whitespace().map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(flags(&["--modversion"]), [env!("CARGO_PKG_VERSION")]);
        let mut gcc = Command::new("gcc");
        said(gcc.args(["line.c", "-o", "shared"]).args(flags(&["--cflags", "--libs"])).current_dir(&here));
        draws(&folder, "shared", "line.svg", &installed("lib"));
        let mut gcc = Command::new("gcc");
        gcc.args(["line.c", "-o", "static"]).args(flags(&["--cflags"])).arg(installed("lib/libgks.a"));
        said(
            gcc.args(flags(&["--static", "--libs-only-l"]).iter().filter(|flag| *flag != "-lgks"))
                .current_dir(&here),
        );
        draws(&folder, "static", "line.svg", "");
    }
}
