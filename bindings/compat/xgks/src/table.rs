//! The table of open workstations, into which programs look.
//!
//! XGKS never meant it for them, but Ferret and its tools include the private headers and read the kind of a
//! workstation, the kind of its metafile, and the display of its window. Those members are here at their places
//! (64-bit layout, as compiled programs have it built in); all others are zero, as is the display, since there is none.

use std::collections::BTreeMap;
use std::ffi::{c_char, c_int, c_void};
use std::ptr;
use std::sync::{Mutex, PoisonError};

/// Kinds of workstations.
const WINDOW: c_int = 1;
const SEGMENT_STORAGE: c_int = 2;
const METAFILE_INPUT: c_int = 3;
const METAFILE_OUTPUT: c_int = 4;

/// Kinds of metafiles.
const GKSM: c_int = 0;
const GIF: c_int = 3;

/// The bytes from the metafile to the end of an entry, more than XGKS has.
const REST: usize = 4096 - 0x28;

/// What programs know of a metafile: its kind comes first.
#[repr(C)]
struct Metafile {
    kind: c_int,
    rest: [u8; 252],
}

/// An entry of the table.
#[repr(C)]
pub(crate) struct Entry {
    id: c_int,
    connection: *const c_char,
    kind_name: *const c_char,
    kind: c_int,
    is_closing: c_int,
    metafile: *const Metafile,
    rest: [u8; REST],
}

/// An entry and what it points to; both stay where they are.
struct Row {
    entry: Box<Entry>,
    metafile: Box<Metafile>,
}

// SAFETY: the pointers lead to what the row itself owns, or are null.
unsafe impl Send for Row {}

static TABLE: Mutex<BTreeMap<c_int, Row>> = Mutex::new(BTreeMap::new());

impl Row {
    fn new(id: c_int) -> Row {
        let metafile = Box::new(Metafile { kind: GKSM, rest: [0; 252] });
        let entry = Entry {
            id,
            connection: ptr::null(),
            kind_name: ptr::null(),
            kind: 0,
            is_closing: 0,
            metafile: ptr::null(),
            rest: [0; REST],
        };
        Row { entry: Box::new(entry), metafile }
    }
}

/// The entry of an open workstation; a null pointer for one that is not open. It stays where it is.
#[unsafe(no_mangle)]
extern "C" fn XgksValidWsId(ws_id: c_int) -> *mut Entry {
    let found = gks_instance::with(|instance| {
        let (_, kind) = instance.gks.inquire_workstation_connection_and_type(ws_id).ok()?;
        Some((kind, instance.keeps_picture(ws_id)))
    });
    let Some((kind, keeps_picture)) = found else { return ptr::null_mut() };
    let mut table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
    let row = table.entry(ws_id).or_insert_with(|| Row::new(ws_id));
    row.metafile.kind = if keeps_picture { GIF } else { GKSM };
    row.entry.kind = match kind {
        1 => METAFILE_INPUT,
        2 => METAFILE_OUTPUT,
        3 => SEGMENT_STORAGE,
        _ => WINDOW,
    };
    let has_metafile = matches!(row.entry.kind, METAFILE_INPUT | METAFILE_OUTPUT);
    row.entry.metafile = if has_metafile { ptr::from_ref(&*row.metafile) } else { ptr::null() };
    ptr::from_mut(&mut *row.entry)
}

/// The workstation whose entry has its metafile at an address.
pub(crate) fn workstation_of(metafile: *const c_void) -> Option<c_int> {
    let table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
    let is_there = |row: &&Row| ptr::from_ref(&row.entry.metafile).cast::<c_void>() == metafile;
    table.values().find(is_there).map(|row| row.entry.id)
}

/// The workstation of an entry.
pub(crate) fn workstation_at(entry: *const Entry) -> Option<c_int> {
    let table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
    table.values().find(|row| ptr::eq(&raw const *row.entry, entry)).map(|row| row.entry.id)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::mem::offset_of;

    /// Where compiled programs look for the members.
    #[test]
    fn members_are_where_programs_expect_them() {
        assert_eq!(offset_of!(Entry, id), 0);
        assert_eq!(offset_of!(Entry, connection), 0x08);
        assert_eq!(offset_of!(Entry, kind_name), 0x10);
        assert_eq!(offset_of!(Entry, kind), 0x18);
        assert_eq!(offset_of!(Entry, metafile), 0x20);
        assert_eq!(offset_of!(Metafile, kind), 0);
        // The display of a window is at 0x768, the window at 0x7a8.
        assert!(size_of::<Entry>() > 0x7b0);
    }

    #[test]
    fn a_workstation_that_is_not_open_has_no_entry() {
        assert!(XgksValidWsId(4711).is_null());
    }
}
