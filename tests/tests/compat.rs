//! The libraries that stand in for those of other implementations of GKS have what their clients need.

use gks_cli::binary::{Binary, Kind};
use gks_tests::program::{built, repository};
use std::collections::BTreeSet;
use std::path::Path;

/// The symbols of a list, one a line.
fn listed(path: &str) -> BTreeSet<String> {
    let text = std::fs::read_to_string(repository().join(path)).expect("the list is there");
    text.lines().map(str::to_owned).collect()
}

fn missing<'a>(needed: &'a BTreeSet<String>, library: &'a Binary) -> Vec<&'a String> {
    needed.difference(&library.offered).collect()
}

#[test]
fn the_library_for_ncar_has_all_that_its_clients_need() {
    let ours = Binary::read(&built("gks-ncar", "libNGgks.so")).expect("the library can be read");
    assert_eq!(ours.kind, Kind::Library);
    let needed = listed("bindings/compat/ncar/symbols.txt");
    assert_eq!(needed.len(), 130);
    assert_eq!(missing(&needed, &ours), [""; 0]);
    // Where the original is installed, the list must be right, and the libraries of its package find what they
    // take from it.
    let folder = Path::new("/usr/lib/x86_64-linux-gnu");
    let Ok(original) = Binary::read(&folder.join("libNGgks.so.1")) else { return };
    assert_eq!(missing(&needed, &original), [""; 0]);
    for name in ["llu", "lluC", "mp", "cn", "misc", "misc2", "ff", "hlu"] {
        let file = folder.join(format!("libNG{name}.so.1"));
        let Ok(client) = Binary::read(&file) else { continue };
        let wanted = client.wanted.difference(&client.offered);
        let wanted = wanted.filter(|symbol| original.offered.contains(*symbol));
        // The COMMON block is in one of the other libraries as well.
        let wanted: BTreeSet<String> = wanted.filter(|symbol| *symbol != "secomi_").cloned().collect();
        assert_eq!(missing(&wanted, &ours), [""; 0], "{}", file.display());
    }
}
