//! The file of a PostScript document and the comments that give its structure (Adobe Technical Note 5001,
//! Document Structuring Conventions 3.0; Technical Note 5002, Encapsulated PostScript 3.0).
//!
//! What must be known at the beginning of a page, its bounding box and its fonts, is known only when it is
//! drawn. A page that fits into the buffer of its description has its bounding box at the beginning, a
//! longer one, from which parts were let go before, at the end, as the conventions allow.

use super::bounds::Bounds;
use super::font::Fonts;
use super::prolog::PROLOG;
use crate::pdf::content::Drain;
use gks_pipeline::device::{DeviceError, Sink};
use std::fmt::Write as _;

/// The kind of a document.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Pages to be printed.
    Printed,
    /// One page to be placed on the page of another document.
    Encapsulated,
}

/// A PostScript file being written.
pub(crate) struct Document {
    sink: Box<dyn Sink>,
    kind: Kind,
    size: (f64, f64),
    opened: bool,
    /// Number of pages begun.
    pages: u32,
    /// Whether the beginning of the page is written.
    begun: bool,
    /// Whether that was before the bounding box was known.
    early: bool,
    /// The bounding box of the page.
    pub(crate) bounds: Bounds,
    /// The bounding box of all pages.
    all: Bounds,
    /// The fonts of the page.
    pub(crate) fonts: Fonts,
    /// The names of all fonts in the document.
    names: Vec<String>,
    out: Vec<u8>,
}

impl Document {
    /// A document that is not begun yet, with pages of a size in points.
    pub(crate) fn new(sink: Box<dyn Sink>, kind: Kind, size: (f64, f64)) -> Self {
        Document {
            sink,
            kind,
            size,
            opened: false,
            pages: 0,
            begun: false,
            early: false,
            bounds: Bounds::default(),
            all: Bounds::default(),
            fonts: Fonts::default(),
            names: Vec::new(),
            out: Vec::new(),
        }
    }

    /// Starts a page.
    pub(crate) fn begin_page(&mut self) -> Result<(), DeviceError> {
        if !self.opened {
            self.sink.open()?;
            self.opened = true;
            if self.kind == Kind::Printed {
                self.header("(atend)", "(atend)");
            }
        }
        self.pages += 1;
        self.begun = false;
        self.bounds = Bounds::default();
        self.fonts = Fonts::default();
        Ok(())
    }

    /// Starts the page over, unless a part of it has been let go.
    pub(crate) fn restart_page(&mut self) -> bool {
        if !self.begun {
            self.bounds = Bounds::default();
            self.fonts = Fonts::default();
        }
        !self.begun
    }

    /// Completes a page, of which `text` is the last part.
    pub(crate) fn end_page(&mut self, text: &mut Vec<u8>) -> Result<(), DeviceError> {
        if !self.begun {
            self.page_header(true);
        }
        self.drain(text)?;
        self.put("page restore end showpage\n");
        self.all.add(&self.bounds);
        match self.kind {
            Kind::Printed if self.early => {
                self.put(&format!("%%PageTrailer\n%%PageBoundingBox: {}\n", self.bounds));
            }
            Kind::Printed => {}
            Kind::Encapsulated => {
                self.put("%%Trailer\n");
                if self.early {
                    self.put(&format!(
                        "%%BoundingBox: {}\n%%HiResBoundingBox: {:#}\n",
                        self.bounds, self.bounds
                    ));
                }
                return self.trailer();
            }
        }
        self.pass()
    }

    /// Completes the document after its last page.
    pub(crate) fn close(&mut self) -> Result<(), DeviceError> {
        if !self.opened {
            return Ok(());
        }
        self.put(&format!(
            "%%Trailer\n%%Pages: {}\n%%BoundingBox: {}\n%%HiResBoundingBox: {:#}\n",
            self.pages, self.all, self.all
        ));
        self.trailer()
    }

    /// The comments at the beginning, and the prolog.
    fn header(&mut self, bounds: &str, fine: &str) {
        let (version, pages) = match self.kind {
            Kind::Printed => ("%!PS-Adobe-3.0", "(atend)"),
            Kind::Encapsulated => ("%!PS-Adobe-3.0 EPSF-3.0", "1"),
        };
        let mut text = format!(
            "{version}\n%%Creator: GKS\n%%LanguageLevel: 3\n%%DocumentData: Clean7Bit\n\
             %%BoundingBox: {bounds}\n%%HiResBoundingBox: {fine}\n%%Pages: {pages}\n\
             %%DocumentSuppliedResources: (atend)\n"
        );
        let (width, height) = self.size;
        let (name, feature) = match (width, height) {
            (595.28, 841.89) => ("A4", "*PageSize A4"),
            _ => ("Sheet", "*CustomPageSize True"),
        };
        if self.kind == Kind::Printed {
            let _ = write!(text, "%%PageOrder: Ascend\n%%DocumentMedia: {name} {width} {height} 0 () ()\n");
        }
        text.push_str("%%EndComments\n");
        text.push_str(PROLOG);
        if self.kind == Kind::Printed {
            let _ = write!(
                text,
                "%%BeginSetup\n%%BeginFeature: {feature}\n\
                 <</PageSize[{width} {height}]>>setpagedevice\n%%EndFeature\n%%EndSetup\n"
            );
        }
        self.put(&text);
    }

    /// The beginning of a page, with its bounding box if that is `known`.
    fn page_header(&mut self, known: bool) {
        self.begun = true;
        self.early = !known;
        let late = "(atend)".to_owned();
        let bounds = if known { self.bounds.to_string() } else { late.clone() };
        if self.kind == Kind::Encapsulated {
            let fine = if known { format!("{:#}", self.bounds) } else { late };
            self.header(&bounds, &fine);
            self.put("%%Page: 1 1\n");
        } else {
            self.put(&format!("%%Page: {} {}\n%%PageBoundingBox: {bounds}\n", self.pages, self.pages));
        }
        self.put(
            "%%BeginPageSetup\nGKS begin/page save def\n\
             .01 dup scale 0 J 0 j 10 setmiterlimit[]0 d\n%%EndPageSetup\n",
        );
    }

    /// What ends the file.
    fn trailer(&mut self) -> Result<(), DeviceError> {
        self.put("%%DocumentSuppliedResources: procset GKS 1.0 0\n");
        for name in std::mem::take(&mut self.names) {
            self.put(&format!("%%+ font {name}\n"));
        }
        self.put("%%EOF\n");
        self.pass()?;
        self.sink.finish()?;
        self.opened = false;
        self.pages = 0;
        self.all = Bounds::default();
        Ok(())
    }

    fn put(&mut self, text: &str) {
        self.out.extend_from_slice(text.as_bytes());
    }

    fn pass(&mut self) -> Result<(), DeviceError> {
        self.sink.write(&self.out)?;
        self.out.clear();
        Ok(())
    }
}

impl Drain for Document {
    /// Lets a part of the page go, behind the fonts that it needs.
    fn drain(&mut self, text: &mut Vec<u8>) -> Result<(), DeviceError> {
        if !self.begun {
            self.page_header(false);
        }
        self.fonts.write(&mut self.names, &mut self.out)?;
        self.pass()?;
        self.sink.write(text)?;
        text.clear();
        Ok(())
    }
}
