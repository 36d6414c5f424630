//! The slant of text: characters that lean, drawn with text vectors that are not at right angles.

use crate::extension;
use gks::Gks;
use gks_geometry::{Map, Ndc, Vector, Wc};
use gks_pipeline::record::{Attribute, Record};

/// Runs `f` with text vectors that lean by the current slant. As in GR, characters become narrower and lower by its cosine.
pub(crate) fn slanted<R>(gks: &mut Gks, f: impl FnOnce(&mut Gks) -> gks::Result<R>) -> gks::Result<R> {
    let slant = extension::with(|state| state.slant);
    if slant == 0.0 || !slant.is_finite() {
        return f(gks);
    }
    let (sine, cosine) = slant.to_radians().sin_cos();
    let (height, up) = (gks.inquire_character_height()?, gks.inquire_character_up_vector()?);
    let expansion = gks.inquire_character_expansion_factor()?;
    let number = gks.inquire_current_normalization_transformation_number()?;
    let current = gks.inquire_normalization_transformation(number)?;
    let map: Map<Wc, Ndc> = Map::window_to_viewport(&current.window, &current.viewport);
    let unit = up.0.normalize() * height;
    let (across, along) = (map.vector(Vector::from_vec(unit)), map.vector(Vector::from_vec(-unit.perp())));
    let leaning = Vector::from_vec(across.0 * cosine + along.0 * (sine * expansion));
    let base = Vector::from_vec(along.0 * cosine);
    gks.interpret(&Record::Attribute(Attribute::CharacterVectors(leaning, base)))?;
    let done = f(gks);
    gks.set_character_height(height)?;
    gks.set_character_up_vector(up)?;
    done
}
