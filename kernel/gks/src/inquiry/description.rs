//! Inquiries of the workstation description table: what a type of workstation is.
//!
//! They read the description of a type as it is before a workstation of it is opened.

use super::serves;
use crate::{Error, Function, Gks, Result};
use gks_pipeline::description::{
    Category, Classification, DeferralMode, Description, DynamicModifications, RegenerationMode,
};
use gks_pipeline::generated::numbers::{self, Gdp, GdpAttributes};

/// The size of a display surface. Device coordinates are metres on every workstation.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct DisplaySpaceSize {
    /// Width and height in metres.
    pub metres: (f64, f64),
    /// Numbers of columns and rows of addressable positions.
    pub raster: (u32, u32),
}

/// How many entries the tables of a workstation can have.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct MaximumTableLengths {
    /// Polyline bundles.
    pub polylines: u32,
    /// Polymarker bundles.
    pub polymarkers: u32,
    /// Text bundles.
    pub texts: u32,
    /// Fill area bundles.
    pub fill_areas: u32,
    /// Patterns.
    pub patterns: u32,
    /// Colours.
    pub colours: u32,
}

/// A group of attributes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum AttributeGroup {
    /// Polyline attributes.
    Polyline = 0,
    /// Polymarker attributes.
    Polymarker = 1,
    /// Text attributes.
    Text = 2,
    /// Fill area attributes.
    FillArea = 3,
}

impl Gks {
    /// The description of a workstation type for an inquiry.
    ///
    /// Errors: 8, 22 (negative type), 23 (no such type), and those of the category.
    pub(super) fn described(&self, function: Function, kind: i32) -> Result<Description> {
        self.check_state(function)?;
        if kind < 0 {
            return Err(Error::new(22, function));
        }
        let description = self.catalogue.describe(kind).ok_or_else(|| Error::new(23, function))?;
        serves(function, description.category)?;
        Ok(description)
    }

    /// INQUIRE WORKSTATION CATEGORY. Errors: 8, 22, 23.
    pub fn inquire_workstation_category(&self, kind: i32) -> Result<Category> {
        Ok(self.described(Function::InquireWorkstationCategory, kind)?.category)
    }

    /// INQUIRE WORKSTATION CLASSIFICATION. Errors: 8, 22, 23, 39.
    pub fn inquire_workstation_classification(&self, kind: i32) -> Result<Classification> {
        Ok(self.described(Function::InquireWorkstationClassification, kind)?.classification)
    }

    /// INQUIRE DISPLAY SPACE SIZE. Errors: 8, 22, 23, 31 (MO), 33 (MI), 36 (WISS).
    pub fn inquire_display_space_size(&self, kind: i32) -> Result<DisplaySpaceSize> {
        let description = self.described(Function::InquireDisplaySpaceSize, kind)?;
        Ok(DisplaySpaceSize { metres: description.size(), raster: description.raster })
    }

    /// INQUIRE DYNAMIC MODIFICATION OF WORKSTATION ATTRIBUTES. Errors: 8, 22, 23, 39.
    pub fn inquire_dynamic_modification_of_workstation_attributes(
        &self,
        kind: i32,
    ) -> Result<DynamicModifications> {
        Ok(self.described(Function::InquireDynamicModificationOfWorkstationAttributes, kind)?.dynamic)
    }

    /// INQUIRE DEFAULT DEFERRAL STATE VALUES. Errors: 8, 22, 23, 39.
    pub fn inquire_default_deferral_state_values(
        &self,
        kind: i32,
    ) -> Result<(DeferralMode, RegenerationMode)> {
        let description = self.described(Function::InquireDefaultDeferralStateValues, kind)?;
        Ok((description.deferral, description.regeneration))
    }

    /// INQUIRE LIST OF AVAILABLE GENERALIZED DRAWING PRIMITIVES. Errors: 8, 22, 23, 39.
    pub fn inquire_list_of_available_generalized_drawing_primitives(
        &self,
        kind: i32,
    ) -> Result<&'static [Gdp]> {
        self.described(Function::InquireListOfAvailableGeneralizedDrawingPrimitives, kind)?;
        Ok(numbers::GDPS)
    }

    /// INQUIRE GENERALIZED DRAWING PRIMITIVE: the groups of attributes that a generalized drawing primitive
    /// takes.
    ///
    /// Errors: 8, 22, 23, 39, 41 (the type has no such primitive), 102 (identifier 0).
    pub fn inquire_generalized_drawing_primitive(
        &self,
        kind: i32,
        identifier: i32,
    ) -> Result<&'static [AttributeGroup]> {
        const F: Function = Function::InquireGeneralizedDrawingPrimitive;
        self.described(F, kind)?;
        match numbers::GDPS.iter().find(|gdp| gdp.number == identifier) {
            Some(gdp) => Ok(match gdp.attributes {
                GdpAttributes::Polyline => &[AttributeGroup::Polyline],
                GdpAttributes::FillArea => &[AttributeGroup::FillArea],
            }),
            None if identifier == 0 => Err(Error::new(102, F)),
            None => Err(Error::new(41, F)),
        }
    }

    /// INQUIRE MAXIMUM LENGTH OF WORKSTATION STATE TABLES. Errors: 8, 22, 23, 39.
    pub fn inquire_maximum_length_of_workstation_state_tables(
        &self,
        kind: i32,
    ) -> Result<MaximumTableLengths> {
        let description = self.described(Function::InquireMaximumLengthOfWorkstationStateTables, kind)?;
        Ok(MaximumTableLengths {
            polylines: numbers::MAX_POLYLINE_BUNDLES,
            polymarkers: numbers::MAX_POLYMARKER_BUNDLES,
            texts: numbers::MAX_TEXT_BUNDLES,
            fill_areas: numbers::MAX_FILL_AREA_BUNDLES,
            patterns: numbers::MAX_PATTERNS,
            colours: description.colour_table_length(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{CATEGORIES, INDEXED, PLAIN, closed, number, open};
    use gks_pipeline::description::DynamicModification;

    type Inquiry = fn(&Gks, i32) -> Result<()>;

    /// All functions of this file that want an OUTPUT or OUTIN type.
    const OUTPUT: [Inquiry; 17] = [
        |gks, kind| gks.inquire_workstation_classification(kind).map(drop),
        |gks, kind| gks.inquire_dynamic_modification_of_workstation_attributes(kind).map(drop),
        |gks, kind| gks.inquire_default_deferral_state_values(kind).map(drop),
        |gks, kind| gks.inquire_polyline_facilities(kind).map(drop),
        |gks, kind| gks.inquire_predefined_polyline_representation(kind, 1).map(drop),
        |gks, kind| gks.inquire_polymarker_facilities(kind).map(drop),
        |gks, kind| gks.inquire_predefined_polymarker_representation(kind, 1).map(drop),
        |gks, kind| gks.inquire_text_facilities(kind).map(drop),
        |gks, kind| gks.inquire_predefined_text_representation(kind, 1).map(drop),
        |gks, kind| gks.inquire_fill_area_facilities(kind).map(drop),
        |gks, kind| gks.inquire_predefined_fill_area_representation(kind, 1).map(drop),
        |gks, kind| gks.inquire_pattern_facilities(kind).map(drop),
        |gks, kind| gks.inquire_predefined_pattern_representation(kind, 1).map(drop),
        |gks, kind| gks.inquire_colour_facilities(kind).map(drop),
        |gks, kind| gks.inquire_predefined_colour_representation(kind, 1).map(drop),
        |gks, kind| gks.inquire_generalized_drawing_primitive(kind, -4).map(drop),
        |gks, kind| gks.inquire_maximum_length_of_workstation_state_tables(kind).map(drop),
    ];

    #[test]
    fn states_types_and_categories_are_checked_in_this_order() {
        let others: [Inquiry; 3] = [
            |gks, kind| gks.inquire_workstation_category(kind).map(drop),
            |gks, kind| gks.inquire_display_space_size(kind).map(drop),
            |gks, kind| gks.inquire_list_of_available_generalized_drawing_primitives(kind).map(drop),
        ];
        let (gks, _) = open(&[]);
        for inquiry in OUTPUT.iter().chain(&others) {
            assert_eq!(number(inquiry(&closed(), -1)), 8);
            assert_eq!(number(inquiry(&gks, -1)), 22);
            assert_eq!(number(inquiry(&gks, 12_345)), 23);
            assert_eq!(inquiry(&gks, PLAIN), Ok(()));
            assert_eq!(inquiry(&gks, CATEGORIES + Category::OutIn as i32), Ok(()));
        }
        use Category::{Input, MetafileInput, MetafileOutput, Wiss};
        for category in [Input, MetafileInput, MetafileOutput, Wiss] {
            let kind = CATEGORIES + category as i32;
            assert_eq!(OUTPUT.map(|inquiry| number(inquiry(&gks, kind))), [39; 17]);
            assert_eq!(number(others[2](&gks, kind)), 39);
            assert_eq!(gks.inquire_workstation_category(kind), Ok(category));
        }
        assert_eq!(others[1](&gks, CATEGORIES + Input as i32), Ok(()));
        for (category, error) in [(MetafileOutput, 31), (MetafileInput, 33), (Wiss, 36)] {
            assert_eq!(number(others[1](&gks, CATEGORIES + category as i32)), error);
        }
    }

    #[test]
    fn the_description_is_that_of_the_catalogue() {
        let (gks, _) = open(&[]);
        assert_eq!(gks.inquire_workstation_category(PLAIN), Ok(Category::Output));
        assert_eq!(gks.inquire_workstation_classification(PLAIN), Ok(Classification::Vector));
        assert_eq!(gks.inquire_workstation_classification(INDEXED), Ok(Classification::Raster));
        let size = gks.inquire_display_space_size(INDEXED).unwrap();
        assert!((size.metres.0 - 0.2).abs() < 1e-12 && (size.metres.1 - 0.1).abs() < 1e-12);
        assert_eq!(size.raster, (1000, 500));
        let deferral = gks.inquire_default_deferral_state_values(PLAIN);
        assert_eq!(deferral, Ok((DeferralMode::Asti, RegenerationMode::Suppressed)));
        let dynamic = gks.inquire_dynamic_modification_of_workstation_attributes(PLAIN).unwrap();
        assert_eq!(dynamic.transformation, DynamicModification::Irg);
        assert_eq!(dynamic.colours, DynamicModification::Imm);
    }

    #[test]
    fn generalized_drawing_primitives_tell_their_attributes() {
        let (gks, _) = open(&[]);
        let list = gks.inquire_list_of_available_generalized_drawing_primitives(PLAIN).unwrap();
        assert!(list.iter().any(|gdp| gdp.number == numbers::gdp::CIRCLE));
        for gdp in list {
            assert!(gks.inquire_generalized_drawing_primitive(PLAIN, gdp.number).is_ok());
        }
        let groups = |identifier| gks.inquire_generalized_drawing_primitive(PLAIN, identifier);
        assert_eq!(groups(numbers::gdp::CIRCULAR_ARC), Ok(&[AttributeGroup::Polyline][..]));
        assert_eq!(groups(numbers::gdp::CIRCLE), Ok(&[AttributeGroup::FillArea][..]));
        assert_eq!([0, 1, -999].map(|identifier| number(groups(identifier))), [102, 41, 41]);
    }

    #[test]
    fn table_lengths_bound_what_can_be_set() {
        let (mut gks, _) = open(&[PLAIN, INDEXED]);
        for (id, kind) in [(1, PLAIN), (2, INDEXED)] {
            let most = gks.inquire_maximum_length_of_workstation_state_tables(kind).unwrap();
            let line =
                |gks: &mut Gks, index: u32| gks.set_polyline_representation(id, index as i32, 1, 1.0, 1);
            assert!(line(&mut gks, most.polylines).is_ok());
            assert_eq!(number(line(&mut gks, most.polylines + 1)), 60);
            let colour =
                |gks: &mut Gks, index: u32| gks.set_colour_representation(id, index as i32, (1.0, 0.0, 0.0));
            assert!(colour(&mut gks, most.colours - 1).is_ok());
            assert_eq!(number(colour(&mut gks, most.colours)), 93);
        }
    }
}
