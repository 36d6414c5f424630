//! Inquiries about segments: names, state lists, and what workstations make of their changes.

use crate::segment::SegmentAttributes;
use crate::{Error, Function, Gks, Result};
use gks_pipeline::description::SegmentModifications;
use gks_pipeline::segment::Segment;

/// The number of segment priorities of all workstations: a continuous range.
const PRIORITIES: u32 = 0;

impl Gks {
    fn inquired_segment(&self, function: Function, name: i32) -> Result<&Segment> {
        self.check_state(function)?;
        self.segments.get(name).ok_or_else(|| Error::new(if name < 1 { 120 } else { 122 }, function))
    }

    /// INQUIRE NAME OF OPEN SEGMENT. Error: 4.
    pub fn inquire_name_of_open_segment(&self) -> Result<i32> {
        const F: Function = Function::InquireNameOfOpenSegment;
        self.check_state(F)?;
        self.open_segment.map(|open| open.name).ok_or_else(|| Error::new(F.state_error(), F))
    }

    /// INQUIRE SET OF SEGMENT NAMES IN USE: in increasing order. Error: 7.
    pub fn inquire_set_of_segment_names_in_use(&self) -> Result<impl Iterator<Item = i32> + Clone> {
        self.check_state(Function::InquireSetOfSegmentNamesInUse)?;
        Ok(self.segments.names())
    }

    /// INQUIRE SET OF SEGMENT NAMES ON WORKSTATION: in the order of priority, the lowest first.
    ///
    /// Errors: 7, 20, 25, 33 (MI), 35 (INPUT).
    pub fn inquire_set_of_segment_names_on_workstation(
        &self,
        id: i32,
    ) -> Result<impl Iterator<Item = i32> + Clone> {
        self.inquired(Function::InquireSetOfSegmentNamesOnWorkstation, id)?;
        Ok(self.segments.on(id).map(Segment::name))
    }

    /// INQUIRE SET OF ASSOCIATED WORKSTATIONS of a segment: their identifiers, in increasing order.
    ///
    /// Errors: 7, 120 (name not positive), 122 (no such segment).
    pub fn inquire_set_of_associated_workstations(
        &self,
        name: i32,
    ) -> Result<impl ExactSizeIterator<Item = i32> + Clone> {
        const F: Function = Function::InquireSetOfAssociatedWorkstations;
        Ok(self.inquired_segment(F, name)?.workstations().iter().copied())
    }

    /// INQUIRE SEGMENT ATTRIBUTES. Errors: 7, 120 (name not positive), 122 (no such segment).
    pub fn inquire_segment_attributes(&self, name: i32) -> Result<SegmentAttributes> {
        const F: Function = Function::InquireSegmentAttributes;
        let segment = self.inquired_segment(F, name)?;
        Ok(SegmentAttributes {
            transformation: segment.appearance.transformation.rows(),
            visibility: segment.visible.into(),
            highlighting: segment.appearance.highlighted.into(),
            priority: segment.priority(),
            detectability: segment.detectable.into(),
        })
    }

    /// INQUIRE NUMBER OF SEGMENT PRIORITIES SUPPORTED: 0 for a continuous range. Errors: 8, 22, 23, 39.
    pub fn inquire_number_of_segment_priorities_supported(&self, kind: i32) -> Result<u32> {
        self.described(Function::InquireNumberOfSegmentPrioritiesSupported, kind)?;
        Ok(PRIORITIES)
    }

    /// INQUIRE DYNAMIC MODIFICATION OF SEGMENT ATTRIBUTES. Errors: 8, 22, 23, 39.
    pub fn inquire_dynamic_modification_of_segment_attributes(
        &self,
        kind: i32,
    ) -> Result<SegmentModifications> {
        Ok(self.described(Function::InquireDynamicModificationOfSegmentAttributes, kind)?.segments)
    }
}
