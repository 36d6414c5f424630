//! What items look like on a workstation, kept to be shown over the picture: solid lines and areas of one colour.
//!
//! A [`Trace`] is how the kernel tells a driver what to echo that only the kernel knows: what would be picked, and
//! pictures to choose from. Like an aperture it comes from the ordinary painter, on a device that keeps what is
//! drawn; what the painter clips or takes apart for a device is clipped and taken apart here.

use crate::colour::Paint;
use crate::device::{Device, DeviceError, Drawn, Fill, Form, Mark, Page, Pen, Rule, Surface};
use crate::item::Item;
use crate::look::{Cap, Join};
use crate::workstation::{Place, Workstation};
use gks_geometry::{Du, Paths, Point, Rect};
use glam::DVec2;

/// The most points that are kept: an echo of what is larger shows a part of it.
const MOST_POINTS: usize = 1 << 20;

/// Lines and areas in device units, in the order of drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    points: Vec<DVec2>,
    /// The ends of paths, counted from the first point of their mark.
    ends: Vec<u32>,
    marks: Vec<Kept>,
}

/// A mark, which takes its paths from the arrays in turn.
#[derive(Copy, Clone, Debug, PartialEq)]
struct Kept {
    points: usize,
    paths: usize,
    style: Style,
}

#[derive(Copy, Clone, Debug, PartialEq)]
enum Style {
    Lines { paint: Paint, width: f64, cap: Cap, join: Join },
    Area(Rule, Paint),
}

impl Trace {
    /// What items look like at a place of a workstation, with the band of highlighting below all of them if they
    /// are `highlighted`.
    pub fn of<'i>(
        workstation: &mut Workstation,
        items: impl Iterator<Item = Item<'i>> + Clone,
        place: &Place,
        highlighted: bool,
    ) -> Result<Trace, DeviceError> {
        let surface = workstation.description().surface.clone();
        let mut tracer = Tracer { surface, trace: Trace::default() };
        if highlighted {
            items.clone().try_for_each(|item| workstation.paint_on(&mut tracer, &item, place, true))?;
        }
        let mut items = items;
        items.try_for_each(|item| workstation.paint_on(&mut tracer, &item, place, false))?;
        Ok(tracer.trace)
    }

    /// Whether there is nothing to be seen.
    pub fn is_empty(&self) -> bool {
        self.marks.is_empty()
    }

    /// The smallest rectangle around all points.
    pub fn bounds(&self) -> Option<Rect<Du>> {
        Rect::around(self.points.iter().map(|&p| Point::from_vec(p)))
    }

    /// Draws everything on a device with the same display surface, as far as the device draws lines and areas.
    pub fn draw(&self, device: &mut dyn Device) -> Result<(), DeviceError> {
        let (mut points, mut ends) = (&self.points[..], &self.ends[..]);
        for kept in &self.marks {
            let (own, rest) = points.split_at(kept.points);
            let (parts, others) = ends.split_at(kept.paths);
            (points, ends) = (rest, others);
            let paths = Paths::new(own, parts);
            let form = match kept.style {
                Style::Lines { paint, width, cap, join } => {
                    Form::Lines(paths, Pen { paint, width, dash: &[], cap, join })
                }
                Style::Area(rule, paint) => Form::Area(paths, rule, Fill::Solid(paint)),
            };
            let _: Drawn = device.draw(&Mark { form, clip: None })?;
        }
        Ok(())
    }

    fn add(&mut self, paths: Paths<'_, Du>, style: Style) {
        let (before, first) = (self.points.len(), self.ends.len());
        for path in paths.iter() {
            if self.points.len() + path.len() > MOST_POINTS {
                break;
            }
            self.points.extend(path);
            self.ends.push((self.points.len() - before) as u32);
        }
        let (points, paths) = (self.points.len() - before, self.ends.len() - first);
        if paths > 0 {
            self.marks.push(Kept { points, paths, style });
        }
    }
}

/// The device that keeps what is drawn.
struct Tracer {
    surface: Surface,
    trace: Trace,
}

impl Device for Tracer {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, _page: &Page) -> Result<(), DeviceError> {
        Ok(())
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let style = match (&mark.form, mark.clip) {
            (Form::Lines(_, pen), None) if pen.dash.is_empty() => {
                Style::Lines { paint: pen.paint, width: pen.width, cap: pen.cap, join: pen.join }
            }
            (Form::Area(_, rule, Fill::Solid(paint)), None) => Style::Area(*rule, *paint),
            _ => return Ok(Drawn::No),
        };
        if let Form::Lines(paths, _) | Form::Area(paths, ..) = mark.form {
            self.trace.add(paths, style);
        }
        Ok(Drawn::Yes)
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::Colour;
    use gks_geometry::PathBuf;

    fn tracer() -> Tracer {
        let surface =
            Surface { width: 100.0, height: 100.0, unit: 0.001, y_down: true, resolution: 1.0, pen: None };
        Tracer { surface, trace: Trace::default() }
    }

    fn paths(paths: &[&[(f64, f64)]]) -> PathBuf<Du> {
        let mut buffer = PathBuf::new();
        paths.iter().for_each(|path| buffer.add(path.iter().map(|&p| DVec2::from(p))));
        buffer
    }

    const PAINT: Paint = Paint { colour: Colour::WHITE, index: 0 };

    fn pen(dash: &[f64]) -> Pen<'_> {
        Pen { paint: PAINT, width: 2.0, dash, cap: Cap::Round, join: Join::Round }
    }

    fn draw(tracer: &mut Tracer, form: Form<'_>, clip: Option<Rect<Du>>) -> Drawn {
        tracer.draw(&Mark { form, clip }).unwrap()
    }

    #[test]
    fn what_is_kept_is_drawn_again() {
        let mut tracer = tracer();
        let lines = paths(&[&[(1.0, 2.0), (3.0, 4.0)], &[(5.0, 6.0), (7.0, 8.0), (9.0, 9.0)]]);
        let rings = paths(&[&[(0.0, 0.0), (50.0, 0.0), (0.0, 50.0)]]);
        assert_eq!(draw(&mut tracer, Form::Lines(lines.as_paths(), pen(&[])), None), Drawn::Yes);
        let area = Form::Area(rings.as_paths(), Rule::NonZero, Fill::Solid(PAINT));
        assert_eq!(draw(&mut tracer, area, None), Drawn::Yes);
        let mut again = self::tracer();
        tracer.trace.draw(&mut again).unwrap();
        assert_eq!(again.trace, tracer.trace);
        assert_eq!(again.trace.bounds(), Some(Rect::new(0.0, 50.0, 0.0, 50.0)));
        assert!(!again.trace.is_empty() && Trace::default().is_empty());
    }

    #[test]
    fn what_comes_back_simpler_is_refused() {
        let mut tracer = tracer();
        let lines = paths(&[&[(1.0, 2.0), (3.0, 4.0)]]);
        let clip = Some(Rect::new(0.0, 2.0, 0.0, 2.0));
        assert_eq!(draw(&mut tracer, Form::Lines(lines.as_paths(), pen(&[])), clip), Drawn::No);
        assert_eq!(draw(&mut tracer, Form::Lines(lines.as_paths(), pen(&[1.0, 1.0])), None), Drawn::No);
        assert!(tracer.trace.is_empty());
    }

    #[test]
    fn no_more_points_are_kept_than_an_echo_needs() {
        let mut tracer = tracer();
        let long: Vec<(f64, f64)> = (0..MOST_POINTS / 2 + 1).map(|i| (i as f64, 0.0)).collect();
        let lines = paths(&[&long, &long]);
        assert_eq!(draw(&mut tracer, Form::Lines(lines.as_paths(), pen(&[])), None), Drawn::Yes);
        assert_eq!(tracer.trace.points.len(), long.len());
        tracer.trace.draw(&mut self::tracer()).unwrap();
    }
}
