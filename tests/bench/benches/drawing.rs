//! Every workload but whole processes, at its smallest size: drawn in memory or into a file, redrawn from a segment,
//! played from a metafile.

use criterion::{Criterion, criterion_group, criterion_main};
use gks_cli::bench::measurement::{self, Folder};
use gks_cli::bench::workload::{self, Way};
use gks_pipeline::generated::numbers::workstation_type as own;

fn drawing(c: &mut Criterion) {
    let folder = Folder::new().expect("a folder for pictures");
    let mut group = c.benchmark_group("drawing");
    group.sample_size(10);
    for workload in workload::all() {
        let scene = (workload.scene)(workload.sizes[0]);
        let kind = match workload.way {
            Way::TrueColour => own::FRAMEBUFFER,
            Way::Indexed => own::FRAMEBUFFER8,
            Way::Document(kind) => {
                let file = folder.path().join(&workload.name);
                group.bench_function(&workload.name, |b| {
                    b.iter(|| measurement::write(kind, &*scene, &file).expect("the document is written"));
                });
                continue;
            }
            Way::Redrawn => {
                let mut gks = measurement::open_segment(&*scene).expect("a segment");
                group.bench_function(&workload.name, |b| {
                    b.iter(|| gks.redraw_all_segments_on_workstation(1).expect("the segment is redrawn"));
                });
                continue;
            }
            Way::Played(kind) => {
                let file = folder.path().join(&workload.name);
                measurement::write(kind, &*scene, &file).expect("the metafile is written");
                let mut gks = measurement::open(own::FRAMEBUFFER, "").expect("a frame buffer");
                group.bench_function(&workload.name, |b| {
                    b.iter(|| measurement::play(&mut gks, &file).expect("the metafile is played"));
                });
                continue;
            }
            Way::Start(_) => continue,
        };
        let mut gks = measurement::open(kind, "").expect("a frame buffer");
        group.bench_function(&workload.name, |b| {
            b.iter(|| measurement::draw(&*scene, &mut gks).expect("the scene is drawn"));
        });
    }
    group.finish();
}

criterion_group!(all, drawing);
criterion_main!(all);
