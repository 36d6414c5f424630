//! Dialects: the initial values that other GKS implementations choose differently.

use crate::gr_colours::GR_COLOURS;
use gks::Defaults;
use gks_pipeline::look::{Cap, InteriorStyle, Join};
use gks_workstations::catalogue::Drivers;
use gks_workstations::dialect::Dialect;
use gks_workstations::environment::Environment;
use std::sync::OnceLock;

/// The dialect of the library that the process has loaded, where that is one for programs of another GKS.
static PRESET: OnceLock<Dialect> = OnceLock::new();

/// Sets the dialect that the process has unless `GKS_DIALECT` names another one. A library that stands in for
/// another GKS calls this when it is loaded, before the first call of any function; the first one wins.
pub fn preset_dialect(dialect: Dialect) {
    let _ = PRESET.set(dialect);
}

/// The workstation types as the environment of the process and the library loaded choose them.
pub(crate) fn drivers() -> Drivers {
    let mut environment = Environment::from_process();
    if let Some(dialect) = PRESET.get() {
        environment.dialect.get_or_insert_with(|| dialect.name().to_owned());
    }
    Drivers::new(environment)
}

/// The outline fonts that NCAR's PostScript, PDF and window workstations show in the place of its stroke fonts,
/// where one has the same characters: sans for the simplex, serif for the complex and triplex families.
const NCAR_SUBSTITUTES: &[(i32, i32)] =
    &[(1, -21), (-2, -21), (-4, -21), (-7, -25), (-10, -27), (-12, -22), (-13, -26), (-14, -28)];

/// The initial values of the GKS state list in a dialect.
pub(crate) fn defaults(dialect: Dialect) -> Defaults {
    let mut defaults = Defaults::default();
    if dialect == Dialect::Ncar {
        // NCAR's utilities save and restore the interior style and rely on this initial value.
        defaults.look.fill.interior = InteriorStyle::Solid;
        // Its drivers draw dots and short pieces of lines with round ends.
        defaults.look.cap = Cap::Round;
        defaults.look.join = Join::Round;
        defaults.tables.substitutes = NCAR_SUBSTITUTES;
        // NCAR's nominal marker size is a hundredth of the unit square, ours 6/1000.
        defaults.tables.nominal.marker_size = 10.0 / 6.0;
        // It has no patterns: areas that should have one are hollow.
        defaults.tables.patterns.clear();
        // Movies of the utilities start with segment 0.
        defaults.first_segment = 0;
        // Its programs draw on metafiles and place texts side by side.
        defaults.text_extent_of_metafiles = true;
    }
    // Programs of XGKS call UPDATE WORKSTATION nowhere and see their segments changed all the same.
    defaults.updates_before_input = dialect == Dialect::Xgks;
    if dialect == Dialect::Gr {
        defaults.colours = &GR_COLOURS;
    }
    defaults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gr_starts_with_many_colours() {
        let colours = defaults(Dialect::Gr).colours;
        assert_eq!((colours.len(), colours[2], colours[980]), (1000, 0xff_0000, 0xff_b300));
        assert!(defaults(Dialect::Iso).colours.is_empty());
    }

    #[test]
    fn ncar_starts_with_solid_areas() {
        assert_eq!(defaults(Dialect::Ncar).look.fill.interior, InteriorStyle::Solid);
        assert_eq!(defaults(Dialect::Iso).look.fill.interior, InteriorStyle::Hollow);
    }

    #[test]
    fn metafiles_of_ncar_have_text_extents_and_its_movies_a_segment_0() {
        use gks::Gks;
        let gks = |dialect| {
            let mut gks =
                Gks::with_defaults(Box::new(Drivers::new(Environment::default())), defaults(dialect));
            gks.open_gks().unwrap();
            gks.open_workstation(1, "/dev/null", 400).unwrap();
            gks.open_workstation(2, "", 1).unwrap();
            gks.activate_workstation(2).unwrap();
            gks
        };
        let (mut ncar, mut iso) = (gks(Dialect::Ncar), gks(Dialect::Iso));
        let extent = |gks: &Gks| gks.inquire_text_extent(1, (0.5, 0.5), "text").map_err(|error| error.number);
        assert!(extent(&ncar).is_ok_and(|extent| extent.concatenation.0.x > 0.5));
        assert_eq!(extent(&iso).map(drop), Err(39));
        let segment = |gks: &mut Gks| gks.create_segment(0).map_err(|error| error.number);
        assert_eq!([segment(&mut ncar), segment(&mut iso)], [Ok(()), Err(120)]);
    }
}
