//! Inquiries of the operating state, the GKS state list and the state lists of workstations.

use super::argument::{Address, allocated, allocated_text, inquire, integer, list};
use super::control::kind_name;
use super::types::{
    Gchar, Gcliprec, Gextent, Gfloat, Gindattr, Gint, Gintlist, Gipoint, Gpoint, Gpriattr, Gpxarray, Grect,
    Gstrlist, Gwsct, Gwsdus, Gwsmax, Gwsti, Gwstran,
};
use gks::Function;
use gks_pipeline::workstation::WorkstationTransformation;

/// INQUIRE OPERATING STATE VALUE.
#[unsafe(no_mangle)]
extern "C" fn ginqopst(state: Address<Gint>) -> Gint {
    state.set(gks_instance::with(|instance| instance.gks.inquire_operating_state_value()) as Gint);
    0
}

/// Inquiries of one value that needs no argument.
macro_rules! inquiries {
    ($($name:ident($type:ty) $function:ident => |$gks:ident| $value:expr;)+) => { $(
        #[doc = concat!("Inquires by `", stringify!($function), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(out: Address<$type>) -> Gint {
            inquire(Function::$function, |$gks| {
                out.set($value);
                Ok(())
            })
        }
    )+ };
}

inquiries! {
    ginqlevelgks(Gint) InquireLevelOfGks => |gks| gks.inquire_level_of_gks()? as Gint;
    ginqwsmaxnum(Gwsmax) InquireWorkstationMaximumNumbers => |gks| {
        let numbers = gks.inquire_workstation_maximum_numbers()?;
        Gwsmax {
            open: integer(numbers.open),
            active: integer(numbers.active),
            assoc: integer(numbers.of_a_segment),
        }
    };
    ginqmaxntrannum(Gint) InquireMaximumNormalizationTransformationNumber
        => |gks| gks.inquire_maximum_normalization_transformation_number()?;
    ginqopenws(Gintlist) InquireSetOfOpenWorkstations => |gks| list(gks.inquire_set_of_open_workstations()?);
    ginqactivews(Gintlist) InquireSetOfActiveWorkstations
        => |gks| list(gks.inquire_set_of_active_workstations()?);
    ginqcurntrannum(Gint) InquireCurrentNormalizationTransformationNumber
        => |gks| gks.inquire_current_normalization_transformation_number()?;
    ginqntrannum(Gintlist) InquireListOfNormalizationTransformationNumbers
        => |gks| list(gks.inquire_list_of_normalization_transformation_numbers()?.iter().copied());
    ginqclip(Gcliprec) InquireClipping => |gks| {
        let (clip, rectangle) = gks.inquire_clipping()?;
        Gcliprec { ind: (!clip).into(), rec: rectangle.into() }
    };
    ginqprimattr(Gpriattr) InquireCurrentPrimitiveAttributeValues => |gks| {
        let attributes = gks.inquire_current_primitive_attribute_values()?;
        Gpriattr {
            plnindex: attributes.polyline_index,
            pmkindex: attributes.polymarker_index,
            txindex: attributes.text_index,
            height: attributes.character_height as Gfloat,
            up: attributes.character_up.into(),
            chwidth: attributes.character_width as Gfloat,
            base: attributes.character_base.into(),
            path: attributes.text_path as Gint,
            align: attributes.text_alignment.into(),
            flindex: attributes.fill_area_index,
            widthvec: attributes.pattern_width.into(),
            heightvec: attributes.pattern_height.into(),
            prp: attributes.pattern_reference.into(),
        }
    };
    ginqindivattr(Gindattr) InquireCurrentIndividualAttributeValues => |gks| {
        let attributes = gks.inquire_current_individual_attribute_values()?;
        let (line, marker) = (attributes.polyline, attributes.polymarker);
        let (text, fill) = (attributes.text, attributes.fill_area);
        Gindattr {
            lntype: line.linetype,
            lnwidth: line.width as Gfloat,
            lncolour: line.colour as Gint,
            mktype: marker.kind,
            mksize: marker.size as Gfloat,
            mkcolour: marker.colour as Gint,
            fp: (text.font, text.precision).into(),
            chexp: text.expansion as Gfloat,
            chspace: text.spacing as Gfloat,
            txcolour: text.colour as Gint,
            flstyle: fill.interior as Gint,
            flindex: fill.style,
            flcolour: fill.colour as Gint,
            asflist: attributes.sources.to_array().map(Gint::from),
        }
    };
}

/// INQUIRE LIST OF AVAILABLE WORKSTATION TYPES: three names, and a null pointer for windows.
#[unsafe(no_mangle)]
extern "C" fn ginqavailwstypes(types: Address<Gstrlist>) -> Gint {
    const F: Function = Function::InquireListOfAvailableWorkstationTypes;
    inquire(F, |gks| {
        gks_instance::check_state(gks, F)?;
        let names = [c"MI".as_ptr(), c"MO".as_ptr(), c"WISS".as_ptr(), std::ptr::null()];
        let strings = allocated(&names);
        types.set(Gstrlist { number: if strings.is_null() { 0 } else { integer(names.len()) }, strings });
        Ok(())
    })
}

/// INQUIRE NORMALIZATION TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn ginqntran(number: Gint, transformation: Address<Gwstran>) -> Gint {
    inquire(Function::InquireNormalizationTransformation, |gks| {
        let found = gks.inquire_normalization_transformation(number)?;
        transformation.set(Gwstran { w: found.window.into(), v: found.viewport.into() });
        Ok(())
    })
}

/// INQUIRE WORKSTATION CONNECTION AND TYPE. The two strings belong to the program.
#[unsafe(no_mangle)]
extern "C" fn ginqwsconntype(ws_id: Gint, result: Address<Gwsct>) -> Gint {
    inquire(Function::InquireWorkstationConnectionAndType, |gks| {
        let (connection, kind) = gks.inquire_workstation_connection_and_type(ws_id)?;
        result.set(Gwsct { conn: allocated_text(connection), kind: allocated_text(kind_name(kind)) });
        Ok(())
    })
}

/// INQUIRE WORKSTATION STATE.
#[unsafe(no_mangle)]
extern "C" fn ginqwsst(ws_id: Gint, state: Address<Gint>) -> Gint {
    inquire(Function::InquireWorkstationState, |gks| {
        state.set(gks.inquire_workstation_state(ws_id)?.into());
        Ok(())
    })
}

/// INQUIRE WORKSTATION DEFERRAL AND UPDATE STATES.
#[unsafe(no_mangle)]
extern "C" fn ginqwsdeferupdatest(ws_id: Gint, states: Address<Gwsdus>) -> Gint {
    inquire(Function::InquireWorkstationDeferralAndUpdateStates, |gks| {
        let found = gks.inquire_workstation_deferral_and_update_states(ws_id)?;
        states.set(Gwsdus {
            defmode: found.deferral as Gint,
            dspsurf: (!found.empty).into(),
            irgmode: found.regeneration as Gint,
            nframe: found.new_frame_necessary.into(),
        });
        Ok(())
    })
}

/// INQUIRE WORKSTATION TRANSFORMATION.
#[unsafe(no_mangle)]
extern "C" fn ginqwstran(ws_id: Gint, result: Address<Gwsti>) -> Gint {
    inquire(Function::InquireWorkstationTransformation, |gks| {
        let state = gks.inquire_workstation_transformation(ws_id)?;
        let pair = |t: WorkstationTransformation| Gwstran { w: t.window.into(), v: t.viewport.into() };
        result.set(Gwsti {
            wstus: state.pending.into(),
            request: pair(state.requested),
            current: pair(state.current),
        });
        Ok(())
    })
}

/// INQUIRE TEXT EXTENT.
#[unsafe(no_mangle)]
extern "C" fn ginqtextextent(
    ws_id: Gint,
    position: Gpoint,
    text: Address<Gchar>,
    extent: Address<Gextent>,
) -> Gint {
    inquire(Function::InquireTextExtent, |gks| {
        let room = gks.inquire_text_extent(ws_id, position, &text.text())?;
        let [ll, lr, ur, ul] = room.corners.map(Gpoint::from);
        extent.set(Gextent { concat: room.concatenation.into(), ll, lr, ul, ur });
        Ok(())
    })
}

/// INQUIRE PIXEL ARRAY DIMENSIONS.
#[unsafe(no_mangle)]
extern "C" fn ginqpixelarraydim(ws_id: Gint, rect: Address<Grect>, size: Address<Gipoint>) -> Gint {
    const F: Function = Function::InquirePixelArrayDimensions;
    inquire(F, |gks| {
        let Grect { ll, ur } = rect.get(F)?;
        let (columns, rows) = gks.inquire_pixel_array_dimensions(ws_id, ll, ur)?;
        size.set(Gipoint { x: integer(columns), y: integer(rows) });
        Ok(())
    })
}

/// INQUIRE PIXEL ARRAY. The array belongs to the program.
#[unsafe(no_mangle)]
extern "C" fn ginqpixelarray(
    ws_id: Gint,
    point: Address<Gpoint>,
    size: Address<Gipoint>,
    result: Address<Gpxarray>,
) -> Gint {
    const F: Function = Function::InquirePixelArray;
    inquire(F, |gks| {
        let size = size.get(F)?;
        let [columns, rows] = [size.x, size.y].map(|n| usize::try_from(n).unwrap_or(0));
        let pixels = gks.inquire_pixel_array(ws_id, point.get(F)?, columns, rows)?;
        result.set(Gpxarray { covalid: (!pixels.invalid).into(), array: allocated(&pixels.indices) });
        Ok(())
    })
}

/// INQUIRE PIXEL.
#[unsafe(no_mangle)]
extern "C" fn ginqpixel(ws_id: Gint, point: Address<Gpoint>, colour: Address<Gint>) -> Gint {
    const F: Function = Function::InquirePixel;
    inquire(F, |gks| {
        colour.set(gks.inquire_pixel(ws_id, point.get(F)?)?);
        Ok(())
    })
}
