//! Normalization transformations, their priority for input, and clipping.

use crate::attributes::NOT_A_NUMBER;
use crate::{Error, Function, Gks, Result};
use gks_geometry::{Map, Ndc, Rect, Wc};
use gks_pipeline::generated::numbers;
use gks_pipeline::look::ClipSector;

/// The window and the viewport of a normalization transformation.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct NormalizationTransformation {
    /// The window, in world coordinates.
    pub window: Rect<Wc>,
    /// The viewport, in normalized device coordinates.
    pub viewport: Rect<Ndc>,
}

/// Which side of another transformation a transformation takes in the order of viewport input priority.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum RelativePriority {
    /// Just before.
    Higher = 0,
    /// Just after.
    Lower = 1,
}

/// The part of the state list about normalization transformations.
pub(crate) struct Normalization {
    pub(crate) transformations: Vec<NormalizationTransformation>,
    /// All transformation numbers by decreasing viewport input priority.
    pub(crate) priority: Vec<i32>,
    pub(crate) current: usize,
    pub(crate) clipping: bool,
    /// The transformation whose viewport clips instead of that of the current one, whatever the indicator says.
    clipping_transformation: Option<usize>,
    /// The sector that clips where a viewport clips.
    clip_sector: Option<ClipSector>,
    /// The map of the current transformation.
    pub(crate) map: Map<Wc, Ndc>,
    /// What clips the primitives created now.
    pub(crate) clip: Rect<Ndc>,
}

impl Default for Normalization {
    fn default() -> Self {
        let unit = NormalizationTransformation { window: Rect::UNIT, viewport: Rect::UNIT };
        let count = numbers::MAX_NORMALIZATION_TRANSFORMATIONS as usize + 1;
        Normalization {
            transformations: vec![unit; count],
            priority: (0..count as i32).collect(),
            current: 0,
            clipping: true,
            clipping_transformation: None,
            clip_sector: None,
            map: Map::IDENTITY,
            clip: Rect::UNIT,
        }
    }
}

impl Normalization {
    fn adopt(&mut self) {
        let current = &self.transformations[self.current];
        self.map = Map::window_to_viewport(&current.window, &current.viewport);
        self.clip = self.clipping_index().map_or(Rect::UNIT, |index| self.transformations[index].viewport);
    }

    /// The transformation whose viewport clips.
    fn clipping_index(&self) -> Option<usize> {
        self.clipping_transformation.or(self.clipping.then_some(self.current))
    }

    /// The index of a transformation number, from `least` on, if it is one.
    fn index(&self, number: i32, least: usize) -> Option<usize> {
        usize::try_from(number).ok().filter(|i| (least..self.transformations.len()).contains(i))
    }
}

impl Gks {
    /// SET WINDOW: the part of world coordinate space that a normalization transformation maps.
    ///
    /// Errors: 8, 50 (number not in 1 to the maximum), 51 (limits).
    pub fn set_window(&mut self, number: i32, window: impl Into<Rect<Wc>>) -> Result<()> {
        const F: Function = Function::SetWindow;
        let (index, window) = self.normalization_arguments(F, number, window.into())?;
        let old = std::mem::replace(&mut self.normalization.transformations[index].window, window);
        if old != window {
            self.normalization_changed(index);
        }
        Ok(())
    }

    /// SET VIEWPORT: the part of NDC space onto which a normalization transformation maps its window.
    ///
    /// Errors: 8, 50 (number not in 1 to the maximum), 51 (limits), 52 (not in the unit square).
    pub fn set_viewport(&mut self, number: i32, viewport: impl Into<Rect<Ndc>>) -> Result<()> {
        const F: Function = Function::SetViewport;
        let (index, viewport) = self.normalization_arguments(F, number, viewport.into())?;
        if !Rect::UNIT.contains_rect(&viewport) {
            return Err(Error::new(52, F).because(format!("limits {:?}", viewport.limits())));
        }
        let old = std::mem::replace(&mut self.normalization.transformations[index].viewport, viewport);
        if old != viewport {
            self.normalization_changed(index);
        }
        Ok(())
    }

    fn normalization_arguments<S: gks_geometry::Space>(
        &self,
        function: Function,
        number: i32,
        rect: Rect<S>,
    ) -> Result<(usize, Rect<S>)> {
        self.check_state(function)?;
        let index = self.normalization.index(number, 1).ok_or_else(|| invalid_number(function, number))?;
        if rect.is_proper() {
            Ok((index, rect))
        } else {
            Err(Error::new(51, function).because(format!("limits {:?}", rect.limits())))
        }
    }

    fn normalization_changed(&mut self, index: usize) {
        if index == self.normalization.current {
            self.adopt_normalization();
            self.geometry_stale = true;
        } else if self.normalization.clipping_transformation == Some(index) {
            self.adopt_normalization();
        }
    }

    fn adopt_normalization(&mut self) {
        self.normalization.adopt();
        // Transformation 0 stands for no clipping: its viewport is all of NDC space.
        let clips = self.normalization.clipping_index().is_some_and(|index| index != 0);
        self.look.clip_sector = self.normalization.clip_sector.filter(|_| clips);
    }

    /// SET VIEWPORT INPUT PRIORITY: moves a transformation next to another one in the order in which
    /// viewports are searched for a position that was entered.
    ///
    /// Errors: 8, 50.
    pub fn set_viewport_input_priority(
        &mut self,
        number: i32,
        reference: i32,
        priority: RelativePriority,
    ) -> Result<()> {
        const F: Function = Function::SetViewportInputPriority;
        self.check_state(F)?;
        for n in [number, reference] {
            self.normalization.index(n, 0).ok_or_else(|| invalid_number(F, n))?;
        }
        if number != reference {
            let order = &mut self.normalization.priority;
            order.retain(|&n| n != number);
            if let Some(at) = order.iter().position(|&n| n == reference) {
                order.insert(at + usize::from(priority == RelativePriority::Lower), number);
            }
        }
        Ok(())
    }

    /// SELECT NORMALIZATION TRANSFORMATION: makes a transformation the current one.
    ///
    /// Errors: 8, 50.
    pub fn select_normalization_transformation(&mut self, number: i32) -> Result<()> {
        const F: Function = Function::SelectNormalizationTransformation;
        self.check_state(F)?;
        let index = self.normalization.index(number, 0).ok_or_else(|| invalid_number(F, number))?;
        if self.normalization.current != index {
            self.normalization.current = index;
            self.normalization_changed(index);
        }
        Ok(())
    }

    /// SET CLIPPING INDICATOR: whether primitives are clipped at the viewport of the current normalization
    /// transformation (`true`) or only at the workstation window.
    ///
    /// Error: 8.
    pub fn set_clipping_indicator(&mut self, clip: bool) -> Result<()> {
        self.check_state(Function::SetClippingIndicator)?;
        self.normalization.clipping = clip;
        self.adopt_normalization();
        Ok(())
    }

    /// Makes a sector of the ellipse in the clipping rectangle clip instead of the whole rectangle, or the rectangle again.
    /// It has no effect while nothing clips (transformation 0, or the clipping indicator off).
    ///
    /// Beyond the standard; ESCAPE offers it to other languages. Metafiles of other systems keep the rectangle. Errors: 8,
    /// 308 (an angle is not finite).
    pub fn set_clip_sector(&mut self, sector: Option<ClipSector>) -> Result<()> {
        const F: Function = Function::Escape;
        self.check_state(F)?;
        if sector.is_some_and(|ClipSector { start, end }| !start.is_finite() || !end.is_finite()) {
            return Err(Error::new(NOT_A_NUMBER, F));
        }
        self.normalization.clip_sector = sector;
        self.adopt_normalization();
        Ok(())
    }

    /// Makes the viewport of one normalization transformation clip, whichever is current and whatever the clipping indicator
    /// says; 0 leaves it to these again.
    ///
    /// Beyond the standard; ESCAPE offers it to other languages. Errors: 8, 50.
    pub fn select_clipping_transformation(&mut self, number: i32) -> Result<()> {
        const F: Function = Function::Escape;
        self.check_state(F)?;
        let index = self.normalization.index(number, 0).ok_or_else(|| invalid_number(F, number))?;
        self.normalization.clipping_transformation = (index != 0).then_some(index);
        self.adopt_normalization();
        Ok(())
    }

    /// INQUIRE CURRENT NORMALIZATION TRANSFORMATION NUMBER. Error: 8.
    #[inline]
    pub fn inquire_current_normalization_transformation_number(&self) -> Result<i32> {
        self.check_state(Function::InquireCurrentNormalizationTransformationNumber)?;
        Ok(self.normalization.current as i32)
    }

    /// INQUIRE LIST OF NORMALIZATION TRANSFORMATION NUMBERS, by decreasing viewport input priority.
    ///
    /// Error: 8.
    pub fn inquire_list_of_normalization_transformation_numbers(&self) -> Result<&[i32]> {
        self.check_state(Function::InquireListOfNormalizationTransformationNumbers)?;
        Ok(&self.normalization.priority)
    }

    /// INQUIRE NORMALIZATION TRANSFORMATION. Errors: 8, 50.
    #[inline]
    pub fn inquire_normalization_transformation(&self, number: i32) -> Result<NormalizationTransformation> {
        const F: Function = Function::InquireNormalizationTransformation;
        self.check_state(F)?;
        match self.normalization.index(number, 0) {
            Some(index) => Ok(self.normalization.transformations[index]),
            None => Err(invalid_number(F, number)),
        }
    }

    /// INQUIRE CLIPPING: the clipping indicator and the clipping rectangle.
    ///
    /// The rectangle is the viewport of the current normalization transformation where the indicator is on, and that of the
    /// one selected by [`Gks::select_clipping_transformation`] in any case.
    /// Error: 8.
    pub fn inquire_clipping(&self) -> Result<(bool, Rect<Ndc>)> {
        self.check_state(Function::InquireClipping)?;
        Ok((self.normalization.clipping, self.normalization.clip))
    }

    /// INQUIRE MAXIMUM NORMALIZATION TRANSFORMATION NUMBER. Error: 8.
    pub fn inquire_maximum_normalization_transformation_number(&self) -> Result<i32> {
        self.check_state(Function::InquireMaximumNormalizationTransformationNumber)?;
        Ok(self.normalization.transformations.len() as i32 - 1)
    }
}

#[cold]
fn invalid_number(function: Function, number: i32) -> Error {
    Error::new(50, function).because(format!("transformation number {number}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{Drawing, Log, PLAIN, active, number};
    use gks_pipeline::generated::numbers::escape;
    use gks_pipeline::look::InteriorStyle;
    use glam::{DVec2, dvec2};

    /// The ends of a line that is drawn across the picture.
    fn across(gks: &mut Gks, log: &Log) -> Vec<Vec<DVec2>> {
        log.take();
        gks.polyline(&[(0.0, 0.5), (1.0, 0.5)][..]).unwrap();
        let (Drawing::Lines(lines, _), None) = log.mark() else { panic!("no line") };
        lines
    }

    fn near(found: &[Vec<DVec2>], left: f64, right: f64) -> bool {
        found.len() == 1
            && found[0].first().zip(found[0].last()).is_some_and(|(a, b)| {
                a.distance(dvec2(left, 500.0)) < 1e-6 && b.distance(dvec2(right, 500.0)) < 1e-6
            })
    }

    #[test]
    fn an_ellipse_clips_where_a_viewport_does() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_viewport(1, (0.2, 0.6, 0.5, 0.7)).unwrap();
        gks.set_window(1, (0.2, 0.6, 0.5, 0.7)).unwrap();
        gks.set_viewport(2, (0.2, 0.6, 0.4, 0.6)).unwrap();
        gks.set_clip_sector(Some(ClipSector::WHOLE)).unwrap();
        assert!(near(&across(&mut gks, &log), 0.0, 1000.0), "transformation 0 does not clip");
        gks.select_clipping_transformation(2).unwrap();
        assert!(near(&across(&mut gks, &log), 200.0, 600.0), "the axis of the ellipse");
        gks.set_viewport(2, (0.2, 0.6, 0.45, 0.65)).unwrap();
        let half = 200.0 * (1.0 - 0.25_f64).sqrt();
        assert!(near(&across(&mut gks, &log), 400.0 - half, 400.0 + half), "a chord of it");
        gks.select_clipping_transformation(0).unwrap();
        assert!(near(&across(&mut gks, &log), 0.0, 1000.0), "nothing");
        gks.select_normalization_transformation(1).unwrap();
        gks.fill_area(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)][..]).unwrap();
        gks.set_clipping_indicator(false).unwrap();
        assert!(near(&across(&mut gks, &log), 0.0, 1000.0), "the indicator is off");
        assert_eq!(number(gks.select_clipping_transformation(999)), 50);
        let sector = ClipSector { start: f64::NAN, end: 1.0 };
        assert_eq!(number(gks.set_clip_sector(Some(sector))), 308);
    }

    #[test]
    fn escapes_set_the_sector_and_areas_are_cut_by_it() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_viewport(1, (0.0, 0.5, 0.0, 0.5)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        let record = crate::DataRecord::new(&[1], &[180.0, 270.0], &[]);
        gks.escape(escape::SET_CLIP_SECTOR, &record).unwrap();
        gks.set_fill_area_interior_style(InteriorStyle::Solid).unwrap();
        gks.fill_area(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)][..]).unwrap();
        let (Drawing::Area(rings, ..), None) = log.mark() else { panic!("no area") };
        let quarter =
            |p: &DVec2| p.max_element() < 250.0 + 1e-6 && p.distance(dvec2(250.0, 250.0)) < 250.0 + 1e-6;
        assert!(rings.len() == 1 && rings[0].len() > 8 && rings[0].iter().all(quarter), "{rings:?}");
        // Outside of it nothing is drawn, and what is on its other side neither.
        gks.polyline(&[(0.6, 0.9), (0.9, 0.6)][..]).unwrap();
        assert!(log.marks().is_empty());
        let record = crate::DataRecord::new(&[0], &[0.0, 0.0], &[]);
        gks.escape(escape::SET_CLIP_SECTOR, &record).unwrap();
        gks.polyline(&[(0.6, 0.9), (0.9, 0.6)][..]).unwrap();
        assert_eq!(log.marks().len(), 1);
    }
}
