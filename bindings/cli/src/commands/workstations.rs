//! `gks workstations`: the workstation types of this installation.

use super::Failure;
use gks_pipeline::description::{Catalogue, Category, Description};
use gks_workstations::catalogue::Drivers;
use serde::Serialize;
use std::process::ExitCode;

/// A workstation type as JSON shows it.
#[derive(Serialize)]
struct Row {
    r#type: i32,
    name: &'static str,
    category: &'static str,
    width: f64,
    height: f64,
    columns: u32,
    rows: u32,
    colours: u32,
}

/// The word for a category.
fn category(category: Category) -> &'static str {
    match category {
        Category::Output => "output",
        Category::Input => "input",
        Category::OutIn => "outin",
        Category::Wiss => "wiss",
        Category::MetafileOutput => "mo",
        Category::MetafileInput => "mi",
    }
}

impl From<Description> for Row {
    fn from(d: Description) -> Self {
        let (width, height) = d.size();
        Row {
            r#type: d.number,
            name: d.name,
            category: category(d.category),
            width,
            height,
            columns: d.raster.0,
            rows: d.raster.1,
            colours: d.colours,
        }
    }
}

/// Prints the table.
pub fn run(json: bool) -> Result<ExitCode, Failure> {
    let drivers = Drivers::from_process();
    let rows: Vec<Row> =
        drivers.types().into_iter().filter_map(|t| drivers.describe(t)).map(Row::from).collect();
    if json {
        println!("{}", serde_json::to_string_pretty(&rows)?);
    } else {
        println!(
            "{:>5}  {:<14} {:<8} {:>17}  {:>15}  {:>7}",
            "type", "name", "category", "metres", "units", "colours"
        );
        for r in rows {
            let metres = format!("{:.3} x {:.3}", r.width, r.height);
            let units = format!("{} x {}", r.columns, r.rows);
            let colours = if r.colours == 0 { "any".to_owned() } else { r.colours.to_string() };
            println!(
                "{:>5}  {:<14} {:<8} {metres:>17}  {units:>15}  {colours:>7}",
                r.r#type, r.name, r.category
            );
        }
    }
    Ok(ExitCode::SUCCESS)
}
