//! AWAIT EVENT, FLUSH DEVICE EVENTS, GET, pick identifiers, and what is inquired of the queue.

use super::super::argument::{Address, call, choice, inquire};
use super::super::types::{Gchar, Gchoice, Gevent, Gfloat, Gint, Gloc, Gpick, Gqueue, Gstroke, Promoted};
use super::{allocated_stroke, real, set_string, string_room};
use gks::{Function, InputClass};

/// The number for no input class.
const NO_CLASS: Gint = 0;

/// AWAIT EVENT. A timeout without an event gives no input class.
#[unsafe(no_mangle)]
extern "C" fn gawaitevent(timeout: Promoted, event: Address<Gevent>) -> Gint {
    event.set(Gevent { ws: 0, dev: 0, class: NO_CLASS });
    call(Function::AwaitEvent, |gks| {
        if let Some((ws, class, dev)) = gks.await_event(timeout)? {
            event.set(Gevent { ws, dev, class: class as Gint });
        }
        Ok(())
    })
}

/// FLUSH DEVICE EVENTS.
#[unsafe(no_mangle)]
extern "C" fn gflushevents(ws_id: Gint, class: Gint, dev: Gint) -> Gint {
    const F: Function = Function::FlushDeviceEvents;
    call(F, |gks| gks.flush_device_events(ws_id, choice(InputClass::from_number(class), F)?, dev))
}

/// The functions GET whose value is set as it is.
macro_rules! get {
    ($($name:ident($type:ty) $function:ident => |$value:ident = $method:ident| $set:expr;)+) => { $(
        #[doc = concat!("Calls `", stringify!($method), "`.")]
        #[unsafe(no_mangle)]
        extern "C" fn $name(response: Address<$type>) -> Gint {
            call(Function::$function, |gks| {
                let $value = gks.$method()?;
                response.set($set);
                Ok(())
            })
        }
    )+ };
}

get! {
    ggetloc(Gloc) GetLocator => |value = get_locator| value.into();
    // XGKS allocates the points here, and nowhere else. They belong to the program.
    ggetstroke(Gstroke) GetStroke => |value = get_stroke| allocated_stroke(&value);
    ggetval(Gfloat) GetValuator => |value = get_valuator| real(value);
    ggetchoice(Gchoice) GetChoice => |value = get_choice| value.into();
    ggetpick(Gpick) GetPick => |value = get_pick| value.into();
}

/// GET STRING.
#[unsafe(no_mangle)]
extern "C" fn ggetstring(response: Address<Gchar>) -> Gint {
    call(Function::GetString, |gks| {
        let value = gks.get_string()?;
        let (ws_id, _, dev) = gks.current_event().unwrap_or((0, InputClass::String, 0));
        set_string(&value, string_room(gks, ws_id, dev), response);
        Ok(())
    })
}

/// SET PICK IDENTIFIER.
#[unsafe(no_mangle)]
extern "C" fn gsetpickid(pick_id: Gint) -> Gint {
    call(Function::SetPickIdentifier, |gks| gks.set_pick_identifier(pick_id))
}

/// INQUIRE CURRENT PICK IDENTIFIER VALUE.
#[unsafe(no_mangle)]
extern "C" fn ginqcurpickid(pick_id: Address<Gint>) -> Gint {
    inquire(Function::InquireCurrentPickIdentifierValue, |gks| {
        pick_id.set(gks.inquire_current_pick_identifier_value()?);
        Ok(())
    })
}

/// INQUIRE MORE SIMULTANEOUS EVENTS.
#[unsafe(no_mangle)]
extern "C" fn ginqmoreevents(more: Address<Gint>) -> Gint {
    inquire(Function::InquireMoreSimultaneousEvents, |gks| {
        more.set(gks.inquire_more_simultaneous_events()?.into());
        Ok(())
    })
}

/// INQUIRE INPUT QUEUE OVERFLOW. The structure has no place for the workstation.
#[unsafe(no_mangle)]
extern "C" fn ginqinputoverflow(overflow: Address<Gqueue>) -> Gint {
    overflow.set(Gqueue { class: NO_CLASS, devno: 0 });
    inquire(Function::InquireInputQueueOverflow, |gks| {
        let (_, class, devno) = gks.inquire_input_queue_overflow()?;
        overflow.set(Gqueue { class: class as Gint, devno });
        Ok(())
    })
}
