//! Long lines, which vector formats draw without holding their points.

use crate::card::{page, paint};
use crate::receiver::Receiver;
use gks_geometry::{Du, LongLine, Map, Ndc, PathBuf, Points, Rect, Wc};
use gks_pipeline::device::{Device, Drawn, Form, Mark, Pen};
use gks_pipeline::look::{Cap, Join};
use gks_workstations::options::Options;
use gks_workstations::pdf::Pdf;
use gks_workstations::postscript::PostScript;
use gks_workstations::svg::Svg;

const FORMATS: [&str; 4] = ["svg", "pdf", "ps", "eps"];

fn device(format: &str, receiver: &Receiver, options: &Options) -> Box<dyn Device> {
    match format {
        "svg" => Box::new(Svg::new(receiver.sink(), options)),
        "pdf" => Box::new(Pdf::new(receiver.sink(), options)),
        "ps" => Box::new(PostScript::new(receiver.sink(), options)),
        _ => Box::new(PostScript::encapsulated(receiver.sink(), options)),
    }
}

/// The document with one mark.
fn document(format: &str, options: &Options, form: &Form<'_>) -> Vec<u8> {
    let receiver = Receiver::default();
    let mut device = device(format, &receiver, options);
    device.begin(&page(1)).unwrap();
    assert_eq!(device.draw(&Mark { form: form.clone(), clip: None }).unwrap(), Drawn::Yes, "{format}");
    device.end().unwrap();
    device.close().unwrap();
    receiver.document()
}

/// A spiral that is broken twice, ends where it started if `closed`, and stands still at its end if not.
fn spiral(count: usize, closed: bool) -> Vec<(f64, f64)> {
    let point = |i: usize| {
        let (turn, reach) = (i as f64 * 0.05, i as f64 / count as f64);
        (0.5 + 0.45 * reach * turn.cos(), 0.5 + 0.45 * reach * turn.sin())
    };
    let mut points: Vec<(f64, f64)> = (0..count).map(point).collect();
    points[count / 3] = (f64::NAN, 0.0);
    points[count / 2] = (0.0, f64::INFINITY);
    let last = if closed { points[count / 2 + 1] } else { points[count - 1] };
    points.push(last);
    points
}

type Parts = Vec<Option<Rect<Wc>>>;

/// Points on the page in units of the devices, and the same as paths.
fn line<'a>(points: &'a [(f64, f64)], parts: &'a mut Parts) -> (LongLine<'a, Du>, PathBuf<Du>) {
    let map = Map::<Ndc, Du>::window_to_viewport(&Rect::UNIT, &Rect::new(20.0, 570.0, 30.0, 580.0));
    let line = LongLine::new(Points::from(points), Map::IDENTITY, parts).mapped(&map);
    let mut paths = PathBuf::new();
    paths.add_pieces(&line);
    (line, paths)
}

fn pen(width: f64, cap: Cap, dash: &[f64]) -> Pen<'_> {
    Pen { paint: paint(0.0, 0.0, 1.0), width, dash, cap, join: Join::Miter }
}

#[test]
fn a_long_line_is_written_as_the_same_line_held() {
    for format in FORMATS {
        for (count, closed, cap, dash) in [
            (10, false, Cap::Butt, &[][..]),
            (5_000, true, Cap::Butt, &[]),
            (70_000, false, Cap::Projecting, &[3.0, 2.0]),
        ] {
            let points = spiral(count, closed);
            let mut parts = Parts::new();
            let (line, paths) = line(&points, &mut parts);
            let pen = pen(2.5, cap, dash);
            let options = Options::default();
            let one = document(format, &options, &Form::LongLine(line, pen));
            let other = document(format, &options, &Form::Lines(paths.as_paths(), pen));
            assert!(one == other, "{format}: {count} points");
        }
    }
}

#[test]
fn reduction_makes_documents_short() {
    let noisy: Vec<(f64, f64)> = (0..100_000)
        .map(|i| f64::from(i) * 1e-5)
        .map(|x| (x, 0.5 + 0.3 * (x * 30.0).sin() + 0.05 * (x * 1e7).sin()))
        .collect();
    let mut parts = Parts::new();
    let (line, _) = line(&noisy, &mut parts);
    let form = Form::LongLine(line, pen(0.6, Cap::Butt, &[]));
    for format in FORMATS {
        let all = document(format, &Options::default(), &form).len();
        let reduced = document(format, &Options { reduce: Some(0.5), ..Options::default() }, &form).len();
        assert!(reduced * 5 < all, "{format}: {reduced} of {all} bytes");
        let exact = document(format, &Options { reduce: Some(0.0), ..Options::default() }, &form).len();
        assert_eq!(exact, all, "{format}");
    }
}

#[test]
fn small_documents_are_smaller() {
    let points = spiral(100_000, false);
    let mut parts = Parts::new();
    let (line, _) = line(&points, &mut parts);
    let form = Form::LongLine(line, pen(1.0, Cap::Butt, &[]));
    let fast = document("pdf", &Options::default(), &form).len();
    let small = document("pdf", &Options { small: true, ..Options::default() }, &form).len();
    assert!(small * 5 < fast * 4, "{small} of {fast} bytes");
}

#[test]
fn long_lines_are_let_go_on_the_way() {
    let points = spiral(500_000, false);
    let mut parts = Parts::new();
    let (line, _) = line(&points, &mut parts);
    for format in ["svg", "pdf", "ps"] {
        let receiver = Receiver::default();
        let mut device = device(format, &receiver, &Options::default());
        device.begin(&page(1)).unwrap();
        let mark = Mark { form: Form::LongLine(line, pen(1.0, Cap::Round, &[])), clip: None };
        assert_eq!(device.draw(&mark).unwrap(), Drawn::Yes);
        let before_the_end = receiver.so_far();
        device.end().unwrap();
        device.close().unwrap();
        let all = receiver.document().len();
        assert!(
            before_the_end + (2 << 20) > all && all > 2 << 20,
            "{format}: {before_the_end} of {all} bytes"
        );
    }
}

#[test]
fn a_full_disk_ends_a_long_line() {
    let points = spiral(500_000, false);
    let mut parts = Parts::new();
    let (line, _) = line(&points, &mut parts);
    for format in FORMATS {
        let receiver = Receiver::with_room(1 << 20);
        let mut device = device(format, &receiver, &Options::default());
        device.begin(&page(1)).unwrap();
        let mark = Mark { form: Form::LongLine(line, pen(1.0, Cap::Butt, &[])), clip: None };
        assert!(device.draw(&mark).and_then(|_| device.end()).is_err(), "{format}");
    }
}
