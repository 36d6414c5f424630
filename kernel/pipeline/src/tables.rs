//! The bundle, pattern and colour tables of one workstation, and how a look is resolved by them.

use crate::colour::{Colour, Paint};
use crate::generated::numbers;
use crate::look::{
    Aspect, FillBundle, InteriorStyle, LineBundle, Look, MarkerBundle, Precision, TextBundle, enumeration,
};
use std::collections::BTreeMap;

/// A pattern: colour indices of `columns` x `rows` cells, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    /// Number of columns.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// The colour indices, column fastest.
    pub indices: Vec<i32>,
}

/// The tables that belong to one workstation: what its state list holds beside control.
///
/// Every table has an entry 1, which stands in for indices that have none.
#[derive(Clone, Debug, PartialEq)]
pub struct Tables {
    /// Polyline bundles by polyline index.
    pub lines: BTreeMap<u32, LineBundle>,
    /// Polymarker bundles by polymarker index.
    pub markers: BTreeMap<u32, MarkerBundle>,
    /// Text bundles by text index.
    pub texts: BTreeMap<u32, TextBundle>,
    /// Fill area bundles by fill area index.
    pub fills: BTreeMap<u32, FillBundle>,
    /// Patterns by pattern index.
    pub patterns: BTreeMap<u32, Pattern>,
    /// Colours by colour index; 0 is the background.
    pub colours: Colours,
    /// Fonts that are drawn with another one in their place: pairs of a font number and its substitute.
    pub substitutes: &'static [(i32, i32)],
    /// Nominal sizes.
    pub nominal: Nominal,
    /// How opaque primitives are, on top of the opacity of their colours.
    pub opacity: Opacity,
}

enumeration! {
    /// The kinds of primitives that have an opacity.
    Primitives {
        /// Polylines.
        Lines = 0,
        /// Polymarkers.
        Markers = 1,
        /// Text.
        Text = 2,
        /// Fill areas and cell arrays.
        Areas = 3,
    }
}

/// The opacity of the primitives of a workstation by their kind, from 0 to 1. Beyond the standard.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Opacity {
    /// Of polylines.
    pub lines: f32,
    /// Of polymarkers.
    pub markers: f32,
    /// Of text.
    pub text: f32,
    /// Of fill areas and cell arrays.
    pub areas: f32,
}

impl Opacity {
    /// Everything covers what is below.
    pub const FULL: Opacity = Opacity { lines: 1.0, markers: 1.0, text: 1.0, areas: 1.0 };

    /// The opacity of a kind of primitives, to be changed.
    pub fn of(&mut self, primitives: Primitives) -> &mut f32 {
        match primitives {
            Primitives::Lines => &mut self.lines,
            Primitives::Markers => &mut self.markers,
            Primitives::Text => &mut self.text,
            Primitives::Areas => &mut self.areas,
        }
    }
}

enumeration! {
    /// The nominal sizes that a workstation may have of its own.
    NominalSize {
        /// Of lines, boundaries of hollow areas and hatches.
        Linewidth = 0,
        /// Of markers.
        MarkerSize = 1,
        /// The distance of the lines of a hatch.
        HatchSpacing = 2,
    }
}

/// The nominal sizes of a workstation as multiples of those that all devices have, more than zero. Beyond the standard.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Nominal {
    /// Of lines.
    pub linewidth: f64,
    /// Of markers.
    pub marker_size: f64,
    /// Of hatches.
    pub hatch_spacing: f64,
}

impl Nominal {
    /// Those that all devices have.
    pub const USUAL: Nominal = Nominal { linewidth: 1.0, marker_size: 1.0, hatch_spacing: 1.0 };

    /// One of them, to be changed.
    pub fn of(&mut self, size: NominalSize) -> &mut f64 {
        match size {
            NominalSize::Linewidth => &mut self.linewidth,
            NominalSize::MarkerSize => &mut self.marker_size,
            NominalSize::HatchSpacing => &mut self.hatch_spacing,
        }
    }
}

/// A colour table: dense where indices are small, so that a look-up costs one load.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Colours {
    dense: Vec<Option<Colour>>,
    sparse: BTreeMap<u32, Colour>,
}

/// Indices below this one are stored densely.
const DENSE: u32 = 4096;

impl Colours {
    /// The colour of an index, if it has one; a packed index has the one that it holds.
    #[inline]
    pub fn get(&self, index: u32) -> Option<Colour> {
        if index < DENSE {
            self.dense.get(index as usize).copied().flatten()
        } else {
            self.sparse.get(&index).copied().or_else(|| Colour::of_packed_index(index))
        }
    }

    /// Sets the colour of an index.
    pub fn set(&mut self, index: u32, colour: Colour) {
        if index < DENSE {
            let i = index as usize;
            if self.dense.len() <= i {
                self.dense.resize(i + 1, None);
            }
            self.dense[i] = Some(colour);
        } else {
            self.sparse.insert(index, colour);
        }
    }

    /// All entries by increasing index.
    pub fn iter(&self) -> impl Iterator<Item = (u32, Colour)> + Clone + '_ {
        let dense = self.dense.iter().enumerate().filter_map(|(i, c)| c.map(|c| (i as u32, c)));
        dense.chain(self.sparse.iter().map(|(&i, &c)| (i, c)))
    }

    /// The number of entries.
    pub fn len(&self) -> usize {
        self.iter().count()
    }

    /// Whether there is no entry.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Entries with the indices 1, 2, ...
fn numbered<B>(entries: impl Iterator<Item = B>) -> BTreeMap<u32, B> {
    (1..).zip(entries).collect()
}

fn entry<B: Copy>(table: &BTreeMap<u32, B>, index: u32, otherwise: B) -> B {
    table.get(&index).or_else(|| table.get(&1)).copied().unwrap_or(otherwise)
}

impl From<&numbers::PolylineBundle> for LineBundle {
    fn from(b: &numbers::PolylineBundle) -> Self {
        LineBundle { linetype: b.linetype, width: b.linewidth, colour: b.colour }
    }
}

impl From<&numbers::PolymarkerBundle> for MarkerBundle {
    fn from(b: &numbers::PolymarkerBundle) -> Self {
        MarkerBundle { kind: b.marker, size: b.size, colour: b.colour }
    }
}

impl From<&numbers::TextBundle> for TextBundle {
    fn from(b: &numbers::TextBundle) -> Self {
        TextBundle {
            font: b.font,
            precision: Precision::from_number(b.precision.into()).unwrap_or(Precision::Stroke),
            expansion: b.expansion,
            spacing: b.spacing,
            colour: b.colour,
        }
    }
}

impl From<&numbers::FillAreaBundle> for FillBundle {
    fn from(b: &numbers::FillAreaBundle) -> Self {
        let interior = InteriorStyle::from_number(b.interior.into()).unwrap_or(InteriorStyle::Hollow);
        FillBundle { interior, style: b.style, colour: b.colour }
    }
}

impl Tables {
    /// The tables that OPEN WORKSTATION sets: the predefined bundles, patterns and colours.
    pub fn predefined() -> Self {
        let mut colours = Colours::default();
        for (index, &[red, green, blue]) in numbers::COLOURS.iter().enumerate() {
            colours.set(index as u32, Colour::rgb(red, green, blue));
        }
        Tables {
            lines: numbered(numbers::POLYLINE_BUNDLES.iter().map(LineBundle::from)),
            markers: numbered(numbers::POLYMARKER_BUNDLES.iter().map(MarkerBundle::from)),
            texts: numbered(numbers::TEXT_BUNDLES.iter().map(TextBundle::from)),
            fills: numbered(numbers::FILL_AREA_BUNDLES.iter().map(FillBundle::from)),
            patterns: numbered(numbers::PATTERNS.iter().map(|p| Pattern {
                columns: p.columns,
                rows: p.rows,
                indices: p.cells.to_vec(),
            })),
            colours,
            substitutes: &[],
            nominal: Nominal::USUAL,
            opacity: Opacity::FULL,
        }
    }

    /// The polyline aspects that hold on this workstation.
    pub fn line(&self, look: &Look) -> LineBundle {
        let own = look.line;
        let asf = look.sources;
        let all = [Aspect::Linetype, Aspect::Linewidth, Aspect::PolylineColour];
        if all.iter().all(|&a| asf.individual(a)) {
            return own;
        }
        let bundle = entry(&self.lines, look.line_index, own);
        LineBundle {
            linetype: if asf.individual(all[0]) { own.linetype } else { bundle.linetype },
            width: if asf.individual(all[1]) { own.width } else { bundle.width },
            colour: if asf.individual(all[2]) { own.colour } else { bundle.colour },
        }
    }

    /// The polymarker aspects that hold on this workstation.
    pub fn marker(&self, look: &Look) -> MarkerBundle {
        let own = look.marker;
        let asf = look.sources;
        let bundle = entry(&self.markers, look.marker_index, own);
        MarkerBundle {
            kind: if asf.individual(Aspect::MarkerType) { own.kind } else { bundle.kind },
            size: if asf.individual(Aspect::MarkerSize) { own.size } else { bundle.size },
            colour: if asf.individual(Aspect::PolymarkerColour) { own.colour } else { bundle.colour },
        }
    }

    /// The text aspects that hold on this workstation, with a substitute in the place of a font that has one.
    pub fn text(&self, look: &Look) -> TextBundle {
        let own = look.text;
        let asf = look.sources;
        let bundle = entry(&self.texts, look.text_index, own);
        let font = if asf.individual(Aspect::TextFontAndPrecision) { own } else { bundle };
        TextBundle {
            font: self.substitute(font.font),
            precision: font.precision,
            expansion: if asf.individual(Aspect::CharacterExpansion) {
                own.expansion
            } else {
                bundle.expansion
            },
            spacing: if asf.individual(Aspect::CharacterSpacing) { own.spacing } else { bundle.spacing },
            colour: if asf.individual(Aspect::TextColour) { own.colour } else { bundle.colour },
        }
    }

    /// A look as a metafile keeps it, for readers that have neither these substitutes nor these nominal sizes; none
    /// where it is the same.
    pub fn portable(&self, look: &Look) -> Option<Look> {
        if self.substitutes.is_empty() && (self.nominal.linewidth, self.nominal.marker_size) == (1.0, 1.0) {
            return None;
        }
        let (text, marker) = (self.portable_text(look.text), self.portable_marker(look.marker));
        Some(Look { line: self.portable_line(look.line), text, marker, ..look.clone() })
    }

    /// A text bundle as a metafile keeps it.
    pub fn portable_text(&self, bundle: TextBundle) -> TextBundle {
        TextBundle { font: self.substitute(bundle.font), ..bundle }
    }

    /// A polyline bundle as a metafile keeps it.
    pub fn portable_line(&self, bundle: LineBundle) -> LineBundle {
        LineBundle { width: bundle.width * self.nominal.linewidth, ..bundle }
    }

    /// A polymarker bundle as a metafile keeps it.
    pub fn portable_marker(&self, bundle: MarkerBundle) -> MarkerBundle {
        MarkerBundle { size: bundle.size * self.nominal.marker_size, ..bundle }
    }

    fn substitute(&self, font: i32) -> i32 {
        let found = self.substitutes.iter().find(|(number, _)| *number == font);
        found.map_or(font, |(_, substitute)| *substitute)
    }

    /// The fill area aspects that hold on this workstation.
    pub fn fill(&self, look: &Look) -> FillBundle {
        let own = look.fill;
        let asf = look.sources;
        let bundle = entry(&self.fills, look.fill_index, own);
        FillBundle {
            interior: if asf.individual(Aspect::InteriorStyle) { own.interior } else { bundle.interior },
            style: if asf.individual(Aspect::StyleIndex) { own.style } else { bundle.style },
            colour: if asf.individual(Aspect::FillColour) { own.colour } else { bundle.colour },
        }
    }

    /// The paint of a colour index; an index without an entry is drawn as index 1.
    #[inline]
    pub fn paint(&self, index: u32) -> Paint {
        match self.colours.get(index) {
            Some(colour) => Paint { colour, index },
            None => Paint { colour: self.colours.get(1).unwrap_or(Colour::BLACK), index: 1 },
        }
    }

    /// The paint of a colour index for primitives of an opacity.
    #[inline]
    pub fn translucent(&self, index: u32, opacity: f32) -> Paint {
        let mut paint = self.paint(index);
        paint.colour.alpha *= opacity;
        paint
    }

    /// The colour of the empty display surface.
    pub fn background(&self) -> Colour {
        self.colours.get(0).unwrap_or(Colour::WHITE)
    }
}
