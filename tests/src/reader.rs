//! Programs that nobody here wrote and that read what the drivers write.

use std::env;
use std::io::Write;
use std::process::{Command, Output, Stdio};

/// The programs among `names` that this machine lacks.
pub fn missing<'n>(names: &[&'n str]) -> Vec<&'n str> {
    let path = env::var_os("PATH").unwrap_or_default();
    let folders: Vec<_> = env::split_paths(&path).collect();
    names.iter().copied().filter(|name| !folders.iter().any(|folder| folder.join(name).is_file())).collect()
}

/// Whether a test that needs the programs `names` can run. Where it cannot, it says so on the standard error,
/// also in tests that pass.
///
/// # Panics
/// Where a program is missing and the environment has `CI=true`.
pub fn present(test: &str, names: &[&str]) -> bool {
    let missing = missing(names);
    if missing.is_empty() {
        return true;
    }
    let missing = missing.join(", ");
    let continuous = env::var("CI").is_ok_and(|value| value == "true");
    assert!(!continuous, "{test} needs programs that are missing: {missing}");
    skip(test, &format!("missing programs: {missing}"));
    false
}

/// Says that a test is skipped, past the capture of the output of tests.
pub fn skip(test: &str, reason: &str) {
    let _ = writeln!(std::io::stderr(), "SKIP {test}: {reason}");
}

/// Runs a program for at most `seconds`. An error is a message with what the program said.
pub fn run(seconds: u32, program: &str, arguments: &[&str]) -> Result<Output, String> {
    let mut command = Command::new("timeout");
    command.arg(seconds.to_string()).arg(program).args(arguments).stdin(Stdio::null());
    let output = command.output().map_err(|error| format!("{program}: {error}"))?;
    if output.status.success() {
        return Ok(output);
    }
    let said = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim().to_owned();
    let (out, err) = (said(&output.stdout), said(&output.stderr));
    Err(format!("{program} {}: {}\n{out}\n{err}", arguments.join(" "), output.status))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_are_found_and_run_in_time() {
        assert_eq!(missing(&["sh", "no-such-program"]), ["no-such-program"]);
        assert_eq!(run(10, "sh", &["-c", "echo seen"]).unwrap().stdout, b"seen\n");
        let said = run(10, "sh", &["-c", "echo seen; echo told >&2; exit 3"]).unwrap_err();
        assert!(said.contains("seen") && said.contains("told") && said.contains('3'), "{said}");
        assert!(run(1, "sleep", &["30"]).is_err());
    }
}
