//! `gks run`: runs a program that was built for another GKS, or for this one, with the right library in front.

use super::Failure;
use crate::binary::{Binary, Kind};
use crate::libraries::Library;
use crate::loading::{Loading, which};
use gks_workstations::catalogue::Drivers;
use gks_workstations::dialect::Dialect;
use std::env;
use std::ffi::{OsStr, OsString};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, ExitCode};

/// What the user asks for beside the program.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    /// The dialect; none has the program looked at.
    pub dialect: Option<Dialect>,
    /// The workstation type that the program draws on.
    pub on: Option<String>,
    /// The file that it writes.
    pub output: Option<String>,
}

/// The library that stands in for the GKS of a program.
struct StandIn {
    library: &'static Library,
    /// The name by which the program asks for it.
    name: String,
    /// Whether the program looks for it where the environment has no say.
    insists: bool,
}

/// Runs a program with arguments in the place of this command. Returns only if that is impossible.
pub fn run(wishes: &Wishes, program: &OsStr, arguments: &[OsString]) -> Result<ExitCode, Failure> {
    let path = which(Path::new(program)).ok_or_else(|| format!("{}: no such program", program.display()))?;
    let stand_in = choose(&path, wishes.dialect)?;
    let mut command = Command::new(&path);
    command.arg0(program).args(arguments);
    let folder = stand_in.library.folder_with(&stand_in.name)?;
    if stand_in.insists {
        command.env("LD_PRELOAD", in_front(folder.join(&stand_in.name).as_os_str(), "LD_PRELOAD"));
    } else {
        command.env("LD_LIBRARY_PATH", in_front(folder.as_os_str(), "LD_LIBRARY_PATH"));
    }
    if wishes.dialect.is_some() {
        command.env("GKS_DIALECT", stand_in.library.dialect.name());
    }
    if let Some(output) = &wishes.output {
        command.env("GKS_CONID", output);
    }
    // The extension of the file says what it is where nothing else does.
    let by_file = wishes.output.as_deref().filter(|name| Drivers::choose(name).is_some());
    if let Some(wish) = wishes.on.as_deref().or(by_file) {
        if Drivers::choose(wish).is_none() {
            return Err(format!("{wish}: no such workstation type; `gks workstations` lists them").into());
        }
        command.env("GKS_WSTYPE", wish).env("GKS_WSTYPE_FORCE", "1");
    }
    Err(format!("{}: {}", path.display(), command.exec()).into())
}

fn choose(path: &Path, dialect: Option<Dialect>) -> Result<StandIn, Failure> {
    let read = Binary::read(path);
    if let Some(library) = dialect.and_then(Library::of) {
        // What cannot be read, such as a script, may run what needs the library.
        let loading = read.ok().map(|binary| Loading::of(path, binary));
        let asked =
            loading.as_ref().and_then(Loading::gks).filter(|(asked, _)| asked.dialect == library.dialect);
        let name = asked.map_or(library.soname, |(_, name)| name).to_owned();
        let insists = loading.is_some_and(|loading| loading.insists(&name));
        return Ok(StandIn { library, name, insists });
    }
    let binary = read?;
    if matches!(binary.kind, Kind::Object | Kind::Archive) {
        let link = "link it: gks cc or gks fc with its name";
        return Err(format!("{}: {}, no program; {link}", path.display(), binary.kind.describe()).into());
    }
    if binary.kind == Kind::Static {
        let relink = "link it again with libgks.a (`gks doctor` says how)";
        return Err(format!("{}: statically linked; {relink}", path.display()).into());
    }
    let loading = Loading::of(path, binary);
    let Some((library, name)) = loading.gks() else {
        return Err(format!("{}: needs no GKS that is known here; see `gks doctor`", path.display()).into());
    };
    Ok(StandIn { library, name: name.to_owned(), insists: loading.insists(name) })
}

/// A value with those that a variable has already behind it.
fn in_front(value: &OsStr, variable: &str) -> OsString {
    let mut list = value.to_owned();
    if let Some(more) = env::var_os(variable).filter(|more| !more.is_empty()) {
        list.push(":");
        list.push(more);
    }
    list
}
