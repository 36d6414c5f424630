//! Linewidths and linetypes.

use crate::device::Surface;
use crate::generated::numbers;

/// The largest linewidth, as a multiple of the nominal one.
pub const MAX_WIDTH: f64 = 200.0;

/// The linewidth in device units for a linewidth scale factor, within the range of the workstation.
pub(crate) fn width(factor: f64, surface: &Surface) -> f64 {
    let factor = if factor.is_finite() { factor.clamp(0.0, MAX_WIDTH) } else { 1.0 };
    (factor * surface.nominal_linewidth()).max(surface.resolution * 0.1)
}

/// The lengths of dashes and gaps of a linetype in nominal linewidths; an unknown linetype is solid.
pub(crate) fn dashes(linetype: i32) -> &'static [f64] {
    numbers::LINETYPES.iter().find(|l| l.number == linetype).map_or(&[], |l| l.dashes)
}
