//! The metafile descriptor: what a metafile says before its first picture.
//!
//! It names the fonts and the largest colour index, which are known only when something has been drawn. So it is
//! written when the first octets of pictures are handed on.

use super::CgmRecorder;
use crate::cgm::element::{Element, Ink, Value};
use crate::cgm::fonts;
use crate::generated::elements::Kind;
use gks_pipeline::generated::numbers;

/// The largest colour index where that is enough: some readers take an octet for a signed number.
const MODEST_COLOUR: u32 = 127;

/// The linetypes that are ours alone, in nominal linewidths, so that every reader can draw them.
fn line_types() -> impl Iterator<Item = Element> {
    let own = numbers::LINETYPES.iter().filter(|own| line_type(own.number) < 0);
    own.map(|own| {
        let mut values = vec![Value::Integer(own.number), Value::Real(own.dashes.iter().sum())];
        values.extend(own.dashes.iter().map(|length| Value::Integer(*length as i32)));
        Element::new(Kind::LineAndEdgeTypeDefinition, values)
    })
}

/// The line type for one of our linetypes: dash-dot-dot is one of the standard.
pub(super) fn line_type(linetype: i32) -> i32 {
    if linetype == -1 { 5 } else { linetype }
}

impl CgmRecorder {
    /// The octets of the descriptor.
    pub(super) fn descriptor(&mut self) -> Vec<u8> {
        let mut out = Vec::new();
        let text = |text: &str| Value::Text(text.as_bytes().to_vec());
        let mut put = |kind: Kind, values: Vec<Value>| {
            self.encoder.encode(&Element::new(kind, values), &mut out);
        };
        put(Kind::BeginMetafile, vec![text("GKS")]);
        put(Kind::MetafileVersion, vec![Value::Integer(i32::from(self.settings.version))]);
        put(Kind::MetafileDescription, vec![text(fonts::AUTHOR)]);
        put(Kind::MetafileElementList, vec![text("DRAWINGPLUS")]);
        put(Kind::VdcType, vec![Value::Integer(i32::from(self.grid.real))]);
        let names: Vec<Value> = self.fonts.names().map(text).collect();
        let most = Value::Ink(Ink::Index(self.most_colour));
        let mut elements = self.encoder.precisions();
        elements.push(Element::new(Kind::MaximumColourIndex, [most]));
        elements.push(Element::new(Kind::FontList, names));
        let mut defaults = self.encoder.coordinate_precisions();
        if self.settings.version >= 3 && !self.settings.plain {
            defaults.extend(line_types());
        }
        if !defaults.is_empty() {
            elements.push(Element::new(Kind::BeginMetafileDefaultsReplacement, []));
            elements.extend(defaults);
            elements.push(Element::new(Kind::EndMetafileDefaultsReplacement, []));
        }
        for element in elements {
            self.encoder.encode(&element, &mut out);
        }
        out
    }

    /// Decides what is left open until something has left the recorder.
    pub(super) fn settle(&mut self) {
        self.fonts.settle();
        if self.tables.colours.iter().all(|(index, _)| index <= MODEST_COLOUR) {
            self.most_colour = self.most_colour.min(MODEST_COLOUR);
        }
    }
}
