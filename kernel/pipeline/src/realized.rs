//! Realized values: what a workstation draws for an attribute that it cannot draw as it was set.
//!
//! They follow the rules by which items are painted, so that an inquiry tells what the picture shows.

use crate::colour::Colour;
use crate::description::Classification;
use crate::font;
use crate::generated::numbers;
use crate::look::{FillBundle, InteriorStyle, LineBundle, MarkerBundle, Precision, TextBundle};
use crate::lower;
use crate::workstation::Workstation;

impl Workstation {
    /// The polyline bundle that is drawn: an unknown linetype is solid, the linewidth lies in the range of the
    /// surface, a colour index without representation is 1.
    pub fn realized_line(&self, set: LineBundle) -> LineBundle {
        let (least, greatest) = lower::line::range(&self.description().surface);
        let nominal = self.tables().nominal.linewidth;
        let known = numbers::LINETYPES.iter().any(|l| l.number == set.linetype);
        LineBundle {
            linetype: if known { set.linetype } else { 1 },
            width: set.width.clamp(least / nominal, greatest / nominal),
            colour: self.realized_index(set.colour),
        }
    }

    /// The polymarker bundle that is drawn: an unknown marker type is an asterisk, the size lies in the range
    /// of the surface, a colour index without representation is 1.
    pub fn realized_marker(&self, set: MarkerBundle) -> MarkerBundle {
        let (least, greatest) = lower::marker::range(&self.description().surface);
        let known = numbers::MARKERS.iter().any(|m| m.number == set.kind);
        MarkerBundle {
            kind: if known { set.kind } else { 3 },
            size: set.size.clamp(least, greatest),
            colour: self.realized_index(set.colour),
        }
    }

    /// The text bundle that is drawn: an unknown font is font 1, an outline font on a device with pens its
    /// stroke font, every precision STROKE, a colour index without representation is 1.
    pub fn realized_text(&self, set: TextBundle) -> TextBundle {
        let face = font::face(set.font);
        let font = match self.description().surface.pen {
            Some(_) => face.map_or(1, |face| face.for_pen().number()),
            None => face.map_or(1, font::Face::number),
        };
        TextBundle { font, precision: Precision::Stroke, colour: self.realized_index(set.colour), ..set }
    }

    /// The fill area bundle that is drawn: a pattern index without representation is 1, or the area is hollow
    /// if pattern 1 has none either; an unknown hatch style is the first one; a colour index without
    /// representation is 1.
    pub fn realized_fill(&self, set: FillBundle) -> FillBundle {
        let colour = self.realized_index(set.colour);
        let (interior, style) = match set.interior {
            InteriorStyle::Hollow | InteriorStyle::Solid => (set.interior, set.style),
            InteriorStyle::Pattern => {
                let patterns = &self.tables().patterns;
                let has =
                    |index: &i32| u32::try_from(*index).is_ok_and(|index| patterns.contains_key(&index));
                match [set.style, 1].into_iter().find(has) {
                    Some(style) => (InteriorStyle::Pattern, style),
                    None => (InteriorStyle::Hollow, set.style),
                }
            }
            InteriorStyle::Hatch => match lower::hatch::style(set.style) {
                Some(hatch) => (InteriorStyle::Hatch, hatch.number),
                None => (InteriorStyle::Hollow, set.style),
            },
        };
        FillBundle { interior, style, colour }
    }

    /// The colour that is shown: the nearest one with 8 bits a component on a raster surface.
    pub fn realized_colour(&self, set: Colour) -> Colour {
        if self.description().classification != Classification::Raster {
            return set;
        }
        let [red, green, blue, alpha] = set.to_bytes().map(|byte| f32::from(byte) / 255.0);
        Colour { red, green, blue, alpha }
    }

    fn realized_index(&self, set: u32) -> u32 {
        self.tables().paint(set).index
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::{
        Category, DeferralMode, Description, DynamicModification, DynamicModifications, RegenerationMode,
        SegmentModifications,
    };
    use crate::device::{Device, DeviceError, Drawn, Mark, Page, Surface};
    use crate::tables::Tables;
    use crate::workstation::Backend;

    struct Blank(Surface);

    impl Device for Blank {
        fn surface(&self) -> &Surface {
            &self.0
        }
        fn begin(&mut self, _: &Page) -> Result<(), DeviceError> {
            Ok(())
        }
        fn draw(&mut self, _: &Mark<'_>) -> Result<Drawn, DeviceError> {
            Ok(Drawn::Yes)
        }
        fn end(&mut self) -> Result<(), DeviceError> {
            Ok(())
        }
        fn close(&mut self) -> Result<(), DeviceError> {
            Ok(())
        }
    }

    /// A workstation of 2000 x 1000 units: nominal linewidth 1, marker size 6.
    fn workstation(classification: Classification, pen: Option<f64>) -> Workstation {
        let surface =
            Surface { width: 2000.0, height: 1000.0, unit: 0.001, y_down: false, resolution: 3.0, pen };
        let imm = DynamicModification::Imm;
        let description = Description {
            number: 1,
            name: "blank",
            category: Category::Output,
            classification,
            surface: surface.clone(),
            raster: (2000, 1000),
            colours: 0,
            dynamic: DynamicModifications {
                line_bundles: imm,
                marker_bundles: imm,
                text_bundles: imm,
                fill_bundles: imm,
                patterns: imm,
                colours: imm,
                transformation: imm,
            },
            deferral: DeferralMode::Asap,
            regeneration: RegenerationMode::Allowed,
            segments: SegmentModifications::REDRAWN,
            input: [0; 6],
        };
        Workstation::new(Backend::Device(Box::new(Blank(surface))), description, Tables::predefined())
    }

    #[test]
    fn what_can_be_drawn_is_realized_as_it_was_set() {
        let raster = workstation(Classification::Raster, None);
        let line = LineBundle { linetype: -6, width: 200.0, colour: 199 };
        assert_eq!(raster.realized_line(line), line);
        let marker = MarkerBundle { kind: -12, size: 7.0, colour: 0 };
        assert_eq!(raster.realized_marker(marker), marker);
        for (interior, style) in
            [(InteriorStyle::Solid, 99), (InteriorStyle::Pattern, 10), (InteriorStyle::Hatch, -12)]
        {
            let fill = FillBundle { interior, style, colour: 1 };
            assert_eq!(raster.realized_fill(fill), fill);
        }
        assert_eq!(raster.realized_colour(Colour::BLACK), Colour::BLACK);
    }

    #[test]
    fn what_cannot_be_drawn_is_replaced_by_what_is() {
        let mut vector = workstation(Classification::Vector, None);
        let line = |linetype, width, colour| LineBundle { linetype, width, colour };
        assert_eq!(vector.realized_line(line(99, 0.0, 60_000)), line(1, 3.0 * 0.1, 1));
        assert_eq!(vector.realized_line(line(2, 1e9, 2)), line(2, 200.0, 2));
        let marker = |kind, size, colour| MarkerBundle { kind, size, colour };
        assert_eq!(vector.realized_marker(marker(99, 0.0, 60_000)), marker(3, 0.5, 1));
        assert_eq!(vector.realized_marker(marker(5, 1e9, 2)), marker(5, 200.0, 2));
        let fill = |interior, style| FillBundle { interior, style, colour: 1 };
        let realized = vector.realized_fill(fill(InteriorStyle::Pattern, -5));
        assert_eq!(realized, fill(InteriorStyle::Pattern, 1));
        vector.tables_mut().patterns.clear();
        let realized = vector.realized_fill(fill(InteriorStyle::Pattern, 4));
        assert_eq!(realized, fill(InteriorStyle::Hollow, 4));
        let realized = vector.realized_fill(fill(InteriorStyle::Hatch, 77));
        assert_eq!(realized, fill(InteriorStyle::Hatch, -1));
    }

    #[test]
    fn text_is_realized_in_precision_stroke_and_with_pens_in_strokes() {
        let text = |font, precision| TextBundle { font, precision, expansion: 2.0, spacing: -1.0, colour: 4 };
        let vector = workstation(Classification::Vector, None);
        assert_eq!(vector.realized_text(text(-21, Precision::Char)), text(-21, Precision::Stroke));
        assert_eq!(vector.realized_text(text(0, Precision::String)), text(1, Precision::Stroke));
        let plotter = workstation(Classification::Vector, Some(3.0));
        let drawn = plotter.realized_text(text(-21, Precision::Char));
        assert!(matches!(font::face(drawn.font), Some(font::Face::Stroke(_))), "font {}", drawn.font);
        assert_eq!(plotter.realized_text(text(-4, Precision::Stroke)), text(-4, Precision::Stroke));
    }

    #[test]
    fn colours_are_rounded_on_raster_surfaces_only() {
        let odd = Colour::rgb(0.1, 0.5, 0.999);
        assert_eq!(workstation(Classification::Vector, None).realized_colour(odd), odd);
        let raster = workstation(Classification::Raster, None).realized_colour(odd);
        assert_eq!(raster, Colour::rgb(26.0 / 255.0, 128.0 / 255.0, 1.0));
    }
}
