//! `gks info`: what is in a metafile.

use super::Failure;
use super::play::{Faults, open};
use gks_metafile::{Opened, ReadOptions, open_source};
use gks_pipeline::generated::numbers::FONTS;
use gks_pipeline::item::Shape;
use gks_pipeline::record::item::{Put, encode, kind};
use gks_pipeline::record::{Attribute, Record, SourceError};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::process::ExitCode;

/// What is in a metafile.
#[derive(Debug, Default, Serialize)]
struct Info {
    format: String,
    /// Pages with a primitive on them.
    pages: u64,
    primitives: u64,
    /// The points of polylines, polymarkers and fill areas.
    points: u64,
    /// Items by name. Elements of other formats are counted as the items that they are in GKS.
    items: BTreeMap<&'static str, u64>,
    /// Elements by name, in formats other than that of GKS.
    elements: BTreeMap<&'static str, u64>,
    /// The fonts that the metafile lists.
    font_list: Vec<String>,
    /// The numbers of the fonts that text is drawn in.
    fonts: BTreeMap<i32, &'static str>,
    segments: u64,
    /// The types of items of applications.
    user_items: BTreeSet<i32>,
    /// What is skipped: unknown, without sense, or without a picture.
    skipped: BTreeMap<String, u64>,
    /// Whether all could be read.
    complete: bool,
    #[serde(skip)]
    drawn: bool,
    #[serde(skip)]
    font: i32,
}

impl Info {
    fn add(&mut self, record: &Record<'_>) {
        encode(record, &mut Names(&mut self.items));
        match record {
            Record::Clear { .. } => self.page(),
            Record::Primitive(shape) => {
                self.drawn = true;
                self.primitives += 1;
                match shape {
                    Shape::Polyline(paths) | Shape::FillArea(paths) => {
                        self.points += paths.points.len() as u64;
                    }
                    Shape::Polymarker(positions) => self.points += positions.len() as u64,
                    Shape::Text(..) => {
                        let name =
                            FONTS.iter().find(|font| font.number == self.font).map_or("", |font| font.name);
                        self.fonts.insert(self.font, name);
                    }
                    _ => {}
                }
            }
            Record::Attribute(Attribute::TextFont(font, _)) => self.font = *font,
            Record::CreateSegment(_) => self.segments += 1,
            Record::User(kind, _) => {
                self.user_items.insert(*kind);
            }
            _ => {}
        }
    }

    fn page(&mut self) {
        self.pages += u64::from(self.drawn);
        self.drawn = false;
    }
}

/// Counts items by name.
struct Names<'a>(&'a mut BTreeMap<&'static str, u64>);

impl Put for Names<'_> {
    fn begin(&mut self, kind: i32) {
        *self.0.entry(kind::name(kind)).or_default() += 1;
    }
    fn integer(&mut self, _value: i32) {}
    fn real(&mut self, _value: f64) {}
    fn characters(&mut self, _bytes: &[u8]) {}
    fn end(&mut self) {}
}

/// Lists what is in a metafile.
pub fn run(file: &str, options: &ReadOptions, json: bool) -> Result<ExitCode, Failure> {
    let said = |error: &dyn std::fmt::Display| format!("{file}: {error}");
    let (bytes, mut progress) = open(file)?;
    let mut opened = open_source(bytes, options).map_err(|error| said(&error))?;
    let mut faults = Faults::default();
    let info = read(&mut opened, &mut faults, || progress.show()).map_err(|error| said(&error))?;
    progress.end();
    if json {
        println!("{}", serde_json::to_string_pretty(&info)?);
    } else {
        print(&info);
    }
    faults.report(file);
    Ok(if info.complete { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Reads a metafile to its end.
fn read(opened: &mut Opened, faults: &mut Faults, mut step: impl FnMut()) -> Result<Info, SourceError> {
    let mut info = Info { format: opened.format.to_string(), font: 1, ..Info::default() };
    loop {
        step();
        match opened.source.next() {
            Ok(Some(record)) => info.add(&record),
            Ok(None) => break,
            Err(error @ SourceError::Io(_)) => return Err(error),
            Err(error) => faults.add(error.to_string()),
        }
    }
    info.page();
    let contents = opened.source.contents();
    (info.elements, info.font_list) = (contents.elements, contents.fonts);
    info.skipped = opened.source.skipped().iter().map(|(name, count)| (name.to_owned(), count)).collect();
    info.complete = faults.is_empty();
    Ok(info)
}

fn print(info: &Info) {
    println!("format      {}", info.format);
    println!("pages       {}", info.pages);
    println!("primitives  {} with {} points", info.primitives, info.points);
    if info.segments > 0 {
        println!("segments    {}", info.segments);
    }
    for (number, name) in &info.fonts {
        println!("font        {number} {name}");
    }
    for (index, name) in (1..).zip(&info.font_list) {
        println!("font list   {index} {name}");
    }
    for kind in &info.user_items {
        println!("user items  of type {kind}");
    }
    // In its own terms, if it has some.
    for (name, count) in if info.elements.is_empty() { &info.items } else { &info.elements } {
        println!("{count:>10}  {name}");
    }
    for (name, count) in &info.skipped {
        println!("{count:>10}  skipped: {name}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn info(text: &'static str) -> Info {
        let mut opened = open_source(text.as_bytes(), &ReadOptions::default()).unwrap();
        read(&mut opened, &mut Faults::default(), || {}).unwrap()
    }

    #[test]
    fn a_cgm_is_listed_in_its_own_terms() {
        let info = info(
            "BEGMF 'a'; FONTLIST 'Times-Bold' 'Nowhere'; BEGPIC 'p'; BEGPICBODY; LINE (0,0) (1,1); TEXTFONTINDEX 1; \
             TEXT (0,0) final 'x'; LINE (0,0) (1,1); SYMBOLSIZE both 1 1; ENDPIC; BEGPIC 'q'; BEGPICBODY; \
             CIRCLE (0,0) 1; ENDPIC; ENDMF;",
        );
        assert_eq!((info.pages, info.primitives), (2, 4));
        assert_eq!(info.font_list, ["Times-Bold", "Nowhere"]);
        assert_eq!(info.fonts.keys().collect::<Vec<_>>(), [&-26]);
        let count = |name: &str| info.elements.get(name).copied().unwrap_or(0);
        assert_eq!(["POLYLINE", "TEXT", "BEGIN PICTURE", "SYMBOL SIZE"].map(count), [2, 1, 2, 1]);
        assert_eq!(info.skipped.keys().collect::<Vec<_>>(), ["SYMBOL SIZE"]);
        let json = serde_json::to_value(&info).unwrap();
        assert_eq!((&json["elements"]["CIRCLE"], &json["font_list"][1]), (&1.into(), &"Nowhere".into()));
    }
}
