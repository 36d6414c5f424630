//! The header of a GKSM: 90 characters.

use super::formatted::newline;
use gks_pipeline::record::item::Convention;

/// The length of a header.
pub(super) const LENGTH: usize = 90;

/// The length of the part that is always there.
const SHORT: usize = 68;

/// What stands for an author in the headers that are written here.
const AUTHOR: &str = concat!("gks ", env!("CARGO_PKG_VERSION"));

/// How the numbers of a metafile are coded.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Header {
    /// The author or the installation.
    pub(super) author: String,
    /// The number of bytes of the word GKSM before every item.
    pub(super) mark: usize,
    /// The lengths of the fields for types of items, lengths of their data, integers and reals.
    pub(super) kind: usize,
    pub(super) length: usize,
    pub(super) integer: usize,
    pub(super) real: usize,
    /// Whether numbers are text.
    pub(super) formatted: bool,
    /// The integers that stand for 0.0 and 1.0 where reals are integers.
    pub(super) scale: Option<(i32, i32)>,
    /// The number of bytes of the header in the file.
    pub(super) size: usize,
}

/// Whether a file that begins with these bytes is a GKSM.
pub(crate) fn is_header(head: &[u8]) -> bool {
    Header::parse(head).is_some()
}

impl Header {
    /// The header of what is written here: binary numbers as the kernel codes them, or formatted ones in fields
    /// that hold any number to the last digit and a blank before it.
    pub(super) fn own(formatted: bool) -> Header {
        let (kind, length, integer, real) = if formatted { (11, 11, 12, 25) } else { (4, 4, 4, 8) };
        Header {
            author: AUTHOR.to_owned(),
            mark: 4,
            kind,
            length,
            integer,
            real,
            formatted,
            scale: None,
            size: LENGTH,
        }
    }

    /// How the author reads the standard.
    pub(super) fn convention(&self) -> Convention {
        match self.author.as_str() {
            author if author.starts_with("gks ") => Convention::Own,
            author if author.contains("SunGKS") => Convention::Sun,
            author if author.starts_with("GKSGRAL") => Convention::Gral,
            author if author.to_ascii_uppercase().contains("XGKS") => Convention::Xgks,
            _ => Convention::Ral,
        }
    }

    /// Whether reals without a point are ten-millionths.
    pub(super) fn implies_point(&self) -> bool {
        self.scale.is_none() && (self.author.contains("U N I G K S") || self.author.contains("UNIRAS"))
    }

    /// The header as text; `date` is of the form yy/mm/dd.
    pub(super) fn text(&self, date: &str) -> String {
        let Header { author, mark, kind, length, integer, real, formatted, .. } = self;
        let form = if *formatted { 1 } else { 2 };
        let (zero, one) = self.scale.unwrap_or((0, 1));
        let reals = if self.scale.is_some() { 2 } else { 1 };
        format!(
            "GKSM{author:<40.40}{date:<8.8}{:2}{mark:2}{kind:2}{length:2}{integer:2}{real:2}{form:2}{reals:2}\
             {zero:11}{one:11}",
            1
        )
    }

    /// The header at the beginning of a file.
    pub(super) fn parse(head: &[u8]) -> Option<Header> {
        // The header may be cut into lines, and may end before what only integers for reals need.
        let mut text = Vec::with_capacity(LENGTH);
        let mut size = 0;
        for &byte in head {
            if text.len() == LENGTH || (text.len() == SHORT && newline(byte)) {
                break;
            }
            size += 1;
            if !newline(byte) {
                text.push(byte);
            }
        }
        let head = text.as_slice();
        let fixed = head.get(..SHORT)?;
        if !fixed.starts_with(b"GKSM") {
            return None;
        }
        let number = |from: usize, width: usize| -> Option<i32> {
            str::from_utf8(head.get(from..from + width)?).ok()?.trim().parse().ok()
        };
        let width = |from: usize| number(from, 2).and_then(|n| usize::try_from(n).ok());
        let (mark, kind, length, integer, real) =
            (width(54)?, width(56)?, width(58)?, width(60)?, width(62)?);
        let formatted = match number(64, 2)? {
            1 => true,
            2 => false,
            _ => return None,
        };
        let scale = match number(66, 2)? {
            1 => None,
            2 => Some((number(68, 11)?, number(79, 11)?)),
            _ => return None,
        };
        if mark > 4
            || [kind, length, integer, real].contains(&0)
            || scale.is_some_and(|(zero, one)| zero == one)
        {
            return None;
        }
        let author = String::from_utf8_lossy(&fixed[4..44]).trim().to_owned();
        Some(Header { author, mark, kind, length, integer, real, formatted, scale, size })
    }
}
