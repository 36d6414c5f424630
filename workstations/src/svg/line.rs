//! Lines and areas as path elements.

use super::COORDINATE;
use super::document::{Document, attribute, open_attribute, paint};
use super::path::PathData;
use crate::route::{Route, Track};
use gks_geometry::{Du, Paths, Pieces, Rect};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::device::{DeviceError, Pen, Rule};
use gks_pipeline::look::{Cap, Join};

/// One element of path data, which is begun with its first path.
struct Element<'d, 'p> {
    data: PathData<'d>,
    clip: Option<&'p Rect<Du>>,
    /// What writes the attributes of the group that the element belongs to.
    attributes: &'p dyn Fn(&mut Vec<u8>),
    /// What they are of.
    what: What<'p>,
    begun: bool,
}

/// What an element draws.
#[derive(Copy, Clone)]
enum What<'p> {
    /// Lines of a pen.
    Lines(&'p Pen<'p>),
    /// Areas, of the colour that the attributes call `currentColor`, if they do.
    Areas(Option<Colour>),
}

impl<'d, 'p> Element<'d, 'p> {
    fn new(
        document: &'d mut Document,
        clip: Option<&'p Rect<Du>>,
        attributes: &'p dyn Fn(&mut Vec<u8>),
        what: What<'p>,
    ) -> Self {
        Element { data: PathData::new(document, COORDINATE), clip, attributes, what, begun: false }
    }

    fn end(self) {
        if self.begun {
            self.data.document.raw("\"/>\n");
        }
    }
}

impl Track for Element<'_, '_> {
    fn start(&mut self, at: [i64; 2]) -> Result<(), DeviceError> {
        if !self.begun {
            self.begun = true;
            let document = &mut *self.data.document;
            let own = match self.what {
                What::Lines(pen) => {
                    document.pen_group(self.clip, pen, self.attributes);
                    None
                }
                What::Areas(colour) => {
                    let is_own = document.coloured_group(self.clip, colour, self.attributes);
                    colour.filter(|_| is_own)
                }
            };
            document.raw("<path");
            if let Some(colour) = own {
                paint(&mut document.out, "color", colour);
            }
            document.raw(" d=\"");
        }
        Ok(self.data.start(at)?)
    }

    #[inline]
    fn line(&mut self, _: [i64; 2], to: [i64; 2]) -> Result<(), DeviceError> {
        Ok(self.data.line(to)?)
    }

    fn finish(&mut self, closed: bool) -> Result<(), DeviceError> {
        if closed {
            self.data.close();
        }
        Ok(())
    }
}

/// Draws lines, with all paths in one element and all dots in another, as wide as the pen and square unless its
/// ends are round. A line that ends where it started has a corner there.
pub(super) fn lines(
    document: &mut Document,
    route: &mut Route,
    clip: Option<&Rect<Du>>,
    paths: &impl Pieces,
    pen: &Pen<'_>,
) -> Result<(), DeviceError> {
    let attributes = |out: &mut Vec<u8>| stroke(out, pen);
    let mut element = Element::new(document, clip, &attributes, What::Lines(pen));
    route.lines(paths, &mut element)?;
    element.end();
    if !route.dots.is_empty() {
        document.group(clip, attributes);
        document.raw("<path");
        if pen.cap == Cap::Butt {
            document.raw(" stroke-linecap=\"square\"");
        }
        if !pen.dash.is_empty() {
            document.raw(" stroke-dasharray=\"none\"");
        }
        document.raw(" d=\"");
        let mut data = PathData::new(document, COORDINATE);
        for dot in &route.dots {
            data.start(*dot)?;
            data.stay();
        }
        document.raw("\"/>\n");
    }
    Ok(())
}

/// Draws the area inside of rings.
pub(super) fn area(
    document: &mut Document,
    route: &mut Route,
    clip: Option<&Rect<Du>>,
    rings: Paths<'_, Du>,
    rule: Rule,
    fill: &Paint,
) -> Result<(), DeviceError> {
    // Viewers antialias every area by itself: what is below would show between neighbours. The cells of a pattern
    // are many rings, which may run along one another with nothing between them.
    let edged = rule == Rule::EvenOdd && fill.colour.alpha >= 1.0 && rings.ends.len() == 1;
    let attributes = |out: &mut Vec<u8>| {
        if edged {
            out.extend_from_slice(b" fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\".5\"");
            return;
        }
        paint(out, "fill", fill.colour);
        if rule == Rule::NonZero {
            out.extend_from_slice(b" fill-rule=\"nonzero\"");
        }
    };
    let mut element = Element::new(document, clip, &attributes, What::Areas(edged.then_some(fill.colour)));
    route.rings(rings.iter().filter(|ring| ring.len() > 2), &mut element)?;
    element.end();
    Ok(())
}

/// Appends the attributes of lines that differ from the initial ones.
pub(super) fn stroke(out: &mut Vec<u8>, pen: &Pen<'_>) {
    paint(out, "stroke", pen.paint.colour);
    let width = pen.width.max(1.0 / COORDINATE.scale());
    if width != 1.0 {
        attribute(out, "stroke-width", width);
    }
    if !pen.dash.is_empty() {
        open_attribute(out, "stroke-dasharray");
        for (i, &length) in pen.dash.iter().enumerate() {
            if i > 0 {
                out.push(b' ');
            }
            COORDINATE.write(out, length);
        }
        out.push(b'"');
    }
    match pen.cap {
        Cap::Butt => {}
        Cap::Round => out.extend_from_slice(b" stroke-linecap=\"round\""),
        Cap::Projecting => out.extend_from_slice(b" stroke-linecap=\"square\""),
    }
    match pen.join {
        Join::Miter => {}
        Join::Round => out.extend_from_slice(b" stroke-linejoin=\"round\""),
        Join::Bevel => out.extend_from_slice(b" stroke-linejoin=\"bevel\""),
    }
}
