//! Measuring one workload at one size, in a process that does nothing else.

use super::clock::{Peak, Sampling, cpu_seconds, medians};
use super::reference::{self, Likeness};
use super::scene::Scene;
use super::skia::TinySkia;
use super::workload::{Way, Workload};
use crate::commands::Failure;
use gks::Gks;
use gks_metafile::{ReadOptions, open_source};
use gks_pipeline::colour::Colour;
use gks_pipeline::generated::numbers::workstation_type as own;
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::{Path, PathBuf};

/// What a workload costs at one size.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Measurement {
    /// The number of primitives, or of points of a single one.
    pub n: usize,
    /// Processor time through the kernel, in milliseconds.
    pub cpu_ms: f64,
    /// Processor time by direct calls of tiny-skia, in milliseconds.
    pub tiny_skia_cpu_ms: Option<f64>,
    /// Peak signal to noise ratio of the picture against the true one, in decibels.
    pub psnr_db: Option<f64>,
    /// The same of tiny-skia's picture.
    pub tiny_skia_psnr_db: Option<f64>,
    /// Mean darkness of the picture, from 0 for white to 255.
    pub ink: Option<f64>,
    /// Mean darkness of the true picture.
    pub true_ink: Option<f64>,
    /// Memory in KiB beyond that of the data, at its peak.
    pub peak_kib: u64,
    /// The size of the file that is written, of a PNG for pictures in memory.
    pub bytes: u64,
}

/// How much is measured.
#[derive(Copy, Clone, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Effort {
    /// Time, the yardstick's time, likeness.
    Full,
    /// Time alone, to compare sizes.
    Growth,
    /// Everything once, to see that it works.
    Once,
}

/// Measures a workload at one size; files go to `folder`.
pub fn measure(
    workload: &Workload,
    size: usize,
    effort: Effort,
    folder: &Path,
) -> Result<Measurement, Failure> {
    let file = |kind: i32| folder.join(format!("picture.{}", crate::commands::extension(kind)));
    let scene = (workload.scene)(size);
    let mut measured = match workload.way {
        Way::TrueColour => pixels(own::FRAMEBUFFER, &*scene, effort, &file(own::PNG)),
        Way::Indexed => pixels(own::FRAMEBUFFER8, &*scene, effort, &file(own::PNG8)),
        Way::Document(kind) => document(kind, &*scene, effort, &file(kind)),
        Way::Redrawn => redrawn(&*scene, effort),
        Way::Played(kind) => played(kind, &*scene, effort, &file(kind)),
        Way::Start(kind) => start(kind, &*scene, &file(kind)),
    }?;
    measured.n = size;
    Ok(measured)
}

/// A kernel with one active workstation that knows the colours of the scenes, whatever the environment says.
pub fn open(kind: i32, connection: &str) -> gks::Result<Gks> {
    let mut gks = Gks::open(Box::new(Drivers::new(Environment::default())));
    gks.open_workstation(1, connection, kind)?;
    gks.activate_workstation(1)?;
    reference::set_colours(&mut gks, 1)?;
    Ok(gks)
}

/// Closes what [`open`] has opened.
pub fn close(mut gks: Gks) -> gks::Result<()> {
    gks.deactivate_workstation(1)?;
    gks.close_workstation(1)?;
    gks.close_gks()
}

/// Draws, and waits until all is drawn.
pub fn draw(scene: &dyn Scene, gks: &mut Gks) -> gks::Result<()> {
    scene.draw(gks)?;
    gks.update_workstation(1, true)
}

impl Effort {
    fn sampling(self) -> Sampling {
        match self {
            Effort::Full => Sampling::CAREFUL,
            Effort::Growth => Sampling::GROWTH,
            Effort::Once => Sampling::ONCE,
        }
    }
}

fn milliseconds(seconds: f64) -> f64 {
    seconds * 1e3
}

fn pixels(kind: i32, scene: &dyn Scene, effort: Effort, file: &Path) -> Result<Measurement, Failure> {
    let peak = Peak::watch();
    let mut gks = open(kind, "")?;
    draw(scene, &mut gks)?;
    let mut measured = Measurement { peak_kib: peak.kib(), ..Measurement::default() };
    let picture = read(&mut gks)?;
    let mut kernel = || draw(scene, &mut gks);
    let figures = if effort == Effort::Growth { None } else { scene.figures() };
    if let Some(figures) = figures {
        let mut canvas = TinySkia::new().ok_or("no memory")?;
        figures(&mut canvas);
        let its_picture = canvas.pixels();
        let mut direct = || {
            figures(&mut canvas);
            Ok(())
        };
        let [kernel, direct] = medians(effort.sampling(), [&mut kernel, &mut direct])?;
        measured.cpu_ms = milliseconds(kernel);
        measured.tiny_skia_cpu_ms = Some(milliseconds(direct));
        let truth = reference::truth(|gks| scene.draw(gks))?;
        measured.tiny_skia_psnr_db = Some(reference::compare(&its_picture, &truth).psnr);
        measured.set_likeness(reference::compare(&picture, &truth));
    } else {
        let [kernel] = medians(effort.sampling(), [&mut kernel])?;
        measured.cpu_ms = milliseconds(kernel);
        if effort != Effort::Growth {
            let truth = reference::truth(|gks| scene.draw(gks))?;
            measured.set_likeness(reference::compare(&picture, &truth));
        }
    }
    close(gks)?;
    let kind = if kind == own::FRAMEBUFFER { own::PNG } else { own::PNG8 };
    if effort != Effort::Growth {
        measured.bytes = write(kind, scene, file)?;
    }
    Ok(measured)
}

impl Measurement {
    fn set_likeness(&mut self, likeness: Likeness) {
        self.psnr_db = Some(likeness.psnr);
        (self.ink, self.true_ink) = (Some(likeness.ink), Some(likeness.true_ink));
    }
}

/// The pixels of the workstation.
fn read(gks: &mut Gks) -> gks::Result<Vec<[u8; 3]>> {
    let (_, colours) = gks.frame_buffer(1)?;
    Ok(colours.map(Colour::to_bytes).map(|[red, green, blue, _]| [red, green, blue]).collect())
}

/// Writes a picture to a file and returns its size in bytes.
pub fn write(kind: i32, scene: &dyn Scene, file: &Path) -> Result<u64, Failure> {
    let mut gks = open(kind, &file.to_string_lossy())?;
    scene.draw(&mut gks)?;
    close(gks)?;
    Ok(fs::metadata(file)?.len())
}

fn document(kind: i32, scene: &dyn Scene, effort: Effort, file: &Path) -> Result<Measurement, Failure> {
    let peak = Peak::watch();
    let bytes = write(kind, scene, file)?;
    let peak_kib = peak.kib();
    let mut kernel = || write(kind, scene, file).map(|_| ());
    let [kernel] = medians(effort.sampling(), [&mut kernel])?;
    Ok(Measurement { cpu_ms: milliseconds(kernel), peak_kib, bytes, ..Measurement::default() })
}

/// A kernel with a frame buffer of colours and a segment on it; it is redrawn by the function of the standard.
pub fn open_segment(scene: &dyn Scene) -> gks::Result<Gks> {
    let mut gks = open(own::FRAMEBUFFER, "")?;
    gks.create_segment(1)?;
    scene.draw(&mut gks)?;
    gks.close_segment()?;
    Ok(gks)
}

/// Plays a metafile.
pub fn play(gks: &mut Gks, file: &Path) -> Result<(), Failure> {
    let reader = std::io::BufReader::new(fs::File::open(file)?);
    let mut source = open_source(Box::new(reader), &ReadOptions::default())?.source;
    while let Some(record) = source.next()? {
        gks.interpret(&record)?;
    }
    Ok(())
}

fn redrawn(scene: &dyn Scene, effort: Effort) -> Result<Measurement, Failure> {
    let peak = Peak::watch();
    let mut gks = open_segment(scene)?;
    let mut kernel = || gks.redraw_all_segments_on_workstation(1);
    kernel()?;
    let peak_kib = peak.kib();
    let [kernel] = medians(effort.sampling(), [&mut kernel])?;
    close(gks)?;
    Ok(Measurement { cpu_ms: milliseconds(kernel), peak_kib, ..Measurement::default() })
}

fn played(kind: i32, scene: &dyn Scene, effort: Effort, file: &Path) -> Result<Measurement, Failure> {
    let bytes = write(kind, scene, file)?;
    let peak = Peak::watch();
    let mut gks = open(own::FRAMEBUFFER, "")?;
    let mut kernel = || play(&mut gks, file);
    kernel()?;
    let peak_kib = peak.kib();
    let [kernel] = medians(effort.sampling(), [&mut kernel])?;
    close(gks)?;
    Ok(Measurement { cpu_ms: milliseconds(kernel), peak_kib, bytes, ..Measurement::default() })
}

/// The processor time of the whole process, this one, when it is about to end.
fn start(kind: i32, scene: &dyn Scene, file: &Path) -> Result<Measurement, Failure> {
    let mut gks = Gks::open(Box::new(Drivers::new(Environment::default())));
    gks.open_workstation(1, &file.to_string_lossy(), kind)?;
    gks.activate_workstation(1)?;
    scene.draw(&mut gks)?;
    close(gks)?;
    let bytes = fs::metadata(file)?.len();
    let (cpu_ms, peak_kib) = (milliseconds(cpu_seconds()), Peak::of_process());
    Ok(Measurement { cpu_ms, peak_kib, bytes, ..Measurement::default() })
}

/// A folder for the files of measurements, which is removed with everything in it.
pub struct Folder(PathBuf);

impl Folder {
    /// A new folder, named after this process.
    pub fn new() -> std::io::Result<Folder> {
        let path = std::env::temp_dir().join(format!("gks-bench-{}", std::process::id()));
        fs::create_dir_all(&path)?;
        Ok(Folder(path))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
