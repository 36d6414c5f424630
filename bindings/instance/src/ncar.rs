//! What programs of NCAR Graphics expect of every binding.

use crate::{Dialect, Instance, with};
use gks::Function;
use gks_pipeline::look::InteriorStyle;
use std::ops::RangeInclusive;

/// The workstation type of a metafile.
const METAFILE: i32 = 1;

/// The name of a metafile that a program gives none.
const USUAL_NAME: &str = "gmeta";

/// The ESCAPE that gives the name of the next metafile.
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

    /// OPEN WORKSTATION, where a metafile takes the name that a program gave before in the way of its dialect.
    pub fn open_workstation(&mut self, workstation: i32, connection: &str, kind: i32) -> gks::Result<()> {
        if self.dialect == Dialect::Xgks {
            return self.open_xgks_workstation(workstation, connection, kind);
        }
        if self.dialect != Dialect::Ncar || kind != METAFILE {
            return self.gks.open_workstation(workstation, connection, kind);
        }
        let name = self.metafile_name.take();
        self.gks.open_workstation(workstation, name.as_deref().unwrap_or(USUAL_NAME), kind)
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
    fn names_end_with_blanks_or_a_zero_byte() {
        assert_eq!(name(b"plot.ncgm      "), Some("plot.ncgm".to_owned()));
        assert_eq!(name(b"plot.ncgm\0rest"), Some("plot.ncgm".to_owned()));
        assert_eq!(name(b"     "), None);
    }
}
