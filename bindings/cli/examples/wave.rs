//! A wave, in the format that the name of the file or `GKS_WSTYPE` says.

use gks::Gks;
use gks_pipeline::look::{Horizontal, Precision, Vertical};
use gks_workstations::catalogue::Drivers;

fn main() -> gks::Result<()> {
    let mut gks = Gks::open(Box::new(Drivers::from_process()));
    gks.open_workstation(1, "wave.svg", 0)?;
    gks.activate_workstation(1)?;
    gks.set_window(1, (0.0, 10.0, -1.2, 1.2))?;
    gks.set_viewport(1, (0.1, 0.9, 0.3, 0.7))?;
    gks.select_normalization_transformation(1)?;
    let wave: Vec<(f64, f64)> =
        (0..=500).map(|i| f64::from(i) / 50.0).map(|x| (x, (2.0 * x).sin())).collect();
    gks.set_polyline_colour_index(4)?;
    gks.polyline(&wave)?;
    gks.select_normalization_transformation(0)?;
    gks.set_text_font_and_precision(-21, Precision::Stroke)?;
    gks.set_character_height(0.03)?;
    gks.set_text_alignment(Horizontal::Centre, Vertical::Base)?;
    gks.text((0.5, 0.75), "A wave, in any format")?;
    gks.deactivate_workstation(1)?;
    gks.close_workstation(1)
}
