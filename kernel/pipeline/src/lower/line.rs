//! Linewidths and linetypes.

use crate::device::Surface;
use crate::generated::numbers;

/// The largest linewidth, as a multiple of the nominal one.
pub const MAX_WIDTH: f64 = 200.0;

/// The least and the greatest linewidth on a surface, as multiples of the nominal one; other factors are
/// drawn as the nearer of the two.
pub fn range(surface: &Surface) -> (f64, f64) {
    let least = surface.resolution * 0.1 / surface.nominal_linewidth();
    (least.min(MAX_WIDTH), MAX_WIDTH)
}

/// The linewidth in device units for a linewidth scale factor, within the range of the workstation.
pub(crate) fn width(factor: f64, surface: &Surface) -> f64 {
    let (least, greatest) = range(surface);
    let factor = if factor.is_finite() { factor.clamp(least, greatest) } else { 1.0 };
    factor * surface.nominal_linewidth()
}

/// The lengths of dashes and gaps of a linetype in nominal linewidths; an unknown linetype is solid.
pub(crate) fn dashes(linetype: i32) -> &'static [f64] {
    numbers::LINETYPES.iter().find(|l| l.number == linetype).map_or(&[], |l| l.dashes)
}
