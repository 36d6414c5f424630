//! The rows of `numbers.toml`.

use std::collections::BTreeMap;

use serde::Deserialize;

/// `numbers.toml`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Numbers {
    pub(crate) nominal: BTreeMap<String, f64>,
    pub(crate) limits: BTreeMap<String, u32>,
    pub(crate) input: BTreeMap<String, f64>,
    pub(crate) input_buffer: BTreeMap<String, u32>,
    pub(crate) input_class: Vec<InputClass>,
    pub(crate) binding_error: Vec<Named>,
    pub(crate) workstation_type: Vec<WorkstationType>,
    pub(crate) reserved_workstation_types: Vec<Reserved>,
    pub(crate) font: Vec<Font>,
    pub(crate) linetype: Vec<Linetype>,
    pub(crate) marker: Vec<Named>,
    pub(crate) hatch: Vec<Hatch>,
    pub(crate) gdp: Vec<Gdp>,
    pub(crate) escape: Vec<Escape>,
    pub(crate) polyline_bundle: Vec<PolylineBundle>,
    pub(crate) polymarker_bundle: Vec<PolymarkerBundle>,
    pub(crate) text_bundle: Vec<TextBundle>,
    pub(crate) fill_area_bundle: Vec<FillAreaBundle>,
    pub(crate) pattern: Vec<Pattern>,
    pub(crate) colour: Vec<Colour>,
    pub(crate) colour_cube: ColourCube,
    pub(crate) grey_ramp: GreyRamp,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Named {
    pub(crate) number: i32,
    pub(crate) name: String,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct InputClass {
    pub(crate) name: String,
    pub(crate) prompts: Vec<i32>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct WorkstationType {
    pub(crate) number: i32,
    pub(crate) name: String,
    pub(crate) extension: String,
    pub(crate) colours: Option<u32>,
    pub(crate) meaning: String,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Reserved {
    pub(crate) first: i32,
    pub(crate) last: i32,
    pub(crate) name: String,
    pub(crate) meaning: String,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Font {
    pub(crate) number: i32,
    pub(crate) name: String,
    pub(crate) kind: String,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Linetype {
    pub(crate) number: i32,
    pub(crate) name: String,
    pub(crate) dashes: Vec<f64>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Hatch {
    pub(crate) number: i32,
    pub(crate) name: String,
    pub(crate) angles: Vec<f64>,
    pub(crate) spacing: f64,
    pub(crate) same_as: Option<i32>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Gdp {
    pub(crate) number: i32,
    pub(crate) name: String,
    pub(crate) points: String,
    pub(crate) least: usize,
    pub(crate) most: usize,
    pub(crate) step: usize,
    pub(crate) attributes: String,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Escape {
    pub(crate) number: i32,
    pub(crate) name: String,
    pub(crate) integers: Vec<String>,
    pub(crate) reals: Vec<String>,
    #[serde(default)]
    pub(crate) output_integers: Vec<String>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PolylineBundle {
    pub(crate) linetype: i32,
    pub(crate) linewidth: f64,
    pub(crate) colour: usize,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PolymarkerBundle {
    pub(crate) marker: i32,
    pub(crate) size: f64,
    pub(crate) colour: usize,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TextBundle {
    pub(crate) font: i32,
    pub(crate) precision: String,
    pub(crate) expansion: f64,
    pub(crate) spacing: f64,
    pub(crate) colour: usize,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FillAreaBundle {
    pub(crate) interior: String,
    pub(crate) style: i32,
    pub(crate) colour: usize,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Pattern {
    pub(crate) name: String,
    pub(crate) rows: Vec<String>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Colour {
    pub(crate) name: String,
    pub(crate) rgb: [f32; 3],
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ColourCube {
    pub(crate) first: usize,
    pub(crate) levels: usize,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct GreyRamp {
    pub(crate) first: usize,
    pub(crate) count: usize,
}
