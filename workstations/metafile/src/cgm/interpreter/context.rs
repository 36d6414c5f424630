//! The attributes and controls in force: what every picture begins with, and what elements change.

use super::hatch::Hatch;
use crate::cgm::coding::{Modes, SizeMode};
use crate::cgm::element::{Cells, Element, Ink};
use crate::generated::elements::Kind;
use gks_pipeline::colour::Colour;
use gks_pipeline::generated::numbers::escape;
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;
use std::collections::BTreeMap;
use std::sync::Arc;

/// How lines or edges look.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    /// The line type.
    pub(super) kind: i32,
    /// The width, as the specification mode has it; the default width if there is none.
    pub(super) width: Option<f64>,
    /// The colour.
    pub(super) ink: Ink,
    /// The ends.
    pub(super) cap: Cap,
    /// The corners.
    pub(super) join: Join,
    /// Whether the dashes begin anew at every corner.
    pub(super) restarts: bool,
    /// How far into its dashes a line begins, as a part of a cycle.
    pub(super) offset: f64,
}

/// How markers look.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Marker {
    /// The marker type.
    pub(super) kind: i32,
    /// The size, as the specification mode has it; the default size if there is none.
    pub(super) size: Option<f64>,
    /// The colour.
    pub(super) ink: Ink,
}

/// How text looks, as far as bundles say it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Text {
    /// The index into the font list.
    pub(super) font: i32,
    /// The precision.
    pub(super) precision: i32,
    /// The expansion factor.
    pub(super) expansion: f64,
    /// The spacing.
    pub(super) spacing: f64,
    /// The colour.
    pub(super) ink: Ink,
}

/// How areas look.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fill {
    /// The interior style: 0 hollow, 1 solid, 2 pattern, 3 hatch, 4 empty, 5 geometric pattern, 6 interpolated.
    pub(super) style: i32,
    /// The colour.
    pub(super) ink: Ink,
    /// The hatch index.
    pub(super) hatch: i32,
    /// The pattern index.
    pub(super) pattern: i32,
}

/// Everything that is reset when a picture begins.
#[derive(Clone, Debug)]
pub(super) struct Context {
    /// How sizes and colours are given.
    pub(super) modes: Modes,
    /// Millimetres for a unit of virtual device coordinates, if the scaling is metric.
    pub(super) metric: Option<f64>,
    /// The two corners of the extent.
    pub(super) extent: Option<(DVec2, DVec2)>,
    /// The background colour.
    pub(super) background: Option<Colour>,
    /// The colour table, as far as it is set.
    pub(super) colours: BTreeMap<u32, Colour>,
    /// The pattern table, which contexts that are saved share.
    pub(super) patterns: BTreeMap<i32, Arc<Cells>>,
    /// Line types and edge types that the metafile defines: dashes and gaps, and how their lengths are given.
    pub(super) dashes: BTreeMap<i32, (SizeMode, Vec<f64>)>,
    /// Hatch styles that the metafile defines.
    pub(super) hatches: BTreeMap<i32, Hatch>,
    /// Individual attributes of lines.
    pub(super) line: Line,
    /// Individual attributes of markers.
    pub(super) marker: Marker,
    /// Individual attributes of text.
    pub(super) text: Text,
    /// Individual attributes of areas.
    pub(super) fill: Fill,
    /// Individual attributes of edges.
    pub(super) edge: Line,
    /// Whether edges are visible.
    pub(super) edges: bool,
    /// Bundle indices of lines, markers, text, areas and edges.
    pub(super) indices: [i32; 5],
    /// Bundles of lines and edges, markers, text and areas that the metafile defines.
    pub(super) line_bundles: BTreeMap<i32, Line>,
    /// Bundles of markers.
    pub(super) marker_bundles: BTreeMap<i32, Marker>,
    /// Bundles of text.
    pub(super) text_bundles: BTreeMap<i32, Text>,
    /// Bundles of areas.
    pub(super) fill_bundles: BTreeMap<i32, Fill>,
    /// Bundles of edges.
    pub(super) edge_bundles: BTreeMap<i32, Line>,
    /// For each of the 18 aspects whether it is bundled.
    pub(super) bundled: [bool; 18],
    /// The character height, or none for a hundredth of the extent.
    pub(super) height: Option<f64>,
    /// The character up vector.
    pub(super) up: DVec2,
    /// The character base vector.
    pub(super) base: DVec2,
    /// The text path.
    pub(super) path: i32,
    /// The alignments and their continuous values.
    pub(super) alignment: (i32, i32, f64, f64),
    /// How restricted text is restricted.
    pub(super) restriction: i32,
    /// The fill reference point, or none for the first corner of the extent.
    pub(super) reference: Option<DVec2>,
    /// Height vector and width vector of patterns, or none for the extent.
    pub(super) pattern_size: Option<(DVec2, DVec2)>,
    /// The corners of the clipping rectangle, or none for the extent.
    pub(super) clip: Option<(DVec2, DVec2)>,
    /// Whether there is clipping.
    pub(super) clipping: bool,
    /// Whether what is copied is clipped as the place it is copied to says, and by nothing else.
    pub(super) clipped_as_copied: bool,
    /// Whether nothing is drawn between dashes and lines of a hatch.
    pub(super) transparent: bool,
    /// The colour that is there otherwise.
    pub(super) auxiliary: Ink,
}

impl Default for Context {
    fn default() -> Self {
        let line = Line {
            kind: 1,
            width: None,
            ink: Ink::Index(1),
            cap: Cap::Butt,
            join: Join::Miter,
            restarts: false,
            offset: 0.0,
        };
        Context {
            modes: Modes::new(255.0),
            metric: None,
            extent: None,
            background: None,
            colours: BTreeMap::new(),
            patterns: BTreeMap::new(),
            dashes: BTreeMap::new(),
            hatches: BTreeMap::new(),
            line: line.clone(),
            marker: Marker { kind: 3, size: None, ink: Ink::Index(1) },
            text: Text { font: 1, precision: 0, expansion: 1.0, spacing: 0.0, ink: Ink::Index(1) },
            fill: Fill { style: 0, ink: Ink::Index(1), hatch: 1, pattern: 1 },
            edge: line,
            edges: false,
            indices: [1; 5],
            line_bundles: BTreeMap::new(),
            marker_bundles: BTreeMap::new(),
            text_bundles: BTreeMap::new(),
            fill_bundles: BTreeMap::new(),
            edge_bundles: BTreeMap::new(),
            bundled: [false; 18],
            height: None,
            up: DVec2::Y,
            base: DVec2::X,
            path: 0,
            alignment: (0, 0, 0.0, 0.0),
            restriction: 1,
            reference: None,
            pattern_size: None,
            clip: None,
            clipping: true,
            clipped_as_copied: false,
            transparent: true,
            auxiliary: Ink::Index(0),
        }
    }
}

/// The continuation of a line type that begins anew at corners.
const RESTART: i32 = 3;

fn cap(number: Option<i32>) -> Option<Cap> {
    match number? {
        3 => Some(Cap::Round),
        4 | 5 => Some(Cap::Projecting),
        1 | 2 => Some(Cap::Butt),
        _ => None,
    }
}

fn join(number: Option<i32>) -> Option<Join> {
    match number? {
        1 | 2 => Some(Join::Miter),
        3 => Some(Join::Round),
        4 => Some(Join::Bevel),
        _ => None,
    }
}

fn set<T>(place: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *place = value;
    }
}

impl Context {
    /// Changes what an element says; whether it is one that only does that.
    pub(super) fn apply(&mut self, element: &Element) -> bool {
        self.modes.observe(element);
        self.line_and_marker(element) || self.text(element) || self.area(element) || self.control(element)
    }

    fn line_and_marker(&mut self, e: &Element) -> bool {
        let size = |e: &Element| e.real(0).filter(|size| *size >= 0.0);
        match e.kind {
            Kind::LineBundleIndex => set(&mut self.indices[0], e.integer(0)),
            Kind::LineType => set(&mut self.line.kind, e.integer(0)),
            Kind::LineWidth => set(&mut self.line.width, size(e).map(Some)),
            Kind::LineColour => set(&mut self.line.ink, e.ink(0)),
            Kind::LineCap => set(&mut self.line.cap, cap(e.integer(0))),
            Kind::LineJoin => set(&mut self.line.join, join(e.integer(0))),
            Kind::LineTypeContinuation => set(&mut self.line.restarts, e.integer(0).map(|n| n == RESTART)),
            Kind::LineTypeInitialOffset => set(&mut self.line.offset, e.real(0)),
            Kind::MarkerBundleIndex => set(&mut self.indices[1], e.integer(0)),
            Kind::MarkerType => set(&mut self.marker.kind, e.integer(0)),
            Kind::MarkerSize => set(&mut self.marker.size, size(e).map(Some)),
            Kind::MarkerColour => set(&mut self.marker.ink, e.ink(0)),
            Kind::EdgeBundleIndex => set(&mut self.indices[4], e.integer(0)),
            Kind::EdgeType => set(&mut self.edge.kind, e.integer(0)),
            Kind::EdgeWidth => set(&mut self.edge.width, size(e).map(Some)),
            Kind::EdgeColour => set(&mut self.edge.ink, e.ink(0)),
            Kind::EdgeVisibility => set(&mut self.edges, e.integer(0).map(|on| on != 0)),
            Kind::EdgeCap => set(&mut self.edge.cap, cap(e.integer(0))),
            Kind::EdgeJoin => set(&mut self.edge.join, join(e.integer(0))),
            Kind::EdgeTypeContinuation => set(&mut self.edge.restarts, e.integer(0).map(|n| n == RESTART)),
            Kind::EdgeTypeInitialOffset => set(&mut self.edge.offset, e.real(0)),
            Kind::LineRepresentation | Kind::EdgeRepresentation => {
                let bundle = || {
                    let (kind, width, ink) = (e.integer(1)?, e.real(2)?, e.ink(3)?);
                    Some((e.integer(0)?, Line { kind, width: Some(width), ink, ..self.line.clone() }))
                };
                let table = if e.kind == Kind::LineRepresentation {
                    &mut self.line_bundles
                } else {
                    &mut self.edge_bundles
                };
                table.extend(bundle());
            }
            Kind::MarkerRepresentation => {
                let bundle = || {
                    let (kind, size, ink) = (e.integer(1)?, Some(e.real(2)?), e.ink(3)?);
                    Some((e.integer(0)?, Marker { kind, size, ink }))
                };
                self.marker_bundles.extend(bundle());
            }
            Kind::LineAndEdgeTypeDefinition => {
                let lengths: Option<Vec<f64>> =
                    (2..e.values.len()).map(|i| e.integer(i).map(f64::from)).collect();
                if let (Some(kind), Some(cycle), Some(lengths)) = (e.integer(0), e.real(1), lengths) {
                    let sum: f64 = lengths.iter().map(|length| length.abs()).sum();
                    if sum > 0.0 && cycle > 0.0 {
                        let scaled = lengths.iter().map(|length| length.abs() / sum * cycle).collect();
                        self.dashes.insert(kind, (self.modes.line_width, scaled));
                    }
                }
            }
            _ => return false,
        }
        true
    }

    fn text(&mut self, e: &Element) -> bool {
        match e.kind {
            Kind::TextBundleIndex => set(&mut self.indices[2], e.integer(0)),
            Kind::TextFontIndex => set(&mut self.text.font, e.integer(0)),
            Kind::TextPrecision => set(&mut self.text.precision, e.integer(0)),
            Kind::CharacterExpansionFactor => {
                set(&mut self.text.expansion, e.real(0).filter(|factor| *factor > 0.0));
            }
            Kind::CharacterSpacing => set(&mut self.text.spacing, e.real(0)),
            Kind::TextColour => set(&mut self.text.ink, e.ink(0)),
            Kind::CharacterHeight => {
                set(&mut self.height, e.real(0).filter(|height| *height > 0.0).map(Some));
            }
            Kind::CharacterOrientation => {
                if let (Some(up), Some(base)) = (e.vector(0), e.vector(2))
                    && up.perp_dot(base) != 0.0
                {
                    (self.up, self.base) = (up, base);
                }
            }
            Kind::TextPath => set(&mut self.path, e.integer(0)),
            Kind::TextAlignment => {
                let (horizontal, vertical) = (e.integer(0).unwrap_or(0), e.integer(1).unwrap_or(0));
                self.alignment = (horizontal, vertical, e.real(2).unwrap_or(0.0), e.real(3).unwrap_or(0.0));
            }
            Kind::RestrictedTextType => set(&mut self.restriction, e.integer(0)),
            Kind::TextRepresentation => {
                let bundle = || {
                    let (font, precision) = (e.integer(1)?, e.integer(2)?);
                    let (spacing, expansion, ink) = (e.real(3)?, e.real(4)?, e.ink(5)?);
                    Some((e.integer(0)?, Text { font, precision, expansion, spacing, ink }))
                };
                self.text_bundles.extend(bundle());
            }
            Kind::CharacterSetIndex | Kind::AlternateCharacterSetIndex => {}
            _ => return false,
        }
        true
    }

    fn area(&mut self, e: &Element) -> bool {
        match e.kind {
            Kind::FillBundleIndex => set(&mut self.indices[3], e.integer(0)),
            Kind::InteriorStyle => set(&mut self.fill.style, e.integer(0)),
            Kind::FillColour => set(&mut self.fill.ink, e.ink(0)),
            Kind::HatchIndex => set(&mut self.fill.hatch, e.integer(0)),
            Kind::PatternIndex => set(&mut self.fill.pattern, e.integer(0)),
            Kind::FillReferencePoint => set(&mut self.reference, e.point(0).map(Some)),
            Kind::PatternSize => {
                if let (Some(height), Some(width)) = (e.vector(0), e.vector(2))
                    && height.perp_dot(width) != 0.0
                {
                    self.pattern_size = Some((height, width));
                }
            }
            Kind::PatternTable => {
                if let (Some(index), Some(cells)) = (e.integer(0), e.cells(1)) {
                    self.patterns.insert(index, Arc::new(cells.clone()));
                }
            }
            Kind::FillRepresentation => {
                let bundle = || {
                    let (style, ink, hatch, pattern) =
                        (e.integer(1)?, e.ink(2)?, e.integer(3)?, e.integer(4)?);
                    Some((e.integer(0)?, Fill { style, ink, hatch, pattern }))
                };
                self.fill_bundles.extend(bundle());
            }
            Kind::HatchStyleDefinition => {
                if let (Some(index), Some(hatch)) = (e.integer(0), Hatch::new(e, self.modes.style_size)) {
                    self.hatches.insert(index, hatch);
                }
            }
            _ => return false,
        }
        true
    }

    fn control(&mut self, e: &Element) -> bool {
        match e.kind {
            Kind::ScalingMode => {
                let factor = e.real(1).filter(|factor| *factor > 0.0);
                self.metric = factor.filter(|_| e.integer(0) == Some(1));
            }
            Kind::VdcExtent => {
                if let (Some(first), Some(second)) = (e.point(0), e.point(1)) {
                    self.extent = Some((first, second));
                }
            }
            Kind::BackgroundColour => {
                if let Some(Ink::Direct(colour)) = e.ink(0) {
                    self.background = Some(colour);
                }
            }
            Kind::ColourTable => {
                let Some(Ink::Index(start)) = e.ink(0) else { return true };
                for place in 1..e.values.len() {
                    let index = start.checked_add(place as u32 - 1);
                    if let (Some(index), Some(Ink::Direct(colour))) = (index, e.ink(place)) {
                        self.colours.insert(index, colour);
                    }
                }
            }
            Kind::Escape if e.integer(0) == Some(escape::SET_COLOUR_ALPHA) => self.opacity(e),
            Kind::ClipRectangle => {
                if let (Some(first), Some(second)) = (e.point(0), e.point(1)) {
                    self.clip = Some((first, second));
                }
            }
            Kind::ClipIndicator => set(&mut self.clipping, e.integer(0).map(|on| on != 0)),
            Kind::ClipInheritance => set(&mut self.clipped_as_copied, e.integer(0).map(|way| way == 0)),
            Kind::Transparency => set(&mut self.transparent, e.integer(0).map(|on| on != 0)),
            Kind::AuxiliaryColour => set(&mut self.auxiliary, e.ink(0)),
            Kind::AspectSourceFlags => {
                for place in (0..e.values.len()).step_by(2) {
                    let aspect = e.integer(place).and_then(|aspect| usize::try_from(aspect).ok());
                    let flag = aspect.and_then(|aspect| self.bundled.get_mut(aspect));
                    if let (Some(flag), Some(value)) = (flag, e.integer(place + 1)) {
                        *flag = value == 1;
                    }
                }
            }
            _ => return false,
        }
        true
    }

    /// Gives an entry of the colour table an opacity: the index and the opacity as text.
    fn opacity(&mut self, e: &Element) {
        let text = e.bytes(1).and_then(|data| std::str::from_utf8(data).ok());
        let Some((index, alpha)) = text.and_then(|text| text.split_once(' ')) else { return };
        if let (Ok(index), Ok(alpha)) = (index.parse::<u32>(), alpha.parse())
            && (0.0..=1.0).contains(&alpha)
            && let Some(colour) = self.colours.get_mut(&index)
        {
            colour.alpha = alpha;
        }
    }

    /// The look of lines.
    pub(super) fn line(&self) -> Line {
        self.merged_line(&self.line, self.line_bundles.get(&self.indices[0]), 0)
    }

    /// The look of edges.
    pub(super) fn edge(&self) -> Line {
        self.merged_line(&self.edge, self.edge_bundles.get(&self.indices[4]), 15)
    }

    fn merged_line(&self, own: &Line, bundle: Option<&Line>, aspect: usize) -> Line {
        let mut line = own.clone();
        if let Some(bundle) = bundle {
            let bundled = &self.bundled[aspect..];
            line.kind = if bundled[0] { bundle.kind } else { own.kind };
            line.width = if bundled[1] { bundle.width } else { own.width };
            line.ink = if bundled[2] { bundle.ink } else { own.ink };
        }
        line
    }

    /// The look of markers.
    pub(super) fn marker(&self) -> Marker {
        let own = &self.marker;
        match self.marker_bundles.get(&self.indices[1]) {
            Some(bundle) => Marker {
                kind: if self.bundled[3] { bundle.kind } else { own.kind },
                size: if self.bundled[4] { bundle.size } else { own.size },
                ink: if self.bundled[5] { bundle.ink } else { own.ink },
            },
            None => own.clone(),
        }
    }

    /// The look of text.
    pub(super) fn text_look(&self) -> Text {
        let own = &self.text;
        match self.text_bundles.get(&self.indices[2]) {
            Some(bundle) => Text {
                font: if self.bundled[6] { bundle.font } else { own.font },
                precision: if self.bundled[7] { bundle.precision } else { own.precision },
                expansion: if self.bundled[8] { bundle.expansion } else { own.expansion },
                spacing: if self.bundled[9] { bundle.spacing } else { own.spacing },
                ink: if self.bundled[10] { bundle.ink } else { own.ink },
            },
            None => own.clone(),
        }
    }

    /// The look of areas.
    pub(super) fn fill(&self) -> Fill {
        let own = &self.fill;
        match self.fill_bundles.get(&self.indices[3]) {
            Some(bundle) => Fill {
                style: if self.bundled[11] { bundle.style } else { own.style },
                ink: if self.bundled[12] { bundle.ink } else { own.ink },
                hatch: if self.bundled[13] { bundle.hatch } else { own.hatch },
                pattern: if self.bundled[14] { bundle.pattern } else { own.pattern },
            },
            None => own.clone(),
        }
    }
}
