//! Hatches: fill areas with interior style HATCH, and solid areas on devices that draw with a pen.

use crate::colour::Paint;
use crate::device::{DeviceError, Pen, Rule, Surface};
use crate::generated::numbers;
use crate::look::{Cap, Join};
use crate::painter::{Canvas, Painter, plain_pen};
use gks_algorithms::fill::HatchLines;
use gks_algorithms::path;
use gks_geometry::{Du, Paths, Point, Rect};
use glam::DVec2;

/// The most lines of one direction that an area gets; a finer hatch is thinned out.
const MOST_LINES: u32 = 100_000;

/// The width of an area, as a part of the resolution, up to which it is nothing but a rounding error.
const SLIVER: f64 = 1e-3;

/// The hatch style of a style index, or hatch style -1 where there is no such style.
pub(crate) fn style(index: i32) -> Option<&'static numbers::Hatch> {
    let find = |n: i32| numbers::HATCHES.iter().find(|s| s.number == n);
    find(index).or_else(|| find(-1))
}

/// Hatches an area; the lines of neighbouring areas of the same style continue one another.
pub(crate) fn draw(
    painter: &mut Painter,
    rings: Paths<'_, Du>,
    style: &numbers::Hatch,
    paint: Paint,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let surface = canvas.surface;
    let nominal = numbers::NOMINAL_HATCH_SPACING * canvas.tables.nominal.hatch_spacing;
    let spacing = surface.width.min(surface.height) * nominal * style.spacing;
    // The lines start from the lower left corner of the surface, so that every device hatches alike; the first
    // is half a spacing away from it. Edges tend to lie at round numbers, and whether a line along an edge is
    // seen depends on rounding.
    let corner = lower_left(surface);
    let pen = plain_pen(paint, canvas);
    let mut lines = std::mem::take(&mut painter.lowered);
    lines.clear();
    for &angle in style.angles {
        let angle = if surface.y_down { -angle } else { angle }.to_radians();
        let origin = corner + DVec2::from_angle(angle).perp() * (spacing * 0.5);
        let family = HatchLines { angle, spacing, origin, limit: MOST_LINES };
        let rect = (clip.min.0, clip.max.0);
        let (points, ends) = (rings.points, rings.ends);
        painter.hatch.segments(points, ends, path::Rule::EvenOdd, &family, rect, |a, b| lines.add([a, b]));
    }
    let done = painter.lines(lines.as_paths(), &pen, clip, canvas);
    painter.lowered = lines;
    done
}

/// Fills an area with lines a pen width apart, and draws its boundary.
pub(crate) fn solid(
    painter: &mut Painter,
    rings: Paths<'_, Du>,
    rule: Rule,
    paint: Paint,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    shade(painter, rings, rule, paint, clip, canvas, true)
}

/// Fills an area with lines a pen width apart, without its boundary: for areas cut out of others, whose
/// rings may run along one another where there is nothing between them.
pub(crate) fn interior(
    painter: &mut Painter,
    rings: Paths<'_, Du>,
    paint: Paint,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    shade(painter, rings, Rule::EvenOdd, paint, clip, canvas, false)
}

/// The lower left corner of a surface.
fn lower_left(surface: &Surface) -> DVec2 {
    DVec2::new(0.0, if surface.y_down { surface.height } else { 0.0 })
}

fn shade(
    painter: &mut Painter,
    rings: Paths<'_, Du>,
    rule: Rule,
    paint: Paint,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
    boundary: bool,
) -> Result<(), DeviceError> {
    let width = canvas.surface.pen.unwrap_or(canvas.surface.resolution);
    let pen = Pen { paint, width, dash: &[], cap: Cap::Round, join: Join::Round };
    let mut lines = std::mem::take(&mut painter.lowered);
    lines.clear();
    // Cells cut at an edge where they should end leave slivers as wide as rounding errors.
    let least = canvas.surface.resolution * SLIVER;
    for ring in rings.iter().filter(|_| boundary) {
        let bounds = Rect::around(ring.iter().map(|&p| Point::<Du>::from_vec(p)));
        if bounds.is_some_and(|bounds| bounds.width() > least && bounds.height() > least) {
            lines.add(ring.iter().copied().chain(ring.first().copied()));
        }
    }
    let family =
        HatchLines { angle: 0.0, spacing: width, origin: lower_left(canvas.surface), limit: MOST_LINES };
    let rect = (clip.min.0, clip.max.0);
    let rule = match rule {
        Rule::EvenOdd => path::Rule::EvenOdd,
        Rule::NonZero => path::Rule::NonZero,
    };
    let (points, ends) = (rings.points, rings.ends);
    painter.hatch.segments(points, ends, rule, &family, rect, |a, b| {
        if a.distance(b) > least {
            lines.add([a, b]);
        }
    });
    let done = painter.lines(lines.as_paths(), &pen, clip, canvas);
    painter.lowered = lines;
    done
}
