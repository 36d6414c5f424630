//! J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 4(1), 1965.

use super::octant::Octant;
use crate::rect::IRect;
use glam::IVec2;

/// Gives the pixels of a segment inside the rectangle, from the first to the last, in whole numbers throughout.
///
/// A pixel halfway between two rows (or columns) goes to the greater one.
pub fn bresenham(from: IVec2, to: IVec2, clip: IRect, mut plot: impl FnMut(i32, i32)) {
    let Some(octant) = Octant::new(from, to, clip) else { return };
    let (up, down) = (2 * octant.rise, 2 * octant.run);
    let (mut minor, mut error) = octant.start();
    for step in octant.first..=octant.last {
        let (x, y) = octant.pixel(step, minor);
        plot(x, y);
        error += up;
        if error >= down {
            error -= down;
            minor += 1;
        }
    }
}
