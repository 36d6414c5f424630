//! Segments.

use super::argument::{Address, call, call_as, inquire, integer, list};
use super::control::kind;
use super::function::SET_SEGMENT_ATTRIBUTES;
use super::types::{Gchar, Gfloat, Gint, Gintlist, Gmatrix};
use gks::{Detectability, Function, Gks, Highlighting, SegmentAttributes, Visibility};
use gks_instance::Instance;

/// The attributes of a segment, as a program hands them over and gets them.
#[repr(C)]
#[derive(Copy, Clone, Debug)]
pub(crate) struct Gsegattr {
    seg: Gint,
    segtran: Gmatrix,
    /// 0 visible, 1 invisible.
    vis: Gint,
    hilight: Gint,
    pri: Gfloat,
    det: Gint,
}

/// What changing the attributes of a segment leads to.
#[repr(C)]
#[derive(Copy, Clone, Debug)]
pub(crate) struct Gmodseg {
    transform: Gint,
    appear: Gint,
    disappear: Gint,
    highlight: Gint,
    priority: Gint,
    addition: Gint,
    deletion: Gint,
}

/// Functions of one or two numbers.
macro_rules! functions {
    ($($name:ident($($argument:ident),*) $function:ident => $method:ident;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name($($argument: Gint),*) -> Gint {
            call(Function::$function, |gks| gks.$method($($argument),*))
        }
    )+ };
}

functions! {
    gcreateseg(name) CreateSegment => create_segment;
    grenameseg(old, new) RenameSegment => rename_segment;
    gdelseg(name) DeleteSegment => delete_segment;
    gdelsegws(ws_id, name) DeleteSegmentFromWorkstation => delete_segment_from_workstation;
    gassocsegws(ws_id, name) AssociateSegmentWithWorkstation => associate_segment_with_workstation;
    gcopysegws(ws_id, name) CopySegmentToWorkstation => copy_segment_to_workstation;
    gredrawsegws(ws_id) RedrawAllSegmentsOnWorkstation => redraw_all_segments_on_workstation;
}

/// CLOSE SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn gcloseseg() -> Gint {
    call(Function::CloseSegment, Gks::close_segment)
}

/// INSERT SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn ginsertseg(name: Gint, matrix: Address<Gmatrix>) -> Gint {
    const F: Function = Function::InsertSegment;
    call(F, |gks| gks.insert_segment(name, matrix.get(F)?.map(|row| row.map(f64::from))))
}

/// Sets all attributes of a segment at once.
#[unsafe(no_mangle)]
extern "C" fn gsetsegattr(name: Gint, attributes: Address<Gsegattr>) -> Gint {
    const F: Function = Function::SetSegmentTransformation;
    call_as(Some(SET_SEGMENT_ATTRIBUTES), F, |Instance { gks, .. }| {
        let Gsegattr { segtran, vis, hilight, pri, det, .. } = attributes.get(F)?;
        gks.set_segment_transformation(name, segtran.map(|row| row.map(f64::from)))?;
        gks.set_visibility(name, if vis == 0 { Visibility::Visible } else { Visibility::Invisible })?;
        gks.set_highlighting(
            name,
            if hilight == 0 { Highlighting::Normal } else { Highlighting::Highlighted },
        )?;
        gks.set_segment_priority(name, pri.into())?;
        let detectability = if det == 0 { Detectability::Undetectable } else { Detectability::Detectable };
        gks.set_detectability(name, detectability)
    })
}

/// INQUIRE SEGMENT ATTRIBUTES, of the segment that the structure names.
#[unsafe(no_mangle)]
extern "C" fn ginqsegattr(attributes: Address<Gsegattr>) -> Gint {
    const F: Function = Function::InquireSegmentAttributes;
    inquire(F, |gks| {
        let seg = attributes.get(F)?.seg;
        let SegmentAttributes { transformation, visibility, highlighting, priority, detectability } =
            gks.inquire_segment_attributes(seg)?;
        attributes.set(Gsegattr {
            seg,
            segtran: transformation.map(|row| row.map(|v| v as Gfloat)),
            vis: (visibility == Visibility::Invisible).into(),
            hilight: (highlighting == Highlighting::Highlighted).into(),
            pri: priority as Gfloat,
            det: (detectability == Detectability::Detectable).into(),
        });
        Ok(())
    })
}

/// INQUIRE NAME OF OPEN SEGMENT.
#[unsafe(no_mangle)]
extern "C" fn ginqnameopenseg(name: Address<Gint>) -> Gint {
    inquire(Function::InquireNameOfOpenSegment, |gks| {
        name.set(gks.inquire_name_of_open_segment()?);
        Ok(())
    })
}

/// INQUIRE SET OF SEGMENT NAMES IN USE.
#[unsafe(no_mangle)]
extern "C" fn ginqsegnames(names: Address<Gintlist>) -> Gint {
    inquire(Function::InquireSetOfSegmentNamesInUse, |gks| {
        names.set(list(gks.inquire_set_of_segment_names_in_use()?));
        Ok(())
    })
}

/// INQUIRE SET OF SEGMENT NAMES ON WORKSTATION.
#[unsafe(no_mangle)]
extern "C" fn ginqsegnamesws(ws_id: Gint, names: Address<Gintlist>) -> Gint {
    inquire(Function::InquireSetOfSegmentNamesOnWorkstation, |gks| {
        names.set(list(gks.inquire_set_of_segment_names_on_workstation(ws_id)?));
        Ok(())
    })
}

/// INQUIRE SET OF ASSOCIATED WORKSTATIONS.
#[unsafe(no_mangle)]
extern "C" fn ginqassocws(name: Gint, workstations: Address<Gintlist>) -> Gint {
    inquire(Function::InquireSetOfAssociatedWorkstations, |gks| {
        workstations.set(list(gks.inquire_set_of_associated_workstations(name)?));
        Ok(())
    })
}

/// INQUIRE NUMBER OF SEGMENT PRIORITIES SUPPORTED.
#[unsafe(no_mangle)]
extern "C" fn ginqnumsegpri(ws_type: Address<Gchar>, number: Address<Gint>) -> Gint {
    inquire(Function::InquireNumberOfSegmentPrioritiesSupported, |gks| {
        number.set(integer(gks.inquire_number_of_segment_priorities_supported(kind(ws_type))?));
        Ok(())
    })
}

/// INQUIRE DYNAMIC MODIFICATION OF SEGMENT ATTRIBUTES.
#[unsafe(no_mangle)]
extern "C" fn ginqmodsegattr(ws_type: Address<Gchar>, modification: Address<Gmodseg>) -> Gint {
    inquire(Function::InquireDynamicModificationOfSegmentAttributes, |gks| {
        let is = gks.inquire_dynamic_modification_of_segment_attributes(kind(ws_type))?;
        modification.set(Gmodseg {
            transform: is.transformation as Gint,
            appear: is.appearing as Gint,
            disappear: is.disappearing as Gint,
            highlight: is.highlighting as Gint,
            priority: is.priority as Gint,
            addition: is.adding as Gint,
            deletion: is.deletion as Gint,
        });
        Ok(())
    })
}
