//! Connection identifiers: which file a workstation writes.

use crate::sink::{FileSink, StdoutSink, before_extension, extension};
use gks_pipeline::device::Sink;
use std::io;

/// Extensions of metafiles that other implementations write and that a picture here should not have.
const METAFILES: [&str; 6] = ["cgm", "ncgm", "gksm", "gks", "mf", "wmf"];

/// Where a workstation writes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Target {
    /// The file name; `-` is the standard output.
    pub(crate) name: String,
    /// Whether it is made up here and may be changed: the program has not asked for this very file.
    pub(crate) invented: bool,
}

impl Target {
    /// The file that the connection identifier of a program means: the file of that name, or `gks.N.ext`
    /// for a number N, or `gks.ext` for none.
    pub(crate) fn of_program(connection: &str, extension: &str) -> Target {
        let connection = connection.trim();
        let invented = |name| Target { name, invented: true };
        if connection.is_empty() {
            invented(format!("gks.{extension}"))
        } else if connection.bytes().all(|b| b.is_ascii_digit()) {
            invented(format!("gks.{connection}.{extension}"))
        } else {
            Target { name: connection.to_owned(), invented: false }
        }
    }

    /// The same for a program that expects another type of workstation, and that may name a window or a
    /// file of another format: the file has the extension of the type that it gets.
    pub(crate) fn of_redirected(connection: &str, new: &str, known: impl Fn(&str) -> bool) -> Target {
        let connection = connection.trim();
        if is_display(connection) {
            return Target::of_program("", new);
        }
        let mut target = Target::of_program(connection, new);
        if target.invented || target.name == "-" || target.name.starts_with("/dev/") {
            return target;
        }
        match extension(&target.name).map(str::to_ascii_lowercase) {
            Some(old) if old == new => {}
            Some(old) if known(&old) || METAFILES.contains(&old.as_str()) => {
                target.name.truncate(target.name.len() - old.len());
                target.name += new;
            }
            _ => target.name = format!("{}.{new}", target.name),
        }
        target
    }

    /// The file that the user of a program named; further workstations get names of their own.
    pub(crate) fn of_user(name: &str) -> Target {
        let name = name.trim();
        Target { name: name.to_owned(), invented: name != "-" && !name.starts_with("/dev/") }
    }

    /// The name, with `-2`, `-3` before the extension if it has been `used` and may be changed.
    pub(crate) fn unused(self, used: &[String]) -> String {
        let free = |name: &String| !used.contains(name);
        if !self.invented || free(&self.name) {
            return self.name;
        }
        let mut numbered = (2u32..).map(|n| before_extension(&self.name, &format!("-{n}")));
        numbered.find(free).unwrap_or(self.name)
    }
}

/// Whether a connection is the name of an X display, `host:0` or `:0.0`.
fn is_display(connection: &str) -> bool {
    let Some((host, display)) = connection.rsplit_once(':') else { return false };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    host.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-' || b == b'.')
        && display.split_once('.').map_or(digits(display), |(d, screen)| digits(d) && digits(screen))
}

/// The text of a file.
pub(crate) fn read(name: &str) -> Result<String, String> {
    std::fs::read_to_string(name).map_err(|error| format!("{name}: {error}"))
}

/// The sink that writes a file, or the standard output for `-`.
pub(crate) fn open(name: &str) -> io::Result<Box<dyn Sink>> {
    match name {
        "-" => Ok(Box::new(StdoutSink::new())),
        _ => Ok(Box::new(FileSink::create(name)?)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_nothing_get_names() {
        let name = |connection: &str| Target::of_program(connection, "svg").name;
        assert_eq!(name(""), "gks.svg");
        assert_eq!(name("  "), "gks.svg");
        assert_eq!(name("2"), "gks.2.svg");
        assert_eq!(name(" 18  "), "gks.18.svg");
        assert_eq!(name("my file.dat "), "my file.dat");
        assert_eq!(name("-1"), "-1");
        assert_eq!(name("-"), "-");
    }

    #[test]
    fn redirected_files_have_the_extension_of_what_is_written() {
        let known = |extension: &str| extension == "png" || extension == "pdf";
        let name = |connection: &str| Target::of_redirected(connection, "png", known).name;
        assert_eq!(name("out.PNG"), "out.PNG");
        assert_eq!(name("a.b/out.pdf"), "a.b/out.png");
        assert_eq!(name("gmeta.ncgm"), "gmeta.png");
        assert_eq!(name("gmeta"), "gmeta.png");
        assert_eq!(name("figure.1"), "figure.1.png");
        assert_eq!(name(":0.0"), "gks.png");
        assert_eq!(name("host.site:10"), "gks.png");
        assert_eq!(name("c:out"), "c:out.png");
        assert_eq!(name("7"), "gks.7.png");
        assert_eq!(name("/dev/null"), "/dev/null");
        assert_eq!(name("-"), "-");
    }

    #[test]
    fn only_invented_names_give_way() {
        let used = ["gks.2.png", "out%d.png", "out%d-2.png", "own.png", "-"].map(str::to_owned);
        assert_eq!(Target::of_program("2", "png").unused(&used), "gks.2-2.png");
        assert_eq!(Target::of_program("3", "png").unused(&used), "gks.3.png");
        assert_eq!(Target::of_program("own.png", "png").unused(&used), "own.png");
        assert_eq!(Target::of_user("out%d.png").unused(&used), "out%d-3.png");
        assert_eq!(Target::of_user("-").unused(&used), "-");
    }
}
