//! From measures, which are about the display surface, to logical input values, and back.

use super::device::Device;
use super::value::{InputValue, LocatorValue, PickValue, StrokeValue};
use crate::gks::OpenWorkstation;
use crate::normalization::Normalization;
use gks_geometry::{Dc, Map, Ndc, Point, Rect, Wc};
use gks_pipeline::input::{Detail, Measure, Setting};
use gks_pipeline::workstation::Workstation;

impl Normalization {
    /// The number of the transformation by which positions are returned, and its map: among those whose
    /// viewport contains all the positions the one with the highest viewport input priority.
    pub(super) fn containing(&self, positions: &[Point<Ndc>]) -> (i32, Map<Ndc, Wc>) {
        let contains = |viewport: &Rect<Ndc>| positions.iter().all(|&p| viewport.contains(p));
        let found = self.priority.iter().find_map(|&number| {
            let transformation = self.transformations.get(usize::try_from(number).ok()?)?;
            let map = Map::window_to_viewport(&transformation.viewport, &transformation.window);
            contains(&transformation.viewport).then_some((number, map))
        });
        // Transformation 0 contains the whole unit square.
        found.unwrap_or((0, Map::IDENTITY))
    }

    /// The map of a transformation to NDC; the identity for a number that there is not.
    pub(super) fn to_ndc(&self, number: i32) -> Map<Wc, Ndc> {
        let transformation = usize::try_from(number).ok().and_then(|n| self.transformations.get(n));
        transformation.map_or(Map::IDENTITY, |t| Map::window_to_viewport(&t.window, &t.viewport))
    }
}

/// The part of the display surface that positions are inside of: that which shows the workstation window.
fn within(workstation: &Workstation) -> Rect<Dc> {
    workstation.device_map().rect(&workstation.current().window)
}

/// The point of a rectangle that is nearest to a point.
fn nearest<S: gks_geometry::Space>(rect: &Rect<S>, p: Point<S>) -> Point<S> {
    let [xmin, xmax, ymin, ymax] = rect.limits();
    // `max` before `min`: what is no number becomes a limit.
    Point::new(p.x().max(xmin).min(xmax), p.y().max(ymin).min(ymax))
}

/// What a driver is told about a device when an interaction starts.
pub(super) fn setting(
    normalization: &Normalization,
    workstation: &mut Workstation,
    device: &Device,
) -> Setting {
    let within = within(workstation);
    let place = |number: i32, p: Point<Wc>| {
        let map = normalization.to_ndc(number).then(&workstation.device_map());
        nearest(&within, map.point(p))
    };
    let initial = match &device.initial {
        InputValue::Locator(value) => Measure::Locator(place(value.transformation, value.position)),
        InputValue::Stroke(value) => {
            Measure::Stroke(value.points.iter().map(|&p| place(value.transformation, p)).collect())
        }
        InputValue::Valuator(value) => Measure::Valuator(*value),
        InputValue::Choice(value) => Measure::Choice(*value),
        // What is picked has no position.
        InputValue::Pick(_) => Measure::Pick(None),
        InputValue::String(value) => Measure::String(value.clone()),
    };
    let menu = device.menu.as_ref();
    Setting {
        echo: device.echo,
        prompt: device.prompt,
        area: device.area,
        within,
        initial,
        detail: device.detail.clone(),
        picture: menu.map(|menu| menu.trace(workstation, &device.area, None)),
    }
}

/// The logical input value of a measure of a device; none if the measure is not one of its class.
///
/// What lies outside of the limits of the device is brought inside: positions outside of the workstation window
/// cannot be returned, nor more points or characters than the buffers hold.
pub(super) fn value(
    normalization: &Normalization,
    open: &mut OpenWorkstation,
    pick: impl FnOnce(&mut Workstation, Point<Dc>, f64) -> Option<PickValue>,
    detail: &Detail,
    measure: Measure,
) -> Option<InputValue> {
    let positions = |points: &[Point<Dc>]| -> (i32, Vec<Point<Wc>>) {
        let workstation = &open.workstation;
        let Some(back) = workstation.device_map().inverse() else { return (0, Vec::new()) };
        let window = workstation.current().window;
        let points: Vec<Point<Ndc>> = points.iter().map(|&p| nearest(&window, back.point(p))).collect();
        let (number, map) = normalization.containing(&points);
        (number, points.into_iter().map(|p| map.point(p)).collect())
    };
    Some(match (measure, detail) {
        (Measure::Locator(point), Detail::Locator) => {
            let (transformation, points) = positions(&[point]);
            InputValue::Locator(LocatorValue { transformation, position: *points.first()? })
        }
        (Measure::Stroke(mut points), Detail::Stroke { buffer, .. }) => {
            points.truncate(*buffer);
            let (transformation, points) = positions(&points);
            InputValue::Stroke(StrokeValue { transformation, points })
        }
        (Measure::Valuator(number), Detail::Valuator { low, high }) => {
            InputValue::Valuator(number.max(*low).min(*high))
        }
        (Measure::Choice(number), Detail::Choice { alternatives, .. }) => {
            InputValue::Choice(number.filter(|number| (1..=*alternatives).contains(number)))
        }
        (Measure::Pick(position), Detail::Pick { aperture }) => {
            let inside = within(&open.workstation);
            let position = position.map(|p| nearest(&inside, p));
            InputValue::Pick(position.and_then(|p| pick(&mut open.workstation, p, *aperture)))
        }
        (Measure::String(text), Detail::String { buffer, .. }) => {
            InputValue::String(text.chars().take(*buffer).collect())
        }
        _ => return None,
    })
}
