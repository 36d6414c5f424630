//! The graphics state of a page description: written when it changes, not when it is used.

use super::content::{Content, Drain, LENGTHS, Language, STEPS};
use crate::number::Decimal;
use gks_geometry::{Du, Rect};
use gks_pipeline::colour::Colour;
use gks_pipeline::device::{DeviceError, Pen};
use gks_pipeline::item::{Curve, Ellipse};
use gks_pipeline::look::{Cap, Join};
use std::collections::BTreeSet;

/// Colour intensities are counted in thousandths.
const INTENSITIES: Decimal = Decimal::new(3).bare();

/// What a colour is for.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Use {
    Lines,
    Areas,
}

/// The graphics state as the reader has it; absent where it is not known.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    line_colour: Option<[i64; 3]>,
    area_colour: Option<[i64; 3]>,
    opacity: u8,
    width: Option<i64>,
    cap: Cap,
    join: Join,
    dash: Vec<i64>,
    font: Option<usize>,
}

impl State {
    pub(super) fn new() -> Self {
        State {
            line_colour: None,
            area_colour: None,
            opacity: 255,
            width: None,
            cap: Cap::Butt,
            join: Join::Miter,
            dash: Vec::new(),
            font: None,
        }
    }
}

impl Content {
    /// Sets the clipping rectangle.
    pub(crate) fn clip(&mut self, clip: Option<&Rect<Du>>) {
        let clip = clip.map(|rect| rect.limits().map(|limit| STEPS.steps(limit)));
        if clip == self.clip {
            return;
        }
        if self.clip.is_some() {
            self.text.extend_from_slice(b"Q\n");
            self.state.clone_from(&self.outside);
        }
        if let Some(limits) = clip {
            self.outside.clone_from(&self.state);
            self.text.extend_from_slice(b"q\n");
            self.rectangle(limits);
            self.text.extend_from_slice(b"W n\n");
        }
        self.clip = clip;
    }

    /// Sets the ellipse or the sector of one that clips, outside of the clipping rectangle.
    #[inline]
    pub(crate) fn region(
        &mut self,
        region: Option<&Ellipse<Du>>,
        drain: &mut impl Drain,
    ) -> Result<(), DeviceError> {
        if self.region.as_ref() == region { Ok(()) } else { self.change_region(region, drain) }
    }

    #[cold]
    fn change_region(
        &mut self,
        region: Option<&Ellipse<Du>>,
        drain: &mut impl Drain,
    ) -> Result<(), DeviceError> {
        self.clip(None);
        if self.region.take().is_some() {
            self.text.extend_from_slice(b"Q\n");
            self.state.clone_from(&self.around);
        }
        if let Some(region) = region {
            self.around.clone_from(&self.state);
            self.text.extend_from_slice(b"q\n");
            // One without area has an inside without area.
            if !self.curve(&Curve::Ellipse(*region), drain)? {
                self.rectangle([0; 4]);
            }
            self.text.extend_from_slice(b"W n\n");
            self.region = Some(*region);
        }
        Ok(())
    }

    /// The opacities, of 255, that this page has used beside 255 itself.
    pub(crate) fn opacities(&self) -> &BTreeSet<u8> {
        &self.opacities
    }

    /// Sets the colour of areas and characters.
    pub(crate) fn area_colour(&mut self, colour: Colour) {
        self.colour(Use::Areas, colour);
    }

    /// Makes a font, by its number, the one for characters; whether it was another before.
    pub(crate) fn changes_font(&mut self, font: usize) -> bool {
        self.state.font.replace(font) != Some(font)
    }

    /// Sets the opacity, of 255, for what follows; PostScript has none.
    pub(crate) fn opacity(&mut self, opacity: u8) {
        if self.language == Language::Pdf && self.state.opacity != opacity {
            self.text.extend_from_slice(format!("/A{opacity} gs\n").as_bytes());
            self.state.opacity = opacity;
            self.opacities.insert(opacity);
        }
    }

    /// Makes a pen the one for lines.
    pub(super) fn pen(&mut self, pen: &Pen<'_>) {
        self.colour(Use::Lines, pen.paint.colour);
        let width = LENGTHS.steps(pen.width.max(0.0));
        if self.state.width != Some(width) {
            self.number(1, width);
            self.text.extend_from_slice(b"w\n");
            self.state.width = Some(width);
        }
        if self.state.cap != pen.cap {
            let code = match pen.cap {
                Cap::Butt => b"0 J\n",
                Cap::Round => b"1 J\n",
                Cap::Projecting => b"2 J\n",
            };
            self.text.extend_from_slice(code);
            self.state.cap = pen.cap;
        }
        if self.state.join != pen.join {
            let code = match pen.join {
                Join::Miter => b"0 j\n",
                Join::Round => b"1 j\n",
                Join::Bevel => b"2 j\n",
            };
            self.text.extend_from_slice(code);
            self.state.join = pen.join;
        }
        self.dash(pen.dash);
    }

    /// Sets the dashes; dashes and gaps without any length would be an error, so they are a solid line.
    fn dash(&mut self, dash: &[f64]) {
        let lengths = || dash.iter().map(|length| LENGTHS.steps(length.max(0.0)));
        let solid = lengths().all(|length| length == 0);
        let count = if solid { 0 } else { dash.len() };
        if self.state.dash.len() == count && lengths().zip(&self.state.dash).all(|(new, old)| new == *old) {
            return;
        }
        self.state.dash.clear();
        self.state.dash.extend(lengths().take(count));
        self.text.push(b'[');
        for (i, length) in lengths().take(count).enumerate() {
            if i > 0 {
                self.text.push(b' ');
            }
            self.formats[1].write_steps(&mut self.text, length);
        }
        self.text.extend_from_slice(b"] 0 d\n");
    }

    /// Sets a colour with its opacity.
    pub(super) fn colour(&mut self, purpose: Use, colour: Colour) {
        self.opacity(colour.to_bytes()[3]);
        let intensity = |value: f32| INTENSITIES.steps(f64::from(value.clamp(0.0, 1.0)));
        let new = [colour.red, colour.green, colour.blue].map(intensity);
        let lines = purpose == Use::Lines && self.language == Language::Pdf;
        let known = if lines { &mut self.state.line_colour } else { &mut self.state.area_colour };
        if *known == Some(new) {
            return;
        }
        *known = Some(new);
        let grey = new[0] == new[1] && new[1] == new[2];
        for &component in &new[..if grey { 1 } else { 3 }] {
            INTENSITIES.write_steps(&mut self.text, component);
            self.text.push(b' ');
        }
        self.text.extend_from_slice(match (grey, lines) {
            (true, true) => b"G\n",
            (true, false) => b"g\n",
            (false, true) => b"RG\n",
            (false, false) => b"rg\n",
        });
    }
}
