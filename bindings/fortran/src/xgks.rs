//! What programs of XGKS expect.

use gks_instance::{Dialect, ErrorFile, Instance, file_of_unit};

/// The workstation type of windows.
const WINDOW: i32 = 4;

/// The connection that a number means: for a metafile the file that is connected to the unit of that number,
/// else, and for a window, the name that the escape GESCID has set. None in another dialect, and for a number that
/// has no such meaning.
pub(crate) fn connection(instance: &Instance, conid: i32, wtype: i32) -> Option<String> {
    if instance.dialect != Dialect::Xgks {
        return None;
    }
    let set = || instance.metafile_name.clone();
    if wtype == WINDOW { Some(set().unwrap_or_default()) } else { file_of_unit(conid).or_else(set) }
}

/// The error file that a unit means: the file that is connected to it, else the standard error output. None in
/// another dialect.
pub(crate) fn error_file(instance: &Instance, unit: i32) -> Option<ErrorFile> {
    let file = || file_of_unit(unit).map_or(ErrorFile::Stderr, |name| ErrorFile::from_name(&name));
    (instance.dialect == Dialect::Xgks).then(file)
}

/// The corners P and Q of CELL ARRAY. XGKS takes them for the lower left and the upper right one, and has the first row of
/// the array at the top.
pub(crate) fn corners(p: (f64, f64), q: (f64, f64)) -> ((f64, f64), (f64, f64)) {
    let is_active = gks_instance::with(|instance| instance.dialect == Dialect::Xgks);
    if is_active { ((p.0, q.1), (q.0, p.1)) } else { (p, q) }
}
