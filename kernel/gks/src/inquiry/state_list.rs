//! Inquiries of the GKS state list: workstations and current attributes.
//!
//! Those of normalization transformations and clipping stand with the functions that set them.

use super::inquiries;
use crate::{Function, Gks, Result};
use gks_geometry::{Point, Vector, Wc};
use gks_pipeline::look::{
    AspectSourceFlags, FillBundle, Horizontal, InteriorStyle, LineBundle, MarkerBundle, Precision,
    TextBundle, TextPath, Vertical,
};

/// The attributes that belong to no workstation: bundle indices and geometric attributes, in world coordinates.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct PrimitiveAttributes {
    /// Polyline index.
    pub polyline_index: i32,
    /// Polymarker index.
    pub polymarker_index: i32,
    /// Text index.
    pub text_index: i32,
    /// Character height, from base line to cap line.
    pub character_height: f64,
    /// Character up vector, as it was set.
    pub character_up: Vector<Wc>,
    /// Character width.
    pub character_width: f64,
    /// Character base vector, as long as the up vector.
    pub character_base: Vector<Wc>,
    /// Text path.
    pub text_path: TextPath,
    /// Text alignment.
    pub text_alignment: (Horizontal, Vertical),
    /// Fill area index.
    pub fill_area_index: i32,
    /// Pattern width vector.
    pub pattern_width: Vector<Wc>,
    /// Pattern height vector.
    pub pattern_height: Vector<Wc>,
    /// Pattern reference point.
    pub pattern_reference: Point<Wc>,
}

/// The attributes that take the place of bundled ones where an aspect source flag says INDIVIDUAL.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct IndividualAttributes {
    /// Linetype, linewidth scale factor and polyline colour index.
    pub polyline: LineBundle,
    /// Marker type, marker size scale factor and polymarker colour index.
    pub polymarker: MarkerBundle,
    /// Text font and precision, character expansion factor, character spacing and text colour index.
    pub text: TextBundle,
    /// Fill area interior style, style index and colour index.
    pub fill_area: FillBundle,
    /// Aspect source flags.
    pub sources: AspectSourceFlags,
}

inquiries! {
    /// INQUIRE CURRENT PRIMITIVE ATTRIBUTE VALUES. Error: 8.
    inquire_current_primitive_attribute_values -> PrimitiveAttributes, InquireCurrentPrimitiveAttributeValues
        => |gks| PrimitiveAttributes {
            polyline_index: gks.look.line_index as i32,
            polymarker_index: gks.look.marker_index as i32,
            text_index: gks.look.text_index as i32,
            character_height: gks.geometry.character_height,
            character_up: gks.geometry.character_up,
            character_width: gks.geometry.character_width,
            character_base: gks.geometry.character_base,
            text_path: gks.look.text_geometry.path,
            text_alignment: (gks.look.text_geometry.horizontal, gks.look.text_geometry.vertical),
            fill_area_index: gks.look.fill_index as i32,
            pattern_width: gks.geometry.pattern_width,
            pattern_height: gks.geometry.pattern_height,
            pattern_reference: gks.geometry.pattern_reference,
        };
    /// INQUIRE POLYLINE INDEX. Error: 8.
    inquire_polyline_index -> i32, InquirePolylineIndex => |gks| gks.look.line_index as i32;
    /// INQUIRE POLYMARKER INDEX. Error: 8.
    inquire_polymarker_index -> i32, InquirePolymarkerIndex => |gks| gks.look.marker_index as i32;
    /// INQUIRE TEXT INDEX. Error: 8.
    inquire_text_index -> i32, InquireTextIndex => |gks| gks.look.text_index as i32;
    /// INQUIRE CHARACTER HEIGHT, in world coordinates. Error: 8.
    inquire_character_height -> f64, InquireCharacterHeight => |gks| gks.geometry.character_height;
    /// INQUIRE CHARACTER UP VECTOR, as it was set, in world coordinates. Error: 8.
    inquire_character_up_vector -> Vector<Wc>, InquireCharacterUpVector => |gks| gks.geometry.character_up;
    /// INQUIRE CHARACTER WIDTH, in world coordinates: the character height, which sets both. Error: 8.
    inquire_character_width -> f64, InquireCharacterWidth => |gks| gks.geometry.character_width;
    /// INQUIRE CHARACTER BASE VECTOR, in world coordinates: the character up vector turned clockwise by a
    /// right angle. Error: 8.
    inquire_character_base_vector -> Vector<Wc>, InquireCharacterBaseVector => |gks| gks.geometry.character_base;
    /// INQUIRE TEXT PATH. Error: 8.
    inquire_text_path -> TextPath, InquireTextPath => |gks| gks.look.text_geometry.path;
    /// INQUIRE TEXT ALIGNMENT. Error: 8.
    inquire_text_alignment -> (Horizontal, Vertical), InquireTextAlignment
        => |gks| (gks.look.text_geometry.horizontal, gks.look.text_geometry.vertical);
    /// INQUIRE FILL AREA INDEX. Error: 8.
    inquire_fill_area_index -> i32, InquireFillAreaIndex => |gks| gks.look.fill_index as i32;
    /// INQUIRE PATTERN WIDTH VECTOR, in world coordinates. Error: 8.
    inquire_pattern_width_vector -> Vector<Wc>, InquirePatternWidthVector => |gks| gks.geometry.pattern_width;
    /// INQUIRE PATTERN HEIGHT VECTOR, in world coordinates. Error: 8.
    inquire_pattern_height_vector -> Vector<Wc>, InquirePatternHeightVector => |gks| gks.geometry.pattern_height;
    /// INQUIRE PATTERN REFERENCE POINT, in world coordinates. Error: 8.
    inquire_pattern_reference_point -> Point<Wc>, InquirePatternReferencePoint
        => |gks| gks.geometry.pattern_reference;
    /// INQUIRE CURRENT INDIVIDUAL ATTRIBUTE VALUES, and the aspect source flags. Error: 8.
    inquire_current_individual_attribute_values -> IndividualAttributes, InquireCurrentIndividualAttributeValues
        => |gks| IndividualAttributes {
            polyline: gks.look.line,
            polymarker: gks.look.marker,
            text: gks.look.text,
            fill_area: gks.look.fill,
            sources: gks.look.sources,
        };
    /// INQUIRE LINETYPE. Error: 8.
    inquire_linetype -> i32, InquireLinetype => |gks| gks.look.line.linetype;
    /// INQUIRE LINEWIDTH SCALE FACTOR. Error: 8.
    inquire_linewidth_scale_factor -> f64, InquireLinewidthScaleFactor => |gks| gks.look.line.width;
    /// INQUIRE POLYLINE COLOUR INDEX. Error: 8.
    inquire_polyline_colour_index -> i32, InquirePolylineColourIndex => |gks| gks.look.line.colour as i32;
    /// INQUIRE MARKER TYPE. Error: 8.
    inquire_marker_type -> i32, InquireMarkerType => |gks| gks.look.marker.kind;
    /// INQUIRE MARKER SIZE SCALE FACTOR. Error: 8.
    inquire_marker_size_scale_factor -> f64, InquireMarkerSizeScaleFactor => |gks| gks.look.marker.size;
    /// INQUIRE POLYMARKER COLOUR INDEX. Error: 8.
    inquire_polymarker_colour_index -> i32, InquirePolymarkerColourIndex => |gks| gks.look.marker.colour as i32;
    /// INQUIRE TEXT FONT AND PRECISION. Error: 8.
    inquire_text_font_and_precision -> (i32, Precision), InquireTextFontAndPrecision
        => |gks| (gks.look.text.font, gks.look.text.precision);
    /// INQUIRE CHARACTER EXPANSION FACTOR. Error: 8.
    inquire_character_expansion_factor -> f64, InquireCharacterExpansionFactor => |gks| gks.look.text.expansion;
    /// INQUIRE CHARACTER SPACING, in character heights. Error: 8.
    inquire_character_spacing -> f64, InquireCharacterSpacing => |gks| gks.look.text.spacing;
    /// INQUIRE TEXT COLOUR INDEX. Error: 8.
    inquire_text_colour_index -> i32, InquireTextColourIndex => |gks| gks.look.text.colour as i32;
    /// INQUIRE FILL AREA INTERIOR STYLE. Error: 8.
    inquire_fill_area_interior_style -> InteriorStyle, InquireFillAreaInteriorStyle
        => |gks| gks.look.fill.interior;
    /// INQUIRE FILL AREA STYLE INDEX. Error: 8.
    inquire_fill_area_style_index -> i32, InquireFillAreaStyleIndex => |gks| gks.look.fill.style;
    /// INQUIRE FILL AREA COLOUR INDEX. Error: 8.
    inquire_fill_area_colour_index -> i32, InquireFillAreaColourIndex => |gks| gks.look.fill.colour as i32;
    /// INQUIRE ASPECT SOURCE FLAGS. Error: 8.
    inquire_aspect_source_flags -> AspectSourceFlags, InquireAspectSourceFlags => |gks| gks.look.sources;
}

impl Gks {
    /// INQUIRE SET OF OPEN WORKSTATIONS: their identifiers, in increasing order. Error: 8.
    pub fn inquire_set_of_open_workstations(&self) -> Result<impl ExactSizeIterator<Item = i32> + Clone> {
        self.check_state(Function::InquireSetOfOpenWorkstations)?;
        Ok(self.workstations.keys().copied())
    }

    /// INQUIRE SET OF ACTIVE WORKSTATIONS: their identifiers, in increasing order. Error: 8.
    pub fn inquire_set_of_active_workstations(&self) -> Result<impl Iterator<Item = i32> + Clone> {
        self.check_state(Function::InquireSetOfActiveWorkstations)?;
        Ok(self.workstations.iter().filter(|(_, open)| open.active).map(|(&id, _)| id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{INDEXED, PLAIN, closed, number, open};

    /// All functions of this file, as `each`.
    macro_rules! for_all {
        ($gks:expr, $each:ident) => {{
            let gks = $gks;
            for_all!(gks, $each:
                inquire_current_primitive_attribute_values,
                inquire_polyline_index, inquire_polymarker_index, inquire_text_index, inquire_character_height,
                inquire_character_up_vector, inquire_character_width, inquire_character_base_vector,
                inquire_text_path, inquire_text_alignment, inquire_fill_area_index,
                inquire_pattern_width_vector, inquire_pattern_height_vector, inquire_pattern_reference_point,
                inquire_current_individual_attribute_values, inquire_linetype, inquire_linewidth_scale_factor,
                inquire_polyline_colour_index, inquire_marker_type, inquire_marker_size_scale_factor,
                inquire_polymarker_colour_index, inquire_text_font_and_precision,
                inquire_character_expansion_factor, inquire_character_spacing, inquire_text_colour_index,
                inquire_fill_area_interior_style, inquire_fill_area_style_index,
                inquire_fill_area_colour_index, inquire_aspect_source_flags, inquire_set_of_open_workstations,
                inquire_set_of_active_workstations)
        }};
        ($gks:ident, $each:ident: $($function:ident),+) => { [$($each($gks.$function().map(drop))),+] };
    }

    #[test]
    fn nothing_can_be_inquired_while_gks_is_closed() {
        assert_eq!(for_all!(closed(), number), [8; 31]);
        let is_ok = |result: Result<()>| result.is_ok();
        assert_eq!(for_all!(open(&[]).0, is_ok), [true; 31]);
    }

    #[test]
    fn attributes_start_as_the_state_list_says() {
        let (gks, _) = open(&[]);
        let start = PrimitiveAttributes {
            polyline_index: 1,
            polymarker_index: 1,
            text_index: 1,
            character_height: 0.01,
            character_up: Vector::new(0.0, 1.0),
            character_width: 0.01,
            character_base: Vector::new(1.0, 0.0),
            text_path: TextPath::Right,
            text_alignment: (Horizontal::Normal, Vertical::Normal),
            fill_area_index: 1,
            pattern_width: Vector::new(1.0, 0.0),
            pattern_height: Vector::new(0.0, 1.0),
            pattern_reference: Point::new(0.0, 0.0),
        };
        assert_eq!(gks.inquire_current_primitive_attribute_values(), Ok(start));
        let individual = IndividualAttributes {
            polyline: LineBundle { linetype: 1, width: 1.0, colour: 1 },
            polymarker: MarkerBundle { kind: 3, size: 1.0, colour: 1 },
            text: TextBundle {
                font: 1,
                precision: Precision::String,
                expansion: 1.0,
                spacing: 0.0,
                colour: 1,
            },
            fill_area: FillBundle { interior: InteriorStyle::Hollow, style: 1, colour: 1 },
            sources: AspectSourceFlags::INDIVIDUAL,
        };
        assert_eq!(gks.inquire_current_individual_attribute_values(), Ok(individual));
    }

    #[test]
    fn primitive_attributes_are_returned_one_by_one_and_together_as_they_were_set() {
        let (mut gks, _) = open(&[]);
        gks.set_window(1, (0.0, 100.0, 0.0, 10.0)).unwrap();
        gks.select_normalization_transformation(1).unwrap();
        gks.set_polyline_index(2).unwrap();
        gks.set_polymarker_index(3).unwrap();
        gks.set_text_index(4).unwrap();
        gks.set_character_height(2.5).unwrap();
        gks.set_character_up_vector((3.0, 4.0)).unwrap();
        gks.set_text_path(TextPath::Down).unwrap();
        gks.set_text_alignment(Horizontal::Centre, Vertical::Cap).unwrap();
        gks.set_fill_area_index(5).unwrap();
        gks.set_pattern_size(7.0, 8.0).unwrap();
        gks.set_pattern_reference_point((9.0, 10.0)).unwrap();
        let set = PrimitiveAttributes {
            polyline_index: 2,
            polymarker_index: 3,
            text_index: 4,
            character_height: 2.5,
            character_up: Vector::new(3.0, 4.0),
            character_width: 2.5,
            character_base: Vector::new(4.0, -3.0),
            text_path: TextPath::Down,
            text_alignment: (Horizontal::Centre, Vertical::Cap),
            fill_area_index: 5,
            pattern_width: Vector::new(7.0, 0.0),
            pattern_height: Vector::new(0.0, 8.0),
            pattern_reference: Point::new(9.0, 10.0),
        };
        assert_eq!(gks.inquire_current_primitive_attribute_values(), Ok(set));
        let split = PrimitiveAttributes {
            polyline_index: gks.inquire_polyline_index().unwrap(),
            polymarker_index: gks.inquire_polymarker_index().unwrap(),
            text_index: gks.inquire_text_index().unwrap(),
            character_height: gks.inquire_character_height().unwrap(),
            character_up: gks.inquire_character_up_vector().unwrap(),
            character_width: gks.inquire_character_width().unwrap(),
            character_base: gks.inquire_character_base_vector().unwrap(),
            text_path: gks.inquire_text_path().unwrap(),
            text_alignment: gks.inquire_text_alignment().unwrap(),
            fill_area_index: gks.inquire_fill_area_index().unwrap(),
            pattern_width: gks.inquire_pattern_width_vector().unwrap(),
            pattern_height: gks.inquire_pattern_height_vector().unwrap(),
            pattern_reference: gks.inquire_pattern_reference_point().unwrap(),
        };
        assert_eq!(split, set);
    }

    #[test]
    fn individual_attributes_are_returned_one_by_one_and_together_as_they_were_set() {
        let (mut gks, _) = open(&[]);
        let sources = AspectSourceFlags::from_array(std::array::from_fn(|i| i % 3 == 0));
        gks.set_linetype(-6).unwrap();
        gks.set_linewidth_scale_factor(2.0).unwrap();
        gks.set_polyline_colour_index(3).unwrap();
        gks.set_marker_type(-4).unwrap();
        gks.set_marker_size_scale_factor(5.0).unwrap();
        gks.set_polymarker_colour_index(6).unwrap();
        gks.set_text_font_and_precision(-7, Precision::Char).unwrap();
        gks.set_character_expansion_factor(8.0).unwrap();
        gks.set_character_spacing(-9.0).unwrap();
        gks.set_text_colour_index(10).unwrap();
        gks.set_fill_area_interior_style(InteriorStyle::Hatch).unwrap();
        gks.set_fill_area_style_index(-11).unwrap();
        gks.set_fill_area_colour_index(i32::MAX).unwrap();
        gks.set_aspect_source_flags(sources).unwrap();
        let set = IndividualAttributes {
            polyline: LineBundle { linetype: -6, width: 2.0, colour: 3 },
            polymarker: MarkerBundle { kind: -4, size: 5.0, colour: 6 },
            text: TextBundle {
                font: -7,
                precision: Precision::Char,
                expansion: 8.0,
                spacing: -9.0,
                colour: 10,
            },
            fill_area: FillBundle { interior: InteriorStyle::Hatch, style: -11, colour: i32::MAX as u32 },
            sources,
        };
        assert_eq!(gks.inquire_current_individual_attribute_values(), Ok(set));
        assert_eq!(gks.inquire_linetype(), Ok(-6));
        assert_eq!(gks.inquire_linewidth_scale_factor(), Ok(2.0));
        assert_eq!(gks.inquire_polyline_colour_index(), Ok(3));
        assert_eq!(gks.inquire_marker_type(), Ok(-4));
        assert_eq!(gks.inquire_marker_size_scale_factor(), Ok(5.0));
        assert_eq!(gks.inquire_polymarker_colour_index(), Ok(6));
        assert_eq!(gks.inquire_text_font_and_precision(), Ok((-7, Precision::Char)));
        assert_eq!(gks.inquire_character_expansion_factor(), Ok(8.0));
        assert_eq!(gks.inquire_character_spacing(), Ok(-9.0));
        assert_eq!(gks.inquire_text_colour_index(), Ok(10));
        assert_eq!(gks.inquire_fill_area_interior_style(), Ok(InteriorStyle::Hatch));
        assert_eq!(gks.inquire_fill_area_style_index(), Ok(-11));
        assert_eq!(gks.inquire_fill_area_colour_index(), Ok(i32::MAX));
        assert_eq!(gks.inquire_aspect_source_flags(), Ok(sources));
        gks.close_gks().unwrap();
        gks.open_gks().unwrap();
        assert_eq!(gks.inquire_linetype(), Ok(1));
    }

    #[test]
    fn open_and_active_workstations_are_listed() {
        let (mut gks, _) = open(&[PLAIN, INDEXED]);
        gks.open_workstation(7, "", PLAIN).unwrap();
        gks.activate_workstation(2).unwrap();
        let open = gks.inquire_set_of_open_workstations().unwrap();
        assert_eq!((open.len(), open.collect::<Vec<_>>()), (3, vec![1, 2, 7]));
        assert_eq!(gks.inquire_set_of_active_workstations().unwrap().collect::<Vec<_>>(), [2]);
        gks.activate_workstation(1).unwrap();
        gks.close_workstation(7).unwrap();
        assert_eq!(gks.inquire_set_of_open_workstations().unwrap().collect::<Vec<_>>(), [1, 2]);
        assert_eq!(gks.inquire_set_of_active_workstations().unwrap().collect::<Vec<_>>(), [1, 2]);
    }
}
