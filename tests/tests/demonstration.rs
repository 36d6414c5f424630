//! The demonstration that comes with XGKS, unmodified: it draws, shows menus, and waits for an operator, who does
//! here what `legacy/gksdemo.txt` says.

use gks_tests::program::{self, Linking, has_compiler, repository, run};
use gks_tests::reader::skip;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where Debian's package has the source.
const SOURCE: &str = "usr/share/doc/libxgks-dev/examples/gksdemo.f";

/// The source: installed, or else taken out of the package, which is downloaded once.
fn source() -> Option<PathBuf> {
    let folder = repository().join("target/legacy/xgks");
    let find =
        || [Path::new("/"), &folder].map(|root| root.join(SOURCE)).into_iter().find(|file| file.exists());
    if find().is_none() {
        std::fs::create_dir_all(&folder).ok()?;
        let unpack = "apt-get download -qq libxgks-dev && dpkg-deb -x libxgks-dev_*.deb .";
        Command::new("sh").args(["-c", unpack]).current_dir(&folder).output().ok()?;
    }
    find()
}

/// The red, green and blue of a pixel.
fn pixel(picture: &image::RgbaImage, x: u32, y: u32) -> [u8; 3] {
    let [red, green, blue, _] = picture.get_pixel(x, y).0;
    [red, green, blue]
}

const WHITE: [u8; 3] = [255, 255, 255];
const YELLOW: [u8; 3] = [255, 255, 0];
const GREEN: [u8; 3] = [0, 255, 0];

#[test]
fn the_demonstration_of_xgks_is_operated_by_a_script() {
    if !has_compiler("gfortran") {
        return;
    }
    let Some(source) = source() else {
        return skip("the demonstration of XGKS", "there is no package libxgks-dev");
    };
    let folder = program::folder(env!("CARGO_TARGET_TMPDIR"), "fortran", "gksdemo");
    let demonstration = folder.join("gksdemo");
    let mut compiler = Command::new("gfortran");
    compiler.args(["-std=legacy", "-w", "-fallow-argument-mismatch"]);
    compiler.arg("-I").arg(repository().join("bindings/fortran/include"));
    compiler.arg(source).arg("-o").arg(&demonstration);
    program::compile(&mut compiler, Linking::Shared);
    let script = repository().join("tests/legacy/gksdemo.txt");
    let environment =
        [("GKS_DIALECT", "xgks"), ("GKS_WSTYPE", "scripted"), ("GKS_SCRIPT", &script.to_string_lossy())];
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
    let menu = picture("menu.png");
    for box_of_choice in [360, 490, 620, 750, 880] {
        assert_eq!(pixel(&menu, 70, box_of_choice), YELLOW);
    }
    assert_eq!(pixel(&menu, 40, 500), WHITE);
    let markers = picture("markers.png");
    // The arms of a plus sign of five times the nominal size.
    for (x, y) in [(325, 680), (340, 680)] {
        assert_ne!(pixel(&markers, x, y), WHITE, "({x}, {y})");
    }
    let drawn = picture("drawn.png");
    assert_eq!(pixel(&drawn, 200, 800), GREEN);
    let near = |x: u32, y: u32| (x - 3..x + 3).any(|x| (y - 3..y + 3).any(|y| pixel(&drawn, x, y) != WHITE));
    // The markers, the polyline, and the text, each where the operator has put it.
    for (x, y) in [(250, 700), (600, 300), (300, 100), (200, 150), (508, 670)] {
        assert!(near(x, y), "({x}, {y})");
    }
    assert!(!near(900, 900));
    // The box RETURN is new; a deleted segment stays visible while regeneration is suppressed.
    let deleted = picture("deleted.png");
    let differs = |x: u32, y: u32| pixel(&drawn, x, y) != pixel(&deleted, x, y);
    assert!((0..200).any(|x| (0..100).any(|y| differs(x, y))));
    assert!((0..1000).all(|x| (100..1000).all(|y| !differs(x, y))));
}
