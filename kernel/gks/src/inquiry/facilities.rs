//! Inquiries of the workstation description table: facilities for each primitive and predefined
//! representations.
//!
//! They read the description of a type as it is before a workstation of it is opened.

use crate::{Error, Function, Gks, Result};
use gks_pipeline::colour::Colour;
use gks_pipeline::generated::numbers::{self, Font, Hatch, Linetype, Marker};
use gks_pipeline::item::Cells;
use gks_pipeline::look::{FillBundle, InteriorStyle, LineBundle, MarkerBundle, Precision, TextBundle};
use gks_pipeline::lower;

/// A continuous range of lengths on the display surface, in metres.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct SizeRange {
    /// The length that scale factor 1 means.
    pub nominal: f64,
    /// The least length.
    pub least: f64,
    /// The greatest length.
    pub greatest: f64,
}

/// What polylines can look like.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct PolylineFacilities {
    /// The linetypes.
    pub linetypes: &'static [Linetype],
    /// The linewidths: any in this range.
    pub widths: SizeRange,
    /// The number of predefined polyline indices, which count from 1.
    pub predefined: usize,
}

/// What polymarkers can look like.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct PolymarkerFacilities {
    /// The marker types.
    pub markers: &'static [Marker],
    /// The marker sizes: any in this range.
    pub sizes: SizeRange,
    /// The number of predefined polymarker indices, which count from 1.
    pub predefined: usize,
}

/// What text can look like.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct TextFacilities {
    /// The fonts, each of which comes in every precision.
    pub fonts: &'static [Font],
    /// The least and the greatest useful character height, in metres: the resolution and the longer side of the
    /// display surface. Any height is drawn.
    pub heights: (f64, f64),
    /// The least and the greatest character expansion factor: any that is positive.
    pub expansions: (f64, f64),
    /// The number of predefined text indices, which count from 1.
    pub predefined: usize,
}

impl TextFacilities {
    /// The pairs of font and precision: for each font the precisions STRING, CHAR and STROKE.
    pub fn pairs(&self) -> impl ExactSizeIterator<Item = (i32, Precision)> + Clone + use<> {
        const PRECISIONS: [Precision; 3] = [Precision::String, Precision::Char, Precision::Stroke];
        let fonts = self.fonts;
        (0..fonts.len() * 3).map(move |i| (fonts[i / 3].number, PRECISIONS[i % 3]))
    }
}

/// What fill areas can look like.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct FillAreaFacilities {
    /// The interior styles.
    pub interior_styles: [InteriorStyle; 4],
    /// The hatch styles.
    pub hatches: &'static [Hatch],
    /// The number of predefined fill area indices, which count from 1.
    pub predefined: usize,
}

/// What colours there are.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct ColourFacilities {
    /// The number of colours that can be shown at the same time; 0 for a continuous range.
    pub colours: u32,
    /// Whether there are colours and not intensities of one colour only.
    pub coloured: bool,
    /// The number of predefined colour indices, which count from 0.
    pub predefined: usize,
}

/// The entry of a predefined table whose indices count from `first`, or error `invalid` for an index before
/// that and error `missing` for one without an entry.
fn predefined<B>(
    function: Function,
    table: &'static [B],
    first: i32,
    index: i32,
    [invalid, missing]: [i32; 2],
) -> Result<&'static B> {
    let place = index.checked_sub(first).and_then(|place| usize::try_from(place).ok());
    let place = place.ok_or_else(|| Error::new(invalid, function))?;
    table.get(place).ok_or_else(|| Error::new(missing, function))
}

/// The lengths in metres for a nominal one and a range of scale factors.
fn size_range(nominal: f64, (least, greatest): (f64, f64)) -> SizeRange {
    SizeRange { nominal, least: least * nominal, greatest: greatest * nominal }
}

impl Gks {
    /// INQUIRE POLYLINE FACILITIES. Errors: 8, 22, 23, 39.
    pub fn inquire_polyline_facilities(&self, kind: i32) -> Result<PolylineFacilities> {
        let surface = self.described(Function::InquirePolylineFacilities, kind)?.surface;
        Ok(PolylineFacilities {
            linetypes: numbers::LINETYPES,
            widths: size_range(surface.nominal_linewidth() * surface.unit, lower::line::range(&surface)),
            predefined: numbers::POLYLINE_BUNDLES.len(),
        })
    }

    /// INQUIRE PREDEFINED POLYLINE REPRESENTATION. Errors: 8, 22, 23, 39, 60 (index below 1), 62 (not
    /// predefined).
    pub fn inquire_predefined_polyline_representation(&self, kind: i32, index: i32) -> Result<LineBundle> {
        const F: Function = Function::InquirePredefinedPolylineRepresentation;
        self.described(F, kind)?;
        predefined(F, numbers::POLYLINE_BUNDLES, 1, index, [60, 62]).map(LineBundle::from)
    }

    /// INQUIRE POLYMARKER FACILITIES. Errors: 8, 22, 23, 39.
    pub fn inquire_polymarker_facilities(&self, kind: i32) -> Result<PolymarkerFacilities> {
        let surface = self.described(Function::InquirePolymarkerFacilities, kind)?.surface;
        Ok(PolymarkerFacilities {
            markers: numbers::MARKERS,
            sizes: size_range(surface.nominal_marker_size() * surface.unit, lower::marker::range(&surface)),
            predefined: numbers::POLYMARKER_BUNDLES.len(),
        })
    }

    /// INQUIRE PREDEFINED POLYMARKER REPRESENTATION. Errors: 8, 22, 23, 39, 66 (index below 1), 68 (not
    /// predefined).
    pub fn inquire_predefined_polymarker_representation(
        &self,
        kind: i32,
        index: i32,
    ) -> Result<MarkerBundle> {
        const F: Function = Function::InquirePredefinedPolymarkerRepresentation;
        self.described(F, kind)?;
        predefined(F, numbers::POLYMARKER_BUNDLES, 1, index, [66, 68]).map(MarkerBundle::from)
    }

    /// INQUIRE TEXT FACILITIES. Errors: 8, 22, 23, 39.
    pub fn inquire_text_facilities(&self, kind: i32) -> Result<TextFacilities> {
        let surface = self.described(Function::InquireTextFacilities, kind)?.surface;
        Ok(TextFacilities {
            fonts: numbers::FONTS,
            heights: (surface.resolution * surface.unit, surface.width.max(surface.height) * surface.unit),
            expansions: (0.0, f32::MAX.into()),
            predefined: numbers::TEXT_BUNDLES.len(),
        })
    }

    /// INQUIRE PREDEFINED TEXT REPRESENTATION. Errors: 8, 22, 23, 39, 72 (index below 1), 74 (not
    /// predefined).
    pub fn inquire_predefined_text_representation(&self, kind: i32, index: i32) -> Result<TextBundle> {
        const F: Function = Function::InquirePredefinedTextRepresentation;
        self.described(F, kind)?;
        predefined(F, numbers::TEXT_BUNDLES, 1, index, [72, 74]).map(TextBundle::from)
    }

    /// INQUIRE FILL AREA FACILITIES. Errors: 8, 22, 23, 39.
    pub fn inquire_fill_area_facilities(&self, kind: i32) -> Result<FillAreaFacilities> {
        use InteriorStyle::{Hatch, Hollow, Pattern, Solid};
        self.described(Function::InquireFillAreaFacilities, kind)?;
        Ok(FillAreaFacilities {
            interior_styles: [Hollow, Solid, Pattern, Hatch],
            hatches: numbers::HATCHES,
            predefined: numbers::FILL_AREA_BUNDLES.len(),
        })
    }

    /// INQUIRE PREDEFINED FILL AREA REPRESENTATION. Errors: 8, 22, 23, 39, 80 (index below 1), 82 (not
    /// predefined).
    pub fn inquire_predefined_fill_area_representation(&self, kind: i32, index: i32) -> Result<FillBundle> {
        const F: Function = Function::InquirePredefinedFillAreaRepresentation;
        self.described(F, kind)?;
        predefined(F, numbers::FILL_AREA_BUNDLES, 1, index, [80, 82]).map(FillBundle::from)
    }

    /// INQUIRE PATTERN FACILITIES: the number of predefined pattern indices, which count from 1.
    ///
    /// Errors: 8, 22, 23, 39.
    pub fn inquire_pattern_facilities(&self, kind: i32) -> Result<usize> {
        self.described(Function::InquirePatternFacilities, kind)?;
        Ok(numbers::PATTERNS.len())
    }

    /// INQUIRE PREDEFINED PATTERN REPRESENTATION: its cells, the upper row first. Errors: 8, 22, 23, 39, 85
    /// (index below 1), 89 (not predefined).
    pub fn inquire_predefined_pattern_representation(&self, kind: i32, index: i32) -> Result<Cells<'static>> {
        const F: Function = Function::InquirePredefinedPatternRepresentation;
        self.described(F, kind)?;
        let pattern = predefined(F, numbers::PATTERNS, 1, index, [85, 89])?;
        Cells::new(pattern.cells, pattern.columns, pattern.rows, pattern.columns)
            .ok_or_else(|| Error::new(89, F))
    }

    /// INQUIRE COLOUR FACILITIES. Errors: 8, 22, 23, 39.
    pub fn inquire_colour_facilities(&self, kind: i32) -> Result<ColourFacilities> {
        let description = self.described(Function::InquireColourFacilities, kind)?;
        Ok(ColourFacilities {
            colours: description.colours,
            coloured: !matches!(description.colours, 1 | 2),
            predefined: numbers::COLOURS.len().min(description.colour_table_length() as usize),
        })
    }

    /// INQUIRE PREDEFINED COLOUR REPRESENTATION. Errors: 8, 22, 23, 39, 93 (negative index), 95 (not
    /// predefined).
    pub fn inquire_predefined_colour_representation(&self, kind: i32, index: i32) -> Result<Colour> {
        const F: Function = Function::InquirePredefinedColourRepresentation;
        let length = self.described(F, kind)?.colour_table_length() as usize;
        let table = &numbers::COLOURS[..numbers::COLOURS.len().min(length)];
        let &[red, green, blue] = predefined(F, table, 0, index, [93, 95])?;
        Ok(Colour::rgb(red, green, blue))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{INDEXED, PLAIN, TRUE_COLOUR, number, open};

    #[test]
    fn facilities_are_lengths_on_the_surface_and_lists_of_types() {
        let (gks, _) = open(&[]);
        let near = |range: SizeRange, nominal: f64, least: f64, greatest: f64| {
            let is = [range.nominal, range.least, range.greatest];
            is.iter().zip([nominal, least, greatest]).all(|(a, b)| (a - b).abs() < 1e-12)
        };
        // 500 rows of 0.2 mm: the nominal linewidth is 1/1000 of the height, a tenth of a pixel is visible.
        let lines = gks.inquire_polyline_facilities(INDEXED).unwrap();
        assert!(near(lines.widths, 0.0001, 0.00002, 0.02), "{:?}", lines.widths);
        assert!((1..=4).all(|n| lines.linetypes.iter().any(|l| l.number == n)));
        assert_eq!(lines.predefined, 5);
        let markers = gks.inquire_polymarker_facilities(INDEXED).unwrap();
        assert!(near(markers.sizes, 0.0006, 0.0002, 0.12), "{:?}", markers.sizes);
        assert!((1..=5).all(|n| markers.markers.iter().any(|m| m.number == n)));
        assert_eq!(markers.predefined, 5);
        let text = gks.inquire_text_facilities(INDEXED).unwrap();
        assert!((text.heights.0 - 0.0002).abs() < 1e-12 && (text.heights.1 - 0.2).abs() < 1e-12);
        assert_eq!(text.pairs().len(), text.fonts.len() * 3);
        assert_eq!(text.pairs().take(2).collect::<Vec<_>>(), [(1, Precision::String), (1, Precision::Char)]);
        assert_eq!(text.pairs().last(), Some((-34, Precision::Stroke)));
        assert_eq!(text.predefined, 6);
        let fill = gks.inquire_fill_area_facilities(PLAIN).unwrap();
        assert!(fill.hatches.len() >= 3 && fill.interior_styles.contains(&InteriorStyle::Pattern));
        assert_eq!(fill.predefined, 5);
        assert_eq!(gks.inquire_pattern_facilities(PLAIN), Ok(10));
        let colours = gks.inquire_colour_facilities(TRUE_COLOUR).unwrap();
        assert_eq!((colours.colours, colours.coloured), (0, true));
        assert_eq!(gks.inquire_colour_facilities(INDEXED).unwrap().colours, 256);
    }

    #[test]
    fn the_lists_of_types_are_those_that_have_an_effect() {
        use gks_pipeline::{font, lower};
        let (gks, _) = open(&[]);
        let lines = gks.inquire_polyline_facilities(PLAIN).unwrap();
        assert!(lines.linetypes.iter().all(|l| l.number == 1 || !l.dashes.is_empty()));
        let asterisk = lower::marker::shape(3);
        let markers = gks.inquire_polymarker_facilities(PLAIN).unwrap().markers;
        assert!(markers.iter().all(|m| m.number == 3 || lower::marker::shape(m.number) != asterisk));
        let text = gks.inquire_text_facilities(PLAIN).unwrap();
        assert!(text.pairs().all(|(number, _)| font::face(number).is_some()));
    }

    #[test]
    fn predefined_representations_are_those_that_a_workstation_starts_with() {
        let (gks, _) = open(&[PLAIN, INDEXED]);
        for (id, kind) in [(1, PLAIN), (2, INDEXED)] {
            let tables = gks.workstations[&id].workstation.tables();
            for (&index, bundle) in &tables.lines {
                assert_eq!(gks.inquire_predefined_polyline_representation(kind, index as i32), Ok(*bundle));
            }
            for (&index, bundle) in &tables.markers {
                assert_eq!(gks.inquire_predefined_polymarker_representation(kind, index as i32), Ok(*bundle));
            }
            for (&index, bundle) in &tables.texts {
                assert_eq!(gks.inquire_predefined_text_representation(kind, index as i32), Ok(*bundle));
            }
            for (&index, bundle) in &tables.fills {
                assert_eq!(gks.inquire_predefined_fill_area_representation(kind, index as i32), Ok(*bundle));
            }
            for (&index, pattern) in &tables.patterns {
                let cells = gks.inquire_predefined_pattern_representation(kind, index as i32).unwrap();
                let rows: Vec<i32> = (0..cells.rows).flat_map(|row| cells.row(row).to_vec()).collect();
                assert_eq!((cells.columns, cells.rows), (pattern.columns, pattern.rows));
                assert_eq!(rows, pattern.indices);
            }
            for (index, colour) in tables.colours.iter() {
                assert_eq!(gks.inquire_predefined_colour_representation(kind, index as i32), Ok(colour));
            }
            let counts = [tables.lines.len(), tables.markers.len(), tables.texts.len(), tables.fills.len()];
            assert_eq!(counts, [5, 5, 6, 5]);
            assert_eq!(gks.inquire_colour_facilities(kind).unwrap().predefined, tables.colours.len());
        }
    }

    #[test]
    fn indices_that_are_not_predefined_are_refused() {
        let (gks, _) = open(&[]);
        for (index, errors) in
            [(0, [60, 66, 72, 80, 85]), (-1, [60, 66, 72, 80, 85]), (99, [62, 68, 74, 82, 89])]
        {
            assert_eq!(number(gks.inquire_predefined_polyline_representation(PLAIN, index)), errors[0]);
            assert_eq!(number(gks.inquire_predefined_polymarker_representation(PLAIN, index)), errors[1]);
            assert_eq!(number(gks.inquire_predefined_text_representation(PLAIN, index)), errors[2]);
            assert_eq!(number(gks.inquire_predefined_fill_area_representation(PLAIN, index)), errors[3]);
            assert_eq!(number(gks.inquire_predefined_pattern_representation(PLAIN, index)), errors[4]);
        }
        let colour = |index| number(gks.inquire_predefined_colour_representation(PLAIN, index));
        assert_eq!([-1, i32::MIN, i32::MAX].map(colour), [93, 93, 95]);
        assert_eq!(gks.inquire_predefined_colour_representation(PLAIN, 0), Ok(Colour::WHITE));
    }
}
