//! What a fuzzer has found stays harmless.

use std::path::Path;

#[test]
fn every_input_comes_back() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus");
    for (name, run) in gks_fuzz::TARGETS {
        let folder = corpus.join(name);
        let files: Vec<_> =
            std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())).collect();
        assert!(!files.is_empty(), "no input for {name}");
        for file in files {
            let path = file.unwrap().path();
            let input = std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            run(&input);
        }
    }
}
