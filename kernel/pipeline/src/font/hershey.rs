//! The Hershey repertoire: 1,597 line figures drawn by A. V. Hershey at the U.S. National Bureau of Standards
//! ("Calligraphy for Computers", NWL Report 1810, 1967), in James Hurt's text format.
//!
//! A record is a five column number, a three column count of coordinate pairs, then the pairs, two characters
//! each, every coordinate being the distance of its character code from that of `R`. The first pair holds the
//! left and the right edge of the body, the pair `" R"` lifts the pen. Records are broken after 72 columns.

use std::sync::OnceLock;

use glam::DVec2;

use super::sketch::Sketch;

static DATA: &[u8] = include_bytes!("../../data/hershey/hershey.jhf");

/// Height above the base line of capitals in the normal size, in Hershey units.
pub(crate) const CAP: f64 = 21.0;

/// Vertical design of one of the three sizes of the repertoire: Hershey's y of the base line (y down) and the
/// height of a capital.
struct Size {
    base: f64,
    cap: f64,
}

/// The size that a figure number belongs to.
fn size(number: u16) -> Size {
    match number {
        1..=235 => Size { base: 4.0, cap: 9.0 },
        1001..=1295 => Size { base: 6.0, cap: 13.0 },
        _ => Size { base: 9.0, cap: CAP },
    }
}

/// Offsets of all records in the data, sorted by figure number.
fn index() -> &'static [(u16, u32)] {
    static INDEX: OnceLock<Vec<(u16, u32)>> = OnceLock::new();
    INDEX.get_or_init(|| {
        let mut index = Vec::with_capacity(1600);
        let mut at = 0;
        while at + 8 <= DATA.len() {
            if DATA[at].is_ascii_control() {
                at += 1;
                continue;
            }
            let (Some(number), Some(pairs)) = (decimal(&DATA[at..at + 5]), decimal(&DATA[at + 5..at + 8]))
            else {
                break;
            };
            index.push((number, at as u32));
            at += 8;
            let mut rest = 2 * usize::from(pairs);
            while rest > 0 && at < DATA.len() {
                rest -= usize::from(!DATA[at].is_ascii_control());
                at += 1;
            }
        }
        index.sort_unstable();
        index
    })
}

fn decimal(field: &[u8]) -> Option<u16> {
    std::str::from_utf8(field).ok()?.trim().parse().ok()
}

/// The figure of a Hershey number as strokes in character heights, its origin at the left edge of the body on the
/// base line; none when the repertoire has no such number.
pub(crate) fn figure(number: u16) -> Option<Sketch> {
    let index = index();
    let record = index.binary_search_by_key(&number, |entry| entry.0).ok()?;
    let at = index[record].1 as usize;
    let pairs = usize::from(decimal(DATA.get(at + 5..at + 8)?)?);
    let mut codes = DATA[at + 8..].iter().copied().filter(|code| !code.is_ascii_control());
    let mut pair = || Some((codes.next()?, codes.next()?));
    let (left, right) = pair()?;
    let Size { base, cap } = size(number);
    let mut sketch = Sketch::new(f64::from(right.wrapping_sub(left)) / cap);
    for _ in 1..pairs {
        match pair()? {
            (b' ', b'R') => sketch.lift(),
            (x, y) => sketch.point(DVec2::new(
                (f64::from(x) - f64::from(left)) / cap,
                (base - (f64::from(y) - f64::from(b'R'))) / cap,
            )),
        }
    }
    sketch.lift();
    Some(sketch)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_record_is_indexed_and_complete() {
        let index = index();
        assert_eq!(index.len(), 1597);
        assert_eq!(index[0].0, 1);
        assert_eq!(index[index.len() - 1].0, 3926);
        for &(number, _) in index {
            assert!(figure(number).is_some(), "figure {number}");
        }
        assert!(figure(0).is_none() && figure(4000).is_none());
    }

    #[test]
    fn simplex_capital_a_has_three_strokes_and_the_height_of_a_capital() {
        let a = figure(501).unwrap();
        assert_eq!(a.advance(), 18.0 / 21.0);
        assert_eq!(a.ends(), [2, 4, 6]);
        let [low, high] = a.bounds();
        assert_eq!((low.y, high.y), (0.0, 1.0));
        assert_eq!((low.x, high.x), (1.0 / 21.0, 17.0 / 21.0));
    }
}
