//! The machine on which is measured, in one line.

use std::fs;
use std::process::Command;

/// Processor, number of cores, memory, system and compilers.
pub(crate) fn description() -> String {
    let field = |file: &str, key: &str| {
        let text = fs::read_to_string(file).unwrap_or_default();
        let line = text.lines().find(|line| line.starts_with(key)).map(str::to_owned);
        line.and_then(|line| Some(line.split_once([':', '='])?.1.trim().trim_matches('"').to_owned()))
    };
    let version = |program: &str| {
        let output = Command::new(program).arg("--version").output().ok()?;
        String::from_utf8(output.stdout).ok()?.lines().next().map(str::to_owned)
    };
    let processor = field("/proc/cpuinfo", "model name").unwrap_or_else(|| "unknown processor".into());
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let memory =
        field("/proc/meminfo", "MemTotal").and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    let memory = memory.map(|kib| format!("{:.0} GiB", kib / 1024.0 / 1024.0));
    let parts = [
        Some(format!("{processor}, {cores} cores")),
        memory,
        field("/etc/os-release", "PRETTY_NAME"),
        version("rustc"),
        version("cc"),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join("; ")
}
