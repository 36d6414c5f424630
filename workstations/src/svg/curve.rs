//! Curves: circles, ellipses and their parts, and Bezier curves.

use super::document::{Document, attribute, open_attribute, paint};
use super::line::stroke;
use super::path::PathData;
use super::{COORDINATE, FINE};
use crate::number::Decimal;
use gks_geometry::{Du, Rect};
use gks_pipeline::colour::Paint;
use gks_pipeline::device::Pen;
use gks_pipeline::item::{Closure, Curve, Ellipse};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::io;

/// Draws a curve with a pen.
pub(super) fn stroked(
    document: &mut Document,
    clip: Option<&Rect<Du>>,
    curve: &Curve<'_, Du>,
    pen: &Pen<'_>,
) -> io::Result<()> {
    document.group(clip, |out| stroke(out, pen));
    element(document, curve, pen.dash.is_empty())
}

/// Draws the area that a curve encloses.
pub(super) fn filled(
    document: &mut Document,
    clip: Option<&Rect<Du>>,
    curve: &Curve<'_, Du>,
    fill: &Paint,
) -> io::Result<()> {
    document.group(clip, |out| paint(out, "fill", fill.colour));
    element(document, curve, true)
}

/// Writes the element for an ellipse or a sector of one that clips.
pub(super) fn region(document: &mut Document, region: &Ellipse<Du>) -> io::Result<()> {
    element(document, &Curve::Ellipse(*region), true)
}

/// Writes the element for a curve; `anywhere` says that it does not matter where a full ellipse starts.
fn element(document: &mut Document, curve: &Curve<'_, Du>, anywhere: bool) -> io::Result<()> {
    match curve {
        Curve::Ellipse(ellipse) => {
            let axes = Axes::of(ellipse);
            if axes.is_flat() {
                flat(document, ellipse, &axes)
            } else if anywhere && ellipse.closure == Closure::Full {
                full(document, ellipse.centre.0, &axes);
                Ok(())
            } else {
                arc(document, ellipse, &axes)
            }
        }
        Curve::Bezier(points) => bezier(document, points),
    }
}

/// The principal axes of an ellipse given by conjugate semi-diameters.
struct Axes {
    /// The longer semi-axis.
    major: DVec2,
    /// The lengths of the semi-axes.
    radii: [f64; 2],
    /// The parameter at which the ellipse meets the longer axis.
    parameter: f64,
}

impl Axes {
    /// The parameter t where `a cos t + b sin t` is longest makes tan 2t = 2 ab / (aa - bb), products being
    /// inner ones; a quarter turn further it is shortest.
    fn of(ellipse: &Ellipse<Du>) -> Self {
        let (a, b) = (ellipse.a.0, ellipse.b.0);
        let parameter = 0.5 * (2.0 * a.dot(b)).atan2(a.dot(a) - b.dot(b));
        let (sin, cos) = parameter.sin_cos();
        let (major, minor) = (a * cos + b * sin, b * cos - a * sin);
        Axes { major, radii: [major.length(), minor.length()], parameter }
    }

    /// Whether the ellipse is no more than a line.
    fn is_flat(&self) -> bool {
        COORDINATE.steps(self.radii[1]) == 0
    }

    /// Whether the ellipse is a circle as far as numbers can tell.
    fn is_circle(&self) -> bool {
        COORDINATE.steps(self.radii[0]) == COORDINATE.steps(self.radii[1])
    }

    /// The angle from the x axis to the longer axis in degrees, from -90 to 90.
    fn turn(&self) -> f64 {
        let degrees = self.major.y.atan2(self.major.x).to_degrees();
        if degrees > 90.0 {
            degrees - 180.0
        } else if degrees <= -90.0 {
            degrees + 180.0
        } else {
            degrees
        }
    }
}

/// A full circle or ellipse.
fn full(document: &mut Document, centre: DVec2, axes: &Axes) {
    let circle = axes.is_circle();
    document.raw(if circle { "<circle" } else { "<ellipse" });
    document.attribute("cx", centre.x);
    document.attribute("cy", centre.y);
    let mut radii = axes.radii;
    if circle {
        document.attribute("r", radii[0]);
    } else {
        let degrees = FINE.steps(axes.turn());
        if degrees == FINE.steps(90.0) {
            radii.reverse();
        }
        document.attribute("rx", radii[0]);
        document.attribute("ry", radii[1]);
        if degrees != 0 && degrees != FINE.steps(90.0) {
            open_attribute(&mut document.out, "transform");
            document.raw("rotate(");
            FINE.write_steps(&mut document.out, degrees);
            document.raw(" ");
            document.number(centre.x);
            document.raw(" ");
            document.number(centre.y);
            document.raw(")\"");
        }
    }
    document.raw("/>\n");
}

/// The parameters at the ends of an arc.
fn range(ellipse: &Ellipse<Du>) -> [f64; 2] {
    let sweep = match ellipse.closure {
        Closure::Full => TAU.copysign(ellipse.sweep),
        _ => ellipse.sweep.clamp(-TAU, TAU),
    };
    [ellipse.start, ellipse.start + sweep]
}

/// A part of an ellipse, or a full one from its starting point on, as arcs of at most a quarter turn.
///
/// An arc is given by its ends and radii, and its centre follows from them. The nearer an arc is to half a
/// turn, and the flatter the ellipse, the more the rounding of the ends moves the centre: hence quarters,
/// and more decimal places for flat ellipses.
fn arc(document: &mut Document, ellipse: &Ellipse<Du>, axes: &Axes) -> io::Result<()> {
    let flatness = (axes.radii[0] / axes.radii[1] * 2.5).log10().clamp(0.0, 4.0) as u32;
    let turn = if axes.is_circle() { 0.0 } else { axes.turn() };
    let [from, to] = range(ellipse);
    let pieces = ((to - from).abs() / FRAC_PI_2 - 1e-9).ceil().clamp(1.0, 4.0);
    let onwards = (ellipse.a.0.perp_dot(ellipse.b.0) > 0.0) == (to > from);
    document.raw("<path d=\"");
    let mut data = PathData::new(document, Decimal::new(2 + flatness));
    data.move_to(ellipse.at(from).0)?;
    for piece in 1..=pieces as u32 {
        let t = from + (to - from) * f64::from(piece) / pieces;
        data.arc_to(axes.radii, turn, onwards, ellipse.at(t).0)?;
    }
    complete(&mut data, ellipse)?;
    document.raw("\"/>\n");
    Ok(())
}

/// An ellipse without width: a line that goes to and fro between the ends of the long axis.
fn flat(document: &mut Document, ellipse: &Ellipse<Du>, axes: &Axes) -> io::Result<()> {
    let [from, to] = range(ellipse);
    let (low, high) = (from.min(to), from.max(to));
    document.raw("<path d=\"");
    let mut data = PathData::new(document, COORDINATE);
    data.move_to(ellipse.at(from).0)?;
    let first = ((low - axes.parameter) / PI).ceil();
    let mut turns: Vec<f64> = (0..3).map(|i| axes.parameter + (first + f64::from(i)) * PI).collect();
    turns.retain(|&t| t < high);
    if to < from {
        turns.reverse();
    }
    let mut moved = false;
    for t in turns.into_iter().chain([to]) {
        moved |= data.line_to(ellipse.at(t).0)?;
    }
    if !moved {
        data.stay();
    }
    complete(&mut data, ellipse)?;
    document.raw("\"/>\n");
    Ok(())
}

/// Completes an arc to the boundary of an area where it is one.
fn complete(data: &mut PathData<'_>, ellipse: &Ellipse<Du>) -> io::Result<()> {
    if ellipse.closure == Closure::Pie {
        data.line_to(ellipse.centre.0)?;
    }
    if ellipse.closure != Closure::Open {
        data.close();
    }
    Ok(())
}

/// A chain of cubic Bezier curves.
fn bezier(document: &mut Document, points: &[DVec2]) -> io::Result<()> {
    let Some((&start, pieces)) = points.split_first() else { return Ok(()) };
    document.raw("<path d=\"");
    let mut data = PathData::new(document, COORDINATE);
    data.move_to(start)?;
    for piece in pieces.chunks_exact(3) {
        data.curve_to([piece[0], piece[1]], piece[2])?;
    }
    document.raw("\"/>\n");
    Ok(())
}

/// Draws markers that are circles, or discs where `filled`.
pub(super) fn circles(
    document: &mut Document,
    clip: Option<&Rect<Du>>,
    positions: &[DVec2],
    radius: f64,
    pen: &Pen<'_>,
    is_filled: bool,
) -> io::Result<()> {
    document
        .group(clip, |out| if is_filled { paint(out, "fill", pen.paint.colour) } else { stroke(out, pen) });
    for position in positions {
        document.raw("<circle");
        for (name, value) in [("cx", position.x), ("cy", position.y), ("r", radius)] {
            attribute(&mut document.out, name, value);
        }
        document.raw("/>\n");
        document.spill()?;
    }
    Ok(())
}
