//! What programs of NCAR Graphics expect.

use crate::answer::{answer, element};
use crate::argument::{Character, Integer, Real};
use crate::call::{call_instance, check_state};
use crate::data_record::LINE;
use crate::unbuilt::refusal;
use gks::{Function, Gks};
use gks_geometry::{Map, Ndc, Point, Wc};
use gks_instance::{Dialect, from_latin1};
use gks_pipeline::look::InteriorStyle;

/// The workstation type of a metafile.
const METAFILE: i32 = 1;

/// The ESCAPE that gives the name of the next metafile.
const METAFILE_NAME: i32 = -1391;

/// The ESCAPE that saves and restores attributes.
const ATTRIBUTES: i32 = -1388;

/// The interior style in which the utilities fill the outlines of characters.
const SOLID_TEXT: i32 = 4;

fn is_active() -> bool {
    gks_instance::with(|instance| instance.dialect == Dialect::Ncar)
}

/// The interior style that a program means by a number: characters are filled as everything else is.
pub(crate) fn interior_style(number: i32) -> i32 {
    if number == SOLID_TEXT && is_active() { InteriorStyle::Solid as i32 } else { number }
}

/// ESCAPE with one of the identifiers of NCAR Graphics, a record and its length; nothing happens for another
/// identifier. Whether it was one.
///
/// All but the name of a metafile are without effect. Output records are left alone, since programs pass
/// constants for their lengths, but for that of saved attributes, which is read back: it is blank.
pub(crate) fn escape(identifier: i32, idr: (Character, usize), mlodr: Integer, odr: Character) -> bool {
    const F: Function = Function::Escape;
    if !(matches!(identifier, -1402..=-1386 | -1532..=-1510) && is_active()) {
        return false;
    }
    call_instance(F, |instance| {
        check_state(&instance.gks, F)?;
        if identifier == METAFILE_NAME {
            let name = from_latin1(idr.0.slice(0, idr.1)).trim().to_owned();
            instance.metafile_name = Some(name).filter(|name| !name.is_empty());
        }
        if identifier == ATTRIBUTES {
            odr.fill(mlodr.count() * LINE, b' ');
        }
        Ok(())
    });
    true
}

/// OPEN WORKSTATION, where a metafile takes the name that ESCAPE gave it.
pub(crate) fn open_workstation(
    instance: &mut gks_instance::Instance,
    wkid: i32,
    conid: i32,
    wtype: i32,
) -> gks::Result<()> {
    let name = instance.metafile_name.take_if(|_| wtype == METAFILE);
    instance.gks.open_workstation(wkid, &name.unwrap_or_else(|| conid.to_string()), wtype)
}

/// GQSGUS: INQUIRE SET OF SEGMENT NAMES IN USE. No segments are built yet; the utilities of NCAR Graphics ask
/// all the same, and want to hear that no name is in use.
#[unsafe(no_mangle)]
extern "C" fn gqsgus_(n: Integer, errind: Integer, ol: Integer, sgna: Integer) {
    const F: Function = Function::InquireSetOfSegmentNamesInUse;
    if is_active() {
        answer(F, errind, (ol, sgna), |_| Ok(element([0; 0], n)));
    } else {
        ol.set(0);
        sgna.set(0);
        errind.set(refusal(F));
    }
}

/// GZW2NX: abscissae from world coordinates to NDC by the current normalization transformation.
#[unsafe(no_mangle)]
extern "C" fn gzw2nx_(n: Integer, p: Real, q: Real) {
    let map = gks_instance::with(|instance| current_map(&instance.gks));
    convert(n, p, q, |x| map.point(Point::new(x, 0.0)).x());
}

/// GZW2NY: ordinates from world coordinates to NDC by the current normalization transformation.
#[unsafe(no_mangle)]
extern "C" fn gzw2ny_(n: Integer, p: Real, q: Real) {
    let map = gks_instance::with(|instance| current_map(&instance.gks));
    convert(n, p, q, |y| map.point(Point::new(0.0, y)).y());
}

/// The map of the current normalization transformation; while GKS is closed, that of transformation 0.
fn current_map(gks: &Gks) -> Map<Wc, Ndc> {
    let number = gks.inquire_current_normalization_transformation_number();
    let current = number.and_then(|number| gks.inquire_normalization_transformation(number));
    current.map_or(Map::IDENTITY, |current| Map::window_to_viewport(&current.window, &current.viewport))
}

/// Converts the elements of an array, which the result may replace.
fn convert(n: Integer, p: Real, q: Real, f: impl Fn(f64) -> f64) {
    let converted: Vec<f32> = p.slice(0, n.count()).iter().map(|&v| f(v.into()) as f32).collect();
    q.set_from(0, converted);
}
