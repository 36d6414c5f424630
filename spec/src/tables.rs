//! The tables of `spec/`, as Rust values: what the TOML files say and nothing else.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde::de::DeserializeOwned;

/// All tables together.
#[derive(Debug, Clone)]
pub(crate) struct Tables {
    pub(crate) functions: Vec<Function>,
    pub(crate) errors: Vec<Error>,
    pub(crate) enumerations: Enumerations,
    pub(crate) numbers: Numbers,
}

impl Tables {
    /// Reads the tables below the folder `spec`; the message of an error names the file and the line.
    pub(crate) fn load(spec: &Path) -> Result<Self, String> {
        let functions: FunctionFile = read(&spec.join("gks/functions.toml"))?;
        let errors: ErrorFile = read(&spec.join("gks/errors.toml"))?;
        Ok(Self {
            functions: functions.function,
            errors: errors.error,
            enumerations: read(&spec.join("gks/enumerations.toml"))?,
            numbers: read(&spec.join("numbers.toml"))?,
        })
    }
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<T, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    toml::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FunctionFile {
    function: Vec<Function>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ErrorFile {
    error: Vec<Error>,
}

/// A function of the standard or of a language binding.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Function {
    pub(crate) name: String,
    pub(crate) category: String,
    pub(crate) level: String,
    pub(crate) rust: Option<String>,
    pub(crate) sample: Option<String>,
    pub(crate) c: Option<String>,
    pub(crate) prototype: Option<String>,
    pub(crate) confirmed: Option<bool>,
    #[serde(rename = "prototype_note")]
    _prototype_note: Option<String>,
    pub(crate) fortran: Vec<String>,
    #[serde(default)]
    pub(crate) fortran_split: Vec<String>,
    pub(crate) id: Option<i32>,
    pub(crate) states: Vec<String>,
    pub(crate) errors: Vec<i32>,
    #[serde(default)]
    pub(crate) fortran_errors: Vec<i32>,
    #[serde(rename = "note")]
    _note: Option<String>,
    #[serde(default)]
    pub(crate) unreachable: BTreeMap<String, String>,
    #[serde(default)]
    pub(crate) parameters: BTreeMap<String, Vec<Parameter>>,
}

/// A parameter of a Fortran subroutine.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Parameter {
    pub(crate) name: String,
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) direction: String,
    pub(crate) dimension: Option<String>,
    pub(crate) enumeration: Option<String>,
    pub(crate) meaning: String,
}

/// An error number with its text.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Error {
    pub(crate) number: i32,
    pub(crate) category: String,
    pub(crate) text: String,
    #[serde(rename = "note")]
    _note: Option<String>,
}

/// The enumerations and the numbers that have names.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Enumerations {
    pub(crate) aspects: Vec<Aspect>,
    pub(crate) enumeration: Vec<Enumeration>,
    pub(crate) named_numbers: Vec<NumberGroup>,
    pub(crate) demonstration_numbers: Vec<NumberGroup>,
    pub(crate) dialect_workstation_types: Vec<DialectTypes>,
}

/// One of the 13 aspects that have a source flag.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Aspect {
    pub(crate) name: String,
    pub(crate) c: String,
    pub(crate) xgks: String,
}

/// An enumeration.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Enumeration {
    pub(crate) name: String,
    pub(crate) rust: String,
    pub(crate) c: String,
    #[serde(rename = "confirmed")]
    _confirmed: bool,
    #[serde(rename = "note")]
    _note: Option<String>,
    pub(crate) values: Vec<Value>,
}

/// Integers with names, not an enumeration: linetypes, marker types.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct NumberGroup {
    pub(crate) name: String,
    #[serde(rename = "note")]
    _note: Option<String>,
    pub(crate) values: Vec<Value>,
}

/// A value of an enumeration, with its names.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Value {
    pub(crate) value: i32,
    pub(crate) rust: Option<String>,
    pub(crate) fortran: OneOrMore,
    pub(crate) c: Option<String>,
    #[serde(rename = "xgks")]
    _xgks: Option<String>,
    #[serde(rename = "xgks_value")]
    _xgks_value: Option<i32>,
    #[serde(rename = "gr")]
    _gr: Option<String>,
}

/// One name or several.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(crate) enum OneOrMore {
    One(String),
    More(Vec<String>),
}

impl OneOrMore {
    /// The names, in order.
    pub(crate) fn names(&self) -> &[String] {
        match self {
            Self::One(name) => std::slice::from_ref(name),
            Self::More(names) => names,
        }
    }
}

/// Workstation type numbers of another implementation.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DialectTypes {
    pub(crate) dialect: String,
    pub(crate) values: Vec<DialectType>,
}

/// A range of them.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DialectType {
    pub(crate) first: i32,
    pub(crate) last: i32,
    pub(crate) meaning: String,
    #[serde(rename = "gr")]
    _gr: Option<String>,
}

/// `numbers.toml`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Numbers {
    pub(crate) nominal: BTreeMap<String, f64>,
    pub(crate) limits: BTreeMap<String, u32>,
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
