//! Calls about segments with one wrong argument, and the errors that they meet.

use super::catalogue::{CATEGORIES, NULL};
use super::provocations::{Provocation, meets};
use super::situation::{OPEN_SEGMENT, SEGMENT, of_category};
use gks::Function::*;
use gks::{Detectability, Gks, Highlighting, Visibility};
use gks_pipeline::description::Category;

/// A name that no segment has.
const FREE: i32 = 77;
/// What is no name.
const NO_NAME: i32 = 0;
const IDENTITY: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
const NOT_A_NUMBER: [[f64; 3]; 2] = [[1.0, 0.0, f64::NAN], [0.0, 1.0, 0.0]];
const WISS: i32 = of_category(Category::Wiss);

/// Opens a segment in segment storage and on the active workstation.
fn open_segment(gks: &mut Gks) {
    gks.activate_workstation(WISS).expect("it is open");
    gks.create_segment(OPEN_SEGMENT).expect("the name is free");
}

/// Opens another workstation in the place of segment storage.
fn close_storage(gks: &mut Gks) {
    gks.close_workstation(WISS).expect("it is open and not active");
    gks.open_workstation(WISS, "", NULL).expect("the identifier is free");
}

/// Wrong names and states of segments.
pub(crate) static PROVOCATIONS: &[Provocation] = &[
    meets(28, OpenWorkstation, |g, id| g.open_workstation(id, "", CATEGORIES + Category::Wiss as i32)),
    meets(120, CreateSegment, |g, _| g.create_segment(NO_NAME)),
    meets(121, CreateSegment, |g, _| g.create_segment(SEGMENT)),
    meets(120, RenameSegment, |g, _| g.rename_segment(NO_NAME, FREE)),
    meets(120, RenameSegment, |g, _| g.rename_segment(SEGMENT, -1)),
    meets(121, RenameSegment, |g, _| g.rename_segment(SEGMENT, SEGMENT)),
    meets(121, RenameSegment, |g, _| g.rename_segment(FREE, SEGMENT)),
    meets(122, RenameSegment, |g, _| g.rename_segment(FREE, FREE)),
    meets(120, DeleteSegment, |g, _| g.delete_segment(NO_NAME)),
    meets(122, DeleteSegment, |g, _| g.delete_segment(FREE)),
    meets(125, DeleteSegment, |g, _| g.delete_segment(OPEN_SEGMENT)).after(open_segment),
    meets(120, DeleteSegmentFromWorkstation, |g, id| g.delete_segment_from_workstation(id, NO_NAME)),
    meets(123, DeleteSegmentFromWorkstation, |g, id| g.delete_segment_from_workstation(id, FREE)),
    meets(123, DeleteSegmentFromWorkstation, |g, id| g.delete_segment_from_workstation(id, SEGMENT)).about(2),
    meets(125, DeleteSegmentFromWorkstation, |g, id| g.delete_segment_from_workstation(id, OPEN_SEGMENT))
        .after(open_segment),
    meets(27, AssociateSegmentWithWorkstation, |g, id| g.associate_segment_with_workstation(id, SEGMENT))
        .after(close_storage),
    meets(120, AssociateSegmentWithWorkstation, |g, id| g.associate_segment_with_workstation(id, NO_NAME)),
    meets(124, AssociateSegmentWithWorkstation, |g, id| g.associate_segment_with_workstation(id, FREE)),
    meets(27, CopySegmentToWorkstation, |g, id| g.copy_segment_to_workstation(id, SEGMENT))
        .after(close_storage),
    meets(120, CopySegmentToWorkstation, |g, id| g.copy_segment_to_workstation(id, NO_NAME)),
    meets(124, CopySegmentToWorkstation, |g, id| g.copy_segment_to_workstation(id, FREE)),
    meets(27, InsertSegment, |g, _| g.insert_segment(SEGMENT, IDENTITY)).after(close_storage),
    meets(120, InsertSegment, |g, _| g.insert_segment(NO_NAME, IDENTITY)),
    meets(124, InsertSegment, |g, _| g.insert_segment(FREE, IDENTITY)),
    meets(125, InsertSegment, |g, _| g.insert_segment(OPEN_SEGMENT, IDENTITY)).after(open_segment),
    meets(308, InsertSegment, |g, _| g.insert_segment(SEGMENT, NOT_A_NUMBER)),
    meets(120, SetSegmentTransformation, |g, _| g.set_segment_transformation(NO_NAME, IDENTITY)),
    meets(122, SetSegmentTransformation, |g, _| g.set_segment_transformation(FREE, IDENTITY)),
    meets(308, SetSegmentTransformation, |g, _| g.set_segment_transformation(SEGMENT, NOT_A_NUMBER)),
    meets(120, SetVisibility, |g, _| g.set_visibility(NO_NAME, Visibility::Visible)),
    meets(122, SetVisibility, |g, _| g.set_visibility(FREE, Visibility::Visible)),
    meets(120, SetHighlighting, |g, _| g.set_highlighting(NO_NAME, Highlighting::Normal)),
    meets(122, SetHighlighting, |g, _| g.set_highlighting(FREE, Highlighting::Normal)),
    meets(120, SetSegmentPriority, |g, _| g.set_segment_priority(NO_NAME, 0.5)),
    meets(122, SetSegmentPriority, |g, _| g.set_segment_priority(FREE, 0.5)),
    meets(126, SetSegmentPriority, |g, _| g.set_segment_priority(SEGMENT, 1.1)),
    meets(126, SetSegmentPriority, |g, _| g.set_segment_priority(SEGMENT, f64::NAN)),
    meets(120, SetDetectability, |g, _| g.set_detectability(NO_NAME, Detectability::Detectable)),
    meets(122, SetDetectability, |g, _| g.set_detectability(FREE, Detectability::Detectable)),
    meets(120, InquireSetOfAssociatedWorkstations, |g, _| {
        g.inquire_set_of_associated_workstations(NO_NAME).map(drop)
    }),
    meets(122, InquireSetOfAssociatedWorkstations, |g, _| {
        g.inquire_set_of_associated_workstations(FREE).map(drop)
    }),
    meets(120, InquireSegmentAttributes, |g, _| g.inquire_segment_attributes(NO_NAME).map(drop)),
    meets(122, InquireSegmentAttributes, |g, _| g.inquire_segment_attributes(FREE).map(drop)),
];
