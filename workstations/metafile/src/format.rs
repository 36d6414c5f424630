//! Which format a metafile has, by its content.

use crate::cgm::{self, Encoding};
use crate::gksm;
use crate::input::Input;
use gks_pipeline::record::item::Convention;
use gks_pipeline::record::{Source, SourceError};
use std::fmt;
use std::io::Read;

/// The formats of metafiles that can be read.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Format {
    /// The metafile of GKS, in any of its codings.
    Gksm,
    /// The Computer Graphics Metafile.
    Cgm(Encoding),
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Format::Gksm => "GKSM",
            Format::Cgm(Encoding::Binary) => "CGM, binary",
            Format::Cgm(Encoding::Text) => "CGM, clear text",
            Format::Cgm(Encoding::Character) => "CGM, characters",
            Format::Cgm(Encoding::Ncgm) => "CGM, binary in records of NCAR",
        })
    }
}

/// The first bytes of a file that decide on its format, at least as many as there are.
pub(crate) const HEAD: usize = 4096;

impl Format {
    /// The format of a file that begins with these bytes, if it is a metafile that can be read.
    pub fn of(head: &[u8]) -> Option<Format> {
        if gksm::is_header(head) {
            return Some(Format::Gksm);
        }
        Encoding::of(head).map(Format::Cgm)
    }
}

/// How a metafile is to be read where the file does not say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions {
    /// Whose switches the UPDATE and VISIBILITY items of a GKSM have, whatever the name of its author says.
    pub items: Option<Convention>,
}

/// A metafile that can be read.
pub struct Opened {
    /// Its format.
    pub format: Format,
    /// Its records.
    pub source: Box<dyn Source>,
}

/// The records in the bytes of a metafile, whose format is found by its content.
///
/// Bytes are read as records are asked for. An error says that no format is known that begins so, or that the
/// beginning of the metafile makes no sense.
pub fn open_source(bytes: impl Read + Send + 'static, options: &ReadOptions) -> Result<Opened, SourceError> {
    let mut input = Input::new(bytes);
    let Some(format) = Format::of(input.peek(HEAD)?) else {
        let what = "neither GKSM nor CGM".to_owned();
        return Err(SourceError::Malformed { offset: 0, what });
    };
    let source: Box<dyn Source> = match format {
        Format::Gksm => Box::new(gksm::Reader::new(input, options)?),
        Format::Cgm(encoding) => cgm::open(input, encoding),
    };
    Ok(Opened { format, source })
}
