//! Writes metafiles of any size and plays them, and says how much memory that took.
//!
//!     volume write TYPE CONNECTION MIB     pages with every kind of primitive, until the file has so many MiB
//!     volume play FILE                     on a workstation that draws nothing
//!
//! The peak of the resident memory, in KiB, is the only output.

use gks::{Gks, Result};
use gks_metafile::{ReadOptions, open_source};
use gks_pipeline::generated::numbers::workstation_type as own;
use gks_pipeline::look::InteriorStyle;
use gks_tests::random::Random;
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use std::env;
use std::fs::{self, File};
use std::process::ExitCode;

/// About how many octets a page takes.
const PAGE: usize = 1 << 20;

fn page(gks: &mut Gks, random: &mut Random) -> Result<()> {
    let mut points =
        |count: usize| -> Vec<(f64, f64)> { (0..count).map(|_| (random.unit(), random.unit())).collect() };
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    for colour in 1..=8 {
        gks.set_polyline_colour_index(colour)?;
        gks.polyline(&points(4000))?;
        gks.polymarker(&points(1000))?;
        gks.set_fill_area_colour_index(colour)?;
        gks.fill_area(&points(100))?;
        let corners = points(2);
        gks.text(corners[0], "Text between the other primitives")?;
        let cells: Vec<i32> = (0..64 * 64).map(|cell| cell % 16).collect();
        gks.cell_array_of(corners[0], corners[1], &cells, 64, 64, 64)?;
    }
    Ok(())
}

fn open() -> Gks {
    Gks::open(Box::new(Drivers::new(Environment::default())))
}

fn write(kind: i32, connection: &str, mib: usize) -> Result<()> {
    let (mut gks, mut random) = (open(), Random::new(1));
    gks.open_workstation(1, connection, kind)?;
    gks.activate_workstation(1)?;
    for _ in 0..(mib << 20) / PAGE {
        page(&mut gks, &mut random)?;
        gks.clear_workstation(1, true)?;
    }
    gks.deactivate_workstation(1)?;
    gks.close_workstation(1)
}

fn play(file: &str) -> std::result::Result<(), String> {
    let file = File::open(file).map_err(|error| error.to_string())?;
    let mut source = open_source(file, &ReadOptions::default()).map_err(|error| error.to_string())?.source;
    let mut gks = open();
    let opened = gks.open_workstation(1, "", own::NULL).and_then(|()| gks.activate_workstation(1));
    opened.map_err(|error| error.to_string())?;
    while let Some(record) = source.next().map_err(|error| error.to_string())? {
        gks.interpret(&record).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// The peak of the resident memory in KiB, as Linux counts it.
fn peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        ["write", kind, connection, mib] => match (kind.parse(), mib.parse()) {
            (Ok(kind), Ok(mib)) => write(kind, connection, mib).map_err(|error| error.to_string()),
            _ => Err("a type and a size are numbers".to_owned()),
        },
        ["play", file] => play(file),
        _ => Err("volume write TYPE CONNECTION MIB, or volume play FILE".to_owned()),
    };
    match (done, peak()) {
        (Ok(()), Some(peak)) => {
            println!("{peak}");
            ExitCode::SUCCESS
        }
        (Err(error), _) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
        (Ok(()), None) => {
            eprintln!("this system does not say how much memory a process takes");
            ExitCode::FAILURE
        }
    }
}
