//! Highlighting: a band along everything that a segment draws, in the highlighting colour.
//!
//! The band is drawn before the primitives and reaches the same distance beyond all of them, so that it is
//! seen whatever their shapes and colours are, and on every device: it consists of solid wide lines. Lines
//! and strokes of characters are drawn wider, areas, cells, curves and outlines of characters get a wide
//! boundary.

use crate::device::{DeviceError, MarkerStyle, Pen};
use crate::item::{Curve, Item, Parallelogram, Role, Shape};
use crate::look::{Cap, Join, Look};
use crate::lower;
use crate::painter::{Canvas, Painter};
use gks_geometry::{Du, Ndc, PathBuf, Paths, Rect};
use glam::DVec2;

/// The colour index of the highlighting colour: orange, unless the program represents it otherwise.
pub const COLOUR: u32 = 15;

/// How far the band reaches beyond a primitive, in nominal linewidths.
const REACH: f64 = 4.0;

/// A pen that draws the band of a line of some width.
pub(crate) fn pen(width: f64, canvas: &Canvas<'_>) -> Pen<'static> {
    let width = width + 2.0 * REACH * canvas.surface.nominal_linewidth();
    Pen { paint: canvas.tables.paint(COLOUR), width, dash: &[], cap: Cap::Round, join: Join::Round }
}

/// Draws the band of an item.
pub(crate) fn draw(
    painter: &mut Painter,
    item: &Item<'_>,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let nominal = canvas.surface.nominal_linewidth();
    match item.shape {
        Shape::Polyline(paths) => {
            let width = lower::line::width(canvas.tables.line(item.look).width, canvas.surface);
            along(painter, paths, false, width, clip, canvas)
        }
        Shape::Polymarker(positions) => markers(painter, positions, item.look, clip, canvas),
        Shape::Text(position, text) => lower::text::draw(painter, position, text, item.look, clip, canvas),
        Shape::FillArea(rings) => along(painter, rings, true, nominal, clip, canvas),
        Shape::CellArray(place, _) => cells(painter, &place, clip, canvas),
        Shape::Generalized(curve, role) => curved(painter, &curve, role, item.look, clip, canvas),
    }
}

/// Draws the band of paths, which are the boundaries of areas if `closed`.
fn along(
    painter: &mut Painter,
    paths: Paths<'_, Ndc>,
    closed: bool,
    width: f64,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let map = canvas.map.0;
    let mut band = PathBuf::<Du>::new();
    for path in paths.iter() {
        let again = path.first().filter(|_| closed);
        band.add(path.iter().chain(again).map(|&p| map.transform_point2(p)));
    }
    let pen = pen(width, canvas);
    painter.lines(band.as_paths(), &pen, clip, canvas)
}

fn markers(
    painter: &mut Painter,
    positions: &[DVec2],
    look: &Look,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let style = lower::marker::style(look, canvas);
    let Pen { width, paint, .. } = pen(style.width, canvas);
    let style = MarkerStyle { width, paint, ..style };
    let window = canvas.clip_map.rect(&canvas.window);
    let map = canvas.map.0;
    let mapped = positions.iter().map(|&p| map.transform_point2(p));
    let inside: Vec<DVec2> = mapped.filter(|&p| clip.contains(gks_geometry::Point::from_vec(p))).collect();
    lower::marker::draw(painter, &inside, &style, &window, canvas)
}

fn cells(
    painter: &mut Painter,
    place: &Parallelogram<Ndc>,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let corners = place.mapped(&canvas.map).corners().map(|corner| corner.0);
    let mut band = PathBuf::<Du>::new();
    band.add(corners.into_iter().chain([corners[0]]));
    let pen = pen(canvas.surface.nominal_linewidth(), canvas);
    painter.lines(band.as_paths(), &pen, clip, canvas)
}

fn curved(
    painter: &mut Painter,
    curve: &Curve<'_, Ndc>,
    role: Role,
    look: &Look,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let mut band = PathBuf::<Du>::new();
    match curve {
        Curve::Ellipse(ellipse) => {
            let mapped = Curve::Ellipse(ellipse.mapped(&canvas.map));
            lower::curve::flattened(&mapped, canvas.tolerance(), &mut band.points);
        }
        Curve::Bezier(points) => {
            let map = canvas.map.0;
            let mapped: Vec<DVec2> = points.iter().map(|&p| map.transform_point2(p)).collect();
            lower::curve::flattened(&Curve::Bezier(&mapped), canvas.tolerance(), &mut band.points);
        }
    }
    if role == Role::Area {
        let first = band.points.first().copied();
        band.points.extend(first);
    }
    band.end();
    let width = match role {
        Role::Line => lower::line::width(canvas.tables.line(look).width, canvas.surface),
        Role::Area => canvas.surface.nominal_linewidth(),
    };
    let pen = pen(width, canvas);
    painter.lines(band.as_paths(), &pen, clip, canvas)
}
