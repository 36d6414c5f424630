//! The demonstration that comes with XGKS, unmodified: it draws, shows menus, and waits for an operator, who goes
//! through all of them here, as `legacy/gksdemo.txt` says. It is made for a black background, and for compilers that keep all
//! variables in memory: it writes a data record beyond the end of one.

use gks_tests::program::{self, Linking, example, has_compiler, repository, run};
use gks_tests::reader::skip;
use std::process::Command;

/// The red, green and blue of a pixel.
fn pixel(picture: &image::RgbaImage, x: u32, y: u32) -> [u8; 3] {
    let [red, green, blue, _] = picture.get_pixel(x, y).0;
    [red, green, blue]
}

const BLACK: [u8; 3] = [0, 0, 0];
const RED: [u8; 3] = [255, 0, 0];
const BLUE: [u8; 3] = [0, 0, 255];
const ORANGE: [u8; 3] = [255, 85, 0];
const YELLOW: [u8; 3] = [255, 255, 0];
const GREEN: [u8; 3] = [0, 255, 0];

#[test]
fn the_demonstration_of_xgks_is_operated_by_a_script() {
    if !has_compiler("gfortran") {
        return;
    }
    let Some(source) = example("gksdemo.f") else {
        return skip("the demonstration of XGKS", "there is no package libxgks-dev");
    };
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "fortran", "gksdemo");
    let demonstration = folder.join("gksdemo");
    let mut compiler = Command::new("gfortran");
    compiler.args(["-std=legacy", "-w", "-fallow-argument-mismatch", "-fno-automatic"]);
    compiler.arg("-I").arg(repository().join("bindings/fortran/include"));
    compiler.arg(source).arg("-o").arg(&demonstration);
    program::compile(&mut compiler, Linking::Shared);
    let script = repository().join("tests/legacy/gksdemo.txt");
    let environment = [
        ("GKS_DIALECT", "xgks"),
        ("GKS_WSTYPE", "scripted"),
        ("GKS_OPTIONS", "background=black"),
        ("GKS_SCRIPT", &script.to_string_lossy()),
    ];
    // A demonstration that is out of step with its operator waits for ever.
    let limited = folder.join("limited");
    std::fs::write(&limited, "#!/bin/sh\nexec timeout 60 ./gksdemo\n").expect("a file can be written");
    let mut permissions = std::fs::metadata(&limited).expect("it is there").permissions();
    std::os::unix::fs::PermissionsExt::set_mode(&mut permissions, 0o755);
    std::fs::set_permissions(&limited, permissions).expect("it is ours");
    let output = run(&limited, &environment);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && !said.contains("GKS ERROR"), "{}:\n{said}", output.status);
    // One prompt to begin with, and one after the segment that was deleted; what missed made none.
    assert_eq!(said.matches("PICK SEGMENT TO DELETE OR RETURN").count(), 2, "{said}");

    let picture = |name: &str| image::open(folder.join(name)).expect("a picture").into_rgba8();
    let steps = std::fs::read_to_string(&script).expect("the script");
    let snapshots: Vec<_> = steps.lines().filter_map(|line| line.strip_prefix("snapshot ")).collect();
    assert_eq!(snapshots.len(), 38);
    // Every screen shows something, and something else than the one before.
    let mut before = None;
    for name in snapshots {
        let screen = picture(name);
        let drawn = screen.pixels().filter(|pixel| pixel.0[..3] != BLACK).count();
        assert!(drawn > 2000, "{name}: {drawn} pixels");
        assert!(before.replace(screen.clone()) != Some(screen), "{name} shows nothing new");
    }
    let menu = picture("menu.png");
    for box_of_choice in [360, 490, 620, 750, 880] {
        assert_eq!(pixel(&menu, 70, box_of_choice), YELLOW);
    }
    assert_eq!(pixel(&menu, 40, 500), BLACK);
    let markers = picture("markers.png");
    // The arms of a plus sign of five times the nominal size.
    for (x, y) in [(325, 680), (340, 680)] {
        assert_ne!(pixel(&markers, x, y), BLACK, "({x}, {y})");
    }
    // The colour that was mixed, and the intensities that were picked are gone.
    let mixed = picture("mixed.png");
    assert_eq!(pixel(&mixed, 910, 825), ORANGE);
    assert_eq!(pixel(&mixed, 560, 740), BLACK);
    assert_eq!(pixel(&picture("colours.png"), 560, 740), RED);
    // Cells stay what they are when colours change, and the screen keeps what it shows.
    assert_eq!(pixel(&picture("spectrum4.png"), 650, 530), pixel(&picture("spectrum1.png"), 650, 530));
    let drawn = picture("drawn.png");
    assert_eq!(pixel(&drawn, 200, 800), GREEN);
    assert_eq!(pixel(&drawn, 800, 850), BLUE);
    let near = |picture: &image::RgbaImage, x: u32, y: u32| {
        (x - 3..x + 3).any(|x| (y - 3..y + 3).any(|y| pixel(picture, x, y) != BLACK))
    };
    // The markers, the polyline, and the text, each where the operator has put it.
    for (x, y) in [(250, 700), (600, 300), (300, 100), (200, 150), (508, 670)] {
        assert!(near(&drawn, x, y), "({x}, {y})");
    }
    assert!(!near(&drawn, 950, 500));
    // The square has moved to where its centre was sent, and the segment that was picked is gone.
    let transformed = picture("transformed.png");
    assert_eq!(pixel(&transformed, 200, 800), BLACK);
    assert_eq!(pixel(&transformed, 560, 770), GREEN);
    let deleted = picture("deleted.png");
    assert!(near(&transformed, 250, 700) && near(&deleted, 600, 300));
    assert!(!near(&deleted, 250, 700));
}
