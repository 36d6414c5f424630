//! What reaches a device: painting seen from below, with a device that records marks and refuses kinds.

use gks_geometry::{Dc, LongLine, Map, Ndc, PathBuf, Paths, Point, Points, Rect, Vector};
use gks_pipeline::colour::Colour;
use gks_pipeline::description::*;
use gks_pipeline::device::*;
use gks_pipeline::item::*;
use gks_pipeline::look::{Cap, InteriorStyle, Look};
use gks_pipeline::record::Record;
use gks_pipeline::tables::Tables;
use gks_pipeline::workstation::{Backend, Workstation};
use glam::DVec2;
use std::sync::{Arc, Mutex};

/// What a device saw of one mark.
#[derive(Clone, Debug, PartialEq)]
struct Seen {
    kind: &'static str,
    paths: Vec<Vec<DVec2>>,
    colour: u32,
    width: f64,
    clipped: bool,
}

/// Accepts unclipped solid lines, and whatever `accepts` names.
struct Recorder {
    surface: Surface,
    accepts: Vec<&'static str>,
    clips: bool,
    seen: Arc<Mutex<Vec<Seen>>>,
}

impl Device for Recorder {
    fn surface(&self) -> &Surface {
        &self.surface
    }
    fn begin(&mut self, _: &Page) -> Result<(), DeviceError> {
        Ok(())
    }
    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let copy = |paths: &Paths<'_, _>| paths.iter().map(<[DVec2]>::to_vec).collect::<Vec<_>>();
        let (kind, paths, colour, width) = match &mark.form {
            Form::LongLine(..) | Form::StrokeText(_) | Form::IndexedCells(..) => return Ok(Drawn::No),
            Form::Lines(paths, pen) if pen.dash.is_empty() => {
                ("lines", copy(paths), pen.paint.index, pen.width)
            }
            Form::Lines(paths, pen) => ("dashed", copy(paths), pen.paint.index, pen.width),
            Form::Area(rings, _, Fill::Solid(paint)) => ("area", copy(rings), paint.index, 0.0),
            Form::Area(rings, _, Fill::Pattern(_, grid)) => {
                ("pattern", copy(rings), grid.paints[0].index, 0.0)
            }
            Form::Markers(at, style) => ("markers", vec![at.to_vec()], style.paint.index, style.size),
            Form::Text(run) => {
                let at = run.glyphs.iter().map(|g| g.origin.0).collect();
                ("text", vec![at], run.paint.index, run.y.length())
            }
            Form::Cells(place, _) => ("cells", vec![place.corners().map(|p| p.0).to_vec()], 0, 0.0),
            Form::Stroke(_, pen) => ("stroke", vec![], pen.paint.index, pen.width),
            Form::Filled(_, paint) => ("filled", vec![], paint.index, 0.0),
        };
        let clipped = mark.clip.is_some();
        if !(kind == "lines" && !clipped || self.accepts.contains(&kind) && (self.clips || !clipped)) {
            return Ok(Drawn::No);
        }
        self.seen.lock().unwrap().push(Seen { kind, paths, colour, width, clipped });
        Ok(Drawn::Yes)
    }
    fn end(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}

/// A workstation of 1000 x 1000 units, y up, and what its device sees.
fn workstation(accepts: &[&'static str], clips: bool) -> (Workstation, Arc<Mutex<Vec<Seen>>>) {
    with_surface(accepts, clips, None)
}

fn with_surface(
    accepts: &[&'static str],
    clips: bool,
    pen: Option<f64>,
) -> (Workstation, Arc<Mutex<Vec<Seen>>>) {
    let surface = Surface { width: 1000.0, height: 1000.0, unit: 0.001, y_down: false, resolution: 1.0, pen };
    let seen = Arc::new(Mutex::new(Vec::new()));
    let imm = DynamicModification::Imm;
    let description = Description {
        number: 999,
        name: "recorder",
        category: Category::Output,
        classification: Classification::Vector,
        surface: surface.clone(),
        raster: (1000, 1000),
        colours: 0,
        dynamic: DynamicModifications {
            line_bundles: imm,
            marker_bundles: imm,
            text_bundles: imm,
            fill_bundles: imm,
            patterns: imm,
            colours: imm,
            transformation: DynamicModification::Irg,
        },
        deferral: DeferralMode::Asti,
        regeneration: RegenerationMode::Suppressed,
        segments: SegmentModifications::REDRAWN,
        input: [0; 6],
    };
    let device = Recorder { surface, accepts: accepts.to_vec(), clips, seen: seen.clone() };
    (Workstation::new(Backend::Device(Box::new(device)), description, Tables::predefined()), seen)
}

fn draw(workstation: &mut Workstation, shape: Shape<'_>, look: &Look, clip: Rect<Ndc>) {
    workstation.draw(&Item { shape, look, clip, pick: 0 }).unwrap();
}

fn path(points: &[(f64, f64)]) -> PathBuf<Ndc> {
    let mut set = PathBuf::new();
    set.add(points.iter().map(|&p| p.into()));
    set
}

fn area_look(interior: InteriorStyle, style: i32) -> Look {
    let mut look = Look::default();
    look.fill.interior = interior;
    look.fill.style = style;
    look
}

const SQUARE: [(f64, f64); 4] = [(0.2, 0.2), (0.6, 0.2), (0.6, 0.6), (0.2, 0.6)];
const LEFT: Rect<Ndc> = Rect::new(0.0, 0.4, 0.0, 1.0);

#[test]
fn long_lines_are_cut_as_short_ones_are() {
    // In and out many times, with the joints of pieces inside, outside and on the edge.
    let point = |i: usize| (i as f64 / 5000.0, 0.5 + 0.3 * ((i % 1023) as f64 / 511.0 - 1.0));
    let mut points: Vec<(f64, f64)> = (0..5000).map(point).collect();
    points[1024].1 = 0.7;
    points[3072].1 = 0.1;
    points[4000].0 = f64::NAN;
    points[4500].1 = f64::INFINITY;
    let mut parts = Vec::new();
    let line = LongLine::new(Points::from(&points), Map::IDENTITY, &mut parts);
    let mut held = PathBuf::new();
    held.add_pieces(&line);
    let clip = Rect::new(0.1, 0.85, 0.3, 0.7);
    for linetype in [1, 2] {
        let mut look = Look::default();
        look.line.linetype = linetype;
        let (mut ws, seen) = workstation(&[], false);
        draw(&mut ws, Shape::Polyline(held.as_paths()), &look, clip);
        assert_eq!(ws.draw_long_line(&line, &look, &clip).unwrap(), Drawn::Yes);
        let seen = seen.lock().unwrap();
        assert_eq!(seen.len(), 2);
        assert!(seen[0].paths.len() > 5, "{}", seen[0].paths.len());
        assert!(seen[0] == seen[1], "line type {linetype}");
    }
}

#[test]
fn lines_are_cut_at_the_clipping_rectangle() {
    let (mut ws, seen) = workstation(&[], false);
    let line = path(&[(0.1, 0.5), (0.9, 0.5), (0.9, 0.7), (0.1, 0.7)]);
    draw(&mut ws, Shape::Polyline(line.as_paths()), &Look::default(), LEFT);
    let seen = seen.lock().unwrap();
    assert_eq!(seen.len(), 1, "both pieces are one mark");
    let expected = vec![
        vec![DVec2::new(100.0, 500.0), DVec2::new(400.0, 500.0)],
        vec![DVec2::new(400.0, 700.0), DVec2::new(100.0, 700.0)],
    ];
    assert_eq!(seen[0].paths, expected);
    assert_eq!((seen[0].colour, seen[0].width), (1, 1.0));
}

#[test]
fn hidden_items_reach_no_device() {
    let (mut ws, seen) = workstation(&["area", "text", "cells", "markers"], true);
    let right = Rect::new(0.7, 1.0, 0.0, 1.0);
    draw(&mut ws, Shape::FillArea(path(&SQUARE).as_paths()), &area_look(InteriorStyle::Solid, 1), right);
    draw(&mut ws, Shape::Text(Point::new(0.1, 0.1), "away"), &Look::default(), right);
    draw(&mut ws, Shape::Polymarker(&[DVec2::new(0.5, 0.5)]), &Look::default(), right);
    assert_eq!(*seen.lock().unwrap(), []);
}

#[test]
fn dashes_keep_their_phase_when_the_line_is_clipped() {
    let mut look = Look::default();
    look.line.linetype = 2;
    let line = path(&[(0.0, 0.5), (1.0, 0.5)]);
    let dashes = |clip| {
        let (mut ws, seen) = workstation(&[], false);
        draw(&mut ws, Shape::Polyline(line.as_paths()), &look, clip);
        let seen = seen.lock().unwrap();
        seen[0].paths.clone()
    };
    let whole = dashes(Rect::UNIT);
    let part = dashes(Rect::new(0.303, 0.7, 0.0, 1.0));
    assert!(whole.len() > 30 && part.len() > 10);
    // Every inner dash of the clipped line is a dash of the whole one.
    for dash in &part[1..part.len() - 1] {
        let near = |d: &Vec<DVec2>| d[0].distance(dash[0]) < 1e-9 && d[1].distance(dash[1]) < 1e-9;
        assert!(whole.iter().any(near), "{dash:?}");
    }
}

#[test]
fn a_device_that_clips_gets_the_rectangle_and_any_other_the_clipped_area() {
    let look = area_look(InteriorStyle::Solid, 1);
    let (mut ws, seen) = workstation(&["area"], true);
    draw(&mut ws, Shape::FillArea(path(&SQUARE).as_paths()), &look, LEFT);
    assert!(seen.lock().unwrap()[0].clipped);
    let (mut ws, seen) = workstation(&["area"], false);
    draw(&mut ws, Shape::FillArea(path(&SQUARE).as_paths()), &look, LEFT);
    let seen = seen.lock().unwrap();
    assert!(!seen[0].clipped);
    let xs: Vec<f64> = seen[0].paths[0].iter().map(|p| p.x).collect();
    assert_eq!((xs.iter().copied().fold(0.0, f64::max), xs.len()), (400.0, 4));
}

#[test]
fn a_pen_fills_areas_with_lines_a_pen_width_apart() {
    let (mut ws, seen) = with_surface(&[], false, Some(10.0));
    let look = area_look(InteriorStyle::Solid, 1);
    draw(&mut ws, Shape::FillArea(path(&SQUARE).as_paths()), &look, Rect::UNIT);
    let seen = seen.lock().unwrap();
    let horizontal = seen[0].paths.iter().filter(|p| p.len() == 2).count();
    assert!((39..=41).contains(&horizontal), "{horizontal} lines for 400 units");
    assert_eq!(seen[0].width, 10.0);
}

#[test]
fn a_pen_draws_wide_lines_with_strokes_that_are_clipped_one_by_one() {
    let line = path(&[(0.1, 0.5), (0.9, 0.5)]);
    let strokes = |width: f64, clip| {
        let (mut ws, seen) = with_surface(&[], false, Some(10.0));
        let mut look = Look::default();
        look.line.width = width;
        draw(&mut ws, Shape::Polyline(line.as_paths()), &look, clip);
        let seen = seen.lock().unwrap();
        assert_eq!(seen.len(), 1);
        let points = seen[0].paths.concat();
        let low = points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        let high = points.iter().map(|p| p.y).fold(0.0, f64::max);
        (seen[0].width, low, high)
    };
    assert_eq!(strokes(15.0, Rect::UNIT), (15.0, 500.0, 500.0));
    assert_eq!(strokes(50.0, Rect::UNIT), (10.0, 480.0, 520.0));
    assert_eq!(strokes(50.0, Rect::new(0.0, 1.0, 0.0, 0.505)), (10.0, 480.0, 505.0));
}

#[test]
fn hatches_of_neighbours_continue_one_another() {
    let look = area_look(InteriorStyle::Hatch, -3);
    let ends = |ring: &[(f64, f64)]| {
        let (mut ws, seen) = workstation(&[], false);
        draw(&mut ws, Shape::FillArea(path(ring).as_paths()), &look, Rect::UNIT);
        let seen = seen.lock().unwrap();
        let at_seam = seen[0].paths.iter().flatten().filter(|p| (p.x - 500.0).abs() < 1e-6);
        let mut ys: Vec<i64> = at_seam.map(|p| (p.y * 1000.0).round() as i64).collect();
        ys.sort_unstable();
        ys
    };
    let left = ends(&[(0.3, 0.203), (0.5, 0.203), (0.5, 0.603), (0.3, 0.603)]);
    let right = ends(&[(0.5, 0.203), (0.7, 0.203), (0.7, 0.603), (0.5, 0.603)]);
    assert!(left.len() > 10);
    assert_eq!(left, right);
}

#[test]
fn hollow_areas_are_outlined_along_the_clipping_rectangle() {
    let (mut ws, seen) = workstation(&["area"], true);
    draw(&mut ws, Shape::FillArea(path(&SQUARE).as_paths()), &Look::default(), LEFT);
    let seen = seen.lock().unwrap();
    assert_eq!(seen[0].kind, "lines");
    let outline = &seen[0].paths[0];
    assert_eq!(outline.first(), outline.last());
    assert_eq!(outline.iter().filter(|p| p.x == 400.0).count(), 2);
}

#[test]
fn patterns_are_taken_apart_with_element_1_1_at_the_upper_left() {
    let (mut ws, seen) = workstation(&["area"], true);
    ws.tables_mut()
        .patterns
        .insert(9, gks_pipeline::tables::Pattern { columns: 2, rows: 2, indices: vec![2, 3, 4, 5] });
    let mut look = area_look(InteriorStyle::Pattern, 9);
    look.pattern.width = Vector::new(0.4, 0.0);
    look.pattern.height = Vector::new(0.0, 0.4);
    look.pattern.reference = Point::new(0.2, 0.2);
    draw(&mut ws, Shape::FillArea(path(&SQUARE).as_paths()), &look, Rect::UNIT);
    let seen = seen.lock().unwrap();
    let centre = |colour| {
        let ring = &seen.iter().find(|s| s.colour == colour).unwrap().paths[0];
        let sum = ring.iter().fold(DVec2::ZERO, |a, &b| a + b) / ring.len() as f64;
        (sum.x.round(), sum.y.round())
    };
    let quarters = [centre(2), centre(3), centre(4), centre(5)];
    assert_eq!(quarters, [(300.0, 500.0), (500.0, 500.0), (300.0, 300.0), (500.0, 300.0)]);
}

#[test]
fn cells_become_areas_of_one_colour_each() {
    let (mut ws, seen) = workstation(&["area"], true);
    let indices = [2, 2, 3, 3];
    let place = Parallelogram {
        origin: Point::new(0.0, 0.0),
        columns: Vector::new(1.0, 0.0),
        rows: Vector::new(0.0, 1.0),
    };
    let cells = Cells::new(&indices, 2, 2, 2).unwrap();
    draw(&mut ws, Shape::CellArray(place, cells), &Look::default(), Rect::UNIT);
    let seen = seen.lock().unwrap();
    assert_eq!(seen.iter().map(|s| (s.colour, s.paths.len())).collect::<Vec<_>>(), [(2, 1), (3, 1)]);
    assert!(seen[0].paths[0].iter().all(|p| p.y <= 500.0), "row 1 lies at P");
}

#[test]
fn a_marker_is_drawn_whole_where_its_position_is_inside() {
    let (mut ws, seen) = workstation(&[], false);
    let mut look = Look::default();
    look.marker.kind = 2;
    look.marker.size = 10.0;
    let at = [DVec2::new(0.39, 0.5), DVec2::new(0.41, 0.5)];
    draw(&mut ws, Shape::Polymarker(&at), &look, LEFT);
    let seen = seen.lock().unwrap();
    assert_eq!(seen[0].paths.len(), 2, "one plus of two lines");
    assert_eq!(seen[0].paths[0], [DVec2::new(360.0, 500.0), DVec2::new(420.0, 500.0)]);
}

#[test]
fn text_is_offered_as_characters_and_refused_text_becomes_outlines() {
    let mut look = Look::default();
    look.text.font = -21;
    look.text_geometry.height = Vector::new(0.0, 0.05);
    look.text_geometry.width = Vector::new(0.05, 0.0);
    let text = Shape::Text(Point::new(0.1, 0.5), "Hi");
    let (mut ws, seen) = workstation(&["text", "area"], true);
    draw(&mut ws, text, &look, Rect::UNIT);
    assert_eq!(seen.lock().unwrap()[0].kind, "text");
    let (mut ws, seen) = workstation(&["area"], true);
    draw(&mut ws, text, &look, Rect::UNIT);
    let seen = seen.lock().unwrap();
    assert_eq!((seen[0].kind, seen[0].paths.len()), ("area", 3), "H, and i with its dot");
    let top = seen[0].paths.iter().flatten().map(|p| p.y).fold(0.0, f64::max);
    assert!((top - 550.0).abs() < 3.0, "the cap line is a character height above the base line: {top}");
}

#[test]
fn text_is_stretched_by_its_vectors() {
    let mut look = Look::default();
    look.text_geometry.height = Vector::new(0.0, 0.1);
    look.text_geometry.width = Vector::new(0.02, 0.0);
    let (mut ws, seen) = workstation(&[], false);
    draw(&mut ws, Shape::Text(Point::new(0.1, 0.5), "H"), &look, Rect::UNIT);
    let seen = seen.lock().unwrap();
    let bounds = Rect::<Ndc>::around(seen[0].paths.iter().flatten().map(|&p| Point::from_vec(p))).unwrap();
    assert!((bounds.height() - 100.0).abs() < 1e-9, "cap height");
    assert!(bounds.width() < 20.0, "narrow");
}

#[test]
fn workstation_transformation_waits_for_an_empty_surface() {
    let (mut ws, seen) = workstation(&[], false);
    let line = path(&[(0.0, 0.0), (0.5, 0.5)]);
    draw(&mut ws, Shape::Polyline(line.as_paths()), &Look::default(), Rect::UNIT);
    ws.set_window(Rect::new(0.0, 0.5, 0.0, 0.5)).unwrap();
    assert!(ws.is_pending() && ws.is_new_frame_necessary());
    assert_eq!(ws.current().window, Rect::UNIT);
    ws.update(true, std::iter::empty()).unwrap();
    assert!(!ws.is_pending() && ws.is_empty());
    ws.set_viewport(Rect::<Dc>::new(0.0, 0.2, 0.0, 0.4)).unwrap();
    draw(&mut ws, Shape::Polyline(line.as_paths()), &Look::default(), Rect::UNIT);
    let seen = seen.lock().unwrap();
    assert_eq!(seen[0].paths[0][1], DVec2::new(500.0, 500.0));
    assert_eq!(seen[1].paths[0][1], DVec2::new(200.0, 200.0), "one scale for both directions");
}

#[test]
fn bundles_and_colours_are_those_of_the_workstation() {
    let (mut ws, seen) = workstation(&[], false);
    let mut look = Look { sources: gks_pipeline::look::AspectSourceFlags::BUNDLED, ..Look::default() };
    look.line_index = 5;
    look.line.width = 9.0;
    look.cap = Cap::Round;
    let line = path(&[(0.0, 0.0), (0.5, 0.5)]);
    draw(&mut ws, Shape::Polyline(line.as_paths()), &look, Rect::UNIT);
    look.line_index = 4711;
    ws.represent(&Record::ColourRepresentation(1, Colour::rgb(1.0, 0.0, 0.0))).unwrap();
    draw(&mut ws, Shape::Polyline(line.as_paths()), &look, Rect::UNIT);
    let seen = seen.lock().unwrap();
    assert_eq!(seen[0].width, 3.0, "predefined polyline bundle 5");
    assert_eq!(seen[1].width, 1.0, "an index without a bundle means bundle 1");
}
