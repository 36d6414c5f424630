//! The document being written: bytes, groups of equal attributes, clipping paths.
//!
//! The document is never held. Text goes to a small buffer that is handed to the sink whenever it is full;
//! beside it only the attributes of the open group and a few clipping rectangles are remembered.

use super::COORDINATE;
use gks_geometry::{Du, Rect};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::{Pen, Sink};
use gks_pipeline::item::Ellipse;
use gks_pipeline::look::{Cap, Join};
use std::collections::VecDeque;
use std::io;

/// As many bytes are collected before they go to the sink.
const FULL: usize = 1 << 16;

/// As many clipping rectangles are remembered; one that has been forgotten is defined again.
const CLIPS: usize = 64;

/// What the attributes of a pen that draws no dashes depend on.
#[derive(Copy, Clone, PartialEq)]
struct SolidPen {
    colour: Colour,
    width: f64,
    cap: Cap,
    join: Join,
}

impl SolidPen {
    #[inline]
    fn of(pen: &Pen<'_>) -> Option<Self> {
        let Pen { paint, width, cap, join, .. } = *pen;
        pen.dash.is_empty().then_some(SolidPen { colour: paint.colour, width, cap, join })
    }
}

/// A document on its way to the sink.
pub(super) struct Document {
    sink: Box<dyn Sink>,
    /// Text that the sink has not yet got.
    pub(super) out: Vec<u8>,
    /// The number of the clipping path of the open outer group.
    clip: Option<u32>,
    /// The attributes of the open inner group; empty if none is open.
    style: Vec<u8>,
    /// The solid pen that those attributes are of, if it is known.
    pen: Option<SolidPen>,
    /// The colour that elements in the open inner group inherit, as bytes.
    colour: Option<[u8; 4]>,
    /// Where the attributes of the next mark are composed.
    wanted: Vec<u8>,
    clips: VecDeque<([i64; 4], u32)>,
    /// The ellipse that clips, outside of all groups.
    region: Option<Ellipse<Du>>,
    defined: u32,
    images: bool,
}

impl Document {
    pub(super) fn new(sink: Box<dyn Sink>) -> Self {
        Document {
            sink,
            out: Vec::with_capacity(FULL + FULL / 4),
            clip: None,
            style: Vec::new(),
            pen: None,
            colour: None,
            wanted: Vec::new(),
            clips: VecDeque::new(),
            region: None,
            defined: 0,
            images: false,
        }
    }

    /// Opens the next document.
    pub(super) fn open(&mut self) -> io::Result<()> {
        self.reset();
        self.sink.open()
    }

    /// Starts the document over, if that is possible.
    pub(super) fn restart(&mut self) -> io::Result<bool> {
        let restarted = self.sink.restart()?;
        if restarted {
            self.reset();
        }
        Ok(restarted)
    }

    fn reset(&mut self) {
        self.out.clear();
        self.style.clear();
        self.pen = None;
        self.clip = None;
        self.clips.clear();
        self.region = None;
        self.defined = 0;
        self.images = false;
    }

    /// The number of bytes of memory that the document takes.
    #[cfg(test)]
    pub(super) fn held(&self) -> usize {
        let clips = self.clips.capacity() * size_of::<([i64; 4], u32)>();
        self.out.capacity() + self.style.capacity() + self.wanted.capacity() + clips
    }

    /// Whether no image has been announced before in this document; one has been from now on.
    pub(super) fn is_first_image(&mut self) -> bool {
        !std::mem::replace(&mut self.images, true)
    }

    /// Makes an ellipse or a sector of one, whose element `write` writes, what clips.
    #[inline]
    pub(super) fn set_region(
        &mut self,
        region: Option<&Ellipse<Du>>,
        write: impl FnOnce(&mut Document, &Ellipse<Du>) -> io::Result<()>,
    ) -> io::Result<()> {
        if self.region.as_ref() == region { Ok(()) } else { self.change_region(region, write) }
    }

    #[cold]
    fn change_region(
        &mut self,
        region: Option<&Ellipse<Du>>,
        write: impl FnOnce(&mut Document, &Ellipse<Du>) -> io::Result<()>,
    ) -> io::Result<()> {
        self.close_groups();
        if self.region.take().is_some() {
            self.raw("</g>\n");
        }
        if let Some(region) = region {
            self.defined += 1;
            let number = self.defined;
            self.raw(&format!("<clipPath id=\"c{number}\">"));
            write(self, region)?;
            self.raw(&format!("</clipPath>\n<g clip-path=\"url(#c{number})\">\n"));
            self.region = Some(*region);
        }
        Ok(())
    }

    /// Closes all groups but that of the region.
    pub(super) fn close_groups(&mut self) {
        self.close_style();
        self.close_clip();
    }

    /// Completes the document.
    pub(super) fn finish(&mut self) -> io::Result<()> {
        self.flush()?;
        self.sink.finish()
    }

    /// Hands the text to the sink if much has been collected.
    #[inline]
    pub(super) fn spill(&mut self) -> io::Result<()> {
        if self.out.len() >= FULL { self.flush() } else { Ok(()) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.write(&self.out)?;
        self.out.clear();
        Ok(())
    }

    /// Appends text as it is.
    #[inline]
    pub(super) fn raw(&mut self, text: &str) {
        self.out.extend_from_slice(text.as_bytes());
    }

    /// Appends a number with the precision of coordinates.
    #[inline]
    pub(super) fn number(&mut self, value: f64) {
        COORDINATE.write(&mut self.out, value);
    }

    /// Appends an attribute whose value is a number.
    pub(super) fn attribute(&mut self, name: &str, value: f64) {
        attribute(&mut self.out, name, value);
    }

    /// Makes sure that what follows is clipped to `clip` and has the attributes that `compose` writes, with a
    /// space before each one.
    pub(super) fn group(&mut self, clip: Option<&Rect<Du>>, compose: impl FnOnce(&mut Vec<u8>)) {
        self.coloured_group(clip, None, compose);
    }

    /// The same for elements in the colour that attributes call `currentColor`: that of the first one stands in the
    /// group. Answers whether an element must name its own.
    pub(super) fn coloured_group(
        &mut self,
        clip: Option<&Rect<Du>>,
        colour: Option<Colour>,
        compose: impl FnOnce(&mut Vec<u8>),
    ) -> bool {
        let clip = clip.map(|rect| rect.limits().map(|limit| COORDINATE.steps(limit)));
        let known = clip.and_then(|rect| self.clips.iter().find(|(known, _)| *known == rect));
        match (clip, known.map(|&(_, number)| number)) {
            (None, _) if self.clip.is_none() => {}
            (Some(_), Some(number)) if self.clip == Some(number) => {}
            (rect, number) => {
                self.close_groups();
                if let Some(rect) = rect {
                    let number = number.unwrap_or_else(|| self.define_clip(rect));
                    self.raw(&format!("<g clip-path=\"url(#c{number})\">\n"));
                    self.clip = Some(number);
                }
            }
        }
        self.wanted.clear();
        compose(&mut self.wanted);
        if self.wanted != self.style {
            self.close_style();
            std::mem::swap(&mut self.style, &mut self.wanted);
            if !self.style.is_empty() {
                self.out.extend_from_slice(b"<g");
                self.out.extend_from_slice(&self.style);
                if let Some(colour) = colour {
                    paint(&mut self.out, "color", colour);
                }
                self.colour = colour.map(Colour::to_bytes);
                self.out.extend_from_slice(b">\n");
            }
        }
        colour.is_some_and(|colour| self.colour != Some(colour.to_bytes()))
    }

    /// Makes sure that what follows is clipped to `clip` and has the attributes of a pen, which `compose` writes.
    #[inline]
    pub(super) fn pen_group(
        &mut self,
        clip: Option<&Rect<Du>>,
        pen: &Pen<'_>,
        compose: impl FnOnce(&mut Vec<u8>),
    ) {
        let wanted = SolidPen::of(pen);
        if clip.is_some() || self.clip.is_some() || wanted.is_none() || wanted != self.pen {
            self.group(clip, compose);
            self.pen = wanted;
        }
    }

    fn close_style(&mut self) {
        if !self.style.is_empty() {
            self.raw("</g>\n");
            self.style.clear();
            self.pen = None;
        }
    }

    fn close_clip(&mut self) {
        if self.clip.take().is_some() {
            self.raw("</g>\n");
        }
    }

    /// Defines a clipping path for a rectangle given in steps.
    fn define_clip(&mut self, rect: [i64; 4]) -> u32 {
        self.defined += 1;
        let [xmin, xmax, ymin, ymax] = rect;
        self.raw(&format!("<clipPath id=\"c{}\"><path d=\"m", self.defined));
        COORDINATE.write_steps(&mut self.out, xmin);
        self.raw(" ");
        COORDINATE.write_steps(&mut self.out, ymin);
        for (command, steps) in [("h", xmax - xmin), ("v", ymax - ymin), ("h", xmin - xmax)] {
            self.raw(command);
            COORDINATE.write_steps(&mut self.out, steps);
        }
        self.raw("z\"/></clipPath>\n");
        if self.clips.len() == CLIPS {
            self.clips.pop_front();
        }
        self.clips.push_back((rect, self.defined));
        self.defined
    }
}

/// Appends an attribute whose value is a number.
pub(super) fn attribute(out: &mut Vec<u8>, name: &str, value: f64) {
    open_attribute(out, name);
    COORDINATE.write(out, value);
    out.push(b'"');
}

/// Appends the attributes that paint with a colour: `name` is `fill` or `stroke`, or `color` for an opaque one.
pub(super) fn paint(out: &mut Vec<u8>, name: &str, colour: Colour) {
    let [red, green, blue, alpha] = colour.to_bytes();
    open_attribute(out, name);
    out.push(b'#');
    let hexadecimal = |nibble: u8| b"0123456789abcdef"[usize::from(nibble & 15)];
    if [red, green, blue].iter().all(|&byte| byte >> 4 == byte & 15) {
        out.extend([red, green, blue].map(hexadecimal));
    } else {
        out.extend([red, green, blue].iter().flat_map(|&byte| [hexadecimal(byte >> 4), hexadecimal(byte)]));
    }
    out.push(b'"');
    if alpha < 255 {
        out.push(b' ');
        out.extend_from_slice(name.as_bytes());
        out.extend_from_slice(b"-opacity=\"");
        crate::number::Decimal::new(3).bare().write(out, f64::from(alpha) / 255.0);
        out.push(b'"');
    }
}

/// Appends the beginning of an attribute up to its value.
pub(super) fn open_attribute(out: &mut Vec<u8>, name: &str) {
    out.push(b' ');
    out.extend_from_slice(name.as_bytes());
    out.extend_from_slice(b"=\"");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_short_and_opacity_is_written_only_if_there_is_some() {
        let text = |red, green, blue, alpha| {
            let mut out = Vec::new();
            paint(&mut out, "fill", Colour { red, green, blue, alpha });
            String::from_utf8(out).unwrap()
        };
        assert_eq!(text(1.0, 0.0, 0.2, 1.0), " fill=\"#f03\"");
        assert_eq!(text(0.5, 0.0, 1.0, 1.0), " fill=\"#8000ff\"");
        assert_eq!(text(0.0, 0.0, 0.0, 0.5), " fill=\"#000\" fill-opacity=\".502\"");
    }
}
