//! A long line whose points are not held is the same picture as the lines through its points.

use gks_algorithms::line::dash;
use gks_geometry::{Du, LongLine, Map, Ndc, PathBuf, Points, Rect, Wc};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::device::{Device, Drawn, Form, Mark, Page, Pen};
use gks_pipeline::look::{Cap, Join};
use gks_workstations::options::Options;
use gks_workstations::raster::{Indexed, TrueColour};
use glam::DVec2;

/// A curve that goes forward in small steps and comes back, and leaps up and down.
fn curve(count: usize) -> Vec<(f64, f64)> {
    let at = |i: usize| {
        let t = i as f64 / count as f64;
        (0.1 + 0.8 * (3.0 * t).sin().abs(), 0.5 + 0.4 * (5.0 * t).sin() * ((i * 7919 % 101) as f64 / 101.0))
    };
    (0..count).map(at).collect()
}

fn colours(device: &mut dyn Device) -> Vec<Option<Colour>> {
    let buffer = device.frame_buffer().unwrap();
    let (columns, rows) = buffer.size();
    (0..rows)
        .flat_map(|row| (0..columns).map(move |column| (column, row)))
        .map(|(c, r)| buffer.colour(c, r))
        .collect()
}

fn drawn(device: &mut dyn Device, form: Form<'_>) -> Vec<Option<Colour>> {
    device.begin(&Page { number: 1, background: Colour::WHITE, colours: vec![] }).unwrap();
    assert_eq!(device.draw(&Mark { form, clip: None }).unwrap(), Drawn::Yes);
    colours(device)
}

/// Raster workstations of 60 by 50 pixels.
fn devices() -> [Box<dyn Device>; 3] {
    let options = Options { size: Some((60.0, 50.0)), ..Options::default() };
    let aliased = Options { antialias: Some(false), ..options.clone() };
    [
        Box::new(TrueColour::new(&options, None).unwrap()),
        Box::new(TrueColour::new(&aliased, None).unwrap()),
        Box::new(Indexed::new(&options, None).unwrap()),
    ]
}

/// The translucent black that lines are drawn with.
const PAINT: Paint = Paint { colour: Colour { alpha: 0.7, ..Colour::BLACK }, index: 1 };

fn to_device() -> Map<Ndc, Du> {
    Map::window_to_viewport(&Rect::UNIT, &Rect::new(0.0, 60.0, 0.0, 50.0))
}

#[test]
fn long_lines_and_lines_are_the_same() {
    let mut devices = devices();
    let window: Rect<Wc> = Rect::new(0.0, 1.0, 0.0, 1.0);
    let normalization = Map::window_to_viewport(&window, &Rect::UNIT);
    let map = to_device();
    for count in [2, 3, 4, 1025, 4097, 9000] {
        let whole = curve(count);
        let mut broken = whole.clone();
        broken[count / 2].1 = f64::NAN;
        for points in [&whole, &broken] {
            let mut parts = Vec::new();
            let line = LongLine::new(Points::from(points), normalization, &mut parts).mapped(&map);
            assert_eq!(line.is_whole(), std::ptr::eq(points, &whole));
            let mut paths = PathBuf::new();
            paths.add_pieces(&line);
            for (cap, join, width) in [(Cap::Butt, Join::Miter, 1.0), (Cap::Round, Join::Round, 2.5)] {
                let pen = Pen { paint: PAINT, width, dash: &[], cap, join };
                for device in &mut devices {
                    let long = drawn(device.as_mut(), Form::LongLine(line, pen));
                    let held = drawn(device.as_mut(), Form::Lines(paths.as_paths(), pen));
                    assert!(long == held, "{count} points, width {width}");
                }
            }
        }
    }
}

#[test]
fn dashes_of_a_long_line_are_dashes_of_the_line() {
    let mut devices = devices();
    let pattern = [3.0, 2.5];
    let around = (DVec2::splat(-3.0), DVec2::new(63.0, 53.0));
    // So many that some of the dashes are drawn before others are cut.
    for count in [2, 500, 40_000] {
        let mut points = curve(count);
        points.extend([(f64::NAN, 0.0), (-0.5, 0.3), (1.5, 0.4)]);
        let mut parts = Vec::new();
        let line = LongLine::new(Points::from(&points), Map::IDENTITY, &mut parts).mapped(&to_device());
        let (mut paths, mut dashes) = (PathBuf::<Du>::new(), PathBuf::new());
        paths.add_pieces(&line);
        for path in paths.as_paths().iter() {
            dash(around, path, &pattern, 0.0, usize::MAX, &mut dashes.points, &mut dashes.ends);
        }
        for (cap, join, width) in [(Cap::Butt, Join::Miter, 1.0), (Cap::Round, Join::Round, 2.5)] {
            let pen = Pen { paint: PAINT, width, dash: &[], cap, join };
            for device in &mut devices {
                let long = drawn(device.as_mut(), Form::LongLine(line, Pen { dash: &pattern, ..pen }));
                let held = drawn(device.as_mut(), Form::Lines(dashes.as_paths(), pen));
                assert!(long == held, "{count} points, width {width}");
            }
        }
    }
}
