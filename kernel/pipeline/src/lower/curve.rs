//! Curved generalized drawing primitives: offered as curves, else flattened to polygons.

use crate::device::{DeviceError, Drawn, Form};
use crate::item::{Closure, Curve, Role};
use crate::look::{InteriorStyle, Look};
use crate::painter::{Canvas, Painter, plain_pen};
use gks_algorithms::{curve, ellipse};
use gks_geometry::{Du, PathBuf, Point, Rect};
use glam::DVec2;

/// Draws a curve with the polyline or the fill area attributes of `look`.
pub(crate) fn draw(
    painter: &mut Painter,
    curve: &Curve<'_, Du>,
    role: Role,
    look: &Look,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let Some(bounds) = bounds(curve) else { return Ok(()) };
    if !bounds.meets(clip) {
        return Ok(());
    }
    // A curve that touches an edge, but for the last digits of a map, does not cross it.
    let around = clip.grown(canvas.surface.resolution * 1e-6);
    let crossing = (!around.contains_rect(&bounds)).then_some(*clip);
    match role {
        Role::Line => painter.with_pen(look, canvas, |painter, pen, canvas| {
            if canvas.offer(Form::Stroke(*curve, *pen), crossing)? == Drawn::Yes {
                return Ok(());
            }
            with_polygon(painter, curve, canvas, |painter, polygon, canvas| {
                painter.lines(polygon.as_paths(), pen, clip, canvas)
            })
        }),
        Role::Area => {
            let bundle = canvas.tables.fill(look);
            let paint = canvas.tables.translucent(bundle.colour, canvas.tables.opacity.areas);
            let whole_ellipse = matches!(curve, Curve::Ellipse(e) if e.closure == Closure::Full);
            let offered = match bundle.interior {
                InteriorStyle::Solid => Some(Form::Filled(*curve, paint)),
                InteriorStyle::Hollow if whole_ellipse && crossing.is_none() => {
                    Some(Form::Stroke(*curve, plain_pen(paint, canvas)))
                }
                _ => None,
            };
            if let Some(form) = offered
                && canvas.offer(form, crossing)? == Drawn::Yes
            {
                return Ok(());
            }
            with_polygon(painter, curve, canvas, |painter, polygon, canvas| {
                painter.area(polygon.as_paths(), look, clip, canvas)
            })
        }
    }
}

fn with_polygon(
    painter: &mut Painter,
    curve: &Curve<'_, Du>,
    canvas: &mut Canvas<'_>,
    then: impl FnOnce(&mut Painter, &PathBuf<Du>, &mut Canvas<'_>) -> Result<(), DeviceError>,
) -> Result<(), DeviceError> {
    let mut polygon = PathBuf::new();
    flattened(curve, canvas.tolerance(), &mut polygon.points);
    polygon.end();
    then(painter, &polygon, canvas)
}

/// The polygon of a curve, within `tolerance`, with the chord or the radii that complete it.
pub fn flattened(curve: &Curve<'_, Du>, tolerance: f64, out: &mut Vec<DVec2>) {
    match curve {
        Curve::Ellipse(e) => {
            ellipse::flatten(e.centre.0, e.a.0, e.b.0, e.start, e.sweep, tolerance, out);
            match e.closure {
                Closure::Full | Closure::Open => {}
                Closure::Chord => out.push(e.at(e.start).0),
                Closure::Pie => {
                    out.push(e.centre.0);
                    out.push(e.at(e.start).0);
                }
            }
        }
        Curve::Bezier(points) => curve::chain(points, tolerance, out),
    }
}

/// A rectangle that surely contains a curve.
fn bounds(curve: &Curve<'_, Du>) -> Option<Rect<Du>> {
    match curve {
        Curve::Ellipse(e) => {
            let reach = DVec2::new(e.a.x().hypot(e.b.x()), e.a.y().hypot(e.b.y()));
            Rect::around([Point::from_vec(e.centre.0 - reach), Point::from_vec(e.centre.0 + reach)])
        }
        Curve::Bezier(points) => Rect::around(points.iter().map(|&p| Point::from_vec(p))),
    }
}
