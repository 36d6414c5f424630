//! Finding what is drawn at a position: picking.
//!
//! There is no second renderer. An [`Aperture`] is a device that draws nothing: the ordinary painter paints items
//! on it, and it notes whether any mark meets a small square. What the painter clips away or does not draw is not
//! found, and what it takes apart is found by its parts.

use crate::device::{Device, DeviceError, Drawn, Fill, Form, Mark, Page, Rule, Surface};
use crate::item::{Item, Parallelogram, Shape};
use crate::workstation::{Place, Workstation};
use gks_algorithms::clip::liang_barsky;
use gks_geometry::{Dc, Du, PathBuf, Paths, Point, Rect};
use glam::DVec2;

/// A square on the display surface in which primitives are looked for.
pub struct Aperture {
    surface: Surface,
    square: Rect<Du>,
    /// Whether the bounds of paths count instead of the paths: a character is hit beside its strokes, too.
    by_bounds: bool,
    hit: bool,
}

impl Aperture {
    /// The square around a position in metres whose sides are `half` metres away from it.
    pub fn new(surface: &Surface, at: Point<Dc>, half: f64) -> Aperture {
        let up = at.y() / surface.unit;
        let y = if surface.y_down { surface.height - up } else { up };
        let centre = Rect::around([Point::new(at.x() / surface.unit, y)]).unwrap_or(surface.extent());
        let square = centre.grown(half / surface.unit);
        Aperture { surface: surface.clone(), square, by_bounds: false, hit: false }
    }

    /// Whether an item that a workstation would draw now at a place meets the square. Nothing is drawn.
    pub fn meets(
        &mut self,
        workstation: &mut Workstation,
        item: &Item<'_>,
        place: &Place,
    ) -> Result<bool, DeviceError> {
        self.hit = false;
        self.by_bounds = matches!(item.shape, Shape::Text(..));
        workstation.paint_on(self, item, place, false)?;
        Ok(self.hit)
    }

    fn lines(&self, square: &Rect<Du>, paths: Paths<'_, Du>, width: f64) -> bool {
        let square = square.grown(width * 0.5);
        paths
            .iter()
            .any(|path| if self.by_bounds { bounds_meet(&square, path) } else { meets(&square, path) })
    }

    fn area(&self, square: &Rect<Du>, rings: Paths<'_, Du>, rule: Rule) -> bool {
        if self.by_bounds {
            return self.lines(square, rings, 0.0);
        }
        let closed = |ring: &[DVec2]| {
            let edge = ring.first().zip(ring.last());
            meets(square, ring) || edge.is_some_and(|(&first, &last)| crosses(square, last, first))
        };
        if rings.iter().any(closed) {
            return true;
        }
        // No boundary passes through the square, so that all of it is inside or outside.
        let centre = square.centre().0;
        let turns: i32 = rings.iter().map(|ring| winding(ring, centre)).sum();
        match rule {
            Rule::EvenOdd => turns % 2 != 0,
            Rule::NonZero => turns != 0,
        }
    }
}

/// Whether the box around a path meets a square.
fn bounds_meet(square: &Rect<Du>, path: &[DVec2]) -> bool {
    Rect::around(path.iter().map(|&p| Point::from_vec(p))).is_some_and(|bounds| bounds.meets(square))
}

/// Whether a path passes through a square; a path of one point is a dot.
fn meets(square: &Rect<Du>, path: &[DVec2]) -> bool {
    match path {
        [dot] => square.contains(Point::from_vec(*dot)),
        _ => path.windows(2).any(|ends| crosses(square, ends[0], ends[1])),
    }
}

/// Whether a line passes through a square.
fn crosses(square: &Rect<Du>, from: DVec2, to: DVec2) -> bool {
    liang_barsky((square.min.0, square.max.0), from, to).is_some()
}

/// How often a ring turns around a point, by the edges that a ray to the right crosses (Sunday 2001).
fn winding(ring: &[DVec2], p: DVec2) -> i32 {
    let mut turns = 0;
    let mut a = ring.last().copied().unwrap_or(p);
    for &b in ring {
        let side = (b - a).perp_dot(p - a);
        if a.y <= p.y && b.y > p.y && side > 0.0 {
            turns += 1;
        } else if a.y > p.y && b.y <= p.y && side < 0.0 {
            turns -= 1;
        }
        a = b;
    }
    turns
}

impl Device for Aperture {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, _page: &Page) -> Result<(), DeviceError> {
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        if self.hit {
            return Ok(Drawn::Yes);
        }
        let square = match &mark.clip {
            None => self.square,
            Some(clip) => match self.square.intersection(clip) {
                Some(square) => square,
                None => return Ok(Drawn::Yes),
            },
        };
        self.hit = match &mark.form {
            Form::Lines(paths, pen) => self.lines(&square, *paths, pen.width),
            Form::Area(rings, rule, Fill::Solid(_) | Fill::Pattern(..)) => self.area(&square, *rings, *rule),
            Form::Markers(positions, style) => {
                let near = square.grown(style.size * 0.5);
                positions.iter().any(|&p| near.contains(Point::from_vec(p)))
            }
            Form::Cells(place, _) => self.area(&square, outline(place).as_paths(), Rule::EvenOdd),
            // Characters and curves come again as outlines and polygons.
            Form::LongLine(..)
            | Form::Text(_)
            | Form::StrokeText(_)
            | Form::IndexedCells(..)
            | Form::Stroke(..)
            | Form::Filled(..) => return Ok(Drawn::No),
        };
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}

/// The boundary of a parallelogram.
fn outline(place: &Parallelogram<Du>) -> PathBuf<Du> {
    let mut path = PathBuf::new();
    path.add(place.corners().map(|corner| corner.0));
    path
}
