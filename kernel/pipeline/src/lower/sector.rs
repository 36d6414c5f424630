//! Clipping at a sector of an ellipse, which no driver knows: a device in front of the device that cuts.
//!
//! The ordinary painter paints on a [`Within`]. It takes solid lines and areas of one colour, cuts them and hands them on;
//! what else crosses the boundary it refuses, so that it comes back as lines and areas.

use crate::device::{Device, DeviceError, Drawn, Fill, Form, Mark, Page, Surface};
use crate::item::{Item, Shape};
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
    let Some(sector) = mapped(sector, &item.clip, &canvas.clip_map) else { return Ok(()) };
    let look = &Look { clip_sector: None, ..item.look.clone() };
    // Markers are drawn whole where their position is inside, as with a rectangle.
    if let Shape::Polymarker(positions) = item.shape {
        let inside = |p: &DVec2| sector.contains(canvas.map.0.transform_point2(*p));
        let positions: Vec<DVec2> = positions.iter().copied().filter(inside).collect();
        return painter.paint(&Item { shape: Shape::Polymarker(&positions), look, ..*item }, canvas);
    }
    let parts = sector.convex_parts(canvas.tolerance());
    let device = &mut *canvas.device;
    let mut within = Within { device, sector, parts, cut: PathBuf::new(), scratch: Vec::new() };
    painter.paint(&Item { look, ..item.clone() }, &mut Canvas { device: &mut within, ..*canvas })
}

/// The sector in device units; none where it has no area.
fn mapped(sector: ClipSector, rectangle: &Rect<Ndc>, map: &Map<Ndc, Du>) -> Option<EllipticSector> {
    let half = (rectangle.max - rectangle.min) * 0.5;
    let centre = map.point(rectangle.min + half);
    let (a, b) = (map.vector(Vector::new(half.0.x, 0.0)), map.vector(Vector::new(0.0, half.0.y)));
    EllipticSector::new(centre.0, a.0, b.0, sector.start.to_radians(), sector.end.to_radians())
}

/// A device that shows what lies inside of a sector.
struct Within<'a> {
    device: &'a mut dyn Device,
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
        let Within { device, sector, parts, cut, scratch } = self;
        cut.clear();
        match (&mark.form, mark.clip) {
            (Form::Lines(paths, pen), None) if pen.dash.is_empty() => {
                for path in paths.iter() {
                    sector.polyline(path, &mut cut.points, &mut cut.ends);
                }
                hand_on(*device, Form::Lines(cut.as_paths(), *pen), !cut.ends.is_empty())
            }
            (Form::Area(rings, rule, Fill::Solid(paint)), None) => {
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
            _ => Ok(Drawn::No),
        }
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.device.end()
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        self.device.close()
    }
}
