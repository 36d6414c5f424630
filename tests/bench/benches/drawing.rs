//! Every workload that is drawn in memory or into a file, at its smallest size.

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
            Way::Redrawn | Way::Played | Way::Start(_) => continue,
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
