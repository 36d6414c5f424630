//! Segments: manipulation, attributes and inquiries of their state lists.

use crate::argument::{In, Out, Part, call, choice, inquire};
use crate::types::{Gdouble, Gfloat, Gint, Gint_list, Gseg_attrs, Gtran_matrix};
use gks::{Detectability, Function, Gks, Highlighting, Visibility};

/// REDRAW ALL SEGMENTS ON WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gredraw_all_segs_ws(ws_id: Gint) {
    call(Function::RedrawAllSegmentsOnWorkstation, |gks| gks.redraw_all_segments_on_workstation(ws_id));
}

/// CREATE SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn gcreate_seg(seg_name: Gint) {
    call(Function::CreateSegment, |gks| gks.create_segment(seg_name));
}

/// CLOSE SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn gclose_seg() {
    call(Function::CloseSegment, Gks::close_segment);
}

/// RENAME SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn grename_seg(old_seg_name: Gint, new_seg_name: Gint) {
    call(Function::RenameSegment, |gks| gks.rename_segment(old_seg_name, new_seg_name));
}

/// DELETE SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn gdel_seg(seg_name: Gint) {
    call(Function::DeleteSegment, |gks| gks.delete_segment(seg_name));
}

/// DELETE SEGMENT FROM WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gdel_seg_ws(ws_id: Gint, seg_name: Gint) {
    const F: Function = Function::DeleteSegmentFromWorkstation;
    call(F, |gks| gks.delete_segment_from_workstation(ws_id, seg_name));
}

/// ASSOCIATE SEGMENT WITH WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gassoc_seg_ws(ws_id: Gint, seg_name: Gint) {
    const F: Function = Function::AssociateSegmentWithWorkstation;
    call(F, |gks| gks.associate_segment_with_workstation(ws_id, seg_name));
}

/// COPY SEGMENT TO WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn gcopy_seg_ws(ws_id: Gint, seg_name: Gint) {
    const F: Function = Function::CopySegmentToWorkstation;
    call(F, |gks| gks.copy_segment_to_workstation(ws_id, seg_name));
}

/// INSERT SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn ginsert_seg(seg_name: Gint, tran_matrix: In<Gtran_matrix>) {
    const F: Function = Function::InsertSegment;
    call(F, |gks| gks.insert_segment(seg_name, rows(tran_matrix.needed(F)?)));
}

/// SET SEGMENT TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn gset_seg_tran(seg_name: Gint, tran_matrix: In<Gtran_matrix>) {
    const F: Function = Function::SetSegmentTransformation;
    call(F, |gks| gks.set_segment_transformation(seg_name, rows(tran_matrix.needed(F)?)));
}

/// SET VISIBILITY.
#[unsafe(no_mangle)]
extern "C" fn gset_vis(seg_name: Gint, seg_vis: Gint) {
    const F: Function = Function::SetVisibility;
    call(F, |gks| gks.set_visibility(seg_name, choice(F, seg_vis, Visibility::from_number)?));
}

/// SET HIGHLIGHTING.
#[unsafe(no_mangle)]
extern "C" fn gset_highl(seg_name: Gint, seg_highl: Gint) {
    const F: Function = Function::SetHighlighting;
    call(F, |gks| gks.set_highlighting(seg_name, choice(F, seg_highl, Highlighting::from_number)?));
}

/// SET SEGMENT PRIORITY.
#[unsafe(no_mangle)]
extern "C" fn gset_seg_pri(seg_name: Gint, seg_pri: Gdouble) {
    call(Function::SetSegmentPriority, |gks| gks.set_segment_priority(seg_name, seg_pri));
}

/// SET DETECTABILITY.
#[unsafe(no_mangle)]
extern "C" fn gset_det(seg_name: Gint, seg_det: Gint) {
    const F: Function = Function::SetDetectability;
    call(F, |gks| gks.set_detectability(seg_name, choice(F, seg_det, Detectability::from_number)?));
}

/// INQUIRE NAME OF OPEN SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn ginq_name_open_seg(err_ind: Out<Gint>, name_open_seg: Out<Gint>) {
    inquire(Function::InquireNameOfOpenSegment, err_ind, |gks| {
        name_open_seg.set(gks.inquire_name_of_open_segment()?);
        Ok(())
    });
}

/// INQUIRE SET OF SEGMENT NAMES ON WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn ginq_set_seg_names_ws(
    ws_id: Gint,
    num_elems_appl_list: Gint,
    start_pos: Gint,
    err_ind: Out<Gint>,
    seg_names: Out<Gint_list>,
    length_list: Out<Gint>,
) {
    const F: Function = Function::InquireSetOfSegmentNamesOnWorkstation;
    let part = Part::of(num_elems_appl_list, start_pos, seg_names, length_list);
    inquire(F, err_ind, |gks| part.set(F, gks.inquire_set_of_segment_names_on_workstation(ws_id)?));
}

/// INQUIRE SET OF ASSOCIATED WORKSTATIONS.
#[unsafe(no_mangle)]
extern "C" fn ginq_set_assoc_wss(
    seg_name: Gint,
    num_elems_appl_list: Gint,
    start_pos: Gint,
    err_ind: Out<Gint>,
    assoc_ws: Out<Gint_list>,
    length_list: Out<Gint>,
) {
    const F: Function = Function::InquireSetOfAssociatedWorkstations;
    let part = Part::of(num_elems_appl_list, start_pos, assoc_ws, length_list);
    inquire(F, err_ind, |gks| part.set(F, gks.inquire_set_of_associated_workstations(seg_name)?));
}

/// INQUIRE SEGMENT ATTRIBUTES.
#[unsafe(no_mangle)]
extern "C" fn ginq_seg_attrs(seg_name: Gint, err_ind: Out<Gint>, seg_attrs: Out<Gseg_attrs>) {
    inquire(Function::InquireSegmentAttributes, err_ind, |gks| {
        let attributes = gks.inquire_segment_attributes(seg_name)?;
        seg_attrs.set(Gseg_attrs {
            tran: attributes.transformation.map(|row| row.map(|v| v as Gfloat)),
            vis: attributes.visibility as Gint,
            highl: attributes.highlighting as Gint,
            pri: attributes.priority,
            det: attributes.detectability as Gint,
        });
        Ok(())
    });
}

fn rows(matrix: Gtran_matrix) -> [[f64; 3]; 2] {
    matrix.map(|row| row.map(f64::from))
}
