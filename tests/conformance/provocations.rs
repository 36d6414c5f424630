//! Calls with one wrong argument, and the errors that they meet.
//!
//! Errors that the workstation or its type is to blame for are provoked for all functions at once.

use gks::CoordinateSwitch::Ndc;
use gks::Function::*;
use gks::{DataRecord, Function, Gks, Points, RelativePriority, Result, ValueType};
use gks_pipeline::generated::numbers;
use gks_pipeline::item::Cells;
use gks_pipeline::look::{InteriorStyle, Precision};
use std::f64::consts::PI;

/// A call that meets an error, in the state WSAC.
pub(crate) struct Provocation {
    /// The function called.
    pub(crate) function: Function,
    /// The error it meets.
    pub(crate) error: i32,
    /// The workstation or the type that the call is about; `None` for that of the sample call.
    pub(crate) subject: Option<i32>,
    /// What has to be done before.
    pub(crate) before: fn(&mut Gks),
    /// The call.
    pub(crate) call: Call,
}

/// A call about a workstation or a workstation type.
pub(crate) type Call = fn(&mut Gks, i32) -> Result<()>;

impl Provocation {
    pub(crate) const fn about(self, subject: i32) -> Provocation {
        Provocation { subject: Some(subject), ..self }
    }

    pub(crate) const fn after(self, before: fn(&mut Gks)) -> Provocation {
        Provocation { before, ..self }
    }
}

/// The call that meets an error, about the workstation or the type of the sample call.
pub(crate) const fn meets(error: i32, function: Function, call: Call) -> Provocation {
    Provocation { function, error, subject: None, before: |_| {}, call }
}

/// Opens workstations until no more can be opened.
fn open_all(gks: &mut Gks) {
    let last = (100..).find(|&id| gks.open_workstation(id, "", super::catalogue::NULL).is_err());
    assert!(last.is_some_and(|id| id < 200));
}

const NAN: f64 = f64::NAN;
const INFINITY: f64 = f64::INFINITY;
const UNIT: (f64, f64, f64, f64) = (0.0, 1.0, 0.0, 1.0);
const FLAT: (f64, f64, f64, f64) = (0.0, 1.0, 0.5, 0.5);
const NO_POINT: Points<'static> = Points::Tuples(&[]);
const ONE_POINT: Points<'static> = Points::Tuples(&[(0.5, 0.5)]);
const TWO_POINTS: Points<'static> = Points::Tuples(&[(0.5, 0.5), (0.7, 0.5)]);
/// A matrix whose products overflow.
const HUGE: [[f64; 3]; 2] = [[f64::MAX, 0.0, 0.0], [0.0, f64::MAX, 0.0]];
/// The first colour index beyond the table of a workstation with a continuous range of colours.
const BEYOND: i32 = numbers::MAX_COLOURS as i32;
/// An index beyond all tables of bundles and patterns.
const FAR: i32 = 1_000_000;

fn record(integers: &[i32], reals: &[f64]) -> DataRecord {
    DataRecord::new(integers, reals, &[])
}

fn cells(index: &[i32]) -> Cells<'_> {
    Cells::new(index, 1, 1, 1).expect("one cell is an array")
}

/// Wrong arguments. Numbers from 300 on are not in the table: the standard allows them everywhere.
pub(crate) static PROVOCATIONS: &[Provocation] = &[
    // Control.
    meets(21, OpenWorkstation, |g, id| g.open_workstation(id, "?nonsense=1", 900)),
    meets(22, OpenWorkstation, |g, id| g.open_workstation(id, "", -1)),
    meets(23, OpenWorkstation, |g, id| g.open_workstation(id, "", 12_345)),
    meets(26, OpenWorkstation, |g, id| g.open_workstation(id, "/no such folder/picture.png", 100)),
    meets(42, OpenWorkstation, |g, id| g.open_workstation(id, "", 900)).after(open_all),
    meets(180, Escape, |g, _| g.escape(-1, &DataRecord::default()).map(drop)),
    meets(180, Escape, |g, _| g.escape(i32::MAX, &DataRecord::default()).map(drop)),
    meets(181, Escape, |g, _| g.escape(0, &DataRecord::default()).map(drop)),
    meets(182, Escape, |g, _| g.escape(-3001, &DataRecord::default()).map(drop)),
    meets(182, Escape, |g, _| g.escape(-3001, &record(&[9], &[])).map(drop)),
    meets(182, Escape, |g, _| g.escape(-3002, &record(&[-1], &[])).map(drop)),
    meets(182, Escape, |g, _| g.escape(-3003, &record(&[1, 1], &[2.0])).map(drop)),
    meets(182, Escape, |g, _| g.escape(-3003, &record(&[99, 1], &[1.0])).map(drop)),
    meets(182, Escape, |g, _| g.escape(-3004, &record(&[1, 2], &[])).map(drop)),
    meets(182, Escape, |g, _| g.escape(-3005, &record(&[0], &[])).map(drop)),
    // Output.
    meets(100, Polyline, |g, _| g.polyline(NO_POINT)),
    meets(100, Polyline, |g, _| g.polyline(ONE_POINT)),
    meets(100, Polymarker, |g, _| g.polymarker(NO_POINT)),
    meets(100, FillArea, |g, _| g.fill_area(TWO_POINTS)),
    meets(91, CellArray, |g, _| g.cell_array_of((0.0, 0.0), (1.0, 1.0), &[0], 0, 1, 1)),
    meets(91, CellArray, |g, _| g.cell_array_of((0.0, 0.0), (1.0, 1.0), &[0], 1, 0, 1)),
    meets(91, CellArray, |g, _| g.cell_array_of((0.0, 0.0), (1.0, 1.0), &[0], 1, 2, 1)),
    meets(91, CellArray, |g, _| g.cell_array_of((0.0, 0.0), (1.0, 1.0), &[0, 1], 2, 1, 1)),
    meets(100, GeneralizedDrawingPrimitive, |g, _| {
        g.generalized_drawing_primitive(ONE_POINT, -4, &DataRecord::default())
    }),
    meets(102, GeneralizedDrawingPrimitive, |g, _| {
        g.generalized_drawing_primitive(TWO_POINTS, 0, &DataRecord::default())
    }),
    meets(104, GeneralizedDrawingPrimitive, |g, _| {
        g.generalized_drawing_primitive(TWO_POINTS, -999, &DataRecord::default())
    }),
    // Attributes.
    meets(60, SetPolylineIndex, |g, _| g.set_polyline_index(0)),
    meets(60, SetPolylineIndex, |g, _| g.set_polyline_index(-1)),
    meets(63, SetLinetype, |g, _| g.set_linetype(0)),
    meets(65, SetLinewidthScaleFactor, |g, _| g.set_linewidth_scale_factor(-0.5)),
    meets(65, SetLinewidthScaleFactor, |g, _| g.set_linewidth_scale_factor(NAN)),
    meets(92, SetPolylineColourIndex, |g, _| g.set_polyline_colour_index(-1)),
    meets(66, SetPolymarkerIndex, |g, _| g.set_polymarker_index(0)),
    meets(69, SetMarkerType, |g, _| g.set_marker_type(0)),
    meets(71, SetMarkerSizeScaleFactor, |g, _| g.set_marker_size_scale_factor(-0.5)),
    meets(71, SetMarkerSizeScaleFactor, |g, _| g.set_marker_size_scale_factor(INFINITY)),
    meets(92, SetPolymarkerColourIndex, |g, _| g.set_polymarker_colour_index(-1)),
    meets(72, SetTextIndex, |g, _| g.set_text_index(0)),
    meets(75, SetTextFontAndPrecision, |g, _| g.set_text_font_and_precision(0, Precision::Char)),
    meets(77, SetCharacterExpansionFactor, |g, _| g.set_character_expansion_factor(0.0)),
    meets(77, SetCharacterExpansionFactor, |g, _| g.set_character_expansion_factor(NAN)),
    meets(308, SetCharacterSpacing, |g, _| g.set_character_spacing(NAN)),
    meets(92, SetTextColourIndex, |g, _| g.set_text_colour_index(-1)),
    meets(78, SetCharacterHeight, |g, _| g.set_character_height(0.0)),
    meets(78, SetCharacterHeight, |g, _| g.set_character_height(NAN)),
    meets(79, SetCharacterUpVector, |g, _| g.set_character_up_vector((0.0, 0.0))),
    meets(79, SetCharacterUpVector, |g, _| g.set_character_up_vector((NAN, 1.0))),
    meets(80, SetFillAreaIndex, |g, _| g.set_fill_area_index(0)),
    meets(84, SetFillAreaStyleIndex, |g, _| g.set_fill_area_style_index(0)),
    meets(92, SetFillAreaColourIndex, |g, _| g.set_fill_area_colour_index(-1)),
    meets(87, SetPatternSize, |g, _| g.set_pattern_size(0.0, 1.0)),
    meets(87, SetPatternSize, |g, _| g.set_pattern_size(1.0, -1.0)),
    meets(308, SetPatternReferencePoint, |g, _| g.set_pattern_reference_point((NAN, 0.0))),
    // Representations.
    meets(60, SetPolylineRepresentation, |g, id| g.set_polyline_representation(id, 0, 1, 1.0, 1)),
    meets(60, SetPolylineRepresentation, |g, id| g.set_polyline_representation(id, FAR, 1, 1.0, 1)),
    meets(63, SetPolylineRepresentation, |g, id| g.set_polyline_representation(id, 1, 0, 1.0, 1)),
    meets(64, SetPolylineRepresentation, |g, id| g.set_polyline_representation(id, 1, 999, 1.0, 1)),
    meets(65, SetPolylineRepresentation, |g, id| g.set_polyline_representation(id, 1, 1, -1.0, 1)),
    meets(93, SetPolylineRepresentation, |g, id| g.set_polyline_representation(id, 1, 1, 1.0, -1)),
    meets(93, SetPolylineRepresentation, |g, id| g.set_polyline_representation(id, 1, 1, 1.0, BEYOND)),
    meets(66, SetPolymarkerRepresentation, |g, id| g.set_polymarker_representation(id, 0, 3, 1.0, 1)),
    meets(66, SetPolymarkerRepresentation, |g, id| g.set_polymarker_representation(id, FAR, 3, 1.0, 1)),
    meets(69, SetPolymarkerRepresentation, |g, id| g.set_polymarker_representation(id, 1, 0, 1.0, 1)),
    meets(70, SetPolymarkerRepresentation, |g, id| g.set_polymarker_representation(id, 1, 999, 1.0, 1)),
    meets(71, SetPolymarkerRepresentation, |g, id| g.set_polymarker_representation(id, 1, 3, NAN, 1)),
    meets(93, SetPolymarkerRepresentation, |g, id| g.set_polymarker_representation(id, 1, 3, 1.0, -1)),
    meets(72, SetTextRepresentation, |g, id| text(g, id, 0, 1, 1.0, 0.0, 1)),
    meets(72, SetTextRepresentation, |g, id| text(g, id, FAR, 1, 1.0, 0.0, 1)),
    meets(75, SetTextRepresentation, |g, id| text(g, id, 1, 0, 1.0, 0.0, 1)),
    meets(76, SetTextRepresentation, |g, id| text(g, id, 1, 999, 1.0, 0.0, 1)),
    meets(77, SetTextRepresentation, |g, id| text(g, id, 1, 1, 0.0, 0.0, 1)),
    meets(93, SetTextRepresentation, |g, id| text(g, id, 1, 1, 1.0, 0.0, -1)),
    meets(308, SetTextRepresentation, |g, id| text(g, id, 1, 1, 1.0, NAN, 1)),
    meets(80, SetFillAreaRepresentation, |g, id| fill(g, id, 0, InteriorStyle::Solid, 1, 1)),
    meets(80, SetFillAreaRepresentation, |g, id| fill(g, id, FAR, InteriorStyle::Solid, 1, 1)),
    meets(85, SetFillAreaRepresentation, |g, id| fill(g, id, 1, InteriorStyle::Pattern, 0, 1)),
    meets(86, SetFillAreaRepresentation, |g, id| fill(g, id, 1, InteriorStyle::Hatch, 999, 1)),
    meets(86, SetFillAreaRepresentation, |g, id| fill(g, id, 1, InteriorStyle::Hatch, 0, 1)),
    meets(93, SetFillAreaRepresentation, |g, id| fill(g, id, 1, InteriorStyle::Hollow, 0, -1)),
    meets(85, SetPatternRepresentation, |g, id| g.set_pattern_representation(id, 0, &cells(&[1]))),
    meets(85, SetPatternRepresentation, |g, id| g.set_pattern_representation(id, FAR, &cells(&[1]))),
    meets(91, SetPatternRepresentation, |g, id| g.set_pattern_representation_of(id, 1, &[1], 1, 2, 1)),
    meets(91, SetPatternRepresentation, |g, id| g.set_pattern_representation_of(id, 1, &[1], 0, 1, 1)),
    meets(93, SetPatternRepresentation, |g, id| g.set_pattern_representation(id, 1, &cells(&[-1]))),
    meets(93, SetColourRepresentation, |g, id| g.set_colour_representation(id, -1, (0.0, 0.0, 0.0))),
    meets(93, SetColourRepresentation, |g, id| g.set_colour_representation(id, BEYOND, (0.0, 0.0, 0.0))),
    meets(93, SetColourRepresentation, |g, id| g.set_colour_representation(id, 256, (0.0, 0.0, 0.0)))
        .about(super::situation::COLOUR_TABLE),
    meets(96, SetColourRepresentation, |g, id| g.set_colour_representation(id, 1, (0.0, 1.1, 0.0))),
    meets(96, SetColourRepresentation, |g, id| g.set_colour_representation(id, 1, (0.0, 0.0, NAN))),
    // Transformations.
    meets(50, SetWindow, |g, _| g.set_window(0, UNIT)),
    meets(50, SetWindow, |g, _| g.set_window(FAR, UNIT)),
    meets(51, SetWindow, |g, _| g.set_window(1, FLAT)),
    meets(51, SetWindow, |g, _| g.set_window(1, (0.0, INFINITY, 0.0, 1.0))),
    meets(50, SetViewport, |g, _| g.set_viewport(0, UNIT)),
    meets(51, SetViewport, |g, _| g.set_viewport(1, FLAT)),
    meets(52, SetViewport, |g, _| g.set_viewport(1, (0.0, 1.1, 0.0, 1.0))),
    meets(50, SetViewportInputPriority, |g, _| g.set_viewport_input_priority(-1, 0, RelativePriority::Lower)),
    meets(50, SetViewportInputPriority, |g, _| {
        g.set_viewport_input_priority(0, FAR, RelativePriority::Lower)
    }),
    meets(50, SelectNormalizationTransformation, |g, _| g.select_normalization_transformation(-1)),
    meets(50, SelectNormalizationTransformation, |g, _| g.select_normalization_transformation(FAR)),
    meets(51, SetWorkstationWindow, |g, id| g.set_workstation_window(id, FLAT)),
    meets(53, SetWorkstationWindow, |g, id| g.set_workstation_window(id, (0.0, 1.1, 0.0, 1.0))),
    meets(51, SetWorkstationViewport, |g, id| g.set_workstation_viewport(id, FLAT)),
    meets(54, SetWorkstationViewport, |g, id| g.set_workstation_viewport(id, (0.0, 9.0, 0.0, 9.0))),
    meets(308, EvaluateTransformationMatrix, |g, _| {
        g.evaluate_transformation_matrix((0.0, 0.0), (0.0, 0.0), NAN, (1.0, 1.0), Ndc).map(drop)
    }),
    meets(308, AccumulateTransformationMatrix, |g, _| {
        g.accumulate_transformation_matrix(HUGE, (0.0, 0.0), (0.0, 0.0), PI, (9.0, 9.0), Ndc).map(drop)
    }),
    // Inquiries.
    meets(50, InquireNormalizationTransformation, |g, _| {
        g.inquire_normalization_transformation(-1).map(drop)
    }),
    meets(50, InquireNormalizationTransformation, |g, _| {
        g.inquire_normalization_transformation(FAR).map(drop)
    }),
    meets(60, InquirePolylineRepresentation, |g, id| {
        g.inquire_polyline_representation(id, 0, ValueType::Set).map(drop)
    }),
    meets(61, InquirePolylineRepresentation, |g, id| {
        g.inquire_polyline_representation(id, 999, ValueType::Set).map(drop)
    }),
    meets(66, InquirePolymarkerRepresentation, |g, id| {
        g.inquire_polymarker_representation(id, -1, ValueType::Set).map(drop)
    }),
    meets(67, InquirePolymarkerRepresentation, |g, id| {
        g.inquire_polymarker_representation(id, 999, ValueType::Set).map(drop)
    }),
    meets(72, InquireTextRepresentation, |g, id| {
        g.inquire_text_representation(id, 0, ValueType::Set).map(drop)
    }),
    meets(73, InquireTextRepresentation, |g, id| {
        g.inquire_text_representation(id, 999, ValueType::Set).map(drop)
    }),
    meets(80, InquireFillAreaRepresentation, |g, id| {
        g.inquire_fill_area_representation(id, 0, ValueType::Set).map(drop)
    }),
    meets(81, InquireFillAreaRepresentation, |g, id| {
        g.inquire_fill_area_representation(id, 999, ValueType::Set).map(drop)
    }),
    meets(85, InquirePatternRepresentation, |g, id| {
        g.inquire_pattern_representation(id, 0, ValueType::Set).map(drop)
    }),
    meets(88, InquirePatternRepresentation, |g, id| {
        g.inquire_pattern_representation(id, 999, ValueType::Set).map(drop)
    }),
    meets(93, InquireColourRepresentation, |g, id| {
        g.inquire_colour_representation(id, -1, ValueType::Set).map(drop)
    }),
    meets(94, InquireColourRepresentation, |g, id| {
        g.inquire_colour_representation(id, 999, ValueType::Set).map(drop)
    }),
    meets(91, InquirePixelArray, |g, id| g.inquire_pixel_array(id, (0.0, 1.0), 0, 1).map(drop)),
    meets(91, InquirePixelArray, |g, id| g.inquire_pixel_array(id, (0.0, 1.0), 1, 0).map(drop)),
    meets(91, InquirePixelArray, |g, id| {
        g.inquire_pixel_array_into(id, (0.0, 1.0), 2, 2, 2, &mut [0; 3]).map(drop)
    }),
    meets(300, InquirePixelArray, |g, id| {
        g.inquire_pixel_array(id, (0.0, 1.0), usize::MAX, usize::MAX).map(drop)
    }),
    meets(60, InquirePredefinedPolylineRepresentation, |g, kind| {
        g.inquire_predefined_polyline_representation(kind, 0).map(drop)
    }),
    meets(62, InquirePredefinedPolylineRepresentation, |g, kind| {
        g.inquire_predefined_polyline_representation(kind, 999).map(drop)
    }),
    meets(66, InquirePredefinedPolymarkerRepresentation, |g, kind| {
        g.inquire_predefined_polymarker_representation(kind, 0).map(drop)
    }),
    meets(68, InquirePredefinedPolymarkerRepresentation, |g, kind| {
        g.inquire_predefined_polymarker_representation(kind, 999).map(drop)
    }),
    meets(72, InquirePredefinedTextRepresentation, |g, kind| {
        g.inquire_predefined_text_representation(kind, i32::MIN).map(drop)
    }),
    meets(74, InquirePredefinedTextRepresentation, |g, kind| {
        g.inquire_predefined_text_representation(kind, i32::MAX).map(drop)
    }),
    meets(80, InquirePredefinedFillAreaRepresentation, |g, kind| {
        g.inquire_predefined_fill_area_representation(kind, 0).map(drop)
    }),
    meets(82, InquirePredefinedFillAreaRepresentation, |g, kind| {
        g.inquire_predefined_fill_area_representation(kind, 999).map(drop)
    }),
    meets(85, InquirePredefinedPatternRepresentation, |g, kind| {
        g.inquire_predefined_pattern_representation(kind, 0).map(drop)
    }),
    meets(89, InquirePredefinedPatternRepresentation, |g, kind| {
        g.inquire_predefined_pattern_representation(kind, 999).map(drop)
    }),
    meets(93, InquirePredefinedColourRepresentation, |g, kind| {
        g.inquire_predefined_colour_representation(kind, -1).map(drop)
    }),
    meets(95, InquirePredefinedColourRepresentation, |g, kind| {
        g.inquire_predefined_colour_representation(kind, 70_000).map(drop)
    }),
    meets(41, InquireGeneralizedDrawingPrimitive, |g, kind| {
        g.inquire_generalized_drawing_primitive(kind, -999).map(drop)
    }),
    meets(102, InquireGeneralizedDrawingPrimitive, |g, kind| {
        g.inquire_generalized_drawing_primitive(kind, 0).map(drop)
    }),
];

/// A call with several wrong arguments.
pub(crate) struct Several {
    /// The function called.
    pub(crate) function: Function,
    /// The errors that apply.
    pub(crate) errors: &'static [i32],
    /// The call, about workstation [`super::situation::ACTIVE`].
    pub(crate) call: fn(&mut Gks) -> Result<()>,
}

const fn several(function: Function, errors: &'static [i32], call: fn(&mut Gks) -> Result<()>) -> Several {
    Several { function, errors, call }
}

/// Several wrong arguments at once. Those of the workstation are combined with all provocations anyway.
pub(crate) static SEVERAL: &[Several] = &[
    several(OpenWorkstation, &[20, 22], |g| g.open_workstation(0, "?nonsense=1", -1)),
    several(OpenWorkstation, &[20, 21], |g| g.open_workstation(0, "?nonsense=1", 900)),
    several(OpenWorkstation, &[22, 24], |g| g.open_workstation(1, "", -1)),
    several(OpenWorkstation, &[23, 24], |g| g.open_workstation(1, "", 12_345)),
    several(OpenWorkstation, &[24, 26], |g| g.open_workstation(1, "/no such folder/picture.png", 100)),
    several(OpenWorkstation, &[21, 26], |g| g.open_workstation(3, "/no such folder/a.png?nonsense=1", 100)),
    several(OpenWorkstation, &[24, 42], |g| {
        open_all(g);
        g.open_workstation(1, "", 900)
    }),
    several(OpenWorkstation, &[23, 42], |g| {
        open_all(g);
        g.open_workstation(3, "", 12_345)
    }),
    several(OpenWorkstation, &[21, 42], |g| {
        open_all(g);
        g.open_workstation(3, "?nonsense=1", 900)
    }),
    several(GeneralizedDrawingPrimitive, &[100, 102], |g| {
        g.generalized_drawing_primitive(NO_POINT, 0, &DataRecord::default())
    }),
    several(GeneralizedDrawingPrimitive, &[100, 104], |g| {
        g.generalized_drawing_primitive(NO_POINT, -999, &DataRecord::default())
    }),
    several(SetPolylineRepresentation, &[60, 63, 65, 93], |g| {
        g.set_polyline_representation(1, 0, 0, -1.0, -1)
    }),
    several(SetPolylineRepresentation, &[60, 64, 65, 93], |g| {
        g.set_polyline_representation(1, FAR, 999, NAN, BEYOND)
    }),
    several(SetPolylineRepresentation, &[63, 65, 93], |g| g.set_polyline_representation(1, 1, 0, -1.0, -1)),
    several(SetPolylineRepresentation, &[64, 65, 93], |g| g.set_polyline_representation(1, 1, 999, -1.0, -1)),
    several(SetPolylineRepresentation, &[65, 93], |g| g.set_polyline_representation(1, 1, 1, -1.0, -1)),
    several(SetPolymarkerRepresentation, &[66, 69, 71, 93], |g| {
        g.set_polymarker_representation(1, 0, 0, -1.0, -1)
    }),
    several(SetPolymarkerRepresentation, &[69, 71, 93], |g| {
        g.set_polymarker_representation(1, 1, 0, -1.0, -1)
    }),
    several(SetPolymarkerRepresentation, &[70, 71, 93], |g| {
        g.set_polymarker_representation(1, 1, 999, -1.0, -1)
    }),
    several(SetPolymarkerRepresentation, &[71, 93], |g| g.set_polymarker_representation(1, 1, 1, -1.0, -1)),
    several(SetTextRepresentation, &[72, 75, 77, 93], |g| text(g, 1, 0, 0, 0.0, NAN, -1)),
    several(SetTextRepresentation, &[75, 77, 93], |g| text(g, 1, 1, 0, 0.0, NAN, -1)),
    several(SetTextRepresentation, &[76, 77, 93], |g| text(g, 1, 1, 999, 0.0, NAN, -1)),
    several(SetTextRepresentation, &[77, 93], |g| text(g, 1, 1, 1, 0.0, NAN, -1)),
    several(SetTextRepresentation, &[93], |g| text(g, 1, 1, 1, 1.0, NAN, -1)),
    several(SetFillAreaRepresentation, &[80, 85, 93], |g| fill(g, 1, 0, InteriorStyle::Pattern, 0, -1)),
    several(SetFillAreaRepresentation, &[85, 93], |g| fill(g, 1, 1, InteriorStyle::Pattern, 0, -1)),
    several(SetFillAreaRepresentation, &[86, 93], |g| fill(g, 1, 1, InteriorStyle::Hatch, 0, -1)),
    several(SetPatternRepresentation, &[85, 91], |g| g.set_pattern_representation_of(1, 0, &[-1], 1, 2, 1)),
    several(SetPatternRepresentation, &[85, 93], |g| g.set_pattern_representation(1, 0, &cells(&[-1]))),
    several(SetPatternRepresentation, &[91, 93], |g| g.set_pattern_representation_of(1, 1, &[-1], 1, 2, 1)),
    several(SetColourRepresentation, &[93, 96], |g| g.set_colour_representation(1, -1, (NAN, 0.0, 0.0))),
    several(SetWindow, &[50, 51], |g| g.set_window(0, FLAT)),
    several(SetViewport, &[50, 51], |g| g.set_viewport(0, FLAT)),
    several(SetViewport, &[50, 52], |g| g.set_viewport(0, (0.0, 2.0, 0.0, 1.0))),
    several(SetViewport, &[51, 52], |g| g.set_viewport(1, (2.0, 2.0, 0.0, 1.0))),
    several(SetWorkstationWindow, &[51, 53], |g| g.set_workstation_window(1, (2.0, 2.0, 0.0, 1.0))),
    several(SetWorkstationViewport, &[51, 54], |g| g.set_workstation_viewport(1, (9.0, 9.0, 0.0, 1.0))),
];

fn text(
    g: &mut Gks,
    id: i32,
    index: i32,
    font: i32,
    expansion: f64,
    spacing: f64,
    colour: i32,
) -> Result<()> {
    g.set_text_representation(id, index, font, Precision::Stroke, expansion, spacing, colour)
}

fn fill(g: &mut Gks, id: i32, index: i32, interior: InteriorStyle, style: i32, colour: i32) -> Result<()> {
    g.set_fill_area_representation(id, index, interior, style, colour)
}
