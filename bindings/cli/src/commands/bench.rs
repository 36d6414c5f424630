//! `gks bench`: what drawing costs.

use super::Failure;
use crate::bench::clock::median;
use crate::bench::measurement::{self, Effort, Folder, Measurement};
use crate::bench::report::{self, Report};
use crate::bench::workload::{self, Way, Workload};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, ExitCode};

/// How often a process is started whose whole time is measured.
const STARTS: usize = 11;

/// What is asked of the benchmarks.
#[derive(Debug)]
pub struct Wish {
    /// The names of workloads; all if there are none.
    pub workloads: Vec<String>,
    /// As JSON.
    pub json: bool,
    /// Each once, at its smallest size, to see that it works.
    pub once: bool,
}

/// Measures workloads and prints a table or JSON.
pub fn run(wish: &Wish) -> Result<ExitCode, Failure> {
    let all = workload::all();
    let find = |name: &String| {
        all.iter().find(|w| w.name == *name).ok_or_else(|| {
            let names: Vec<&str> = all.iter().map(|w| w.name.as_str()).collect();
            format!("no workload {name}; the workloads are {}", names.join(", "))
        })
    };
    let chosen: Vec<&Workload> = match wish.workloads.is_empty() {
        true => all.iter().collect(),
        false => wish.workloads.iter().map(find).collect::<Result<_, _>>()?,
    };
    let mut reports = BTreeMap::new();
    if !wish.json {
        println!("{}", report::heading());
    }
    for workload in chosen {
        let report = measured(workload, wish.once)?;
        if wish.json {
            reports.insert(&workload.name, report);
        } else {
            println!("{}", report::line(workload, &report));
        }
    }
    if wish.json {
        print_json(&reports)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    println!("{}", serde_json::to_string_pretty(value)?);
    Ok(())
}

fn measured(workload: &Workload, once: bool) -> Result<Report, Failure> {
    if once {
        let nominal = in_process(workload, workload.sizes[0], Effort::Once)?;
        return Ok(Report { sizes: vec![(&nominal).into()], nominal });
    }
    let nominal = workload.nominal_size();
    if matches!(workload.way, Way::Start(_)) {
        let runs = (0..STARTS).map(|_| in_process(workload, nominal, Effort::Full));
        let runs = runs.collect::<Result<Vec<_>, _>>()?;
        let cpu_ms = median(runs.iter().map(|run| run.cpu_ms).collect());
        let nominal = Measurement { cpu_ms, ..runs.into_iter().next().unwrap_or_default() };
        return Ok(Report { sizes: vec![(&nominal).into()], nominal });
    }
    let effort = |size| if size == nominal { Effort::Full } else { Effort::Growth };
    let sizes = workload.sizes.iter().map(|&size| in_process(workload, size, effort(size)));
    let sizes = sizes.collect::<Result<Vec<_>, _>>()?;
    Ok(Report { nominal: sizes[workload.nominal].clone(), sizes: sizes.iter().map(Into::into).collect() })
}

/// Measures in a process of its own, so that nothing before it counts.
fn in_process(workload: &Workload, size: usize, effort: Effort) -> Result<Measurement, Failure> {
    let folder = Folder::new()?;
    let effort = clap::ValueEnum::to_possible_value(&effort).ok_or("no such effort")?;
    let output = Command::new(std::env::current_exe()?)
        .args(["bench", "--measure", effort.get_name(), "--size", &size.to_string(), "--folder"])
        .arg(folder.path())
        .arg(&workload.name)
        .stderr(std::process::Stdio::inherit())
        .output()?;
    if !output.status.success() {
        return Err(format!("{} at {size}: {}", workload.name, output.status).into());
    }
    Ok(serde_json::from_slice(&output.stdout)?)
}

/// Measures one workload at one size in this process, for [`run`] in another one.
pub fn measure(name: &str, size: usize, effort: Effort, folder: &Path) -> Result<ExitCode, Failure> {
    let workload = workload::all().into_iter().find(|w| w.name == name);
    let workload = workload.ok_or_else(|| format!("no workload {name}"))?;
    print_json(&measurement::measure(&workload, size, effort, folder)?)?;
    Ok(ExitCode::SUCCESS)
}
