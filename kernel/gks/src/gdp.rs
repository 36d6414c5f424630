//! Generalized drawing primitives: circles, ellipses and curves.
//!
//! A shape is what it is in world coordinates and is taken to NDC as a whole, so that a circle becomes an
//! ellipse where the normalization transformation stretches one direction more than the other.

use crate::{DataRecord, Error, Function, Gks, Points, Result};
use gks_geometry::{Ndc, Paths, Point, Wc};
use gks_pipeline::generalized::{ellipse, role, spline};
use gks_pipeline::generated::numbers::{GDPS, Gdp, gdp};
use gks_pipeline::item::{Curve, Role, Shape};
use glam::DVec2;

const F: Function = Function::GeneralizedDrawingPrimitive;

impl Gks {
    /// GENERALIZED DRAWING PRIMITIVE: the shape with an identifier of [`gdp`], through or around points.
    ///
    /// Shapes without an inside take the polyline attributes, all others the fill area attributes. Where the
    /// points do not determine the shape (an arc through points on one line, a circle without a radius), the
    /// polygon through the points is drawn in its place. Nothing is drawn if a coordinate is not finite, but
    /// splines leave such points out. No shape reads the data record.
    ///
    /// Errors: 5, 100 (number of points), 102 (identifier 0), 104 (no such shape).
    pub fn generalized_drawing_primitive<'p>(
        &mut self,
        points: impl Into<Points<'p>>,
        id: i32,
        _record: &DataRecord,
    ) -> Result<()> {
        self.check_state(F)?;
        let points = points.into();
        let kind = GDPS.iter().find(|kind| kind.number == id);
        if points.is_empty() || kind.is_some_and(|kind| !suits(kind, points.len())) {
            return Err(Error::new(100, F).because(format!("{} points", points.len())));
        }
        match kind {
            Some(kind) => self.shape(kind, &points),
            None if id == 0 => Err(Error::new(102, F)),
            None => Err(Error::new(104, F).because(format!("identifier {id}"))),
        }
    }

    /// A circle around a centre, through a point on its edge. Errors: 5.
    pub fn circle(&mut self, centre: impl Into<Point<Wc>>, edge: impl Into<Point<Wc>>) -> Result<()> {
        self.through([edge.into(), centre.into()], gdp::CIRCLE)
    }

    /// The circular arc from `start` to `end` that passes `middle`. Error: 5.
    pub fn arc(
        &mut self,
        start: impl Into<Point<Wc>>,
        middle: impl Into<Point<Wc>>,
        end: impl Into<Point<Wc>>,
    ) -> Result<()> {
        self.through([start.into(), middle.into(), end.into()], gdp::CIRCULAR_ARC)
    }

    /// The area between the circular arc from `start` to `end` that passes `middle`, and its chord. Error: 5.
    pub fn chord(
        &mut self,
        start: impl Into<Point<Wc>>,
        middle: impl Into<Point<Wc>>,
        end: impl Into<Point<Wc>>,
    ) -> Result<()> {
        self.through([start.into(), middle.into(), end.into()], gdp::CIRCULAR_CHORD)
    }

    /// The area between the circular arc from `start` to `end` that passes `middle`, and its radii. Error: 5.
    pub fn pie(
        &mut self,
        start: impl Into<Point<Wc>>,
        middle: impl Into<Point<Wc>>,
        end: impl Into<Point<Wc>>,
    ) -> Result<()> {
        self.through([start.into(), middle.into(), end.into()], gdp::CIRCULAR_PIE)
    }

    /// The ellipse around a centre with the ends of two conjugate half axes. Error: 5.
    pub fn ellipse(
        &mut self,
        centre: impl Into<Point<Wc>>,
        first: impl Into<Point<Wc>>,
        second: impl Into<Point<Wc>>,
    ) -> Result<()> {
        self.through([centre.into(), first.into(), second.into()], gdp::ELLIPSE)
    }

    /// The arc of an ellipse, given as in [`Gks::ellipse`], from the ray through `start` to the ray through
    /// `end`, in the sense from the first half axis to the second. Error: 5.
    pub fn elliptic_arc(
        &mut self,
        [centre, first, second]: [impl Into<Point<Wc>>; 3],
        start: impl Into<Point<Wc>>,
        end: impl Into<Point<Wc>>,
    ) -> Result<()> {
        let points = [centre.into(), first.into(), second.into(), start.into(), end.into()];
        self.through(points, gdp::ELLIPTIC_ARC)
    }

    /// A chain of cubic Bezier curves: a point, then two control points and an end point for each curve.
    ///
    /// Errors: 5, 100 (not 4, 7, 10, ... points).
    pub fn bezier<'p>(&mut self, points: impl Into<Points<'p>>) -> Result<()> {
        self.generalized_drawing_primitive(points, gdp::BEZIER_CHAIN, &DataRecord::default())
    }

    /// The natural cubic spline through points, or the area inside the closed one.
    ///
    /// Errors: 5, 100 (fewer than 2 points, or 3 where closed).
    pub fn spline<'p>(&mut self, points: impl Into<Points<'p>>, closed: bool) -> Result<()> {
        let id = if closed { gdp::CLOSED_SPLINE } else { gdp::SPLINE };
        self.generalized_drawing_primitive(points, id, &DataRecord::default())
    }

    fn through<const N: usize>(&mut self, points: [Point<Wc>; N], id: i32) -> Result<()> {
        let points = points.map(|p| [p.x(), p.y()]);
        self.generalized_drawing_primitive(&points, id, &DataRecord::default())
    }

    fn shape(&mut self, kind: &Gdp, points: &Points<'_>) -> Result<()> {
        self.map_geometry();
        let Some(role) = role(kind.number) else { return Ok(()) };
        let mut through = Vec::with_capacity(points.len());
        points.for_each(|p| through.push(p));
        let is_spline = matches!(kind.number, gdp::SPLINE | gdp::CLOSED_SPLINE);
        if !is_spline && !through.iter().all(|p| p.is_finite()) {
            return Ok(());
        }
        match kind.number {
            gdp::BEZIER_CHAIN => self.bezier_chain(&through, role),
            gdp::SPLINE | gdp::CLOSED_SPLINE => {
                let control = spline(&through, kind.number == gdp::CLOSED_SPLINE);
                if control.len() > 1 { self.bezier_chain(&control, role) } else { self.polygon(points, role) }
            }
            _ => match ellipse(kind.number, &through) {
                Some(ellipse) => {
                    let ellipse = ellipse.mapped(&self.normalization.map);
                    let finite = [ellipse.centre.0, ellipse.a.0, ellipse.b.0].iter().all(|v| v.is_finite());
                    if finite {
                        self.output(F, Shape::Generalized(Curve::Ellipse(ellipse), role))
                    } else {
                        Ok(())
                    }
                }
                None => self.polygon(points, role),
            },
        }
    }

    /// Draws a chain of Bezier curves given in world coordinates.
    fn bezier_chain(&mut self, control: &[DVec2], role: Role) -> Result<()> {
        let map = self.normalization.map.0;
        let control: Vec<DVec2> = control.iter().map(|&p| map.transform_point2(p)).collect();
        if !control.iter().all(|p| p.is_finite()) {
            return Ok(());
        }
        self.output(F, Shape::Generalized(Curve::Bezier(&control), role))
    }

    /// Draws the points in place of a shape that they do not determine.
    fn polygon(&mut self, points: &Points<'_>, role: Role) -> Result<()> {
        self.normalize(points, 1, false);
        self.output_paths(F, |paths: Paths<'_, Ndc>| match role {
            Role::Line => Shape::Polyline(paths),
            Role::Area => Shape::FillArea(paths),
        })
    }
}

/// Whether a shape may have this number of points.
fn suits(kind: &Gdp, count: usize) -> bool {
    let enough = count >= kind.least && (kind.most == 0 || count <= kind.most);
    enough && (count - kind.least).is_multiple_of(kind.step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{Drawing, INDEXED, PLAIN, active, closed, number, open};
    use gks_geometry::Wc;
    use gks_pipeline::item::{Closure, Ellipse};
    use gks_pipeline::look::InteriorStyle;
    use glam::dvec2;
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    fn near(a: DVec2, b: DVec2) -> bool {
        a.distance(b) < 1e-9
    }

    #[test]
    fn states_counts_and_identifiers_are_checked_in_this_order() {
        let record = DataRecord::default();
        let points = [(0.5, 0.5); 12];
        let gdp = |gks: &mut Gks, count: usize, id| {
            gks.generalized_drawing_primitive(&points[..count], id, &record)
        };
        assert_eq!(number(gdp(&mut closed(), 0, 0)), 5);
        assert_eq!(number(gdp(&mut open(&[PLAIN]).0, 0, 0)), 5);
        let (mut gks, _) = active(&[PLAIN]);
        assert_eq!(number(gdp(&mut gks, 0, 0)), 100);
        assert_eq!(number(gdp(&mut gks, 2, 0)), 102);
        assert_eq!([-12, 1, -31_999].map(|id| number(gdp(&mut gks, 2, id))), [104; 3]);
        for kind in GDPS {
            let accepted: Vec<usize> = (0..=12).filter(|&n| gdp(&mut gks, n, kind.number).is_ok()).collect();
            let expected: Vec<usize> = match kind.number {
                gdp::CIRCLE => vec![2],
                gdp::BEZIER_CHAIN => vec![4, 7, 10],
                gdp::SPLINE => (2..=12).collect(),
                gdp::CLOSED_SPLINE => (3..=12).collect(),
                gdp::ELLIPTIC_ARC | gdp::ELLIPTIC_CHORD | gdp::ELLIPTIC_PIE => vec![5],
                _ => vec![3],
            };
            assert_eq!(accepted, expected, "{}", kind.name);
            assert_eq!(number(gdp(&mut gks, 1, kind.number)), 100);
        }
    }

    #[test]
    fn a_circle_becomes_an_ellipse_under_an_anisotropic_transformation() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_fill_area_interior_style(InteriorStyle::Solid).unwrap();
        gks.set_window(1, (0.0, 10.0, 0.0, 20.0)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        gks.circle((5.0, 10.0), (5.0, 12.0)).unwrap();
        let (Drawing::FilledEllipse(e, _), None) = log.mark() else { panic!("not an ellipse") };
        assert!(near(e.centre.0, dvec2(500.0, 500.0)));
        assert!(near(e.a.0, dvec2(200.0, 0.0)) && near(e.b.0, dvec2(0.0, 100.0)));
        assert_eq!((e.sweep, e.closure), (TAU, Closure::Full));
    }

    #[test]
    fn attributes_and_the_clipping_rectangle_reach_the_device() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_colour_representation(1, 6, (1.0, 0.0, 0.0)).unwrap();
        gks.set_colour_alpha(1, 6, 0.25).unwrap();
        gks.set_fill_area_colour_index(6).unwrap();
        gks.set_fill_area_interior_style(InteriorStyle::Solid).unwrap();
        gks.circle((0.0, 0.5), (0.25, 0.5)).unwrap();
        let (Drawing::FilledEllipse(_, paint), Some(clip)) = log.mark() else { panic!("not clipped") };
        assert_eq!((paint.index, paint.colour.alpha), (6, 0.25));
        assert_eq!(clip.limits(), [0.0, 1000.0, 0.0, 1000.0]);
        gks.set_polyline_colour_index(3).unwrap();
        gks.set_linetype(3).unwrap();
        gks.arc((0.2, 0.5), (0.5, 0.8), (0.8, 0.5)).unwrap();
        let (Drawing::EllipticArc(_, pen), None) = log.mark() else { panic!("not an arc") };
        assert_eq!((pen.paint.index, pen.dash.len()), (3, 2));
    }

    #[test]
    fn arcs_begin_at_the_first_point_pass_the_second_and_end_at_the_third() {
        let (mut gks, log) = active(&[INDEXED]);
        gks.set_fill_area_interior_style(InteriorStyle::Solid).unwrap();
        // 500 pixels to the unit, ordinates downwards: centre (250, 250), radius 100, clockwise below.
        gks.arc((0.7, 0.5), (0.5, 0.3), (0.3, 0.5)).unwrap();
        gks.chord((0.7, 0.5), (0.5, 0.7), (0.3, 0.5)).unwrap();
        gks.pie((0.7, 0.5), (0.5, 0.7), (0.3, 0.5)).unwrap();
        let marks = log.marks();
        let Drawing::EllipticArc(arc, _) = &marks[0].0 else { panic!("{marks:?}") };
        let (Drawing::FilledEllipse(chord, _), Drawing::FilledEllipse(pie, _)) = (&marks[1].0, &marks[2].0)
        else {
            panic!("{marks:?}")
        };
        for (e, middle) in [(arc, 350.0), (chord, 150.0), (pie, 150.0)] {
            assert!(near(e.at(e.start).0, dvec2(350.0, 250.0)));
            assert!(near(e.at(e.start + e.sweep * 0.5).0, dvec2(250.0, middle)));
            assert!(near(e.at(e.start + e.sweep).0, dvec2(150.0, 250.0)));
        }
        assert_eq!([arc, chord, pie].map(|e| e.closure), [Closure::Open, Closure::Chord, Closure::Pie]);
    }

    #[test]
    fn elliptic_arcs_turn_from_the_first_half_axis_to_the_second() {
        let part = |start, end| -> Ellipse<Wc> {
            let points = [dvec2(1.0, 1.0), dvec2(4.0, 2.0), dvec2(1.0, 3.0), start, end];
            ellipse(gdp::ELLIPTIC_ARC, &points).unwrap()
        };
        let quarter = part(dvec2(7.0, 3.0), dvec2(1.0, 1.5));
        assert!(quarter.start.abs() < 1e-12 && (quarter.sweep - FRAC_PI_2).abs() < 1e-12);
        let rest = part(dvec2(1.0, 1.5), dvec2(7.0, 3.0));
        assert!((rest.sweep - 3.0 * FRAC_PI_2).abs() < 1e-12);
        // Where the second half axis lies clockwise of the first, the arc turns clockwise.
        let points = [(0.0, 0.0), (1.0, 0.0), (0.0, -2.0), (1.0, 0.0), (-3.0, 0.0)].map(DVec2::from);
        let half: Ellipse<Wc> = ellipse(gdp::ELLIPTIC_PIE, &points).unwrap();
        assert!((half.sweep - PI).abs() < 1e-12 && near(half.at(half.sweep * 0.5).0, dvec2(0.0, -2.0)));
        assert_eq!(part(dvec2(4.0, 2.0), dvec2(13.0, 5.0)).sweep, TAU);
    }

    #[test]
    fn curves_run_through_the_images_of_their_points() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_window(1, (0.0, 10.0, 0.0, 20.0)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        gks.bezier(&[(0.0, 0.0), (5.0, 0.0), (10.0, 10.0), (10.0, 20.0)]).unwrap();
        let (Drawing::Bezier(control, _), None) = log.mark() else { panic!("not a curve") };
        assert!(near(control[1], dvec2(500.0, 0.0)) && near(control[3], dvec2(1000.0, 1000.0)));
        let through = [(1.0, 2.0), (3.0, 16.0), (5.0, f64::NAN), (7.0, 4.0)];
        gks.spline(&through, false).unwrap();
        let (Drawing::Bezier(control, _), None) = log.mark() else { panic!("not a curve") };
        let met: Vec<DVec2> = control.iter().copied().step_by(3).collect();
        let expected = [dvec2(100.0, 100.0), dvec2(300.0, 800.0), dvec2(700.0, 200.0)];
        assert!(met.len() == 3 && met.iter().zip(expected).all(|(&a, b)| near(a, b)));
        gks.set_fill_area_interior_style(InteriorStyle::Solid).unwrap();
        gks.spline(&through, true).unwrap();
        let (Drawing::FilledBezier(control, _), _) = log.mark() else { panic!("not a closed curve") };
        assert!(control.len() == 10 && near(control[0], control[9]));
    }

    #[test]
    fn points_that_determine_no_shape_are_joined_by_lines() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.arc((0.1, 0.1), (0.5, 0.5), (0.9, 0.9)).unwrap();
        let (Drawing::Lines(paths, _), None) = log.mark() else { panic!("not a line") };
        assert_eq!(paths[0].len(), 3);
        gks.set_fill_area_interior_style(InteriorStyle::Solid).unwrap();
        gks.ellipse((0.5, 0.5), (0.6, 0.6), (0.3, 0.3)).unwrap();
        gks.circle((0.5, 0.5), (0.5, 0.5)).unwrap();
        gks.spline(&[(0.5, 0.5); 4], true).unwrap();
        assert!(log.marks().iter().all(|(drawing, _)| matches!(drawing, Drawing::Area(..))));
        gks.elliptic_arc([(0.5, 0.5), (0.7, 0.5), (0.5, 0.6)], (0.5, 0.5), (0.5, 0.9)).unwrap();
        assert!(matches!(log.mark().0, Drawing::Lines(..)));
    }

    #[test]
    fn coordinates_that_are_not_finite_draw_nothing() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.circle((0.5, f64::NAN), (0.1, 0.1)).unwrap();
        gks.arc((0.5, f64::INFINITY), (0.1, 0.1), (0.2, 0.1)).unwrap();
        gks.bezier(&[(0.0, 0.0), (f64::NAN, 0.0), (1.0, 1.0), (1.0, 1.0)]).unwrap();
        gks.circle((1e308, -1e308), (-1e308, 1e308)).unwrap();
        gks.spline(&[(f64::NAN, 0.0); 3], true).unwrap();
        assert_eq!(log.marks(), []);
    }
}
