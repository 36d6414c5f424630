//! Markers: their shapes, and lines or areas for devices without markers.

use crate::device::{DeviceError, MarkerStyle, Pen, Rule, Surface};
use crate::look::{Cap, Join, Look};
use crate::painter::{Canvas, Painter};
use gks_geometry::{Du, PathBuf, Rect};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The largest marker size, as a multiple of the nominal one.
pub const MAX_SIZE: f64 = 200.0;

/// The least and the greatest marker size on a surface, as multiples of the nominal one; a factor beyond is
/// drawn as the nearer of the two.
pub fn range(surface: &Surface) -> (f64, f64) {
    let least = surface.resolution / surface.nominal_marker_size();
    (least.min(MAX_SIZE), MAX_SIZE)
}

/// The marker that the polymarker attributes of `look` mean on this workstation.
pub(crate) fn style(look: &Look, canvas: &Canvas<'_>) -> MarkerStyle {
    let bundle = canvas.tables.marker(look);
    let (least, greatest) = range(canvas.surface);
    let factor = if bundle.size.is_finite() { bundle.size.clamp(least, greatest) } else { 1.0 };
    let width = canvas.surface.nominal_linewidth();
    let size = match bundle.kind {
        1 => width,
        _ => factor * canvas.tables.nominal.marker_size * canvas.surface.nominal_marker_size(),
    };
    let paint = canvas.tables.translucent(bundle.colour, canvas.tables.opacity.markers);
    MarkerStyle { kind: bundle.kind, size, width, paint }
}

/// The shape of a marker of size 1 around the origin, y up.
#[derive(Clone, Debug, PartialEq)]
pub enum MarkerShape {
    /// A dot of one linewidth.
    Dot,
    /// Lines.
    Lines(Vec<Vec<DVec2>>),
    /// A circle of diameter 1.
    Circle,
    /// A filled circle of diameter 1.
    Disc,
    /// A filled polygon.
    Area(Vec<DVec2>),
}

/// The shape of a marker type; a type without a shape is drawn as an asterisk.
pub fn shape(kind: i32) -> MarkerShape {
    let line = |x0, y0, x1, y1| vec![DVec2::new(x0, y0), DVec2::new(x1, y1)];
    let closed = |mut ring: Vec<DVec2>| {
        ring.push(ring[0]);
        MarkerShape::Lines(vec![ring])
    };
    // A half unit of size for the standard's shapes, so that all are equally large.
    let d = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
    let regular = |n: u32, turn: f64| -> Vec<DVec2> {
        (0..n).map(|i| DVec2::from_angle(turn + TAU * f64::from(i) / f64::from(n)) * 0.5).collect()
    };
    let square = || vec![DVec2::new(-d, -d), DVec2::new(d, -d), DVec2::new(d, d), DVec2::new(-d, d)];
    let star = || -> Vec<DVec2> {
        let radius = |i: u32| if i.is_multiple_of(2) { 0.5 } else { 0.191 };
        (0..10).map(|i| DVec2::from_angle(FRAC_PI_2 + TAU * f64::from(i) / 10.0) * radius(i)).collect()
    };
    match kind {
        1 => MarkerShape::Dot,
        2 => MarkerShape::Lines(vec![line(-0.5, 0.0, 0.5, 0.0), line(0.0, -0.5, 0.0, 0.5)]),
        4 => MarkerShape::Circle,
        5 => MarkerShape::Lines(vec![line(-d, -d, d, d), line(-d, d, d, -d)]),
        -1 => closed(square()),
        -2 => MarkerShape::Area(square()),
        -3 => closed(regular(3, FRAC_PI_2)),
        -4 => MarkerShape::Area(regular(3, FRAC_PI_2)),
        -5 => closed(regular(3, -FRAC_PI_2)),
        -6 => MarkerShape::Area(regular(3, -FRAC_PI_2)),
        -7 => closed(regular(4, 0.0)),
        -8 => MarkerShape::Area(regular(4, 0.0)),
        -9 => MarkerShape::Disc,
        -10 => closed(star()),
        -11 => MarkerShape::Area(star()),
        -12 => closed(regular(6, 0.0)),
        _ => MarkerShape::Lines(vec![
            line(-0.5, 0.0, 0.5, 0.0),
            line(0.0, -0.5, 0.0, 0.5),
            line(-d, -d, d, d),
            line(-d, d, d, -d),
        ]),
    }
}

/// How many points are collected before they are drawn, so that memory does not grow with the number of
/// markers.
const CHUNK: usize = 1 << 16;

/// The path, closed if it is the boundary of an area.
fn closed(mut path: Vec<DVec2>) -> Vec<DVec2> {
    if path.len() > 2 {
        path.extend(path.first().copied());
    }
    path
}

/// Draws markers as lines or areas.
pub(crate) fn draw(
    painter: &mut Painter,
    positions: &[DVec2],
    style: &MarkerStyle,
    window: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let scale = DVec2::new(style.size, if canvas.surface.y_down { -style.size } else { style.size });
    let circle = || {
        let mut ring = Vec::new();
        let r = style.size * 0.5;
        let (a, b) = (DVec2::new(r, 0.0), DVec2::new(0.0, r));
        gks_algorithms::ellipse::flatten(DVec2::ZERO, a, b, 0.0, TAU, canvas.tolerance(), &mut ring);
        ring
    };
    let scaled = |path: &Vec<DVec2>| path.iter().map(|&p| p * scale).collect::<Vec<_>>();
    let (paths, filled): (Vec<Vec<DVec2>>, bool) = match shape(style.kind) {
        MarkerShape::Dot => (vec![vec![DVec2::ZERO]], false),
        MarkerShape::Lines(paths) => (paths.iter().map(scaled).collect(), false),
        MarkerShape::Circle => (vec![circle()], false),
        MarkerShape::Disc => (vec![circle()], true),
        MarkerShape::Area(ring) => (vec![scaled(&ring)], true),
    };
    // The band of highlighting runs along the boundary.
    let (paths, filled) = match canvas.glow {
        true => (paths.into_iter().map(closed).collect(), false),
        false => (paths, filled),
    };
    let pen = Pen { paint: style.paint, width: style.width, dash: &[], cap: Cap::Round, join: Join::Round };
    let mut out = PathBuf::new();
    let mut flush = |out: &mut PathBuf<Du>, canvas: &mut Canvas<'_>| {
        let done = if filled {
            painter.solid(out.as_paths(), Rule::NonZero, style.paint, window, canvas)
        } else {
            painter.lines(out.as_paths(), &pen, window, canvas)
        };
        out.clear();
        done
    };
    // Translucent markers that overlap show both, as where a device draws them one by one.
    let chunk = if style.paint.colour.alpha < 1.0 { 1 } else { CHUNK };
    for &position in positions {
        for path in &paths {
            out.add(path.iter().map(|&p| p + position));
        }
        if out.points.len() >= chunk {
            flush(&mut out, canvas)?;
        }
    }
    flush(&mut out, canvas)
}
