//! Pictures drawn here, at once and by way of metafiles.

use crate::pictures::{Picture, draw_gks};
use gks_metafile::{Format, ReadOptions, open_source};
use gks_pipeline::generated::numbers::workstation_type as own;
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use std::fs;
use std::path::{Path, PathBuf};

/// The most faults of a metafile that are told.
const MOST_FAULTS: usize = 16;

/// The drivers of the installation, whatever the environment says.
pub fn drivers() -> Drivers {
    Drivers::new(Environment::default())
}

/// A folder for the files of a test below the temporary one; what is in it stays.
///
/// # Panics
/// Where it cannot be made.
pub fn folder(temporary: impl AsRef<Path>, name: &str) -> PathBuf {
    let folder = temporary.as_ref().join(name);
    fs::create_dir_all(&folder).expect("the target folder can be written");
    folder
}

/// Plays a metafile into an image, or a page each where the name says so, with an option for the surface; an error
/// where anything was wrong with it.
pub fn play(file: &Path, image: &Path, surface: &str) -> Result<Format, String> {
    let bytes = fs::File::open(file).map_err(|error| error.to_string())?;
    let opened = open_source(bytes, &ReadOptions::default()).map_err(|error| error.to_string())?;
    let (mut source, mut faults) = (opened.source, Vec::new());
    let connection = format!("{}?{surface}", image.display());
    let played = draw_gks(Box::new(drivers()), &connection, own::PNG, |gks, _| {
        while faults.len() < MOST_FAULTS {
            match source.next() {
                Ok(None) => break,
                Ok(Some(record)) => {
                    faults.extend(gks.interpret(&record).err().map(|error| error.to_string()));
                }
                Err(error) => faults.push(error.to_string()),
            }
        }
        Ok(())
    });
    faults.extend(played.err().map(|error| error.to_string()));
    if faults.is_empty() { Ok(opened.format) } else { Err(faults.join(", ")) }
}

/// The way of a picture through a metafile.
#[derive(Copy, Clone)]
pub struct Way<'a> {
    /// The workstation type of the metafile.
    pub kind: i32,
    /// Its options beside the surface, each after `&`.
    pub options: &'a str,
    /// The option for the surface, of the metafile and of both pictures.
    pub surface: &'a str,
    /// Where the files are.
    pub folder: &'a Path,
}

/// Draws a picture at once and by way of a metafile, and compares both images. Files stay only where they differ.
pub fn round_trip(
    picture: &Picture,
    way: Way<'_>,
    compare: impl FnOnce(&Path, &Path) -> Result<(), String>,
) -> Result<(), String> {
    let Way { kind, options, surface, folder } = way;
    let name = format!("{}-{kind}{}", picture.name, options.replace(['&', '='], "-"));
    let file = |end: &str| folder.join(format!("{name}.{end}"));
    let (direct, metafile, played) = (file("direct.png"), file("metafile"), file("played.png"));
    let _ = fs::remove_file(&played);
    picture.draw(Box::new(drivers()), &format!("{}?{surface}", direct.display()), own::PNG)?;
    picture.draw(Box::new(drivers()), &format!("{}?{surface}{options}", metafile.display()), kind)?;
    play(&metafile, &played, surface)
        .and_then(|_| compare(&direct, &played))
        .map_err(|fault| format!("{name}: {fault}"))?;
    for file in [direct, metafile, played] {
        let _ = fs::remove_file(file);
    }
    Ok(())
}
