//! Where the time of a program goes: instructions counted by function.

use std::path::Path;
use std::process::Command;

/// How many functions are told.
const FUNCTIONS: usize = 5;

/// The functions of a program in which most instructions are executed, with their share; none where valgrind is
/// not installed.
pub(crate) fn hottest(words: &[String], folder: &Path) -> Vec<String> {
    let counts = folder.join("callgrind");
    if count(words, &counts, folder).is_none() {
        return Vec::new();
    }
    let annotated = Command::new("callgrind_annotate").arg(&counts).output();
    annotated.map_or(Vec::new(), |output| functions(&String::from_utf8_lossy(&output.stdout)))
}

/// How many instructions a program executes; none where valgrind is not installed.
pub(crate) fn instructions(words: &[String], folder: &Path) -> Option<u64> {
    let said = count(words, &folder.join("callgrind"), folder)?;
    let (_, number) = said.lines().find_map(|line| line.split_once("Collected :"))?;
    number.trim().parse().ok()
}

/// Counts the instructions of a program into a file, and gives what valgrind says.
fn count(words: &[String], counts: &Path, folder: &Path) -> Option<String> {
    let mut command = Command::new("valgrind");
    command.arg("--tool=callgrind").arg(format!("--callgrind-out-file={}", counts.display()));
    let output = command.args(words).current_dir(folder).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stderr).into_owned())
}

/// The lines of functions: `1,234,567 (12.34%)  file:function [library]`.
fn functions(text: &str) -> Vec<String> {
    let hot = text.lines().filter_map(|line| {
        let (_, rest) = line.split_once('(')?;
        let (share, name) = rest.split_once("%)")?;
        let share: f64 = share.trim().parse().ok()?;
        let name = name.trim().split_once(':')?.1.split(" [").next()?;
        Some(format!("{share:.0} % {}", short(name)))
    });
    hot.take(FUNCTIONS).collect()
}

/// A function without the hash that tells apart those of one name.
fn short(name: &str) -> &str {
    name.split("::h").find(|part| part.len() > 3).unwrap_or(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_are_found_in_the_listing() {
        let text = "Profile data file\n\
            100 (100.0%)  PROGRAM TOTALS\n\
            60 (60.00%)  ???:gks_pipeline::painter::Painter::lines::h0123456789abcdef [/lib/libgks.so]\n\
            40 (40.00%)  ./libc/memcpy.S:memcpy [/lib/libc.so]\n";
        assert_eq!(functions(text), ["60 % gks_pipeline::painter::Painter::lines", "40 % memcpy"]);
    }
}
