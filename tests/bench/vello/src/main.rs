//! Draws one workload with vello_cpu on one thread and says what it cost, as the program in C does, from the same
//! data: `gks-bench-vello memory WORKLOAD DATA FILE REPETITIONS`.

use rustix::time::{ClockId, clock_gettime};
use std::error::Error;
use std::fs;
use std::path::Path;
use vello_cpu::color::AlphaColor;
use vello_cpu::kurbo::{BezPath, Cap, Circle, Join, Rect, Shape, Stroke};
use vello_cpu::peniko::Fill;
use vello_cpu::{Pixmap, RenderContext, Resources};

/// The side of the canvas in pixels.
const SIDE: u16 = 1000;

type Points = Vec<(f64, f64)>;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [device, workload, data, _, repetitions] = &arguments[..] else {
        return Err("usage: gks-bench-vello memory WORKLOAD DATA FILE REPETITIONS".into());
    };
    if device != "memory" || workload.starts_with("w6") || workload == "w10" {
        return Err("neither files nor cells".into());
    }
    let parts = read(&Path::new(data).join(if workload == "w5" { "w5strokes" } else { workload }))?;
    let repetitions: u32 = repetitions.parse()?;
    let before = memory("VmRSS:");
    let start = milliseconds();
    let mut context = RenderContext::new(SIDE, SIDE);
    let (mut resources, mut target) = (Resources::new(), Pixmap::new(SIDE, SIDE));
    let opened = milliseconds();
    for _ in 0..repetitions {
        draw(&mut context, workload, &parts);
        context.flush();
        context.render(&mut target, &mut resources);
        context.reset();
    }
    let drawn = milliseconds();
    println!(
        "{{\"open_ms\":{},\"draw_ms\":{},\"close_ms\":0,\"process_ms\":{drawn},\"peak_kib\":{},\"bytes\":0}}",
        opened - start,
        (drawn - opened) / f64::from(repetitions),
        memory("VmHWM:").saturating_sub(before)
    );
    Ok(())
}

/// Processor time of this process in milliseconds.
fn milliseconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 * 1e3 + time.tv_nsec as f64 * 1e-6
}

/// A line of `/proc/self/status` in KiB.
fn memory(key: &str) -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(key));
    line.and_then(|rest| rest.split_whitespace().next()?.parse().ok()).unwrap_or(0)
}

/// The number of parts, the number of points of each, then x and y of each point.
fn read(file: &Path) -> Result<Vec<Points>, Box<dyn Error>> {
    let bytes = fs::read(file)?;
    let (head, rest) = bytes.split_at_checked(4).ok_or("no number of parts")?;
    let count = u32::from_ne_bytes(head.try_into()?) as usize;
    let (sizes, coordinates) = rest.split_at_checked(4 * count).ok_or("too few sizes")?;
    let number = |bytes: &[u8]| f64::from_ne_bytes(bytes.try_into().unwrap_or_default());
    let mut points = coordinates.chunks_exact(16).map(|pair| (number(&pair[..8]), number(&pair[8..])));
    let sizes = sizes.chunks_exact(4).map(|size| u32::from_ne_bytes(size.try_into().unwrap_or_default()));
    Ok(sizes.map(|size| points.by_ref().take(size as usize).collect()).collect())
}

/// Where a point of the unit square lies in pixels, y down.
fn pixel((x, y): (f64, f64)) -> (f64, f64) {
    (x * f64::from(SIDE), f64::from(SIDE) * (1.0 - y))
}

fn path(points: impl Iterator<Item = (f64, f64)>) -> BezPath {
    let mut path = BezPath::new();
    for (i, point) in points.enumerate() {
        if i == 0 { path.move_to(point) } else { path.line_to(point) }
    }
    path
}

/// The colours of all benchmarks.
fn colour(index: usize) -> AlphaColor<vello_cpu::color::Srgb> {
    let part = |factor: usize, start: usize| ((index * factor + start) & 255) as u8;
    if index < 2 {
        AlphaColor::from_rgb8(0, 0, 0)
    } else {
        AlphaColor::from_rgb8(part(37, 0), part(91, 60), part(151, 128))
    }
}

fn draw(context: &mut RenderContext, workload: &str, parts: &[Points]) {
    let pen = |width: f64| Stroke::new(width).with_caps(Cap::Round).with_join(Join::Round);
    context.set_paint(colour(1));
    context.set_aliasing_threshold((workload == "w1a").then_some(128));
    context.set_stroke(pen(1.0));
    match workload {
        "w3dot" => {
            for (x, y) in parts.iter().flatten().map(|&p| pixel(p)) {
                context.fill_rect(&Rect::new(x.floor(), y.floor(), x.floor() + 1.0, y.floor() + 1.0));
            }
        }
        "w3plus" => {
            for (x, y) in parts.iter().flatten().map(|&p| pixel(p)) {
                context.stroke_path(&path([(x - 3.0, y), (x + 3.0, y)].into_iter()));
                context.stroke_path(&path([(x, y - 3.0), (x, y + 3.0)].into_iter()));
            }
        }
        "w3circ" => {
            for centre in parts.iter().flatten().map(|&p| pixel(p)) {
                context.stroke_path(&Circle::new(centre, 3.0).to_path(0.1));
            }
        }
        "w4a" | "w4b" => {
            context.set_fill_rule(Fill::EvenOdd);
            for (i, polygon) in parts.iter().enumerate() {
                context.set_paint(colour(1 + i % 8));
                let mut path = path(polygon.iter().map(|&p| pixel(p)));
                path.close_path();
                context.fill_path(&path);
            }
        }
        _ => {
            if workload == "w7" {
                context.set_stroke(pen(3.0).with_dashes(0.0, [18.0, 12.0]));
            }
            let (left, right) = if workload == "w8" { (0.45, 0.55) } else { (0.0, 1.0) };
            for part in parts {
                let shown = part.iter().map(|&(x, y)| pixel(((x - left) / (right - left), y)));
                context.stroke_path(&path(shown));
            }
        }
    }
}
