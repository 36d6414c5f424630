//! Clipping at a sector of an ellipse, which few drivers know: a device in front of the device that cuts.
//!
//! The ordinary painter paints on a `Within`. It takes solid lines and areas of one colour, cuts them and hands them on;
//! what else crosses the boundary it refuses unless the device can clip it, so that it comes back as lines and areas.

use crate::device::{Device, DeviceError, Drawn, Fill, Form, Mark, Page, Surface};
use crate::item::{Closure, Ellipse, Item, Shape};
use crate::look::{ClipSector, Look};
use crate::painter::{Canvas, Painter};
use gks_algorithms::clip::EllipticSector;
use gks_geometry::{Du, Map, Ndc, PathBuf, Rect, Vector};
use glam::DVec2;

/// Paints an item inside of a sector of the ellipse in its clipping rectangle.
pub(crate) fn paint(
    painter: &mut Painter,
    item: &Item<'_>,
    sector: ClipSector,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let region = mapped(sector, &item.clip, &canvas.clip_map);
    let Some(sector) = sector_of(&region) else { return Ok(()) };
    let look = &Look { clip_sector: None, ..item.look.clone() };
    // Markers are drawn whole where their position is inside, as with a rectangle.
    if let Shape::Polymarker(positions) = item.shape {
        let inside = |p: &DVec2| sector.contains(canvas.map.0.transform_point2(*p));
        let positions: Vec<DVec2> = positions.iter().copied().filter(inside).collect();
        return painter.paint(&Item { shape: Shape::Polymarker(&positions), look, ..*item }, canvas);
    }
    let parts = sector.convex_parts(canvas.tolerance());
    let device = &mut *canvas.device;
    let mut within = Within { device, region, sector, parts, cut: PathBuf::new(), scratch: Vec::new() };
    painter.paint(&Item { look, ..item.clone() }, &mut Canvas { device: &mut within, ..*canvas })
}

/// The sector in device units.
fn mapped(sector: ClipSector, rectangle: &Rect<Ndc>, map: &Map<Ndc, Du>) -> Ellipse<Du> {
    let half = (rectangle.max - rectangle.min) * 0.5;
    let turn = (sector.end - sector.start).abs() >= 360.0;
    let sweep = if turn { 360.0 } else { (sector.end - sector.start).rem_euclid(360.0) };
    Ellipse {
        centre: map.point(rectangle.min + half),
        a: map.vector(Vector::new(half.0.x, 0.0)),
        b: map.vector(Vector::new(0.0, half.0.y)),
        start: sector.start.to_radians(),
        sweep: sweep.to_radians(),
        closure: if turn { Closure::Full } else { Closure::Pie },
    }
}

/// The same for cutting; none where it has no area.
fn sector_of(region: &Ellipse<Du>) -> Option<EllipticSector> {
    let Ellipse { centre, a, b, start, sweep, .. } = *region;
    EllipticSector::new(centre.0, a.0, b.0, start, sweep)
}

/// A device that shows what lies inside of a sector.
struct Within<'a> {
    device: &'a mut dyn Device,
    region: Ellipse<Du>,
    sector: EllipticSector,
    /// Its boundary as convex polygons.
    parts: Vec<Vec<DVec2>>,
    cut: PathBuf<Du>,
    scratch: Vec<DVec2>,
}

/// Hands on what has been cut, if anything is left of it.
fn hand_on(device: &mut dyn Device, form: Form<'_>, left: bool) -> Result<Drawn, DeviceError> {
    if left { device.draw(&Mark { form, clip: None }) } else { Ok(Drawn::Yes) }
}

impl Device for Within<'_> {
    fn surface(&self) -> &Surface {
        self.device.surface()
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.device.begin(page)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let Within { device, region, sector, parts, cut, scratch } = self;
        cut.clear();
        match (&mark.form, mark.clip) {
            // As with a rectangle, the width of lines is not cut.
            (Form::Lines(paths, pen), None) if pen.dash.is_empty() => {
                for path in paths.iter() {
                    sector.polyline(path, &mut cut.points, &mut cut.ends);
                }
                hand_on(*device, Form::Lines(cut.as_paths(), *pen), !cut.ends.is_empty())
            }
            (Form::Area(rings, rule, Fill::Solid(paint)), None) => {
                if device.draw_within(mark, region)? == Drawn::Yes {
                    return Ok(Drawn::Yes);
                }
                for ring in rings.iter() {
                    sector.ring(parts, ring, scratch, &mut cut.points, &mut cut.ends);
                }
                let form = Form::Area(cut.as_paths(), *rule, Fill::Solid(*paint));
                hand_on(*device, form, !cut.ends.is_empty())
            }
            (Form::Cells(place, _) | Form::IndexedCells(place, ..), _)
                if sector.contains_all(&place.corners().map(|corner| corner.0)) =>
            {
                device.draw(mark)
            }
            _ => device.draw_within(mark, region),
        }
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.device.end()
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        self.device.close()
    }
}
