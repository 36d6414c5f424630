//! Normalization transformations, their priority for input, and clipping.

use crate::{Error, Function, Gks, Result};
use gks_geometry::{Map, Ndc, Rect, Wc};
use gks_pipeline::generated::numbers;

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
            map: Map::IDENTITY,
            clip: Rect::UNIT,
        }
    }
}

impl Normalization {
    fn adopt(&mut self) {
        let current = &self.transformations[self.current];
        self.map = Map::window_to_viewport(&current.window, &current.viewport);
        self.clip = if self.clipping { current.viewport } else { Rect::UNIT };
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
            self.normalization.adopt();
            self.geometry_stale = true;
        }
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
        self.normalization.adopt();
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
    /// The rectangle is the viewport of the current normalization transformation where the indicator is on.
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
