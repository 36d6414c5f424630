//! Every device shows the same picture.
//!
//! Each test picture is drawn on each device with a square surface, read by a program that nobody here wrote,
//! and compared with our own raster; `measure.rs` says how. Devices that can do less are compared with our
//! raster behind a device that can do as little: a plotter with solid lines of pens. `mutation.rs` draws
//! pictures that are wrong by little and sees that they are refused.
//!
//! Pictures that do not agree are left in `target/agreement`: ours, the other one, and where they differ. With
//! `GKS_KEEP_PICTURES=1` all are left there.

mod measure;
mod mutation;
mod render;

use gks_tests::pictures::{PICTURES, Picture};
use gks_tests::reader;
use measure::{Limits, Picture as Pixels, compare};
use render::{Plan, folder, save};
use std::fmt::Write;
use std::sync::OnceLock;

/// Our own raster of a picture of the table, drawn once.
fn ours(number: usize, plan: &Plan) -> Result<&'static Pixels, String> {
    type Drawn = [OnceLock<Result<Pixels, String>>; PICTURES.len()];
    static DRAWN: [Drawn; 3] = [const { [const { OnceLock::new() }; PICTURES.len()] }; 3];
    let drawn =
        DRAWN[plan.ability as usize][number].get_or_init(|| render::raster(&PICTURES[number], plan.ability));
    drawn.as_ref().map_err(Clone::clone)
}

/// Compares a picture of the table on a device with ours; an error says what differs.
fn agree(number: usize, plan: &Plan, limits: &Limits) -> Result<String, String> {
    let picture = &PICTURES[number];
    let ours = ours(number, plan)?;
    let theirs = plan.render(picture)?;
    let difference = compare(ours, &theirs);
    let fault = difference.fault(limits);
    if fault.is_some() || std::env::var_os("GKS_KEEP_PICTURES").is_some() {
        let file = |what: &str| folder().join(format!("{}-{}-{what}.png", picture.name, plan.name));
        save(ours, &file("ours"));
        save(&theirs, &file("theirs"));
        save(&difference.shown(ours), &file("difference"));
    }
    match fault {
        Some(fault) => Err(format!("{fault}  ({limits:?})")),
        None => Ok(difference.to_string()),
    }
}

/// Compares all pictures on a device with ours.
fn all_agree(plan: &Plan) {
    if !reader::present(plan.name, plan.programs) {
        return;
    }
    let mut faults = String::new();
    for (number, picture) in PICTURES.iter().enumerate() {
        match agree(number, plan, &limits(plan, picture)) {
            Ok(said) => println!("{:<28} {said}", picture.name),
            Err(fault) => {
                println!("{:<28} {fault}  <<<", picture.name);
                let _ = writeln!(faults, "{:<28} {fault}", picture.name);
            }
        }
    }
    assert!(faults.is_empty(), "{} differs; see {}:\n{faults}", plan.name, folder().display());
}

/// What a picture on a device may differ.
fn limits(plan: &Plan, picture: &Picture) -> Limits {
    let clipped = picture.name.ends_with("-clipped");
    match plan.name {
        // Ghostscript darkens every part of a pixel that an area touches. Wide curves are cut there at the
        // clipping rectangle with their width, while others are cut first and drawn then.
        "ps" | "eps" => Limits { strays: if clipped { 40 } else { 4 }, colours: 0, ink: 0.16, shift: 0.15 },
        // Cells of patterns end where the nearest line of a pen ends.
        "hpgl" => Limits { strays: 16, colours: 0, ink: 0.05, shift: 0.2 },
        // Lines are whole pixels wide.
        "png8" => Limits { strays: if clipped { 12 } else { 0 }, colours: 0, ink: 0.06, shift: 0.15 },
        // Areas there are a quarter of a pixel larger, so that no seams are between neighbours, and so is what
        // clipping leaves along the edges of large cells of patterns.
        "svg" | "svg-outlines" if picture.name == "fill_area-placed_patterns" => {
            Limits { strays: 40, colours: 0, ink: 0.02, shift: 0.15 }
        }
        _ => Limits { strays: if clipped { 12 } else { 0 }, colours: 0, ink: 0.02, shift: 0.15 },
    }
}

#[test]
fn png_agrees() {
    all_agree(&render::PNG);
}

#[test]
fn png8_agrees() {
    all_agree(&render::PNG8);
}

#[test]
fn svg_agrees() {
    all_agree(&render::SVG);
}

#[test]
fn svg_outlines_agrees() {
    all_agree(&render::SVG_OUTLINES);
}

#[test]
fn pdf_agrees() {
    all_agree(&render::PDF);
}

#[test]
fn ps_agrees() {
    all_agree(&render::PS);
}

#[test]
fn eps_agrees() {
    all_agree(&render::EPS);
}

#[test]
fn hpgl_agrees() {
    all_agree(&render::HPGL);
}
