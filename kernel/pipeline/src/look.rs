//! The look of a primitive before a workstation resolves it: aspects, indices and aspect source flags.

use gks_geometry::{Ndc, Point, Vector};

pub use crate::font::{Horizontal, TextPath, Vertical};

macro_rules! enumeration {
    ($(#[$doc:meta])* $name:ident { $($(#[$vdoc:meta])* $variant:ident = $value:literal),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
        #[repr(i32)]
        pub enum $name { $($(#[$vdoc])* $variant = $value),+ }

        impl $name {
            /// The value with the number that the language bindings use, or none for another number.
            pub const fn from_number(number: i32) -> Option<Self> {
                match number { $($value => Some($name::$variant),)+ _ => None }
            }
        }
    };
}
pub(crate) use enumeration;

enumeration! {
    /// How the interior of a fill area is drawn.
    InteriorStyle {
        /// The boundary alone.
        Hollow = 0,
        /// Filled with the fill area colour.
        Solid = 1,
        /// Tiled with a pattern of the pattern table.
        Pattern = 2,
        /// Hatched with lines of a hatch style.
        Hatch = 3,
    }
}

enumeration! {
    /// How closely text must follow its attributes. The pipeline draws every precision as STROKE.
    Precision {
        /// Position and alignment at least.
        String = 0,
        /// Every character placed by the attributes.
        Char = 1,
        /// Exact in shape and clipping.
        Stroke = 2,
    }
}

enumeration! {
    /// The ends of polylines. Beyond the standard, as PostScript has them.
    Cap {
        /// Cut off at the end point.
        Butt = 0,
        /// A half disc around the end point.
        Round = 1,
        /// Continued by half the linewidth.
        Projecting = 2,
    }
}

enumeration! {
    /// The corners of polylines. Beyond the standard, as PostScript has them.
    Join {
        /// Edges continued until they meet, bevelled beyond a limit of 10 linewidths.
        Miter = 0,
        /// A disc around the corner.
        Round = 1,
        /// Cut off.
        Bevel = 2,
    }
}

/// A sector of the ellipse that touches the sides of the clipping rectangle. Beyond the standard.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct ClipSector {
    /// Where it begins: the parameter of the ellipse in degrees, 0 at the right, 90 at the top.
    pub start: f64,
    /// Where it ends, counterclockwise from there; the whole ellipse where it is 360 degrees or more away.
    pub end: f64,
}

impl ClipSector {
    /// The whole ellipse.
    pub const WHOLE: ClipSector = ClipSector { start: 0.0, end: 360.0 };
}

/// The aspects whose value comes either from a bundle or from an individual attribute, in the
/// standard's order.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[repr(u8)]
#[allow(missing_docs, reason = "the names say it all")]
pub enum Aspect {
    Linetype,
    Linewidth,
    PolylineColour,
    MarkerType,
    MarkerSize,
    PolymarkerColour,
    TextFontAndPrecision,
    CharacterExpansion,
    CharacterSpacing,
    TextColour,
    InteriorStyle,
    StyleIndex,
    FillColour,
}

/// For each of the 13 aspects where its value comes from.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct AspectSourceFlags(u16);

impl AspectSourceFlags {
    /// All values come from bundles.
    pub const BUNDLED: AspectSourceFlags = AspectSourceFlags(0);
    /// All values come from individual attributes.
    pub const INDIVIDUAL: AspectSourceFlags = AspectSourceFlags((1 << 13) - 1);

    /// The flags in the standard's order, `true` for INDIVIDUAL.
    pub fn from_array(flags: [bool; 13]) -> Self {
        AspectSourceFlags(flags.iter().enumerate().fold(0, |bits, (i, &f)| bits | u16::from(f) << i))
    }

    /// The flags as an array in the standard's order, `true` for INDIVIDUAL.
    pub fn to_array(self) -> [bool; 13] {
        std::array::from_fn(|i| self.0 >> i & 1 == 1)
    }

    /// Whether the value of `aspect` is an individual attribute.
    #[inline]
    pub const fn individual(self, aspect: Aspect) -> bool {
        self.0 >> aspect as u16 & 1 == 1
    }
}

/// The polyline aspects that a bundle holds.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct LineBundle {
    /// Linetype: 1 solid, 2 dashed, 3 dotted, 4 dash-dotted, negative values private.
    pub linetype: i32,
    /// Linewidth scale factor, a multiple of the nominal linewidth of the workstation.
    pub width: f64,
    /// Colour index.
    pub colour: u32,
}

/// The polymarker aspects that a bundle holds.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct MarkerBundle {
    /// Marker type: 1 dot, 2 plus, 3 asterisk, 4 circle, 5 diagonal cross, negative values private.
    pub kind: i32,
    /// Marker size scale factor, a multiple of the nominal marker size of the workstation.
    pub size: f64,
    /// Colour index.
    pub colour: u32,
}

/// The text aspects that a bundle holds.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct TextBundle {
    /// Font number.
    pub font: i32,
    /// Text precision.
    pub precision: Precision,
    /// Character expansion factor: the width of characters relative to their design.
    pub expansion: f64,
    /// Character spacing, in character heights.
    pub spacing: f64,
    /// Colour index.
    pub colour: u32,
}

/// The fill area aspects that a bundle holds.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct FillBundle {
    /// Interior style.
    pub interior: InteriorStyle,
    /// Style index: a pattern index, a hatch style, or without meaning.
    pub style: i32,
    /// Colour index.
    pub colour: u32,
}

/// The text attributes that no bundle holds, taken to NDC.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct TextGeometry {
    /// The image of the vector from base line to cap line.
    pub height: Vector<Ndc>,
    /// The image of the vector along the base line, as long as the height before the normalization
    /// transformation distorts both.
    pub width: Vector<Ndc>,
    /// The direction in which characters follow one another.
    pub path: TextPath,
    /// Where the text position lies in the text, horizontally.
    pub horizontal: Horizontal,
    /// Where the text position lies in the text, vertically.
    pub vertical: Vertical,
}

/// The pattern attributes, taken to NDC.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct PatternGeometry {
    /// The lower left corner of one copy of the pattern.
    pub reference: Point<Ndc>,
    /// The lower edge of the pattern box.
    pub width: Vector<Ndc>,
    /// The left edge of the pattern box.
    pub height: Vector<Ndc>,
}

/// Everything that decides how a primitive looks, unresolved: what the GKS state list holds, with
/// geometric attributes already in NDC.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Where the value of each aspect comes from.
    pub sources: AspectSourceFlags,
    /// Polyline index.
    pub line_index: u32,
    /// Individual polyline aspects.
    pub line: LineBundle,
    /// Line ends.
    pub cap: Cap,
    /// Line corners.
    pub join: Join,
    /// Polymarker index.
    pub marker_index: u32,
    /// Individual polymarker aspects.
    pub marker: MarkerBundle,
    /// Text index.
    pub text_index: u32,
    /// Individual text aspects.
    pub text: TextBundle,
    /// Geometric text attributes.
    pub text_geometry: TextGeometry,
    /// Fill area index.
    pub fill_index: u32,
    /// Individual fill area aspects.
    pub fill: FillBundle,
    /// Geometric pattern attributes.
    pub pattern: PatternGeometry,
    /// What clips in addition to the clipping rectangle.
    pub clip_sector: Option<ClipSector>,
}

impl Default for Look {
    /// The values that OPEN GKS sets, under the identity normalization transformation.
    fn default() -> Self {
        Look {
            sources: AspectSourceFlags::INDIVIDUAL,
            line_index: 1,
            line: LineBundle { linetype: 1, width: 1.0, colour: 1 },
            cap: Cap::Butt,
            join: Join::Miter,
            marker_index: 1,
            marker: MarkerBundle { kind: 3, size: 1.0, colour: 1 },
            text_index: 1,
            text: TextBundle {
                font: 1,
                precision: Precision::String,
                expansion: 1.0,
                spacing: 0.0,
                colour: 1,
            },
            text_geometry: TextGeometry {
                height: Vector::new(0.0, 0.01),
                width: Vector::new(0.01, 0.0),
                path: TextPath::Right,
                horizontal: Horizontal::Normal,
                vertical: Vertical::Normal,
            },
            fill_index: 1,
            fill: FillBundle { interior: InteriorStyle::Hollow, style: 1, colour: 1 },
            pattern: PatternGeometry {
                reference: Point::new(0.0, 0.0),
                width: Vector::new(1.0, 0.0),
                height: Vector::new(0.0, 1.0),
            },
            clip_sector: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn aspect_source_flags_keep_their_order() {
        let mut flags = [false; 13];
        flags[Aspect::MarkerSize as usize] = true;
        flags[Aspect::FillColour as usize] = true;
        let asf = AspectSourceFlags::from_array(flags);
        assert!(asf.individual(Aspect::MarkerSize) && asf.individual(Aspect::FillColour));
        assert!(!asf.individual(Aspect::Linetype));
        assert_eq!(asf.to_array(), flags);
        assert_eq!(AspectSourceFlags::INDIVIDUAL.to_array(), [true; 13]);
    }
}
