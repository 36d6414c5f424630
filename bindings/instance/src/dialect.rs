//! Dialects: what other GKS implementations do differently, chosen by `GKS_DIALECT`.

use gks::Defaults;
use gks_pipeline::look::InteriorStyle;

/// Whose initial values, workstation types and escapes hold.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// The standard and this library's own choices.
    #[default]
    Iso,
    /// NCAR Graphics.
    Ncar,
    /// XGKS.
    Xgks,
    /// The GR framework.
    Gr,
}

/// The outline fonts that NCAR's PostScript, PDF and window workstations show in the place of its stroke fonts,
/// where one has the same characters: sans for the simplex, serif for the complex and triplex families.
const NCAR_SUBSTITUTES: &[(i32, i32)] =
    &[(1, -21), (-2, -21), (-4, -21), (-7, -25), (-10, -27), (-12, -22), (-13, -26), (-14, -28)];

impl Dialect {
    /// The dialect with a name, in any case; none for an unknown name.
    pub fn from_name(name: &str) -> Option<Self> {
        match name.to_ascii_lowercase().as_str() {
            "" | "iso" => Some(Dialect::Iso),
            "ncar" => Some(Dialect::Ncar),
            "xgks" => Some(Dialect::Xgks),
            "gr" => Some(Dialect::Gr),
            _ => None,
        }
    }

    /// What the environment of the process says.
    pub fn from_process() -> Self {
        let name = std::env::var("GKS_DIALECT").unwrap_or_default();
        Dialect::from_name(&name).unwrap_or_else(|| {
            eprintln!("GKS_DIALECT={name} is unknown (iso, ncar, xgks, gr); iso is used");
            Dialect::Iso
        })
    }

    /// The initial values of the GKS state list.
    pub fn defaults(self) -> Defaults {
        let mut defaults = Defaults::default();
        if self == Dialect::Ncar {
            // NCAR's utilities save and restore the interior style and rely on this initial value.
            defaults.look.fill.interior = InteriorStyle::Solid;
            defaults.substitutes = NCAR_SUBSTITUTES;
            // NCAR's nominal marker size is a hundredth of the unit square, ours 6/1000.
            defaults.marker_scale = 10.0 / 6.0;
        }
        defaults
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_in_any_case() {
        assert_eq!(Dialect::from_name("NCAR"), Some(Dialect::Ncar));
        assert_eq!(Dialect::from_name(""), Some(Dialect::Iso));
        assert_eq!(Dialect::from_name("dec"), None);
    }

    #[test]
    fn ncar_starts_with_solid_areas() {
        assert_eq!(Dialect::Ncar.defaults().look.fill.interior, InteriorStyle::Solid);
        assert_eq!(Dialect::Iso.defaults().look.fill.interior, InteriorStyle::Hollow);
    }
}
