//! The comparison with other libraries: `tests/bench/run` in the sources starts it.
//!
//! - `gks-bench table [--rounds N] [--once] [--report] [--readme FILE] [WORKLOAD...]` measures and prints the tables,
//!   and puts them into a file between its markers. It fails if a gate is missed, with `--report` never, and with
//!   `--once` not for a time, of which a single measurement says little.
//! - `gks-bench growth [--rounds N] [--report] [WORKLOAD...]` compares what ten million of something cost with a
//!   hundred thousand, and fails if a primitive costs more or a document takes more memory.
//! - `gks-bench measure WORKLOAD SIZE` is what that starts.
//! - `gks-bench data FOLDER` writes the data that the C programs read.
//! - `gks-bench instructions [--accept]` counts instructions of a few kernels and compares them with the accepted
//!   counts; `gks-bench kernel NAME` is what is counted.
//! - `gks-bench draw WORKLOAD REPETITIONS` draws with tiny-skia and prints what it cost.

mod comparison;
mod cost;
mod data;
mod gate;
mod growth;
mod instructions;
mod kernel;
mod machine;
mod peer;
mod profile;
mod table;

use comparison::Comparison;
use gate::Gate;
use growth::Growth;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What ends the comparison early.
type Failure = Box<dyn Error>;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["instructions"] => return exit(instructions::run(false)),
        ["instructions", "--accept"] => return exit(instructions::run(true)),
        ["kernel", name] => kernel::run(name),
        ["data", folder] => data::write(Path::new(folder)),
        ["draw", workload, repetitions] => draw(workload, repetitions),
        ["table", ref rest @ ..] => return exit(compare(rest)),
        ["growth", ref rest @ ..] => return exit(grow(rest)),
        ["measure", workload, size] => measure(workload, size),
        _ => Err("usage: gks-bench table | growth | instructions | kernel NAME | data FOLDER | \
            draw WORKLOAD REPETITIONS | measure WORKLOAD SIZE"
            .into()),
    };
    exit(done.map(|()| ExitCode::SUCCESS))
}

fn exit(done: Result<ExitCode, Failure>) -> ExitCode {
    match done {
        Ok(code) => code,
        Err(failure) => {
            eprintln!("gks-bench: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn draw(workload: &str, repetitions: &str) -> Result<(), Failure> {
    let cost = peer::draw(workload, repetitions.parse()?)?;
    println!("{}", serde_json::to_string(&cost)?);
    Ok(())
}

fn measure(workload: &str, size: &str) -> Result<(), Failure> {
    println!("{}", serde_json::to_string(&growth::measure(workload, size.parse()?)?)?);
    Ok(())
}

fn compare(arguments: &[&str]) -> Result<ExitCode, Failure> {
    let mut comparison = Comparison::default();
    let (mut readme, mut report) = (None, false);
    let mut rest = arguments.iter();
    while let Some(&argument) = rest.next() {
        match argument {
            "--once" => comparison.once = true,
            "--report" => report = true,
            "--rounds" => comparison.rounds = rest.next().ok_or("how many rounds?")?.parse()?,
            "--readme" => readme = Some(PathBuf::from(rest.next().ok_or("which file?")?)),
            name => comparison.workloads.push(name.to_owned()),
        }
    }
    let rows = comparison.run()?;
    let text = table::text(&rows);
    println!("{text}");
    if let Some(file) = readme {
        table::insert(&file, &text)?;
    }
    let counts = |gate: &Gate| !(comparison.once && gate.is_of_time());
    Ok(judge(&rows.iter().flat_map(|row| table::missed(row, counts)).collect::<Vec<_>>(), report))
}

fn grow(arguments: &[&str]) -> Result<ExitCode, Failure> {
    let (mut growth, mut report) = (Growth::default(), false);
    let mut rest = arguments.iter();
    while let Some(&argument) = rest.next() {
        match argument {
            "--report" => report = true,
            "--rounds" => growth.rounds = rest.next().ok_or("how many rounds?")?.parse()?,
            name => growth.workloads.push(name.to_owned()),
        }
    }
    Ok(judge(&growth.run()?, report))
}

/// Says which gates are missed, and fails for them unless they are only to be reported.
fn judge(missed: &[String], report: bool) -> ExitCode {
    for gate in missed {
        eprintln!("missed: {gate}");
    }
    if missed.is_empty() || report { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
