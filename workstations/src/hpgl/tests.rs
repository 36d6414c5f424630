//! Whole plots: their text, and what the reader hp2xx makes of it.

use super::*;
use crate::sink::tests::Directory;
use crate::sink::{MemoryDocuments, MemorySink};
use gks_geometry::{Du, PathBuf};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::device::{Fill, Pen, Rule};
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;
use std::process::Command;

type Line<'a> = &'a [(f64, f64)];

fn paths(paths: &[Line<'_>]) -> PathBuf<Du> {
    let mut set = PathBuf::new();
    for path in paths {
        set.add(path.iter().map(|&(x, y)| DVec2::new(x, y)));
    }
    set
}

fn pen(index: u32) -> Pen<'static> {
    let paint = Paint { colour: Colour::BLACK, index };
    Pen { paint, width: 12.0, dash: &[], cap: Cap::Butt, join: Join::Miter }
}

fn page(number: u32) -> Page {
    Page { number, background: Colour::WHITE, colours: Vec::new() }
}

fn plotter(options: &Options) -> (Hpgl, MemoryDocuments) {
    let (sink, documents) = MemorySink::new();
    (Hpgl::new(Box::new(sink), options), documents)
}

/// The sheet with these lines, each set with a colour index, without what begins and ends every sheet.
fn body(lines: &[(u32, &[Line<'_>])]) -> String {
    let (mut device, documents) = plotter(&Options::default());
    device.begin(&page(1)).unwrap();
    for (index, set) in lines {
        let set = paths(set);
        let mark = Mark { form: Form::Lines(set.as_paths(), pen(*index)), clip: None };
        assert_eq!(device.draw(&mark).unwrap(), Drawn::Yes);
    }
    device.end().unwrap();
    device.close().unwrap();
    let text = documents.text(0).unwrap();
    let body = text.strip_prefix("IN;\nIP0,0,10870,7600;\n").and_then(|t| t.strip_suffix("SP0;\n"));
    body.unwrap_or_else(|| panic!("{text}")).to_owned()
}

#[test]
fn pens_change_only_when_they_must_and_index_0_is_the_paper() {
    let line = |y: f64| [(10.0, y), (20.0, y)];
    let (a, b, c, d) = (line(1.0), line(2.0), line(3.0), line(4.0));
    let text = body(&[(1, &[&a, &b]), (0, &[&a]), (1, &[&c]), (10, &[&d]), (2, &[&a])]);
    let expected = "SP1;\nPU10,1;PD20,1;\nPU10,2;PD20,2;\nPU10,3;PD20,3;\nPU;\n\
                    SP2;\nPU10,4;PD20,4;\nPU10,1;PD20,1;\nPU;\n";
    assert_eq!(text, expected);
    assert_eq!(body(&[(0, &[&a])]), "");
}

#[test]
fn a_line_that_goes_on_is_joined_and_positions_are_not_repeated() {
    let text = body(&[(
        1,
        &[
            &[(0.0, 0.0), (10.2, 0.0), (10.4, 0.4), (20.0, 0.0)],
            &[(20.0, 0.0), (20.0, 10.5)],
            &[(20.0, 11.0), (0.0, 11.0)],
            &[(5.0, 5.0), (6.0, 5.0)],
        ],
    )]);
    assert_eq!(text, "SP1;\nPU0,0;PD10,0,20,0,20,11,0,11;\nPU5,5;PD6,5;\nPU;\n");
}

#[test]
fn dots_are_dots_even_if_rounding_makes_them() {
    let dot: &[Line<'_>] = &[&[(7.0, 8.0)], &[(9.0, 9.0), (9.1, 9.1)], &[(9.0, 9.0), (12.0, 9.0)]];
    assert_eq!(body(&[(1, dot)]), "SP1;\nPU7,8;PD;\nPU9,9;PD;\nPD12,9;\nPU;\n");
}

#[test]
fn long_lines_are_cut_into_short_instructions() {
    let points: Vec<(f64, f64)> = (0..70).map(|i| (f64::from(i), f64::from(i % 2))).collect();
    let text = body(&[(1, &[&points])]);
    let instructions: Vec<&str> = text.split(';').map(str::trim).filter(|i| i.starts_with("PD")).collect();
    let lengths: Vec<usize> = instructions.iter().map(|i| i.split(',').count() / 2).collect();
    assert_eq!(lengths, [32, 32, 5]);
    assert!(instructions[1].starts_with("PD33,1,34,0,"), "{text}");
}

#[test]
fn each_page_is_a_document() {
    let (mut device, documents) = plotter(&Options::default());
    let set = paths(&[&[(0.0, 0.0), (5.0, 5.0)]]);
    for number in 1..=2 {
        device.begin(&page(number)).unwrap();
        let mark = Mark { form: Form::Lines(set.as_paths(), pen(3)), clip: None };
        assert_eq!(device.draw(&mark).unwrap(), Drawn::Yes);
        device.end().unwrap();
    }
    device.close().unwrap();
    let expected = "IN;\nIP0,0,10870,7600;\nSP3;\nPU0,0;PD5,5;\nPU;\nSP0;\n";
    assert_eq!(documents.take(), [expected.as_bytes(), expected.as_bytes()]);
}

#[test]
fn only_solid_lines_without_clipping_are_accepted() {
    let (mut device, documents) = plotter(&Options::default());
    device.begin(&page(1)).unwrap();
    let set = paths(&[&[(0.0, 0.0), (5.0, 5.0), (0.0, 5.0)]]);
    let extent = device.surface().extent();
    let lines = |pen| Form::Lines(set.as_paths(), pen);
    let area = Form::Area(set.as_paths(), Rule::EvenOdd, Fill::Solid(pen(1).paint));
    let refused = [
        Mark { form: lines(pen(1)), clip: Some(extent) },
        Mark { form: lines(Pen { dash: &[1.0, 1.0], ..pen(1) }), clip: None },
        Mark { form: area, clip: None },
    ];
    for mark in refused {
        assert_eq!(device.draw(&mark).unwrap(), Drawn::No);
    }
    let clear = Paint { colour: Colour { alpha: 0.0, ..Colour::BLACK }, index: 1 };
    let invisible = Mark { form: lines(Pen { paint: clear, ..pen(1) }), clip: None };
    assert_eq!(device.draw(&invisible).unwrap(), Drawn::Yes);
    device.end().unwrap();
    assert_eq!(documents.text(0).unwrap(), "IN;\nIP0,0,10870,7600;\nSP0;\n");
}

#[test]
fn sheets_have_the_size_and_orientation_asked_for() {
    let size = |options: &Options| {
        let (device, _) = plotter(options);
        let surface = device.surface().clone();
        assert_eq!(describe(300, "hpgl", options).surface, surface);
        (surface.width, surface.height)
    };
    assert_eq!(size(&Options::default()), (10870.0, 7600.0));
    assert_eq!(size(&Options { landscape: Some(false), ..Options::default() }), (7600.0, 10870.0));
    assert_eq!(size(&Options { size: Some((390.0, 270.03)), ..Options::default() }), (15600.0, 10801.0));
    let surface = plotter(&Options::default()).0.surface().clone();
    assert!((surface.pen.unwrap() * surface.unit - 0.0003).abs() < 1e-12);
}

#[test]
fn pens_are_used_in_turn() {
    let two = Profile { pens: 2, ..Profile::A4 };
    assert_eq!([0, 1, 2, 3, 4].map(|index| two.pen(index)), [None, Some(1), Some(2), Some(1), Some(2)]);
    assert_eq!(Profile::A4.pen(9), Some(1));
    assert_eq!(Profile::A4.pen(u32::MAX), Some(7));
    assert_eq!(Profile { pens: 0, ..Profile::A4 }.pen(5), Some(1));
}

/// The picture that hp2xx makes of a plot, 4 pixels for a millimetre, cropped to what is drawn: the width in
/// pixels and whether each pixel is inked, row by row from the top. None where hp2xx is missing.
fn seen_by_hp2xx(plot: &str) -> Option<(usize, Vec<bool>)> {
    let directory = Directory::new();
    let (input, output) = (directory.name("plot.plt"), directory.name("plot.png"));
    std::fs::write(&input, plot).unwrap();
    let arguments = ["20", "hp2xx", "-q", "-t", "-m", "png", "-d", "101.6", "-p", "33333333", "-f"];
    let run = Command::new("timeout").args(arguments).args([&output, &input]).output().ok()?;
    if run.status.code() == Some(127) {
        eprintln!("hp2xx is missing: plot not read");
        return None;
    }
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let picture = image::open(&output).unwrap().into_luma8();
    Some((picture.width() as usize, picture.pixels().map(|p| p.0[0] < 128).collect()))
}

#[test]
fn hp2xx_sees_lines_and_dots_where_they_were_drawn() {
    let (mut device, documents) = plotter(&Options::default());
    device.begin(&page(1)).unwrap();
    let set = paths(&[
        &[(0.0, 0.0), (4000.0, 0.0), (4000.0, 2000.0), (0.0, 2000.0), (0.0, 0.0)],
        &[(1000.0, 1500.0)],
        &[(2000.0, 500.0), (3000.0, 500.0)],
    ]);
    let mark = Mark { form: Form::Lines(set.as_paths(), pen(1)), clip: None };
    assert_eq!(device.draw(&mark).unwrap(), Drawn::Yes);
    device.end().unwrap();
    let Some((width, ink)) = seen_by_hp2xx(&documents.text(0).unwrap()) else { return };
    let height = ink.len() / width;
    // Ink within a millimetre of a position in plotter units.
    let near = |x: i32, y: i32| {
        let (column, row) = (x as usize / 10, height.saturating_sub(y as usize / 10));
        let rows = row.saturating_sub(4)..(row + 4).min(height);
        let columns = column.saturating_sub(4)..(column + 4).min(width);
        rows.flat_map(|r| columns.clone().map(move |c| (r, c))).filter(|(r, c)| ink[r * width + c]).count()
    };
    assert!((390..=410).contains(&width) && (190..=210).contains(&height), "{width} x {height}");
    assert!((1..=16).contains(&near(1000, 1500)), "dot");
    assert!(near(2500, 500) > 10, "line");
    assert!(near(4000, 1000) > 10 && near(2000, 2000) > 10, "frame");
    assert_eq!([near(3200, 500), near(1500, 1500), near(500, 500)], [0; 3]);
}
