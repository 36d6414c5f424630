//! The libraries that stand in for XGKS and for the GKS of GR: their symbols, and that their names draw what those of
//! ISO draw.

use gks_tests::likeness;
use gks_tests::program::{self, assert_good, example, has_compiler, repository, run};
use gks_tests::reader::{self, present, skip};
use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The folder of the libraries, which are built if they are not up to date.
fn libraries() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let built = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args([
                "build",
                "--quiet",
                "--package",
                "gks-xgks",
                "--package",
                "gks-gr",
                "--package",
                "libgks",
                "--package",
                "gks-cli",
            ])
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

/// The header and the library of a binding.
#[derive(Copy, Clone)]
struct Binding {
    include: &'static str,
    library: &'static str,
}

const ISO: Binding = Binding { include: "c/include", library: "libgks.so" };
const XGKS: Binding = Binding { include: "compat/xgks/include", library: "libxgks_gfortran.so" };
const GR: Binding = Binding { include: "compat/gr/include", library: "libGKS.so" };

/// Compiles a program of `programs/compat` with the header and the library of its binding, into a folder of its own.
fn compile(name: &str, binding: Binding) -> PathBuf {
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "compat", name);
    let program = folder.join(name);
    let mut compiler = Command::new("gcc");
    compiler.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror"]);
    compiler.arg("-I").arg(repository().join("bindings").join(binding.include)).arg("-o").arg(&program);
    compiler.arg(repository().join("tests/programs/compat").join(name).with_extension("c"));
    // Programs look for a library by the name that is in it, so that this one gets a link of that name.
    compiler.arg(libraries().join(binding.library)).arg("-lm");
    let compiled = compiler.output().expect("the compiler runs");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    front(&folder);
    program
}

/// Puts a link to the library for XGKS into a folder, under the name that programs know.
fn front(folder: &Path) {
    #[cfg(unix)]
    std::os::unix::fs::symlink(libraries().join("libxgks_gfortran.so"), folder.join("libxgks-gfortran.so.2"))
        .expect("a link to the library");
}

/// Runs a program with the libraries in front of all others.
fn start(program: &Path, environment: &[(&str, &str)]) -> Output {
    let folder = program.parent().expect("the folder of the program");
    let path = env::join_paths([folder, libraries()]).expect("folders without colons");
    let path = path.to_str().expect("folders in UTF-8");
    run(program, &[&[("LD_LIBRARY_PATH", path)], environment].concat())
}

/// The picture that a program writes.
fn picture(name: &str, binding: Binding) -> Vec<u8> {
    let program = compile(name, binding);
    let output = start(&program, &[]);
    assert!(output.status.success(), "{name}: {output:?}");
    if name == "xgks" {
        let said = String::from_utf8_lossy(&output.stdout);
        assert!(said.starts_with("gsetlinetype()   63 "), "{said}");
    }
    fs::read(program.with_extension("png")).expect("the picture")
}

#[cfg(target_os = "linux")]
#[test]
fn all_bindings_to_c_draw_the_same_figure() {
    if !has_compiler("gcc") {
        return;
    }
    let iso = picture("iso", ISO);
    assert!(iso.starts_with(b"\x89PNG") && iso.len() > 4000);
    assert!(picture("xgks", XGKS) == iso, "XGKS differs from ISO");
    assert!(picture("gr", GR) == iso, "GR differs from ISO");
    assert!(picture("gr_classic", GR) == iso, "the C names of 1988 of GR differ from ISO");
}

/// Paths and the other primitives of GR are where it draws them, in its colours.
#[cfg(target_os = "linux")]
#[test]
fn primitives_of_gr_are_drawn() {
    if !has_compiler("gcc") {
        return;
    }
    let picture = image::load_from_memory(&picture("gr_more", GR)).expect("a picture").into_rgb8();
    let at = |x: f64, y: f64| picture.get_pixel((1000.0 * x) as u32, (1000.0 * (1.0 - y)) as u32).0;
    assert_eq!(at(0.15, 0.3), [0xff, 0xb3, 0x00], "the path is filled");
    assert_eq!(at(0.25, 0.25), [0xff; 3], "it has a hole");
    assert_eq!(at(0.125, 0.2), [0x00, 0x00, 0xff], "and an edge");
    assert_eq!(at(0.55, 0.7), [0x00, 0x80, 0xff], "the polygon has a colour of its own");
    assert_eq!(at(0.6, 0.5015), [0xff, 0x00, 0x00], "so has a line");
    assert_eq!(at(0.7405, 0.1255), [0xff, 0x80, 0x80], "and a marker, whose arm lies on two rows of pixels");
}

/// What GR has beyond the standard is drawn: images with opacity, wider lines, text that leans.
#[cfg(target_os = "linux")]
#[test]
fn extensions_of_gr_are_drawn() {
    if !has_compiler("gcc") {
        return;
    }
    let picture = image::load_from_memory(&picture("gr_extension", GR)).expect("a picture").into_rgb8();
    let at = |x: f64, y: f64| picture.get_pixel((1000.0 * x) as u32, (1000.0 * (1.0 - y)) as u32).0;
    assert_eq!(at(0.15, 0.15), [0xff, 0x00, 0x00], "a pixel of an image");
    assert_eq!(at(0.25, 0.15), [0x7d, 0x7d, 0xff], "a translucent one");
    assert_eq!(at(0.15, 0.35), [0x00, 0xff, 0x00], "another image");
    assert_eq!(at(0.55, 0.15), [0xff, 0x7d, 0x7d], "an image while all is translucent");
    assert_eq!([at(0.5, 0.5035), at(0.5, 0.6035)], [[0x00; 3], [0xff; 3]], "nominal linewidths");
    let leans =
        (60..70).any(|x| (80..84).any(|y| at(f64::from(x) / 100.0, f64::from(y) / 100.0) != [0xff; 3]));
    assert!(leans, "the upper end of the I is to the right of its foot");
}

/// What clips in GR besides the rectangle, and images that are smooth.
#[cfg(target_os = "linux")]
#[test]
fn clip_regions_and_resampling_of_gr_are_drawn() {
    if !has_compiler("gcc") {
        return;
    }
    let program = compile("gr_region", GR);
    assert!(start(&program, &[]).status.success());
    documents_are_clipped_the_same(&program);
    let picture = image::open(program.with_extension("png")).expect("a picture").into_rgb8();
    let at = |x: f64, y: f64| picture.get_pixel((1000.0 * x) as u32, (1000.0 * (1.0 - y)) as u32).0;
    let [white, cyan, green, blue, black] = [[0xff; 3], [0, 0xff, 0xff], [0, 0xff, 0], [0, 0, 0xff], [0; 3]];

    // An ellipse about (0.25, 0.75) whose radius is 0.2.
    let on_circle = |angle: f64, radius: f64| {
        let (sine, cosine) = angle.to_radians().sin_cos();
        (0.25 + radius * cosine, 0.75 + radius * sine)
    };
    for angle in [15.0, 165.0, 195.0, 300.0, 345.0] {
        let ((x, y), (u, v)) = (on_circle(angle, 0.197), on_circle(angle, 0.203));
        assert_eq!((at(x, y), at(u, v)), (cyan, white), "the area at {angle} degrees");
    }
    let dark = (0..1000).filter(|&x| picture.get_pixel(x, 250).0 == black && x < 500);
    let (first, last) = (dark.clone().min(), dark.clone().max());
    assert!(
        first.is_some_and(|x| x > 48) && last.is_some_and(|x| x < 452),
        "the line is cut: {first:?} {last:?}"
    );
    assert!((200..300).contains(&dark.count()), "it is dashed");
    assert!(at(0.058, 0.558) == white && at(0.25, 0.76) != cyan, "a marker outside and one inside");
    let is_dark = |x, y| picture.get_pixel(x, y).0.iter().all(|&part| part < 128);
    let text = |left: u32, right: u32| (left..right).any(|x| (80..130).any(|y| is_dark(x, y)));
    assert!(text(200, 300) && !text(0, 100) && !text(400, 500), "text is cut");

    // From 90 degrees on about (0.75, 0.75).
    assert_eq!([at(0.7, 0.9), at(0.65, 0.65), at(0.85, 0.65)], [green; 3], "three quarters");
    assert_eq!([at(0.8, 0.8), at(0.85, 0.853)], [white; 2], "the first quarter");
    let line = [at(0.6, 0.85), at(0.8, 0.85), at(0.56, 0.85)];
    assert_eq!(line, [black, white, white], "the line ends at the radius");

    // The rectangle of transformation 3.
    assert_eq!([at(0.06, 0.06), at(0.44, 0.44), at(0.25, 0.47), at(0.03, 0.25)], [blue, blue, white, white]);

    // Colours along a row: red, then less of it, then blue; nothing outside of the ellipse.
    let reds: Vec<u8> = (56..95).map(|x| at(f64::from(x) / 100.0, 0.25)[0]).collect();
    assert!(reds.is_sorted_by(|a, b| a >= b) && reds[0] == 255 && reds[38] == 0, "{reds:?}");
    assert!(reds.iter().any(|&red| (100..156).contains(&red)), "{reds:?}");
    assert_eq!([at(0.56, 0.06), at(0.94, 0.44)], [white; 2], "the corners");
}

/// Documents clip by themselves, and are no larger for it.
#[cfg(target_os = "linux")]
fn documents_are_clipped_the_same(program: &Path) {
    if !present("clip regions", &["rsvg-convert", "pdftoppm", "gs"]) {
        return;
    }
    let folder = program.parent().expect("the folder of the program");
    let file = |name: &str| folder.join(name).to_str().expect("a path in UTF-8").to_owned();
    let write = |kind: &str| {
        let (size, name) =
            (["800x800", "400x400"][usize::from(kind != "png")], file(&format!("region.{kind}")));
        let environment =
            [("GKS_WSTYPE", kind), ("GKS_CONID", &name[..]), ("GKS_OPTIONS", &format!("size={size}"))];
        assert!(start(program, &environment).status.success(), "{kind}");
        assert!(fs::metadata(&name).expect("a document").len() < 300_000, "{kind}");
        name
    };
    let expected = likeness::open(Path::new(&write("png"))).expect("a picture");
    let readers: [(&str, &str, Vec<&str>); 3] = [
        ("svg", "rsvg-convert", vec!["-w", "800", "-o", "OUT", "IN"]),
        ("pdf", "pdftoppm", vec!["-png", "-r", "144", "-singlefile", "IN", "OUT"]),
        (
            "ps",
            "gs",
            vec![
                "-q",
                "-dNOPAUSE",
                "-dBATCH",
                "-dSAFER",
                "-sDEVICE=png16m",
                "-r144",
                "-sOutputFile=OUT",
                "IN",
            ],
        ),
    ];
    for (kind, reader, arguments) in readers {
        let (document, picture) = (write(kind), file(&format!("{kind}.png")));
        let out = if reader == "pdftoppm" { picture.trim_end_matches(".png") } else { &picture };
        let arguments: Vec<String> =
            arguments.iter().map(|word| word.replace("OUT", out).replace("IN", &document)).collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        reader::run(60, reader, &arguments).expect("a picture of the document");
        let found = likeness::open(Path::new(&picture)).expect("a picture");
        let likeness = likeness::likeness(&expected, &found);
        assert!(likeness.stray < 0.02 && likeness.tone < 2.0, "{kind}: {likeness:?}");
    }
}

/// A program's own error handling function gets the numbers that XGKS has for its functions.
#[cfg(target_os = "linux")]
#[test]
fn programs_of_xgks_handle_errors() {
    if !has_compiler("gcc") {
        return;
    }
    let output = start(&compile("xgks_errors", XGKS), &[]);
    assert_good(&output);
    let said = String::from_utf8_lossy(&output.stdout);
    let names: Vec<_> = said.lines().filter_map(|line| line.split_once("  ").map(|(name, _)| name)).collect();
    assert_eq!(names, ["gopengks()", "ginqwstran()", "an unknown function"], "{said}");
}

/// Every class of input in every mode.
#[cfg(target_os = "linux")]
#[test]
fn programs_of_xgks_are_operated_by_a_script() {
    if !has_compiler("gcc") {
        return;
    }
    let script = repository().join("tests/programs/compat/xgks_input.txt");
    let environment = [("GKS_WSTYPE", "scripted"), ("GKS_SCRIPT", &script.to_string_lossy())];
    assert_good(&start(&compile("xgks_input", XGKS), &environment));
}

#[cfg(target_os = "linux")]
#[test]
fn programs_of_xgks_write_read_and_interpret_metafiles() {
    if !has_compiler("gcc") {
        return;
    }
    let program = compile("xgks_metafile", XGKS);
    assert_good(&start(&program, &[]));
    let file = |name| fs::read(program.with_file_name(name)).expect("a file of the program");
    assert!(file("xgks.png") == file("direct.png"), "the metafile shows another picture");
    assert!(file("xgks.gksm").starts_with(b"GKSM"));

    // The tool of Ferret that turns metafiles into PostScript looks into the items by itself.
    let tool = Path::new("/usr/bin/gksm2ps");
    if !tool.exists() {
        return skip("gksm2ps", "there is no package ferret-vis");
    }
    let copy = program.with_file_name("gksm2ps");
    fs::copy(tool, &copy).expect("a copy of the tool");
    let limited = program.with_file_name("limited");
    fs::write(&limited, "#!/bin/sh\nexec timeout 60 ./gksm2ps -R -l cps -o xgks.ps xgks.gksm\n")
        .expect("a file");
    let permissions = fs::metadata(&copy).expect("it is there").permissions();
    fs::set_permissions(&limited, permissions).expect("it is ours");
    let output = start(&limited, &[]);
    assert!(output.status.success(), "{output:?}");
    let page = String::from_utf8_lossy(&file("xgks.ps")).into_owned();
    for part in [
        "0.500000 0.750000 ln",
        "(Text in a metafile) 0.250000 0.125000 text",
        "ct 9 [1.000000 0.500000 0.250000]",
    ] {
        assert!(page.contains(part), "{part} is not in\n{page}");
    }
}

/// The header has the layouts and the values of the original, where that is installed.
#[test]
fn the_header_for_xgks_has_the_layouts_of_the_original() {
    let original = Path::new("/usr/include/xgks.h");
    if !has_compiler("gcc") {
        return;
    }
    if !original.exists() {
        return skip("the header of XGKS", "there is no package libxgks-dev");
    }
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "compat", "layouts");
    let source = repository().join("tests/programs/compat/xgks_layouts.c");
    let layouts = |name: &str, include: &Path| {
        let program = folder.join(name);
        let mut compiler = Command::new("gcc");
        compiler.args(["-std=gnu99", "-w", "-I"]).arg(include).arg("-o").arg(&program);
        let compiled = compiler.arg(&source).output().expect("the compiler runs");
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        String::from_utf8(run(&program, &[]).stdout).expect("lines of text")
    };
    let ours = layouts("ours", &repository().join("bindings/compat/xgks/include"));
    let theirs = layouts("theirs", original.parent().expect("a folder"));
    assert!(ours.lines().count() > 300);
    let differences: Vec<_> = ours.lines().zip(theirs.lines()).filter(|(a, b)| a != b).collect();
    assert!(differences.is_empty() && ours == theirs, "{differences:?}");
}

/// C++ programs include the headers, too.
#[test]
fn the_headers_are_cpp() {
    if !has_compiler("g++") {
        return;
    }
    for (name, binding) in [("xgks", XGKS), ("gks", GR)] {
        let source = program::folder(env!("CARGO_TARGET_TMPDIR"), "compat-cpp", name).join("header.cpp");
        fs::write(&source, format!("#include <{name}.h>\n")).expect("the program can be written");
        let include = repository().join("bindings").join(binding.include);
        let compiled = Command::new("g++")
            .args(["-std=c++11", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I"])
            .args([&include, &source])
            .output()
            .expect("g++ runs");
        assert!(compiled.status.success(), "{name}: {}", String::from_utf8_lossy(&compiled.stderr));
    }
}

/// The examples of XGKS, as Debian ships their sources, on this library.
#[cfg(target_os = "linux")]
#[test]
fn the_examples_of_xgks_draw() {
    let (Some(star), Some(hanoi)) = (example("star.f"), example("hanoi.c")) else {
        return skip("the examples of XGKS", "there is no package libxgks-dev");
    };
    if !has_compiler("gcc") || !has_compiler("gfortran") {
        return;
    }
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "compat", "examples");
    front(&folder);
    let build = |compiler: &str, arguments: &[&str], include: &[&str], source: &Path, name: &str| {
        let program = folder.join(name);
        let mut command = Command::new(compiler);
        command.args(arguments).arg("-o").arg(&program).arg(source);
        command.args(include.iter().map(|folder| format!("-I{}", repository().join(folder).display())));
        let compiled =
            command.arg(libraries().join("libxgks_gfortran.so")).arg("-lm").output().expect("it runs");
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        program
    };
    let legacy = ["-std=legacy", "-w"];
    let star = build("gfortran", &legacy, &["bindings/fortran/include"], &star, "star");
    let include = ["bindings/compat/xgks/include", "tests/legacy/xgks"];
    let hanoi = build("gcc", &["-std=gnu89", "-w"], &include, &hanoi, "hanoi");
    for (program, name) in [(star, "star"), (hanoi, "hanoi")] {
        let output = start(&program, &[("GKS_CONID", &format!("{name}.png"))]);
        assert!(output.status.success(), "{name}: {output:?}");
        let picture = image::open(folder.join(format!("{name}.png"))).expect("the picture").into_rgb8();
        let drawn = picture.pixels().filter(|pixel| pixel.0 != [255; 3]).count();
        assert!(drawn > 1000, "{name}: {drawn} pixels");
    }
}
