//! What earlier elements say about how later ones are coded.

use super::element::{Element, Ink};
use crate::generated::elements::Kind;
use gks_pipeline::colour::Colour;

/// How the size of lines, markers, edges and styles is given (specification modes).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SizeMode {
    /// In virtual device coordinates.
    Absolute,
    /// As a factor of a nominal size.
    Scaled,
    /// As a fraction of the display surface.
    Fractional,
    /// In millimetres.
    Millimetres,
}

impl SizeMode {
    fn from_number(number: i32) -> Option<SizeMode> {
        [SizeMode::Absolute, SizeMode::Scaled, SizeMode::Fractional, SizeMode::Millimetres]
            .get(usize::try_from(number).ok()?)
            .copied()
    }
}

/// How direct colours are given (COLOUR MODEL).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColourModel {
    /// Red, green, blue.
    Rgb,
    /// Lightness and two chromaticities of CIE.
    Cie,
    /// Cyan, magenta, yellow, black.
    Cmyk,
}

impl ColourModel {
    /// The number of components.
    pub fn components(self) -> usize {
        if self == ColourModel::Cmyk { 4 } else { 3 }
    }
}

/// The modes that all encodings share. Precisions belong to each encoding.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// Whether virtual device coordinates are real numbers.
    pub real_coordinates: bool,
    /// Whether colours are direct.
    pub direct: bool,
    /// The colour model.
    pub model: ColourModel,
    /// The components of direct colours that stand for the least and the greatest intensity.
    pub extent: ([f64; 4], [f64; 4]),
    /// How line widths are given.
    pub line_width: SizeMode,
    /// How marker sizes are given.
    pub marker_size: SizeMode,
    /// How edge widths are given.
    pub edge_width: SizeMode,
    /// How sizes of interior styles are given.
    pub style_size: SizeMode,
    /// Whether device viewports are given in the units of a device.
    pub device_viewport: bool,
}

impl Modes {
    /// The modes before any element, with the greatest colour component of the encoding.
    pub fn new(component: f64) -> Modes {
        Modes {
            real_coordinates: false,
            direct: false,
            model: ColourModel::Rgb,
            extent: ([0.0; 4], [component; 4]),
            line_width: SizeMode::Scaled,
            marker_size: SizeMode::Scaled,
            edge_width: SizeMode::Scaled,
            style_size: SizeMode::Absolute,
            device_viewport: false,
        }
    }

    /// Takes note of an element.
    pub fn observe(&mut self, element: &Element) {
        let number = element.integer(0);
        let size = number.and_then(SizeMode::from_number);
        match element.kind {
            Kind::VdcType => self.real_coordinates = number.map_or(self.real_coordinates, |n| n == 1),
            Kind::ColourSelectionMode => self.direct = number.map_or(self.direct, |n| n == 1),
            Kind::ColourModel => {
                self.model = match number {
                    Some(2 | 3) => ColourModel::Cie,
                    Some(4) => ColourModel::Cmyk,
                    _ => ColourModel::Rgb,
                }
            }
            Kind::ColourValueExtent => self.set_extent(element),
            Kind::LineWidthSpecificationMode => self.line_width = size.unwrap_or(self.line_width),
            Kind::MarkerSizeSpecificationMode => self.marker_size = size.unwrap_or(self.marker_size),
            Kind::EdgeWidthSpecificationMode => self.edge_width = size.unwrap_or(self.edge_width),
            Kind::InteriorStyleSpecificationMode => self.style_size = size.unwrap_or(self.style_size),
            Kind::DeviceViewportSpecificationMode => self.device_viewport = number == Some(2),
            _ => {}
        }
    }

    fn set_extent(&mut self, element: &Element) {
        let values: Vec<f64> = (0..element.values.len()).map_while(|i| element.real(i)).collect();
        let half = values.len() / 2;
        if half < self.model.components() {
            return;
        }
        let (mut least, mut most) = self.extent;
        for i in 0..self.model.components() {
            (least[i], most[i]) = (values[i], values[half + i]);
        }
        self.extent = (least, most);
    }

    /// The colour of components as they are coded.
    pub fn colour(&self, components: [f64; 4]) -> Colour {
        let (least, most) = &self.extent;
        let share = |i: usize| {
            let range = most[i] - least[i];
            let share = if range == 0.0 { 0.0 } else { (components[i] - least[i]) / range };
            if share.is_finite() { share.clamp(0.0, 1.0) as f32 } else { 0.0 }
        };
        match self.model {
            ColourModel::Rgb => Colour::rgb(share(0), share(1), share(2)),
            ColourModel::Cmyk => {
                let key = 1.0 - share(3);
                Colour::rgb((1.0 - share(0)) * key, (1.0 - share(1)) * key, (1.0 - share(2)) * key)
            }
            // Of the lightness at least; chromaticities would need the reference white.
            ColourModel::Cie => Colour::rgb(share(0), share(0), share(0)),
        }
    }

    /// The components of a colour as they are coded, whole numbers, of the RGB model.
    pub fn components(&self, colour: Colour) -> [f64; 3] {
        let (least, most) = &self.extent;
        // Rounded as devices do that take bytes for components.
        let range = |i: usize| (most[i] - least[i]) as f32;
        let scaled =
            |i: usize, share: f32| least[i] + f64::from((share.clamp(0.0, 1.0) * range(i) + 0.5).floor());
        [scaled(0, colour.red), scaled(1, colour.green), scaled(2, colour.blue)]
    }

    /// Whether a colour that follows the colour selection mode is direct.
    pub fn ink_of(&self, index: u32, components: [f64; 4]) -> Ink {
        if self.direct { Ink::Direct(self.colour(components)) } else { Ink::Index(index) }
    }
}
