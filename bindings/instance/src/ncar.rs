//! What programs of NCAR Graphics expect of every binding.

use crate::{Dialect, Instance, with};
use gks::Function;
use gks_pipeline::generated::numbers::NOMINAL_HATCH_SPACING;
use gks_pipeline::look::{Cap, InteriorStyle, Join};
use gks_pipeline::tables::NominalSize;
use std::ops::RangeInclusive;

/// The ESCAPEs that have an effect. Their records are text: but for the first one numbers, which begin with that of a
/// workstation where they are not about paper.
mod escape {
    /// The name of the file of the next workstation.
    pub(super) const FILE_NAME: i32 = -1391;
    /// The spacing of hatches, as a part of the unit square.
    pub(super) const HATCH_SPACING: i32 = -1513;
    /// A factor for the nominal linewidth.
    pub(super) const LINEWIDTH: i32 = -1516;
    /// The joins of lines, as PostScript numbers them.
    pub(super) const JOIN: i32 = -1518;
    /// The ends of lines, as PostScript numbers them.
    pub(super) const CAP: i32 = -1519;
    /// Where on paper the unit square lies: x and y of its lower left corner and of its upper right one.
    pub(super) const PLACE: i32 = -1521;
    /// The width of paper.
    pub(super) const PAPER_WIDTH: i32 = -1529;
    /// The height of paper.
    pub(super) const PAPER_HEIGHT: i32 = -1530;

    pub(super) const ALL: [i32; 8] =
        [FILE_NAME, HATCH_SPACING, LINEWIDTH, JOIN, CAP, PLACE, PAPER_WIDTH, PAPER_HEIGHT];
}

/// Whether the record of an ESCAPE of NCAR Graphics is text with a meaning here.
pub fn ncar_record_is_read(identifier: i32) -> bool {
    escape::ALL.contains(&identifier)
}

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

/// The numbers in the record of an escape.
fn numbers(record: &[u8]) -> Vec<f64> {
    let text = crate::from_latin1(record);
    let words = text.split(|c: char| c.is_whitespace() || c == '\0');
    words.filter(|word| !word.is_empty()).map_while(|word| word.parse().ok()).collect()
}

/// The lines for the error file in the form that NCAR Graphics gives them, which names subroutines.
pub(crate) fn message(number: i32, function: Option<Function>, text: &str) -> String {
    let subroutine = function.and_then(|function| function.fortran().first().copied()).unwrap_or_default();
    format!(" GKS ERROR NUMBER{number:5} ISSUED FROM SUBROUTINE {subroutine:<6}:\n --{text}\n")
}

impl Instance {
    /// Does what an ESCAPE with one of the identifiers of NCAR Graphics asks for, whose record is text; nothing happens
    /// for another identifier. Whether it was one. Most are without effect; so are all about workstations that are not
    /// open or draw nothing.
    pub fn ncar_escape(&mut self, identifier: i32, record: &[u8]) -> bool {
        if self.dialect != Dialect::Ncar || !IDENTIFIERS.contains(&identifier) {
            return false;
        }
        if identifier == escape::FILE_NAME {
            self.metafile_name = name(record);
        } else {
            // What a workstation cannot do is left undone.
            let _ = self.numeric_escape(identifier, &numbers(record));
        }
        true
    }

    /// Does what an ESCAPE with numbers asks for.
    fn numeric_escape(&mut self, identifier: i32, numbers: &[f64]) -> gks::Result<()> {
        let gks = &mut self.gks;
        match (identifier, numbers) {
            (escape::HATCH_SPACING, &[workstation, spacing]) => gks.set_nominal_size(
                workstation as i32,
                NominalSize::HatchSpacing,
                spacing / NOMINAL_HATCH_SPACING,
            ),
            (escape::LINEWIDTH, &[workstation, factor]) => {
                gks.set_nominal_size(workstation as i32, NominalSize::Linewidth, factor)
            }
            (escape::JOIN, &[_, join]) => {
                Join::from_number(join as i32).map_or(Ok(()), |join| gks.set_line_join(join))
            }
            (escape::CAP, &[_, cap]) => {
                Cap::from_number(cap as i32).map_or(Ok(()), |cap| gks.set_line_cap(cap))
            }
            (escape::PLACE, &[left, bottom, right, top]) => {
                self.paper.square = Some([left, bottom, right, top]);
                Ok(())
            }
            (escape::PAPER_WIDTH | escape::PAPER_HEIGHT, &[side]) => {
                self.paper.size[usize::from(identifier == escape::PAPER_HEIGHT)] = Some(side);
                Ok(())
            }
            _ => Ok(()),
        }
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
        if self.dialect != Dialect::Ncar {
            return self.gks.open_workstation(workstation, connection, kind);
        }
        let name = file_name(kind, workstation, &mut self.metafile_name);
        let name = name.as_deref().unwrap_or(connection);
        let Some(paper) = self.paper.of(kind, &self.environment) else {
            return self.gks.open_workstation(workstation, name, kind);
        };
        self.gks.open_workstation(workstation, &paper.connection(name), kind)?;
        paper.place(&mut self.gks, workstation, kind)
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
    fn records_are_numbers_that_blanks_separate() {
        assert_eq!(numbers(b"    1 0.0500000     "), [1.0, 0.05]);
        assert_eq!(numbers(b"       -90       -15       710       785\0"), [-90.0, -15.0, 710.0, 785.0]);
        assert_eq!(numbers(b"     "), []);
    }

    #[test]
    fn names_end_with_blanks_or_a_zero_byte() {
        assert_eq!(name(b"plot.ncgm      "), Some("plot.ncgm".to_owned()));
        assert_eq!(name(b"plot.ncgm\0rest"), Some("plot.ncgm".to_owned()));
        assert_eq!(name(b"     "), None);
    }
}
