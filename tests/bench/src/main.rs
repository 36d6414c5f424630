//! The comparison with other libraries: `tests/bench/run` in the sources starts it.
//!
//! - `gks-bench table [--rounds N] [--once] [--readme FILE] [WORKLOAD...]` measures and prints the tables, and
//!   puts them into a file between its markers.
//! - `gks-bench data FOLDER` writes the data that the C programs read.
//! - `gks-bench instructions [--accept]` counts instructions of a few kernels and compares them with the accepted
//!   counts; `gks-bench kernel NAME` is what is counted.
//! - `gks-bench draw WORKLOAD REPETITIONS` draws with tiny-skia and prints what it cost.

mod comparison;
mod cost;
mod data;
mod gate;
mod instructions;
mod kernel;
mod machine;
mod peer;
mod profile;
mod table;

use comparison::Comparison;
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
        ["table", ref rest @ ..] => compare(rest),
        _ => Err(
            "usage: gks-bench table | instructions | kernel NAME | data FOLDER | draw WORKLOAD REPETITIONS"
                .into(),
        ),
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

fn compare(arguments: &[&str]) -> Result<(), Failure> {
    let mut comparison = Comparison::default();
    let mut readme = None;
    let mut rest = arguments.iter();
    while let Some(&argument) = rest.next() {
        match argument {
            "--once" => comparison.once = true,
            "--rounds" => comparison.rounds = rest.next().ok_or("how many rounds?")?.parse()?,
            "--readme" => readme = Some(PathBuf::from(rest.next().ok_or("which file?")?)),
            name => comparison.workloads.push(name.to_owned()),
        }
    }
    let rows = comparison.run()?;
    let text = table::text(&rows);
    println!("{text}");
    match readme {
        Some(file) => table::insert(&file, &text),
        None => Ok(()),
    }
}
