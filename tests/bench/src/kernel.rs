//! The kernels whose instructions are counted.

use crate::Failure;
use gks::{Gks, Points};
use gks_cli::bench::measurement::{self, Folder};
use gks_cli::bench::workload;
use gks_pipeline::generated::numbers::workstation_type as own;
use std::hint::black_box;

/// A kernel: its name, and what is made ready before it runs.
pub(crate) struct Kernel {
    /// The name in the table of counts.
    pub(crate) name: &'static str,
    prepare: fn(&Folder) -> Result<Run, Failure>,
}

/// What runs once, counted.
type Run = Box<dyn FnOnce() -> gks::Result<()>>;

/// All kernels.
pub(crate) const KERNELS: [Kernel; 5] = [
    Kernel { name: "100000 polylines on the null workstation", prepare: |_| calls() },
    Kernel { name: "w1 at 100000 on a frame buffer", prepare: |_| drawing("w1", 100_000) },
    Kernel { name: "w4a at 1000 on a frame buffer", prepare: |_| drawing("w4a", 1_000) },
    Kernel { name: "w5 at 1000 on a frame buffer", prepare: |_| drawing("w5", 1_000) },
    Kernel { name: "w1 at 100000 as SVG", prepare: |folder| document("w1", 100_000, folder) },
];

/// Runs a kernel. Only what happens in [`measured`] is counted.
pub(crate) fn run(name: &str) -> Result<(), Failure> {
    let kernel = KERNELS.into_iter().find(|kernel| kernel.name == name);
    let kernel = kernel.ok_or_else(|| format!("no kernel {name}"))?;
    let folder = Folder::new()?;
    let run = (kernel.prepare)(&folder)?;
    Ok(measured(run)?)
}

/// The function that the counter is told to watch.
#[inline(never)]
fn measured(run: Run) -> gks::Result<()> {
    black_box(run)()
}

/// What a call costs before a device sees it: two points, attributes that are what they were.
fn calls() -> Result<Run, Failure> {
    let mut gks = measurement::open(own::NULL, "")?;
    let (x, y) = ([0.1f32, 0.9], [0.1f32, 0.9]);
    gks.polyline(Points::SplitSingles(&x, &y))?;
    Ok(Box::new(move || {
        (0..100_000).try_for_each(|_| {
            gks.set_polyline_colour_index(black_box(2))?;
            gks.polyline(Points::SplitSingles(black_box(&x), black_box(&y)))
        })
    }))
}

fn scene(name: &str, size: usize) -> Result<Box<dyn gks_cli::bench::scene::Scene>, Failure> {
    let workload = workload::all().into_iter().find(|w| w.name == name);
    Ok((workload.ok_or_else(|| format!("no workload {name}"))?.scene)(size))
}

fn drawing(name: &str, size: usize) -> Result<Run, Failure> {
    let scene = scene(name, size)?;
    let mut gks: Gks = measurement::open(own::FRAMEBUFFER, "")?;
    measurement::draw(&*scene, &mut gks)?;
    Ok(Box::new(move || measurement::draw(&*scene, &mut gks)))
}

fn document(name: &str, size: usize, folder: &Folder) -> Result<Run, Failure> {
    let scene = scene(name, size)?;
    let mut gks: Gks = measurement::open(own::SVG, &folder.path().join("kernel.svg").to_string_lossy())?;
    Ok(Box::new(move || {
        scene.draw(&mut gks)?;
        measurement::close(gks)
    }))
}
