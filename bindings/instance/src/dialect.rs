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
