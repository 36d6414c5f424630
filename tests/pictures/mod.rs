//! Pictures that every device must show alike: each a few primitives and attributes in the unit square.

pub mod bundle;
pub mod cell_array;
pub mod fill_area;
pub mod font;
pub mod gdp;
pub mod opacity;
pub mod polyline;
pub mod polymarker;
pub mod segment;
pub mod text;
pub mod transformation;

use gks::Gks;
use gks_pipeline::description::Catalogue;
use phigs::Phigs;

/// A picture.
#[derive(Copy, Clone, Debug)]
pub struct Picture {
    /// Its name.
    pub name: &'static str,
    /// What draws it.
    pub content: Content,
}

/// What draws a picture on an active workstation.
#[derive(Copy, Clone, Debug)]
pub enum Content {
    /// Functions of GKS.
    Gks(fn(&mut Gks, i32) -> gks::Result<()>),
    /// Functions of PHIGS.
    Phigs(fn(&mut Phigs, i32) -> phigs::Result<()>),
}

impl Picture {
    /// The picture with a name.
    ///
    /// # Panics
    /// Where there is none.
    pub fn named(name: &str) -> &'static Picture {
        PICTURES.iter().find(|picture| picture.name == name).unwrap_or_else(|| panic!("no picture {name}"))
    }

    /// Draws the picture on a workstation of a type and closes it. An error is a message.
    pub fn draw(&self, catalogue: Box<dyn Catalogue>, connection: &str, kind: i32) -> Result<(), String> {
        match self.content {
            Content::Gks(picture) => {
                draw_gks(catalogue, connection, kind, picture).map_err(|e| e.to_string())
            }
            Content::Phigs(picture) => {
                let mut phigs = Phigs::open(catalogue);
                let drawn = phigs
                    .open_workstation(1, connection, kind)
                    .and_then(|()| picture(&mut phigs, 1))
                    .and_then(|()| phigs.close_workstation(1));
                drawn.map_err(|e| e.to_string())
            }
        }
    }
}

/// Draws on one workstation from OPEN WORKSTATION to CLOSE WORKSTATION.
pub fn draw_gks(
    catalogue: Box<dyn Catalogue>,
    connection: &str,
    kind: i32,
    picture: impl FnOnce(&mut Gks, i32) -> gks::Result<()>,
) -> gks::Result<()> {
    let mut gks = Gks::open(catalogue);
    gks.open_workstation(1, connection, kind)?;
    gks.activate_workstation(1)?;
    picture(&mut gks, 1)?;
    gks.deactivate_workstation(1)?;
    gks.close_workstation(1)?;
    gks.close_gks()
}

macro_rules! pictures {
    ($($module:ident: $($picture:ident),+;)+) => {
        &[
            $($(Picture {
                name: concat!(stringify!($module), "-", stringify!($picture)),
                content: Content::Gks($module::$picture),
            },)+)+
            Picture { name: "demo-gks", content: Content::Gks(gks_cli::demo::draw) },
            Picture { name: "demo-phigs", content: Content::Phigs(gks_cli::towers::draw) },
        ]
    };
}

/// All pictures.
pub static PICTURES: &[Picture] = pictures! {
    polyline: linetypes, widths, ends_and_corners, clipped, dashed_curves, degenerate;
    polymarker: types, sizes, clipped;
    fill_area: interiors, patterns, placed_patterns, hatches, crossing_edges, clipped;
    cell_array: colours, mirrored, partial, clipped, fine;
    text: precisions, paths, alignments, path_alignments, up_vectors, widths, stretched, clipped;
    font: strokes, outlines, scripts;
    gdp: circles, ellipses, curves, stretched, clipped, interiors;
    transformation: normalizations, window, viewport, unclipped;
    bundle: predefined, represented, colours;
    opacity: overlapping, lines_and_text;
    segment: transformed, clipped, priorities, highlighted, storage;
};
