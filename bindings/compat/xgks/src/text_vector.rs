//! The vectors of text in NDC, which programs that write metafiles ask XGKS for.

use crate::picture::Pair;
use gks_geometry::{Map, Ndc, Wc};

/// Gives the character height vector and the character width vector in NDC.
#[unsafe(no_mangle)]
extern "C" fn XgksComputeVec(height: *mut Pair, width: *mut Pair) {
    let found = gks_instance::with(|instance| {
        let gks = &instance.gks;
        let attributes = gks.inquire_current_primitive_attribute_values().ok()?;
        let number = gks.inquire_current_normalization_transformation_number().ok()?;
        let current = gks.inquire_normalization_transformation(number).ok()?;
        let map: Map<Wc, Ndc> = Map::window_to_viewport(&current.window, &current.viewport);
        let (up, base) = (attributes.character_up, attributes.character_base);
        let to_length = |v: gks_geometry::Vector<Wc>, length: f64| map.vector(v * (length / v.length()));
        Some((to_length(up, attributes.character_height), to_length(base, attributes.character_width)))
    });
    let Some((up, base)) = found else { return };
    for (address, vector) in [(height, up), (width, base)] {
        if !address.is_null() {
            // SAFETY: the contract of the crate.
            unsafe { address.write(Pair { x: vector.x() as f32, y: vector.y() as f32 }) }
        }
    }
}
