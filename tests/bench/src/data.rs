//! The data of the workloads as files, for programs in C.

use crate::Failure;
use gks_cli::bench::reference;
use gks_cli::bench::scene::{Data, Scene};
use gks_cli::bench::workload::{self, Workload};
use std::fs;
use std::path::Path;

/// The workloads with data of their own. `w1k` is W1 with a tenth of the points.
pub(crate) const FILES: [&str; 14] =
    ["w1", "w1k", "w1a", "w1s", "w2", "w3dot", "w3plus", "w3circ", "w4a", "w4b", "w6a", "w6b", "w7", "w8"];

/// The scene that a file holds.
pub(crate) fn scene(name: &str) -> Result<Box<dyn Scene>, Failure> {
    let find = |name: &str| -> Result<Workload, Failure> {
        let found = workload::all().into_iter().find(|w| w.name == name);
        Ok(found.ok_or_else(|| format!("no workload {name}"))?)
    };
    Ok(match name {
        "w1k" => (find("w1")?.scene)(100_000),
        _ => {
            let workload = find(name)?;
            (workload.scene)(workload.nominal_size())
        }
    })
}

/// Writes all data into a folder, but for what is there already.
pub(crate) fn write(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder)?;
    let put = |name: &str, bytes: &[u8]| -> Result<(), Failure> { Ok(fs::write(folder.join(name), bytes)?) };
    for name in FILES.into_iter().chain(["w5"]) {
        if folder.join(name).exists() {
            continue;
        }
        let scene = scene(name)?;
        if name == "w5" {
            let lines = reference::lines(|gks| scene.draw(gks))?;
            let sizes: Vec<u32> = lines.iter().map(|line| line.len() as u32).collect();
            put("w5strokes", &parts(&sizes, lines.into_iter().flatten()))?;
        }
        put(name, &bytes(&scene.data()))?;
    }
    Ok(())
}

fn bytes(data: &Data<'_>) -> Vec<u8> {
    match *data {
        Data::Parts(points, []) => parts(&[points.len() as u32], points.iter().copied()),
        Data::Parts(points, ends) => {
            let starts = std::iter::once(0).chain(ends.iter().copied());
            let sizes: Vec<u32> = starts.zip(ends).map(|(start, end)| (end - start) as u32).collect();
            parts(&sizes, points.iter().copied())
        }
        Data::Lines(lines) => parts(&vec![2; lines.len()], lines.as_flattened().iter().copied()),
        Data::Cells(indices, columns) => {
            let size = [columns as i32, (indices.len() / columns) as i32];
            size.iter().chain(indices).flat_map(|number| number.to_ne_bytes()).collect()
        }
        Data::Strings(strings) => {
            let lines: Vec<String> =
                strings.iter().map(|((x, y), text)| format!("{x} {y} {text}\n")).collect();
            lines.concat().into_bytes()
        }
    }
}

/// The number of parts, the number of points of each, and the points.
fn parts(sizes: &[u32], points: impl Iterator<Item = (f64, f64)>) -> Vec<u8> {
    let mut bytes = (sizes.len() as u32).to_ne_bytes().to_vec();
    bytes.extend(sizes.iter().flat_map(|size| size.to_ne_bytes()));
    bytes.extend(points.flat_map(|(x, y)| [x, y]).flat_map(f64::to_ne_bytes));
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_their_sizes_before_their_points() {
        let points = [(0.0, 1.0), (2.0, 3.0), (4.0, 5.0)];
        let bytes = bytes(&Data::Parts(&points, &[1, 3]));
        assert_eq!(bytes.len(), 4 + 2 * 4 + 6 * 8);
        assert_eq!(bytes[..12], [2u32, 1, 2].map(u32::to_ne_bytes).concat());
        assert_eq!(bytes[12 + 24..12 + 32], 3.0f64.to_ne_bytes());
    }

    #[test]
    fn every_file_has_a_scene() {
        for name in FILES {
            assert!(workload::all().iter().any(|w| w.name == name || name == "w1k"), "{name}");
        }
    }
}
