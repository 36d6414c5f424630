//! What programs of NCAR Graphics expect of every binding.

use crate::{Dialect, Instance, with};
use gks::Function;
use gks_pipeline::look::InteriorStyle;
use std::ops::RangeInclusive;

/// The ESCAPE that gives the name of the file of the next workstation.
pub const NCAR_METAFILE_NAME: i32 = -1391;

/// The identifiers of ESCAPE that NCAR Graphics has given out, and those that HLU uses on top of them.
const IDENTIFIERS: RangeInclusive<i32> = -1599..=-1386;

/// The error of a function that cannot be used on workstation independent segment storage.
const IS_WISS: i32 = 36;

/// The interior style in which the utilities fill the outlines of characters.
const SOLID_TEXT: i32 = 4;

/// The interior style that a program means by a number: characters are filled as everything else is.
pub fn interior_style(number: i32) -> i32 {
    if number == SOLID_TEXT && with(|instance| instance.dialect == Dialect::Ncar) {
        InteriorStyle::Solid as i32
    } else {
        number
    }
}

/// How the names of the files of a workstation type begin where the program gives none, and their extension.
fn file_of(kind: i32) -> Option<(&'static str, &'static str)> {
    match kind {
        1 => Some(("gmeta", "")),
        11 | 12 => Some(("gmeta", "pdf")),
        20..=31 => Some(("gmeta", ["ps", "eps", "epsi"][(kind - 20) as usize % 3])),
        40 => Some(("cairo", "ps")),
        41 => Some(("cairo", "png")),
        42 => Some(("cairo", "pdf")),
        43 => Some(("cairo", "tif")),
        45 => Some(("cairo", "eps")),
        47 => Some(("cairo", "svg")),
        _ => None,
    }
}

/// The name of the file that a workstation of a type writes: the one that the program has given, to which only cairo's
/// types add their extension, or that of the type and the identifier of the workstation.
fn file_name(kind: i32, workstation: i32, given: &mut Option<String>) -> Option<String> {
    let (usual, extension) = file_of(kind)?;
    Some(match given.take() {
        Some(name) if usual == "cairo" && !name.ends_with(&format!(".{extension}")) => {
            format!("{name}.{extension}")
        }
        Some(name) => name,
        None if extension.is_empty() => usual.to_owned(),
        None => format!("{usual}{workstation}.{extension}"),
    })
}

/// The name of the metafile in the record of an escape, which blanks or a zero byte end.
fn name(record: &[u8]) -> Option<String> {
    let name = crate::from_latin1(record).trim().to_owned();
    Some(name).filter(|name| !name.is_empty())
}

/// The lines for the error file in the form that NCAR Graphics gives them, which names subroutines.
pub(crate) fn message(number: i32, function: Option<Function>, text: &str) -> String {
    let subroutine = function.and_then(|function| function.fortran().first().copied()).unwrap_or_default();
    format!(" GKS ERROR NUMBER{number:5} ISSUED FROM SUBROUTINE {subroutine:<6}:\n --{text}\n")
}

impl Instance {
    /// Takes note of an ESCAPE with one of the identifiers of NCAR Graphics, whose record is text; nothing
    /// happens for another identifier. Whether it was one. All but the name of a metafile are without effect.
    pub fn ncar_escape(&mut self, identifier: i32, record: &[u8]) -> bool {
        if self.dialect != Dialect::Ncar || !IDENTIFIERS.contains(&identifier) {
            return false;
        }
        if identifier == NCAR_METAFILE_NAME {
            self.metafile_name = name(record);
        }
        true
    }

    /// UPDATE WORKSTATION, which NCAR Graphics allows for workstation independent segment storage: HLU updates
    /// all workstations that are open.
    pub fn update_workstation(&mut self, workstation: i32, perform: bool) -> gks::Result<()> {
        match self.gks.update_workstation(workstation, perform) {
            Err(error) if error.number == IS_WISS && self.dialect == Dialect::Ncar => Ok(()),
            result => result,
        }
    }

    /// OPEN WORKSTATION, where a file has the name that a program gave before in the way of its dialect.
    pub fn open_workstation(&mut self, workstation: i32, connection: &str, kind: i32) -> gks::Result<()> {
        if self.dialect == Dialect::Xgks {
            return self.open_xgks_workstation(workstation, connection, kind);
        }
        let name = match self.dialect {
            Dialect::Ncar => file_name(kind, workstation, &mut self.metafile_name),
            _ => None,
        };
        self.gks.open_workstation(workstation, name.as_deref().unwrap_or(connection), kind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_name_subroutines() {
        let text = message(6, Some(Function::ActivateWorkstation), "Wrong state.");
        assert_eq!(text, " GKS ERROR NUMBER    6 ISSUED FROM SUBROUTINE GACWK :\n --Wrong state.\n");
    }

    #[test]
    fn files_have_the_names_that_programs_of_ncar_know() {
        let name = |kind, given: Option<&str>| file_name(kind, 2, &mut given.map(str::to_owned)).unwrap();
        assert_eq!(
            [1, 12, 20, 25, 31, 41].map(|kind| name(kind, None)),
            ["gmeta", "gmeta2.pdf", "gmeta2.ps", "gmeta2.epsi", "gmeta2.epsi", "cairo2.png"]
        );
        assert_eq!(name(20, Some("plot")), "plot");
        assert_eq!([Some("plot"), Some("plot.png")].map(|given| name(41, given)), ["plot.png"; 2]);
        assert_eq!([3, 8, 10, 100].map(|kind| file_name(kind, 1, &mut None)), [const { None }; 4]);
    }

    #[test]
    fn names_end_with_blanks_or_a_zero_byte() {
        assert_eq!(name(b"plot.ncgm      "), Some("plot.ncgm".to_owned()));
        assert_eq!(name(b"plot.ncgm\0rest"), Some("plot.ncgm".to_owned()));
        assert_eq!(name(b"     "), None);
    }
}
