//! Programs in other languages that check themselves: compiled, linked with `libgks` and run.

use std::env;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// How a program takes the library.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Linking {
    /// `libgks.so`.
    Shared,
    /// `libgks.a`.
    Static,
}

/// The top of the repository.
pub fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests lie in a folder of the repository")
}

/// The folder of `libgks`, which is built if it is not up to date.
pub fn library() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let file = built("libgks", "libgks.a");
        file.parent().expect("the library lies in a folder").to_owned()
    })
}

/// A library of a package, which is built if it is not up to date.
pub fn built(package: &str, library: &str) -> PathBuf {
    let built = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        // Together with the command dependencies have the features that they have in the whole workspace.
        .args(["build", "--quiet", "--package", package, "--package", "gks-cli", "--message-format", "json"])
        .current_dir(repository())
        .output()
        .expect("cargo runs");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    // The report of cargo names the files of each package that it built or found up to date.
    let report = String::from_utf8_lossy(&built.stdout);
    let mut files = report.split('"').filter(|word| word.ends_with(&format!("/{library}")));
    PathBuf::from(files.next_back().expect("cargo reports the library"))
}

/// Whether there is a compiler; says loudly if there is none.
pub fn has_compiler(compiler: &str) -> bool {
    let found = Command::new(compiler).arg("--version").output().is_ok();
    if !found {
        // Not a macro, whose text would be shown for failed tests only.
        let _ = std::io::stderr().write_all(format!("\nSKIPPED: {compiler} is not installed\n").as_bytes());
    }
    found
}

/// An empty folder for the files of a program, below the folder for temporary files of the tests.
pub fn folder(temporary: &str, language: &str, name: &str) -> PathBuf {
    let folder = Path::new(temporary).join(language).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder for the program");
    folder
}

/// Runs a compiler that has its sources and options, linking with the library.
pub fn compile(compiler: &mut Command, linking: Linking) {
    let library = library();
    match linking {
        Linking::Shared => {
            compiler.arg("-L").arg(library).arg("-lgks").arg(format!("-Wl,-rpath,{}", library.display()))
        }
        Linking::Static => compiler.arg(library.join("libgks.a")),
    };
    let compiled = compiler.args(["-lm", "-lpthread", "-ldl"]).output().expect("the compiler runs");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
}

/// Runs a program in its folder, without what the environment of the tests says to GKS.
pub fn run(program: &Path, environment: &[(&str, &str)]) -> Output {
    let mut command = Command::new(program);
    for (name, _) in env::vars().filter(|(name, _)| name.starts_with("GKS_")) {
        command.env_remove(name);
    }
    command.current_dir(program.parent().expect("a program lies in a folder"));
    command.envs(environment.iter().copied()).output().expect("the program runs")
}

/// An example of XGKS: installed, or else taken out of the package of Debian, which is downloaded once.
pub fn example(name: &str) -> Option<PathBuf> {
    const EXAMPLES: &str = "usr/share/doc/libxgks-dev/examples";
    let folder = repository().join("target/legacy/xgks");
    let find = || {
        let roots = [Path::new("/"), &folder];
        roots.map(|root| root.join(EXAMPLES).join(name)).into_iter().find(|file| file.exists())
    };
    if find().is_none() {
        fs::create_dir_all(&folder).ok()?;
        let unpack = "apt-get download -qq libxgks-dev && dpkg-deb -x libxgks-dev_*.deb .";
        Command::new("sh").args(["-c", unpack]).current_dir(&folder).output().ok()?;
    }
    find()
}

/// Checks that a program found nothing wrong, whose last word is then `good`.
pub fn assert_good(output: &Output) {
    let text = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    let is_good = output.status.success() && text.trim_end().ends_with("good");
    assert!(is_good, "{}:\n{text}{errors}", output.status);
}
