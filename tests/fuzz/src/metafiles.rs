//! Metafiles of any bytes, read to their end and drawn on a small display surface.

use gks::Gks;
use gks_metafile::cgm::{self, Encoding};
use gks_metafile::{ReadOptions, open_source};
use gks_pipeline::generated::numbers::workstation_type;
use gks_pipeline::record::Source;
use gks_workstations::catalogue::Drivers;
use gks_workstations::environment::Environment;
use std::io::Cursor;

/// The most records that are drawn of one input: later ones would only make runs longer.
const RECORDS: usize = 5_000;

/// A metafile of GKS, or whatever the bytes are taken for.
pub fn gksm(input: &[u8]) {
    if let Ok(mut opened) = open_source(Cursor::new(input.to_vec()), &ReadOptions::default()) {
        play(&mut *opened.source);
    }
}

/// A CGM in binary.
pub fn cgm_binary(input: &[u8]) {
    play(&mut *cgm::open(Cursor::new(input.to_vec()), Encoding::Binary));
}

/// A CGM in clear text.
pub fn cgm_text(input: &[u8]) {
    play(&mut *cgm::open(Cursor::new(input.to_vec()), Encoding::Text));
}

/// A CGM in characters.
pub fn cgm_character(input: &[u8]) {
    play(&mut *cgm::open(Cursor::new(input.to_vec()), Encoding::Character));
}

/// A CGM in records of NCAR.
pub fn ncgm(input: &[u8]) {
    play(&mut *cgm::open(Cursor::new(input.to_vec()), Encoding::Ncgm));
}

fn play(source: &mut dyn Source) {
    let environment = Environment { options: Some("size=64x64".to_owned()), ..Environment::default() };
    let mut gks = Gks::open(Box::new(Drivers::new(environment)));
    gks.open_workstation(1, "", workstation_type::FRAMEBUFFER).expect("a frame buffer");
    gks.activate_workstation(1).expect("the frame buffer is open");
    let mut faults = 0;
    for _ in 0..RECORDS {
        match source.next() {
            // What a record asks for may be an error of GKS.
            Ok(Some(record)) => drop(gks.interpret(&record)),
            Ok(None) => break,
            Err(_) if faults < 100 => faults += 1,
            Err(_) => break,
        }
    }
    gks.emergency_close_gks();
}
