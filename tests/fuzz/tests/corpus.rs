//! What a fuzzer has found stays harmless.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// The inputs that are kept for a target.
fn inputs(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(target);
    let files = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    assert!(!paths.is_empty(), "no input for {target}");
    paths.sort();
    let read = |path: PathBuf| std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    paths.into_iter().map(read).collect()
}

#[test]
fn every_input_comes_back() {
    for (name, run) in gks_fuzz::TARGETS {
        inputs(name).iter().for_each(|input| gks_fuzz::attempt(*run, input));
    }
}

/// What is fed to the fuzzer reaches more than the checks of arguments.
#[test]
fn every_subroutine_succeeds_for_some_input() {
    let mut failing: BTreeSet<&str> = gks_fuzz::calls::subroutines().collect();
    assert_eq!(failing.len(), 218);
    for input in inputs("calls") {
        gks_fuzz::calls::run_and_tell(&input, |call| {
            if call.good {
                failing.remove(call.name);
            }
            ControlFlow::Continue(())
        });
    }
    assert!(failing.is_empty(), "{failing:?}");
}

/// Few bytes that stand for much: it is held once, or in less detail.
#[test]
fn what_stands_for_much_is_not_held() {
    let text = |body: String| format!("BEGMF ''; VDCTYPE real; BEGPIC ''; BEGPICBODY; {body} ENDPIC; ENDMF;");
    let saved: String = (0..256).map(|name| format!("SAVEPRIMCONT {name};")).collect();
    let curves = format!("POLYBEZIER 2 0 0 {};", "9e5 9e5 -9e5 9e5 0 0 ".repeat(500));
    for body in [
        format!("BEGFIGURE; {} ENDFIGURE;", "CIRCLE .5 .5 1e6;".repeat(500)),
        format!("LINETYPE 2; LINETYPEINITOFFSET .5; {curves}"),
        format!("INTSTYLE hatch; BEGFIGURE; {curves} ENDFIGURE;"),
        format!("PATTABLE 1 40 40 0 {}; {saved}", "1 ".repeat(1600)),
    ] {
        gks_fuzz::attempt(gks_fuzz::metafiles::cgm_text, text(body).as_bytes());
    }
    // CELL ARRAY, 32767 by 128 in as many runs as rows: eight times in a segment, which is copied.
    let mut cells = vec![0x41, 0x3f, 2, 0x14, 0, 0, 0, 0, 0x7f, 0xff, 0x7f, 0xff, 0x7f, 0xff, 0, 0];
    cells.extend([0x7f, 0xff, 0, 128, 0, 0, 0, 0]);
    cells.extend([0x7f, 0xff, 1, 0].repeat(128));
    let copied = [&[0x80, 0x38, 0, 1, 0, 1, 0, 0][..], &[0; 10], &[0, 1, 0, 0, 0, 0, 0, 0]].concat();
    let begin = [0, 0x21, 0, 0, 0, 0x61, 0, 0, 0, 0x80, 0, 0xc2, 0, 1];
    let metafile = [&begin[..], &cells.repeat(8), &[0, 0xe0], &copied, &[0, 0xa0, 0, 0x40]].concat();
    gks_fuzz::attempt(gks_fuzz::metafiles::cgm_binary, &metafile);
}
