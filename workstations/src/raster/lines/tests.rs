use super::*;
use gks_geometry::{Map, Points};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::look::Cap;
use std::cell::Cell;

const BLACK: Paint = Paint { colour: Colour::BLACK, index: 1 };

fn drawn(path: &[DVec2], paint: Paint, width: f64, cap: Cap, join: Join) -> Vec<f64> {
    let mut bitmap = Bitmap::new(100, 100);
    bitmap.fill([255; 4]);
    let pen = Pen { paint, width, dash: &[], cap, join };
    Lines::new().draw(&mut bitmap, &Paths::new(path, &[path.len() as u32]), &pen);
    bitmap.pixels().iter().map(|p| 1.0 - f64::from(p[1]) / 255.0).collect()
}

fn ink(path: &[DVec2], width: f64, cap: Cap) -> f64 {
    drawn(path, BLACK, width, cap, Join::Miter).iter().sum()
}

#[test]
fn a_line_keeps_its_weight_where_it_slants() {
    let middle = DVec2::splat(50.3);
    for degrees in 0..180 {
        let reach = DVec2::from_angle(f64::from(degrees).to_radians()) * 30.0;
        let (a, b) = (middle - reach, middle + reach);
        for (path, width, cap) in [
            (vec![a, b], 1.0, Cap::Butt),
            (vec![a, middle, b], 1.0, Cap::Butt),
            (vec![a, b], 1.7, Cap::Projecting),
            (vec![a, b], 3.0, Cap::Butt),
        ] {
            let longer = if cap == Cap::Projecting { width } else { 0.0 };
            let expected = (60.0 + longer) * width;
            let found = ink(&path, width, cap);
            assert!((found / expected - 1.0).abs() < 0.04, "{degrees} {width}: {found} {expected}");
        }
    }
}

#[test]
fn a_lone_segment_looks_like_one_of_many() {
    for end in [(80.2, 31.7), (40.9, 88.8), (20.3, 60.1), (71.4, 20.2), (23.1, 22.9), (13.3, 14.2)] {
        for (cap, width) in [(Cap::Butt, 1.0), (Cap::Round, 1.0), (Cap::Projecting, 1.0), (Cap::Round, 1.9)] {
            let (a, b) = (DVec2::new(20.3, 20.8), DVec2::from(end));
            let lone = drawn(&[a, b], BLACK, width, cap, Join::Bevel);
            let many = drawn(&[a, a.lerp(b, 0.4), b], BLACK, width, cap, Join::Bevel);
            let far = lone.iter().zip(&many).map(|(p, q)| (p - q).abs()).fold(0.0, f64::max);
            assert!(far < 0.15, "{b} {cap:?} {width}: {far}");
        }
    }
}

#[test]
fn a_dense_curve_is_as_dark_as_its_outline_and_no_darker() {
    // To and fro in a band of 5 by 50 pixels, in steps far smaller than a pixel.
    let band: Vec<DVec2> = (0..60_000u32)
        .map(|i| {
            let y = 40.0 + f64::from(i * 7919 % 1009) / 1009.0 * 5.0;
            DVec2::new(20.0 + 50.0 * f64::from(i) / 60_000.0, y)
        })
        .collect();
    let found = ink(&band, 1.0, Cap::Butt);
    assert!((found - 51.0 * 5.0).abs() < 6.0, "{found}");
}

#[test]
fn many_upright_dashes_look_like_each_of_them() {
    for (cap, join) in [(Cap::Round, Join::Round), (Cap::Butt, Join::Miter)] {
        let dashes: Vec<[DVec2; 2]> = (0..2000u32)
            .map(|i| {
                let i = f64::from(i);
                let at = DVec2::new(10.0 + i * 0.03, 20.0 + 60.0 * (i * 0.37).sin().abs());
                [at, at + DVec2::new(0.02, 5.0)]
            })
            .collect();
        let pen = Pen { paint: BLACK, width: 3.0, dash: &[], cap, join };
        let ends: Vec<u32> = (1..=2000).map(|i| 2 * i).collect();
        let mut pictures = [100, 6400].map(|columns| {
            let mut bitmap = Bitmap::new(columns, 100);
            bitmap.fill([255; 4]);
            Lines::new().draw(&mut bitmap, &Paths::new(dashes.as_flattened(), &ends), &pen);
            let rows = bitmap.pixels().chunks(columns as usize).flat_map(|row| &row[..100]);
            rows.map(|p| f64::from(p[1])).collect::<Vec<_>>()
        });
        let [reduced, all] = &mut pictures;
        assert!(reduced != all, "the path of 4000 points should be dense on 100 columns");
        let error: f64 = reduced.iter().zip(all.iter()).map(|(a, b)| (a - b).powi(2)).sum();
        let psnr = 10.0 * (255.0 * 255.0 * reduced.len() as f64 / error).log10();
        assert!(psnr > 34.0, "{cap:?} {psnr}");
    }
}

#[test]
fn faint_and_translucent_lines_have_one_opacity() {
    let half = Paint { colour: Colour { alpha: 0.5, ..Colour::BLACK }, index: 2 };
    let zigzag: Vec<DVec2> =
        [(20.0, 20.0), (70.0, 80.0), (70.0, 20.0), (20.0, 80.0), (20.0, 20.0)].map(DVec2::from).to_vec();
    for (paint, width, darkest) in [(half, 5.0, 0.5), (BLACK, 0.3, 0.3), (half, 0.4, 0.2)] {
        let pixels = drawn(&zigzag, paint, width, Cap::Round, Join::Round);
        let most = pixels.iter().copied().fold(0.0, f64::max);
        assert!(most < darkest + 0.01 && most > darkest * 0.85, "{most} {darkest}");
    }
}

/// A picture of 3000 by 3000 pixels on which `draw` draws with so many threads.
fn large(threads: usize, draw: impl FnOnce(&mut Lines, &mut Bitmap)) -> Bitmap {
    let mut bitmap = Bitmap::new(3000, 3000);
    bitmap.fill([255; 4]);
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let mut lines = Lines { pool: Some(Arc::new(pool)), ..Lines::new() };
    draw(&mut lines, &mut bitmap);
    assert_eq!(lines.nibs.len(), threads - 1);
    bitmap
}

/// A curve that is dense on large pictures.
fn dense_curve() -> Vec<DVec2> {
    let point = |i: u32| {
        let t = f64::from(i) / 200_000.0;
        let y = (t * 9000.0).sin() * 700.0 + (t * 7.0).cos() * 1000.0;
        DVec2::new(t * 3100.0 - 50.0, 1500.0 + (y * 16.0).round() / 16.0)
    };
    (0..200_000).map(point).collect()
}

#[test]
fn pixels_are_the_same_by_any_number_of_threads() {
    let curve = dense_curve();
    let zigzag: Vec<DVec2> = (0..60u32)
        .map(|i| DVec2::new(f64::from(i * 61 % 48) * 62.5 + 1.0625, f64::from(i * 7919 % 3001)))
        .collect();
    let tuples: Vec<(f64, f64)> = curve.iter().map(|&p| p.into()).collect();
    let half = Paint { colour: Colour { alpha: 0.5, ..Colour::BLACK }, index: 2 };
    let pen = |width| Pen { paint: half, width, dash: &[], cap: Cap::Round, join: Join::Round };
    let mut parts = Vec::new();
    let line = LongLine::new(Points::from(&tuples), Map::IDENTITY, &mut parts).mapped(&Map::IDENTITY);
    let pictures = |threads| {
        let draw = |path: &[DVec2], width| {
            let ends = [path.len() as u32];
            large(threads, |lines, bitmap| lines.draw(bitmap, &Paths::new(path, &ends), &pen(width)))
        };
        let long = large(threads, |lines, bitmap| lines.draw_long(bitmap, &line, &pen(1.0)));
        let dashed = Pen { dash: &[9.0, 30.0], ..pen(2.0) };
        let dashes = large(threads, |lines, bitmap| lines.draw_long(bitmap, &line, &dashed));
        [draw(&curve, 1.0), long, dashes, draw(&zigzag, 23.0), draw(&zigzag, 1.0)]
    };
    let alone = pictures(1);
    for picture in &alone {
        let drawn = picture.pixels().iter().filter(|pixel| **pixel != [255; 4]).count();
        assert!(drawn > 100_000, "{drawn}");
    }
    for threads in [2, 3, 7] {
        for (i, (one, other)) in alone.iter().zip(pictures(threads)).enumerate() {
            assert!(one.pixels() == other.pixels(), "picture {i} by {threads} threads");
        }
    }
}

#[test]
fn threads_draw_large_pictures_only_and_only_large_parts_of_them() {
    let curve = dense_curve();
    let pen = Pen { paint: BLACK, width: 1.0, dash: &[], cap: Cap::Butt, join: Join::Miter };
    let nibs = |columns, points: &[DVec2]| {
        let pool = Arc::new(ThreadPoolBuilder::new().num_threads(2).build().unwrap());
        let mut lines = Lines { pool: Some(pool), ..Lines::new() };
        let ends = [points.len() as u32];
        lines.draw(&mut Bitmap::new(columns, 2048), &Paths::new(points, &ends), &pen);
        lines.nibs.len()
    };
    let short = [(0.0, 0.0), (900.0, 900.0), (0.0, 900.0)].map(DVec2::from);
    assert_eq!([nibs(1024, &curve), nibs(1025, &curve), nibs(1025, &short)], [0, 1, 0]);
}

#[test]
fn a_thread_of_a_program_takes_up_nothing_else_while_it_draws() {
    thread_local!(static DRAWS: Cell<bool> = const { Cell::new(false) });
    let curve = dense_curve();
    let pen = Pen { paint: BLACK, width: 1.0, dash: &[], cap: Cap::Butt, join: Join::Miter };
    let ends = [curve.len() as u32];
    let pool = Arc::new(ThreadPoolBuilder::new().num_threads(2).build().unwrap());
    let mut lines = Lines { pool: Some(pool), ..Lines::new() };
    ThreadPoolBuilder::new().num_threads(1).build().unwrap().scope(|scope| {
        scope.spawn(|_| assert!(!DRAWS.get()));
        DRAWS.set(true);
        lines.draw(&mut Bitmap::new(3000, 3000), &Paths::new(&curve, &ends), &pen);
        DRAWS.set(false);
    });
}
