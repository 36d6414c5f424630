//! Pictures of the true-colour workstation, pixel by pixel.

use super::*;
use gks_geometry::{Point, Vector};
use gks_pipeline::item::Curve;
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;

const BLACK: Paint = Paint { colour: Colour::BLACK, index: 1 };
const RED: Paint = Paint { colour: Colour::rgb(1.0, 0.0, 0.0), index: 2 };
const HALF: Paint = Paint { colour: Colour { alpha: 0.5, ..Colour::BLACK }, index: 3 };

fn canvas(width: f64, height: f64) -> TrueColour {
    let options = Options { size: Some((width, height)), ..Options::default() };
    let mut device = TrueColour::new(&options, None).unwrap();
    device.begin(&Page { number: 1, background: Colour::WHITE, colours: vec![] }).unwrap();
    device
}

fn draw(device: &mut TrueColour, form: Form<'_>, clip: Option<Rect<Du>>) {
    assert_eq!(device.draw(&Mark { form, clip }).unwrap(), Drawn::Yes);
}

fn pen(paint: Paint, width: f64) -> Pen<'static> {
    Pen { paint, width, dash: &[], cap: Cap::Butt, join: Join::Miter }
}

fn points(of: &[(f64, f64)]) -> Vec<DVec2> {
    of.iter().map(|&p| p.into()).collect()
}

fn rectangle(x0: f64, x1: f64, y0: f64, y1: f64) -> Vec<DVec2> {
    points(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
}

/// The green component of every pixel, row by row: 0 where black or red was drawn, 255 on white.
fn greens(device: &TrueColour) -> Vec<Vec<u8>> {
    let (width, _) = device.size();
    device.shared().read(|bytes| {
        let rows = bytes.chunks_exact(width as usize * 4);
        rows.map(|row| row.chunks_exact(4).map(|p| p[1]).collect()).collect()
    })
}

#[test]
fn areas_follow_their_rule_and_cover_pixels_in_part() {
    for (rule, inner) in [(Rule::EvenOdd, 255), (Rule::NonZero, 0)] {
        let mut device = canvas(8.0, 8.0);
        let mut rings = rectangle(1.0, 7.0, 1.0, 6.5);
        rings.extend(rectangle(3.0, 5.0, 3.0, 5.0));
        draw(&mut device, Form::Area(Paths::new(&rings, &[4, 8]), rule, Fill::Solid(BLACK)), None);
        let g = greens(&device);
        assert_eq!((g[0][0], g[1][1], g[2][2], g[7][3]), (255, 0, 0, 255));
        assert_eq!(g[4][4], inner);
        // Opaque fill areas take pixels that they cover by half, so that neighbours leave no seam.
        let half = if rule == Rule::EvenOdd { 0..=2 } else { 120..=135 };
        assert!(half.contains(&g[6][3]), "{}", g[6][3]);
    }
}

#[test]
fn areas_with_a_common_boundary_leave_no_seam() {
    let mut device = canvas(20.0, 20.0);
    let left = points(&[(2.0, 2.0), (9.3, 2.0), (12.8, 18.0), (2.0, 18.0)]);
    let right = points(&[(9.3, 2.0), (18.0, 2.0), (18.0, 18.0), (12.8, 18.0)]);
    for ring in [left, right] {
        draw(&mut device, Form::Area(Paths::new(&ring, &[4]), Rule::EvenOdd, Fill::Solid(BLACK)), None);
    }
    let g = greens(&device);
    assert!(g[3..17].iter().all(|row| row[3..17].iter().all(|&v| v <= 2)), "{g:?}");
}

#[test]
fn without_antialiasing_there_are_only_two_colours() {
    let mut device = canvas(20.0, 20.0);
    assert!(device.set_antialiasing(false) && !device.antialiasing());
    let line = points(&[(1.0, 2.0), (18.0, 9.0), (3.0, 18.5)]);
    draw(&mut device, Form::Lines(Paths::new(&line, &[3]), pen(BLACK, 1.0)), None);
    draw(&mut device, Form::Lines(Paths::new(&line[1..2], &[1]), pen(BLACK, 3.0)), None);
    draw(&mut device, Form::Area(Paths::new(&line, &[3]), Rule::EvenOdd, Fill::Solid(BLACK)), None);
    let g = greens(&device).concat();
    assert!(g.iter().all(|&v| v == 0 || v == 255));
    assert!(g.iter().filter(|&&v| v == 0).count() > 100);
}

#[test]
fn a_translucent_line_that_crosses_itself_has_one_opacity() {
    for width in [1.0, 4.0] {
        let mut device = canvas(40.0, 40.0);
        let cross = points(&[(2.5, 20.5), (37.5, 20.5), (20.5, 37.5), (20.5, 2.5)]);
        draw(&mut device, Form::Lines(Paths::new(&cross, &[4]), pen(HALF, width)), None);
        let g = greens(&device);
        assert!(g[20][10].abs_diff(127) <= 1, "{}", g[20][10]);
        assert_eq!(g[20][20], g[20][10], "at the crossing");
        assert!(g.concat().iter().all(|&v| v >= g[20][10]));
    }
}

#[test]
fn a_long_wide_line_is_drawn_whole() {
    let mut device = canvas(600.0, 100.0);
    let wave: Vec<DVec2> = (0..4000)
        .map(|i| DVec2::new(20.0 + 0.14 * f64::from(i), 50.0 + 30.0 * (f64::from(i) * 0.01).sin()))
        .collect();
    let wide = Pen { cap: Cap::Projecting, ..pen(BLACK, 8.0) };
    draw(&mut device, Form::Lines(Paths::new(&wave, &[4000]), wide), None);
    let g = greens(&device);
    for p in &wave {
        assert_eq!(g[p.y as usize][p.x as usize], 0, "{p}");
    }
    assert_eq!(g[49][17], 0, "a projecting end");
    assert_eq!(g[49][14], 255);
}

#[test]
fn dots_are_as_wide_as_the_pen() {
    let mut device = canvas(30.0, 10.0);
    let dots = points(&[(4.5, 4.5), (10.0, 5.0), (20.0, 5.0)]);
    draw(&mut device, Form::Lines(Paths::new(&dots[..1], &[1]), pen(BLACK, 1.0)), None);
    draw(&mut device, Form::Lines(Paths::new(&dots[1..2], &[1]), pen(BLACK, 4.0)), None);
    let round = Pen { cap: Cap::Round, ..pen(BLACK, 6.0) };
    draw(&mut device, Form::Lines(Paths::new(&dots[2..], &[1]), round), None);
    let g = greens(&device);
    let black = |columns: std::ops::Range<usize>| {
        g.iter().map(|row| row[columns.clone()].iter().filter(|&&v| v == 0).count()).sum::<usize>()
    };
    assert_eq!((black(0..7), g[4][4]), (1, 0));
    assert_eq!(black(7..14), 16);
    let ink: f64 = g.iter().flat_map(|row| &row[15..26]).map(|&v| 1.0 - f64::from(v) / 255.0).sum();
    assert!((ink - 9.0 * std::f64::consts::PI).abs() < 1.0, "{ink}");
}

#[test]
fn a_cell_fills_the_pixels_whose_centre_it_contains() {
    let mut device = canvas(6.0, 4.0);
    let frame = Parallelogram {
        origin: Point::new(0.6, 0.4),
        columns: Vector::new(4.0, 0.0),
        rows: Vector::new(0.0, 2.2),
    };
    let grid = Grid { paints: &[BLACK, RED], columns: 2, rows: 1 };
    draw(&mut device, Form::Cells(frame, grid), Some(Rect::new(0.0, 6.0, 0.0, 1.8)));
    let colours =
        |row| -> Vec<[u8; 4]> { (0..6).map(|c| device.colour(c, row).unwrap().to_bytes()).collect() };
    let (w, b, r) = ([255; 4], [0, 0, 0, 255], [255, 0, 0, 255]);
    assert_eq!(colours(0), [w, b, b, r, r, w]);
    assert_eq!(colours(1), [w, b, b, r, r, w]);
    assert_eq!(colours(2), [w; 6], "clipped");
    assert_eq!(device.colour(6, 0), None);
}

#[test]
fn a_pattern_is_tiled_and_its_area_clipped_at_parts_of_pixels() {
    let mut device = canvas(8.0, 6.0);
    let far = rectangle(-1e9, 1e9, -1e9, 1e9);
    let frame = Parallelogram {
        origin: Point::new(1.0, 1.0),
        columns: Vector::new(4.0, 0.0),
        rows: Vector::new(0.0, 2.0),
    };
    let white = Paint { colour: Colour::WHITE, index: 0 };
    let fill = Fill::Pattern(frame, Grid { paints: &[BLACK, white], columns: 2, rows: 1 });
    let clip = Some(Rect::new(1.5, 8.0, 0.0, 5.0));
    draw(&mut device, Form::Area(Paths::new(&far, &[4]), Rule::EvenOdd, fill), clip);
    let g = greens(&device);
    assert_eq!(g[0], [255, 127, 0, 255, 255, 0, 0, 255]);
    assert_eq!(g[4], g[0]);
    assert_eq!(g[5], [255; 8]);
}

#[test]
fn what_is_left_to_the_pipeline_is_refused_untouched() {
    let mut device = canvas(10.0, 10.0);
    let line = points(&[(1.0, 1.0), (9.0, 9.0)]);
    let paths = Paths::new(&line, &[2]);
    let clip = Some(Rect::new(0.0, 5.0, 0.0, 5.0));
    for (form, clip) in [
        (Form::Lines(paths, Pen { dash: &[1.0, 1.0], ..pen(BLACK, 1.0) }), None),
        (Form::Lines(paths, pen(BLACK, 1.0)), clip),
        (Form::Area(paths, Rule::EvenOdd, Fill::Solid(BLACK)), clip),
        (Form::Filled(Curve::Bezier(&line), BLACK), None),
        (Form::Stroke(Curve::Bezier(&line), pen(BLACK, 1.0)), None),
    ] {
        assert_eq!(device.draw(&Mark { form, clip }).unwrap(), Drawn::No);
    }
    assert!(greens(&device).concat().iter().all(|&v| v == 255));
}

#[test]
fn far_and_bad_coordinates_neither_stop_nor_hang() {
    let mut device = canvas(50.0, 50.0);
    for far in [1e9, 1e40, 1e300, f64::INFINITY, f64::NAN] {
        let path = points(&[(-far, 25.0), (far, 25.0), (25.0, far), (25.0, 25.0)]);
        for paint in [BLACK, HALF] {
            for width in [0.0, 1.0, 5.0, 1e6] {
                for antialias in [true, false] {
                    device.set_antialiasing(antialias);
                    draw(&mut device, Form::Lines(Paths::new(&path, &[1, 4]), pen(paint, width)), None);
                }
            }
            draw(&mut device, Form::Area(Paths::new(&path, &[4]), Rule::NonZero, Fill::Solid(paint)), None);
        }
    }
    let mut device = canvas(50.0, 50.0);
    let path = points(&[(-1e9, 25.5), (1e9, 25.5)]);
    draw(&mut device, Form::Lines(Paths::new(&path, &[2]), pen(BLACK, 1.0)), None);
    assert_eq!(greens(&device)[25], [0; 50]);
}

#[test]
fn background_comes_from_the_page_or_the_options() {
    let page = Page { number: 1, background: Colour::rgb(0.0, 1.0, 0.0), colours: vec![] };
    let first = |options: Options| {
        let mut device = TrueColour::new(&options, None).unwrap();
        device.begin(&page).unwrap();
        device.colour(3, 3).unwrap().to_bytes()
    };
    assert_eq!(first(Options::default()), [0, 255, 0, 255]);
    let blue = Some(Colour::rgb(0.0, 0.0, 1.0));
    assert_eq!(first(Options { background: blue, ..Options::default() }), [0, 0, 255, 255]);
    assert_eq!(first(Options { transparent: true, ..Options::default() }), [0; 4]);
}

#[test]
fn cells_by_index_look_like_cells_of_paints() {
    use gks_pipeline::device::Palette;
    use gks_pipeline::item::Cells;
    use gks_pipeline::tables::Tables;
    let mut tables = Tables::predefined();
    tables.colours.set(3, Colour { alpha: 0.4, ..Colour::rgb(0.1, 0.9, 0.3) });
    tables.colours.set(4000, Colour { alpha: 0.5, ..Colour::rgb(0.6, 0.2, 0.3) });
    let whole = |x: f64, y: f64, width: f64, height: f64| Parallelogram {
        origin: Point::new(x, y),
        columns: Vector::new(width, 0.0),
        rows: Vector::new(0.0, height),
    };
    let skewed = Parallelogram {
        columns: Vector::new(9.0, 3.0),
        rows: Vector::new(-2.0, 8.0),
        ..whole(5.0, 1.0, 0.0, 0.0)
    };
    let turned = Parallelogram {
        columns: Vector::new(0.0, -9.0),
        rows: Vector::new(8.0, 0.0),
        ..whole(1.0, 11.0, 0.0, 0.0)
    };
    for [first, last] in [[1, 2], [0, 3], [2, 300], [-1, 4000]] {
        let indices: Vec<i32> = (0..60).map(|i| if i % 7 == 3 { last } else { first }).collect();
        let cells = Cells::new(&indices[2..], 6, 5, 10).unwrap();
        let paints: Vec<Paint> = (0..5)
            .flat_map(|row| cells.row(row).iter().map(|&index| Palette::new(&tables).paint(index)))
            .collect();
        let grid = Grid { paints: &paints, columns: 6, rows: 5 };
        for frame in [whole(2.0, 3.0, 6.0, 5.0), whole(0.5, -2.0, 17.0, 14.0), skewed, turned] {
            for clip in [None, Some(Rect::new(3.0, 9.0, 2.0, 7.0))] {
                let (mut by_index, mut by_paint) = (canvas(14.0, 12.0), canvas(14.0, 12.0));
                draw(&mut by_index, Form::IndexedCells(frame, cells, Palette::new(&tables)), clip);
                draw(&mut by_paint, Form::Cells(frame, grid), clip);
                let pixels = |device: &TrueColour| device.shared().read(<[u8]>::to_vec);
                assert!(pixels(&by_index) == pixels(&by_paint), "{first} {last} {frame:?} {clip:?}");
            }
        }
    }
}
