//! Workstation transformations: which part of NDC space a workstation shows, and where.

use crate::gks::device_error;
use crate::{Error, Function, Gks, Result};
use gks_geometry::{Dc, Ndc, Rect};
use gks_pipeline::description::Description;

/// Limits of a workstation viewport closer than this to an edge of the display surface, in units of its
/// width or height, are on the edge: callers in single precision cannot name it exactly.
const EDGE: f64 = 1e-6;

impl Gks {
    /// SET WORKSTATION WINDOW: the part of NDC space that a workstation shows.
    ///
    /// Takes effect when the display surface is empty, at the next new frame otherwise. Errors: 7, 20, 25,
    /// 33, 36, 51 (limits), 53 (not in the unit square), 303.
    pub fn set_workstation_window(&mut self, id: i32, window: impl Into<Rect<Ndc>>) -> Result<()> {
        const F: Function = Function::SetWorkstationWindow;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let window: Rect<Ndc> = window.into();
        if !window.is_proper() {
            return Err(Error::new(51, F).because(format!("limits {:?}", window.limits())));
        }
        if !Rect::UNIT.contains_rect(&window) {
            return Err(Error::new(53, F).because(format!("limits {:?}", window.limits())));
        }
        let set = workstation.set_window(window).map_err(|e| device_error(F, &e));
        self.settle(F, id).and(set)
    }

    /// SET WORKSTATION VIEWPORT: the part of the display surface, in metres from its lower left corner, that
    /// shows the workstation window.
    ///
    /// The window keeps its shape: where the shapes differ, room is left at the right or at the top. Takes
    /// effect as SET WORKSTATION WINDOW does. Errors: 7, 20, 25, 33, 36, 51 (limits), 54 (not on the display
    /// surface), 303.
    pub fn set_workstation_viewport(&mut self, id: i32, viewport: impl Into<Rect<Dc>>) -> Result<()> {
        const F: Function = Function::SetWorkstationViewport;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let (width, height) = workstation.description().size();
        let given: Rect<Dc> = viewport.into();
        let viewport = on_display(given, workstation.description());
        if !viewport.is_proper() {
            return Err(Error::new(51, F).because(format!("limits {:?}", given.limits())));
        }
        if !Rect::new(0.0, width, 0.0, height).contains_rect(&viewport) {
            return Err(Error::new(54, F).because(format!("limits {:?}", given.limits())));
        }
        let set = workstation.set_viewport(viewport).map_err(|e| device_error(F, &e));
        self.settle(F, id).and(set)
    }
}

/// A rectangle on the display surface, its limits put on the edges that they are very close to.
pub(crate) fn on_display(rect: Rect<Dc>, description: &Description) -> Rect<Dc> {
    let (width, height) = description.size();
    let [xmin, xmax, ymin, ymax] = rect.limits();
    let (x, y) = (|x| on_edge(x, width), |y| on_edge(y, height));
    Rect::new(x(xmin), x(xmax), y(ymin), y(ymax))
}

/// The limit `at`, put on the edge 0 or `size` if it is that close.
fn on_edge(at: f64, size: f64) -> f64 {
    [0.0, size].into_iter().find(|edge| (at - edge).abs() <= size * EDGE).unwrap_or(at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{CATEGORIES, Drawing, INDEXED, PLAIN, active, closed, number, open};
    use gks_pipeline::description::{Category, DeferralMode, RegenerationMode};
    use glam::dvec2;

    const DIAGONAL: [(f64, f64); 2] = [(0.0, 0.0), (1.0, 1.0)];

    fn line(drawing: &Drawing) -> &[glam::DVec2] {
        let Drawing::Lines(paths, _) = drawing else { panic!("not a line: {drawing:?}") };
        &paths[0]
    }

    #[test]
    fn states_identifiers_and_categories_are_checked_in_this_order() {
        let bad = (1.0, 0.0, 0.0, f64::NAN);
        assert_eq!(number(closed().set_workstation_window(-1, bad)), 7);
        assert_eq!(number(open(&[]).0.set_workstation_viewport(-1, bad)), 7);
        let kinds = [Category::MetafileInput, Category::Wiss, Category::Input];
        let (mut gks, _) = open(&kinds.map(|category| CATEGORIES + category as i32));
        for (id, error) in [(-1, 20), (9, 25), (1, 33), (2, 36), (3, 51)] {
            assert_eq!(number(gks.set_workstation_window(id, bad)), error);
            assert_eq!(number(gks.set_workstation_viewport(id, bad)), error);
        }
    }

    #[test]
    fn limits_are_checked() {
        let (mut gks, _) = open(&[PLAIN]);
        for flat in [(0.5, 0.5, 0.0, 1.0), (0.0, 1.0, 0.2, 0.1), (0.0, 1e-9, 0.0, 0.1)] {
            assert_eq!(number(gks.set_workstation_viewport(1, flat)), 51);
        }
        assert_eq!(number(gks.set_workstation_window(1, (0.0, 1.0, 0.2, 0.2))), 51);
        for outside in [(0.0, 1.5, 0.0, 1.0), (-0.5, 1.0, 0.0, 1.0), (0.0, 1.0, 0.0, 1.0001)] {
            assert_eq!(number(gks.set_workstation_window(1, outside)), 53);
        }
        for outside in [(0.0, 0.4, 0.0, 0.2), (-0.2, 0.2, 0.0, 0.2), (0.0, 0.2, 0.0, 0.2001)] {
            assert_eq!(number(gks.set_workstation_viewport(1, outside)), 54);
        }
    }

    #[test]
    fn single_precision_names_the_edge() {
        let (mut gks, _) = open(&[PLAIN]);
        let (below, above) = (0.199_999_99_f32, 0.2_f32);
        assert!(f64::from(above) > 0.2);
        gks.set_workstation_viewport(1, (-1e-9, above.into(), 1e-9, below.into())).unwrap();
        assert_eq!(gks.workstations[&1].workstation.current().viewport, Rect::new(0.0, 0.2, 0.0, 0.2));
    }

    #[test]
    fn the_window_keeps_its_shape_in_the_lower_left_of_the_viewport() {
        let (mut gks, log) = active(&[PLAIN, INDEXED]);
        gks.set_workstation_window(1, (0.0, 1.0, 0.0, 0.5)).unwrap();
        gks.set_workstation_viewport(1, (0.1, 0.2, 0.1, 0.2)).unwrap();
        gks.polyline(&[(0.0, 0.0), (1.0, 0.5)]).unwrap();
        let marks = log.marks();
        assert!(line(&marks[0].0)[0].distance(dvec2(500.0, 500.0)) < 1e-9);
        assert!(line(&marks[0].0)[1].distance(dvec2(1000.0, 750.0)) < 1e-9);
        // The whole square on a wide surface whose ordinates point down.
        assert!(line(&marks[1].0)[0].distance(dvec2(0.0, 500.0)) < 1e-9);
        assert!(line(&marks[1].0)[1].distance(dvec2(500.0, 250.0)) < 1e-9);
    }

    #[test]
    fn the_window_clips_whatever_the_clipping_indicator_says() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_clipping_indicator(false).unwrap();
        gks.set_workstation_window(1, (0.25, 0.75, 0.25, 0.75)).unwrap();
        gks.polyline(&DIAGONAL).unwrap();
        assert_eq!(line(&log.mark().0), [dvec2(0.0, 0.0), dvec2(1000.0, 1000.0)]);
    }

    #[test]
    fn a_change_waits_for_the_next_frame_once_something_is_drawn() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.polyline(&DIAGONAL).unwrap();
        gks.set_workstation_window(1, (0.0, 0.5, 0.0, 0.5)).unwrap();
        gks.polyline(&[(0.0, 0.0), (0.5, 0.5)]).unwrap();
        assert_eq!(line(&log.marks()[1].0)[1], dvec2(500.0, 500.0));
        assert!(gks.workstations[&1].workstation.is_pending());
        gks.update_workstation(1, true).unwrap();
        gks.polyline(&[(0.0, 0.0), (0.5, 0.5)]).unwrap();
        assert_eq!(line(&log.mark().0)[1], dvec2(1000.0, 1000.0));
        let (deferral, _) = gks.workstations[&1].workstation.deferral();
        gks.set_deferral_state(1, deferral, RegenerationMode::Allowed).unwrap();
        gks.set_workstation_window(1, (0.0, 1.0, 0.0, 1.0)).unwrap();
        // Deferred until the next output.
        assert!(gks.workstations[&1].workstation.is_pending());
        gks.polyline(&DIAGONAL).unwrap();
        assert!(!gks.workstations[&1].workstation.is_pending());
        gks.set_deferral_state(1, DeferralMode::Asap, RegenerationMode::Allowed).unwrap();
        gks.set_workstation_window(1, (0.0, 0.5, 0.0, 0.5)).unwrap();
        assert!(!gks.workstations[&1].workstation.is_pending());
    }

    #[test]
    fn the_clipping_rectangle_travels_with_a_dashed_line() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_viewport(1, (0.25, 0.75, 0.0, 1.0)).unwrap();
        gks.set_window(1, (0.25, 0.75, 0.0, 1.0)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        gks.set_linetype(2).unwrap();
        gks.polyline(&[(0.0, 0.5), (1.0, 0.5)]).unwrap();
        assert_eq!(log.mark().1, Some(Rect::new(250.0, 750.0, 0.0, 1000.0)));
    }
}
