//! Writes `kernel/pipeline/src/generated/numbers.rs`: the library's own numbers and predefined tables.

use std::fmt::Write as _;

use crate::tables::{Hatch, Numbers, Tables};

const HEAD: &str = r#"//! Numbers of the library's own choice, and the predefined bundle, pattern and colour tables.
//!
//! Written by `gks-spec generate` from `spec/numbers.toml`; do not edit.

/// A workstation type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WorkstationType {
    /// The number given to OPEN WORKSTATION.
    pub number: i32,
    /// The name that may be given instead of the number.
    pub name: &'static str,
    /// The extension of the files it writes, without the dot; empty if it writes none.
    pub extension: &'static str,
    /// The length of its colour table.
    pub colours: u32,
    /// What it is, in a few words.
    pub meaning: &'static str,
}

/// A font.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Font {
    /// The font number.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// Whether its characters are filled outlines; they are strokes otherwise.
    pub outline: bool,
}

/// A linetype.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linetype {
    /// The linetype number.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// Drawn and blank lengths in turn, in units of the nominal linewidth; empty for a solid line.
    pub dashes: &'static [f64],
}

/// A marker type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Marker {
    /// The marker type number.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
}

/// A hatch style.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatch {
    /// The style index.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// The directions of its families of lines, in degrees anticlockwise from the horizontal.
    pub angles: &'static [f64],
    /// The distance between lines, in units of the nominal hatch spacing.
    pub spacing: f64,
}

/// The group of attributes that a generalized drawing primitive takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GdpAttributes {
    /// The polyline attributes.
    Polyline,
    /// The fill area attributes.
    FillArea,
}

/// A generalized drawing primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gdp {
    /// Its identifier.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// The least number of points.
    pub least: usize,
    /// The greatest number of points; 0 if there is none.
    pub most: usize,
    /// The number of points is `least` plus a multiple of this.
    pub step: usize,
    /// The attributes it takes.
    pub attributes: GdpAttributes,
}

/// A function of ESCAPE.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Escape {
    /// Its identifier.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// How many integers the input data record holds.
    pub integers: usize,
    /// How many reals the input data record holds.
    pub reals: usize,
    /// How many integers the output data record holds.
    pub output_integers: usize,
}

/// A predefined polyline bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolylineBundle {
    /// The linetype.
    pub linetype: i32,
    /// The linewidth scale factor.
    pub linewidth: f64,
    /// The colour index.
    pub colour: u32,
}

/// A predefined polymarker bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolymarkerBundle {
    /// The marker type.
    pub marker: i32,
    /// The marker size scale factor.
    pub size: f64,
    /// The colour index.
    pub colour: u32,
}

/// A predefined text bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextBundle {
    /// The font.
    pub font: i32,
    /// The precision: 0 STRING, 1 CHAR, 2 STROKE.
    pub precision: u8,
    /// The character expansion factor.
    pub expansion: f64,
    /// The character spacing.
    pub spacing: f64,
    /// The colour index.
    pub colour: u32,
}

/// A predefined fill area bundle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FillAreaBundle {
    /// The interior style: 0 HOLLOW, 1 SOLID, 2 PATTERN, 3 HATCH.
    pub interior: u8,
    /// The style index.
    pub style: i32,
    /// The colour index.
    pub colour: u32,
}

/// A predefined pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The number of columns, DX.
    pub columns: usize,
    /// The number of rows, DY.
    pub rows: usize,
    /// The colour indices, row by row, the upper row first.
    pub cells: &'static [i32],
}
"#;

/// The text of the file.
pub(crate) fn generate(tables: &Tables) -> String {
    let numbers = &tables.numbers;
    let mut out = String::from(HEAD);
    write_scalars(&mut out, numbers);
    write_devices(&mut out, numbers);
    write_looks(&mut out, numbers);
    write_functions(&mut out, numbers);
    write_bundles(&mut out, tables);
    write_colours(&mut out, numbers);
    out
}

fn write_scalars(out: &mut String, numbers: &Numbers) {
    for (name, value) in &numbers.nominal {
        let _ = writeln!(
            out,
            "\n/// The nominal {}, as a fraction of the shorter side of the display surface.\npub const NOMINAL_{}: f64 = {value:?};",
            name.replace('_', " "),
            constant(name)
        );
    }
    for (name, value) in &numbers.limits {
        let _ = writeln!(
            out,
            "\n/// The greatest number of {}.\npub const MAX_{}: u32 = {value};",
            name.replace('_', " "),
            constant(name)
        );
    }
    for (name, value) in &numbers.input {
        let _ = writeln!(
            out,
            "\n/// The {} of input devices of a workstation just opened.\npub const INPUT_{}: f64 = {value:?};",
            name.replace('_', " "),
            constant(name)
        );
    }
    for (name, size) in &numbers.input_buffer {
        let _ = writeln!(
            out,
            "\n/// What the buffer of a {name} device of a workstation just opened holds.\npub const INPUT_BUFFER_{}: usize = {size};",
            constant(name)
        );
    }
    let rows = numbers.input_class.iter().map(|class| format!("&{:?}", class.prompts));
    array(out, "PROMPTS", "&[i32]", "The prompt and echo types of the input classes, in their order.", rows);
    for error in &numbers.binding_error {
        let _ = writeln!(
            out,
            "\n/// The error number of the bindings for: {}.\npub const ERROR_{}: i32 = {};",
            error.name,
            constant(&error.name),
            error.number
        );
    }
}

fn write_devices(out: &mut String, numbers: &Numbers) {
    let types = numbers.workstation_type.iter().map(|t| (t.number, t.name.as_str(), t.meaning.as_str()));
    module(out, "workstation_type", "Workstation type numbers.", types);
    let rows = numbers.workstation_type.iter().map(|t| {
        let colours = t.colours.or_else(|| numbers.limits.get("colours").copied()).unwrap_or(0);
        format!(
            "WorkstationType {{ number: {}, name: {:?}, extension: {:?}, colours: {colours}, meaning: {:?} }}",
            t.number, t.name, t.extension, t.meaning
        )
    });
    array(out, "WORKSTATION_TYPES", "WorkstationType", "The workstation types.", rows);
    let rows = numbers.font.iter().map(|f| {
        format!("Font {{ number: {}, name: {:?}, outline: {} }}", f.number, f.name, f.kind == "outline")
    });
    array(out, "FONTS", "Font", "The fonts.", rows);
}

fn write_looks(out: &mut String, numbers: &Numbers) {
    let rows = numbers
        .linetype
        .iter()
        .map(|l| format!("Linetype {{ number: {}, name: {:?}, dashes: &{:?} }}", l.number, l.name, l.dashes));
    array(out, "LINETYPES", "Linetype", "The linetypes.", rows);
    let markers = numbers.marker.iter().map(|m| (m.number, m.name.as_str(), m.name.as_str()));
    module(out, "marker", "Marker type numbers.", markers);
    let rows =
        numbers.marker.iter().map(|m| format!("Marker {{ number: {}, name: {:?} }}", m.number, m.name));
    array(out, "MARKERS", "Marker", "The marker types.", rows);
    let hatch = |number: i32, h: &Hatch| {
        let (name, angles, spacing) = (&h.name, &h.angles, h.spacing);
        format!("Hatch {{ number: {number}, name: {name:?}, angles: &{angles:?}, spacing: {spacing:?} }}")
    };
    let own = numbers.hatch.iter().map(|h| hatch(h.number, h));
    let same = numbers.hatch.iter().filter_map(|h| h.same_as.map(|number| hatch(number, h)));
    array(
        out,
        "HATCHES",
        "Hatch",
        "The hatch styles, the positive indices after the negative ones.",
        own.chain(same),
    );
}

fn write_functions(out: &mut String, numbers: &Numbers) {
    let gdps = numbers.gdp.iter().map(|g| (g.number, g.name.as_str(), g.points.as_str()));
    module(out, "gdp", "Identifiers of generalized drawing primitives; the points of each, in order.", gdps);
    let rows = numbers.gdp.iter().map(|g| {
        format!(
            "Gdp {{ number: {}, name: {:?}, least: {}, most: {}, step: {}, attributes: GdpAttributes::{} }}",
            g.number, g.name, g.least, g.most, g.step, g.attributes
        )
    });
    array(out, "GDPS", "Gdp", "The generalized drawing primitives.", rows);
    let records: Vec<String> = numbers
        .escape
        .iter()
        .map(|e| {
            let parts =
                [("integers", &e.integers), ("reals", &e.reals), ("integers out", &e.output_integers)];
            let parts: Vec<String> = parts
                .iter()
                .filter(|(_, items)| !items.is_empty())
                .map(|(label, items)| format!("{label} ({})", items.join("; ")))
                .collect();
            format!("{}; data record: {}", e.name, parts.join(", "))
        })
        .collect();
    let escapes = numbers.escape.iter().zip(&records).map(|(e, r)| (e.number, e.name.as_str(), r.as_str()));
    module(out, "escape", "Identifiers of escape functions.", escapes);
    let rows = numbers.escape.iter().map(|e| {
        format!(
            "Escape {{ number: {}, name: {:?}, integers: {}, reals: {}, output_integers: {} }}",
            e.number,
            e.name,
            e.integers.len(),
            e.reals.len(),
            e.output_integers.len()
        )
    });
    array(out, "ESCAPES", "Escape", "The escape functions.", rows);
}

fn write_bundles(out: &mut String, tables: &Tables) {
    let numbers = &tables.numbers;
    let rows = numbers.polyline_bundle.iter().map(|b| {
        format!(
            "PolylineBundle {{ linetype: {}, linewidth: {:?}, colour: {} }}",
            b.linetype, b.linewidth, b.colour
        )
    });
    array(out, "POLYLINE_BUNDLES", "PolylineBundle", "The predefined polyline bundles 1, 2, ....", rows);
    let rows = numbers.polymarker_bundle.iter().map(|b| {
        format!("PolymarkerBundle {{ marker: {}, size: {:?}, colour: {} }}", b.marker, b.size, b.colour)
    });
    array(
        out,
        "POLYMARKER_BUNDLES",
        "PolymarkerBundle",
        "The predefined polymarker bundles 1, 2, ....",
        rows,
    );
    let rows = numbers.text_bundle.iter().map(|b| {
        format!(
            "TextBundle {{ font: {}, precision: {}, expansion: {:?}, spacing: {:?}, colour: {} }}",
            b.font,
            value_of(tables, "text precision", &b.precision),
            b.expansion,
            b.spacing,
            b.colour
        )
    });
    array(out, "TEXT_BUNDLES", "TextBundle", "The predefined text bundles 1, 2, ....", rows);
    let rows = numbers.fill_area_bundle.iter().map(|b| {
        let interior = value_of(tables, "fill area interior style", &b.interior);
        format!("FillAreaBundle {{ interior: {interior}, style: {}, colour: {} }}", b.style, b.colour)
    });
    array(out, "FILL_AREA_BUNDLES", "FillAreaBundle", "The predefined fill area bundles 1, 2, ....", rows);
    let rows = numbers.pattern.iter().map(|p| {
        let cells: Vec<u32> =
            p.rows.iter().flat_map(|row| row.chars().filter_map(|c| c.to_digit(10))).collect();
        let columns = p.rows.first().map_or(0, String::len);
        format!("Pattern {{ columns: {columns}, rows: {}, cells: &{cells:?} }}", p.rows.len())
    });
    array(out, "PATTERNS", "Pattern", "The predefined patterns 1, 2, ....", rows);
}

fn write_colours(out: &mut String, numbers: &Numbers) {
    let names = numbers.colour.iter().enumerate().map(|(i, c)| (i as i32, c.name.as_str(), c.name.as_str()));
    module(out, "colour", "Indices of the named predefined colours.", names);
    let rows = colours(numbers).into_iter().map(|rgb| format!("{rgb:?}"));
    array(
        out,
        "COLOURS",
        "[f32; 3]",
        "The predefined colours 0, 1, ...: red, green, blue from 0 to 1.",
        rows,
    );
}

/// The predefined colour table: the listed colours, the cube, the ramp.
pub(crate) fn colours(numbers: &Numbers) -> Vec<[f32; 3]> {
    let mut table: Vec<[f32; 3]> = numbers.colour.iter().map(|c| c.rgb).collect();
    let levels = numbers.colour_cube.levels;
    let component = |level: usize| level as f32 / (levels - 1) as f32;
    for cell in 0..levels.pow(3) {
        table.push([cell / (levels * levels), cell / levels % levels, cell % levels].map(component));
    }
    let count = numbers.grey_ramp.count;
    table.extend((1..=count).map(|i| [i as f32 / (count + 1) as f32; 3]));
    table
}

/// The value of an enumeration's constant by its Rust name; -1, which does not compile, for an unknown one.
fn value_of(tables: &Tables, enumeration: &str, name: &str) -> i32 {
    let enumeration = tables.enumerations.enumeration.iter().find(|e| e.name == enumeration);
    enumeration
        .and_then(|e| e.values.iter().find(|v| v.rust.as_deref() == Some(name)))
        .map_or(-1, |value| value.value)
}

fn module<'a>(out: &mut String, name: &str, doc: &str, items: impl Iterator<Item = (i32, &'a str, &'a str)>) {
    let _ = writeln!(out, "\n/// {doc}\npub mod {name} {{");
    for (number, name, meaning) in items {
        let _ = writeln!(
            out,
            "    /// {}.\n    pub const {}: i32 = {number};",
            sentence(meaning),
            constant(name)
        );
    }
    out.push_str("}\n");
}

fn array(out: &mut String, name: &str, kind: &str, doc: &str, rows: impl Iterator<Item = String>) {
    let _ = writeln!(out, "\n/// {doc}\npub static {name}: &[{kind}] = &[");
    for row in rows {
        let _ = writeln!(out, "    {row},");
    }
    out.push_str("];\n");
}

fn constant(name: &str) -> String {
    let name = name.to_uppercase().replace([' ', '-'], "_");
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("N{name}") } else { name }
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|c| c.to_uppercase().collect::<String>() + letters.as_str()).unwrap_or_default()
}
