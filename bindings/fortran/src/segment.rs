//! Segments: manipulation, attributes and inquiries.

use crate::answer::{Array, inquiries, lists};
use crate::argument::{Integer, Real};
use crate::call::subroutines;
use crate::transformation::matrix;
use gks::SegmentAttributes;

subroutines! {
    gcrsg_(sgna: Integer) CreateSegment => |gks| gks.create_segment(sgna.get());
    gclsg_() CloseSegment => gks::Gks::close_segment;
    grensg_(old: Integer, new: Integer) RenameSegment => |gks| gks.rename_segment(old.get(), new.get());
    gdsg_(sgna: Integer) DeleteSegment => |gks| gks.delete_segment(sgna.get());
    gdsgwk_(wkid: Integer, sgna: Integer) DeleteSegmentFromWorkstation
        => |gks| gks.delete_segment_from_workstation(wkid.get(), sgna.get());
    gasgwk_(wkid: Integer, sgna: Integer) AssociateSegmentWithWorkstation
        => |gks| gks.associate_segment_with_workstation(wkid.get(), sgna.get());
    gcsgwk_(wkid: Integer, sgna: Integer) CopySegmentToWorkstation
        => |gks| gks.copy_segment_to_workstation(wkid.get(), sgna.get());
    ginsg_(sgna: Integer, m: Real) InsertSegment => |gks| gks.insert_segment(sgna.get(), matrix(m));
    grsgwk_(wkid: Integer) RedrawAllSegmentsOnWorkstation
        => |gks| gks.redraw_all_segments_on_workstation(wkid.get());
    gssgt_(sgna: Integer, m: Real) SetSegmentTransformation
        => |gks| gks.set_segment_transformation(sgna.get(), matrix(m));
    gsvis_(sgna: Integer, vis: Integer) SetVisibility
        => |gks| gks.set_visibility(sgna.get(), vis.choice(F)?);
    gshlit_(sgna: Integer, hil: Integer) SetHighlighting
        => |gks| gks.set_highlighting(sgna.get(), hil.choice(F)?);
    gssgp_(sgna: Integer, prior: Real) SetSegmentPriority
        => |gks| gks.set_segment_priority(sgna.get(), prior.real());
    gsdtec_(sgna: Integer, det: Integer) SetDetectability
        => |gks| gks.set_detectability(sgna.get(), det.choice(F)?);
}

lists! {
    gqsgus_() InquireSetOfSegmentNamesInUse => |gks| gks.inquire_set_of_segment_names_in_use();
    gqsgwk_(wkid: Integer) InquireSetOfSegmentNamesOnWorkstation
        => |gks| gks.inquire_set_of_segment_names_on_workstation(wkid.get());
    gqaswk_(sgna: Integer) InquireSetOfAssociatedWorkstations
        => |gks| gks.inquire_set_of_associated_workstations(sgna.get());
}

inquiries! {
    gqopsg_() -> (sgna: Integer) InquireNameOfOpenSegment => |gks| gks.inquire_name_of_open_segment();
    gqsga_(sgna: Integer) -> (
        segtm: Array<f32, 6>, vis: Integer, high: Integer, sgpr: Real, det: Integer
    ) InquireSegmentAttributes => |gks| {
        let SegmentAttributes { transformation, visibility, highlighting, priority, detectability }
            = gks.inquire_segment_attributes(sgna.get())?;
        Ok((transformation, visibility, highlighting, priority, detectability))
    };
    gqsgp_(wtype: Integer) -> (nsg: Integer) InquireNumberOfSegmentPrioritiesSupported
        => |gks| gks.inquire_number_of_segment_priorities_supported(wtype.get());
    gqdsga_(wtype: Integer) -> (
        sgtr: Integer, vonoff: Integer, voffon: Integer, high: Integer, sgpr: Integer, add: Integer,
        sgdel: Integer
    ) InquireDynamicModificationOfSegmentAttributes => |gks| {
        let is = gks.inquire_dynamic_modification_of_segment_attributes(wtype.get())?;
        let shown = (is.transformation, is.disappearing, is.appearing, is.highlighting);
        Ok((shown.0, shown.1, shown.2, shown.3, is.priority, is.adding, is.deletion))
    };
}
