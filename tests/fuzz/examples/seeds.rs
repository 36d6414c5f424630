//! Writes a small picture as a metafile of every format into the corpus: what a fuzzer starts from.

use gks::{Gks, Visibility};
use gks_geometry::Point;
use gks_pipeline::item::Cells;
use gks_pipeline::look::{InteriorStyle, Precision};
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use std::path::Path;

/// Targets, connections and workstation types.
const SEEDS: [(&str, &str, i32); 6] = [
    ("gksm", "formatted.gksm?coding=formatted", 2),
    ("gksm", "binary.gksm?coding=binary", 2),
    ("cgm_binary", "seed.cgm", 400),
    ("cgm_text", "seed.cgmt", 401),
    ("cgm_character", "seed.cgmc", 402),
    ("ncgm", "seed.ncgm", 403),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus");
    for (target, name, kind) in SEEDS {
        let folder = corpus.join(target);
        std::fs::create_dir_all(&folder)?;
        let mut gks = Gks::open(Box::new(Drivers::new(Environment::default())));
        gks.open_workstation(1, &folder.join(name).to_string_lossy(), kind)?;
        gks.activate_workstation(1)?;
        draw(&mut gks)?;
        gks.deactivate_workstation(1)?;
        gks.close_workstation(1)?;
        gks.close_gks()?;
    }
    Ok(())
}

/// Something of everything, on two pages.
fn draw(gks: &mut Gks) -> gks::Result<()> {
    let points = [(0.1, 0.1), (0.9, 0.2), (0.5, 0.8), (0.2, 0.7)];
    gks.set_linetype(3)?;
    gks.polyline(&points)?;
    gks.set_marker_type(4)?;
    gks.polymarker(&points)?;
    gks.set_character_height(0.05)?;
    gks.set_text_font_and_precision(-3, Precision::Stroke)?;
    gks.text(Point::new(0.2, 0.4), "seed")?;
    for (style, index) in [(InteriorStyle::Solid, 1), (InteriorStyle::Hatch, -3), (InteriorStyle::Pattern, 1)]
    {
        gks.set_fill_area_interior_style(style)?;
        gks.set_fill_area_style_index(index)?;
        gks.fill_area(&points[..3])?;
    }
    gks.clear_workstation(1, true)?;
    let indices = [0, 1, 2, 3, 4, 5];
    if let Some(cells) = Cells::new(&indices, 3, 2, 3) {
        gks.cell_array(Point::new(0.1, 0.1), Point::new(0.6, 0.5), &cells)?;
    }
    gks.create_segment(7)?;
    gks.polyline(&points)?;
    gks.close_segment()?;
    gks.set_visibility(7, Visibility::Invisible)?;
    Ok(())
}
