//! GENERALIZED DRAWING PRIMITIVE: the primitives of GR, and those of this library.

use crate::argument::{Address, call};
use crate::extension;
use crate::image::packed;
use crate::output::{border, translucent};
use crate::path::{Part, parts};
use gks::{DataRecord, Function, Gks, Points};
use gks_pipeline::look::InteriorStyle;
use glam::DVec2;
use std::ffi::c_int;

/// The primitives of GR.
const PATH: c_int = 1;
const LINES: c_int = 2;
const MARKERS: c_int = 3;
const TRIANGLES: c_int = 4;
const POLYGONS: c_int = 5;

/// Draws a primitive of GR, or one of those that have negative identifiers here.
#[unsafe(no_mangle)]
extern "C" fn gks_gdp(
    count: c_int,
    x: Address<f64>,
    y: Address<f64>,
    primitive: c_int,
    length: c_int,
    record: Address<c_int>,
) {
    draw(&DVec2s::of(x.array(count), y.array(count)), primitive, record.array(length));
}

/// The same with coordinates as GR's text in three dimensions gives them.
#[unsafe(no_mangle)]
extern "C" fn gks_ft_gdp(
    count: c_int,
    x: Address<f64>,
    y: Address<f64>,
    primitive: c_int,
    length: c_int,
    record: Address<c_int>,
) {
    gks_gdp(count, x, y, primitive, length, record);
}

/// The same for Fortran.
#[unsafe(no_mangle)]
extern "C" fn GGDP(
    count: Address<c_int>,
    x: Address<f32>,
    y: Address<f32>,
    primitive: Address<c_int>,
    length: Address<c_int>,
    record: Address<c_int>,
) {
    let number = |address: Address<c_int>| address.slice(1).first().copied().unwrap_or(0);
    let (x, y) = (x.array(number(count)), y.array(number(count)));
    let points = x.iter().zip(y).map(|(&x, &y)| DVec2::new(x.into(), y.into())).collect();
    draw(&DVec2s(points), number(primitive), record.array(number(length)));
}

/// The points of a primitive.
struct DVec2s(Vec<DVec2>);

impl DVec2s {
    fn of(x: &[f64], y: &[f64]) -> Self {
        DVec2s(x.iter().zip(y).map(|(&x, &y)| DVec2::new(x, y)).collect())
    }

    /// The point with a number, from 1.
    fn numbered(&self, number: c_int) -> Option<DVec2> {
        self.0.get(usize::try_from(number).ok()?.checked_sub(1)?).copied()
    }
}

fn draw(points: &DVec2s, primitive: c_int, record: &[c_int]) {
    call(Function::GeneralizedDrawingPrimitive, |gks| match primitive {
        PATH => parts(record, &points.0).iter().try_for_each(|part| draw_part(gks, part)),
        LINES => lines(gks, points, record),
        MARKERS => markers(gks, points, record),
        TRIANGLES => triangles(gks, points, record),
        POLYGONS => polygons(gks, points, record),
        other => {
            let points: Vec<(f64, f64)> = tuples(&points.0);
            gks.generalized_drawing_primitive(Points::Tuples(&points), other, &DataRecord::default())
        }
    });
}

/// The index of a colour of its own, as opaque as what is drawn now.
fn own(colour: c_int) -> c_int {
    packed(colour, extension::with(|state| state.opacity))
}

fn tuples(points: &[DVec2]) -> Vec<(f64, f64)> {
    points.iter().map(|p| (p.x, p.y)).collect()
}

/// Fills an area in a colour, whatever the interior style is.
fn fill(gks: &mut Gks, outline: &[(f64, f64)], colour: Option<c_int>) -> gks::Result<()> {
    let (style, index) = (gks.inquire_fill_area_interior_style()?, gks.inquire_fill_area_colour_index()?);
    let colour = colour.unwrap_or(index);
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    gks.set_fill_area_colour_index(colour)?;
    let drawn = translucent(gks, Some(colour), |gks| gks.fill_area(Points::Tuples(outline)));
    gks.set_fill_area_interior_style(style)?;
    gks.set_fill_area_colour_index(index)?;
    drawn
}

/// Draws a part of a path: its inside in the colour of areas, what is inside twice being outside, its edge as borders are.
fn draw_part(gks: &mut Gks, part: &Part) -> gks::Result<()> {
    if part.paint.fill && !part.lines.is_empty() {
        // Ways to the other lines and back again enclose nothing.
        let mut outline = Vec::new();
        for line in &part.lines {
            outline.extend(tuples(line));
            outline.extend(outline.first().copied());
        }
        fill(gks, &outline, None)?;
    }
    if part.paint.stroke {
        part.lines.iter().try_for_each(|line| border(gks, &tuples(line)))?;
    }
    Ok(())
}

/// Lines with a width, in thousandths, and a colour for each.
fn lines(gks: &mut Gks, points: &DVec2s, record: &[c_int]) -> gks::Result<()> {
    let attributes = record.as_chunks::<2>().0;
    let old = (gks.inquire_polyline_colour_index()?, gks.inquire_linewidth_scale_factor()?);
    let mut drawn = Ok(());
    for (pair, &[width, colour]) in points.0.windows(2).zip(attributes) {
        gks.set_linewidth_scale_factor(f64::from(width.max(0)) / 1000.0)?;
        gks.set_polyline_colour_index(own(colour))?;
        drawn = gks.polyline(Points::Tuples(&tuples(pair)));
        if drawn.is_err() {
            break;
        }
    }
    gks.set_polyline_colour_index(old.0)?;
    gks.set_linewidth_scale_factor(old.1)?;
    drawn
}

/// Markers with a size, in thousandths, and a colour for each.
fn markers(gks: &mut Gks, points: &DVec2s, record: &[c_int]) -> gks::Result<()> {
    let attributes = record.as_chunks::<2>().0;
    let old = (gks.inquire_polymarker_colour_index()?, gks.inquire_marker_size_scale_factor()?);
    let mut drawn = Ok(());
    for (point, &[size, colour]) in points.0.iter().zip(attributes) {
        gks.set_marker_size_scale_factor(f64::from(size.max(0)) / 1000.0)?;
        gks.set_polymarker_colour_index(own(colour))?;
        drawn = gks.polymarker(Points::Tuples(&[(point.x, point.y)]));
        if drawn.is_err() {
            break;
        }
    }
    gks.set_polymarker_colour_index(old.0)?;
    gks.set_marker_size_scale_factor(old.1)?;
    drawn
}

/// The edges of triangles: the numbers of three points and a colour for each.
fn triangles(gks: &mut Gks, points: &DVec2s, record: &[c_int]) -> gks::Result<()> {
    let triangles = record.as_chunks::<4>().0;
    let old = gks.inquire_polyline_colour_index()?;
    let mut drawn = Ok(());
    for &[a, b, c, colour] in triangles {
        let corners: Option<Vec<DVec2>> = [a, b, c, a].into_iter().map(|n| points.numbered(n)).collect();
        let Some(corners) = corners else { continue };
        gks.set_polyline_colour_index(own(colour))?;
        drawn = gks.polyline(Points::Tuples(&tuples(&corners)));
        if drawn.is_err() {
            break;
        }
    }
    gks.set_polyline_colour_index(old)?;
    drawn
}

/// Polygons with their edges: how many points, their numbers and a colour for each. The opacity in the colour is not used.
fn polygons(gks: &mut Gks, points: &DVec2s, mut record: &[c_int]) -> gks::Result<()> {
    while let [length, rest @ ..] = record {
        let length = usize::try_from(*length).unwrap_or(usize::MAX);
        let Some((numbers, &[colour, ref after @ ..])) = rest.split_at_checked(length) else { break };
        record = after;
        let corners: Vec<DVec2> = numbers.iter().filter_map(|&n| points.numbered(n)).collect();
        if corners.len() > 2 {
            let mut outline = tuples(&corners);
            fill(gks, &outline, Some(own(colour)))?;
            outline.extend(outline.first().copied());
            border(gks, &outline)?;
        }
    }
    Ok(())
}
