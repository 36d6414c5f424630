//! The measure refuses pictures that are wrong by little, on every device.

use crate::limits;
use crate::measure::compare;
use crate::render::{EPS, HPGL, PDF, PNG, PNG8, PS, Plan, SVG, SVG_OUTLINES, raster};
use gks::{Gks, Result};
use gks_pipeline::look::{Cap, InteriorStyle, Precision};
use gks_tests::pictures::{Content, Picture};
use gks_tests::reader;

static DEVICES: [&Plan; 8] = [&PNG, &PNG8, &SVG, &SVG_OUTLINES, &PDF, &PS, &EPS, &HPGL];

/// A picture, and the same wrong by little.
struct Mutation {
    name: &'static str,
    right: fn(&mut Gks, i32) -> Result<()>,
    wrong: fn(&mut Gks, i32) -> Result<()>,
}

macro_rules! mutations {
    ($($drawing:ident),+ $(,)?) => {
        [$(Mutation {
            name: stringify!($drawing),
            right: |gks, _| $drawing(gks, 0.0),
            wrong: |gks, _| $drawing(gks, 1.0),
        }),+]
    };
}

impl Mutation {
    fn picture(&self, wrong: bool) -> Picture {
        let content = Content::Gks(if wrong { self.wrong } else { self.right });
        Picture { name: self.name, content }
    }
}

/// Many labels; one is 3 pixels too far to the right.
fn label_shifted(gks: &mut Gks, wrong: f64) -> Result<()> {
    for i in 0..40 {
        let font = [1, -7, -21, -25][i % 4];
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        gks.set_character_height(0.012 + 0.002 * (i % 3) as f64)?;
        let shift = if i == 21 { 0.003 * wrong } else { 0.0 };
        gks.text((0.05 + 0.23 * (i % 4) as f64 + shift, 0.95 - 0.09 * (i / 4) as f64), "Label 12.5")?;
    }
    Ok(())
}

/// Many markers of nominal size; one is missing.
fn marker_missing(gks: &mut Gks, wrong: f64) -> Result<()> {
    for kind in 2..=5 {
        gks.set_marker_type(kind)?;
        for i in 0..100 {
            if kind != 4 || i != 37 || wrong == 0.0 {
                let (x, y) = (0.05 + 0.09 * f64::from(i % 10), 0.05 + 0.09 * f64::from(i / 10));
                gks.polymarker(&[(x + 0.02 * f64::from(kind), y)])?;
            }
        }
    }
    Ok(())
}

/// Many dashed lines; one has another linetype.
fn linetype_changed(gks: &mut Gks, wrong: f64) -> Result<()> {
    for i in 0..20 {
        let other = i == 7 && wrong != 0.0;
        gks.set_linetype(if other { -3 } else { 2 })?;
        gks.polyline(&[(0.05, 0.05 + 0.045 * f64::from(i)), (0.95, 0.06 + 0.045 * f64::from(i))])?;
    }
    Ok(())
}

/// Many solid lines; one is 2.4 pixels too low.
fn line_moved(gks: &mut Gks, wrong: f64) -> Result<()> {
    for i in 0..20 {
        let moved = if i == 7 { -0.0024 * wrong } else { 0.0 };
        let y = 0.05 + 0.045 * f64::from(i) + moved;
        gks.polyline(&[(0.05, y), (0.5, y + 0.01), (0.95, y)])?;
    }
    Ok(())
}

/// A line of another colour.
fn colour_changed(gks: &mut Gks, wrong: f64) -> Result<()> {
    for i in 0..20 {
        let other = i == 7 && wrong != 0.0;
        gks.set_polyline_colour_index(if other { 2 } else { 4 })?;
        gks.polyline(&[(0.05, 0.05 + 0.045 * f64::from(i)), (0.95, 0.06 + 0.045 * f64::from(i))])?;
    }
    Ok(())
}

/// A letter in place of another one.
fn letter_changed(gks: &mut Gks, wrong: f64) -> Result<()> {
    gks.set_text_font_and_precision(-21, Precision::Stroke)?;
    gks.set_character_height(0.015)?;
    for i in 0..20 {
        let text = if i == 7 && wrong != 0.0 { "mistaken" } else { "mistaker" };
        gks.text((0.1, 0.05 + 0.045 * f64::from(i)), text)?;
    }
    Ok(())
}

/// A viewport 3 pixels too wide.
fn clipped_too_far(gks: &mut Gks, wrong: f64) -> Result<()> {
    gks.set_viewport(1, (0.2, 0.7 + 0.003 * wrong, 0.2, 0.8))?;
    gks.set_window(1, (0.2, 0.7 + 0.003 * wrong, 0.2, 0.8))?;
    gks.select_normalization_transformation(1)?;
    for i in 0..30 {
        gks.polyline(&[(0.0, 0.033 * f64::from(i)), (1.0, 0.033 * f64::from(i))])?;
    }
    Ok(())
}

/// A hole filled.
fn hole_filled(gks: &mut Gks, wrong: f64) -> Result<()> {
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    let mut points = vec![(0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8), (0.2, 0.2)];
    if wrong == 0.0 {
        points.extend([(0.5, 0.5), (0.508, 0.5), (0.508, 0.508), (0.5, 0.508), (0.5, 0.5)]);
    }
    gks.fill_area(&points)
}

/// Everything half a pixel too high.
fn all_shifted(gks: &mut Gks, wrong: f64) -> Result<()> {
    let low = -0.0005 * wrong;
    gks.set_window(1, (0.0, 1.0, low, 1.0 + low))?;
    gks.select_normalization_transformation(1)?;
    label_shifted(gks, 0.0)?;
    marker_missing(gks, 0.0)
}

/// A line end of another kind.
fn end_changed(gks: &mut Gks, wrong: f64) -> Result<()> {
    gks.set_linewidth_scale_factor(12.0)?;
    gks.set_line_cap(if wrong == 0.0 { Cap::Butt } else { Cap::Round })?;
    gks.polyline(&[(0.2, 0.5), (0.8, 0.6)])
}

#[test]
fn pictures_that_are_wrong_by_little_are_refused() {
    let mutations = mutations![
        label_shifted,
        marker_missing,
        linetype_changed,
        line_moved,
        colour_changed,
        letter_changed,
        clipped_too_far,
        hole_filled,
        all_shifted,
        end_changed,
    ];
    let mut faults = Vec::new();
    for plan in DEVICES {
        if !reader::present(plan.name, plan.programs) {
            continue;
        }
        for mutation in &mutations {
            let [right, wrong] = [false, true].map(|wrong| mutation.picture(wrong));
            let shown = plan.render(&right).expect("the device draws");
            let mut judge = |picture: &Picture, good: bool| {
                let ours = raster(picture, plan.ability).expect("the frame buffer draws");
                let difference = compare(&ours, &shown);
                println!("{:<13} {:<17} {good:<5} {difference}", plan.name, mutation.name);
                if difference.fault(&limits(plan, picture)).is_none() != good {
                    faults.push(format!("{} {} right {good}: {difference}", plan.name, mutation.name));
                }
            };
            judge(&right, true);
            judge(&wrong, false);
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
