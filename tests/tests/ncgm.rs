//! Metafiles that NCAR's own GKS has written, drawn by us and by NCAR's `ctrans`.

use gks_tests::drawing::play;
use gks_tests::likeness::{SIZE, likeness, open};
use gks_tests::program;
use gks_tests::reader;
use image::RgbImage;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Demonstrations of NCAR Graphics that state all their colours, with the number of their frames: where colours 0 and
/// 1 are not stated, `ctrans` draws white on black.
const PROGRAMS: [(&str, usize); 3] = [("thstgr", 3), ("tareas", 1), ("tlblba", 1)];
const SOURCES: &str = "/usr/share/ncarg/tests";
const LIBRARIES: &str = "-lNGlluC -lNGllu -lNGmisc2 -lNGmisc -lNGff -lNGmp -lNGcn -lNGmath -lNGgks -lNGc";

/// The frames of a Sun raster file: a header of eight numbers of 32 bits, 256 reds, greens and blues, and an octet for
/// each pixel, frame by frame.
fn frames(octets: &[u8]) -> Vec<RgbImage> {
    let (header, side) = (32, SIZE as usize);
    let frame = |octets: &[u8]| {
        let number =
            |place: usize| octets[place * 4..][..4].iter().fold(0, |n, octet| n << 8 | u32::from(*octet));
        let found = [0, 1, 2, 3, 6, 7].map(number);
        assert_eq!(found, [0x59a6_6a95, SIZE, SIZE, 8, 1, 768], "a header");
        let (colours, pixels) = octets[header..].split_at(768);
        RgbImage::from_fn(SIZE, SIZE, |x, y| {
            let index = usize::from(pixels[y as usize * side + x as usize]);
            image::Rgb([0, 256, 512].map(|component| colours[component + index]))
        })
    };
    octets.chunks_exact(header + 768 + side * side).map(frame).collect()
}

/// Compiles a program against NCAR's libraries and runs it, which leaves `gmeta` in the folder.
fn write_metafile(name: &str, folder: &Path) {
    let program = folder.join(name).display().to_string();
    let source = format!("{SOURCES}/{name}.f");
    let options = "-std=legacy -w -fallow-argument-mismatch";
    let arguments: Vec<&str> = options
        .split(' ')
        .chain(["-o", &program, &source, "-Wl,--no-as-needed"])
        .chain(LIBRARIES.split(' '))
        .collect();
    reader::run(120, "gfortran", &arguments).expect("it compiles");
    let ran = Command::new(&program).current_dir(folder).output().expect("it runs");
    assert!(ran.status.success(), "{name}: {ran:?}");
}

#[test]
fn metafiles_of_ncar_look_as_ncar_draws_them() {
    if !reader::present("NCAR's metafiles", &["gfortran", "ctrans"]) {
        return;
    }
    if !Path::new(SOURCES).is_dir() {
        reader::skip("NCAR's metafiles", "libncarg-data is not installed");
        return;
    }
    for (name, count) in PROGRAMS {
        let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "ncgm", name);
        write_metafile(name, &folder);
        let metafile = folder.join("gmeta").display().to_string();
        let size = format!("{SIZE}x{SIZE}");
        let raster = reader::run(60, "ctrans", &["-d", "sun", "-resolution", &size, &metafile]);
        let theirs = frames(&raster.expect("ctrans draws it").stdout);
        play(&folder.join("gmeta"), &folder.join("page.%d.png"), &format!("size={size}"))
            .expect("it is played");
        assert_eq!(theirs.len(), count, "{name}");
        assert_eq!(
            fs::read_dir(&folder).expect("a folder").flatten().filter(is_page).count(),
            count,
            "{name}"
        );
        for (theirs, number) in theirs.iter().zip(1..) {
            let ours = open(&folder.join(format!("page.{number}.png"))).expect("a page");
            let found = likeness(&ours, theirs);
            assert!(found.stray <= 0.03 && found.tone <= 15.0, "{name} {number}: {found:?}");
        }
        let _ = fs::remove_dir_all(&folder);
    }
}

fn is_page(entry: &fs::DirEntry) -> bool {
    entry.path().extension().is_some_and(|extension| extension == "png")
}
