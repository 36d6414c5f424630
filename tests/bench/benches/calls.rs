//! What a call costs before a device sees anything of it.

use criterion::{Criterion, criterion_group, criterion_main};
use gks::{Gks, Points};
use gks_cli::bench::measurement;
use gks_pipeline::generated::numbers::workstation_type as own;
use std::hint::black_box;

fn kernel() -> Gks {
    measurement::open(own::NULL, "").expect("the null workstation can be opened")
}

fn primitives(c: &mut Criterion) {
    let mut gks = kernel();
    let (x, y) = ([0.1f32, 0.9], [0.2f32, 0.8]);
    c.bench_function("polyline of 2 points", |b| {
        b.iter(|| gks.polyline(Points::SplitSingles(black_box(&x), black_box(&y))));
    });
    c.bench_function("polyline of 2 points in a new colour", |b| {
        let mut colour = 1;
        b.iter(|| {
            colour ^= 3;
            gks.set_polyline_colour_index(black_box(colour))?;
            gks.polyline(Points::SplitSingles(black_box(&x), black_box(&y)))
        });
    });
    let many: Vec<f32> = (0..10_000).map(|i| i as f32 / 10_000.0).collect();
    c.bench_function("polyline of 10000 points", |b| {
        b.iter(|| gks.polyline(Points::SplitSingles(black_box(&many), black_box(&many))));
    });
    c.bench_function("polymarker of one point", |b| {
        b.iter(|| gks.polymarker(Points::SplitSingles(black_box(&x[..1]), black_box(&y[..1]))));
    });
    c.bench_function("fill area of 3 points", |b| {
        b.iter(|| gks.fill_area(black_box(&[(0.1, 0.1), (0.9, 0.1), (0.5, 0.9)])));
    });
}

fn attributes_and_inquiries(c: &mut Criterion) {
    let mut gks = kernel();
    c.bench_function("set polyline colour index", |b| b.iter(|| gks.set_polyline_colour_index(black_box(2))));
    c.bench_function("select normalization transformation", |b| {
        b.iter(|| gks.select_normalization_transformation(black_box(0)));
    });
    c.bench_function("inquire normalization transformation", |b| {
        b.iter(|| gks.inquire_normalization_transformation(black_box(0)));
    });
    c.bench_function("inquire clipping", |b| b.iter(|| black_box(&gks).inquire_clipping()));
}

criterion_group!(calls, primitives, attributes_and_inquiries);
criterion_main!(calls);
