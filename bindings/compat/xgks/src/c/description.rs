//! Inquiries of the workstation description table.

use super::argument::{Address, allocated, inquire, integer, list};
use super::control::kind;
use super::types::{
    Gchar, Gcofac, Gdefer, Gdspsize, Gflfac, Gfloat, Ggdpfac, Gint, Gintlist, Gipoint, Glnfac, Gmkfac,
    Gmodws, Gpoint, Gtxfac, Gtxfp, Gwstables,
};
use gks::Function;

/// Metres, the only unit of device coordinates.
const METRES: Gint = 0;
/// How many sizes there are in a continuous range.
const CONTINUOUS: Gint = 0;

/// Inquiries of one value that a workstation type alone decides.
macro_rules! inquiries {
    ($($name:ident($type:ty) $function:ident => |$gks:ident, $kind:ident| $value:expr;)+) => { $(
        #[doc = concat!("Inquires by `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(ws_type: Address<Gchar>, out: Address<$type>) -> Gint {
            inquire(Function::$function, |$gks| {
                let $kind = kind(ws_type);
                out.set($value);
                Ok(())
            })
        }
    )+ };
}

inquiries! {
    ginqwscategory(Gint) InquireWorkstationCategory => |gks, kind| gks.inquire_workstation_category(kind)? as Gint;
    ginqwsclass(Gint) InquireWorkstationClassification
        => |gks, kind| gks.inquire_workstation_classification(kind)? as Gint;
    ginqdisplayspacesize(Gdspsize) InquireDisplaySpaceSize => |gks, kind| {
        let size = gks.inquire_display_space_size(kind)?;
        Gdspsize {
            units: METRES,
            device: Gpoint { x: size.metres.0 as Gfloat, y: size.metres.1 as Gfloat },
            raster: Gipoint { x: integer(size.raster.0), y: integer(size.raster.1) },
        }
    };
    ginqmodwsattr(Gmodws) InquireDynamicModificationOfWorkstationAttributes => |gks, kind| {
        let dynamic = gks.inquire_dynamic_modification_of_workstation_attributes(kind)?;
        Gmodws {
            line: dynamic.line_bundles as Gint,
            mark: dynamic.marker_bundles as Gint,
            text: dynamic.text_bundles as Gint,
            fill: dynamic.fill_bundles as Gint,
            pat: dynamic.patterns as Gint,
            colour: dynamic.colours as Gint,
            wstran: dynamic.transformation as Gint,
        }
    };
    ginqdefdeferst(Gdefer) InquireDefaultDeferralStateValues => |gks, kind| {
        let (deferral, regeneration) = gks.inquire_default_deferral_state_values(kind)?;
        Gdefer { defmode: deferral as Gint, irgmode: regeneration as Gint }
    };
    ginqlinefacil(Glnfac) InquirePolylineFacilities => |gks, kind| {
        let found = gks.inquire_polyline_facilities(kind)?;
        Glnfac {
            types: list(found.linetypes.iter().map(|linetype| linetype.number)),
            widths: CONTINUOUS,
            nom: found.widths.nominal as Gfloat,
            min: found.widths.least as Gfloat,
            max: found.widths.greatest as Gfloat,
            predefined: integer(found.predefined),
        }
    };
    ginqmarkerfacil(Gmkfac) InquirePolymarkerFacilities => |gks, kind| {
        let found = gks.inquire_polymarker_facilities(kind)?;
        Gmkfac {
            types: list(found.markers.iter().map(|marker| marker.number)),
            sizes: CONTINUOUS,
            nom: found.sizes.nominal as Gfloat,
            min: found.sizes.least as Gfloat,
            max: found.sizes.greatest as Gfloat,
            predefined: integer(found.predefined),
        }
    };
    ginqtextfacil(Gtxfac) InquireTextFacilities => |gks, kind| {
        let found = gks.inquire_text_facilities(kind)?;
        let pairs: Vec<Gtxfp> = found.pairs().map(Gtxfp::from).collect();
        Gtxfac {
            fps: integer(pairs.len()),
            fp_list: allocated(&pairs),
            heights: CONTINUOUS,
            min_ht: found.heights.0 as Gfloat,
            max_ht: found.heights.1 as Gfloat,
            expansions: CONTINUOUS,
            min_ex: found.expansions.0 as Gfloat,
            max_ex: found.expansions.1 as Gfloat,
            predefined: integer(found.predefined),
        }
    };
    ginqfillfacil(Gflfac) InquireFillAreaFacilities => |gks, kind| {
        let found = gks.inquire_fill_area_facilities(kind)?;
        Gflfac {
            interiors: list(found.interior_styles.iter().map(|&style| style as Gint)),
            hatches: list(found.hatches.iter().map(|hatch| hatch.number)),
            predefined: integer(found.predefined),
        }
    };
    ginqpatfacil(Gint) InquirePatternFacilities => |gks, kind| integer(gks.inquire_pattern_facilities(kind)?);
    ginqcolourfacil(Gcofac) InquireColourFacilities => |gks, kind| {
        let found = gks.inquire_colour_facilities(kind)?;
        Gcofac {
            colours: integer(found.colours),
            coavail: (!found.coloured).into(),
            predefined: integer(found.predefined),
        }
    };
    ginqmaxwssttables(Gwstables) InquireMaximumLengthOfWorkstationStateTables => |gks, kind| {
        let lengths = gks.inquire_maximum_length_of_workstation_state_tables(kind)?;
        Gwstables {
            line: integer(lengths.polylines),
            mark: integer(lengths.polymarkers),
            text: integer(lengths.texts),
            fill: integer(lengths.fill_areas),
            pat: integer(lengths.patterns),
            colour: integer(lengths.colours),
        }
    };
}

/// INQUIRE LIST OF AVAILABLE GENERALIZED DRAWING PRIMITIVES, as identifiers. Functions to draw them, which XGKS
/// lists too, do not exist.
#[unsafe(no_mangle)]
extern "C" fn ginqavailgdp(ws_type: Address<Gchar>, gdps: Address<Ggdplist>) -> Gint {
    inquire(Function::InquireListOfAvailableGeneralizedDrawingPrimitives, |gks| {
        let found = gks.inquire_list_of_available_generalized_drawing_primitives(kind(ws_type))?;
        let Gintlist { number, integers } = list(found.iter().map(|gdp| gdp.number));
        gdps.set(Ggdplist { number, functions: std::ptr::null_mut(), indices: integers });
        Ok(())
    })
}

/// A list of generalized drawing primitives.
#[repr(C)]
#[derive(Copy, Clone, Debug)]
pub(crate) struct Ggdplist {
    number: Gint,
    functions: *mut std::ffi::c_void,
    indices: *mut Gint,
}

/// INQUIRE GENERALIZED DRAWING PRIMITIVE.
#[unsafe(no_mangle)]
extern "C" fn ginqgdp(ws_type: Address<Gchar>, gdp: Gint, facilities: Address<Ggdpfac>) -> Gint {
    inquire(Function::InquireGeneralizedDrawingPrimitive, |gks| {
        let groups = gks.inquire_generalized_drawing_primitive(kind(ws_type), gdp)?;
        let attrs: Vec<Gint> = groups.iter().map(|&group| group as Gint).collect();
        facilities.set(Ggdpfac { number: integer(attrs.len()), attrs: allocated(&attrs) });
        Ok(())
    })
}
