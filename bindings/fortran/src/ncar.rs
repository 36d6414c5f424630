//! What programs of NCAR Graphics expect.

use crate::argument::{Character, Integer, Real};
use crate::call::{call_instance, check_state, subroutines};
use crate::data_record::LINE;
#[cfg(target_os = "linux")]
use crate::error_log::find;
use gks::{Function, Gks};
use gks_geometry::{Map, Ndc, Point, Wc};
use gks_instance::Dialect;

/// The ESCAPE that saves and restores attributes.
const ATTRIBUTES: i32 = -1388;

fn is_active() -> bool {
    gks_instance::with(|instance| instance.dialect == Dialect::Ncar)
}

/// ESCAPE with one of the identifiers of NCAR Graphics, a record and its length; nothing happens for another
/// identifier. Whether it was one.
///
/// Output records are left alone, since programs pass
/// constants for their lengths, but for that of saved attributes, which is read back: it is blank.
pub(crate) fn escape(identifier: i32, idr: (Character, usize), mlodr: Integer, odr: Character) -> bool {
    const F: Function = Function::Escape;
    if identifier >= 0 || !is_active() {
        return false;
    }
    let mut known = true;
    call_instance(F, |instance| {
        check_state(&instance.gks, F)?;
        known = instance.ncar_escape(identifier, idr.0.slice(0, idr.1));
        if identifier == ATTRIBUTES {
            odr.fill(mlodr.count() * LINE, b' ');
        }
        Ok(())
    });
    known
}

/// Has messages of the utilities go to the unit of the error file, as OPEN GKS of NCAR Graphics does: the unit is
/// the first number of their COMMON block SECOMI, which is in the process where they are.
#[cfg(target_os = "linux")]
pub(crate) fn share_error_unit(dialect: Dialect, unit: i32) {
    if dialect != Dialect::Ncar || unit == 0 {
        return;
    }
    let secomi = find(c"secomi_").cast::<i32>();
    if !secomi.is_null() {
        // SAFETY: the COMMON block begins with an INTEGER.
        unsafe { secomi.write(unit) }
    }
}

#[cfg(not(target_os = "linux"))]
pub(crate) fn share_error_unit(_dialect: Dialect, _unit: i32) {}

/// GZOPWK: OPEN WORKSTATION for the library HLU, which has a GOPWK of its own.
#[unsafe(no_mangle)]
extern "C" fn gzopwk_(wkid: Integer, conid: Integer, wtype: Integer) {
    call_instance(Function::OpenWorkstation, |instance| {
        instance.open_workstation(wkid.get(), &conid.get().to_string(), wtype.get())
    });
}

// The same for the other functions that HLU has itself.
subroutines! {
    gzclwk_(wkid: Integer) CloseWorkstation => |gks| gks.close_workstation(wkid.get());
    gzacwk_(wkid: Integer) ActivateWorkstation => |gks| gks.activate_workstation(wkid.get());
    gzdawk_(wkid: Integer) DeactivateWorkstation => |gks| gks.deactivate_workstation(wkid.get());
    gzclrwk_(wkid: Integer, cofl: Integer) ClearWorkstation
        => |gks| gks.clear_workstation(wkid.get(), cofl.choice(F)?);
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
