//! Text: strings in parts, restricted text, and characters out of octets.

use super::{Drawing, Interpreter};
use crate::cgm::decoder::Decoder;
use crate::cgm::element::Element;
use crate::cgm::fonts;
use crate::generated::elements::Kind;
use gks_geometry::{Point, Vector};
use gks_pipeline::font::{Layout, TextStyle, layout};
use gks_pipeline::look::{Horizontal, Look, Precision, TextPath, Vertical};
use glam::DVec2;

/// A string whose last part has not come yet.
#[derive(Clone, Debug)]
pub(super) struct PendingText {
    at: DVec2,
    /// Width and height that the text is restricted to.
    restriction: Option<DVec2>,
    text: String,
    look: Look,
}

impl<D: Decoder> Interpreter<D> {
    pub(super) fn string(&mut self, e: &Element) -> bool {
        let (first, restriction) = match e.kind {
            Kind::Text => (0, None),
            Kind::RestrictedText => (2, e.vector(0)),
            Kind::AppendText => {
                if let (Some(last), Some(bytes)) = (e.integer(0), e.bytes(1)) {
                    if let Some(text) = &mut self.text {
                        text.text.push_str(&decoded(bytes));
                    }
                    if last == 1 {
                        self.end_text();
                    }
                }
                return true;
            }
            _ => return false,
        };
        self.end_text();
        if let (Some(at), Some(last), Some(bytes)) =
            (e.point(first), e.integer(first + 1), e.bytes(first + 2))
        {
            let look = self.text_attributes();
            self.text = Some(PendingText { at, restriction, text: decoded(bytes), look });
            if last == 1 {
                self.end_text();
            }
        } else {
            self.senseless(e);
        }
        true
    }

    /// Draws the text that is complete now.
    pub(super) fn end_text(&mut self) {
        let Some(PendingText { at, restriction, text, mut look }) = self.text.take() else { return };
        let mapping = self.mapping();
        if let Some(restriction) = restriction {
            let shrink = self.shrunk(&text, &look, restriction * mapping.scale);
            let geometry = &mut look.text_geometry;
            geometry.width = geometry.width * shrink.x;
            geometry.height = geometry.height * shrink.y;
        }
        let at = Point::from_vec(mapping.point(at));
        self.draw(Drawing::Text(at, text), look);
    }

    /// The factors by which text must shrink, or may grow, to fit a width and a height in NDC.
    fn shrunk(&self, text: &str, look: &Look, restriction: DVec2) -> DVec2 {
        let style = TextStyle {
            font: look.text.font,
            expansion: look.text.expansion,
            spacing: look.text.spacing,
            path: look.text_geometry.path,
            horizontal: look.text_geometry.horizontal,
            vertical: look.text_geometry.vertical,
        };
        let mut placed = Layout::default();
        layout(text, &style, &mut placed);
        let [low, _, high, _] = placed.extent;
        let geometry = &look.text_geometry;
        let size = (high - low).abs() * DVec2::new(geometry.width.length(), geometry.height.length());
        let fit = restriction.abs() / size;
        if !fit.is_finite() || fit.min_element() <= 0.0 {
            return DVec2::ONE;
        }
        match self.context.restriction {
            // Boxed and justified text fills the width.
            2 | 3 | 6 => DVec2::new(fit.x, fit.y.min(1.0)),
            // Text of one size shrinks as a whole; so does the basic type, which leaves the choice.
            _ => DVec2::splat(fit.min_element().min(1.0)),
        }
    }

    fn text_attributes(&mut self) -> Look {
        let mapping = self.mapping();
        let text = self.context.text_look();
        let mut look = self.queue.look().clone();
        look.text.font = fonts::listed(&self.fonts, self.own, text.font);
        look.text.precision = Precision::from_number(text.precision).unwrap_or(Precision::String);
        look.text.expansion = text.expansion;
        look.text.spacing = text.spacing;
        look.text.colour = self.index(text.ink);
        let context = &self.context;
        // In units of the extent, whose hundredth is the default height.
        let height = context.height.map_or(0.01, |height| height * mapping.scale);
        let (mut up, mut base) = (mapping.vector(context.up).0, mapping.vector(context.base).0);
        // Vectors of the right length are taken to the last digit.
        if (up.length() - height).abs() > 1e-12 * height {
            let ratio = context.base.length() / context.up.length();
            let ratio = if ratio.is_finite() { ratio } else { 1.0 };
            (up, base) = (up.normalize_or(DVec2::Y) * height, base.normalize_or(DVec2::X) * height * ratio);
        }
        let geometry = &mut look.text_geometry;
        (geometry.height, geometry.width) = (Vector::from_vec(up), Vector::from_vec(base));
        geometry.path = TextPath::from_number(context.path).unwrap_or(TextPath::Right);
        let (horizontal, vertical, across, along) = context.alignment;
        geometry.horizontal = match horizontal {
            4 if across < 0.25 => Horizontal::Left,
            4 if across < 0.75 => Horizontal::Centre,
            4 => Horizontal::Right,
            other => Horizontal::from_number(other).unwrap_or(Horizontal::Normal),
        };
        geometry.vertical = match vertical {
            6 if along < 0.25 => Vertical::Bottom,
            6 if along < 0.75 => Vertical::Half,
            6 => Vertical::Top,
            other => Vertical::from_number(other).unwrap_or(Vertical::Normal),
        };
        look
    }
}

/// The characters of a string: UTF-8 where it is that, else Latin-1 with the right half behind SHIFT OUT. Escape
/// sequences, which announce character sets, are left out.
pub(super) fn decoded(bytes: &[u8]) -> String {
    let mut plain = Vec::with_capacity(bytes.len());
    let (mut shifted, mut rest) = (false, bytes.iter());
    while let Some(&byte) = rest.next() {
        match byte {
            0x1b => {
                let _ = rest.by_ref().find(|byte| !(0x20..0x30).contains(*byte));
            }
            0x0e => shifted = true,
            0x0f => shifted = false,
            _ if shifted && byte >= 0x20 => plain.push(byte | 0x80),
            _ => plain.push(byte),
        }
    }
    match String::from_utf8(plain) {
        Ok(text) => text,
        Err(error) => error.as_bytes().iter().map(|&byte| char::from(byte)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::decoded;

    #[test]
    fn strings_in_several_codes() {
        assert_eq!(decoded("Größe".as_bytes()), "Größe");
        assert_eq!(decoded(b"Gr\xf6\xdfe"), "Größe");
        assert_eq!(decoded(b"\x1b-AGr\x0ev_\x0fe"), "Größe");
        assert_eq!(decoded(b"\x1b%Gab\x1b"), "ab");
    }
}
