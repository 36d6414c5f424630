//! The coordinate spaces of GKS and PHIGS as marker types.

use std::fmt::Debug;

/// A coordinate space: a marker that never exists as a value of its own.
pub trait Space: Copy + Clone + Debug + Default + PartialEq + Send + Sync + 'static {
    /// The customary abbreviation, as used in the standards.
    const NAME: &'static str;
}

macro_rules! space {
    ($(#[$doc:meta])* $name:ident = $text:literal) => {
        $(#[$doc])*
        #[derive(Copy, Clone, Debug, Default, PartialEq)]
        pub struct $name;
        impl Space for $name {
            const NAME: &'static str = $text;
        }
    };
}

space! {
    /// Modelling coordinates: a PHIGS structure's own space.
    Mc = "MC"
}
space! {
    /// World coordinates: the application's space.
    Wc = "WC"
}
space! {
    /// View reference coordinates of a PHIGS view.
    Vrc = "VRC"
}
space! {
    /// Normalized device coordinates: the unit square is what workstation windows select from.
    Ndc = "NDC"
}
space! {
    /// Device coordinates of one workstation as an application sees them: metres (or the device's own
    /// unit), origin at the lower left corner of the display surface.
    Dc = "DC"
}
space! {
    /// Device units: the addressable units of a display surface (pixels, points, plotter steps), counted
    /// from the corner and in the direction in which the device counts them.
    Du = "DU"
}

/// Normalized projection coordinates of PHIGS, which meet GKS's NDC at the waist of the pipeline.
pub type Npc = Ndc;
