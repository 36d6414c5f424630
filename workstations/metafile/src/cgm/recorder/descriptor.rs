//! The metafile descriptor: what a metafile says before its first picture.
//!
//! It names the fonts and the largest colour index, which are known only when something has been drawn. So it is
//! written when the first octets of pictures are handed on.

use super::CgmRecorder;
use crate::cgm::element::{Element, Ink, Value};
use crate::cgm::fonts;
use crate::generated::elements::Kind;

/// The largest colour index where that is enough: some readers take an octet for a signed number.
const MODEST_COLOUR: u32 = 127;

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
        let coordinates = self.encoder.coordinate_precisions();
        if !coordinates.is_empty() {
            elements.push(Element::new(Kind::BeginMetafileDefaultsReplacement, []));
            elements.extend(coordinates);
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
