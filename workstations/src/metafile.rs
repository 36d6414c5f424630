//! Metafiles as workstations: their description, and finding the file that is read.

use crate::connection;
use crate::options::Options;
use crate::raster::{self, SizeError};
use gks_metafile::{ReadOptions, open_source};
use gks_pipeline::description::{
    Category, Classification, Description, DynamicModification, DynamicModifications,
};
use gks_pipeline::generated::numbers::{WORKSTATION_TYPES, workstation_type as own};
use gks_pipeline::record::Source;
use std::fs::File;
use std::io;
use std::path::Path;

/// The description of a type that writes or reads metafiles.
///
/// Its display surface, which bounds workstation viewports, is that of a raster with the same options.
pub(crate) fn describe(
    number: i32,
    name: &'static str,
    category: Category,
    options: &Options,
) -> Result<Description, SizeError> {
    let surface = raster::true_colour(number, name, options)?;
    if !matches!(number, own::GKSM | own::MI) {
        // Pictures are drawn as on a device.
        return Ok(Description { category, classification: Classification::Other, ..surface });
    }
    let imm = DynamicModification::Imm;
    Ok(Description {
        category,
        classification: Classification::Other,
        // What is changed is recorded at once.
        dynamic: DynamicModifications {
            line_bundles: imm,
            marker_bundles: imm,
            text_bundles: imm,
            fill_bundles: imm,
            patterns: imm,
            colours: imm,
            transformation: imm,
        },
        ..surface
    })
}

/// The metafile that the connection identifier of a program means: the file of that name, the standard input
/// for `-`, or for a number N the first file that there is of `gks.N` with the extensions of metafiles.
pub(crate) fn open(connection: &str, options: &Options) -> Result<Box<dyn Source>, String> {
    let name = found(connection.trim());
    let said = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let read = ReadOptions { items: options.items };
    let opened = if name == "-" {
        open_source(io::stdin(), &read)
    } else {
        open_source(File::open(&name).map_err(|error| said(&error))?, &read)
    };
    opened.map(|opened| opened.source).map_err(|error| said(&error))
}

/// The name of the file to read.
fn found(connection: &str) -> String {
    let kinds =
        WORKSTATION_TYPES.iter().filter(|kind| crate::drivers::category(kind) == Category::MetafileOutput);
    let mut names = kinds.map(|kind| connection::Target::of_program(connection, kind.extension).name);
    let first = names.next().unwrap_or_else(|| connection.to_owned());
    let there = std::iter::once(first.clone()).chain(names).find(|name| Path::new(name).exists());
    there.unwrap_or(first)
}
