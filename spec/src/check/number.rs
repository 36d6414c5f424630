//! Checks `numbers.toml`.

use super::unique;
use crate::numbers::colours;
use crate::tables::{Numbers, Tables};

/// Adds what is wrong with the numbers of our own.
pub(super) fn check(tables: &Tables, faults: &mut Vec<String>) {
    let numbers = &tables.numbers;
    duplicates(numbers, faults);
    workstation_types(numbers, faults);
    looks(numbers, faults);
    input(tables, faults);
    references(tables, faults);
    colour_table(numbers, faults);
    least_support(tables, faults);
    for error in &numbers.binding_error {
        if !tables.errors.iter().any(|e| e.number == error.number) {
            faults.push(format!("{}: error {} has no text", error.name, error.number));
        }
    }
}

fn duplicates(numbers: &Numbers, faults: &mut Vec<String>) {
    unique("workstation type", numbers.workstation_type.iter().map(|t| t.number), faults);
    unique("workstation type", numbers.workstation_type.iter().map(|t| &t.name), faults);
    unique("font", numbers.font.iter().map(|f| f.number), faults);
    unique("font", numbers.font.iter().map(|f| &f.name), faults);
    unique("linetype", numbers.linetype.iter().map(|l| l.number), faults);
    unique("linetype", numbers.linetype.iter().map(|l| &l.name), faults);
    unique("marker type", numbers.marker.iter().map(|m| m.number), faults);
    unique("marker type", numbers.marker.iter().map(|m| &m.name), faults);
    let hatches = numbers.hatch.iter().flat_map(|h| std::iter::once(h.number).chain(h.same_as));
    unique("hatch style", hatches, faults);
    unique("hatch style", numbers.hatch.iter().map(|h| &h.name), faults);
    unique("generalized drawing primitive", numbers.gdp.iter().map(|g| g.number), faults);
    unique("generalized drawing primitive", numbers.gdp.iter().map(|g| &g.name), faults);
    unique("escape", numbers.escape.iter().map(|e| e.number), faults);
    unique("escape", numbers.escape.iter().map(|e| &e.name), faults);
    unique("pattern", numbers.pattern.iter().map(|p| &p.name), faults);
    unique("colour", numbers.colour.iter().map(|c| &c.name), faults);
}

fn workstation_types(numbers: &Numbers, faults: &mut Vec<String>) {
    for reserved in &numbers.reserved_workstation_types {
        if reserved.first > reserved.last || reserved.meaning.is_empty() {
            faults.push(format!("{}: the reserved range is empty or has no meaning", reserved.name));
        }
        let range = reserved.first..=reserved.last;
        for kind in numbers.workstation_type.iter().filter(|t| range.contains(&t.number)) {
            faults.push(format!(
                "workstation type {}: {} is reserved for {}",
                kind.name, kind.number, reserved.name
            ));
        }
    }
    for kind in &numbers.workstation_type {
        let limit = numbers.limits.get("colours").copied().unwrap_or(0);
        if kind.meaning.is_empty() || kind.colours.is_some_and(|colours| colours > limit) {
            faults.push(format!("workstation type {}: no meaning, or too many colours", kind.name));
        }
    }
}

/// There is a row for every input class, in order, and each class has prompt and echo type 1.
fn input(tables: &Tables, faults: &mut Vec<String>) {
    let rows = &tables.numbers.input_class;
    let classes = tables.enumerations.enumeration.iter().find(|e| e.name == "input class");
    let names: Vec<String> = classes.map_or(Vec::new(), |classes| {
        let own = classes.values.iter().filter(|value| value.value > 0);
        own.filter_map(|value| Some(value.rust.as_ref()?.to_lowercase())).collect()
    });
    if !rows.iter().map(|row| &row.name).eq(&names) {
        faults.push(format!("the input classes are not those of the enumeration: {names:?}"));
    }
    for row in rows {
        if row.prompts.first() != Some(&1) || !row.prompts.is_sorted_by(|a, b| a < b) {
            faults.push(format!("{}: prompt and echo types start with 1 and increase", row.name));
        }
    }
}

fn looks(numbers: &Numbers, faults: &mut Vec<String>) {
    for (name, size) in &numbers.nominal {
        if !(*size > 0.0 && *size < 1.0) {
            faults.push(format!("nominal {name}: not a fraction of the display surface"));
        }
    }
    for font in &numbers.font {
        if !["stroke", "outline"].contains(&font.kind.as_str()) {
            faults.push(format!("font {}: unknown kind {}", font.name, font.kind));
        }
    }
    for linetype in &numbers.linetype {
        if linetype.dashes.len() % 2 == 1 || linetype.dashes.iter().any(|length| *length <= 0.0) {
            faults.push(format!("linetype {}: dashes and gaps do not alternate", linetype.name));
        }
    }
    for hatch in &numbers.hatch {
        let angles = hatch.angles.iter().all(|angle| (0.0..180.0).contains(angle));
        if hatch.angles.is_empty() || !angles || hatch.spacing <= 0.0 || hatch.same_as.is_some_and(|n| n <= 0)
        {
            faults.push(format!("hatch style {}: the lines make no sense", hatch.name));
        }
    }
    for gdp in &numbers.gdp {
        let group = ["Polyline", "FillArea"].contains(&gdp.attributes.as_str());
        let count = gdp.least > 0 && gdp.step > 0 && (gdp.most == 0 || gdp.most >= gdp.least);
        if !group || !count || gdp.points.is_empty() {
            faults.push(format!(
                "generalized drawing primitive {}: points or attributes make no sense",
                gdp.name
            ));
        }
    }
    for escape in &numbers.escape {
        let own = clear_of_ncar(escape.number);
        let record = [&escape.integers, &escape.reals, &escape.output_integers];
        if !own || record.into_iter().flatten().any(String::is_empty) {
            faults.push(format!("escape {}: the number is NCAR's, or an item has no meaning", escape.name));
        }
    }
    for pattern in &numbers.pattern {
        let columns = pattern.rows.first().map_or(0, String::len);
        let digits =
            pattern.rows.iter().all(|row| row.len() == columns && row.chars().all(|c| c.is_ascii_digit()));
        if columns == 0 || !digits {
            faults.push(format!("pattern {}: not a rectangle of digits", pattern.name));
        }
    }
}

/// Whether an escape identifier keeps clear of those of NCAR's GKS.
fn clear_of_ncar(number: i32) -> bool {
    !(-1532..=-1386).contains(&number)
}

/// Bundles may only use what exists.
fn references(tables: &Tables, faults: &mut Vec<String>) {
    let numbers = &tables.numbers;
    let colour_count = colours(numbers).len();
    let mut want = |fine: bool, what: &str, place: usize| {
        if !fine {
            faults.push(format!("{what} bundle {}: it uses what does not exist", place + 1));
        }
    };
    let value = |enumeration: &str, name: &str| {
        let enumeration = tables.enumerations.enumeration.iter().find(|e| e.name == enumeration);
        enumeration.is_some_and(|e| e.values.iter().any(|v| v.rust.as_deref() == Some(name)))
    };
    for (i, bundle) in numbers.polyline_bundle.iter().enumerate() {
        let linetype = numbers.linetype.iter().any(|l| l.number == bundle.linetype);
        want(linetype && bundle.linewidth >= 0.0 && bundle.colour < colour_count, "polyline", i);
    }
    for (i, bundle) in numbers.polymarker_bundle.iter().enumerate() {
        let marker = numbers.marker.iter().any(|m| m.number == bundle.marker);
        want(marker && bundle.size >= 0.0 && bundle.colour < colour_count, "polymarker", i);
    }
    for (i, bundle) in numbers.text_bundle.iter().enumerate() {
        let font = numbers.font.iter().any(|f| f.number == bundle.font)
            && value("text precision", &bundle.precision);
        want(
            font && bundle.expansion > 0.0 && bundle.spacing.is_finite() && bundle.colour < colour_count,
            "text",
            i,
        );
    }
    for (i, bundle) in numbers.fill_area_bundle.iter().enumerate() {
        let style = match bundle.interior.as_str() {
            "Pattern" => (1..=numbers.pattern.len() as i32).contains(&bundle.style),
            "Hatch" => {
                numbers.hatch.iter().any(|h| h.number == bundle.style || h.same_as == Some(bundle.style))
            }
            interior => value("fill area interior style", interior) && bundle.style != 0,
        };
        want(style && bundle.colour < colour_count, "fill area", i);
    }
}

fn colour_table(numbers: &Numbers, faults: &mut Vec<String>) {
    let cube = numbers.colour_cube.first;
    let ramp = numbers.grey_ramp.first;
    let levels = numbers.colour_cube.levels;
    if levels < 2 || cube != numbers.colour.len() || ramp != cube + levels.pow(3) {
        faults.push("the colours, the colour cube and the grey ramp do not follow one another".to_owned());
    }
    for colour in &numbers.colour {
        if !colour.rgb.iter().all(|component| (0.0..=1.0).contains(component)) {
            faults.push(format!("colour {}: a component lies outside 0 to 1", colour.name));
        }
    }
    for (place, colour) in numbers.colour.iter().enumerate() {
        if numbers.colour[..place].iter().any(|other| other.rgb == colour.rgb) {
            faults.push(format!("colour {}: it cannot be told from another", colour.name));
        }
    }
}

/// The predefined tables must be as long as the standard asks at output level 2.
fn least_support(tables: &Tables, faults: &mut Vec<String>) {
    let numbers = &tables.numbers;
    let limit = |name: &str| numbers.limits.get(name).map_or(0, |limit| *limit as usize);
    let counts = [
        ("linetypes", numbers.linetype.len()),
        ("marker_types", numbers.marker.len()),
        ("hatch_styles", numbers.hatch.len()),
        ("stroke_precision_fonts", numbers.font.len()),
        ("predefined_polyline_bundles", numbers.polyline_bundle.len()),
        ("predefined_polymarker_bundles", numbers.polymarker_bundle.len()),
        ("predefined_text_bundles", numbers.text_bundle.len()),
        ("predefined_fill_area_bundles", numbers.fill_area_bundle.len()),
        ("predefined_patterns", numbers.pattern.len()),
        ("settable_polyline_bundles", limit("polyline_bundles")),
        ("settable_polymarker_bundles", limit("polymarker_bundles")),
        ("settable_text_bundles", limit("text_bundles")),
        ("settable_fill_area_bundles", limit("fill_area_bundles")),
        ("settable_patterns", limit("patterns")),
        ("normalization_transformations", limit("normalization_transformations")),
    ];
    for (name, count) in counts {
        let least = tables.states.least_support.get(name).map(|levels| levels[2]);
        if least.is_none_or(|least| (count as i32) < least) {
            faults.push(format!("{name}: {count}, and the standard asks for {least:?}"));
        }
    }
}
