//! Nothing is allocated for a primitive once what holds its points has grown to its size, from the Rust API to the
//! picture, but for the few that are said here.
#![allow(unsafe_code, reason = "an allocator that counts")]

use gks::Gks;
use gks_pipeline::generated::numbers::workstation_type as own;
use gks_pipeline::look::{InteriorStyle, Precision};
use gks_tests::folder::Folder;
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The allocator of the system, which counts what each thread asks of it.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

fn count() {
    ALLOCATIONS.set(ALLOCATIONS.get() + 1);
}

// SAFETY: all is left to the allocator of the system.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: asked of us as well.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, address: *mut u8, layout: Layout) {
        // SAFETY: asked of us as well.
        unsafe { System.dealloc(address, layout) }
    }

    unsafe fn realloc(&self, address: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: asked of us as well.
        unsafe { System.realloc(address, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// How often is drawn.
const TIMES: usize = 1000;

type Draw = fn(&mut Gks, usize) -> gks::Result<()>;

/// Somewhere, from 0.1 to 0.9, different each time.
fn at(time: usize) -> f64 {
    0.1 + 0.8 * (time * 37 % 101) as f64 / 101.0
}

/// The primitives: name, what draws one at a time.
const PRIMITIVES: [(&str, Draw); 7] = [
    ("polyline", |gks, i| gks.polyline(&[(at(i), 0.1), (0.5, at(i + 1)), (0.9, 0.2)])),
    ("dashed polyline", |gks, i| {
        gks.set_linetype(2)?;
        gks.polyline(&[(at(i), 0.1), (0.5, at(i + 1)), (0.9, 0.2)])?;
        gks.set_linetype(1)
    }),
    ("polymarker", |gks, i| gks.polymarker(&[(at(i), 0.1), (0.5, at(i + 1))])),
    ("fill area", |gks, i| {
        gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
        gks.fill_area(&[(at(i), 0.1), (0.5, at(i + 1)), (0.9, 0.2)])
    }),
    ("hatched fill area", |gks, i| {
        gks.set_fill_area_interior_style(InteriorStyle::Hatch)?;
        gks.set_fill_area_style_index(-1)?;
        gks.fill_area(&[(at(i), 0.1), (0.5, at(i + 1)), (0.9, 0.2)])
    }),
    ("text", |gks, i| {
        gks.set_text_font_and_precision(1, Precision::Stroke)?;
        gks.text((at(i), at(i + 1)), "Text in strokes")
    }),
    ("cell array", |gks, i| {
        let cells = [1, 2, 3, 4, 5, 6];
        gks.cell_array_of((at(i), 0.3), (at(i) + 0.05, 0.2), &cells, 3, 2, 3)
    }),
];

/// Draws each primitive many times after it was drawn as often before, and compares the allocations of one with what is
/// allowed: nothing, but for those primitives that `exceptions` has.
fn check(kind: i32, connection: &str, exceptions: &[(&str, usize)]) {
    let mut gks = Gks::open(Box::new(Drivers::new(Environment::default())));
    gks.open_workstation(1, connection, kind).expect("a workstation");
    gks.activate_workstation(1).expect("it is active");
    for (name, draw) in PRIMITIVES {
        (0..TIMES).for_each(|i| draw(&mut gks, i).expect(name));
        let before = ALLOCATIONS.get();
        (0..TIMES).for_each(|i| draw(&mut gks, i).expect(name));
        let counted = ALLOCATIONS.get() - before;
        let allowed = exceptions.iter().find(|exception| exception.0 == name).map_or(0, |e| e.1);
        assert!(counted <= allowed * TIMES, "{name}: {counted} allocations for {TIMES}");
    }
}

/// A cell array has a list of the cells of its pixels, along each of its sides.
#[test]
fn a_frame_buffer_allocates_nothing_but_for_cell_arrays() {
    check(own::FRAMEBUFFER, "", &[("cell array", 12)]);
}

/// SVG has no markers but circles: the shape of others is made for each polymarker, not for each marker. Cells are
/// ordered by colour, or compressed.
#[test]
fn a_document_allocates_nothing_but_for_shapes_of_markers_and_cell_arrays() {
    let folder = Folder::new(env!("CARGO_TARGET_TMPDIR"), "allocation");
    check(own::SVG, &folder.file("picture.svg"), &[("polymarker", 16), ("cell array", 4)]);
}
