//! Inquiries, by the state list or description table that they read.
//!
//! An inquiry changes nothing and raises no error handling: the number of the [`Error`] that it returns is the
//! error indicator of the standard. Such errors carry no details, so that asking costs no allocation.

mod description;
mod facilities;
mod gks_description;
mod pixels;
mod representation;
mod segment;
mod state_list;
mod text_extent;
mod workstation;

pub use description::{AttributeGroup, DisplaySpaceSize, MaximumTableLengths};
pub use facilities::{
    ColourFacilities, FillAreaFacilities, PolylineFacilities, PolymarkerFacilities, SizeRange, TextFacilities,
};
pub use gks_description::WorkstationMaximumNumbers;
pub use pixels::PixelArray;
pub use representation::ValueType;
pub use state_list::{IndividualAttributes, PrimitiveAttributes};
pub use text_extent::TextExtent;
pub use workstation::{DeferralAndUpdateStates, WorkstationTransformationState};

use crate::{Error, Function, Result};
use gks_pipeline::description::Category;

/// Writes inquiries of one value that fail only in the wrong state.
macro_rules! inquiries {
    ($($(#[$doc:meta])* $name:ident -> $type:ty, $function:ident => $value:expr;)+) => {
        impl Gks { $(
            $(#[$doc])*
            #[inline]
            pub fn $name(&self) -> Result<$type> {
                self.check_state(Function::$function)?;
                let value: fn(&Gks) -> $type = $value;
                Ok(value(self))
            }
        )+ }
    };
}
use inquiries;

/// Checks that a function serves workstations of a category, by the errors that the function lists.
///
/// Errors: 31 (MO), 33 (MI), 35 (INPUT), 36 (WISS), 39 (neither OUTPUT nor OUTIN).
fn serves(function: Function, category: Category) -> Result<()> {
    let own = match category {
        Category::Output | Category::OutIn => return Ok(()),
        Category::Input => 35,
        Category::Wiss => 36,
        Category::MetafileOutput => 31,
        Category::MetafileInput => 33,
    };
    match [own, 39].into_iter().find(|number| function.errors().contains(number)) {
        Some(number) => Err(Error::new(number, function)),
        None => Ok(()),
    }
}
