//! Whole documents: their text, their validity, their memory.

use super::*;
use gks_geometry::{Du, PathBuf, Rect};
use gks_pipeline::colour::Paint;
use gks_pipeline::device::Rule;
use gks_pipeline::item::{Closure, Curve, Ellipse};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::io;
use std::io::Write;
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex};

/// What was written: the documents, and the length of the longest piece handed over at once.
#[derive(Clone, Default)]
struct Written(Arc<Mutex<(Vec<Vec<u8>>, usize)>>);

impl Sink for Written {
    fn open(&mut self) -> io::Result<()> {
        self.0.lock().unwrap().0.push(Vec::new());
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        let mut written = self.0.lock().unwrap();
        written.1 = written.1.max(bytes.len());
        written.0.last_mut().unwrap().extend_from_slice(bytes);
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

pub(super) const BLACK: Paint = Paint { colour: Colour::BLACK, index: 1 };
pub(super) const RED: Paint = Paint { colour: Colour::rgb(1.0, 0.0, 0.0), index: 2 };
pub(super) const THIN: Pen<'static> =
    Pen { paint: BLACK, width: 1.0, dash: &[], cap: Cap::Butt, join: Join::Miter };

pub(super) fn paths(paths: &[&[(f64, f64)]]) -> PathBuf<Du> {
    let mut set = PathBuf::new();
    for path in paths {
        set.add(path.iter().map(|&(x, y)| DVec2::new(x, y)));
    }
    set
}

/// The document of a page with these options on which `draw` draws.
pub(super) fn page_with(options: &Options, draw: impl FnOnce(&mut Svg)) -> String {
    let written = Written::default();
    let mut svg = Svg::new(Box::new(written.clone()), options);
    svg.begin(&Page { number: 1, background: Colour::WHITE, colours: Vec::new() }).unwrap();
    draw(&mut svg);
    svg.end().unwrap();
    svg.close().unwrap();
    let text = String::from_utf8(written.0.lock().unwrap().0.concat()).unwrap();
    validate(&text);
    text
}

/// The part of a document that the marks make.
pub(super) fn body(draw: impl FnOnce(&mut Svg)) -> String {
    let text = page_with(&Options { transparent: true, ..Options::default() }, draw);
    let start = text.find("</title>\n").unwrap() + "</title>\n".len();
    text[start..text.rfind("</svg>").unwrap()].to_owned()
}

/// Draws a mark, which must be accepted.
pub(super) fn draw(svg: &mut Svg, form: Form<'_>, clip: Option<Rect<Du>>) {
    assert_eq!(svg.draw(&Mark { form, clip }).unwrap(), Drawn::Yes);
}

/// Asserts that a document is valid SVG 1.1; says so where the validator is missing.
fn validate(text: &str) {
    const DTD: &str = "/usr/share/xml/w3c-sgml-lib/schema/dtd/REC-SVG11-20110816/svg11.dtd";
    let mut depth = 0;
    for event in ::svg::read(text).unwrap() {
        match event {
            ::svg::parser::Event::Error(error) => panic!("{error}\n{text}"),
            ::svg::parser::Event::Tag(_, ::svg::node::element::tag::Type::Start, _) => depth += 1,
            ::svg::parser::Event::Tag(_, ::svg::node::element::tag::Type::End, _) => depth -= 1,
            _ => {}
        }
    }
    assert_eq!(depth, 0, "elements are not nested:\n{text}");
    let mut command = Command::new("xmllint");
    command.args(["--noout", "--nonet", "--dtdvalid", DTD, "-"]);
    let started = command.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let Ok(mut child) = started else {
        eprintln!("xmllint is missing: document not validated");
        return;
    };
    if !std::path::Path::new(DTD).exists() {
        eprintln!("{DTD} is missing: document not validated");
        child.kill().unwrap();
        child.wait().unwrap();
        return;
    }
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{}\n{text}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn empty_page() {
    let head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
        <svg xmlns=\"http://www.w3.org/2000/svg\" \
        xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" \
        width=\"200mm\" height=\"200mm\" viewBox=\"0 0 1000 1000\" fill=\"none\" fill-rule=\"evenodd\" \
        stroke-miterlimit=\"10\" text-rendering=\"geometricPrecision\">\n<title>Page 1</title>\n";
    assert_eq!(
        page_with(&Options::default(), |_| {}),
        format!("{head}<rect width=\"1000\" height=\"1000\" fill=\"#fff\"/>\n</svg>\n")
    );
    let transparent = Options { transparent: true, ..Options::default() };
    assert_eq!(page_with(&transparent, |_| {}), format!("{head}</svg>\n"));
    let grey = Options { background: Some(Colour::rgb(0.5, 0.5, 0.5)), ..Options::default() };
    assert!(page_with(&grey, |_| {}).contains("fill=\"#808080\"/>"));
}

#[test]
fn size_and_orientation() {
    let a4 = Options { size: Some((595.2756, 841.8898)), ..Options::default() };
    assert!(page_with(&a4, |_| {}).contains("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 1050 1485\""));
    let landscape = Options { landscape: Some(true), ..a4.clone() };
    assert!(
        page_with(&landscape, |_| {}).contains("width=\"297mm\" height=\"210mm\" viewBox=\"0 0 1485 1050\"")
    );
    for size in [(0.0, 5.0), (5.0, f64::NAN), (-1.0, 1.0), (1e300, 1.0)] {
        let surface = surface(&Options { size: Some(size), ..Options::default() });
        assert_eq!((surface.width, surface.height), (1000.0, 1000.0));
    }
    let description = describe(40, "svg", &a4);
    assert_eq!(description.raster, (1050, 1485));
    let (width, height) = description.size();
    assert!((width - 0.21).abs() < 1e-6 && (height - 0.297).abs() < 1e-6);
    assert!((surface(&Options::default()).nominal_linewidth() - 1.0).abs() < 1e-12);
}

#[test]
fn lines_are_relative_and_share_attributes() {
    let text = body(|svg| {
        let set =
            paths(&[&[(10.0, 20.0), (13.0, 24.5), (13.0, 30.0), (1.0, 30.0), (1.25, 30.75)], &[(5.0, 6.0)]]);
        draw(svg, Form::Lines(set.as_paths(), THIN), None);
        draw(svg, Form::Lines(paths(&[&[(1.0, 1.0), (2.0, 2.0)]]).as_paths(), THIN), None);
        let back = paths(&[
            &[(1.0, 1.0), (2.0, 2.0), (1.0, 1.0)],
            &[(1.0, 1.0), (4.0, 1.0), (4.0, 9.0), (1.0, 1.0)],
        ]);
        draw(svg, Form::Lines(back.as_paths(), THIN), None);
        let thick = Pen { width: 2.5, paint: RED, cap: Cap::Round, join: Join::Bevel, dash: &[3.0, 1.5] };
        draw(svg, Form::Lines(paths(&[&[(1.0, 1.0), (1.001, 1.001)]]).as_paths(), thick), None);
    });
    assert_eq!(
        text,
        "<g stroke=\"#000\">\n\
        <path d=\"m10 20 3 4.5v5.5h-12l.25.75\"/>\n\
        <path stroke-linecap=\"square\" d=\"m5 6h0\"/>\n\
        <path d=\"m1 1 1 1\"/>\n\
        <path d=\"m1 1 1 1-1-1m0 0h3v8z\"/>\n\
        </g>\n\
        <g stroke=\"#f00\" stroke-width=\"2.5\" stroke-dasharray=\"3 1.5\" stroke-linecap=\"round\" \
        stroke-linejoin=\"bevel\">\n\
        <path stroke-dasharray=\"none\" d=\"m1 1h0\"/>\n\
        </g>\n"
    );
}

#[test]
fn areas_are_closed_and_clipping_paths_are_reused() {
    let square = paths(&[&[(1.0, 1.0), (3.0, 1.0), (3.0, 4.0), (1.0, 4.0), (1.0, 1.0)]]);
    let clips = [Rect::new(0.0, 2.0, 0.0, 2.5), Rect::new(1.0, 2.0, 1.0, 2.0)];
    let text = body(|svg| {
        let area = |rule| Form::Area(square.as_paths(), rule, Fill::Solid(RED));
        draw(svg, area(Rule::EvenOdd), Some(clips[0]));
        draw(svg, area(Rule::NonZero), Some(clips[0]));
        draw(svg, area(Rule::NonZero), Some(clips[1]));
        draw(svg, area(Rule::EvenOdd), Some(clips[0]));
        draw(svg, area(Rule::EvenOdd), None);
    });
    let path = "<path d=\"m1 1h2v3h-2z\"/>\n</g>\n";
    let (even, non_zero) = (
        "<g fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\".5\" color=\"#f00\">\n",
        "<g fill=\"#f00\" fill-rule=\"nonzero\">\n",
    );
    assert_eq!(
        text,
        format!(
            "<clipPath id=\"c1\"><path d=\"m0 0h2v2.5h-2z\"/></clipPath>\n<g clip-path=\"url(#c1)\">\n\
            {even}{path}{non_zero}{path}</g>\n\
            <clipPath id=\"c2\"><path d=\"m1 1h1v1h-1z\"/></clipPath>\n<g clip-path=\"url(#c2)\">\n\
            {non_zero}{path}</g>\n\
            <g clip-path=\"url(#c1)\">\n{even}{path}</g>\n{even}{path}"
        )
    );
}

/// The points that path data of lines leads through, added up in single precision as viewers do.
fn followed(data: &str) -> Vec<[f32; 2]> {
    let mut points: Vec<[f32; 2]> = Vec::new();
    let mut at = [0.0_f32; 2];
    let mut rest = data;
    let mut command = 'm';
    while !rest.is_empty() {
        if let Some(letter) = rest.chars().next().filter(char::is_ascii_alphabetic) {
            command = letter;
            rest = &rest[1..];
        }
        let mut number = || {
            rest = rest.trim_start_matches(' ');
            let mut point = false;
            let end = rest.char_indices().position(|(i, c)| {
                let again = c == '.' && point;
                point |= c == '.';
                again || !(c.is_ascii_digit() || c == '.' || (c == '-' && i == 0))
            });
            let (text, tail) = rest.split_at(end.unwrap_or(rest.len()));
            rest = tail;
            text.parse::<f32>().unwrap()
        };
        match command {
            'm' | 'l' => at = [at[0] + number(), at[1] + number()],
            'M' | 'L' => at = [number(), number()],
            'h' => at[0] += number(),
            'v' => at[1] += number(),
            _ => panic!("unexpected {command}"),
        }
        points.push(at);
    }
    points
}

#[test]
fn long_paths_do_not_drift() {
    // Steps that are no multiple of a hundredth, from a point that is none.
    let points: Vec<(f64, f64)> = (0..60_000_i32)
        .map(|i| (1.0 / 3.0 + f64::from(i) * 0.0163, 700.0 + f64::from(i % 7) * 1.0 / 7.0))
        .collect();
    let text = body(|svg| draw(svg, Form::Lines(paths(&[&points]).as_paths(), THIN), None));
    let data = text.split('"').nth(3).unwrap();
    let reached = followed(data);
    assert_eq!(reached.len(), points.len());
    for (&(x, y), reached) in points.iter().zip(&reached) {
        let error = DVec2::new(x - f64::from(reached[0]), y - f64::from(reached[1])).abs().max_element();
        assert!(error < 0.015, "({x}, {y}) became {reached:?}");
    }
}

#[test]
fn memory_does_not_grow_with_the_picture() {
    let written = Written::default();
    let mut svg = Svg::new(Box::new(written.clone()), &Options::default());
    svg.begin(&Page { number: 1, background: Colour::WHITE, colours: Vec::new() }).unwrap();
    let million: Vec<(f64, f64)> = (0..200_000).map(|i| (f64::from(i) * 0.005, f64::from(i % 10))).collect();
    draw(&mut svg, Form::Lines(paths(&[&million]).as_paths(), THIN), None);
    for i in 0..100_000 {
        let x = f64::from(i % 997);
        let line = [DVec2::new(x, 0.5), DVec2::new(x + 3.5, f64::from(i) * 0.01)];
        let clip = (i % 3 == 0).then(|| Rect::new(0.0, x + 1.0, 0.0, 500.0));
        let pen = Pen { width: f64::from(i % 11), ..THIN };
        draw(&mut svg, Form::Lines(gks_geometry::Paths::new(&line, &[2]), pen), clip);
        assert!(svg.document.held() < 100_000, "{} bytes are held after {i} marks", svg.document.held());
    }
    svg.end().unwrap();
    let written = written.0.lock().unwrap();
    assert!(written.0[0].len() > 3_000_000 && written.1 < 100_000);
}

#[test]
fn each_page_is_a_document_of_its_own() {
    let written = Written::default();
    let mut svg = Svg::new(Box::new(written.clone()), &Options::default());
    let line = paths(&[&[(1.0, 1.0), (5.0, 5.0)]]);
    for number in 1..=2 {
        svg.begin(&Page { number, background: Colour::WHITE, colours: Vec::new() }).unwrap();
        draw(&mut svg, Form::Lines(line.as_paths(), THIN), Some(Rect::new(0.0, 2.0, 0.0, 2.0)));
        svg.end().unwrap();
    }
    svg.close().unwrap();
    let documents = written.0.lock().unwrap().0.clone();
    assert_eq!(documents.len(), 2);
    let [first, second] = [0, 1].map(|i| String::from_utf8(documents[i].clone()).unwrap());
    assert_eq!(first.replace("Page 1", "Page 2"), second);
}

fn ellipse(a: (f64, f64), b: (f64, f64), range: (f64, f64), closure: Closure) -> Curve<'static, Du> {
    Curve::Ellipse(Ellipse {
        centre: (100.0, 200.0).into(),
        a: a.into(),
        b: b.into(),
        start: range.0,
        sweep: range.1,
        closure,
    })
}

#[test]
fn full_ellipses_stay_elements() {
    let text = body(|svg| {
        let full = |a, b| ellipse(a, b, (0.3, TAU), Closure::Full);
        draw(svg, Form::Filled(full((30.0, 40.0), (-40.0, 30.0)), RED), None);
        draw(svg, Form::Filled(full((30.0, 0.0), (0.0, 20.0)), RED), None);
        draw(svg, Form::Filled(full((10.0, 0.0), (0.0, -20.0)), RED), None);
        draw(svg, Form::Filled(full((20.0, 20.0), (-10.0, 10.0)), RED), None);
        // The conjugate semi-diameters of an ellipse with the axes (30, 0) and (0, 10).
        let (sin, cos) = 0.7_f64.sin_cos();
        draw(svg, Form::Filled(full((30.0 * cos, 10.0 * sin), (-30.0 * sin, 10.0 * cos)), RED), None);
    });
    assert_eq!(
        text,
        "<g fill=\"#f00\">\n\
        <circle cx=\"100\" cy=\"200\" r=\"50\"/>\n\
        <ellipse cx=\"100\" cy=\"200\" rx=\"30\" ry=\"20\"/>\n\
        <ellipse cx=\"100\" cy=\"200\" rx=\"10\" ry=\"20\"/>\n\
        <ellipse cx=\"100\" cy=\"200\" rx=\"28.28\" ry=\"14.14\" transform=\"rotate(45 100 200)\"/>\n\
        <ellipse cx=\"100\" cy=\"200\" rx=\"30\" ry=\"10\"/>\n\
        </g>\n"
    );
}

#[test]
fn arcs_are_quarters_and_closed_as_asked() {
    let arc = |range, closure| ellipse((50.0, 0.0), (0.0, -50.0), range, closure);
    let text = body(|svg| {
        draw(svg, Form::Stroke(arc((0.0, FRAC_PI_2), Closure::Open), THIN), None);
        draw(svg, Form::Stroke(arc((0.0, -PI), Closure::Chord), THIN), None);
        draw(svg, Form::Stroke(arc((0.0, FRAC_PI_2), Closure::Pie), THIN), None);
        let flat = ellipse((50.0, 10.0), (50.0, 10.0), (0.0, TAU), Closure::Full);
        draw(svg, Form::Stroke(flat, THIN), None);
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 1.5), (2.0, 3.0)].map(|(x, y)| DVec2::new(x, y));
        draw(svg, Form::Stroke(Curve::Bezier(&points), THIN), None);
    });
    assert_eq!(
        text,
        "<g stroke=\"#000\">\n\
        <path d=\"m150 200a50 50 0 0 0-50-50\"/>\n\
        <path d=\"m150 200a50 50 0 0 1-50 50 50 50 0 0 1-50-50z\"/>\n\
        <path d=\"m150 200a50 50 0 0 0-50-50v50z\"/>\n\
        <path d=\"m150 210 20.71 4.14-141.42-28.28 120.71 24.14z\"/>\n\
        <path d=\"m0 0c1 0 2 1.5 2 3\"/>\n\
        </g>\n"
    );
}

/// Points on an arc from `from` to `to`, by the formulas of SVG 1.1, F.6.5.
fn points_on(from: DVec2, to: DVec2, radii: DVec2, turn: f64, onwards: bool) -> [DVec2; 9] {
    let axis = DVec2::from_angle(turn.to_radians());
    // The way to the unit circle, on which the centre lies to the side of the chord.
    let [from, to] = [from, to].map(|p| DVec2::new(axis.x, -axis.y).rotate(p) / radii);
    let half = (from - to) / 2.0;
    let side = if onwards { 1.0 } else { -1.0 };
    let distance = (1.0 / half.length_squared() - 1.0).max(0.0).sqrt();
    let centre = (from + to) / 2.0 + DVec2::new(half.y, -half.x) * distance * side;
    let angle = (from - centre).angle_to(to - centre);
    std::array::from_fn(|i| {
        let here = DVec2::from_angle(angle * (i + 1) as f64 / 10.0).rotate(from - centre);
        axis.rotate((centre + here) * radii)
    })
}

#[test]
fn rounding_does_not_move_arcs() {
    for (minor, turn) in [(300.0, 0.3), (120.0, 1.0), (20.0, -0.5), (2.0, 0.1), (0.3, 2.0)] {
        let axis = DVec2::from_angle(turn);
        let (a, b) = (axis * 300.123, axis.perp() * minor);
        for sweep in [0.5, 1.7, PI - 1e-4, 4.0, -PI - 1e-5, -6.2] {
            let curve = ellipse((a.x, a.y), (b.x, b.y), (0.123, sweep), Closure::Open);
            let text = body(|svg| draw(svg, Form::Stroke(curve, THIN), None));
            let data = text.split('"').nth(3).unwrap().replace('-', " -").replace("a", " ").replace('m', "");
            // A second point in a number starts the next one.
            let mut split = String::new();
            for word in data.split_whitespace() {
                for (i, part) in word.split('.').enumerate() {
                    split.push_str(if i == 0 {
                        ""
                    } else if i == 1 {
                        "."
                    } else {
                        " ."
                    });
                    split.push_str(part);
                }
                split.push(' ');
            }
            let numbers: Vec<f64> = split.split_whitespace().map(|n| n.parse().unwrap()).collect();
            let mut at = DVec2::new(numbers[0], numbers[1]);
            assert_eq!((numbers.len() - 2) % 7, 0, "{text}");
            for arc in numbers[2..].chunks(7) {
                let to = at + DVec2::new(arc[5], arc[6]);
                let radii = DVec2::new(arc[0], arc[1]);
                for found in points_on(at, to, radii, arc[2], arc[4] == 1.0) {
                    // How far from the ellipse, to first order.
                    let local = DVec2::new(axis.x, -axis.y).rotate(found - DVec2::new(100.0, 200.0));
                    let unit = local / DVec2::new(300.123, minor);
                    let slope = unit / DVec2::new(300.123, minor);
                    let error = (unit.length() - 1.0).abs() * unit.length() / slope.length();
                    assert!(error < 0.02, "{error} at {found} of {text}");
                }
                at = to;
            }
        }
    }
}

#[test]
fn circles_are_markers_and_other_markers_are_refused() {
    let positions = [DVec2::new(5.0, 5.0), DVec2::new(8.25, 5.0)];
    let style = |kind| MarkerStyle { kind, size: 6.0, width: 1.5, paint: RED };
    let text = body(|svg| {
        draw(svg, Form::Markers(&positions, style(4)), None);
        draw(svg, Form::Markers(&positions[..1], style(-9)), None);
        for kind in [1, 2, 3, 5, -1, -8] {
            let mark = Mark { form: Form::Markers(&positions, style(kind)), clip: None };
            assert_eq!(svg.draw(&mark).unwrap(), Drawn::No);
        }
    });
    assert_eq!(
        text,
        "<g stroke=\"#f00\" stroke-width=\"1.5\">\n<circle cx=\"5\" cy=\"5\" r=\"3\"/>\n\
        <circle cx=\"8.25\" cy=\"5\" r=\"3\"/>\n</g>\n\
        <g fill=\"#f00\">\n<circle cx=\"5\" cy=\"5\" r=\"3\"/>\n</g>\n"
    );
}
