//! `gks doctor`: which functions of GKS a program, library or object needs, and what to do to have it draw here.

use super::Failure;
use crate::binary::{Binary, Kind};
use crate::libraries::{LIBRARIES, Library};
use crate::loading::{Loading, which};
use gks::Function;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::ExitCode;

/// What is found out about a file.
struct Findings {
    kind: Kind,
    /// The library that the program asks for, with the name that it uses.
    asked: Option<(&'static Library, String)>,
    /// The functions of GKS that it needs.
    needs: BTreeSet<String>,
    /// The functions that are in the program itself.
    own: usize,
}

/// Prints the findings. Succeeds if something is needed and one of our libraries has all of it.
pub fn run(path: &Path) -> Result<ExitCode, Failure> {
    // A file that is here comes before a program of its name.
    let path = if path.is_file() { Some(path.to_path_buf()) } else { which(path) }
        .ok_or_else(|| format!("{}: no such file", path.display()))?;
    let offers: Vec<(&Library, BTreeSet<String>)> = LIBRARIES
        .iter()
        .filter_map(|library| Some((library, Binary::read(&library.find().ok()?).ok()?.offered)))
        .collect();
    let findings = examine(&path, &offers)?;
    println!("{}: {}", path.display(), describe(&findings));
    if findings.needs.is_empty() {
        println!("{}", advise(&path, &findings, None));
        return Ok(ExitCode::FAILURE);
    }
    println!("needs {} functions of GKS:", findings.needs.len());
    let mut fits = None;
    for (library, offered) in &offers {
        let missing: Vec<&str> = findings.needs.difference(offered).map(String::as_str).collect();
        let there = findings.needs.len() - missing.len();
        println!("  {:<22} has {there:>3}{}", library.soname, list(&missing));
        let asked = findings.asked.as_ref().is_some_and(|(asked, _)| asked.dialect == library.dialect);
        if missing.is_empty() && (asked || (findings.asked.is_none() && fits.is_none())) {
            fits = Some(*library);
        }
    }
    println!("{}", advise(&path, &findings, fits));
    Ok(if fits.is_some() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// A few missing names.
fn list(missing: &[&str]) -> String {
    const MOST: usize = 12;
    if missing.is_empty() {
        return String::new();
    }
    let more =
        if missing.len() > MOST { format!(" and {} more", missing.len() - MOST) } else { String::new() };
    format!(", not {}{more}", missing[..missing.len().min(MOST)].join(" "))
}

fn examine(path: &Path, offers: &[(&Library, BTreeSet<String>)]) -> Result<Findings, Failure> {
    let binary = Binary::read(path)?;
    let known = |symbol: &str| {
        is_standard(symbol) || offers.iter().any(|(_, offered)| is_ours(symbol) && offered.contains(symbol))
    };
    let kind = binary.kind;
    let own = binary.offered.iter().filter(|symbol| is_standard(symbol)).count();
    if !matches!(kind, Kind::Dynamic | Kind::Library) {
        let needs = binary.wanted.into_iter().filter(|symbol| known(symbol)).collect();
        return Ok(Findings { kind, asked: None, needs, own });
    }
    let loading = Loading::of(path, binary);
    let asked = loading.gks().map(|(library, name)| (library, name.to_owned()));
    let original = asked.as_ref().and_then(|(_, name)| loading.libraries.get(name)?.as_ref());
    // Where the original library is there it tells what is a function of it; what others offer as well, such as
    // HLU with its own OPEN WORKSTATION, is not needed from a GKS.
    let libraries = loading.libraries.iter().filter(|(name, _)| Library::by_name(name).is_none());
    let others: Vec<&Binary> = libraries.filter_map(|(_, found)| found.as_ref().map(|(_, b)| b)).collect();
    let wanted = others.iter().copied().chain([&loading.program]).flat_map(|binary| &binary.wanted);
    let wanted = wanted.chain(&loading.program.variables);
    let needs = wanted.filter(|symbol| match original {
        Some((_, original)) => original.offered.contains(*symbol),
        None => known(symbol),
    });
    let needs: BTreeSet<String> = needs
        .filter(|symbol| !others.iter().any(|binary| binary.offered.contains(*symbol)))
        .cloned()
        .collect();
    Ok(Findings { kind, asked, needs, own })
}

/// Whether a symbol is a function of the standard, in Fortran or in C.
fn is_standard(symbol: &str) -> bool {
    let fortran = symbol.strip_suffix('_').map(str::to_ascii_uppercase);
    Function::ALL.into_iter().any(|function| {
        function.c() == Some(symbol)
            || fortran.as_deref().is_some_and(|name| function.fortran().contains(&name))
    })
}

/// Whether a symbol of one of our libraries is a function of GKS, and not of the language it is written in.
fn is_ours(symbol: &str) -> bool {
    symbol.starts_with('g') || symbol.starts_with("Xgks") || symbol.starts_with("GIF")
}

fn describe(findings: &Findings) -> String {
    let kind = findings.kind.describe();
    match &findings.asked {
        Some((library, name)) => format!("{kind} for the GKS of {} ({name})", library.family),
        None => kind.to_owned(),
    }
}

/// What to do.
fn advise(path: &Path, findings: &Findings, fits: Option<&Library>) -> String {
    let name = path.display();
    if findings.needs.is_empty() && findings.own > 0 {
        return format!(
            "has {} functions of GKS in itself: link its objects again with libgks.a in the place of its GKS",
            findings.own
        );
    }
    if findings.needs.is_empty() {
        return "needs no function of GKS that is known here; if it draws with a GKS that is linked into it, link it \
                again with libgks.a in the place of that"
            .to_owned();
    }
    match (findings.kind, fits) {
        (_, None) => {
            "no library here has all of them; what is missing ends a program when it is called, or at \
             once where all symbols are bound at the start"
                .to_owned()
        }
        (Kind::Dynamic, Some(_)) if findings.asked.is_some() => {
            format!("run it unchanged: gks run --on svg -- {name}")
        }
        (Kind::Dynamic, Some(library)) => {
            format!("run it unchanged: gks run --dialect {} --on svg -- {name}", library.dialect.name())
        }
        (Kind::Library, Some(library)) => {
            format!("programs that load it run with {}: gks run --on svg -- PROGRAM", library.soname)
        }
        (_, Some(_)) => format!("link it: gks fc {name} (Fortran) or gks cc {name} (C)"),
    }
}
