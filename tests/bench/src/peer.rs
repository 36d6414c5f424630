//! The libraries that are compared, each in a program of its own.

use crate::Failure;
use crate::cost::Cost;
use crate::data;
use gks_cli::bench::clock::{Peak, cpu_seconds};
use gks_cli::bench::skia::TinySkia;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The seconds of processor time after which a run is given up.
pub(crate) const PATIENCE: u32 = 10;
/// The environment variable that names the GKS of GR, as a file.
const GR: &str = "GKS_BENCH_GR";
/// The one that names the folder where Blend2D is installed.
const BLEND2D: &str = "GKS_BENCH_BLEND2D";

/// A library behind a program.
pub(crate) struct Peer {
    /// The name in the table.
    pub(crate) name: &'static str,
    program: Program,
}

enum Program {
    /// This program, for tiny-skia.
    Own,
    /// Another program; how the device is called that has pixels.
    Other(PathBuf, &'static str),
}

/// How a run ended.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Run {
    /// The workload was drawn.
    Done(Cost),
    /// It took longer than [`PATIENCE`].
    GivenUp,
    /// The library has no such device or primitive, or failed.
    Impossible,
}

impl Run {
    /// What it has cost, if it came to its end.
    pub(crate) fn cost(&self) -> Option<Cost> {
        if let Run::Done(cost) = self { Some(*cost) } else { None }
    }
}

/// This library, which is compared with the others.
pub(crate) const OURS: &str = "this library";

/// What a C program is made of: the name of the library, its source, flags, the device with pixels.
struct Recipe {
    name: &'static str,
    source: &'static str,
    compiler: &'static str,
    flags: Vec<String>,
    pixels: &'static str,
}

impl Peer {
    /// All libraries that are installed: the C programs are compiled into `folder`.
    pub(crate) fn all(sources: &Path, folder: &Path) -> Result<Vec<Peer>, Failure> {
        let mut peers = vec![Peer { name: "tiny-skia", program: Program::Own }];
        match vello(sources, folder) {
            Ok(binary) => peers.push(Peer { name: "vello_cpu", program: Program::Other(binary, "memory") }),
            Err(failure) => eprintln!("without vello_cpu: {failure}"),
        }
        for recipe in recipes(sources)? {
            let binary = folder.join(recipe.name.replace(' ', "-"));
            match compile(&recipe, sources, &binary) {
                Ok(()) => {
                    peers.push(Peer { name: recipe.name, program: Program::Other(binary, recipe.pixels) });
                }
                Err(failure) if recipe.name == OURS => return Err(failure),
                Err(failure) => eprintln!("without {}: {failure}", recipe.name),
            }
        }
        Ok(peers)
    }

    /// Draws a workload once, or more often, on a device.
    pub(crate) fn run(
        &self,
        device: &str,
        workload: &str,
        repetitions: u32,
        folder: &Path,
    ) -> Result<Run, Failure> {
        let file = folder.join("picture");
        let mut command = match &self.program {
            Program::Own if device == "memory" => {
                let mut command = limited(&std::env::current_exe()?);
                command.args(["draw", workload]);
                command
            }
            Program::Own => return Ok(Run::Impossible),
            Program::Other(binary, pixels) => {
                let mut command = limited(binary);
                command.arg(self.device(device, pixels, workload)).arg(workload);
                command.arg(folder.join("data")).arg(file);
                command
            }
        };
        // The environment of the user is no part of the comparison.
        for name in ["GKS_WSTYPE", "GKS_CONID", "GKS_OPTIONS", "GKS_DIALECT"] {
            command.env_remove(name);
        }
        command.arg(repetitions.to_string()).current_dir(folder).stderr(Stdio::null());
        let output = command.output()?;
        let last = output.stdout.split(|&byte| byte == b'\n').rfind(|line| line.starts_with(b"{"));
        match last {
            Some(line) if output.status.success() => Ok(Run::Done(serde_json::from_slice(line)?)),
            _ if matches!(output.status.signal(), Some(SIGKILL | SIGXCPU)) => Ok(Run::GivenUp),
            _ => Ok(Run::Impossible),
        }
    }

    /// What the program calls a device. That small files are asked for, and lines that are not antialiased, is told to this
    /// library alone: others have one kind of each.
    fn device<'a>(&self, device: &'a str, pixels: &'a str, workload: &str) -> &'a str {
        match device {
            "memory" if self.name == OURS && workload == "w1a" => "memory-aliased",
            "memory" => pixels,
            "pdf-small" if self.name != OURS => "pdf",
            device => device,
        }
    }

    /// The command line that draws a workload once, to be watched by a profiler.
    pub(crate) fn command_line(&self, device: &str, workload: &str, folder: &Path) -> Option<Vec<String>> {
        let Program::Other(binary, pixels) = &self.program else { return None };
        let text = |path: PathBuf| path.to_string_lossy().into_owned();
        let device = self.device(device, pixels, workload);
        let words = [text(binary.clone()), device.into(), workload.into(), text(folder.join("data"))];
        Some(words.into_iter().chain([text(folder.join("picture")), "1".into()]).collect())
    }
}

/// The signals that end a program which has used its time.
const SIGKILL: i32 = 9;
const SIGXCPU: i32 = 24;

/// A program that is stopped when it has taken too long.
fn limited(program: &Path) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", &format!("ulimit -t {PATIENCE}; exec \"$0\" \"$@\"")]).arg(program);
    command
}

/// Draws with tiny-skia, in this process.
pub(crate) fn draw(workload: &str, repetitions: u32) -> Result<Cost, Failure> {
    let scene = data::scene(workload)?;
    let figures = scene.figures().ok_or("nothing that such a library could draw")?;
    let peak = Peak::watch();
    let start = cpu_seconds();
    let mut canvas = TinySkia::new().ok_or("no memory")?;
    let opened = cpu_seconds();
    (0..repetitions).for_each(|_| figures(&mut canvas));
    let drawn = cpu_seconds();
    Ok(Cost {
        open_ms: 1e3 * (opened - start),
        draw_ms: 1e3 * (drawn - opened) / f64::from(repetitions.max(1)),
        close_ms: 0.0,
        process_ms: 1e3 * drawn,
        peak_kib: peak.kib(),
        bytes: 0,
    })
}

/// What `pkg-config` says about a library.
fn pkg_config(arguments: &[&str]) -> Result<Vec<String>, Failure> {
    let output = Command::new("pkg-config").args(arguments).output()?;
    if !output.status.success() {
        return Err(format!("pkg-config {}: not installed", arguments.join(" ")).into());
    }
    Ok(String::from_utf8(output.stdout)?.split_whitespace().map(str::to_owned).collect())
}

fn recipes(sources: &Path) -> Result<Vec<Recipe>, Failure> {
    let root = sources.ancestors().nth(3).ok_or("no folder above the sources")?;
    let release = root.join("target/release").to_string_lossy().into_owned();
    let include = root.join("bindings/c/include").to_string_lossy().into_owned();
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let mut recipes = vec![Recipe {
        name: OURS,
        source: "iso.c",
        compiler: "cc",
        flags: vec![
            format!("-I{include}"),
            format!("-L{release}"),
            "-lgks".into(),
            format!("-Wl,-rpath,{release}"),
        ],
        pixels: "memory",
    }];
    if let Ok(flags) = pkg_config(&["--cflags", "--libs", "cairo", "cairo-svg", "cairo-pdf", "cairo-ps"]) {
        recipes.push(Recipe { name: "cairo", source: "cairo.c", compiler: "cc", flags, pixels: "memory" });
    }
    if let Ok(flags) = pkg_config(&["--cflags", "--libs", "libagg"]) {
        recipes.push(Recipe { name: "AGG", source: "agg.cpp", compiler: "c++", flags, pixels: "memory" });
    }
    let fortran = |name, define: &str, libraries: &str, pixels| Recipe {
        name,
        source: "fortran.c",
        compiler: "cc",
        flags: [vec![define.into()], words(libraries)].concat(),
        pixels,
    };
    let machine = std::env::consts::ARCH;
    let xgks =
        format!("-L/usr/lib/{machine}-linux-gnu/fortran/gfortran -lxgks -ludport -lgfortran -lX11 -lm");
    recipes.push(fortran(
        "NCAR",
        "-DNCAR",
        "-lncarg_gks -lncarg_c -lgfortran -lcairo -lfreetype -lX11 -lm",
        "png",
    ));
    recipes.push(fortran("XGKS", "-DXGKS", &xgks, "window"));
    match std::env::var(BLEND2D) {
        Ok(folder) => recipes.push(blend2d(Path::new(&folder))?),
        Err(_) => eprintln!("without Blend2D: {BLEND2D} names no folder"),
    }
    match std::env::var(GR) {
        Ok(library) => recipes.push(gr(Path::new(&library))?),
        Err(_) => eprintln!("without GR: {GR} names no libGKS.so"),
    }
    Ok(recipes)
}

/// Blend2D, which Debian does not have.
fn blend2d(folder: &Path) -> Result<Recipe, Failure> {
    let folder = folder.canonicalize().map_err(|error| format!("{BLEND2D}={}: {error}", folder.display()))?;
    let libraries = folder.join("lib").display().to_string();
    let flags = vec![
        format!("-I{}", folder.join("include").display()),
        format!("-L{libraries}"),
        "-lblend2d".into(),
        format!("-Wl,-rpath,{libraries}"),
    ];
    Ok(Recipe { name: "Blend2D", source: "blend2d.cpp", compiler: "c++", flags, pixels: "memory" })
}

/// The GKS of GR, which draws its pictures by the plug-in for cairo.
fn gr(library: &Path) -> Result<Recipe, Failure> {
    let library = library.canonicalize().map_err(|error| format!("{GR}={}: {error}", library.display()))?;
    let folder = library.parent().unwrap_or(Path::new("/")).display();
    let flags = vec![format!("-Wl,-rpath,{folder}"), library.display().to_string(), "-lm".into()];
    Ok(Recipe { name: "GR", source: "gr.c", compiler: "cc", flags, pixels: "png" })
}

/// Builds the program that draws with vello_cpu.
fn vello(sources: &Path, folder: &Path) -> Result<PathBuf, Failure> {
    let manifest = sources.with_file_name("vello").join("Cargo.toml");
    let target = sources.ancestors().nth(3).unwrap_or(folder).join("target/vello");
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--quiet", "--release", "--locked", "--manifest-path"]).arg(manifest);
    let output = cargo.arg("--target-dir").arg(&target).output()?;
    match output.status.success() {
        true => Ok(target.join("release/gks-bench-vello")),
        false => Err(String::from_utf8_lossy(&output.stderr).trim().to_owned().into()),
    }
}

fn compile(recipe: &Recipe, sources: &Path, binary: &Path) -> Result<(), Failure> {
    let object = binary.with_extension("o");
    let compiled = |command: &mut Command| -> Result<(), Failure> {
        let output = command.output()?;
        match output.status.success() {
            true => Ok(()),
            false => Err(String::from_utf8_lossy(&output.stderr).trim().to_owned().into()),
        }
    };
    let c = |compiler: &str| {
        let mut command = Command::new(compiler);
        command.arg("-O2").current_dir(sources);
        command
    };
    compiled(c("cc").args(["-c", "main.c", "-o"]).arg(&object))?;
    compiled(c(recipe.compiler).arg(recipe.source).arg(&object).args(&recipe.flags).arg("-o").arg(binary))
}
