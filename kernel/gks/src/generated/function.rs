//! The functions of GKS, their operating states, levels, errors and names in the bindings.
//!
//! Written by `gks-spec generate` from `spec/gks/functions.toml`; do not edit.

/// The operating state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum OperatingState {
    /// GGKCL.
    Gkcl = 0,
    /// GGKOP.
    Gkop = 1,
    /// GWSOP.
    Wsop = 2,
    /// GWSAC.
    Wsac = 3,
    /// GSGOP.
    Sgop = 4,
}

/// The level of GKS.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Level {
    /// GL0A.
    L0a = 0,
    /// GL0B.
    L0b = 1,
    /// GL0C.
    L0c = 2,
    /// GL1A.
    L1a = 3,
    /// GL1B.
    L1b = 4,
    /// GL1C.
    L1c = 5,
    /// GL2A.
    L2a = 6,
    /// GL2B.
    L2b = 7,
    /// GL2C.
    L2c = 8,
}

/// A set of operating states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StateMask(u8);

impl StateMask {
    /// Whether `state` is one of the set.
    #[must_use]
    pub const fn contains(self, state: OperatingState) -> bool {
        self.0 & (1 << state as u8) != 0
    }
}

impl Level {
    /// The output level, 0 to 2.
    #[must_use]
    pub const fn output(self) -> u8 {
        self as u8 / 3
    }

    /// The input level: 0 for a, 1 for b, 2 for c.
    #[must_use]
    pub const fn input(self) -> u8 {
        self as u8 % 3
    }

    /// Whether an implementation of this level has the functions of level `other`.
    #[must_use]
    pub const fn includes(self, other: Self) -> bool {
        self.output() >= other.output() && self.input() >= other.input()
    }
}

/// A function of GKS or of one of its language bindings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Function {
    /// OPEN GKS.
    OpenGks,
    /// CLOSE GKS.
    CloseGks,
    /// OPEN WORKSTATION.
    OpenWorkstation,
    /// CLOSE WORKSTATION.
    CloseWorkstation,
    /// ACTIVATE WORKSTATION.
    ActivateWorkstation,
    /// DEACTIVATE WORKSTATION.
    DeactivateWorkstation,
    /// CLEAR WORKSTATION.
    ClearWorkstation,
    /// REDRAW ALL SEGMENTS ON WORKSTATION.
    RedrawAllSegmentsOnWorkstation,
    /// UPDATE WORKSTATION.
    UpdateWorkstation,
    /// SET DEFERRAL STATE.
    SetDeferralState,
    /// MESSAGE.
    Message,
    /// ESCAPE.
    Escape,
    /// POLYLINE.
    Polyline,
    /// POLYMARKER.
    Polymarker,
    /// TEXT.
    Text,
    /// FILL AREA.
    FillArea,
    /// CELL ARRAY.
    CellArray,
    /// GENERALIZED DRAWING PRIMITIVE.
    GeneralizedDrawingPrimitive,
    /// SET POLYLINE INDEX.
    SetPolylineIndex,
    /// SET LINETYPE.
    SetLinetype,
    /// SET LINEWIDTH SCALE FACTOR.
    SetLinewidthScaleFactor,
    /// SET POLYLINE COLOUR INDEX.
    SetPolylineColourIndex,
    /// SET POLYMARKER INDEX.
    SetPolymarkerIndex,
    /// SET MARKER TYPE.
    SetMarkerType,
    /// SET MARKER SIZE SCALE FACTOR.
    SetMarkerSizeScaleFactor,
    /// SET POLYMARKER COLOUR INDEX.
    SetPolymarkerColourIndex,
    /// SET TEXT INDEX.
    SetTextIndex,
    /// SET TEXT FONT AND PRECISION.
    SetTextFontAndPrecision,
    /// SET CHARACTER EXPANSION FACTOR.
    SetCharacterExpansionFactor,
    /// SET CHARACTER SPACING.
    SetCharacterSpacing,
    /// SET TEXT COLOUR INDEX.
    SetTextColourIndex,
    /// SET CHARACTER HEIGHT.
    SetCharacterHeight,
    /// SET CHARACTER UP VECTOR.
    SetCharacterUpVector,
    /// SET TEXT PATH.
    SetTextPath,
    /// SET TEXT ALIGNMENT.
    SetTextAlignment,
    /// SET FILL AREA INDEX.
    SetFillAreaIndex,
    /// SET FILL AREA INTERIOR STYLE.
    SetFillAreaInteriorStyle,
    /// SET FILL AREA STYLE INDEX.
    SetFillAreaStyleIndex,
    /// SET FILL AREA COLOUR INDEX.
    SetFillAreaColourIndex,
    /// SET PATTERN SIZE.
    SetPatternSize,
    /// SET PATTERN REFERENCE POINT.
    SetPatternReferencePoint,
    /// SET ASPECT SOURCE FLAGS.
    SetAspectSourceFlags,
    /// SET PICK IDENTIFIER.
    SetPickIdentifier,
    /// SET POLYLINE REPRESENTATION.
    SetPolylineRepresentation,
    /// SET POLYMARKER REPRESENTATION.
    SetPolymarkerRepresentation,
    /// SET TEXT REPRESENTATION.
    SetTextRepresentation,
    /// SET FILL AREA REPRESENTATION.
    SetFillAreaRepresentation,
    /// SET PATTERN REPRESENTATION.
    SetPatternRepresentation,
    /// SET COLOUR REPRESENTATION.
    SetColourRepresentation,
    /// SET WINDOW.
    SetWindow,
    /// SET VIEWPORT.
    SetViewport,
    /// SET VIEWPORT INPUT PRIORITY.
    SetViewportInputPriority,
    /// SELECT NORMALIZATION TRANSFORMATION.
    SelectNormalizationTransformation,
    /// SET CLIPPING INDICATOR.
    SetClippingIndicator,
    /// SET WORKSTATION WINDOW.
    SetWorkstationWindow,
    /// SET WORKSTATION VIEWPORT.
    SetWorkstationViewport,
    /// CREATE SEGMENT.
    CreateSegment,
    /// CLOSE SEGMENT.
    CloseSegment,
    /// RENAME SEGMENT.
    RenameSegment,
    /// DELETE SEGMENT.
    DeleteSegment,
    /// DELETE SEGMENT FROM WORKSTATION.
    DeleteSegmentFromWorkstation,
    /// ASSOCIATE SEGMENT WITH WORKSTATION.
    AssociateSegmentWithWorkstation,
    /// COPY SEGMENT TO WORKSTATION.
    CopySegmentToWorkstation,
    /// INSERT SEGMENT.
    InsertSegment,
    /// SET SEGMENT TRANSFORMATION.
    SetSegmentTransformation,
    /// SET VISIBILITY.
    SetVisibility,
    /// SET HIGHLIGHTING.
    SetHighlighting,
    /// SET SEGMENT PRIORITY.
    SetSegmentPriority,
    /// SET DETECTABILITY.
    SetDetectability,
    /// INITIALISE LOCATOR.
    InitialiseLocator,
    /// INITIALISE STROKE.
    InitialiseStroke,
    /// INITIALISE VALUATOR.
    InitialiseValuator,
    /// INITIALISE CHOICE.
    InitialiseChoice,
    /// INITIALISE PICK.
    InitialisePick,
    /// INITIALISE STRING.
    InitialiseString,
    /// SET LOCATOR MODE.
    SetLocatorMode,
    /// SET STROKE MODE.
    SetStrokeMode,
    /// SET VALUATOR MODE.
    SetValuatorMode,
    /// SET CHOICE MODE.
    SetChoiceMode,
    /// SET PICK MODE.
    SetPickMode,
    /// SET STRING MODE.
    SetStringMode,
    /// REQUEST LOCATOR.
    RequestLocator,
    /// REQUEST STROKE.
    RequestStroke,
    /// REQUEST VALUATOR.
    RequestValuator,
    /// REQUEST CHOICE.
    RequestChoice,
    /// REQUEST PICK.
    RequestPick,
    /// REQUEST STRING.
    RequestString,
    /// SAMPLE LOCATOR.
    SampleLocator,
    /// SAMPLE STROKE.
    SampleStroke,
    /// SAMPLE VALUATOR.
    SampleValuator,
    /// SAMPLE CHOICE.
    SampleChoice,
    /// SAMPLE PICK.
    SamplePick,
    /// SAMPLE STRING.
    SampleString,
    /// AWAIT EVENT.
    AwaitEvent,
    /// FLUSH DEVICE EVENTS.
    FlushDeviceEvents,
    /// GET LOCATOR.
    GetLocator,
    /// GET STROKE.
    GetStroke,
    /// GET VALUATOR.
    GetValuator,
    /// GET CHOICE.
    GetChoice,
    /// GET PICK.
    GetPick,
    /// GET STRING.
    GetString,
    /// WRITE ITEM TO GKSM.
    WriteItemToGksm,
    /// GET ITEM TYPE FROM GKSM.
    GetItemTypeFromGksm,
    /// READ ITEM FROM GKSM.
    ReadItemFromGksm,
    /// INTERPRET ITEM.
    InterpretItem,
    /// INQUIRE OPERATING STATE VALUE.
    InquireOperatingStateValue,
    /// INQUIRE LEVEL OF GKS.
    InquireLevelOfGks,
    /// INQUIRE LIST OF AVAILABLE WORKSTATION TYPES.
    InquireListOfAvailableWorkstationTypes,
    /// INQUIRE WORKSTATION MAXIMUM NUMBERS.
    InquireWorkstationMaximumNumbers,
    /// INQUIRE MAXIMUM NORMALIZATION TRANSFORMATION NUMBER.
    InquireMaximumNormalizationTransformationNumber,
    /// INQUIRE SET OF OPEN WORKSTATIONS.
    InquireSetOfOpenWorkstations,
    /// INQUIRE SET OF ACTIVE WORKSTATIONS.
    InquireSetOfActiveWorkstations,
    /// INQUIRE CURRENT PRIMITIVE ATTRIBUTE VALUES.
    InquireCurrentPrimitiveAttributeValues,
    /// INQUIRE POLYLINE INDEX.
    InquirePolylineIndex,
    /// INQUIRE POLYMARKER INDEX.
    InquirePolymarkerIndex,
    /// INQUIRE TEXT INDEX.
    InquireTextIndex,
    /// INQUIRE CHARACTER HEIGHT.
    InquireCharacterHeight,
    /// INQUIRE CHARACTER UP VECTOR.
    InquireCharacterUpVector,
    /// INQUIRE CHARACTER WIDTH.
    InquireCharacterWidth,
    /// INQUIRE CHARACTER BASE VECTOR.
    InquireCharacterBaseVector,
    /// INQUIRE TEXT PATH.
    InquireTextPath,
    /// INQUIRE TEXT ALIGNMENT.
    InquireTextAlignment,
    /// INQUIRE FILL AREA INDEX.
    InquireFillAreaIndex,
    /// INQUIRE PATTERN WIDTH VECTOR.
    InquirePatternWidthVector,
    /// INQUIRE PATTERN HEIGHT VECTOR.
    InquirePatternHeightVector,
    /// INQUIRE PATTERN REFERENCE POINT.
    InquirePatternReferencePoint,
    /// INQUIRE CURRENT PICK IDENTIFIER VALUE.
    InquireCurrentPickIdentifierValue,
    /// INQUIRE CURRENT INDIVIDUAL ATTRIBUTE VALUES.
    InquireCurrentIndividualAttributeValues,
    /// INQUIRE LINETYPE.
    InquireLinetype,
    /// INQUIRE LINEWIDTH SCALE FACTOR.
    InquireLinewidthScaleFactor,
    /// INQUIRE POLYLINE COLOUR INDEX.
    InquirePolylineColourIndex,
    /// INQUIRE MARKER TYPE.
    InquireMarkerType,
    /// INQUIRE MARKER SIZE SCALE FACTOR.
    InquireMarkerSizeScaleFactor,
    /// INQUIRE POLYMARKER COLOUR INDEX.
    InquirePolymarkerColourIndex,
    /// INQUIRE TEXT FONT AND PRECISION.
    InquireTextFontAndPrecision,
    /// INQUIRE CHARACTER EXPANSION FACTOR.
    InquireCharacterExpansionFactor,
    /// INQUIRE CHARACTER SPACING.
    InquireCharacterSpacing,
    /// INQUIRE TEXT COLOUR INDEX.
    InquireTextColourIndex,
    /// INQUIRE FILL AREA INTERIOR STYLE.
    InquireFillAreaInteriorStyle,
    /// INQUIRE FILL AREA STYLE INDEX.
    InquireFillAreaStyleIndex,
    /// INQUIRE FILL AREA COLOUR INDEX.
    InquireFillAreaColourIndex,
    /// INQUIRE ASPECT SOURCE FLAGS.
    InquireAspectSourceFlags,
    /// INQUIRE CURRENT NORMALIZATION TRANSFORMATION NUMBER.
    InquireCurrentNormalizationTransformationNumber,
    /// INQUIRE LIST OF NORMALIZATION TRANSFORMATION NUMBERS.
    InquireListOfNormalizationTransformationNumbers,
    /// INQUIRE NORMALIZATION TRANSFORMATION.
    InquireNormalizationTransformation,
    /// INQUIRE CLIPPING.
    InquireClipping,
    /// INQUIRE NAME OF OPEN SEGMENT.
    InquireNameOfOpenSegment,
    /// INQUIRE SET OF SEGMENT NAMES IN USE.
    InquireSetOfSegmentNamesInUse,
    /// INQUIRE MORE SIMULTANEOUS EVENTS.
    InquireMoreSimultaneousEvents,
    /// INQUIRE WORKSTATION CONNECTION AND TYPE.
    InquireWorkstationConnectionAndType,
    /// INQUIRE WORKSTATION STATE.
    InquireWorkstationState,
    /// INQUIRE WORKSTATION DEFERRAL AND UPDATE STATES.
    InquireWorkstationDeferralAndUpdateStates,
    /// INQUIRE LIST OF POLYLINE INDICES.
    InquireListOfPolylineIndices,
    /// INQUIRE POLYLINE REPRESENTATION.
    InquirePolylineRepresentation,
    /// INQUIRE LIST OF POLYMARKER INDICES.
    InquireListOfPolymarkerIndices,
    /// INQUIRE POLYMARKER REPRESENTATION.
    InquirePolymarkerRepresentation,
    /// INQUIRE LIST OF TEXT INDICES.
    InquireListOfTextIndices,
    /// INQUIRE TEXT REPRESENTATION.
    InquireTextRepresentation,
    /// INQUIRE TEXT EXTENT.
    InquireTextExtent,
    /// INQUIRE LIST OF FILL AREA INDICES.
    InquireListOfFillAreaIndices,
    /// INQUIRE FILL AREA REPRESENTATION.
    InquireFillAreaRepresentation,
    /// INQUIRE LIST OF PATTERN INDICES.
    InquireListOfPatternIndices,
    /// INQUIRE PATTERN REPRESENTATION.
    InquirePatternRepresentation,
    /// INQUIRE LIST OF COLOUR INDICES.
    InquireListOfColourIndices,
    /// INQUIRE COLOUR REPRESENTATION.
    InquireColourRepresentation,
    /// INQUIRE WORKSTATION TRANSFORMATION.
    InquireWorkstationTransformation,
    /// INQUIRE SET OF SEGMENT NAMES ON WORKSTATION.
    InquireSetOfSegmentNamesOnWorkstation,
    /// INQUIRE LOCATOR DEVICE STATE.
    InquireLocatorDeviceState,
    /// INQUIRE STROKE DEVICE STATE.
    InquireStrokeDeviceState,
    /// INQUIRE VALUATOR DEVICE STATE.
    InquireValuatorDeviceState,
    /// INQUIRE CHOICE DEVICE STATE.
    InquireChoiceDeviceState,
    /// INQUIRE PICK DEVICE STATE.
    InquirePickDeviceState,
    /// INQUIRE STRING DEVICE STATE.
    InquireStringDeviceState,
    /// INQUIRE WORKSTATION CATEGORY.
    InquireWorkstationCategory,
    /// INQUIRE WORKSTATION CLASSIFICATION.
    InquireWorkstationClassification,
    /// INQUIRE DISPLAY SPACE SIZE.
    InquireDisplaySpaceSize,
    /// INQUIRE DYNAMIC MODIFICATION OF WORKSTATION ATTRIBUTES.
    InquireDynamicModificationOfWorkstationAttributes,
    /// INQUIRE DEFAULT DEFERRAL STATE VALUES.
    InquireDefaultDeferralStateValues,
    /// INQUIRE POLYLINE FACILITIES.
    InquirePolylineFacilities,
    /// INQUIRE PREDEFINED POLYLINE REPRESENTATION.
    InquirePredefinedPolylineRepresentation,
    /// INQUIRE POLYMARKER FACILITIES.
    InquirePolymarkerFacilities,
    /// INQUIRE PREDEFINED POLYMARKER REPRESENTATION.
    InquirePredefinedPolymarkerRepresentation,
    /// INQUIRE TEXT FACILITIES.
    InquireTextFacilities,
    /// INQUIRE PREDEFINED TEXT REPRESENTATION.
    InquirePredefinedTextRepresentation,
    /// INQUIRE FILL AREA FACILITIES.
    InquireFillAreaFacilities,
    /// INQUIRE PREDEFINED FILL AREA REPRESENTATION.
    InquirePredefinedFillAreaRepresentation,
    /// INQUIRE PATTERN FACILITIES.
    InquirePatternFacilities,
    /// INQUIRE PREDEFINED PATTERN REPRESENTATION.
    InquirePredefinedPatternRepresentation,
    /// INQUIRE COLOUR FACILITIES.
    InquireColourFacilities,
    /// INQUIRE PREDEFINED COLOUR REPRESENTATION.
    InquirePredefinedColourRepresentation,
    /// INQUIRE LIST OF AVAILABLE GENERALIZED DRAWING PRIMITIVES.
    InquireListOfAvailableGeneralizedDrawingPrimitives,
    /// INQUIRE GENERALIZED DRAWING PRIMITIVE.
    InquireGeneralizedDrawingPrimitive,
    /// INQUIRE MAXIMUM LENGTH OF WORKSTATION STATE TABLES.
    InquireMaximumLengthOfWorkstationStateTables,
    /// INQUIRE NUMBER OF SEGMENT PRIORITIES SUPPORTED.
    InquireNumberOfSegmentPrioritiesSupported,
    /// INQUIRE DYNAMIC MODIFICATION OF SEGMENT ATTRIBUTES.
    InquireDynamicModificationOfSegmentAttributes,
    /// INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES.
    InquireNumberOfAvailableLogicalInputDevices,
    /// INQUIRE DEFAULT LOCATOR DEVICE DATA.
    InquireDefaultLocatorDeviceData,
    /// INQUIRE DEFAULT STROKE DEVICE DATA.
    InquireDefaultStrokeDeviceData,
    /// INQUIRE DEFAULT VALUATOR DEVICE DATA.
    InquireDefaultValuatorDeviceData,
    /// INQUIRE DEFAULT CHOICE DEVICE DATA.
    InquireDefaultChoiceDeviceData,
    /// INQUIRE DEFAULT PICK DEVICE DATA.
    InquireDefaultPickDeviceData,
    /// INQUIRE DEFAULT STRING DEVICE DATA.
    InquireDefaultStringDeviceData,
    /// INQUIRE SET OF ASSOCIATED WORKSTATIONS.
    InquireSetOfAssociatedWorkstations,
    /// INQUIRE SEGMENT ATTRIBUTES.
    InquireSegmentAttributes,
    /// INQUIRE PIXEL ARRAY DIMENSIONS.
    InquirePixelArrayDimensions,
    /// INQUIRE PIXEL ARRAY.
    InquirePixelArray,
    /// INQUIRE PIXEL.
    InquirePixel,
    /// INQUIRE INPUT QUEUE OVERFLOW.
    InquireInputQueueOverflow,
    /// EVALUATE TRANSFORMATION MATRIX.
    EvaluateTransformationMatrix,
    /// ACCUMULATE TRANSFORMATION MATRIX.
    AccumulateTransformationMatrix,
    /// EMERGENCY CLOSE GKS.
    EmergencyCloseGks,
    /// ERROR HANDLING.
    ErrorHandling,
    /// ERROR LOGGING.
    ErrorLogging,
    /// PACK DATA RECORD.
    PackDataRecord,
    /// UNPACK DATA RECORD.
    UnpackDataRecord,
    /// CREATE STORE.
    CreateStore,
    /// DELETE STORE.
    DeleteStore,
    /// SET ERROR HANDLER.
    SetErrorHandler,
}

struct Entry {
    name: &'static str,
    fortran: &'static [&'static str],
    c: &'static str,
    level: Level,
    id: i32,
    states: u8,
    errors: &'static [i32],
}

impl Function {
    /// The standard's name, in capitals.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ENTRIES[self as usize].name
    }

    /// The Fortran subroutines: the full variant, then the subset variant; none for what only the C binding has
    /// and for inquiries that Fortran splits into others.
    #[must_use]
    pub const fn fortran(self) -> &'static [&'static str] {
        ENTRIES[self as usize].fortran
    }

    /// The C function; `None` for what only the Fortran binding has.
    #[must_use]
    pub const fn c(self) -> Option<&'static str> {
        let c = ENTRIES[self as usize].c;
        if c.is_empty() { None } else { Some(c) }
    }

    /// The lowest level of GKS that has the function.
    #[must_use]
    pub const fn level(self) -> Level {
        ENTRIES[self as usize].level
    }

    /// The function identifier that the error handler is given, the same in Fortran and C; inquiries have none.
    #[must_use]
    pub const fn id(self) -> Option<i32> {
        let id = ENTRIES[self as usize].id;
        if id < 0 { None } else { Some(id) }
    }

    /// The operating states in which the function may be called.
    #[must_use]
    pub const fn states(self) -> StateMask {
        StateMask(ENTRIES[self as usize].states)
    }

    /// The error, 1 to 8, of a call in another state; 0 for functions that may be called in every state.
    #[must_use]
    pub const fn state_error(self) -> i32 {
        let errors = ENTRIES[self as usize].errors;
        if !errors.is_empty() && errors[0] <= 8 { errors[0] } else { 0 }
    }

    /// The errors that the standard lists for the function, in the order of checking.
    #[must_use]
    pub const fn errors(self) -> &'static [i32] {
        ENTRIES[self as usize].errors
    }
}

impl Function {
    /// All functions, in the order of the table.
    pub const ALL: [Self; 218] = [
        Self::OpenGks,
        Self::CloseGks,
        Self::OpenWorkstation,
        Self::CloseWorkstation,
        Self::ActivateWorkstation,
        Self::DeactivateWorkstation,
        Self::ClearWorkstation,
        Self::RedrawAllSegmentsOnWorkstation,
        Self::UpdateWorkstation,
        Self::SetDeferralState,
        Self::Message,
        Self::Escape,
        Self::Polyline,
        Self::Polymarker,
        Self::Text,
        Self::FillArea,
        Self::CellArray,
        Self::GeneralizedDrawingPrimitive,
        Self::SetPolylineIndex,
        Self::SetLinetype,
        Self::SetLinewidthScaleFactor,
        Self::SetPolylineColourIndex,
        Self::SetPolymarkerIndex,
        Self::SetMarkerType,
        Self::SetMarkerSizeScaleFactor,
        Self::SetPolymarkerColourIndex,
        Self::SetTextIndex,
        Self::SetTextFontAndPrecision,
        Self::SetCharacterExpansionFactor,
        Self::SetCharacterSpacing,
        Self::SetTextColourIndex,
        Self::SetCharacterHeight,
        Self::SetCharacterUpVector,
        Self::SetTextPath,
        Self::SetTextAlignment,
        Self::SetFillAreaIndex,
        Self::SetFillAreaInteriorStyle,
        Self::SetFillAreaStyleIndex,
        Self::SetFillAreaColourIndex,
        Self::SetPatternSize,
        Self::SetPatternReferencePoint,
        Self::SetAspectSourceFlags,
        Self::SetPickIdentifier,
        Self::SetPolylineRepresentation,
        Self::SetPolymarkerRepresentation,
        Self::SetTextRepresentation,
        Self::SetFillAreaRepresentation,
        Self::SetPatternRepresentation,
        Self::SetColourRepresentation,
        Self::SetWindow,
        Self::SetViewport,
        Self::SetViewportInputPriority,
        Self::SelectNormalizationTransformation,
        Self::SetClippingIndicator,
        Self::SetWorkstationWindow,
        Self::SetWorkstationViewport,
        Self::CreateSegment,
        Self::CloseSegment,
        Self::RenameSegment,
        Self::DeleteSegment,
        Self::DeleteSegmentFromWorkstation,
        Self::AssociateSegmentWithWorkstation,
        Self::CopySegmentToWorkstation,
        Self::InsertSegment,
        Self::SetSegmentTransformation,
        Self::SetVisibility,
        Self::SetHighlighting,
        Self::SetSegmentPriority,
        Self::SetDetectability,
        Self::InitialiseLocator,
        Self::InitialiseStroke,
        Self::InitialiseValuator,
        Self::InitialiseChoice,
        Self::InitialisePick,
        Self::InitialiseString,
        Self::SetLocatorMode,
        Self::SetStrokeMode,
        Self::SetValuatorMode,
        Self::SetChoiceMode,
        Self::SetPickMode,
        Self::SetStringMode,
        Self::RequestLocator,
        Self::RequestStroke,
        Self::RequestValuator,
        Self::RequestChoice,
        Self::RequestPick,
        Self::RequestString,
        Self::SampleLocator,
        Self::SampleStroke,
        Self::SampleValuator,
        Self::SampleChoice,
        Self::SamplePick,
        Self::SampleString,
        Self::AwaitEvent,
        Self::FlushDeviceEvents,
        Self::GetLocator,
        Self::GetStroke,
        Self::GetValuator,
        Self::GetChoice,
        Self::GetPick,
        Self::GetString,
        Self::WriteItemToGksm,
        Self::GetItemTypeFromGksm,
        Self::ReadItemFromGksm,
        Self::InterpretItem,
        Self::InquireOperatingStateValue,
        Self::InquireLevelOfGks,
        Self::InquireListOfAvailableWorkstationTypes,
        Self::InquireWorkstationMaximumNumbers,
        Self::InquireMaximumNormalizationTransformationNumber,
        Self::InquireSetOfOpenWorkstations,
        Self::InquireSetOfActiveWorkstations,
        Self::InquireCurrentPrimitiveAttributeValues,
        Self::InquirePolylineIndex,
        Self::InquirePolymarkerIndex,
        Self::InquireTextIndex,
        Self::InquireCharacterHeight,
        Self::InquireCharacterUpVector,
        Self::InquireCharacterWidth,
        Self::InquireCharacterBaseVector,
        Self::InquireTextPath,
        Self::InquireTextAlignment,
        Self::InquireFillAreaIndex,
        Self::InquirePatternWidthVector,
        Self::InquirePatternHeightVector,
        Self::InquirePatternReferencePoint,
        Self::InquireCurrentPickIdentifierValue,
        Self::InquireCurrentIndividualAttributeValues,
        Self::InquireLinetype,
        Self::InquireLinewidthScaleFactor,
        Self::InquirePolylineColourIndex,
        Self::InquireMarkerType,
        Self::InquireMarkerSizeScaleFactor,
        Self::InquirePolymarkerColourIndex,
        Self::InquireTextFontAndPrecision,
        Self::InquireCharacterExpansionFactor,
        Self::InquireCharacterSpacing,
        Self::InquireTextColourIndex,
        Self::InquireFillAreaInteriorStyle,
        Self::InquireFillAreaStyleIndex,
        Self::InquireFillAreaColourIndex,
        Self::InquireAspectSourceFlags,
        Self::InquireCurrentNormalizationTransformationNumber,
        Self::InquireListOfNormalizationTransformationNumbers,
        Self::InquireNormalizationTransformation,
        Self::InquireClipping,
        Self::InquireNameOfOpenSegment,
        Self::InquireSetOfSegmentNamesInUse,
        Self::InquireMoreSimultaneousEvents,
        Self::InquireWorkstationConnectionAndType,
        Self::InquireWorkstationState,
        Self::InquireWorkstationDeferralAndUpdateStates,
        Self::InquireListOfPolylineIndices,
        Self::InquirePolylineRepresentation,
        Self::InquireListOfPolymarkerIndices,
        Self::InquirePolymarkerRepresentation,
        Self::InquireListOfTextIndices,
        Self::InquireTextRepresentation,
        Self::InquireTextExtent,
        Self::InquireListOfFillAreaIndices,
        Self::InquireFillAreaRepresentation,
        Self::InquireListOfPatternIndices,
        Self::InquirePatternRepresentation,
        Self::InquireListOfColourIndices,
        Self::InquireColourRepresentation,
        Self::InquireWorkstationTransformation,
        Self::InquireSetOfSegmentNamesOnWorkstation,
        Self::InquireLocatorDeviceState,
        Self::InquireStrokeDeviceState,
        Self::InquireValuatorDeviceState,
        Self::InquireChoiceDeviceState,
        Self::InquirePickDeviceState,
        Self::InquireStringDeviceState,
        Self::InquireWorkstationCategory,
        Self::InquireWorkstationClassification,
        Self::InquireDisplaySpaceSize,
        Self::InquireDynamicModificationOfWorkstationAttributes,
        Self::InquireDefaultDeferralStateValues,
        Self::InquirePolylineFacilities,
        Self::InquirePredefinedPolylineRepresentation,
        Self::InquirePolymarkerFacilities,
        Self::InquirePredefinedPolymarkerRepresentation,
        Self::InquireTextFacilities,
        Self::InquirePredefinedTextRepresentation,
        Self::InquireFillAreaFacilities,
        Self::InquirePredefinedFillAreaRepresentation,
        Self::InquirePatternFacilities,
        Self::InquirePredefinedPatternRepresentation,
        Self::InquireColourFacilities,
        Self::InquirePredefinedColourRepresentation,
        Self::InquireListOfAvailableGeneralizedDrawingPrimitives,
        Self::InquireGeneralizedDrawingPrimitive,
        Self::InquireMaximumLengthOfWorkstationStateTables,
        Self::InquireNumberOfSegmentPrioritiesSupported,
        Self::InquireDynamicModificationOfSegmentAttributes,
        Self::InquireNumberOfAvailableLogicalInputDevices,
        Self::InquireDefaultLocatorDeviceData,
        Self::InquireDefaultStrokeDeviceData,
        Self::InquireDefaultValuatorDeviceData,
        Self::InquireDefaultChoiceDeviceData,
        Self::InquireDefaultPickDeviceData,
        Self::InquireDefaultStringDeviceData,
        Self::InquireSetOfAssociatedWorkstations,
        Self::InquireSegmentAttributes,
        Self::InquirePixelArrayDimensions,
        Self::InquirePixelArray,
        Self::InquirePixel,
        Self::InquireInputQueueOverflow,
        Self::EvaluateTransformationMatrix,
        Self::AccumulateTransformationMatrix,
        Self::EmergencyCloseGks,
        Self::ErrorHandling,
        Self::ErrorLogging,
        Self::PackDataRecord,
        Self::UnpackDataRecord,
        Self::CreateStore,
        Self::DeleteStore,
        Self::SetErrorHandler,
    ];
}

static ENTRIES: [Entry; 218] = [
    Entry { name: "OPEN GKS", fortran: &["GOPKS"], c: "gopen_gks", level: Level::L0a, id: 0, states: 0b00001, errors: &[1, 200] },
    Entry { name: "CLOSE GKS", fortran: &["GCLKS"], c: "gclose_gks", level: Level::L0a, id: 1, states: 0b00010, errors: &[2] },
    Entry { name: "OPEN WORKSTATION", fortran: &["GOPWK"], c: "gopen_ws", level: Level::L0a, id: 2, states: 0b11110, errors: &[8, 20, 22, 23, 24, 28, 42, 21, 26] },
    Entry { name: "CLOSE WORKSTATION", fortran: &["GCLWK"], c: "gclose_ws", level: Level::L0a, id: 3, states: 0b11100, errors: &[7, 20, 25, 29, 147] },
    Entry { name: "ACTIVATE WORKSTATION", fortran: &["GACWK"], c: "gactivate_ws", level: Level::L0a, id: 4, states: 0b01100, errors: &[6, 20, 25, 29, 33, 35, 43] },
    Entry { name: "DEACTIVATE WORKSTATION", fortran: &["GDAWK"], c: "gdeactivate_ws", level: Level::L0a, id: 5, states: 0b01000, errors: &[3, 20, 30, 33, 35] },
    Entry { name: "CLEAR WORKSTATION", fortran: &["GCLRWK"], c: "gclear_ws", level: Level::L0a, id: 6, states: 0b01100, errors: &[6, 20, 25, 33, 35] },
    Entry { name: "REDRAW ALL SEGMENTS ON WORKSTATION", fortran: &["GRSGWK"], c: "gredraw_all_segs_ws", level: Level::L1a, id: 7, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "UPDATE WORKSTATION", fortran: &["GUWK"], c: "gupd_ws", level: Level::L0a, id: 8, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "SET DEFERRAL STATE", fortran: &["GSDS"], c: "gset_defer_st", level: Level::L1a, id: 9, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "MESSAGE", fortran: &["GMSG", "GMSGS"], c: "gmessage", level: Level::L1a, id: 10, states: 0b11100, errors: &[7, 20, 25, 36] },
    Entry { name: "ESCAPE", fortran: &["GESC"], c: "gescape", level: Level::L0a, id: 11, states: 0b11110, errors: &[8, 180, 181, 182] },
    Entry { name: "POLYLINE", fortran: &["GPL"], c: "gpolyline", level: Level::L0a, id: 12, states: 0b11000, errors: &[5, 100] },
    Entry { name: "POLYMARKER", fortran: &["GPM"], c: "gpolymarker", level: Level::L0a, id: 13, states: 0b11000, errors: &[5, 100] },
    Entry { name: "TEXT", fortran: &["GTX", "GTXS"], c: "gtext", level: Level::L0a, id: 14, states: 0b11000, errors: &[5, 101] },
    Entry { name: "FILL AREA", fortran: &["GFA"], c: "gfill_area", level: Level::L0a, id: 15, states: 0b11000, errors: &[5, 100] },
    Entry { name: "CELL ARRAY", fortran: &["GCA"], c: "gcell_array", level: Level::L0a, id: 16, states: 0b11000, errors: &[5, 91] },
    Entry { name: "GENERALIZED DRAWING PRIMITIVE", fortran: &["GGDP"], c: "ggdp", level: Level::L0a, id: 17, states: 0b11000, errors: &[5, 100, 102, 103, 104, 105] },
    Entry { name: "SET POLYLINE INDEX", fortran: &["GSPLI"], c: "gset_line_ind", level: Level::L0a, id: 18, states: 0b11110, errors: &[8, 60] },
    Entry { name: "SET LINETYPE", fortran: &["GSLN"], c: "gset_linetype", level: Level::L0a, id: 19, states: 0b11110, errors: &[8, 63] },
    Entry { name: "SET LINEWIDTH SCALE FACTOR", fortran: &["GSLWSC"], c: "gset_linewidth", level: Level::L0a, id: 20, states: 0b11110, errors: &[8, 65] },
    Entry { name: "SET POLYLINE COLOUR INDEX", fortran: &["GSPLCI"], c: "gset_line_colr_ind", level: Level::L0a, id: 21, states: 0b11110, errors: &[8, 92] },
    Entry { name: "SET POLYMARKER INDEX", fortran: &["GSPMI"], c: "gset_marker_ind", level: Level::L0a, id: 22, states: 0b11110, errors: &[8, 66] },
    Entry { name: "SET MARKER TYPE", fortran: &["GSMK"], c: "gset_marker_type", level: Level::L0a, id: 23, states: 0b11110, errors: &[8, 69] },
    Entry { name: "SET MARKER SIZE SCALE FACTOR", fortran: &["GSMKSC"], c: "gset_marker_size", level: Level::L0a, id: 24, states: 0b11110, errors: &[8, 71] },
    Entry { name: "SET POLYMARKER COLOUR INDEX", fortran: &["GSPMCI"], c: "gset_marker_colr_ind", level: Level::L0a, id: 25, states: 0b11110, errors: &[8, 92] },
    Entry { name: "SET TEXT INDEX", fortran: &["GSTXI"], c: "gset_text_ind", level: Level::L0a, id: 26, states: 0b11110, errors: &[8, 72] },
    Entry { name: "SET TEXT FONT AND PRECISION", fortran: &["GSTXFP"], c: "gset_text_font_prec", level: Level::L0a, id: 27, states: 0b11110, errors: &[8, 75] },
    Entry { name: "SET CHARACTER EXPANSION FACTOR", fortran: &["GSCHXP"], c: "gset_char_expan", level: Level::L0a, id: 28, states: 0b11110, errors: &[8, 77] },
    Entry { name: "SET CHARACTER SPACING", fortran: &["GSCHSP"], c: "gset_char_space", level: Level::L0a, id: 29, states: 0b11110, errors: &[8] },
    Entry { name: "SET TEXT COLOUR INDEX", fortran: &["GSTXCI"], c: "gset_text_colr_ind", level: Level::L0a, id: 30, states: 0b11110, errors: &[8, 92] },
    Entry { name: "SET CHARACTER HEIGHT", fortran: &["GSCHH"], c: "gset_char_ht", level: Level::L0a, id: 31, states: 0b11110, errors: &[8, 78] },
    Entry { name: "SET CHARACTER UP VECTOR", fortran: &["GSCHUP"], c: "gset_char_up_vec", level: Level::L0a, id: 32, states: 0b11110, errors: &[8, 79] },
    Entry { name: "SET TEXT PATH", fortran: &["GSTXP"], c: "gset_text_path", level: Level::L0a, id: 33, states: 0b11110, errors: &[8] },
    Entry { name: "SET TEXT ALIGNMENT", fortran: &["GSTXAL"], c: "gset_text_align", level: Level::L0a, id: 34, states: 0b11110, errors: &[8] },
    Entry { name: "SET FILL AREA INDEX", fortran: &["GSFAI"], c: "gset_fill_ind", level: Level::L0a, id: 35, states: 0b11110, errors: &[8, 80] },
    Entry { name: "SET FILL AREA INTERIOR STYLE", fortran: &["GSFAIS"], c: "gset_fill_int_style", level: Level::L0a, id: 36, states: 0b11110, errors: &[8] },
    Entry { name: "SET FILL AREA STYLE INDEX", fortran: &["GSFASI"], c: "gset_fill_style_ind", level: Level::L0a, id: 37, states: 0b11110, errors: &[8, 84] },
    Entry { name: "SET FILL AREA COLOUR INDEX", fortran: &["GSFACI"], c: "gset_fill_colr_ind", level: Level::L0a, id: 38, states: 0b11110, errors: &[8, 92] },
    Entry { name: "SET PATTERN SIZE", fortran: &["GSPA"], c: "gset_pat_size", level: Level::L0a, id: 39, states: 0b11110, errors: &[8, 87] },
    Entry { name: "SET PATTERN REFERENCE POINT", fortran: &["GSPARF"], c: "gset_pat_ref_point", level: Level::L0a, id: 40, states: 0b11110, errors: &[8] },
    Entry { name: "SET ASPECT SOURCE FLAGS", fortran: &["GSASF"], c: "gset_asfs", level: Level::L0a, id: 41, states: 0b11110, errors: &[8] },
    Entry { name: "SET PICK IDENTIFIER", fortran: &["GSPKID"], c: "gset_pick_id", level: Level::L1b, id: 42, states: 0b11110, errors: &[8, 97] },
    Entry { name: "SET POLYLINE REPRESENTATION", fortran: &["GSPLR"], c: "gset_line_rep", level: Level::L1a, id: 43, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 60, 63, 64, 65, 93] },
    Entry { name: "SET POLYMARKER REPRESENTATION", fortran: &["GSPMR"], c: "gset_marker_rep", level: Level::L1a, id: 44, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 66, 69, 70, 71, 93] },
    Entry { name: "SET TEXT REPRESENTATION", fortran: &["GSTXR"], c: "gset_text_rep", level: Level::L1a, id: 45, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 72, 75, 76, 77, 93] },
    Entry { name: "SET FILL AREA REPRESENTATION", fortran: &["GSFAR"], c: "gset_fill_rep", level: Level::L1a, id: 46, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 80, 83, 85, 86, 93] },
    Entry { name: "SET PATTERN REPRESENTATION", fortran: &["GSPAR"], c: "gset_pat_rep", level: Level::L1a, id: 47, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 85, 90, 91, 93] },
    Entry { name: "SET COLOUR REPRESENTATION", fortran: &["GSCR"], c: "gset_colr_rep", level: Level::L0a, id: 48, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 93, 96] },
    Entry { name: "SET WINDOW", fortran: &["GSWN"], c: "gset_win", level: Level::L0a, id: 49, states: 0b11110, errors: &[8, 50, 51] },
    Entry { name: "SET VIEWPORT", fortran: &["GSVP"], c: "gset_vp", level: Level::L0a, id: 50, states: 0b11110, errors: &[8, 50, 51, 52] },
    Entry { name: "SET VIEWPORT INPUT PRIORITY", fortran: &["GSVPIP"], c: "gset_vp_in_pri", level: Level::L0b, id: 51, states: 0b11110, errors: &[8, 50] },
    Entry { name: "SELECT NORMALIZATION TRANSFORMATION", fortran: &["GSELNT"], c: "gsel_norm_tran", level: Level::L0a, id: 52, states: 0b11110, errors: &[8, 50] },
    Entry { name: "SET CLIPPING INDICATOR", fortran: &["GSCLIP"], c: "gset_clip_ind", level: Level::L0a, id: 53, states: 0b11110, errors: &[8] },
    Entry { name: "SET WORKSTATION WINDOW", fortran: &["GSWKWN"], c: "gset_ws_win", level: Level::L0a, id: 54, states: 0b11100, errors: &[7, 20, 25, 33, 36, 51, 53] },
    Entry { name: "SET WORKSTATION VIEWPORT", fortran: &["GSWKVP"], c: "gset_ws_vp", level: Level::L0a, id: 55, states: 0b11100, errors: &[7, 20, 25, 33, 36, 51, 54] },
    Entry { name: "CREATE SEGMENT", fortran: &["GCRSG"], c: "gcreate_seg", level: Level::L1a, id: 56, states: 0b01000, errors: &[3, 120, 121] },
    Entry { name: "CLOSE SEGMENT", fortran: &["GCLSG"], c: "gclose_seg", level: Level::L1a, id: 57, states: 0b10000, errors: &[4] },
    Entry { name: "RENAME SEGMENT", fortran: &["GRENSG"], c: "grename_seg", level: Level::L1a, id: 58, states: 0b11100, errors: &[7, 120, 121, 122] },
    Entry { name: "DELETE SEGMENT", fortran: &["GDSG"], c: "gdel_seg", level: Level::L1a, id: 59, states: 0b11100, errors: &[7, 120, 122, 125] },
    Entry { name: "DELETE SEGMENT FROM WORKSTATION", fortran: &["GDSGWK"], c: "gdel_seg_ws", level: Level::L1a, id: 60, states: 0b11100, errors: &[7, 20, 25, 33, 35, 120, 123, 125] },
    Entry { name: "ASSOCIATE SEGMENT WITH WORKSTATION", fortran: &["GASGWK"], c: "gassoc_seg_ws", level: Level::L2a, id: 61, states: 0b01100, errors: &[6, 20, 25, 27, 33, 35, 120, 124] },
    Entry { name: "COPY SEGMENT TO WORKSTATION", fortran: &["GCSGWK"], c: "gcopy_seg_ws", level: Level::L2a, id: 62, states: 0b01100, errors: &[6, 20, 25, 27, 33, 35, 36, 120, 124] },
    Entry { name: "INSERT SEGMENT", fortran: &["GINSG"], c: "ginsert_seg", level: Level::L2a, id: 63, states: 0b11000, errors: &[5, 27, 120, 124, 125] },
    Entry { name: "SET SEGMENT TRANSFORMATION", fortran: &["GSSGT"], c: "gset_seg_tran", level: Level::L1a, id: 64, states: 0b11100, errors: &[7, 120, 122] },
    Entry { name: "SET VISIBILITY", fortran: &["GSVIS"], c: "gset_vis", level: Level::L1a, id: 65, states: 0b11100, errors: &[7, 120, 122] },
    Entry { name: "SET HIGHLIGHTING", fortran: &["GSHLIT"], c: "gset_highl", level: Level::L1a, id: 66, states: 0b11100, errors: &[7, 120, 122] },
    Entry { name: "SET SEGMENT PRIORITY", fortran: &["GSSGP"], c: "gset_seg_pri", level: Level::L1a, id: 67, states: 0b11100, errors: &[7, 120, 122, 126] },
    Entry { name: "SET DETECTABILITY", fortran: &["GSDTEC"], c: "gset_det", level: Level::L1b, id: 68, states: 0b11100, errors: &[7, 120, 122] },
    Entry { name: "INITIALISE LOCATOR", fortran: &["GINLC"], c: "ginit_loc", level: Level::L0b, id: 69, states: 0b11100, errors: &[7, 20, 25, 38, 51, 140, 141, 144, 145, 146, 152] },
    Entry { name: "INITIALISE STROKE", fortran: &["GINSK"], c: "ginit_stroke", level: Level::L0b, id: 70, states: 0b11100, errors: &[7, 20, 25, 38, 51, 140, 141, 144, 145, 146, 152, 153] },
    Entry { name: "INITIALISE VALUATOR", fortran: &["GINVL"], c: "ginit_val", level: Level::L0b, id: 71, states: 0b11100, errors: &[7, 20, 25, 38, 51, 140, 141, 144, 145, 146, 152] },
    Entry { name: "INITIALISE CHOICE", fortran: &["GINCH"], c: "ginit_choice", level: Level::L0b, id: 72, states: 0b11100, errors: &[7, 20, 25, 38, 51, 140, 141, 144, 145, 146, 152] },
    Entry { name: "INITIALISE PICK", fortran: &["GINPK"], c: "ginit_pick", level: Level::L1b, id: 73, states: 0b11100, errors: &[7, 20, 25, 37, 51, 140, 141, 144, 145, 146, 152] },
    Entry { name: "INITIALISE STRING", fortran: &["GINST", "GINSTS"], c: "ginit_string", level: Level::L0b, id: 74, states: 0b11100, errors: &[7, 20, 25, 38, 51, 140, 141, 144, 145, 146, 152, 154] },
    Entry { name: "SET LOCATOR MODE", fortran: &["GSLCM"], c: "gset_loc_mode", level: Level::L0b, id: 75, states: 0b11100, errors: &[7, 20, 25, 38, 140, 143] },
    Entry { name: "SET STROKE MODE", fortran: &["GSSKM"], c: "gset_stroke_mode", level: Level::L0b, id: 76, states: 0b11100, errors: &[7, 20, 25, 38, 140, 143] },
    Entry { name: "SET VALUATOR MODE", fortran: &["GSVLM"], c: "gset_val_mode", level: Level::L0b, id: 77, states: 0b11100, errors: &[7, 20, 25, 38, 140, 143] },
    Entry { name: "SET CHOICE MODE", fortran: &["GSCHM"], c: "gset_choice_mode", level: Level::L0b, id: 78, states: 0b11100, errors: &[7, 20, 25, 38, 140, 143] },
    Entry { name: "SET PICK MODE", fortran: &["GSPKM"], c: "gset_pick_mode", level: Level::L1b, id: 79, states: 0b11100, errors: &[7, 20, 25, 37, 140, 143] },
    Entry { name: "SET STRING MODE", fortran: &["GSSTM"], c: "gset_string_mode", level: Level::L0b, id: 80, states: 0b11100, errors: &[7, 20, 25, 38, 140, 143] },
    Entry { name: "REQUEST LOCATOR", fortran: &["GRQLC"], c: "greq_loc", level: Level::L0b, id: 81, states: 0b11100, errors: &[7, 20, 25, 38, 140, 141] },
    Entry { name: "REQUEST STROKE", fortran: &["GRQSK"], c: "greq_stroke", level: Level::L0b, id: 82, states: 0b11100, errors: &[7, 20, 25, 38, 140, 141] },
    Entry { name: "REQUEST VALUATOR", fortran: &["GRQVL"], c: "greq_val", level: Level::L0b, id: 83, states: 0b11100, errors: &[7, 20, 25, 38, 140, 141] },
    Entry { name: "REQUEST CHOICE", fortran: &["GRQCH"], c: "greq_choice", level: Level::L0b, id: 84, states: 0b11100, errors: &[7, 20, 25, 38, 140, 141] },
    Entry { name: "REQUEST PICK", fortran: &["GRQPK"], c: "greq_pick", level: Level::L1b, id: 85, states: 0b11100, errors: &[7, 20, 25, 37, 140, 141] },
    Entry { name: "REQUEST STRING", fortran: &["GRQST", "GRQSTS"], c: "greq_string", level: Level::L0b, id: 86, states: 0b11100, errors: &[7, 20, 25, 38, 140, 141] },
    Entry { name: "SAMPLE LOCATOR", fortran: &["GSMLC"], c: "gsample_loc", level: Level::L0c, id: 87, states: 0b11100, errors: &[7, 20, 25, 38, 140, 142] },
    Entry { name: "SAMPLE STROKE", fortran: &["GSMSK"], c: "gsample_stroke", level: Level::L0c, id: 88, states: 0b11100, errors: &[7, 20, 25, 38, 140, 142] },
    Entry { name: "SAMPLE VALUATOR", fortran: &["GSMVL"], c: "gsample_val", level: Level::L0c, id: 89, states: 0b11100, errors: &[7, 20, 25, 38, 140, 142] },
    Entry { name: "SAMPLE CHOICE", fortran: &["GSMCH"], c: "gsample_choice", level: Level::L0c, id: 90, states: 0b11100, errors: &[7, 20, 25, 38, 140, 142] },
    Entry { name: "SAMPLE PICK", fortran: &["GSMPK"], c: "gsample_pick", level: Level::L1c, id: 91, states: 0b11100, errors: &[7, 20, 25, 37, 140, 142] },
    Entry { name: "SAMPLE STRING", fortran: &["GSMST", "GSMSTS"], c: "gsample_string", level: Level::L0c, id: 92, states: 0b11100, errors: &[7, 20, 25, 38, 140, 142] },
    Entry { name: "AWAIT EVENT", fortran: &["GWAIT"], c: "gawait_event", level: Level::L0c, id: 93, states: 0b11100, errors: &[7, 147, 151] },
    Entry { name: "FLUSH DEVICE EVENTS", fortran: &["GFLUSH"], c: "gflush_events", level: Level::L0c, id: 94, states: 0b11100, errors: &[7, 20, 25, 38, 140, 147] },
    Entry { name: "GET LOCATOR", fortran: &["GGTLC"], c: "gget_loc", level: Level::L0c, id: 95, states: 0b11100, errors: &[7, 150] },
    Entry { name: "GET STROKE", fortran: &["GGTSK"], c: "gget_stroke", level: Level::L0c, id: 96, states: 0b11100, errors: &[7, 150] },
    Entry { name: "GET VALUATOR", fortran: &["GGTVL"], c: "gget_val", level: Level::L0c, id: 97, states: 0b11100, errors: &[7, 150] },
    Entry { name: "GET CHOICE", fortran: &["GGTCH"], c: "gget_choice", level: Level::L0c, id: 98, states: 0b11100, errors: &[7, 150] },
    Entry { name: "GET PICK", fortran: &["GGTPK"], c: "gget_pick", level: Level::L1c, id: 99, states: 0b11100, errors: &[7, 150] },
    Entry { name: "GET STRING", fortran: &["GGTST", "GGTSTS"], c: "gget_string", level: Level::L0c, id: 100, states: 0b11100, errors: &[7, 150] },
    Entry { name: "WRITE ITEM TO GKSM", fortran: &["GWITM"], c: "gwrite_item", level: Level::L0a, id: 101, states: 0b11000, errors: &[5, 20, 30, 32, 160, 161] },
    Entry { name: "GET ITEM TYPE FROM GKSM", fortran: &["GGTITM"], c: "gget_item_type", level: Level::L0a, id: 102, states: 0b11100, errors: &[7, 20, 25, 34, 162, 163] },
    Entry { name: "READ ITEM FROM GKSM", fortran: &["GRDITM"], c: "gread_item", level: Level::L0a, id: 103, states: 0b11100, errors: &[7, 20, 25, 34, 162, 163, 165, 166] },
    Entry { name: "INTERPRET ITEM", fortran: &["GIITM"], c: "ginterpret_item", level: Level::L0a, id: 104, states: 0b11100, errors: &[7, 161, 163, 164, 165, 167, 168] },
    Entry { name: "INQUIRE OPERATING STATE VALUE", fortran: &["GQOPS"], c: "ginq_op_st", level: Level::L0a, id: -1, states: 0b11111, errors: &[] },
    Entry { name: "INQUIRE LEVEL OF GKS", fortran: &["GQLVKS"], c: "ginq_level_gks", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE LIST OF AVAILABLE WORKSTATION TYPES", fortran: &["GQEWK"], c: "ginq_list_avail_ws_types", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE WORKSTATION MAXIMUM NUMBERS", fortran: &["GQWKM"], c: "ginq_ws_max_nums", level: Level::L1a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE MAXIMUM NORMALIZATION TRANSFORMATION NUMBER", fortran: &["GQMNTN"], c: "ginq_max_norm_tran_num", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE SET OF OPEN WORKSTATIONS", fortran: &["GQOPWK"], c: "ginq_set_open_wss", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE SET OF ACTIVE WORKSTATIONS", fortran: &["GQACWK"], c: "ginq_set_active_wss", level: Level::L1a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CURRENT PRIMITIVE ATTRIBUTE VALUES", fortran: &[], c: "ginq_cur_prim_attrs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE POLYLINE INDEX", fortran: &["GQPLI"], c: "ginq_line_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE POLYMARKER INDEX", fortran: &["GQPMI"], c: "ginq_marker_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE TEXT INDEX", fortran: &["GQTXI"], c: "ginq_text_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CHARACTER HEIGHT", fortran: &["GQCHH"], c: "ginq_char_ht", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CHARACTER UP VECTOR", fortran: &["GQCHUP"], c: "ginq_char_up_vec", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CHARACTER WIDTH", fortran: &["GQCHW"], c: "ginq_char_width", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CHARACTER BASE VECTOR", fortran: &["GQCHB"], c: "ginq_char_base_vec", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE TEXT PATH", fortran: &["GQTXP"], c: "ginq_text_path", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE TEXT ALIGNMENT", fortran: &["GQTXAL"], c: "ginq_text_align", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE FILL AREA INDEX", fortran: &["GQFAI"], c: "ginq_fill_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE PATTERN WIDTH VECTOR", fortran: &["GQPA"], c: "ginq_pat_width_vec", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE PATTERN HEIGHT VECTOR", fortran: &[], c: "ginq_pat_ht_vec", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE PATTERN REFERENCE POINT", fortran: &["GQPARF"], c: "ginq_pat_ref_point", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CURRENT PICK IDENTIFIER VALUE", fortran: &["GQPKID"], c: "ginq_cur_pick_id", level: Level::L1b, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CURRENT INDIVIDUAL ATTRIBUTE VALUES", fortran: &[], c: "ginq_cur_indiv_attrs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE LINETYPE", fortran: &["GQLN"], c: "ginq_linetype", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE LINEWIDTH SCALE FACTOR", fortran: &["GQLWSC"], c: "ginq_linewidth", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE POLYLINE COLOUR INDEX", fortran: &["GQPLCI"], c: "ginq_line_colr_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE MARKER TYPE", fortran: &["GQMK"], c: "ginq_marker_type", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE MARKER SIZE SCALE FACTOR", fortran: &["GQMKSC"], c: "ginq_marker_size", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE POLYMARKER COLOUR INDEX", fortran: &["GQPMCI"], c: "ginq_marker_colr_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE TEXT FONT AND PRECISION", fortran: &["GQTXFP"], c: "ginq_text_font_prec", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CHARACTER EXPANSION FACTOR", fortran: &["GQCHXP"], c: "ginq_char_expan", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CHARACTER SPACING", fortran: &["GQCHSP"], c: "ginq_char_space", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE TEXT COLOUR INDEX", fortran: &["GQTXCI"], c: "ginq_text_colr_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE FILL AREA INTERIOR STYLE", fortran: &["GQFAIS"], c: "ginq_fill_int_style", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE FILL AREA STYLE INDEX", fortran: &["GQFASI"], c: "ginq_fill_style_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE FILL AREA COLOUR INDEX", fortran: &["GQFACI"], c: "ginq_fill_colr_ind", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE ASPECT SOURCE FLAGS", fortran: &["GQASF"], c: "ginq_asfs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE CURRENT NORMALIZATION TRANSFORMATION NUMBER", fortran: &["GQCNTN"], c: "ginq_cur_norm_tran_num", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE LIST OF NORMALIZATION TRANSFORMATION NUMBERS", fortran: &["GQENTN"], c: "ginq_list_norm_tran_nums", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE NORMALIZATION TRANSFORMATION", fortran: &["GQNT"], c: "ginq_norm_tran", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 50] },
    Entry { name: "INQUIRE CLIPPING", fortran: &["GQCLIP"], c: "ginq_clip", level: Level::L0a, id: -1, states: 0b11110, errors: &[8] },
    Entry { name: "INQUIRE NAME OF OPEN SEGMENT", fortran: &["GQOPSG"], c: "ginq_name_open_seg", level: Level::L1a, id: -1, states: 0b10000, errors: &[4] },
    Entry { name: "INQUIRE SET OF SEGMENT NAMES IN USE", fortran: &["GQSGUS"], c: "ginq_set_seg_names", level: Level::L1a, id: -1, states: 0b11100, errors: &[7] },
    Entry { name: "INQUIRE MORE SIMULTANEOUS EVENTS", fortran: &["GQSIM"], c: "ginq_more_simult_events", level: Level::L0c, id: -1, states: 0b11100, errors: &[7] },
    Entry { name: "INQUIRE WORKSTATION CONNECTION AND TYPE", fortran: &["GQWKC"], c: "ginq_ws_conn_type", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25] },
    Entry { name: "INQUIRE WORKSTATION STATE", fortran: &["GQWKS"], c: "ginq_ws_st", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35] },
    Entry { name: "INQUIRE WORKSTATION DEFERRAL AND UPDATE STATES", fortran: &["GQWKDU"], c: "ginq_ws_defer_upd_sts", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "INQUIRE LIST OF POLYLINE INDICES", fortran: &["GQEPLI"], c: "ginq_list_line_inds", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "INQUIRE POLYLINE REPRESENTATION", fortran: &["GQPLR"], c: "ginq_line_rep", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 60, 61] },
    Entry { name: "INQUIRE LIST OF POLYMARKER INDICES", fortran: &["GQEPMI"], c: "ginq_list_marker_inds", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "INQUIRE POLYMARKER REPRESENTATION", fortran: &["GQPMR"], c: "ginq_marker_rep", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 66, 67] },
    Entry { name: "INQUIRE LIST OF TEXT INDICES", fortran: &["GQETXI"], c: "ginq_list_text_inds", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "INQUIRE TEXT REPRESENTATION", fortran: &["GQTXR"], c: "ginq_text_rep", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 72, 73] },
    Entry { name: "INQUIRE TEXT EXTENT", fortran: &["GQTXX", "GQTXXS"], c: "ginq_text_extent", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 39, 101] },
    Entry { name: "INQUIRE LIST OF FILL AREA INDICES", fortran: &["GQEFAI"], c: "ginq_list_fill_inds", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "INQUIRE FILL AREA REPRESENTATION", fortran: &["GQFAR"], c: "ginq_fill_rep", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 80, 81] },
    Entry { name: "INQUIRE LIST OF PATTERN INDICES", fortran: &["GQEPAI"], c: "ginq_list_pat_inds", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "INQUIRE PATTERN REPRESENTATION", fortran: &["GQPAR"], c: "ginq_pat_rep", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 85, 88, 90] },
    Entry { name: "INQUIRE LIST OF COLOUR INDICES", fortran: &["GQECI"], c: "ginq_list_colr_inds", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36] },
    Entry { name: "INQUIRE COLOUR REPRESENTATION", fortran: &["GQCR"], c: "ginq_colr_rep", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35, 36, 93, 94] },
    Entry { name: "INQUIRE WORKSTATION TRANSFORMATION", fortran: &["GQWKT"], c: "ginq_ws_tran", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 36] },
    Entry { name: "INQUIRE SET OF SEGMENT NAMES ON WORKSTATION", fortran: &["GQSGWK"], c: "ginq_set_seg_names_ws", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 20, 25, 33, 35] },
    Entry { name: "INQUIRE LOCATOR DEVICE STATE", fortran: &["GQLCS"], c: "ginq_loc_st", level: Level::L0b, id: -1, states: 0b11100, errors: &[7, 20, 25, 38, 140] },
    Entry { name: "INQUIRE STROKE DEVICE STATE", fortran: &["GQSKS"], c: "ginq_stroke_st", level: Level::L0b, id: -1, states: 0b11100, errors: &[7, 20, 25, 38, 140] },
    Entry { name: "INQUIRE VALUATOR DEVICE STATE", fortran: &["GQVLS"], c: "ginq_val_st", level: Level::L0b, id: -1, states: 0b11100, errors: &[7, 20, 25, 38, 140] },
    Entry { name: "INQUIRE CHOICE DEVICE STATE", fortran: &["GQCHS"], c: "ginq_choice_st", level: Level::L0b, id: -1, states: 0b11100, errors: &[7, 20, 25, 38, 140] },
    Entry { name: "INQUIRE PICK DEVICE STATE", fortran: &["GQPKS"], c: "ginq_pick_st", level: Level::L1b, id: -1, states: 0b11100, errors: &[7, 20, 25, 37, 140] },
    Entry { name: "INQUIRE STRING DEVICE STATE", fortran: &["GQSTS", "GQSTSS"], c: "ginq_string_st", level: Level::L0b, id: -1, states: 0b11100, errors: &[7, 20, 25, 38, 140] },
    Entry { name: "INQUIRE WORKSTATION CATEGORY", fortran: &["GQWKCA"], c: "ginq_ws_cat", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23] },
    Entry { name: "INQUIRE WORKSTATION CLASSIFICATION", fortran: &["GQWKCL"], c: "ginq_ws_class", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE DISPLAY SPACE SIZE", fortran: &["GQDSP"], c: "ginq_disp_space_size", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 31, 33, 36] },
    Entry { name: "INQUIRE DYNAMIC MODIFICATION OF WORKSTATION ATTRIBUTES", fortran: &["GQDWKA"], c: "ginq_dyn_mod_ws_attrs", level: Level::L1a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE DEFAULT DEFERRAL STATE VALUES", fortran: &["GQDDS"], c: "ginq_def_defer_sts", level: Level::L1a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE POLYLINE FACILITIES", fortran: &["GQPLF"], c: "ginq_line_facs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE PREDEFINED POLYLINE REPRESENTATION", fortran: &["GQPPLR"], c: "ginq_pred_line_rep", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39, 60, 62] },
    Entry { name: "INQUIRE POLYMARKER FACILITIES", fortran: &["GQPMF"], c: "ginq_marker_facs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE PREDEFINED POLYMARKER REPRESENTATION", fortran: &["GQPPMR"], c: "ginq_pred_marker_rep", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39, 66, 68] },
    Entry { name: "INQUIRE TEXT FACILITIES", fortran: &["GQTXF"], c: "ginq_text_facs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE PREDEFINED TEXT REPRESENTATION", fortran: &["GQPTXR"], c: "ginq_pred_text_rep", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39, 72, 74] },
    Entry { name: "INQUIRE FILL AREA FACILITIES", fortran: &["GQFAF"], c: "ginq_fill_facs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE PREDEFINED FILL AREA REPRESENTATION", fortran: &["GQPFAR"], c: "ginq_pred_fill_rep", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39, 80, 82] },
    Entry { name: "INQUIRE PATTERN FACILITIES", fortran: &["GQPAF"], c: "ginq_pat_facs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE PREDEFINED PATTERN REPRESENTATION", fortran: &["GQPPAR"], c: "ginq_pred_pat_rep", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39, 85, 89, 90] },
    Entry { name: "INQUIRE COLOUR FACILITIES", fortran: &["GQCF"], c: "ginq_colr_facs", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE PREDEFINED COLOUR REPRESENTATION", fortran: &["GQPCR"], c: "ginq_pred_colr_rep", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39, 93, 95] },
    Entry { name: "INQUIRE LIST OF AVAILABLE GENERALIZED DRAWING PRIMITIVES", fortran: &["GQEGDP"], c: "ginq_list_avail_gdps", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE GENERALIZED DRAWING PRIMITIVE", fortran: &["GQGDP"], c: "ginq_gdp", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39, 41, 102] },
    Entry { name: "INQUIRE MAXIMUM LENGTH OF WORKSTATION STATE TABLES", fortran: &["GQLWK"], c: "ginq_max_ws_st_tables", level: Level::L0a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE NUMBER OF SEGMENT PRIORITIES SUPPORTED", fortran: &["GQSGP"], c: "ginq_num_seg_pris", level: Level::L1a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE DYNAMIC MODIFICATION OF SEGMENT ATTRIBUTES", fortran: &["GQDSGA"], c: "ginq_dyn_mod_seg_attrs", level: Level::L1a, id: -1, states: 0b11110, errors: &[8, 22, 23, 39] },
    Entry { name: "INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES", fortran: &["GQLI"], c: "ginq_num_avail_in", level: Level::L0b, id: -1, states: 0b11110, errors: &[8, 22, 23, 38] },
    Entry { name: "INQUIRE DEFAULT LOCATOR DEVICE DATA", fortran: &["GQDLC"], c: "ginq_def_loc_data", level: Level::L0b, id: -1, states: 0b11110, errors: &[8, 22, 23, 38, 140] },
    Entry { name: "INQUIRE DEFAULT STROKE DEVICE DATA", fortran: &["GQDSK"], c: "ginq_def_stroke_data", level: Level::L0b, id: -1, states: 0b11110, errors: &[8, 22, 23, 38, 140] },
    Entry { name: "INQUIRE DEFAULT VALUATOR DEVICE DATA", fortran: &["GQDVL"], c: "ginq_def_val_data", level: Level::L0b, id: -1, states: 0b11110, errors: &[8, 22, 23, 38, 140] },
    Entry { name: "INQUIRE DEFAULT CHOICE DEVICE DATA", fortran: &["GQDCH"], c: "ginq_def_choice_data", level: Level::L0b, id: -1, states: 0b11110, errors: &[8, 22, 23, 38, 140] },
    Entry { name: "INQUIRE DEFAULT PICK DEVICE DATA", fortran: &["GQDPK"], c: "ginq_def_pick_data", level: Level::L1b, id: -1, states: 0b11110, errors: &[8, 22, 23, 37, 140] },
    Entry { name: "INQUIRE DEFAULT STRING DEVICE DATA", fortran: &["GQDST"], c: "ginq_def_string_data", level: Level::L0b, id: -1, states: 0b11110, errors: &[8, 22, 23, 38, 140] },
    Entry { name: "INQUIRE SET OF ASSOCIATED WORKSTATIONS", fortran: &["GQASWK"], c: "ginq_set_assoc_wss", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 120, 122] },
    Entry { name: "INQUIRE SEGMENT ATTRIBUTES", fortran: &["GQSGA"], c: "ginq_seg_attrs", level: Level::L1a, id: -1, states: 0b11100, errors: &[7, 120, 122] },
    Entry { name: "INQUIRE PIXEL ARRAY DIMENSIONS", fortran: &["GQPXAD"], c: "ginq_pixel_array_dims", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 39] },
    Entry { name: "INQUIRE PIXEL ARRAY", fortran: &["GQPXA"], c: "ginq_pixel_array", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 39, 40, 91] },
    Entry { name: "INQUIRE PIXEL", fortran: &["GQPX"], c: "ginq_pixel", level: Level::L0a, id: -1, states: 0b11100, errors: &[7, 20, 25, 39, 40] },
    Entry { name: "INQUIRE INPUT QUEUE OVERFLOW", fortran: &["GQIQOV"], c: "ginq_in_overf", level: Level::L0c, id: -1, states: 0b11100, errors: &[7, 148, 149] },
    Entry { name: "EVALUATE TRANSFORMATION MATRIX", fortran: &["GEVTM"], c: "geval_tran_matrix", level: Level::L1a, id: 105, states: 0b11110, errors: &[8] },
    Entry { name: "ACCUMULATE TRANSFORMATION MATRIX", fortran: &["GACTM"], c: "gaccum_tran_matrix", level: Level::L1a, id: 106, states: 0b11110, errors: &[8] },
    Entry { name: "EMERGENCY CLOSE GKS", fortran: &["GECLKS"], c: "gemergency_close_gks", level: Level::L0a, id: -1, states: 0b11111, errors: &[] },
    Entry { name: "ERROR HANDLING", fortran: &["GERHND"], c: "gerr_hand", level: Level::L0a, id: -1, states: 0b11111, errors: &[] },
    Entry { name: "ERROR LOGGING", fortran: &["GERLOG"], c: "gerr_log", level: Level::L0a, id: -1, states: 0b11111, errors: &[] },
    Entry { name: "PACK DATA RECORD", fortran: &["GPREC"], c: "", level: Level::L0a, id: 107, states: 0b11111, errors: &[2001] },
    Entry { name: "UNPACK DATA RECORD", fortran: &["GUREC"], c: "", level: Level::L0a, id: 108, states: 0b11111, errors: &[2001, 2003] },
    Entry { name: "CREATE STORE", fortran: &[], c: "gcreate_store", level: Level::L0a, id: -1, states: 0b11111, errors: &[2204] },
    Entry { name: "DELETE STORE", fortran: &[], c: "gdel_store", level: Level::L0a, id: -1, states: 0b11111, errors: &[] },
    Entry { name: "SET ERROR HANDLER", fortran: &[], c: "gset_err_hand", level: Level::L0a, id: -1, states: 0b11111, errors: &[] },
];
