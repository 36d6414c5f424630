//! GKS, the Graphical Kernel System (ISO 7942): state lists and functions.
//!
//! [`Gks`] is the kernel as a value; every function of the standard is a method of it.

mod attributes;
mod control;
mod copy;
mod data_record;
mod error;
mod escape;
mod gdp;
pub mod generated;
mod gks;
mod input;
mod inquiry;
mod matrix;
mod metafile;
mod normalization;
mod output;
mod representation;
mod segment;
#[cfg(test)]
mod test_device;
mod workstation_transformation;

pub use crate::data_record::{DataRecord, GivenRecord, Line};
pub use crate::error::{Error, Result};
pub use crate::generated::function::{Function, Level, OperatingState, StateMask};
pub use crate::gks::{Defaults, Gks, MessageHandler};
pub use crate::input::{
    DefaultDevice, Detail, DeviceState, InputClass, InputStatus, InputValue, LocatorValue, OperatingMode,
    PickValue, StrokeValue,
};
pub use crate::inquiry::{
    AttributeGroup, ColourFacilities, DeferralAndUpdateStates, DisplaySpaceSize, FillAreaFacilities,
    IndividualAttributes, MaximumTableLengths, PixelArray, PolylineFacilities, PolymarkerFacilities,
    PrimitiveAttributes, SizeRange, TextExtent, TextFacilities, ValueType, WorkstationMaximumNumbers,
    WorkstationTransformationState,
};
pub use crate::matrix::CoordinateSwitch;
pub use crate::normalization::{NormalizationTransformation, RelativePriority};
pub use crate::segment::{Detectability, Highlighting, SegmentAttributes, Visibility};
pub use gks_geometry::Points;
