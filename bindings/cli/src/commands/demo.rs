//! `gks demo`: the demonstration pictures on several devices.

use super::{Failure, extension};
use crate::{demo, towers};
use gks::Gks;
use gks_pipeline::description::{Catalogue, Category};
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use phigs::Phigs;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// Draws the pictures on the devices of `on` into files in `folder` and prints a table.
pub fn run(on: &str, folder: &Path) -> Result<ExitCode, Failure> {
    fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    println!("{:<14} {:<32} {:>10} {:>9}", "device", "file", "bytes", "time");
    for (kind, name, extension) in devices(on)? {
        let file = folder.join(format!("demo{}.{extension}", variant(name, extension)));
        show(name, &file, || gks_picture(kind, &file))?;
    }
    for (kind, name, extension) in
        devices(on)?.into_iter().filter(|(_, name, _)| ["png", "svg", "hpgl"].contains(name))
    {
        let file = folder.join(format!("phigs.{extension}"));
        show(name, &file, || phigs_picture(kind, &file))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The devices as the command line chooses them: of the environment only `GKS_OPTIONS` counts.
fn own_choice() -> Drivers {
    Drivers::new(Environment { options: Environment::from_process().options, ..Environment::default() })
}

/// What tells apart the files of devices that share an extension.
fn variant(name: &str, extension: &str) -> String {
    if name == extension || name == "hpgl" || name == "jpeg" || name == "tiff" {
        String::new()
    } else {
        format!("-{name}")
    }
}

/// The workstation types with their names and extensions.
fn devices(on: &str) -> Result<Vec<(i32, &'static str, &'static str)>, Failure> {
    let drivers = own_choice();
    let all: Vec<i32> = drivers.types().into_iter().filter(|&t| t != 0).collect();
    let chosen: Vec<i32> = if on == "all" {
        all
    } else {
        on.split(',')
            .map(|word| Drivers::choose(word).ok_or_else(|| format!("no workstation type {word}")))
            .collect::<Result<_, _>>()?
    };
    let described = chosen.into_iter().filter_map(|t| drivers.describe(t));
    Ok(described
        .filter(|d| matches!(d.category, Category::Output | Category::MetafileOutput))
        .map(|d| (d.number, d.name, extension(d.number)))
        .filter(|(_, _, extension)| !extension.is_empty())
        .collect())
}

fn show(name: &str, file: &Path, picture: impl FnOnce() -> Result<(), Failure>) -> Result<(), Failure> {
    let start = Instant::now();
    picture()?;
    let time = start.elapsed().as_secs_f64() * 1000.0;
    let bytes = fs::metadata(file).map_err(|e| format!("{}: {e}", file.display()))?.len();
    println!("{name:<14} {:<32} {bytes:>10} {time:>6.0} ms", file.display());
    Ok(())
}

/// The demonstration picture of GKS.
pub fn gks_picture(kind: i32, file: &Path) -> Result<(), Failure> {
    let mut gks = Gks::open(Box::new(own_choice()));
    gks.open_workstation(1, &file.to_string_lossy(), kind)?;
    gks.activate_workstation(1)?;
    demo::draw(&mut gks, 1)?;
    gks.deactivate_workstation(1)?;
    gks.close_workstation(1)?;
    gks.close_gks()?;
    Ok(())
}

/// The demonstration picture of PHIGS.
pub fn phigs_picture(kind: i32, file: &Path) -> Result<(), Failure> {
    let mut phigs = Phigs::open(Box::new(own_choice()));
    phigs.open_workstation(1, &file.to_string_lossy(), kind)?;
    towers::draw(&mut phigs, 1)?;
    phigs.close_workstation(1)?;
    Ok(())
}
