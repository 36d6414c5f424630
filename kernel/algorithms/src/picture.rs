//! Pictures made of characters: what the tests of this crate expect of everything that plots pixels.

use crate::rect::IRect;
use crate::xorshift::Xorshift;
use glam::IVec2;
use std::collections::BTreeSet;

/// Anything that plots pixels inside a rectangle.
pub(crate) type Plotter<'a> = dyn Fn(IRect, &mut dyn FnMut(i32, i32)) + 'a;

/// The pixels plotted; each must lie in the rectangle and come once.
pub(crate) fn pixels(clip: IRect, plotter: &Plotter<'_>) -> BTreeSet<(i32, i32)> {
    let mut set = BTreeSet::new();
    plotter(clip, &mut |x, y| {
        assert!(clip.contains(x, y), "({x}, {y}) lies outside {clip:?}");
        assert!(set.insert((x, y)), "({x}, {y}) is plotted twice");
    });
    set
}

/// The rows of the rectangle, first row first, with `#` for a plotted pixel and `.` for another.
pub(crate) fn picture(clip: IRect, plotter: &Plotter<'_>) -> Vec<String> {
    let set = pixels(clip, plotter);
    let row =
        |y: i32| (clip.min.x..clip.max.x).map(|x| if set.contains(&(x, y)) { '#' } else { '.' }).collect();
    (clip.min.y..clip.max.y).map(row).collect()
}

/// Checks with rectangles at random that clipping leaves out pixels outside and changes nothing else.
pub(crate) fn check_clipping(random: &mut Xorshift, whole: IRect, plotter: &Plotter<'_>) {
    let all = pixels(whole, plotter);
    for _ in 0..8 {
        let min = random.grid(whole.min.x.min(whole.min.y), whole.max.x.max(whole.max.y));
        let clip = IRect::new(min, min + random.grid(0, 40));
        let expected: BTreeSet<_> = all.iter().copied().filter(|&(x, y)| clip.contains(x, y)).collect();
        assert_eq!(pixels(clip, plotter), expected, "{clip:?}");
    }
}

/// Whether one can walk from any pixel to any other, diagonal steps allowed.
pub(crate) fn is_connected(set: &BTreeSet<(i32, i32)>) -> bool {
    let mut left = set.clone();
    let mut found: Vec<(i32, i32)> = left.pop_first().into_iter().collect();
    while let Some((x, y)) = found.pop() {
        for step in 0..9 {
            let next = (x + step % 3 - 1, y + step / 3 - 1);
            if left.remove(&next) {
                found.push(next);
            }
        }
    }
    left.is_empty()
}

/// The square of pixels up to `reach` away from (0, 0).
pub(crate) fn around(reach: i32) -> IRect {
    IRect::new(IVec2::splat(-reach), IVec2::splat(reach + 1))
}
