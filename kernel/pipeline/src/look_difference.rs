//! The attributes in which one primitive differs from the one before it.

use crate::item::Item;
use crate::look::{Cap, Join, Look};
use crate::record::Attribute;
use gks_geometry::{Ndc, Rect};

/// The attributes that were in force for a primitive.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The look.
    pub look: Look,
    /// The clipping rectangle.
    pub clip: Rect<Ndc>,
    /// The pick identifier.
    pub pick: i32,
}

impl Default for State {
    /// What OPEN GKS sets.
    fn default() -> Self {
        State { look: Look::default(), clip: Rect::UNIT, pick: 0 }
    }
}

impl State {
    /// Changes one attribute.
    pub fn set(&mut self, attribute: Attribute) {
        let State { look, clip, pick } = self;
        match attribute {
            Attribute::LineIndex(v) => look.line_index = v,
            Attribute::Linetype(v) => look.line.linetype = v,
            Attribute::LineWidth(v) => look.line.width = v,
            Attribute::LineColour(v) => look.line.colour = v,
            Attribute::MarkerIndex(v) => look.marker_index = v,
            Attribute::MarkerType(v) => look.marker.kind = v,
            Attribute::MarkerSize(v) => look.marker.size = v,
            Attribute::MarkerColour(v) => look.marker.colour = v,
            Attribute::TextIndex(v) => look.text_index = v,
            Attribute::TextFont(font, precision) => {
                look.text.font = font;
                look.text.precision = precision;
            }
            Attribute::CharacterExpansion(v) => look.text.expansion = v,
            Attribute::CharacterSpacing(v) => look.text.spacing = v,
            Attribute::TextColour(v) => look.text.colour = v,
            Attribute::CharacterVectors(height, width) => {
                look.text_geometry.height = height;
                look.text_geometry.width = width;
            }
            Attribute::TextPath(v) => look.text_geometry.path = v,
            Attribute::TextAlignment(horizontal, vertical) => {
                look.text_geometry.horizontal = horizontal;
                look.text_geometry.vertical = vertical;
            }
            Attribute::FillIndex(v) => look.fill_index = v,
            Attribute::InteriorStyle(v) => look.fill.interior = v,
            Attribute::FillStyle(v) => look.fill.style = v,
            Attribute::FillColour(v) => look.fill.colour = v,
            Attribute::PatternVectors(width, height) => {
                look.pattern.width = width;
                look.pattern.height = height;
            }
            Attribute::PatternReference(v) => look.pattern.reference = v,
            Attribute::AspectSourceFlags(v) => look.sources = v,
            Attribute::PickIdentifier(v) => *pick = v,
            Attribute::ClippingRectangle(v) => *clip = v,
            Attribute::Cap(v) => look.cap = v,
            Attribute::Join(v) => look.join = v,
            Attribute::ClipSector(v) => look.clip_sector = v,
        }
    }
}

impl State {
    /// All attributes with their values, line ends, corners and the sector that clips only where they are not the initial ones.
    pub fn attributes(&self) -> impl Iterator<Item = Attribute> + use<> {
        let State { look, clip, pick } = self;
        let (line, marker, text, fill) = (&look.line, &look.marker, &look.text, &look.fill);
        let (geometry, pattern) = (&look.text_geometry, &look.pattern);
        let standard = [
            Attribute::LineIndex(look.line_index),
            Attribute::Linetype(line.linetype),
            Attribute::LineWidth(line.width),
            Attribute::LineColour(line.colour),
            Attribute::MarkerIndex(look.marker_index),
            Attribute::MarkerType(marker.kind),
            Attribute::MarkerSize(marker.size),
            Attribute::MarkerColour(marker.colour),
            Attribute::TextIndex(look.text_index),
            Attribute::TextFont(text.font, text.precision),
            Attribute::CharacterExpansion(text.expansion),
            Attribute::CharacterSpacing(text.spacing),
            Attribute::TextColour(text.colour),
            Attribute::CharacterVectors(geometry.height, geometry.width),
            Attribute::TextPath(geometry.path),
            Attribute::TextAlignment(geometry.horizontal, geometry.vertical),
            Attribute::FillIndex(look.fill_index),
            Attribute::InteriorStyle(fill.interior),
            Attribute::FillStyle(fill.style),
            Attribute::FillColour(fill.colour),
            Attribute::PatternVectors(pattern.width, pattern.height),
            Attribute::PatternReference(pattern.reference),
            Attribute::AspectSourceFlags(look.sources),
            Attribute::PickIdentifier(*pick),
            Attribute::ClippingRectangle(*clip),
        ];
        let cap = (look.cap != Cap::Butt).then_some(Attribute::Cap(look.cap));
        let join = (look.join != Join::Miter).then_some(Attribute::Join(look.join));
        let sector = look.clip_sector.map(|sector| Attribute::ClipSector(Some(sector)));
        standard.into_iter().chain(cap).chain(join).chain(sector)
    }
}

/// Brings `known` to the attributes of `item` and calls `tell` for each one that changes.
pub fn differences(known: &mut State, item: &Item<'_>, mut tell: impl FnMut(Attribute)) {
    let (old, new) = (&known.look, item.look);
    // The common case, a primitive like the one before, costs one comparison.
    if old != new {
        let mut attribute = |changed: bool, attribute: Attribute| {
            if changed {
                tell(attribute);
            }
        };
        let (a, b) = (&old.line, &new.line);
        attribute(old.line_index != new.line_index, Attribute::LineIndex(new.line_index));
        attribute(a.linetype != b.linetype, Attribute::Linetype(b.linetype));
        attribute(a.width != b.width, Attribute::LineWidth(b.width));
        attribute(a.colour != b.colour, Attribute::LineColour(b.colour));
        attribute(old.cap != new.cap, Attribute::Cap(new.cap));
        attribute(old.join != new.join, Attribute::Join(new.join));
        let (a, b) = (&old.marker, &new.marker);
        attribute(old.marker_index != new.marker_index, Attribute::MarkerIndex(new.marker_index));
        attribute(a.kind != b.kind, Attribute::MarkerType(b.kind));
        attribute(a.size != b.size, Attribute::MarkerSize(b.size));
        attribute(a.colour != b.colour, Attribute::MarkerColour(b.colour));
        let (a, b) = (&old.text, &new.text);
        attribute(old.text_index != new.text_index, Attribute::TextIndex(new.text_index));
        attribute((a.font, a.precision) != (b.font, b.precision), Attribute::TextFont(b.font, b.precision));
        attribute(a.expansion != b.expansion, Attribute::CharacterExpansion(b.expansion));
        attribute(a.spacing != b.spacing, Attribute::CharacterSpacing(b.spacing));
        attribute(a.colour != b.colour, Attribute::TextColour(b.colour));
        let (a, b) = (&old.text_geometry, &new.text_geometry);
        attribute((a.height, a.width) != (b.height, b.width), Attribute::CharacterVectors(b.height, b.width));
        attribute(a.path != b.path, Attribute::TextPath(b.path));
        attribute(
            (a.horizontal, a.vertical) != (b.horizontal, b.vertical),
            Attribute::TextAlignment(b.horizontal, b.vertical),
        );
        let (a, b) = (&old.fill, &new.fill);
        attribute(old.fill_index != new.fill_index, Attribute::FillIndex(new.fill_index));
        attribute(a.interior != b.interior, Attribute::InteriorStyle(b.interior));
        attribute(a.style != b.style, Attribute::FillStyle(b.style));
        attribute(a.colour != b.colour, Attribute::FillColour(b.colour));
        let (a, b) = (&old.pattern, &new.pattern);
        attribute((a.width, a.height) != (b.width, b.height), Attribute::PatternVectors(b.width, b.height));
        attribute(a.reference != b.reference, Attribute::PatternReference(b.reference));
        attribute(old.sources != new.sources, Attribute::AspectSourceFlags(new.sources));
        attribute(old.clip_sector != new.clip_sector, Attribute::ClipSector(new.clip_sector));
        known.look.clone_from(new);
    }
    if known.clip != item.clip {
        known.clip = item.clip;
        tell(Attribute::ClippingRectangle(item.clip));
    }
    if known.pick != item.pick {
        known.pick = item.pick;
        tell(Attribute::PickIdentifier(item.pick));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::item::Shape;
    use crate::look::{
        AspectSourceFlags, Cap, ClipSector, Horizontal, InteriorStyle, Join, Precision, TextPath, Vertical,
    };
    use gks_geometry::{Point, Vector};

    /// One changed value of every attribute.
    fn all() -> Vec<Attribute> {
        vec![
            Attribute::LineIndex(2),
            Attribute::Linetype(3),
            Attribute::LineWidth(2.5),
            Attribute::LineColour(4),
            Attribute::Cap(Cap::Round),
            Attribute::Join(Join::Bevel),
            Attribute::MarkerIndex(5),
            Attribute::MarkerType(4),
            Attribute::MarkerSize(1.5),
            Attribute::MarkerColour(6),
            Attribute::TextIndex(3),
            Attribute::TextFont(-4, Precision::Stroke),
            Attribute::CharacterExpansion(0.5),
            Attribute::CharacterSpacing(0.25),
            Attribute::TextColour(7),
            Attribute::CharacterVectors(Vector::new(0.1, 0.2), Vector::new(0.2, -0.1)),
            Attribute::TextPath(TextPath::Down),
            Attribute::TextAlignment(Horizontal::Centre, Vertical::Half),
            Attribute::FillIndex(2),
            Attribute::InteriorStyle(InteriorStyle::Hatch),
            Attribute::FillStyle(-3),
            Attribute::FillColour(8),
            Attribute::PatternVectors(Vector::new(0.5, 0.0), Vector::new(0.0, 0.25)),
            Attribute::PatternReference(Point::new(0.1, 0.2)),
            Attribute::AspectSourceFlags(AspectSourceFlags::BUNDLED),
            Attribute::ClipSector(Some(ClipSector { start: 30.0, end: 270.0 })),
            Attribute::ClippingRectangle(Rect::new(0.1, 0.9, 0.2, 0.8)),
            Attribute::PickIdentifier(9),
        ]
    }

    #[test]
    fn every_attribute_that_changes_is_told_once() {
        let mut other = State::default();
        for attribute in all() {
            let before = other.clone();
            other.set(attribute);
            assert_ne!(before, other, "{attribute:?} changes nothing");
        }
        let item =
            Item { shape: Shape::Polymarker(&[]), look: &other.look, clip: other.clip, pick: other.pick };
        let (mut known, mut told) = (State::default(), Vec::new());
        differences(&mut known, &item, |attribute| told.push(attribute));
        assert_eq!(told, all());
        assert_eq!(known, other);
        differences(&mut known, &item, |attribute| panic!("{attribute:?} has not changed"));
        let mut again = State::default();
        other.attributes().for_each(|attribute| again.set(attribute));
        assert_eq!(again, other);
    }
}
